//! Every model of the core.

use microbrdf::brdf::{Brdf, Flat, Metal, Metallic, Mirror, Retro};
use microbrdf::table::{COSINE_KNOTS, CosineCurve};

use crate::arithmetic::Sampled;
use crate::digest::digest;

/// A parameter with 16 fraction bits.
const fn whole(number: u64) -> u64 {
    number << 16
}

/// Hands the name and the checksum over `count` pairs of every model of the
/// core to `sink`, one after the other.
///
/// Each model is built, its table with it, when its turn comes, and is gone
/// before the next, so that a small stack is enough for small tables.
///
/// # Panics
/// If a constructor refuses a parameter that is within its range.
pub fn checksums<A: Sampled>(count: usize, sink: &mut dyn FnMut(&'static str, u64)) {
    let fraction = |sixteenths: u32| sixteenths << 12;
    let albedo = [fraction(9), fraction(5), fraction(1)];
    each(sink, count, "lambert", || A::lambert(albedo));
    for (name, n) in [
        ("metallic-phong, n = 0", 0),
        ("metallic-phong, n = 1", whole(1)),
        ("metallic-phong, n = 2.5", whole(5) / 2),
        ("metallic-phong, n = 20", whole(20)),
        ("metallic-phong, n = 5e3", whole(5_000)),
        ("metallic-phong, n = 1e8", whole(100_000_000)),
    ] {
        each(sink, count, name, || A::lobe::<Mirror, _>(n, Metallic));
    }
    each(sink, count, "phong, n = 20", || {
        A::lobe::<Mirror, _>(whole(20), Flat)
    });
    each(sink, count, "phong, n = 20, p = 0.5", || {
        A::lobe::<Mirror, _>(whole(20), A::power_model(1 << 15)?)
    });
    each(sink, count, "retro-phong, n = 20", || {
        A::lobe::<Retro, _>(whole(20), Metallic)
    });
    for (name, radius) in [
        ("patch, R = 0.3", 19_661),
        ("patch, R = 1.5", 3 << 15),
        ("patch, R = 2", 2 << 16),
    ] {
        each(sink, count, name, || A::patch(radius));
    }
    for (name, sharpness) in [
        ("patch-exponential, s = 0", 0),
        ("patch-exponential, s = 0.05", 3_277),
        ("patch-exponential, s = 4", whole(4)),
        ("patch-exponential, s = 4096", whole(4_096)),
    ] {
        each(sink, count, name, || A::patch_exponential(sharpness));
    }
    each(sink, count, "metal, n = 20", || {
        Ok(Metal::new(
            A::lobe::<Mirror, _>(whole(20), Metallic)?,
            curve(),
        ))
    });
    each(sink, count, "plastic, n = 20", || {
        A::plastic(albedo, [fraction(3), fraction(5), fraction(7)], whole(20))
    });
}

#[inline(never)]
fn each<A: Sampled, M: Brdf<A>>(
    sink: &mut dyn FnMut(&'static str, u64),
    count: usize,
    name: &'static str,
    model: impl FnOnce() -> Result<M, microbrdf::ParameterError>,
) {
    match model() {
        Ok(model) => sink(name, digest::<A>(&model, count)),
        Err(error) => panic!("{name}: {error}"),
    }
}

/// Three curves that differ, bend and pass 1.
fn curve() -> CosineCurve {
    let mut entries = [[0; 3]; COSINE_KNOTS];
    for (index, entry) in entries.iter_mut().enumerate() {
        let cosine = u32::from(CosineCurve::knot(index));
        let rest = 256 - cosine;
        *entry = [
            32_768 + cosine as u16,
            (18_000 + rest * rest / 5) as u16,
            (9_000 + rest * rest * rest / 1_000) as u16,
        ];
    }
    CosineCurve::from_entries(entries)
}
