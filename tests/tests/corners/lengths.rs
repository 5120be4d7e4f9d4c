//! Directions whose length is not 1.

use microbrdf::geometry::World;
use microbrdf_tests::arithmetic::{Tested, rounded};
use microbrdf_tests::domain::Set;
use microbrdf_tests::error::Subject;
use microbrdf_tests::frame::Rotations;
use microbrdf_tests::given::frame;
use microbrdf_tests::{in_every_arithmetic, registry};

use crate::faults::{Faults, in_range};

in_every_arithmetic!(
    lengths_within_the_contract_keep_the_accuracy,
    lengths_off_by_a_thousandth_stay_in_range,
);

/// Both lengths off by up to 2⁻¹⁴, either way: against the reference at the
/// same values no wider than the table of tolerances; and against it at the
/// unit vectors not much.
fn lengths_within_the_contract_keep_the_accuracy<A: Tested>() {
    const OFF: f64 = 1.0 / 16384.0;
    for entry in registry::all() {
        // At n = 1e8 half a squared length error is worth a whole lobe.
        if entry.n > 1e5 {
            continue;
        }
        let subject = Subject::<A>::new(&entry.material());
        for set in [Set::Lobe, Set::Random, Set::Mirror] {
            let pairs = entry.pairs(set, 9.0, 200);
            for (index, [l, v]) in pairs.into_iter().enumerate() {
                let [a, b] = [[OFF, OFF], [OFF, -OFF], [-OFF, OFF], [-OFF, -OFF]][index % 4];
                let pair = [l.map(|c| c * (1.0 + a)), v.map(|c| c * (1.0 + b))];
                let (shown, exact) = subject.codes(pair, 1.0);
                let (_, unit) = subject.codes([l, v], 1.0);
                // Their m sees a length error as such, not as a share of m.
                let patch = entry.model.starts_with("patch")
                    || ["metallic-paint", "generalised-lambert"].contains(&entry.model);
                // Rounding another length moves a sharp lobe's directions.
                let coarse = entry.n.sqrt() * A::COMPONENT_ERROR > 1e-4;
                for channel in 0..3 {
                    let code = f64::from(shown[channel]);
                    let arithmetic = (code - exact[channel]).abs();
                    assert!(
                        arithmetic <= A::CODE_ERROR,
                        "{}: {code} for {} {pair:?}",
                        entry.toml,
                        exact[channel]
                    );
                    assert!(
                        patch || coarse || (code - unit[channel]).abs() <= A::CODE_ERROR + 0.16,
                        "{}: {code} for {} of unit vectors, {pair:?}",
                        entry.toml,
                        unit[channel]
                    );
                }
            }
        }
    }
}

fn lengths_off_by_a_thousandth_stay_in_range<A: Tested>() {
    let mut faults = Faults::default();
    let mut rotations = Rotations::new(12);
    for entry in registry::all() {
        let model = entry.material().model::<A>().expect("a material");
        for set in Set::ALL {
            for (index, [l, v]) in entry.pairs(set, 9.0, 100).into_iter().enumerate() {
                let [a, b] =
                    [[1e-3, 1e-3], [1e-3, -1e-3], [-1e-3, 1e-3], [-1e-3, -1e-3]][index % 4];
                let pair = [l.map(|c| c * (1.0 + a)), v.map(|c| c * (1.0 + b))];
                in_range(
                    &mut faults,
                    &entry.toml,
                    &model,
                    &frame::<A>(pair[0], pair[1]),
                );
                let [n, l, v] = rotations.turn(pair).map(rounded::<A>);
                in_range(&mut faults, &entry.toml, &model, &World::new(n, l, v));
            }
        }
        let up = frame::<A>([0.0, 0.0, 1.001], [0.0, 0.0, 1.001]);
        in_range(&mut faults, &entry.toml, &model, &up);
    }
}
