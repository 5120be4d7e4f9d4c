//! A scene as Rust source: constants in flash, and just the types it needs.

mod lamps;
mod view;

use std::fmt::Write as _;

use microbrdf::geometry::Direction;
use microbrdf::shade::{Checker, Tracing};
use microbrdf::table::CosineCurve;

use crate::description::Description;
use crate::host::HostArithmetic;
use crate::material::{Material, PatchShape};
use crate::model::generalised_profile;
use crate::prepare::{Prepared, PreparedCoat, PreparedPart};
use crate::quality::{AnySamples, AnyShadows};

/// Writes the module that firmware includes: the constants `NAME`,
/// `ARITHMETIC`, `WIDTH`, `HEIGHT`, `EXPOSURE` and `DITHER`, and the function
/// `shade_row`.
///
/// # Errors
/// A material that the arithmetic does not take.
pub fn bake<A: HostArithmetic>(description: &Description) -> Result<String, String> {
    let prepared = description.prepare::<A>()?;
    let mut out = String::new();
    let code = &mut out;
    head::<A>(code, description);
    let lamp = lamps::bake::<A>(code, &prepared.lights);
    for (index, ((name, _), coat)) in description
        .materials
        .iter()
        .zip(&prepared.coats)
        .enumerate()
    {
        material::<A>(code, index, name, coat);
    }
    materials(code, prepared.coats.len());
    let view = view::bake(code, prepared.view.as_ref());
    scene::<A>(code, &prepared, lamp, view);
    Ok(out)
}

type Fine<A> = <A as Tracing>::Fine;

fn line(code: &mut String, text: impl AsRef<str>) {
    code.push_str(text.as_ref());
    code.push('\n');
}

fn head<A: HostArithmetic>(code: &mut String, description: &Description) {
    let camera = &description.camera;
    let _ = write!(
        code,
        "// Made by `microbrdf bake`; changes are lost.\n\
         use microbrdf::Rgb;\n\
         #[allow(unused_imports)]\n\
         use microbrdf::arithmetic::{{Arithmetic, Gain15, Gain31}};\n\
         #[allow(unused_imports)]\n\
         use microbrdf::brdf::*;\n\
         #[allow(unused_imports)]\n\
         use microbrdf::fixed::types::*;\n\
         use microbrdf::geometry::Direction;\n\
         #[allow(unused_imports)]\n\
         use microbrdf::shade::*;\n\
         #[allow(unused_imports)]\n\
         use microbrdf::table::{{CosineCurve, ProfileCurve}};\n\n\
         type A = {};\n\n\
         /// The scene's name.\n\
         pub const NAME: &str = {:?};\n\
         /// What it is shaded in.\n\
         pub const ARITHMETIC: &str = {:?};\n\
         /// Columns.\n\
         pub const WIDTH: usize = {};\n\
         /// Rows.\n\
         pub const HEIGHT: usize = {};\n\
         /// What radiance is multiplied by.\n\
         pub const EXPOSURE: f64 = {:?};\n\
         /// Whether displays of few levels dither.\n\
         pub const DITHER: bool = {};\n\n",
        A::TYPE,
        description.name,
        A::NAME,
        camera.width,
        camera.height,
        description.exposure,
        description.dither,
    );
}

fn direction<A: HostArithmetic>(direction: &Direction<A>) -> String {
    let component = |component| A::component_code(component);
    format!(
        "Direction::new({}, {}, {})",
        component(direction.x),
        component(direction.y),
        component(direction.z)
    )
}

fn gain<A: HostArithmetic>(gain: &[f64; 3]) -> String {
    let [r, g, b] = gain.map(A::gain_code);
    format!("Rgb {{ r: {r}, g: {g}, b: {b} }}")
}

fn curve(curve: &CosineCurve) -> String {
    format!("CosineCurve::from_entries({:?})", curve.entries())
}

