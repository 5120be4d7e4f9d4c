//! `microbrdf albedo`.

use microbrdf_reference as reference;
use microbrdf_scene::{HostArithmetic, Material};

use super::Computed;
use crate::cli::Albedo;
use crate::energy;
use crate::exit::{Failure, Outcome};
use crate::with_arithmetic;

/// Prints directional albedos, and the mean if asked.
pub fn run(arguments: &Albedo) -> Outcome<()> {
    let computed = Computed::parse(&arguments.arithmetic)?;
    for angle in &arguments.angles {
        if !(0.0..=90.0).contains(angle) {
            return Err(Failure::Usage(format!(
                "--angles {angle}: must be numbers from 0 to 90, in degrees"
            )));
        }
    }
    let material = Material::from_argument(&arguments.material)?;
    match computed {
        Computed::Reference => {
            let model = material.reference();
            print(
                arguments,
                &material,
                |angle| reference::directional_albedo_rgb(&*model, cosine(angle)).map(|e| e.value),
                || reference::mean_albedo_rgb(&*model).map(|e| e.value),
            )
        }
        Computed::Core(name) => with_arithmetic!(name, A => core::<A>(arguments, &material)),
    }
}

fn core<A: HostArithmetic>(arguments: &Albedo, material: &Material) -> Outcome<()> {
    let shipped = energy::Shipped::<A>::new(material)
        .map_err(|error| Failure::Usage(format!("--material: {error} in {}", A::NAME)))?;
    print(
        arguments,
        material,
        |angle| shipped.albedo(cosine(angle)),
        || shipped.mean_albedo(),
    )
}

fn cosine(degrees: f64) -> f64 {
    // cos 90° is 6e-17 in double precision.
    if degrees == 90.0 {
        0.0
    } else {
        degrees.to_radians().cos()
    }
}

fn print(
    arguments: &Albedo,
    material: &Material,
    albedo: impl Fn(f64) -> [f64; 3],
    mean: impl Fn() -> [f64; 3],
) -> Outcome<()> {
    let channels = if material.is_coloured() { 3 } else { 1 };
    let line = |name: &str, values: [f64; 3]| {
        let values: Vec<_> = values[..channels].iter().map(f64::to_string).collect();
        super::print(&format!("{name},{}\n", values.join(",")))
    };
    for &angle in &arguments.angles {
        line(&angle.to_string(), albedo(angle))?;
    }
    if arguments.mean {
        line("mean", mean())?;
    }
    Ok(())
}
