//! Of generalised Lambert.

use microbrdf::brdf::Brdf;
use microbrdf_tests::arithmetic::Tested;
use microbrdf_tests::given::{frame, model};
use microbrdf_tests::in_every_arithmetic;

use crate::{at, close, share};

in_every_arithmetic!(
    generalised_lambert_is_the_closed_form,
    the_full_moon_is_flat,
);

/// C is 0.27128 for d = 0.5 in Table 4.3, whose constants are up to 5.2e-4 of
/// their value too great.
fn generalised_lambert_is_the_closed_form<A: Tested>() {
    let matt =
        model::<A>("model = \"generalised-lambert\", albedo = [0.8, 0.3, 0.1], smoothness = 0.5");
    let profile = |m: f64| (1.0 - 0.25 * m * m).powf(-0.25);
    let greatest = profile(1.9);
    let peak = 0.27128 * greatest;
    close(A::scale_value(matt.peak()), peak, 5.2e-4 * peak);
    let mut clipped = 0;
    for theta in [5.0, 30.0, 60.0, 72.0, 75.0, 80.0, 88.0] {
        for (other, phi) in [(theta, 0.0), (theta, 180.0), (80.0, 20.0), (40.0, 60.0)] {
            let (l, v) = (at(theta, 0.0), at(other, phi));
            let m = (l[0] + v[0]).hypot(l[1] + v[1]);
            let expected = profile(m.min(1.9)) / greatest * l[2];
            clipped += u32::from(m > 1.9);
            let found = share(&matt, &frame::<A>(l, v));
            for (channel, albedo) in [0.8, 0.3, 0.1].into_iter().enumerate() {
                close(
                    found[channel],
                    albedo * expected,
                    4e-4 * expected + 2.0 * A::PRODUCT_ERROR,
                );
            }
        }
    }
    assert!(clipped >= 4);
}

/// d = 1, L = V: the same radiance to where the clip begins, at 71.8°.
fn the_full_moon_is_flat<A: Tested>() {
    let moon = model::<A>("model = \"generalised-lambert\", albedo = 1, smoothness = 1");
    let at_angle = |theta: f64| share(&moon, &frame::<A>(at(theta, 40.0), at(theta, 40.0)))[0];
    let middle = at_angle(0.0);
    for theta in [10.0, 30.0, 50.0, 65.0, 71.0] {
        close(at_angle(theta), middle, 1e-3 * middle);
    }
    assert!(at_angle(80.0) < 0.7 * middle);
}
