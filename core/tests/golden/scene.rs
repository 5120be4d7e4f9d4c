//! Small pictures: rays, shapes, materials, daylight, every encoding.

use microbrdf::Rgb;
use microbrdf::brdf::{Metallic, Mirror};
use microbrdf::geometry::Direction;
use microbrdf::shade::{
    AlbedoDaylight, Camera, Checker, Coat, Extent, FourSamples, Ground, Light, Linear, NoDaylight,
    NoView, OneSample, Plane, PointLight, Samples, Scene, Shadowed, Shadows, Sphere, Spot, Surface,
    Unshadowed, View, grey16,
};
use microbrdf_bits::Checksum;

use crate::Sums;
use crate::given::{self, Viewed, direction};

/// Adds a sum for each picture.
pub fn add<A: Viewed>(sums: &mut Sums) {
    let planes = planes::<A>();
    let lights = directions::<A>();
    let above = camera::<A>([0.0, 0.6, -0.8], 37, 23, 0.02);
    let level = camera::<A>([0.0, 1.0, 0.0], 18, 30, 0.06);
    let upwards = camera::<A>([0.28, -0.0, 0.96], 9, 8, 0.1);
    let plain = |camera| picture(camera, &planes, &lights, Unshadowed, OneSample);
    sums.push("scene, from above", plain(above));
    sums.push("scene, level", plain(level));
    sums.push("scene, upwards", plain(upwards));

    let part = Extent {
        columns: [11, 30],
        rows: [4, 15],
    };
    sums.push(
        "scene, spheres in a part",
        within(part, NoView, above, &planes, &lights, Unshadowed, OneSample),
    );
    sums.push(
        "scene, nothing but spheres in a part",
        within(
            part,
            NoView,
            above,
            &planes[..0],
            &lights,
            Unshadowed,
            OneSample,
        ),
    );

    let checkers = planes.map(checker);
    let high = Camera {
        width: 36,
        height: 24,
        ..above
    };
    sums.push(
        "scene, checkers in shadow, four samples",
        picture(high, &checkers, &lights, Shadowed, FourSamples),
    );
    let lamps = lamps::<A>();
    sums.push(
        "scene, points in shadow",
        picture(level, &checkers, &lamps, Shadowed, OneSample),
    );
    sums.push(
        "scene, points",
        picture(above, &planes, &lamps, Unshadowed, FourSamples),
    );
    let down = direction::<A>([0, 0, 1 << 30]);
    let floods = lamps.map(|lamp| A::flood(lamp, down, 5).expect("n"));
    sums.push(
        "scene, floods in shadow",
        picture(above, &checkers, &floods, Shadowed, OneSample),
    );
    // By reference, as a baked scene has it; a sphere stands behind it, and
    // throws no shadow forwards.
    let low = PointLight::<A> {
        position: [0.2, 2.6, -1.2].map(A::length),
        near: A::length(0.25),
    };
    let low = A::flood(low, direction::<A>([0, 1 << 30, 0]), 2).expect("n");
    sums.push(
        "scene, a flood before a sphere in shadow",
        picture(above, &checkers, &[&low], Shadowed, OneSample),
    );
    sums.push(
        "scene, floods",
        picture(level, &checkers, &floods, Unshadowed, OneSample),
    );
}

/// A camera towards `forward`, with steps of `step` for half a pixel.
pub fn camera<A: Viewed>(forward: [f64; 3], width: u16, height: u16, step: f64) -> Camera<A> {
    let [fx, fy, fz] = forward;
    let number = |numbers: [f64; 3]| numbers.map(A::fine);
    // Right is level, up is right × forward.
    let long = f64::hypot(fx, fy);
    let right = [fy / long, -fx / long, 0.0];
    let up = [
        right[1] * fz - right[2] * fy,
        right[2] * fx - right[0] * fz,
        right[0] * fy - right[1] * fx,
    ];
    Camera::<A> {
        width,
        height,
        forward: number(forward),
        right: number(right.map(|c| c * step)),
        up: number(up.map(|c| c * step)),
    }
}

/// A floor and a wall.
pub fn planes<A: Viewed>() -> [Plane<A>; 2] {
    let unit = |bits: [i32; 3]| direction::<A>(bits);
    [
        Plane {
            normal: unit([0, 0, 1 << 30]),
            height: A::length(1.5),
            material: 2,
        },
        // (−3, −4, 0)/5: a wall.
        Plane {
            normal: unit([-644_245_094, -858_993_459, 0]),
            height: A::length(7.25),
            material: 1,
        },
    ]
}

/// Squares of 0.8, those of an odd sum of material 0.
fn checker<A: Viewed>(plane: Plane<A>) -> Checker<A> {
    let axes = if plane.material == 2 {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
    } else {
        [[0.8, -0.6, 0.0], [0.0, 0.0, 1.0]]
    };
    Checker {
        plane,
        odd: 0,
        eye: [0.3, 1.7].map(A::fine),
        across: axes.map(|axis| axis.map(|c: f64| A::fine(c / 0.8))),
    }
}

