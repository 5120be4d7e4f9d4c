//! Samplers of the core beside the densities that they must have, and the
//! chi-square test of the one against the other.

use std::f64::consts::{PI, TAU};

use fixed::types::{U0F32, U2F30, U32F32};
use microbrdf::arithmetic::{F32, Q31};
use microbrdf::brdf::{Flat, Foreshortening, Metallic, Mirror, Retro};
use microbrdf::sampling::{
    LobeAxis, MetalSampler, PatchExponentialSampler, PatchSampler, PhongLobeSampler, Sample,
    Sampling,
};
use microbrdf_reference as reference;
use microbrdf_scene::Material;
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;
use reference::quadrature::{Accuracy, Chart, chart_cell};
use reference::sampling::{PatchDisc, PatchMethod, PhongLobe, Sampler as _};
use reference::{Brdf as _, Direction};
use statrs::distribution::{ChiSquared, ContinuousCDF as _};

use crate::arithmetic::{Tested, rounded, value_of};

/// An arithmetic that has samplers.
pub trait Drawing: Tested + Sampling {
    /// The random number whose leading bits are these.
    fn uniform(word: u32) -> Self::Uniform;
    /// The lobe.
    fn lobe_sampler<X: LobeAxis, P: Foreshortening<Self> + Copy>(
        n: f64,
        foreshortening: P,
    ) -> PhongLobeSampler<Self, X, P>;
    /// The basic patch.
    fn patch_sampler(radius: f64) -> PatchSampler<Self>;
    /// The exponential mixture.
    fn mixture_sampler(sharpness: f64) -> PatchExponentialSampler<Self>;
}

const IN_RANGE: &str = "a parameter within its range";

impl Drawing for F32 {
    fn uniform(word: u32) -> f32 {
        (word >> 8) as f32 / (1 << 24) as f32
    }
    fn lobe_sampler<X: LobeAxis, P: Foreshortening<Self> + Copy>(
        n: f64,
        foreshortening: P,
    ) -> PhongLobeSampler<Self, X, P> {
        PhongLobeSampler::<Self, X, P>::with_foreshortening(n as f32, foreshortening)
            .expect(IN_RANGE)
    }
    fn patch_sampler(radius: f64) -> PatchSampler<Self> {
        PatchSampler::<Self>::new(radius as f32).expect(IN_RANGE)
    }
    fn mixture_sampler(sharpness: f64) -> PatchExponentialSampler<Self> {
        PatchExponentialSampler::<Self>::new(sharpness as f32).expect(IN_RANGE)
    }
}

impl Drawing for Q31 {
    fn uniform(word: u32) -> U0F32 {
        U0F32::from_bits(word)
    }
    fn lobe_sampler<X: LobeAxis, P: Foreshortening<Self> + Copy>(
        n: f64,
        foreshortening: P,
    ) -> PhongLobeSampler<Self, X, P> {
        PhongLobeSampler::<Self, X, P>::with_foreshortening(U32F32::from_num(n), foreshortening)
            .expect(IN_RANGE)
    }
    fn patch_sampler(radius: f64) -> PatchSampler<Self> {
        PatchSampler::<Self>::new(U2F30::from_num(radius)).expect(IN_RANGE)
    }
    fn mixture_sampler(sharpness: f64) -> PatchExponentialSampler<Self> {
        PatchExponentialSampler::<Self>::new(U32F32::from_num(sharpness)).expect(IN_RANGE)
    }
}

/// The sampler of a material.
///
/// # Panics
/// For a plastic, a free profile and what else has none.
pub fn sampler<A: Drawing>(material: &Material) -> Box<dyn Sample<A>> {
    match material {
        Material::Lambert { albedo } => Box::new(A::lambert(albedo.rgb()).expect(IN_RANGE)),
        Material::Phong {
            exponent: n,
            p,
            retro,
            ..
        } => match (*retro, *p) {
            (false, 0.0) => Box::new(A::lobe_sampler::<Mirror, _>(*n, Flat)),
            (false, 1.0) => Box::new(A::lobe_sampler::<Mirror, _>(*n, Metallic)),
            (true, 1.0) => Box::new(A::lobe_sampler::<Retro, _>(*n, Metallic)),
            (false, p) => {
                let power = A::power_model(p).expect(IN_RANGE);
                Box::new(A::lobe_sampler::<Mirror, _>(*n, power))
            }
            (true, p) => {
                let power = A::power_model(p).expect(IN_RANGE);
                Box::new(A::lobe_sampler::<Retro, _>(*n, power))
            }
        },
        Material::Patch { radius } => Box::new(A::patch_sampler(*radius)),
        Material::PatchExponential { sharpness } => Box::new(A::mixture_sampler(*sharpness)),
        Material::Metal {
            exponent,
            reflectance,
        } => Box::new(MetalSampler::new(
            A::lobe_sampler(*exponent, Metallic),
            reflectance.curve(),
        )),
        Material::Plastic { .. } => panic!("a plastic is sampled by its parts"),
        Material::PatchProfile { .. } => panic!("a free profile has no sampler"),
        Material::PatchMetal { .. }
        | Material::MetallicPaint { .. }
        | Material::GeneralisedLambert { .. } => panic!("it has no sampler in the core"),
    }
}

