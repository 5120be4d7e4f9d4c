//! What a scene puts into flash: tables, whose bytes are those of their types,
//! and code, of which it is counted what there is.

use std::collections::BTreeMap;
use std::mem::size_of;

use microbrdf::Rgb;
use microbrdf::shade::{Checker, FloodLight, Plane, PointLight, Sphere};
use microbrdf::table::CosineCurve;
use microbrdf_scene::{
    AnyLight, AnySamples, HostArithmetic, Prepared, PreparedCoat, StoredNormals,
};

use super::{kind::kind, steps::several_kinds};

/// Bytes of a pointer on every board.
const POINTER: usize = 4;

/// Names of pieces of code, and how often a scene has them.
pub type Pieces = BTreeMap<String, f64>;

/// A scene's constants and code.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contents {
    /// Bytes of each material's tables: its models', gains, albedo.
    pub materials: Vec<usize>,
    /// Bytes of each light.
    pub lights: Vec<usize>,
    /// Bytes of spheres, planes and what is seen of meshes.
    pub shapes: usize,
    /// Its pieces of code.
    pub code: Pieces,
}

impl Contents {
    /// What is in a scene.
    pub fn of<A: HostArithmetic>(prepared: &Prepared<A>) -> Self {
        let checkered = |plane: &Checker<A>| plane.odd != plane.plane.material;
        let checkers = prepared.planes.iter().any(checkered);
        let plane = if checkers {
            size_of::<Checker<A>>()
        } else {
            size_of::<Plane<A>>()
        };
        let several = several_kinds(&prepared.lights);
        let view = prepared.view.as_ref().map_or(0, |view| view.bytes());
        Self {
            materials: prepared.coats.iter().map(material).collect(),
            lights: prepared
                .lights
                .iter()
                .map(|light| light_bytes(light, several))
                .collect(),
            shapes: prepared.spheres.len() * size_of::<Sphere<A>>()
                + prepared.planes.len() * plane
                + view,
            code: code(prepared, checkers, several),
        }
    }

    /// Bytes of all tables.
    #[must_use]
    pub fn tables(&self) -> usize {
        self.materials.iter().chain(&self.lights).sum::<usize>() + self.shapes
    }
}

fn material<A: HostArithmetic>(coat: &PreparedCoat<A>) -> usize {
    let gain = size_of::<Rgb<A::Gain>>();
    let parts: usize = coat
        .parts
        .iter()
        .map(|part| part.model.bytes() + part.gains.len() * gain)
        .sum();
    let sky = coat.daylight.map_or(0, |_| size_of::<CosineCurve>() + gain);
    parts + sky
}

fn light_bytes<A: HostArithmetic>(light: &AnyLight<A>, several: bool) -> usize {
    let entry = match light {
        AnyLight::Directional(_) => size_of::<microbrdf::geometry::Direction<A>>(),
        AnyLight::Point(_) => size_of::<PointLight<A>>(),
        AnyLight::Flood(_) => POINTER + size_of::<FloodLight<A>>(),
    };
    entry + if several { POINTER } else { 0 }
}

fn code<A: HostArithmetic>(prepared: &Prepared<A>, checkers: bool, several: bool) -> Pieces {
    let mut code = Pieces::new();
    let mut add = |name: &str, times: usize| {
        if times > 0 {
            *code.entry(name.to_owned()).or_default() += times as f64;
        }
    };
    add("application", 1);
    let has = |is: bool| usize::from(is);
    add("spheres", has(!prepared.spheres.is_empty()));
    add("planes", has(!prepared.planes.is_empty()));
    add("checkers", has(checkers));
    add("several spheres", has(prepared.spheres.len() > 1));
    add("several planes", has(prepared.planes.len() > 1));
    add("several materials", has(prepared.coats.len() > 1));
    add("several lights", has(prepared.lights.len() > 1));
    add("lights of several kinds", has(several));
    add("shadows", has(prepared.shadows.0));
    add("four samples", has(prepared.samples == AnySamples::Four));
    let lights = &prepared.lights;
    add(
        "lamps",
        has(lights
            .iter()
            .any(|light| !matches!(light, AnyLight::Directional(_)))),
    );
    add(
        "floods",
        has(lights
            .iter()
            .any(|light| matches!(light, AnyLight::Flood(_)))),
    );
    if let Some(view) = &prepared.view {
        add("mesh", 1);
        add("depths of a mesh", has(view.depths.is_some()));
        add(
            "normals of 3 bytes",
            has(matches!(view.normals, StoredNormals::Three(_))),
        );
    }
    // Coats of one type share their code; what light reaches a coat makes no
    // other type of it, but a sky does.
    let mut types: Vec<Vec<&str>> = Vec::new();
    for coat in &prepared.coats {
        // Without a light no model is asked, and its code is left out.
        let lit = coat.parts.iter().filter(|_| !prepared.lights.is_empty());
        let mut parts: Vec<_> = lit.map(|part| kind(&part.material)).collect();
        if coat.daylight.is_some() {
            parts.push("daylight");
        }
        if !types.contains(&parts) {
            types.push(parts);
        }
    }
    add("materials", prepared.coats.len());
    for parts in &types {
        add("types of material", 1);
        for part in parts {
            add(&format!("use of {part}"), 1);
        }
        let several = parts.iter().filter(|part| **part != "daylight").count();
        add("sums of coats", several.saturating_sub(1));
    }
    let mut kinds: Vec<_> = types.concat();
    kinds.sort_unstable();
    kinds.dedup();
    for kind in kinds {
        add(kind, 1);
    }
    code
}
