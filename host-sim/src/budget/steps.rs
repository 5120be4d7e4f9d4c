//! What is done for each row of a scene, counted while the core's own row
//! function runs.

use microbrdf::Rgb;
use microbrdf::brdf::Brdf;
use microbrdf::geometry::{Direction, Geometry};
use microbrdf::shade::{
    AlbedoDaylight, Checker, Coat, Daylight, Dimmed, Ground, Light, Samples as _, Scene, Shadows,
    Sphere, Spot, Surface, View,
};
use microbrdf_scene::{
    AnyLight, AnyModel, AnySamples, AnyView, HostArithmetic, Material, Prepared, PreparedCoat,
    PreparedView, StoredNormals,
};

pub use super::tally::{Step, Steps};
use super::{kind::kind, tally::Tally};

/// The steps of each row that `rows` names.
pub fn of_rows<A: HostArithmetic>(
    prepared: &Prepared<A>,
    rows: impl IntoIterator<Item = usize>,
) -> Vec<Steps> {
    let tally = Tally::default();
    let gains = gains(prepared);
    let surfaces: Vec<_> = prepared
        .coats
        .iter()
        .zip(&gains)
        .enumerate()
        .map(|(index, (coat, gains))| Counted {
            tally: &tally,
            index,
            of_several: prepared.coats.len() > 1,
            coats: coats(&tally, coat, gains),
        })
        .collect();
    let several = several_kinds(&prepared.lights);
    let lights: Vec<_> = prepared
        .lights
        .iter()
        .enumerate()
        .map(|(index, light)| CountedLight {
            tally: &tally,
            index,
            light,
            several,
        })
        .collect();
    let planes: Vec<_> = prepared
        .planes
        .iter()
        .map(|plane| CountedPlane {
            tally: &tally,
            plane,
        })
        .collect();
    let scene = Scene {
        camera: prepared.camera,
        view: CountedView {
            tally: &tally,
            prepared,
        },
        spheres: &prepared.spheres,
        planes: &planes,
        lights: &lights,
        materials: &surfaces,
        background: prepared.background,
        shadows: CountedShadows {
            tally: &tally,
            on: prepared.shadows.0,
        },
        samples: prepared.samples,
    };
    let side = prepared.samples.side();
    rows.into_iter()
        .map(|y| {
            scene.shade_row(y, |_, _| ());
            tally.add("pixel", "", u64::from(prepared.camera.width / side));
            tally.take()
        })
        .collect()
}

fn gains<A: HostArithmetic>(prepared: &Prepared<A>) -> Vec<Vec<Vec<Rgb<A::Gain>>>> {
    let rgb = |gain: &[f64; 3]| Rgb::from_array(gain.map(A::gain));
    let of_coat = |coat: &PreparedCoat<A>| {
        let parts = coat.parts.iter();
        parts
            .map(|part| part.gains.iter().map(rgb).collect())
            .collect()
    };
    prepared.coats.iter().map(of_coat).collect()
}

type CountedCoat<'a, A> = Coat<'a, A, CountedModel<'a, A>, CountedSky<'a, A>>;

fn coats<'a, A: HostArithmetic>(
    tally: &'a Tally,
    coat: &'a PreparedCoat<A>,
    gains: &'a [Vec<Rgb<A::Gain>>],
) -> Vec<CountedCoat<'a, A>> {
    coat.parts
        .iter()
        .zip(gains)
        .enumerate()
        .map(|(index, (part, gains))| Coat {
            model: CountedModel {
                tally,
                kind: kind(&part.material),
                lobe: !matches!(
                    part.material,
                    Material::Lambert { .. } | Material::GeneralisedLambert { .. }
                ),
                model: &part.model,
            },
            gains,
            daylight: CountedSky {
                tally,
                // The sky answers to the whole: it is added once.
                sky: coat
                    .daylight
                    .filter(|_| index == 0)
                    .map(|(albedo, gain)| AlbedoDaylight {
                        albedo,
                        gain: Rgb::from_array(gain.map(A::gain)),
                    }),
            },
        })
        .collect()
}