/// One static for a material: its coat, or a tuple of two.
fn material<A: HostArithmetic>(
    code: &mut String,
    index: usize,
    name: &str,
    coat: &PreparedCoat<A>,
) {
    let mut types = Vec::new();
    let mut values = Vec::new();
    for (number, part) in coat.parts.iter().enumerate() {
        let gains: Vec<_> = part.gains.iter().map(gain::<A>).collect();
        let (kind, model) = model::<A>(part);
        let (sky, daylight) = match (&coat.daylight, number) {
            (Some((albedo, radiance)), 0) => (
                "AlbedoDaylight<A>",
                format!(
                    "AlbedoDaylight {{ albedo: {}, gain: {} }}",
                    curve(albedo),
                    gain::<A>(radiance)
                ),
            ),
            _ => ("NoDaylight", "NoDaylight".to_owned()),
        };
        types.push(format!("Coat<'static, A, {kind}, {sky}>"));
        values.push(format!(
            "Coat {{\n    model: {model},\n    gains: &[{}],\n    daylight: {daylight},\n}}",
            gains.join(", ")
        ));
    }
    let tuple = |parts: &[String]| match parts {
        [only] => only.clone(),
        _ => format!("({})", parts.join(", ")),
    };
    let name: String = name.chars().filter(|c| !c.is_control()).collect();
    line(
        code,
        format!("\n// {name}\ntype Material{index} = {};", tuple(&types)),
    );
    line(
        code,
        format!(
            "static MATERIAL_{index}: Material{index} = {};",
            tuple(&values)
        ),
    );
}

/// Type and value of a part's model.
fn model<A: HostArithmetic>(part: &PreparedPart<A>) -> (String, String) {
    let checked =
        |kind: &str, arguments: String| format!("microbrdf::constant!({kind}::new({arguments}))");
    let parameter = |value: f64| A::parameter_code(value);
    match &part.material {
        Material::Lambert { .. } => (
            "Lambert<A>".into(),
            checked("Lambert::<A>", format!("Rgb::grey({})", A::one_code())),
        ),
        Material::Phong {
            exponent, p, retro, ..
        } => {
            let axis = if *retro { "Retro" } else { "Mirror" };
            let (kind, value) = if *p == 0.0 {
                ("Flat", "Flat".to_owned())
            } else if *p == 1.0 {
                ("Metallic", "Metallic".to_owned())
            } else {
                ("PowerModel<A>", checked("PowerModel::<A>", A::p_code(*p)))
            };
            let kind = format!("PhongLobe<A, {axis}, {kind}>");
            let value = format!(
                "microbrdf::constant!(<{kind}>::with_foreshortening({}, {value}))",
                parameter(*exponent)
            );
            (kind, value)
        }
        Material::Patch { radius } => (
            "Patch<A>".into(),
            checked("Patch::<A>", A::radius_code(*radius)),
        ),
        Material::PatchExponential { sharpness } => (
            "PatchExponential<A>".into(),
            checked("PatchExponential::<A>", parameter(*sharpness)),
        ),
        Material::PatchProfile { profile } => (
            "PatchProfile<A>".into(),
            format!(
                "PatchProfile::new({}, {})",
                checked("ProfileCurve", profile.code()),
                parameter(part.material.reference().peak())
            ),
        ),
        Material::Metal {
            exponent,
            reflectance,
        } => {
            let lobe = checked("MetallicPhong::<A>", parameter(*exponent));
            (
                "Metal<A>".into(),
                format!("Metal::new({lobe}, {})", curve(&reflectance.curve())),
            )
        }
        Material::PatchMetal { shape, reflectance } => {
            let (shape, value) = match *shape {
                PatchShape::Basic { radius } => {
                    ("Patch<A>", checked("Patch::<A>", A::radius_code(radius)))
                }
                PatchShape::Exponential { sharpness } => (
                    "PatchExponential<A>",
                    checked("PatchExponential::<A>", parameter(sharpness)),
                ),
            };
            (
                format!("PatchMetal<{shape}>"),
                format!("PatchMetal::new({value}, {})", curve(&reflectance.curve())),
            )
        }
        Material::MetallicPaint {
            sharpness,
            reflectance,
        } => (
            "MetallicPaint<A>".into(),
            format!(
                "MetallicPaint::new({}, {})",
                checked("PatchExponential::<A>", parameter(*sharpness)),
                curve(&reflectance.curve())
            ),
        ),
        Material::GeneralisedLambert {
            smoothness, clip, ..
        } => (
            "GeneralisedLambert<A>".into(),
            format!(
                "GeneralisedLambert::new({}, {}, {})",
                checked("Lambert::<A>", format!("Rgb::grey({})", A::one_code())),
                checked(
                    "microbrdf::table::SquareCurve",
                    generalised_profile(*smoothness, *clip).code()
                ),
                parameter(part.material.reference().peak())
            ),
        ),
        Material::Plastic { .. } => unreachable!("a plastic has two parts, neither a plastic"),
    }
}

