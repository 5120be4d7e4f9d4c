//! Constructors refuse what is out of range, by the name of the parameter,
//! and take the very ends.

use microbrdf::ParameterError;
use microbrdf::Rgb;

/// Asserts who is blamed.
#[track_caller]
fn refused<T>(result: Result<T, ParameterError>, parameter: &str) {
    match result {
        Ok(_) => panic!("{parameter} was accepted"),
        Err(error) => {
            assert_eq!(error.parameter, parameter);
            assert_eq!(
                error.to_string(),
                format!("{parameter} must be {}", error.accepted)
            );
            assert!(error.accepted.contains(|c: char| c.is_ascii_digit()));
        }
    }
}

#[track_caller]
fn taken<T>(result: Result<T, ParameterError>) {
    if let Err(error) = result {
        panic!("{error}");
    }
}

mod f32 {
    use super::*;
    use microbrdf::arithmetic::F32;
    use microbrdf::brdf::{
        Lambert, MetallicPhong, Patch, PatchExponential, Phong, Plastic, PowerModel, RetroPhong,
    };

    const NONE: [f32; 3] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];

    #[test]
    fn exponents() {
        for n in NONE
            .into_iter()
            .chain([-1e-30, -1.0, 1.000_001e8, f32::MAX])
        {
            refused(MetallicPhong::<F32>::new(n), "exponent");
            refused(Phong::<F32>::new(n), "exponent");
            refused(RetroPhong::<F32>::new(n), "exponent");
            refused(
                Plastic::<F32>::new(Rgb::grey(0.5), Rgb::grey(0.5), n),
                "exponent",
            );
        }
        for n in [0.0, -0.0, 1e-30, 0.5, 1.0, 1e8] {
            taken(MetallicPhong::<F32>::new(n));
        }
    }

    #[test]
    fn powers_of_the_cosine() {
        for p in NONE.into_iter().chain([-1e-7, 1.000_001]) {
            refused(PowerModel::<F32>::new(p), "p");
        }
        for p in [0.0, 1e-7, 0.5, 1.0] {
            taken(PowerModel::<F32>::new(p));
        }
    }

    #[test]
    fn radii() {
        for radius in NONE.into_iter().chain([-1.0, 0.0, 0.999_99e-4, 2.000_001]) {
            refused(Patch::<F32>::new(radius), "radius");
        }
        for radius in [1e-4, 1.0, 2.0] {
            taken(Patch::<F32>::new(radius));
        }
    }

    #[test]
    fn sharpnesses() {
        for s in NONE.into_iter().chain([-1e-30, 4096.001]) {
            refused(PatchExponential::<F32>::new(s), "sharpness");
        }
        for s in [0.0, 1e-30, 4096.0] {
            taken(PatchExponential::<F32>::new(s));
        }
    }

    #[test]
    fn albedos_and_shares() {
        let with = |channel: usize, value: f32| {
            let mut rgb = [0.25; 3];
            rgb[channel] = value;
            Rgb::from_array(rgb)
        };
        let grey = Rgb::grey(0.25);
        for channel in 0..3 {
            for bad in NONE.into_iter().chain([-1e-6, 1.000_001]) {
                refused(Lambert::<F32>::new(with(channel, bad)), "albedo");
                refused(Plastic::<F32>::new(with(channel, bad), grey, 9.0), "albedo");
                refused(
                    Plastic::<F32>::new(grey, with(channel, bad), 9.0),
                    "specular",
                );
            }
            for other in 0..3 {
                refused(
                    Plastic::<F32>::new(with(channel, 0.7), with(other, 0.301), 9.0),
                    "specular",
                );
                taken(Plastic::<F32>::new(
                    with(channel, 0.7),
                    with(other, 0.3),
                    9.0,
                ));
            }
        }
        taken(Lambert::<F32>::new(Rgb::grey(0.0)));
        taken(Lambert::<F32>::new(Rgb::grey(1.0)));
        taken(Plastic::<F32>::new(Rgb::grey(0.0), Rgb::grey(0.0), 9.0));
    }
}

