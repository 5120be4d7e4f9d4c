//! Materials and directions from arbitrary bytes, and what must hold for them.

use arbitrary::{Arbitrary as _, Unstructured};
use microbrdf::brdf::Brdf as _;
use microbrdf::geometry::{Geometry, ShadingFrame, World};
use microbrdf_scene::{AnyModel, Material};

use crate::arithmetic::{Tested, bits, rounded};
use crate::curves::CURVES;
use crate::error::Subject;

/// A whole number from the environment.
///
/// # Panics
/// Where it is something else.
#[must_use]
pub fn setting(name: &str, default: u64) -> u64 {
    match std::env::var(name) {
        Ok(text) => text
            .parse()
            .unwrap_or_else(|_| panic!("{name} = {text}: must be a whole number")),
        Err(_) => default,
    }
}

/// A material and places to evaluate it at.
#[derive(Clone, Debug)]
pub struct Case {
    /// The material's table.
    pub toml: String,
    /// Where: a table takes as long to build as many evaluations.
    pub places: Vec<Place>,
}

/// Directions and an exposure.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// N, L and V, not yet rounded: any finite numbers.
    pub vectors: [[f64; 3]; 3],
    /// K.
    pub exposure: f64,
}

/// Places of a case.
const PLACES: usize = 64;
/// Bytes that a case takes at most.
pub const BYTES: usize = 64 + 96 * PLACES;

impl Case {
    /// The case that some bytes stand for; beyond their end they are 0.
    ///
    /// # Panics
    /// Never: integers can be made of any bytes.
    pub fn new(bytes: &[u8]) -> Self {
        Self::read(&mut Unstructured::new(bytes)).expect("integers of any bytes")
    }

    fn read(source: &mut Unstructured<'_>) -> arbitrary::Result<Self> {
        Ok(Self {
            toml: material(source)?,
            places: (0..PLACES)
                .map(|_| Place::read(source))
                .collect::<Result<_, _>>()?,
        })
    }
}

impl Place {
    fn read(source: &mut Unstructured<'_>) -> arbitrary::Result<Self> {
        let about_mirror = bool::arbitrary(source)?;
        let mut vectors = [vector(source)?, vector(source)?, vector(source)?];
        if about_mirror {
            // V within a lobe of L: where most code runs.
            let distance = 10f64.powf(-9.0 * unit(source)?);
            let [_, l, v] = vectors;
            vectors[2] = [0, 1, 2].map(|i| {
                let mirrored = if i < 2 { -l[i] } else { l[i] };
                mirrored + distance * v[i]
            });
        }
        if u8::arbitrary(source)? % 4 > 0 {
            vectors = vectors.map(normalised);
        }
        Ok(Self {
            vectors,
            exposure: 1e-3 * 2e10f64.powf(unit(source)?),
        })
    }
}

/// In [0, 1].
fn unit(source: &mut Unstructured<'_>) -> arbitrary::Result<f64> {
    Ok(f64::from(u32::arbitrary(source)?) / f64::from(u32::MAX))
}

/// Between two numbers, evenly in the logarithm; the ends more often.
fn parameter(source: &mut Unstructured<'_>, low: f64, high: f64) -> arbitrary::Result<f64> {
    Ok(match u8::arbitrary(source)? % 8 {
        0 => low,
        1 => high,
        _ => (low * (high / low).powf(unit(source)?)).clamp(low, high),
    })
}

/// Any component: a special one, a share of one, or a tiny one.
fn component(source: &mut Unstructured<'_>) -> arbitrary::Result<f64> {
    let sign = if bool::arbitrary(source)? { -1.0 } else { 1.0 };
    let magnitude = match u8::arbitrary(source)? % 8 {
        0 => 0.0,
        1 => 1.0,
        2 => 2.0,
        3 | 4 => 10f64.powf(-10.0 * unit(source)?),
        _ => unit(source)?,
    };
    Ok(sign * magnitude)
}

fn vector(source: &mut Unstructured<'_>) -> arbitrary::Result<[f64; 3]> {
    Ok([component(source)?, component(source)?, component(source)?])
}

fn normalised(vector: [f64; 3]) -> [f64; 3] {
    let length = vector.iter().map(|c| c * c).sum::<f64>().sqrt();
    if length > 0.0 {
        vector.map(|c| c / length)
    } else {
        [0.0, 0.0, 1.0]
    }
}

