//! Greatest errors of the scalar steps, over every 16-bit input.

use microbrdf::Rgb;
use microbrdf::brdf::{Brdf as _, MetallicPhong, Mirror, PModel};
use microbrdf::geometry::{Direction, ShadingFrame};

use crate::arithmetic::Tested;

/// A step whose input is one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// (1 − x)ⁿ for n from 5 to 1e8, where it is at least 2⁻¹²: relative error.
    Lobe,
    /// The same, where it is less: absolute error.
    LobeTail,
    /// (1 − x)ⁿ for n = 0 and from 1 to 5: absolute error.
    BroadLobe,
    /// e^(−s·m) for s from 0 to 4096, where it is at least 2⁻¹²: relative
    /// error.
    Profile,
    /// The same, where it is less: absolute error.
    ProfileTail,
    /// c^(1−p) for p from 1/65 to 64/65, where it is at least 2⁻¹²: relative
    /// error.
    CosinePower,
    /// cosΘL / max(cosΘL, cosΘV): absolute error.
    Ratio,
    /// a·b of shares: absolute error.
    Product,
    /// K·ρ for K from 1e-3 to 2e7, where it is at most 1: absolute error.
    Exposure,
}

impl Step {
    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::Lobe,
        Self::LobeTail,
        Self::BroadLobe,
        Self::Profile,
        Self::ProfileTail,
        Self::CosinePower,
        Self::Ratio,
        Self::Product,
        Self::Exposure,
    ];

    /// What is computed and how its error is given, for documents.
    pub fn name(self) -> &'static str {
        match self {
            Self::Lobe => "(1 − x)ⁿ ≥ 2⁻¹², n from 5 to 1e8: relative",
            Self::LobeTail => "(1 − x)ⁿ < 2⁻¹², n from 5 to 1e8: absolute",
            Self::BroadLobe => "(1 − x)ⁿ, n = 0 and from 1 to 5: absolute",
            Self::Profile => "e^(−s·m) ≥ 2⁻¹², s from 0 to 4096: relative",
            Self::ProfileTail => "e^(−s·m) < 2⁻¹², s from 0 to 4096: absolute",
            Self::CosinePower => "c^(1−p) ≥ 2⁻¹², p from 1/65 to 64/65: relative",
            Self::Ratio => "cosΘL / max(cosΘL, cosΘV): absolute",
            Self::Product => "a·b of shares: absolute",
            Self::Exposure => "K·ρ ≤ 1, K from 1e-3 to 2e7: absolute",
        }
    }

    /// The greatest error in an arithmetic: every input of 16 bits, each with
    /// 64 exponents, sharpnesses, powers, cosines, shares or gains.
    pub fn greatest<A: Tested>(self) -> f64 {
        let each = |parameter: &dyn Fn(f64) -> f64, worst: &dyn Fn(f64) -> f64| {
            (0..PARAMETERS)
                .map(|i| worst(parameter(f64::from(i) / f64::from(PARAMETERS - 1))))
                .fold(0.0, f64::max)
        };
        let narrow = |t: f64| 5.0 * 2e7f64.powf(t);
        let sharpness = |t: f64| {
            if t == 0.0 {
                0.0
            } else {
                4096f64.powf(2.0 * t - 1.0)
            }
        };
        match self {
            Self::Lobe => each(&narrow, &|n| lobe::<A>(n).relative),
            Self::LobeTail => each(&narrow, &|n| lobe::<A>(n).tail),
            Self::BroadLobe => {
                let broad = each(&|t| 5f64.powf(t), &|n| lobe::<A>(n).absolute);
                lobe::<A>(0.0).absolute.max(broad)
            }
            Self::Profile => each(&sharpness, &|s| profile::<A>(s).relative),
            Self::ProfileTail => each(&sharpness, &|s| profile::<A>(s).tail),
            Self::CosinePower => each(&|t| (1.0 + 63.0 * t) / 65.0, &|p| {
                cosine_power::<A>(p).relative
            }),
            Self::Ratio => each(&|t| 10f64.powf(-4.0 * t), &ratio::<A>),
            Self::Product => each(&|t| 1.0 - 0.99 * t, &product::<A>),
            Self::Exposure => each(&|t| 1e-3 * 2e10f64.powf(t), &exposure::<A>),
        }
    }
}

