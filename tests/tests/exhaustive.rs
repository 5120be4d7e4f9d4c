//! Every 16-bit input of each scalar step, with 64 exponents, sharpnesses,
//! powers, cosines, shares and gains: the bounds that are found are those in
//! the documentation.

use microbrdf_tests::arithmetic::Tested;
use microbrdf_tests::in_every_arithmetic;
use microbrdf_tests::steps::{BOUNDS, Step};

in_every_arithmetic!(lobes, profiles, every_other_step);

#[track_caller]
fn check<A: Tested>(steps: &[Step]) {
    let mut faults = Vec::new();
    for &step in steps {
        let Some(bound) = BOUNDS
            .iter()
            .find(|bound| bound.arithmetic == A::NAME && bound.step == step)
        else {
            faults.push(format!("{} {step:?}: no bound", A::NAME));
            continue;
        };
        let found = step.greatest::<A>();
        println!("{} {step:?}: {found:.3e}", A::NAME);
        if found > bound.error || found < 0.9 * bound.error {
            faults.push(format!(
                "{} {step:?}: {found:.4e}, documented {:e}",
                A::NAME,
                bound.error
            ));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

fn lobes<A: Tested>() {
    check::<A>(&[Step::Lobe, Step::LobeTail, Step::BroadLobe]);
}

fn profiles<A: Tested>() {
    check::<A>(&[Step::Profile, Step::ProfileTail]);
}

fn every_other_step<A: Tested>() {
    check::<A>(&[
        Step::CosinePower,
        Step::Ratio,
        Step::Product,
        Step::Exposure,
    ]);
}

#[test]
fn every_step_is_checked() {
    for step in Step::ALL {
        for arithmetic in ["f32", "micromath", "q31", "q15"] {
            let rows = BOUNDS
                .iter()
                .filter(|bound| bound.arithmetic == arithmetic && bound.step == step);
            assert_eq!(rows.count(), 1, "{arithmetic} {step:?}");
        }
    }
}
