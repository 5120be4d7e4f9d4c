//! Lights: of their own kind where all are of one, else of an enum of those
//! kinds that the scene has.

use microbrdf::shade::PointLight;

use super::{direction, line};
use crate::host::HostArithmetic;
use crate::lamp::AnyLight;

/// Name, type and pattern of each kind.
const KINDS: [(&str, &str); 3] = [
    ("Directional", "Direction<A>"),
    ("Point", "PointLight<A>"),
    ("Flood", "&'static FloodLight<A>"),
];

fn kind<A: HostArithmetic>(light: &AnyLight<A>) -> (&'static str, &'static str) {
    KINDS[match light {
        AnyLight::Directional(_) => 0,
        AnyLight::Point(_) => 1,
        AnyLight::Flood(_) => 2,
    }]
}

/// Writes the static `LIGHTS`; gives the type of its entries.
pub(super) fn bake<A: HostArithmetic>(code: &mut String, lights: &[AnyLight<A>]) -> &'static str {
    let used: Vec<_> = KINDS
        .into_iter()
        .filter(|known| lights.iter().any(|light| kind(light) == *known))
        .collect();
    for (index, light) in lights.iter().enumerate() {
        if let AnyLight::Flood(flood) = light {
            let new = format!(
                "FloodLight::<A>::new({}, {}, {})",
                point(&flood.lamp),
                direction(&flood.back),
                A::parameter_code(flood.exponent)
            );
            line(
                code,
                format!("static LIGHT_{index}: FloodLight<A> = microbrdf::constant!({new});"),
            );
        }
    }
    let value = |(index, light): (usize, &AnyLight<A>)| match light {
        AnyLight::Directional(to_light) => direction(to_light),
        AnyLight::Point(lamp) => point(lamp),
        AnyLight::Flood(_) => format!("&LIGHT_{index}"),
    };
    let values = lights.iter().enumerate().map(value);
    let (entry, values): (_, Vec<_>) = match used[..] {
        [] => (KINDS[0].1, Vec::new()),
        [(_, only)] => (only, values.collect()),
        _ => {
            mixture(code, &used);
            let named = |(light, value)| format!("Lamp::{}({value})", kind(light).0);
            ("Lamp", lights.iter().zip(values).map(named).collect())
        }
    };
    line(
        code,
        format!(
            "static LIGHTS: [{entry}; {}] = [{}];",
            values.len(),
            values.join(", ")
        ),
    );
    entry
}

/// The enum of the scene's kinds.
fn mixture(code: &mut String, used: &[(&str, &str)]) {
    let variants: Vec<_> = used
        .iter()
        .map(|(name, kind)| format!("    {name}({kind}),"))
        .collect();
    let arms: Vec<_> = used
        .iter()
        .map(|(name, _)| match *name {
            "Directional" => {
                "            Self::Directional(direction) => (*direction).into(),".into()
            }
            _ => format!("            Self::{name}(lamp) => lamp.beam(place),"),
        })
        .collect();
    let places: Vec<_> = used
        .iter()
        .map(|(name, _)| format!("            Self::{name}(light) => light.lamp(),"))
        .collect();
    line(
        code,
        format!(
            "enum Lamp {{\n{}\n}}\n\n\
             impl Light<A> for Lamp {{\n    type Beam = Dimmed<A>;\n\n    #[inline]\n    \
             fn beam(&self, place: impl Fn() -> <A as Placing>::Place) -> Dimmed<A> {{\n        \
             match self {{\n{}\n        }}\n    }}\n\n    #[inline]\n    \
             fn lamp(&self) -> Option<&[<A as Tracing>::Length; 3]> {{\n        \
             match self {{\n{}\n        }}\n    }}\n}}\n",
            variants.join("\n"),
            arms.join("\n"),
            places.join("\n")
        ),
    );
}

fn point<A: HostArithmetic>(lamp: &PointLight<A>) -> String {
    let position = lamp.position.map(A::length_code).join(", ");
    format!(
        "PointLight {{ position: [{position}], near: {} }}",
        A::length_code(lamp.near)
    )
}
