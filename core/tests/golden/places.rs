//! Rays, shapes and lamps of any size and place: what saturates, falls outside
//! or is too far to keep its digits.

use microbrdf::Rgb;
use microbrdf::brdf::Brdf;
use microbrdf::geometry::{Direction, World};
use microbrdf::shade::{Camera, Extent, Sphere};
use microbrdf_bits::Checksum;

use crate::Sums;
use crate::given::{Viewed, Words};

/// Rounds for each sum.
const COUNT: usize = 4_000;

/// Adds a sum for each step.
pub fn add<A: Viewed>(sums: &mut Sums) {
    sums.push("any ray at a sphere", spheres::<A>());
    sums.push("any ray at a plane", planes::<A>());
    sums.push("any lamp", lamps::<A>());
    sums.push("any shadow", shadows::<A>());
    sums.push("any shadow far from its lamp", far_shadows::<A>());
}

/// Numbers made of words.
struct Numbers(Words);

impl Numbers {
    /// Any in −1 … 1.
    fn signed(&mut self) -> f64 {
        f64::from(self.0.word() as i32) / f64::from(1u32 << 31)
    }

    /// Any in −`most` … `most`, as often of one order of magnitude as of
    /// another.
    fn any(&mut self, most: f64) -> f64 {
        self.signed() * most / f64::from(1u32 << (self.0.word() % 20))
    }

    /// Three.
    fn three(&mut self, mut number: impl FnMut(&mut Self) -> f64) -> [f64; 3] {
        [(); 3].map(|()| number(self))
    }

    /// A unit vector.
    fn unit(&mut self) -> [f64; 3] {
        let vector = self.three(Self::signed);
        let length = vector.iter().map(|c| c * c).sum::<f64>().sqrt();
        vector.map(|c| c / length)
    }
}

/// The ray of the middle of a picture.
fn middle<A: Viewed>(forward: [f64; 3]) -> A::Ray {
    let still = [0.0; 3].map(A::fine);
    let camera = Camera::<A> {
        width: 1,
        height: 1,
        forward: forward.map(A::fine),
        right: still,
        up: still,
    };
    A::ray(&camera, 0, 0)
}

/// A direction, rounded.
fn direction<A: Viewed>(vector: [f64; 3]) -> Direction<A> {
    crate::given::direction(vector.map(|c| (c * f64::from(1 << 30)) as i32))
}

fn feed<A: Viewed>(sum: &mut Checksum, direction: &Direction<A>) {
    for component in [direction.x, direction.y, direction.z] {
        sum.feed(A::bits(component));
    }
}

/// A camera of any steps, and a pixel of it; now and then rays of no length.
fn any_ray<A: Viewed>(numbers: &mut Numbers, round: usize) -> A::Ray {
    if round % 4 != 0 {
        return middle::<A>(numbers.unit());
    }
    let most = if round % 16 == 0 { 0.0 } else { 1.9 };
    let camera = Camera::<A> {
        width: 401,
        height: 300,
        forward: numbers.three(|n| n.any(most)).map(A::fine),
        right: numbers.three(|n| n.any(most / 400.0)).map(A::fine),
        up: numbers.three(|n| n.any(most / 400.0)).map(A::fine),
    };
    let [x, y] = [401, 300].map(|size| numbers.0.word() as usize % size);
    A::ray(&camera, x, y)
}

fn spheres<A: Viewed>() -> u64 {
    let mut numbers = Numbers(Words::new(0x5F_E2E5));
    let mut sum = Checksum::new();
    for round in 0..COUNT {
        let d = any_ray::<A>(&mut numbers, round);
        feed::<A>(&mut sum, &A::reverse(&d));
        let eye = numbers.three(|n| n.any(127.9)).map(A::length);
        let radius = A::length(numbers.any(127.9));
        let along = A::along(&eye, &d);
        sum.feed(A::length_bits(along));
        let half = A::nearest(&eye, &d, along).and_then(|nearest| {
            let half = A::half_chord(&nearest)?;
            feed::<A>(&mut sum, &A::entry(&nearest, half, &d));
            Some(half)
        });
        let depth = half.and_then(|half| A::sphere_depth(radius, along, half));
        sum.feed(u32::from(half.is_some()) << 1 | u32::from(depth.is_some()));
        if let Some(depth) = depth {
            let from = A::place(&d, depth);
            let (to, _) = A::towards(&from, &[0.0; 3].map(A::length), radius);
            feed::<A>(&mut sum, &to);
        }
    }
    sum.value()
}

fn planes<A: Viewed>() -> u64 {
    let mut numbers = Numbers(Words::new(0x71A_1E55));
    let mut sum = Checksum::new();
    for round in 0..COUNT {
        let d = any_ray::<A>(&mut numbers, round);
        let normal = direction::<A>(numbers.unit());
        let height = A::length(numbers.any(127.9));
        let eye = A::fine(numbers.any(1_000.0));
        let across = numbers.three(|n| n.any(30.0)).map(A::fine);
        let Some(depth) = A::plane_depth(height, &normal, &d) else {
            sum.feed(2);
            continue;
        };
        sum.feed(u32::from(A::odd_stripe(eye, &across, &d, depth)));
        let lamp = numbers.three(|n| n.any(127.9)).map(A::length);
        let (to, _) = A::towards(&A::place(&d, depth), &lamp, height);
        feed::<A>(&mut sum, &to);
    }
    sum.value()
}