/// What a light is called where it is counted.
pub(super) fn light_kind<A: HostArithmetic>(light: &AnyLight<A>) -> &'static str {
    match light {
        AnyLight::Directional(_) => "directional",
        AnyLight::Point(_) => "point",
        AnyLight::Flood(_) => "flood",
    }
}

/// Whether firmware needs an enum for these lights.
pub(super) fn several_kinds<A: HostArithmetic>(lights: &[AnyLight<A>]) -> bool {
    lights
        .windows(2)
        .any(|pair| std::mem::discriminant(&pair[0]) != std::mem::discriminant(&pair[1]))
}

struct Counted<'a, A: HostArithmetic> {
    tally: &'a Tally,
    index: usize,
    of_several: bool,
    coats: Vec<CountedCoat<'a, A>>,
}

impl<A: HostArithmetic> Surface<A> for Counted<'_, A> {
    fn light(
        &self,
        n: &Direction<A>,
        v: &Direction<A>,
        lights: &[impl Light<A>],
        spot: impl Spot<A>,
    ) -> Rgb<A::Light> {
        self.tally.material.set(Some(self.index));
        if self.of_several {
            self.tally.add("material", "of several", 1);
        }
        let mut sum = Rgb::default();
        for coat in &self.coats {
            self.tally.add("coat", "", 1);
            sum = sum.zip(coat.light(n, v, lights, spot), A::add_light);
            self.tally.light.set(None);
        }
        self.tally.material.set(None);
        sum
    }
}

struct CountedModel<'a, A: HostArithmetic> {
    tally: &'a Tally,
    kind: &'static str,
    /// Whether there is an outside where nothing is reflected.
    lobe: bool,
    model: &'a AnyModel<A>,
}

impl<A: HostArithmetic> Brdf<A> for CountedModel<'_, A> {
    fn peak(&self) -> A::Scale {
        Brdf::<A>::peak(self.model)
    }

    fn share(&self, geometry: &impl Geometry<A>) -> Rgb<A::Unit> {
        let (n_dot_l, n_dot_v) = geometry.cosines();
        let share = self.model.share(geometry);
        let way = if !A::lit(n_dot_l, n_dot_v) {
            "unlit"
        } else if self.lobe && share.to_array() == [A::ZERO; 3] {
            "outside"
        } else {
            "inside"
        };
        self.tally.add(self.kind, way, 1);
        share
    }

    fn brdf(&self, geometry: &impl Geometry<A>) -> Rgb<A::Value> {
        self.model.brdf(geometry)
    }
}

struct CountedSky<'a, A: HostArithmetic> {
    tally: &'a Tally,
    sky: Option<AlbedoDaylight<A>>,
}

impl<A: HostArithmetic> Daylight<A> for CountedSky<'_, A> {
    fn light(&self, n_dot_v: A::Cosine) -> Rgb<A::Light> {
        let Some(sky) = &self.sky else {
            return Rgb::default();
        };
        self.tally.add("daylight", "", 1);
        sky.light(n_dot_v)
    }
}

struct CountedLight<'a, A: HostArithmetic> {
    tally: &'a Tally,
    index: usize,
    light: &'a AnyLight<A>,
    several: bool,
}

impl<A: HostArithmetic> Light<A> for CountedLight<'_, A> {
    type Beam = Dimmed<A>;

    fn beam(&self, place: impl Fn() -> A::Place) -> Dimmed<A> {
        self.tally.light.set(Some(self.index));
        self.tally.add("light", light_kind(self.light), 1);
        if self.several {
            self.tally.add("light", "of several kinds", 1);
        }
        let beam = self.light.beam(place);
        if beam.dimming.is_some() {
            self.tally.add("light", "dimmed", 1);
        }
        beam
    }

    fn lamp(&self) -> Option<&[A::Length; 3]> {
        self.light.lamp()
    }
}

struct CountedPlane<'a, A: HostArithmetic> {
    tally: &'a Tally,
    plane: &'a Checker<A>,
}