mod q31 {
    use super::*;
    use microbrdf::arithmetic::Q31;
    use microbrdf::brdf::{
        Lambert, MetallicPhong, Patch, PatchExponential, Phong, Plastic, PowerModel, RetroPhong,
    };
    use microbrdf::fixed::types::{U0F32, U1F31, U2F30, U32F32};

    /// The constructors of models whose tables have the default size.
    type M = Q31;

    #[test]
    fn exponents() {
        let step = U32F32::DELTA;
        let greatest = U32F32::from_num(100_000_000);
        for n in [
            step,
            U32F32::lit("0.5"),
            U32F32::ONE - step,
            greatest + step,
            U32F32::MAX,
        ] {
            refused(MetallicPhong::<M>::new(n), "exponent");
            refused(Phong::<M>::new(n), "exponent");
            refused(RetroPhong::<M>::new(n), "exponent");
            let half = Rgb::grey(U1F31::lit("0.5"));
            refused(Plastic::<M>::new(half, half, n), "exponent");
        }
        for n in [U32F32::ZERO, U32F32::ONE, U32F32::ONE + step, greatest] {
            taken(MetallicPhong::<M>::new(n));
        }
    }

    #[test]
    fn powers_of_the_cosine() {
        refused(PowerModel::<M>::new(U0F32::ZERO), "p");
        taken(PowerModel::<M>::new(U0F32::DELTA));
        taken(PowerModel::<M>::new(U0F32::MAX));
    }

    #[test]
    fn radii() {
        let step = U2F30::DELTA;
        // 1e-4 rounded down is taken: nobody can write it more exactly.
        let least = U2F30::from_bits(107_374);
        for radius in [U2F30::ZERO, step, least - step, U2F30::lit("2") + step] {
            refused(Patch::<M>::new(radius), "radius");
        }
        for radius in [least, U2F30::ONE, U2F30::lit("2")] {
            taken(Patch::<M>::new(radius));
        }
    }

    #[test]
    fn sharpnesses() {
        let greatest = U32F32::from_num(4096);
        refused(
            PatchExponential::<M>::new(greatest + U32F32::DELTA),
            "sharpness",
        );
        refused(PatchExponential::<M>::new(U32F32::MAX), "sharpness");
        for s in [U32F32::ZERO, U32F32::DELTA, greatest] {
            taken(PatchExponential::<M>::new(s));
        }
    }

    #[test]
    fn albedos_and_shares() {
        let quarter = U1F31::lit("0.25");
        let with = |channel: usize, value: U1F31| {
            let mut rgb = [quarter; 3];
            rgb[channel] = value;
            Rgb::from_array(rgb)
        };
        let n = U32F32::from_num(9);
        let above = U1F31::ONE + U1F31::DELTA;
        for channel in 0..3 {
            refused(Lambert::<M>::new(with(channel, above)), "albedo");
            refused(
                Plastic::<M>::new(with(channel, above), Rgb::grey(quarter), n),
                "albedo",
            );
            refused(
                Plastic::<M>::new(Rgb::grey(quarter), with(channel, above), n),
                "specular",
            );
            for other in 0..3 {
                let most = with(channel, U1F31::lit("0.7"));
                refused(
                    Plastic::<M>::new(most, with(other, U1F31::lit("0.301")), n),
                    "specular",
                );
                taken(Plastic::<M>::new(most, with(other, U1F31::lit("0.3")), n));
            }
        }
        taken(Lambert::<M>::new(Rgb::grey(U1F31::ONE)));
        taken(Plastic::<M>::new(
            Rgb::grey(U1F31::ZERO),
            Rgb::grey(U1F31::ZERO),
            n,
        ));
    }
}

