//! Of the patch.

use microbrdf::brdf::Brdf;
use microbrdf_tests::arithmetic::Tested;
use microbrdf_tests::given::{frame, model};
use microbrdf_tests::in_every_arithmetic;

use crate::{at, close, share};

in_every_arithmetic!(the_patch_is_a_disc_of_its_radius_about_r,);

/// m is measured in the base plane, between R and V, in any azimuth.
fn the_patch_is_a_disc_of_its_radius_about_r<A: Tested>() {
    let l = at(40.0, 200.0);
    for radius in [0.05, 0.3] {
        let patch = model::<A>(&format!("model = \"patch\", radius = {radius}"));
        for phi in 0..24 {
            let (s, c) = (15.0 * f64::from(phi)).to_radians().sin_cos();
            for (m, inside) in [(0.999 * radius, true), (1.001 * radius, false)] {
                let (x, y) = (-l[0] + m * c, -l[1] + m * s);
                let v = [x, y, (1.0 - x * x - y * y).sqrt()];
                let geometry = frame::<A>(l, v);
                let expected = if inside {
                    A::component_value(geometry.l.z)
                } else {
                    0.0
                };
                close(share(&patch, &geometry)[0], expected, A::UNIT_STEP);
            }
        }
    }
    // R ≤ 1: 1/(πR²); above, the part inside the base circle alone.
    for (radius, peak) in [(0.5, 4.0), (1.0, 1.0), (1.7, 1.0)] {
        let patch = model::<A>(&format!("model = \"patch\", radius = {radius}"));
        let found = A::scale_value(patch.peak()) * std::f64::consts::PI;
        close(found, peak, 1e-6);
    }
}