/// The scene's own closed set of materials.
fn materials(code: &mut String, count: usize) {
    let each = |text: &dyn Fn(usize) -> String| (0..count).map(text).collect::<String>();
    let variants = each(&|i| format!("    Material{i}(&'static Material{i}),\n"));
    let arms = each(&|i| {
        format!("            Self::Material{i}(coat) => coat.light(n, v, lights, spot),\n")
    });
    let values = each(&|i| format!("Material::Material{i}(&MATERIAL_{i}), "));
    let body = if count == 0 {
        // No object: nothing asks for light.
        "let _ = (n, v, lights, spot);\n        match *self {}".to_owned()
    } else {
        format!("match self {{\n{arms}        }}")
    };
    let _ = write!(
        code,
        "\n#[derive(Clone, Copy)]\nenum Material {{\n{variants}}}\n\n\
         impl Surface<A> for Material {{\n    #[inline]\n    \
         fn light(&self, n: &Direction<A>, v: &Direction<A>, lights: &[impl Light<A>], spot: impl Spot<A>) -> \
         Rgb<<A as Arithmetic>::Light> {{\n        {body}\n    }}\n}}\n\n\
         static MATERIALS: [Material; {count}] = [{values}];\n\n"
    );
}

/// The planes' type, and their values: checkers only if one of them is.
fn planes<A: HostArithmetic>(prepared: &Prepared<A>) -> (&'static str, String) {
    let lengths = |values: &[Fine<A>]| {
        let values: Vec<_> = values.iter().map(|step| A::fine_code(*step)).collect();
        format!("[{}]", values.join(", "))
    };
    let checkered = |checker: &Checker<A>| checker.odd != checker.plane.material;
    let any = prepared.planes.iter().any(checkered);
    let value = |checker: &Checker<A>| {
        let plane = format!(
            "Plane {{ normal: {}, height: {}, material: {} }}",
            direction::<A>(&checker.plane.normal),
            A::length_code(checker.plane.height),
            checker.plane.material
        );
        if any {
            let [first, second] = &checker.across;
            format!(
                "        Checker {{ plane: {plane}, odd: {}, eye: {}, across: [{}, {}] }},\n",
                checker.odd,
                lengths(&checker.eye),
                lengths(first),
                lengths(second),
            )
        } else {
            format!("        {plane},\n")
        }
    };
    let kind = if any { "Checker<A>" } else { "Plane<A>" };
    (kind, prepared.planes.iter().map(value).collect())
}

fn scene<A: HostArithmetic>(
    code: &mut String,
    prepared: &Prepared<A>,
    lamp: &str,
    (seen, view): (String, String),
) {
    let lengths = |values: &[A::Length]| {
        let values: Vec<_> = values
            .iter()
            .map(|length| A::length_code(*length))
            .collect();
        format!("[{}]", values.join(", "))
    };
    let steps = |values: &[Fine<A>]| {
        let values: Vec<_> = values.iter().map(|step| A::fine_code(*step)).collect();
        format!("[{}]", values.join(", "))
    };
    let spheres: String = prepared
        .spheres
        .iter()
        .map(|sphere| {
            format!(
                "        Sphere {{ eye: {}, radius: {}, material: {}, extent: Extent {{ columns: {:?}, rows: {:?} }} }},\n",
                lengths(&sphere.eye),
                A::length_code(sphere.radius),
                sphere.material,
                sphere.extent.columns,
                sphere.extent.rows
            )
        })
        .collect();
    let (ground, planes) = planes(prepared);
    let shadows = match prepared.shadows {
        AnyShadows(true) => "Shadowed",
        AnyShadows(false) => "Unshadowed",
    };
    let samples = match prepared.samples {
        AnySamples::One => "OneSample",
        AnySamples::Four => "FourSamples",
    };
    let camera = &prepared.camera;
    let [r, g, b] = prepared.background.to_raw();
    let _ = write!(
        code,
        "static SCENE: Scene<'static, A, Material, {ground}, {lamp}, {seen}, {shadows}, {samples}> = Scene {{\n    camera: Camera {{\n        \
         width: {}, height: {},\n        forward: {},\n        right: {},\n        up: {},\n    \
         }},\n    view: {view},\n    spheres: &[\n{spheres}    ],\n    planes: &[\n{planes}    ],\n    \
         lights: &LIGHTS,\n    materials: &MATERIALS,\n    \
         background: Linear::from_raw({r}, {g}, {b}),\n    shadows: {shadows},\n    samples: {samples},\n}};\n\n\
         /// Shades row `y`, calling `sink` with each column and its light, left to right.\n\
         pub fn shade_row(y: usize, sink: impl FnMut(usize, Linear)) {{\n    \
         SCENE.shade_row(y, sink);\n}}\n",
        camera.width,
        camera.height,
        steps(&camera.forward),
        steps(&camera.right),
        steps(&camera.up),
    );
}