/// How many values the parameter of each step takes.
pub const PARAMETERS: u32 = 64;

/// A documented bound.
#[derive(Clone, Copy, Debug)]
pub struct StepBound {
    /// Arithmetic.
    pub arithmetic: &'static str,
    /// Step.
    pub step: Step,
    /// Greatest error.
    pub error: f64,
}

const fn bound(arithmetic: &'static str, step: Step, error: f64) -> StepBound {
    StepBound {
        arithmetic,
        step,
        error,
    }
}

/// Every bound; `tests/tests/exhaustive.rs` fails when one is passed, and when
/// it lies more than a tenth above what is found.
pub const BOUNDS: &[StepBound] = &[
    bound("f32", Step::Lobe, 1.6e-6),
    bound("f32", Step::LobeTail, 3.2e-10),
    bound("f32", Step::BroadLobe, 8.3e-8),
    bound("f32", Step::Profile, 5.3e-7),
    bound("f32", Step::ProfileTail, 1.3e-10),
    bound("f32", Step::CosinePower, 7.0e-8),
    bound("f32", Step::Ratio, 3.0e-8),
    bound("f32", Step::Product, 3.0e-8),
    bound("f32", Step::Exposure, 1.4e-7),
    bound("micromath", Step::Lobe, 9.5e-3),
    bound("micromath", Step::LobeTail, 2.4e-6),
    bound("micromath", Step::BroadLobe, 1.3e-3),
    bound("micromath", Step::Profile, 2.5e-3),
    bound("micromath", Step::ProfileTail, 3.0e-7),
    bound("micromath", Step::CosinePower, 2.5e-3),
    bound("micromath", Step::Ratio, 3.0e-8),
    bound("micromath", Step::Product, 3.0e-8),
    bound("micromath", Step::Exposure, 1.4e-7),
    bound("q31", Step::Lobe, 1.7e-4),
    bound("q31", Step::LobeTail, 2.7e-8),
    bound("q31", Step::BroadLobe, 1.4e-5),
    bound("q31", Step::Profile, 1.8e-4),
    bound("q31", Step::ProfileTail, 2.7e-8),
    bound("q31", Step::CosinePower, 7.6e-6),
    bound("q31", Step::Ratio, 4.7e-10),
    bound("q31", Step::Product, 2.4e-10),
    bound("q31", Step::Exposure, 6.0e-8),
    bound("q15", Step::Lobe, 3.0e-3),
    bound("q15", Step::LobeTail, 6.4e-7),
    bound("q15", Step::BroadLobe, 2.6e-4),
    bound("q15", Step::Profile, 2.7e-3),
    bound("q15", Step::ProfileTail, 5.2e-7),
    bound("q15", Step::CosinePower, 4.8e-2),
    bound("q15", Step::Ratio, 1.4e-4),
    bound("q15", Step::Product, 1.5e-5),
    bound("q15", Step::Exposure, 1.6e-2),
];

/// Every number of 16 bits, as a fraction.
fn inputs() -> impl Iterator<Item = f64> {
    (0..=u16::MAX).map(|i| f64::from(i) / 65_536.0)
}

/// What is not told apart from black: 12.92 · 255 · 2⁻¹² is 0.8 of a code.
const DARK: f64 = 1.0 / 4096.0;

/// Greatest errors of a curve.
#[derive(Default)]
struct Errors {
    absolute: f64,
    /// Of its value, where that is not dark.
    relative: f64,
    /// Absolute, where it is.
    tail: f64,
}

impl Errors {
    fn add(&mut self, found: f64, exact: f64) {
        let error = (found - exact).abs();
        self.absolute = self.absolute.max(error);
        if exact >= DARK {
            self.relative = self.relative.max(error / exact);
        } else {
            self.tail = self.tail.max(error);
        }
    }
}