/// A table of any model; exponents are those that every arithmetic takes.
fn material(source: &mut Unstructured<'_>) -> arbitrary::Result<String> {
    let exponent = |source: &mut Unstructured<'_>| {
        Ok(if u8::arbitrary(source)? % 16 == 0 {
            0.0
        } else {
            parameter(source, 1.0, 1e8)?
        })
    };
    Ok(match u8::arbitrary(source)? % 11 {
        0 => format!(
            "model = \"lambert\", albedo = [{}, {}, {}]",
            unit(source)?,
            unit(source)?,
            unit(source)?
        ),
        1 => format!(
            "model = \"phong\", exponent = {}, p = {}",
            exponent(source)?,
            unit(source)?
        ),
        2 => format!(
            "model = \"metallic-phong\", exponent = {}",
            exponent(source)?
        ),
        3 => format!(
            "model = \"retro-phong\", exponent = {}, p = {}",
            exponent(source)?,
            unit(source)?
        ),
        4 => format!(
            "model = \"patch\", radius = {}",
            parameter(source, 1e-4, 2.0)?
        ),
        5 => format!(
            "model = \"patch-exponential\", sharpness = {}",
            parameter(source, 1e-9, 4096.0)?
        ),
        6 => {
            let n = exponent(source)?;
            let chosen = usize::from(u8::arbitrary(source)?) % (2 * CURVES.len());
            match CURVES.get(chosen) {
                Some(curve) => format!("model = \"metal\", exponent = {n}, {}", curve.fields),
                None => {
                    let eta = parameter(source, 0.1, 20.0)?;
                    let k = parameter(source, 1e-3, 20.0)?;
                    format!(
                        "model = \"metal\", exponent = {n}, eta = [{eta}, 1.5, {eta}], \
                         k = [{k}, 0, 1]"
                    )
                }
            }
        }
        7 => {
            let curve = CURVES[usize::from(u8::arbitrary(source)?) % CURVES.len()];
            if bool::arbitrary(source)? {
                let radius = parameter(source, 1e-4, 2.0)?;
                format!(
                    "model = \"patch-metal\", {}, radius = {radius}",
                    curve.fields
                )
            } else {
                let sharpness = parameter(source, 1e-9, 4096.0)?;
                format!(
                    "model = \"patch-metal\", {}, sharpness = {sharpness}",
                    curve.fields
                )
            }
        }
        8 => format!(
            "model = \"metallic-paint\", {}, sharpness = {}",
            CURVES[usize::from(u8::arbitrary(source)?) % CURVES.len()].fields,
            parameter(source, 1e-9, 4096.0)?
        ),
        9 => format!(
            "model = \"generalised-lambert\", albedo = [{}, {}, {}], smoothness = {}, clip = {}",
            unit(source)?,
            unit(source)?,
            unit(source)?,
            unit(source)?,
            parameter(source, 1.0, 1.9)?
        ),
        _ => {
            let albedo = unit(source)?;
            let index = if bool::arbitrary(source)? {
                ", index = 1.5"
            } else {
                ""
            };
            format!(
                "model = \"plastic\", albedo = {albedo}, specular = {}, exponent = {}{index}",
                (1.0 - albedo) * unit(source)?,
                exponent(source)?
            )
        }
    })
}

/// What must hold in an arithmetic.
///
/// # Errors
/// What does not, and where.
pub fn check<A: Tested>(case: &Case) -> Result<(), String> {
    let material = Material::from_argument(&case.toml).map_err(|error| error.to_string())?;
    // An arithmetic may have no room for a p next to 0 or 1.
    if material.rounded::<A>().model::<A>().is_err() {
        return Ok(());
    }
    let subject = Subject::<A>::new(&material);
    for place in &case.places {
        holds(&case.toml, &subject, place).map_err(|fault| format!("{fault}, {place:?}"))?;
    }
    Ok(())
}

