//! The world-space call and the shading-frame call agree, for random
//! rotations, within bounds that are derived here.
//!
//! Let u be the greatest error of a rounded component. Then R − V, a vector
//! of which every model takes the length, is off
//!
//! * in the shading frame by √3·u from each of L and V: 3.5 u;
//! * in world space by √3·u from each of L and V and 4√3·u from N, for
//!   |2h|² + |L − V|² ≤ 16 with h = L + V: 10.4 u; and by the rounding of the
//!   steps. In `q31` each cosine is off by u, which the product with N and
//!   the rounding of that product make 3.7 u along the plane and 2 u in
//!   height: 15 u in all. In `f32` a step is worth 2 u of its result, a cosine
//!   thus 6 u, h − (N·h)N 28 u and the height 16 u: 43 u in all.
//!
//! A cosine is off by u in the shading frame; in world space by 3.5 u of the
//! vectors and its own rounding: 4.5 u in `q31`, 9.5 u in `f32`. Every share
//! is monotone in |R − V| and in each cosine, so that intervals follow.

use microbrdf::brdf::Brdf;
use microbrdf::geometry::{ShadingFrame, World};
use microbrdf_reference::geometry::power_lobe;
use microbrdf_scene::{AnyModel, Material};
use microbrdf_tests::arithmetic::{Tested, rounded};
use microbrdf_tests::domain::{Pair, Set};
use microbrdf_tests::frame::Rotations;
use microbrdf_tests::in_every_arithmetic;

in_every_arithmetic!(
    both_calls_stay_within_what_rounding_explains,
    the_error_of_a_lobe_grows_with_the_root_of_its_exponent,
);

/// How far the geometry of a call may be off.
#[derive(Clone, Copy)]
struct Room {
    /// |R − V|.
    distance: f64,
    /// Each cosine.
    cosine: f64,
    /// A squared distance, relative, by its own steps.
    square: f64,
}

impl Room {
    fn frame<A: Tested>() -> Self {
        let u = A::COMPONENT_ERROR;
        Self {
            distance: 3.5 * u,
            cosine: u,
            square: Self::square::<A>(),
        }
    }

    fn world<A: Tested>() -> Self {
        let u = A::COMPONENT_ERROR;
        // A fixed-point sum of products is rounded once.
        let fixed = A::NAME.starts_with('q');
        Self {
            distance: if fixed { 15.0 * u } else { 43.0 * u },
            cosine: if fixed { 4.5 * u } else { 9.5 * u },
            square: Self::square::<A>(),
        }
    }

    /// Four squares, three sums, a half: each worth a step of the result.
    fn square<A: Tested>() -> f64 {
        8.0 * A::UNIT_STEP
    }

    /// The least and the greatest squared distance.
    fn squares(self, exact: f64) -> [f64; 2] {
        let distance = exact.sqrt();
        let low = (distance - self.distance).max(0.0).powi(2) * (1.0 - self.square);
        let high = (distance + self.distance).powi(2) * (1.0 + self.square);
        [low, high]
    }
}

/// A model and its share as a function of a squared distance and the cosines.
enum Shape {
    Lobe { n: f64, retro: bool },
    Patch { radius: f64 },
    Exponential { s: f64 },
}

impl Shape {
    fn toml(&self) -> String {
        match self {
            Self::Lobe { n, retro: false } => format!("model = \"metallic-phong\", exponent = {n}"),
            Self::Lobe { n, retro: true } => format!("model = \"retro-phong\", exponent = {n}"),
            Self::Patch { radius } => format!("model = \"patch\", radius = {radius}"),
            Self::Exponential { s } => format!("model = \"patch-exponential\", sharpness = {s}"),
        }
    }

    /// Exponent of a lobe that is about as wide.
    fn width(&self) -> f64 {
        match self {
            Self::Lobe { n, .. } => *n,
            Self::Patch { radius } => 1.0 / (radius * radius),
            Self::Exponential { s } => s * s / 8.0,
        }
    }

    fn square(&self, [l, v]: Pair) -> f64 {
        let squares = |d: [f64; 3]| d.iter().map(|c| c * c).sum();
        match self {
            Self::Lobe { retro: false, .. } => squares([l[0] + v[0], l[1] + v[1], l[2] - v[2]]),
            Self::Lobe { retro: true, .. } => squares([l[0] - v[0], l[1] - v[1], l[2] - v[2]]),
            _ => squares([l[0] + v[0], l[1] + v[1], 0.0]),
        }
    }

    /// The shape at a squared distance, and the relative error with which it
    /// is stored.
    fn at(&self, square: f64) -> f64 {
        match self {
            Self::Lobe { n, .. } => power_lobe(*n, 0.5 * square),
            Self::Patch { radius } => f64::from(u8::from(square <= radius * radius)),
            Self::Exponential { s } => (-s * square.sqrt()).exp(),
        }
    }

    fn ratios(&self, [l, v]: Pair, room: Room) -> [f64; 2] {
        let c = room.cosine;
        let below = l[2] < c || v[2] < c;
        match self {
            Self::Lobe { .. } => {
                let high = if v[2] > c {
                    ((l[2] + c) / (v[2] - c)).clamp(0.0, 1.0)
                } else {
                    1.0
                };
                let low = ((l[2] - c) / (v[2] + c)).min(1.0);
                [
                    if below { 0.0 } else { low },
                    if l[2] < -c { 0.0 } else { high },
                ]
            }
            _ => [if below { 0.0 } else { l[2] - c }, (l[2] + c).max(0.0)],
        }
    }