impl<A: HostArithmetic> Ground<A> for CountedPlane<'_, A> {
    fn hit(&self, d: &A::Ray) -> Option<(A::Depth, Direction<A>, u8)> {
        let hit = self.plane.hit(d);
        self.tally
            .add("plane", if hit.is_some() { "hit" } else { "missed" }, 1);
        if hit.is_some() && self.plane.odd != self.plane.plane.material {
            self.tally.add("checker", "", 1);
        }
        hit
    }
}

#[derive(Clone, Copy)]
struct CountedShadows<'a> {
    tally: &'a Tally,
    on: bool,
}

impl Shadows for CountedShadows<'_> {
    fn hide<A: microbrdf::shade::Placing>(
        self,
        spheres: &[Sphere<A>],
        place: impl Fn() -> A::Place,
        light: &impl Light<A>,
        l: &Direction<A>,
    ) -> bool {
        if !self.on {
            return false;
        }
        self.tally.add("shadow", "", 1);
        let place = place();
        spheres.iter().any(|sphere| {
            let hidden = A::hides(sphere, &place, l, light.lamp());
            let way = match (hidden, light.lamp().is_some()) {
                (true, _) => "of a sphere in the way",
                (false, false) => "of a sphere beside a direction",
                (false, true) => "of a sphere beside the way to a lamp",
            };
            self.tally.add("shadow", way, 1);
            hidden
        })
    }
}

/// The view is asked before any shape is: it counts what the scene does with
/// spheres, too.
struct CountedView<'a, A: HostArithmetic> {
    tally: &'a Tally,
    prepared: &'a Prepared<A>,
}

impl<A: HostArithmetic> View<A> for CountedView<'_, A> {
    fn at(&self, x: usize, y: usize) -> Option<(A::Depth, Direction<A>, u8)> {
        if self.prepared.samples == AnySamples::Four {
            self.tally.add("sample", "", 1);
        }
        if let Some(view) = &self.prepared.view {
            self.tally.add("mesh", "sought", 1);
            self.tally.add("mesh", "span", spans(view, x, y));
            let seen = AnyView(Some(view)).at(x, y);
            if seen.is_some() {
                self.tally.add("ray", "", 1);
                let way = match view.normals {
                    StoredNormals::Three(_) => "normal of 3 bytes",
                    StoredNormals::Four(_) => "normal of 4 bytes",
                };
                self.tally.add("mesh", way, 1);
                return seen;
            }
        }
        let spheres = &self.prepared.spheres;
        let (near, beside): (Vec<_>, Vec<_>) =
            spheres.iter().partition(|sphere| sphere.extent.holds(x, y));
        self.tally.add("sphere", "beside", beside.len() as u64);
        if near.is_empty() && self.prepared.planes.is_empty() {
            // One sphere is tested for a whole row at once, as it turns out.
            let way = if spheres.len() > 1 {
                "beside several spheres"
            } else {
                "beside one"
            };
            self.tally.add("background", way, 1);
            return None;
        }
        self.tally.add("ray", "", 1);
        let d = A::ray(&self.prepared.camera, x, y);
        for sphere in &near {
            self.tally.add("sphere", way(sphere, &d), 1);
        }
        if spheres.len() > 1 {
            self.tally.add("sphere", "of several", near.len() as u64);
        }
        None
    }
}

/// Spans that are looked at before column `x` of row `y` is found, or not.
fn spans<A: HostArithmetic>(view: &PreparedView<A>, x: usize, y: usize) -> u64 {
    let ends = |y: usize| view.rows.get(y).map_or(0, |end| *end as usize);
    let row = view.spans.get(ends(y)..ends(y + 1)).unwrap_or_default();
    let passed = row
        .iter()
        .take_while(|span| x >= usize::from(span.parts().1))
        .count();
    row.len().min(passed + 1) as u64
}

/// How far the test of a sphere gets.
fn way<A: HostArithmetic>(sphere: &Sphere<A>, d: &A::Ray) -> &'static str {
    let along = A::along(&sphere.eye, d);
    let Some(nearest) = A::nearest(&sphere.eye, d, along) else {
        return "far off";
    };
    if A::half_chord(&nearest).is_none() {
        return "missed";
    }
    "hit"
}
