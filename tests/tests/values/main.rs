//! Values that tell right code from wrong code that albedo tests pass:
//! against closed forms, and against what the wrong formula would give.

mod fresnel;
mod lambert;
mod lobe;
mod patch;

use microbrdf::brdf::Brdf;
use microbrdf::geometry::Geometry;
use microbrdf_scene::AnyModel;
use microbrdf_tests::arithmetic::Tested;

/// The direction at angles in degrees.
fn at(theta: f64, phi: f64) -> [f64; 3] {
    let (theta, phi) = (theta.to_radians(), phi.to_radians());
    [
        theta.sin() * phi.cos(),
        theta.sin() * phi.sin(),
        theta.cos(),
    ]
}

fn share<A: Tested>(model: &AnyModel<A>, geometry: &impl Geometry<A>) -> [f64; 3] {
    model.share(geometry).to_array().map(A::unit_value)
}

fn brdf<A: Tested>(model: &AnyModel<A>, geometry: &impl Geometry<A>) -> [f64; 3] {
    model.brdf(geometry).to_array().map(A::value_value)
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{found} for {expected}: off by {:e}, may be {tolerance:e}",
        found - expected
    );
}

/// Twenty angles, the horizon all but touched.
fn angles() -> impl Iterator<Item = f64> {
    (0..=19).map(|i| 4.7 * f64::from(i)).chain([89.9, 89.999])
}