/// The share at L = N and V beside it at the same height, `distance` away, and
/// the distance as it is held: x = distance²/2 and m = distance, and nothing
/// else enters the share.
fn beside<A: Tested>(
    distance: f64,
    share: impl Fn(&ShadingFrame<A>) -> Rgb<A::Unit>,
) -> (f64, f64) {
    let (zero, one) = (A::component(0.0), A::component(1.0));
    let held = A::component(distance);
    let geometry = ShadingFrame::new(
        Direction::new(zero, zero, one),
        Direction::new(held, zero, one),
    );
    (A::component_value(held), A::unit_value(share(&geometry).r))
}

/// Greatest error of (1 − x)ⁿ, absolute and relative; the inputs are spread
/// over the lobe as their squares.
fn lobe<A: Tested>(n: f64) -> Errors {
    let n = A::exponent_value(n);
    let model: MetallicPhong<A> =
        A::lobe::<Mirror, _>(n, microbrdf::brdf::Metallic).expect("an exponent in range");
    let reach = (2.0 * 22.5 / n.max(1e-9)).min(1.999).sqrt();
    let mut errors = Errors::default();
    for input in inputs() {
        let (distance, share) = beside::<A>(reach * input, |geometry| model.share(geometry));
        let x = 0.5 * distance * distance;
        if x < 1.0 {
            errors.add(share, (n * (-x).ln_1p()).exp());
        } else {
            assert_eq!(share, 0.0, "n = {n}, x = {x}");
        }
    }
    errors
}

fn profile<A: Tested>(s: f64) -> Errors {
    let s = A::exponent_value(s);
    let model = A::patch_exponential(s).expect("a sharpness in range");
    let reach = (22.5 / s.max(1e-9)).min(1.999);
    let mut errors = Errors::default();
    for input in inputs() {
        let (m, share) = beside::<A>(reach * input, |geometry| model.share(geometry));
        errors.add(share, (-s * m).exp());
    }
    errors
}

fn cosine_power<A: Tested>(p: f64) -> Errors {
    // A p that every arithmetic holds.
    let p = (p * 65_536.0).round() / 65_536.0;
    let power = A::power_model(p).expect("a p in range");
    let model: PModel<A> = A::lobe::<Mirror, _>(20.0, power).expect("an exponent in range");
    let mut errors = Errors::default();
    for input in inputs() {
        let (zero, cosine) = (A::component(0.0), A::component(input));
        if cosine != zero {
            let up = Direction::new(zero, zero, cosine);
            let share = A::unit_value(model.share(&ShadingFrame::new(up, up)).r);
            errors.add(share, A::component_value(cosine).powf(1.0 - p));
        }
    }
    errors
}

fn ratio<A: Tested>(other: f64) -> f64 {
    let other = A::component(other);
    inputs()
        .map(|input| {
            let cosine = A::component(input);
            let [l, v] = [cosine, other].map(A::component_value);
            let exact = if l == 0.0 { 0.0 } else { l / l.max(v) };
            let ratio = A::ratio(A::upright(cosine), A::upright(other));
            let found = ratio.map_or(A::ONE, |ratio| A::attenuate(A::ONE, ratio));
            (A::unit_value(found) - exact).abs()
        })
        .fold(0.0, f64::max)
}

fn product<A: Tested>(other: f64) -> f64 {
    let other = A::unit(other);
    inputs()
        .map(|input| {
            let share = A::unit(input);
            let exact = A::unit_value(share) * A::unit_value(other);
            (A::unit_value(A::product(share, other)) - exact).abs()
        })
        .fold(0.0, f64::max)
}

fn exposure<A: Tested>(k: f64) -> f64 {
    let gain = A::gain(k);
    inputs()
        .map(|input| {
            // Spread over what is neither black nor white.
            let share = A::unit(input / k.max(1.0));
            let exact = k * A::unit_value(share);
            let light = A::linear(Rgb::grey(A::expose(gain, share))).to_raw()[0];
            if exact > 1.0 {
                0.0
            } else {
                (f64::from(light) / f64::from(1 << 24) - exact).abs()
            }
        })
        .fold(0.0, f64::max)
}
