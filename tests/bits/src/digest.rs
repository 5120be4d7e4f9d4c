//! One model's checksum.

use microbrdf::Rgb;
use microbrdf::brdf::Brdf;
use microbrdf::geometry::{Direction, ShadingFrame, World};

use crate::arithmetic::Sampled;
use crate::raw::Checksum;
use crate::samples::Samples;

/// Sums up a model's peak and, for `count` pairs of directions, BRDF, share
/// and reflected radiance in the shading frame and in world space, and the
/// pixel at two exposures.
pub fn digest<A: Sampled>(model: &impl Brdf<A>, count: usize) -> u64 {
    let mut sum = Checksum::new();
    sum.feed(model.peak());
    let gains = [1 << 16, 80 << 16].map(|gain| Rgb::grey(A::gain(gain)));
    let mut samples = Samples::new(0x5EED);
    for _ in 0..count {
        let [l, v] = samples.pair();
        let frame = ShadingFrame::new(direction::<A>(l), direction::<A>(v));
        sum.feed_rgb(model.brdf(&frame));
        sum.feed_rgb(model.share(&frame));
        sum.feed_rgb(model.reflect(&frame));
        for gain in &gains {
            let pixel = A::linear(model.shade(gain, &frame));
            for component in pixel.to_raw() {
                sum.feed(component);
            }
            for code in pixel.srgb8() {
                sum.feed(u32::from(code));
            }
            sum.feed(u32::from(pixel.rgb565()));
            sum.feed(pixel.luminance());
        }
        let [n, l, v] = rotated(l, v).map(direction::<A>);
        let world = World::new(n, l, v);
        sum.feed_rgb(model.brdf(&world));
        sum.feed_rgb(model.share(&world));
        sum.feed_rgb(model.reflect(&world));
    }
    sum.value()
}

fn direction<A: Sampled>([x, y, z]: [i32; 3]) -> Direction<A> {
    Direction::new(A::component(x), A::component(y), A::component(z))
}

/// N, L and V in a frame whose axes are (1, 2, 2)/3, (2, 1, −2)/3 and
/// (2, −2, 1)/3, in 30 fraction bits.
fn rotated(l: [i32; 3], v: [i32; 3]) -> [[i32; 3]; 3] {
    const AXES: [[i64; 3]; 3] = [[1, 2, 2], [2, 1, -2], [2, -2, 1]];
    let turn = |a: [i32; 3]| {
        [0, 1, 2].map(|i| {
            let sum: i64 = (0..3).map(|j| AXES[j][i] * i64::from(a[j])).sum();
            (sum / 3) as i32
        })
    };
    [turn([0, 0, 1 << 30]), turn(l), turn(v)]
}