#[test]
fn profiles() {
    use microbrdf::table::{PROFILE_KNOTS, ProfileCurve};
    let with = |index: usize, knot: u32| {
        let mut knots = [1 << 30; PROFILE_KNOTS];
        knots[index] = knot;
        knots
    };
    for index in [0, 1, PROFILE_KNOTS - 1] {
        taken(ProfileCurve::new(with(index, 1 << 31), 11));
        refused(ProfileCurve::new(with(index, (1 << 31) + 1), 0), "knots");
    }
    refused(ProfileCurve::new(with(0, 0), 12), "halvings");
}

/// Lobes and patches with a light's gain in their tables.
mod exposed {
    use super::*;
    use microbrdf::arithmetic::Q15;
    use microbrdf::brdf::{ExposedMetal, ExposedPatch, ExposedPhong, MetallicPhong, Patch};
    use microbrdf::fixed::types::{U2F30, U32F32};
    use microbrdf::table::{COSINE_KNOTS, CosineCurve};

    fn lobe() -> MetallicPhong<Q15> {
        MetallicPhong::<Q15>::new(U32F32::lit("20")).expect("an exponent")
    }

    fn gain(r: &str, g: &str, b: &str) -> Rgb<U32F32> {
        let [r, g, b] = [r, g, b].map(|k| k.parse().expect("a number"));
        Rgb { r, g, b }
    }

    fn level(entry: u16) -> CosineCurve {
        CosineCurve::from_entries([[entry; 3]; COSINE_KNOTS])
    }

    #[test]
    fn gains() {
        let phong = |gain| ExposedPhong::<129>::new(lobe(), gain);
        let metal = |gain| ExposedMetal::<129, 65>::new(lobe(), &level(1 << 15), gain);
        for (dim, bright) in [("1.9", "255.9"), ("2.1", "257"), ("0", "1000")] {
            taken(phong(gain(dim, bright, bright)));
            taken(phong(gain(bright, bright, dim)));
            taken(metal(gain(bright, dim, bright)));
        }
        for (dim, bright) in [("1.9", "257"), ("7", "1000"), ("0.0000000003", "300")] {
            refused(phong(gain(dim, bright, bright)), "gain");
            refused(phong(gain(bright, bright, dim)), "gain");
            refused(metal(gain(bright, dim, bright)), "gain");
        }
        // At twice the brightness, a curve that is half as bright somewhere.
        let mut entries = [[1 << 15; 3]; COSINE_KNOTS];
        entries[COSINE_KNOTS - 1] = [1 << 14; 3];
        let curve = CosineCurve::from_entries(entries);
        let metal = |gain| ExposedMetal::<129, 65>::new(lobe(), &curve, gain);
        taken(metal(gain("4.2", "260", "260")));
        refused(metal(gain("4.0", "260", "260")), "gain");
        taken(phong(gain("0", "0", "0")));
    }

    #[test]
    fn gains_of_patches() {
        let patch = Patch::<Q15>::new(U2F30::lit("0.1")).expect("a radius");
        let exposed = |gain| ExposedPatch::<129>::new(patch, gain);
        for [r, g, b] in [
            ["16384", "0", "1"],
            ["1", "16384", "0"],
            ["0", "1", "16384"],
        ] {
            taken(exposed(gain(r, g, b)));
        }
        let more = "16384.0001";
        for [r, g, b] in [[more, "0", "1"], ["1", more, "0"], ["0", "1", more]] {
            refused(exposed(gain(r, g, b)), "gain");
        }
    }

    #[test]
    fn curves() {
        // In the coarse part a cell is from one entry to the next. The greatest
        // entry is between 1 and 2: a half of 2 is 32768.
        for (from, to, takes) in [
            (40_000, 7_232, true),
            (40_000, 7_228, false),
            (7_236, 40_000, true),
            (7_232, 40_000, false),
        ] {
            let mut entries = [[from; 3]; COSINE_KNOTS];
            for entry in entries.iter_mut().skip(80) {
                *entry = [to; 3];
            }
            let curve = CosineCurve::from_entries(entries);
            let model = ExposedMetal::<129, 65>::new(lobe(), &curve, Rgb::grey(U32F32::ONE));
            if takes {
                taken(model);
            } else {
                refused(model, "fresnel");
            }
        }
    }
}