/// Two lamps.
pub fn lamps<A: Viewed>() -> [PointLight<A>; 2] {
    [[1.5, 2.0, 1.0], [-2.0, 3.0, 2.5]].map(|position: [f64; 3]| PointLight {
        position: position.map(A::length),
        near: A::length(0.75),
    })
}

/// (2, 1, 2)/3, (−6, −3, 2)/7, and straight down.
pub fn directions<A: Viewed>() -> [Direction<A>; 3] {
    [
        direction::<A>([715_827_882, 357_913_941, 715_827_882]),
        direction::<A>([-920_350_135, -460_175_067, 306_783_378]),
        direction::<A>([0, 0, -(1 << 30)]),
    ]
}

/// A picture of spheres and these planes under these lights.
fn picture<A: Viewed>(
    camera: Camera<A>,
    planes: &[impl Ground<A>],
    lights: &[impl Light<A>],
    shadows: impl Shadows,
    samples: impl Samples,
) -> u64 {
    behind(NoView, camera, planes, lights, shadows, samples)
}

/// The same behind a view.
pub fn behind<A: Viewed>(
    view: impl View<A>,
    camera: Camera<A>,
    planes: &[impl Ground<A>],
    lights: &[impl Light<A>],
    shadows: impl Shadows,
    samples: impl Samples,
) -> u64 {
    let extent = Extent::EVERYWHERE;
    within(extent, view, camera, planes, lights, shadows, samples)
}

/// The same, with spheres looked for in a part of it alone.
fn within<A: Viewed>(
    extent: Extent,
    view: impl View<A>,
    camera: Camera<A>,
    planes: &[impl Ground<A>],
    lights: &[impl Light<A>],
    shadows: impl Shadows,
    samples: impl Samples,
) -> u64 {
    let sphere = |centre: [f64; 3], radius: f64, material| Sphere::<A> {
        eye: centre.map(|c| A::length(-c / radius)),
        radius: A::length(radius),
        material,
        extent,
    };
    let spheres = [
        sphere([0.0, 4.0, -1.0], 1.0, 0),
        sphere([1.0, 3.0, -0.5], 0.5, 1),
        sphere([-1.5, 6.0, -2.5], 2.0, 2),
        // Behind the eye.
        sphere([0.0, -4.0, 0.0], 1.5, 1),
        // Nearly a hundred radii away.
        sphere([0.5, 11.0, 0.6], 0.12, 0),
        // No such material.
        sphere([-2.0, 3.5, 0.3], 0.4, 9),
    ];
    let gains = [
        [30_000, 60_000, 90_000],
        [4 << 16, 1 << 15, 1 << 10],
        [1 << 16, 1 << 16, 1 << 16],
    ]
    .map(|gain: [u64; 3]| Rgb::from_array(gain.map(A::gain)));
    let lobe = |n| A::lobe::<Mirror, _>(n, Metallic).expect("n");
    let shiny = Coat {
        model: lobe(30 << 16),
        gains: &gains,
        daylight: AlbedoDaylight {
            albedo: given::curve(),
            gain: Rgb::from_array([1 << 14, 1 << 13, 1 << 12].map(A::gain)),
        },
    };
    let dull = Coat {
        model: lobe(1 << 16),
        // A light without a gain does not count.
        gains: &gains[..2],
        daylight: NoDaylight,
    };
    let materials = [
        Worn::First(shiny),
        Worn::Second(dull),
        Worn::Both((shiny, dull)),
    ];
    let scene = Scene {
        camera,
        view,
        spheres: &spheres,
        planes,
        lights,
        materials: &materials,
        background: Linear::from_raw(1 << 20, 1 << 21, 1 << 22),
        shadows,
        samples,
    };
    let mut sum = Checksum::new();
    for y in 0..usize::from(camera.height / samples.side()) {
        scene.shade_row(y, |x, pixel| {
            sum.feed(x as u32);
            for component in pixel.to_raw() {
                sum.feed(component);
            }
            sum.feed(u32::from(pixel.rgb565()));
            sum.feed(u32::from(grey16(pixel.luminance(), x, y)));
        });
    }
    sum.value()
}

/// One coat, another, or both.
enum Worn<S, T> {
    First(S),
    Second(T),
    Both((S, T)),
}

impl<A: Viewed, S: Surface<A>, T: Surface<A>> Surface<A> for Worn<S, T> {
    fn light(
        &self,
        n: &Direction<A>,
        v: &Direction<A>,
        lights: &[impl Light<A>],
        spot: impl Spot<A>,
    ) -> Rgb<A::Light> {
        match self {
            Self::First(coat) => coat.light(n, v, lights, spot),
            Self::Second(coat) => coat.light(n, v, lights, spot),
            Self::Both(coats) => coats.light(n, v, lights, spot),
        }
    }
}