fn holds<A: Tested>(toml: &str, subject: &Subject<A>, place: &Place) -> Result<(), String> {
    let model = &subject.model;
    let [n, l, v] = place.vectors.map(rounded::<A>);
    let frames = [ShadingFrame::new(l, v), ShadingFrame::new(v, l)];
    let worlds = [World::new(n, l, v), World::new(n, v, l)];
    // A metal's curve can reach past 1 by its rounding.
    let most = if ["metal = ", "eta = "]
        .iter()
        .any(|field| toml.contains(field))
    {
        1.0 + 1.0 / 32768.0
    } else {
        1.0
    };
    in_range(model, &frames[0], most)?;
    in_range(model, &worlds[0], most)?;
    let reciprocal = bits(model.brdf(&frames[0]).to_array())
        == bits(model.brdf(&frames[1]).to_array())
        && bits(model.brdf(&worlds[0]).to_array()) == bits(model.brdf(&worlds[1]).to_array());
    if !reciprocal {
        return Err("the BRDF changes when L and V are swapped".to_owned());
    }
    let gain = microbrdf::Rgb::grey(A::gain(place.exposure));
    let linear = A::linear(model.shade(&gain, &worlds[0]));
    if linear.to_raw().iter().any(|light| *light > 1 << 24) {
        return Err(format!("linear light is {:?}", linear.to_raw()));
    }
    accuracy::<A>(toml, subject, place)
}

/// Finite, not negative, and bounded.
fn in_range<A: Tested>(
    model: &AnyModel<A>,
    geometry: &impl Geometry<A>,
    most: f64,
) -> Result<(), String> {
    let share = model.share(geometry).to_array().map(A::unit_value);
    let reflected = model.reflect(geometry).to_array();
    let f = model.brdf(geometry).to_array().map(A::value_value);
    let fine = |value: f64| value.is_finite() && value.is_sign_positive();
    let bounded = most > 1.0 || reflected.iter().all(|r| A::at_most(*r, model.peak()));
    if share.iter().all(|s| fine(*s) && *s <= most) && f.iter().all(|f| fine(*f)) && bounded {
        Ok(())
    } else {
        Err(format!(
            "share {share:?}, BRDF {f:?}, radiance {:?} of peak {:?}",
            reflected.map(A::radiance_value),
            A::scale_value(model.peak())
        ))
    }
}

/// Unit vectors: the code at K = 1 within 0.56 LSB, or with coarse lobes 1.
fn accuracy<A: Tested>(toml: &str, subject: &Subject<A>, place: &Place) -> Result<(), String> {
    let [_, l, v] = place.vectors;
    // A curve's bound is one for the metals that were measured.
    if toml.contains("\"metal\"") && !CURVES.iter().any(|curve| toml.ends_with(curve.fields)) {
        return Ok(());
    }
    let is_unit = |v: [f64; 3]| (v.iter().map(|c| c * c).sum::<f64>() - 1.0).abs() < 1e-9;
    if !(is_unit(l) && is_unit(v)) {
        return Ok(());
    }
    // The table of tolerances is for the parameters of the registry; what has
    // coarse lobes is held to one code between them.
    let most = if A::CODE_ERROR < 0.6 { 0.56 } else { 1.0 };
    let (shown, exact) = subject.codes([l, v], 1.0);
    for (shown, exact) in shown.into_iter().zip(exact) {
        let error = (f64::from(shown) - exact).abs();
        if error > most && !at_edge::<A>(toml, l, v) {
            return Err(format!("code {shown} for {exact}"));
        }
    }
    Ok(())
}

/// Whether a jump of the model is so near that either side will do: the edge
/// of a patch, or the end of a lobe of n = 0.
fn at_edge<A: Tested>(toml: &str, l: [f64; 3], v: [f64; 3]) -> bool {
    let near = 4.0 * A::COMPONENT_ERROR + 1e-7;
    let squares = |signs: [f64; 3]| -> f64 {
        (0..3)
            .map(|i| (l[i] + signs[i] * v[i]) * (l[i] + signs[i] * v[i]))
            .sum()
    };
    if let Some((_, radius)) = toml.split_once("radius = ") {
        let m = (l[0] + v[0]).hypot(l[1] + v[1]);
        return (m - radius.parse().unwrap_or(0.0)).abs() < near;
    }
    let flat = toml.ends_with("exponent = 0") || toml.contains("exponent = 0,");
    let versines = [squares([1.0, 1.0, -1.0]), squares([-1.0; 3])].map(|square| 0.5 * square);
    flat && versines.iter().any(|x| (x - 1.0).abs() < near)
}