fn lamps<A: Viewed>() -> u64 {
    let mut numbers = Numbers(Words::new(0x1A_3F5));
    let model = A::lambert([1 << 16, 1 << 14, 5]).expect("an albedo");
    let mut sum = Checksum::new();
    for round in 0..COUNT {
        let toward = numbers.unit();
        let d = middle::<A>(toward);
        let [near, range] = [numbers.any(100.0).abs(), numbers.any(100.0)].map(A::length);
        let depth = A::stored_depth(near, range, numbers.0.word() as u16);
        let place = A::place(&d, depth);
        // Now and then in the lamp itself.
        let lamp = if round % 50 == 0 {
            toward.map(|c| A::length(c / 8.0))
        } else {
            numbers.three(|n| n.any(127.9)).map(A::length)
        };
        let place = if round % 50 == 0 {
            let eighth = A::stored_depth(A::length(0.125), A::length(0.0), 0);
            A::place(&d, eighth)
        } else {
            place
        };
        let (l, dimming) = A::towards(&place, &lamp, A::length(numbers.any(60.0)));
        feed::<A>(&mut sum, &l);
        let [n, v] = [numbers.unit(), numbers.unit()].map(direction::<A>);
        let Rgb { r, g, b } = model.share(&World::new(n, l, v));
        let narrow = A::narrow(dimming, g);
        for share in [r, g, b] {
            sum.feed(A::dim(share, dimming));
            sum.feed(A::dim(share, narrow));
            sum.feed(A::dim(share, A::narrow(narrow, r)));
        }
    }
    sum.value()
}

/// A sphere from which the eye is `eye` radii away.
fn ball<A: Viewed>(eye: [f64; 3], radius: f64) -> Sphere<A> {
    Sphere {
        eye: eye.map(A::length),
        radius: A::length(radius),
        material: 0,
        extent: Extent::EVERYWHERE,
    }
}

fn shadows<A: Viewed>() -> u64 {
    let mut numbers = Numbers(Words::new(0x5AD0));
    let mut sum = Checksum::new();
    let mut fed = 0;
    while fed < COUNT {
        let toward = numbers.unit();
        let near = numbers.any(120.0).abs();
        let depth = A::stored_depth(A::length(near), A::length(0.0), 0);
        let place = A::place(&middle::<A>(toward), depth);
        let from = toward.map(|c| c * near);
        // A sphere on the way, or nearly so, and a lamp before, in or beyond it.
        let l = numbers.unit();
        let along = numbers.any(3_000.0);
        let radius = numbers.any(127.9).abs();
        let aside = numbers.unit().map(|c| c * 1.2 * radius);
        let centre = [0, 1, 2].map(|i| from[i] + along * l[i] + aside[i]);
        let eye = centre.map(|c| -c / radius);
        let past = along + numbers.signed() * 2.0 * radius;
        let lamp = [0, 1, 2].map(|i| from[i] + past * l[i]);
        if eye.iter().any(|c| c.abs() >= 127.9) || past < 0.0 {
            continue;
        }
        let sphere = ball::<A>(eye, radius);
        let l = direction::<A>(l);
        let mut bits = u32::from(A::hides(&sphere, &place, &l, None));
        if lamp.iter().all(|c| c.abs() < 127.9) {
            let lamp = lamp.map(A::length);
            bits |= u32::from(A::hides(&sphere, &place, &l, Some(&lamp))) << 1;
        }
        sum.feed(bits);
        fed += 1;
    }
    sum.value()
}

/// Places that may be more than 256 units from the lamp, with a sphere on the
/// way, nearly so, or far from it.
fn far_shadows<A: Viewed>() -> u64 {
    let mut numbers = Numbers(Words::new(0xFA_25AD));
    let mut sum = Checksum::new();
    let mut fed = 0;
    while fed < COUNT {
        let toward = numbers.unit();
        let half = 60.0 + 60.0 * numbers.signed().abs();
        let depth = A::stored_depth(A::length(half), A::length(half), u16::MAX);
        let place = A::place(&middle::<A>(toward), depth);
        let from = toward.map(|c| c * 2.0 * half);
        let lamp = numbers.three(|n| 127.9 * n.signed());
        let way = [0, 1, 2].map(|i| lamp[i] - from[i]);
        let distance = way.iter().map(|c| c * c).sum::<f64>().sqrt();
        let l = way.map(|c| c / distance);
        let radius = 1.0 + 100.0 * numbers.signed().abs();
        let along = distance * 1.2 * numbers.signed().abs();
        // Every other one further from the way: squares of 64 bits may overflow.
        let most = if fed % 2 == 0 {
            1.2
        } else {
            6.0 * numbers.signed().abs()
        };
        let aside = numbers.unit().map(|c| c * most * radius);
        let eye = [0, 1, 2].map(|i| (from[i] + along * l[i] + aside[i]) / -radius);
        if eye.iter().any(|c| c.abs() >= 127.9) {
            continue;
        }
        let sphere = ball::<A>(eye, radius);
        let lamp = lamp.map(A::length);
        let hidden = A::hides(&sphere, &place, &direction::<A>(l), Some(&lamp));
        sum.feed(u32::from(hidden));
        fed += 1;
    }
    sum.value()
}