/// The density that a material's sampler must have, in f64: the reference's
/// own samplers give it, but for the far part of an exponential mixture.
pub fn density(material: &Material, v: Direction) -> Box<dyn Fn(&Direction) -> f64> {
    let material = material.clone();
    Box::new(move |l| {
        let model = material.reference();
        match &material {
            Material::Lambert { .. } => l.z.max(0.0) / PI,
            Material::Phong {
                exponent, retro, ..
            } => {
                let lobe = if *retro {
                    PhongLobe::retro(&*model, *exponent, v)
                } else {
                    PhongLobe::new(&*model, *exponent, v)
                };
                lobe.pdf(l)
            }
            Material::Metal { exponent, .. } => PhongLobe::new(&*model, *exponent, v).pdf(l),
            Material::Patch { radius } => PatchDisc::new(*radius, v, PatchMethod::Roulette).pdf(l),
            Material::PatchExponential { sharpness } => {
                if l.z < 0.0 {
                    return 0.0;
                }
                let m = (l.x + v.x).hypot(l.y + v.y);
                let distance = if m <= 1.0 { m } else { l.x.hypot(l.y) };
                model.peak() * (-sharpness * distance).exp() * l.z
            }
            Material::Plastic { .. } => panic!("a plastic is sampled by its parts"),
            Material::PatchProfile { .. } => panic!("a free profile has no sampler"),
            Material::PatchMetal { .. }
            | Material::MetallicPaint { .. }
            | Material::GeneralisedLambert { .. } => panic!("it has no sampler in the core"),
        }
    })
}

/// A sequence of random numbers.
pub struct Numbers(Pcg64Mcg);

impl Numbers {
    /// That of a seed.
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    /// The next two.
    pub fn pair<A: Drawing>(&mut self) -> [A::Uniform; 2] {
        [0, 1].map(|_| A::uniform((self.0.next_u64() >> 32) as u32))
    }
}

/// Rings about the lobe's centre, of equal shares of a pilot run, cut into
/// sectors.
pub struct Bins {
    v: Direction,
    chart: Chart,
    edges: Vec<f64>,
}

const RINGS: usize = 12;
const SECTORS: usize = 8;
/// Outcomes: the bins and the rejection.
pub const OUTCOMES: usize = RINGS * SECTORS + 1;

impl Bins {
    /// The bins for a sampler at V.
    pub fn new<A: Drawing>(
        sampler: &dyn Sample<A>,
        v: &microbrdf::geometry::Direction<A>,
        chart: Chart,
        numbers: &mut Numbers,
    ) -> Self {
        let place = value_of::<A>(v);
        let mut radii: Vec<f64> = (0..20_000)
            .filter_map(|_| sampler.sample(v, numbers.pair::<A>()))
            .map(|drawn| {
                chart
                    .coordinates(&place, &value_of::<A>(&drawn.direction))
                    .0
            })
            .collect();
        radii.sort_by(f64::total_cmp);
        let edges = (1..RINGS).map(|i| radii[i * radii.len() / RINGS]).collect();
        Self {
            v: place,
            chart,
            edges,
        }
    }

    /// The bin of a direction.
    pub fn index(&self, l: &Direction) -> usize {
        let (t, phi) = self.chart.coordinates(&self.v, l);
        let ring = self.edges.partition_point(|edge| *edge <= t);
        let sector = ((phi + PI) / TAU * SECTORS as f64) as usize;
        ring * SECTORS + sector.min(SECTORS - 1)
    }

    /// The density's integral over each bin, and what is missing from 1.
    pub fn shares(
        &self,
        creases: &dyn Fn(&Direction, &mut Vec<f64>),
        density: &dyn Fn(&Direction) -> f64,
    ) -> Vec<f64> {
        let accuracy = Accuracy {
            tolerance: 1e-7,
            outer_panels: 60,
            inner_panels: 30,
        };
        let per_area = |l: &Direction| if l.z > 0.0 { density(l) / l.z } else { 0.0 };
        let mut shares = Vec::new();
        for ring in 0..RINGS {
            let low = if ring == 0 { 0.0 } else { self.edges[ring - 1] };
            let high = self.edges.get(ring).copied().unwrap_or(f64::INFINITY);
            for sector in 0..SECTORS {
                let width = TAU / SECTORS as f64;
                let from = width * sector as f64 - PI;
                let share = chart_cell(
                    &self.v,
                    &self.chart,
                    (low, high),
                    (from, from + width),
                    accuracy,
                    &|l, out| creases(l, out),
                    &per_area,
                );
                shares.push(share.value);
            }
        }
        let total: f64 = shares.iter().sum();
        assert!(total <= 1.0 + 1e-5, "the density's integral is {total}");
        shares.push((1.0 - total).max(0.0));
        shares
    }
}

/// The probability of counts at least as far from their expectation; thin
/// bins are put together.
pub fn chi_square(counts: &[usize], shares: &[f64]) -> f64 {
    let all: usize = counts.iter().sum();
    let (mut sum, mut cells) = (0.0, 0);
    let mut thin = (0.0, 0.0);
    for (count, share) in counts.iter().zip(shares) {
        let (count, expected) = (*count as f64, share * all as f64);
        if expected < 20.0 {
            thin = (thin.0 + count, thin.1 + expected);
        } else {
            sum += (count - expected) * (count - expected) / expected;
            cells += 1;
        }
    }
    if thin.1 >= 5.0 {
        sum += (thin.0 - thin.1) * (thin.0 - thin.1) / thin.1;
        cells += 1;
    } else if thin.0 > thin.1 + 20.0 {
        // Samples where the density is all but 0.
        return 0.0;
    }
    ChiSquared::new(f64::from(cells - 1))
        .expect("more than one cell")
        .sf(sum)
}

/// The direction at a cosine and an azimuth of 25°, rounded.
pub fn view<A: Drawing>(cosine: f64) -> microbrdf::geometry::Direction<A> {
    rounded(crate::domain::direction(cosine, 25f64.to_radians()))
}