    /// What the share may be.
    fn interval<A: Tested>(&self, pair: Pair, room: Room) -> [f64; 2] {
        if pair[0][2] < -room.cosine || pair[1][2] < -room.cosine {
            return [0.0, 0.0];
        }
        let [near, far] = room.squares(self.square(pair));
        let [low, high] = self.ratios(pair, room);
        let stored = match self {
            Self::Patch { .. } => 0.0,
            _ => A::LOBE_ERROR,
        };
        let step = 4.0 * A::UNIT_STEP + A::LOBE_FLOOR + 4.0 * A::RATIO_FLOOR;
        [
            self.at(far) * low * (1.0 - stored) - step,
            self.at(near) * high * (1.0 + stored) + step,
        ]
    }
}

fn share<A: Tested>(model: &AnyModel<A>, geometry: &impl microbrdf::geometry::Geometry<A>) -> f64 {
    A::unit_value(model.share(geometry).r)
}

fn both_calls_stay_within_what_rounding_explains<A: Tested>() {
    let mut shapes = Vec::new();
    for n in [0.0, 1.0, 20.0, 500.0, 5e3, 1e5, 1e8] {
        shapes.push(Shape::Lobe { n, retro: false });
        shapes.push(Shape::Lobe { n, retro: true });
    }
    shapes.extend([0.01, 0.3, 1.0, 1.5].map(|radius| Shape::Patch { radius }));
    shapes.extend([0.0, 4.0, 128.0, 4096.0].map(|s| Shape::Exponential { s }));
    let mut rotations = Rotations::new(3);
    let (mut lit, mut apart) = (0, 0);
    for shape in shapes {
        let model: AnyModel<A> = Material::from_argument(&shape.toml())
            .expect("a material")
            .model()
            .expect("a material that the arithmetic takes");
        for set in Set::ALL {
            for [l, v] in set.pairs(shape.width(), 12.0, 600) {
                let retro = matches!(shape, Shape::Lobe { retro: true, .. });
                let v = if retro { [-v[0], -v[1], v[2]] } else { v };
                let pair = [l, v];
                let framed = share(&model, &ShadingFrame::new(rounded::<A>(l), rounded::<A>(v)));
                let [n, l, v] = rotations.turn(pair).map(rounded::<A>);
                let world = share(&model, &World::new(n, l, v));
                for (found, room) in [(framed, Room::frame::<A>()), (world, Room::world::<A>())] {
                    let [low, high] = shape.interval::<A>(pair, room);
                    assert!(
                        (low..=high).contains(&found),
                        "{}, {set:?}: {found} outside {low} … {high} for {pair:?}",
                        shape.toml()
                    );
                }
                lit += u32::from(framed > 0.0);
                apart += u32::from(framed != world);
            }
        }
    }
    // The bounds were put to use.
    assert!(lit > 20_000 && apart > 5_000, "{lit} lit, {apart} apart");
}

/// At τ = 1 the relative error is about √(2n) times that of |R − V|, of which
/// the worst of many samples is below 7 u; n times it, as of an R·V, would be four
/// orders above.
fn the_error_of_a_lobe_grows_with_the_root_of_its_exponent<A: Tested>() {
    let mut rotations = Rotations::new(4);
    for n in [1.0f64, 20.0, 500.0, 5e3, 1e5, 1e8] {
        let toml = format!("model = \"metallic-phong\", exponent = {n}");
        let model: AnyModel<A> = Material::from_argument(&toml)
            .expect("a material")
            .model()
            .expect("a material that the arithmetic takes");
        let tau: f64 = if n == 1.0 { 0.1 } else { 1.0 };
        let exact = power_lobe(n, tau / n);
        let mut worst = 0.0f64;
        for step in 0..4000 {
            // 40°, V anywhere on the cone of τ about R; the higher is lit.
            let l = microbrdf_tests::domain::direction(0.766, 0.0);
            let r = [-l[0], -l[1], l[2]];
            let v = microbrdf_tests::domain::turned(r, tau / n, 0.0015 * f64::from(step));
            let pair = if v[2] > l[2] { [v, l] } else { [l, v] };
            let [normal, l, v] = rotations.turn(pair).map(rounded::<A>);
            let found = share(&model, &World::new(normal, l, v));
            worst = worst.max((found / exact - 1.0).abs());
        }
        let u = A::COMPONENT_ERROR;
        let law = (2.0 * n * tau).sqrt() * 7.0 * u + 12.0 * u;
        println!("{}, n = {n}: {worst:.1e}, law {law:.1e}", A::NAME);
        let stored = if A::NAME == "f32" { 0.0 } else { A::LOBE_ERROR };
        assert!(worst <= law + stored, "n = {n}: {worst:e}, law {law:e}");
        assert!(
            n < 100.0 || worst >= 0.3 * law,
            "n = {n}: {worst:e}, law {law:e}"
        );
    }
}
