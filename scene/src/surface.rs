//! A scene's materials, chosen at run time.

use microbrdf::Rgb;
use microbrdf::geometry::Direction;
use microbrdf::shade::{AlbedoDaylight, Checker, Coat, Daylight, Light, Scene, Spot, Surface};

use crate::host::HostArithmetic;
use crate::lamp::AnyLight;
use crate::mesh::AnyView;
use crate::model::AnyModel;
use crate::prepare::{Prepared, PreparedCoat};
use crate::quality::{AnySamples, AnyShadows};

/// The core's coat with any model and perhaps a sky.
type AnyCoat<'a, A> = Coat<'a, A, AnyModel<A>, AnyDaylight<A>>;

/// A sky or none.
#[derive(Clone, Copy, Debug)]
pub struct AnyDaylight<A: HostArithmetic>(Option<AlbedoDaylight<A>>);

impl<A: HostArithmetic> Daylight<A> for AnyDaylight<A> {
    fn light(&self, n_dot_v: A::Cosine) -> Rgb<A::Light> {
        self.0
            .as_ref()
            .map_or_else(Rgb::default, |daylight| daylight.light(n_dot_v))
    }
}

/// The sum of a material's parts.
#[derive(Clone, Debug)]
pub struct AnySurface<'a, A: HostArithmetic> {
    first: AnyCoat<'a, A>,
    rest: Vec<AnyCoat<'a, A>>,
}

impl<A: HostArithmetic> Surface<A> for AnySurface<'_, A> {
    fn light(
        &self,
        n: &Direction<A>,
        v: &Direction<A>,
        lights: &[impl Light<A>],
        spot: impl Spot<A>,
    ) -> Rgb<A::Light> {
        self.rest
            .iter()
            .fold(self.first.light(n, v, lights, spot), |sum, coat| {
                sum.zip(coat.light(n, v, lights, spot), A::add_light)
            })
    }
}

/// A scene of anything.
pub type AnyScene<'a, A> = Scene<
    'a,
    A,
    AnySurface<'a, A>,
    Checker<A>,
    AnyLight<A>,
    AnyView<'a, A>,
    AnyShadows,
    AnySamples,
>;

/// What a [`Scene`] borrows from.
#[derive(Clone, Debug)]
pub struct SceneParts<A: HostArithmetic> {
    prepared: Prepared<A>,
    /// Gains of each part of each material.
    gains: Vec<Vec<Vec<Rgb<A::Gain>>>>,
}

impl<A: HostArithmetic> SceneParts<A> {
    /// Rounds the gains of a prepared scene.
    #[must_use]
    pub fn new(prepared: Prepared<A>) -> Self {
        let rgb = |gain: &[f64; 3]| Rgb::from_array(gain.map(A::gain));
        let gains = prepared
            .coats
            .iter()
            .map(|coat| {
                coat.parts
                    .iter()
                    .map(|part| part.gains.iter().map(rgb).collect())
                    .collect()
            })
            .collect();
        Self { prepared, gains }
    }

    /// Its materials.
    #[must_use]
    pub fn surfaces(&self) -> Vec<AnySurface<'_, A>> {
        self.prepared
            .coats
            .iter()
            .zip(&self.gains)
            .map(|(coat, gains)| surface(coat, gains))
            .collect()
    }

    /// The scene with these materials.
    #[must_use]
    pub fn scene<'a>(&'a self, materials: &'a [AnySurface<'a, A>]) -> AnyScene<'a, A> {
        Scene {
            camera: self.prepared.camera,
            view: AnyView(self.prepared.view.as_ref()),
            spheres: &self.prepared.spheres,
            planes: &self.prepared.planes,
            lights: &self.prepared.lights,
            materials,
            background: self.prepared.background,
            shadows: self.prepared.shadows,
            samples: self.prepared.samples,
        }
    }
}

fn surface<'a, A: HostArithmetic>(
    coat: &'a PreparedCoat<A>,
    gains: &'a [Vec<Rgb<A::Gain>>],
) -> AnySurface<'a, A> {
    let mut coats = coat
        .parts
        .iter()
        .zip(gains)
        .enumerate()
        .map(|(index, (part, gains))| Coat {
            model: part.model.clone(),
            gains,
            // The sky answers to the whole: it is added once.
            daylight: AnyDaylight(coat.daylight.filter(|_| index == 0).map(|(albedo, gain)| {
                AlbedoDaylight {
                    albedo,
                    gain: Rgb::from_array(gain.map(A::gain)),
                }
            })),
        });
    let first = coats.next().expect("a material has a part");
    AnySurface {
        first,
        rest: coats.collect(),
    }
}
