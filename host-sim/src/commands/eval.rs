//! `microbrdf eval`.

use std::io::{self, BufWriter, Write};

use microbrdf::Rgb;
use microbrdf::brdf::Brdf;
use microbrdf::geometry::{Direction, ShadingFrame};
use microbrdf_reference as reference;
use microbrdf_scene::{AnyModel, HostArithmetic, Material};

use super::Computed;
use crate::cli::{Encoding, Eval, Quantity};
use crate::directions::{self, Pair};
use crate::exit::{Failure, Outcome};
use crate::with_arithmetic;

/// Evaluates a material for each pair of directions on standard input.
pub fn run(arguments: &Eval) -> Outcome<()> {
    let computed = Computed::parse(&arguments.arithmetic)?;
    if !(1e-3..=2e7).contains(&arguments.exposure) {
        return Err(Failure::Usage(format!(
            "--exposure {}: must be a number from 1e-3 to 2e7",
            arguments.exposure
        )));
    }
    let material = Material::from_argument(&arguments.material)?;
    match computed {
        Computed::Reference => {
            let model = material.reference();
            each_line(arguments, &material, |pair| exact(arguments, &*model, pair))
        }
        Computed::Core(name) => with_arithmetic!(name, A => {
            let model = material
                .model::<A>()
                .map_err(|error| Failure::Usage(format!("--material: {error} in {}", name.name())))?;
            each_line(arguments, &material, |pair| core::<A>(arguments, &model, pair))
        }),
    }
}

/// The directions as rounded, then the three channels.
type Line = ([String; 6], [String; 3]);

fn each_line(
    arguments: &Eval,
    material: &Material,
    mut evaluate: impl FnMut(Pair) -> Line,
) -> Outcome<()> {
    let channels = if material.is_coloured() { 3 } else { 1 };
    let mut output = BufWriter::new(io::stdout().lock());
    let outcome = directions::read(io::stdin().lock(), |pair| {
        let (rounded, values) = evaluate(pair);
        let shown = if arguments.print_directions {
            &rounded[..]
        } else {
            &[]
        };
        let fields: Vec<_> = shown
            .iter()
            .chain(&values[..channels])
            .map(String::as_str)
            .collect();
        writeln!(output, "{}", fields.join(",")).map_err(output_failed)
    });
    output.flush().map_err(output_failed)?;
    outcome
}

/// Nobody reads on: not a mistake, but the result is incomplete.
fn output_failed(error: io::Error) -> Failure {
    Failure::Incomplete(format!("standard output: {error}"))
}

fn core<A: HostArithmetic>(arguments: &Eval, model: &AnyModel<A>, pair: Pair) -> Line {
    let [l, v] = pair.map(|vector| vector.map(A::component));
    let direction = |[x, y, z]: [A::Component; 3]| Direction::new(x, y, z);
    let geometry = ShadingFrame::new(direction(l), direction(v));
    let values = match arguments.quantity {
        Quantity::Brdf => model.brdf(&geometry).to_array().map(A::value_text),
        Quantity::Reflect => model.reflect(&geometry).to_array().map(A::radiance_text),
        Quantity::Code => {
            let gain = Rgb::grey(A::gain(arguments.exposure));
            let pixel = A::linear(model.shade(&gain, &geometry));
            match arguments.encoding {
                Encoding::Srgb => pixel.srgb8().map(|code| code.to_string()),
                // 24 fraction bits to 255 codes, rounded.
                Encoding::Linear => pixel
                    .to_raw()
                    .map(|light| ((u64::from(light) * 255 + (1 << 23)) >> 24).to_string()),
            }
        }
    };
    let [lx, ly, lz] = l.map(A::component_text);
    let [vx, vy, vz] = v.map(A::component_text);
    ([lx, ly, lz, vx, vy, vz], values)
}

fn exact(arguments: &Eval, model: &dyn reference::Brdf, pair: Pair) -> Line {
    let [l, v] = pair.map(|[x, y, z]| reference::Direction::new(x, y, z));
    let values = match arguments.quantity {
        Quantity::Brdf => model.eval_rgb(&l, &v).map(|f| f.to_string()),
        Quantity::Reflect => model.reflect(&l, &v).map(|f| f.to_string()),
        Quantity::Code => model.rho(&l, &v).map(|rho| {
            let linear = (arguments.exposure * rho).clamp(0.0, 1.0);
            let encoded = match arguments.encoding {
                Encoding::Srgb => reference::encode_srgb(linear),
                Encoding::Linear => linear,
            };
            (255.0 * encoded).round().to_string()
        }),
    };
    let text = pair.map(|vector| vector.map(|c| c.to_string()));
    let [[lx, ly, lz], [vx, vy, vz]] = text;
    ([lx, ly, lz, vx, vy, vz], values)
}
