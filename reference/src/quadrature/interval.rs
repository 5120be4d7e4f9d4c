//! Adaptive Gauss–Kronrod quadrature (10 and 21 points) over an interval with breaks.

use super::{Estimate, Estimates};

/// Positive nodes of the 21-point Kronrod rule (QUADPACK's dqk21), greatest first.
const NODES: [f64; 11] = [
    0.995_657_163_025_808_1,
    0.973_906_528_517_171_7,
    0.930_157_491_355_708_2,
    0.865_063_366_688_984_5,
    0.780_817_726_586_416_9,
    0.679_409_568_299_024_4,
    0.562_757_134_668_604_7,
    0.433_395_394_129_247_2,
    0.294_392_862_701_460_2,
    0.148_874_338_981_631_22,
    0.0,
];
const KRONROD: [f64; 11] = [
    0.011_694_638_867_371_874,
    0.032_558_162_307_964_725,
    0.054_755_896_574_351_995,
    0.075_039_674_810_919_96,
    0.093_125_454_583_697_6,
    0.109_387_158_802_297_64,
    0.123_491_976_262_065_85,
    0.134_709_217_311_473_34,
    0.142_775_938_577_060_09,
    0.147_739_104_901_338_49,
    0.149_445_554_002_916_9,
];
/// Weights of the 10-point Gauss rule, at the odd entries of `NODES`.
const GAUSS: [f64; 5] = [
    0.066_671_344_308_688_14,
    0.149_451_349_150_580_6,
    0.219_086_362_515_982_04,
    0.269_266_719_309_996_35,
    0.295_524_224_714_752_87,
];

#[derive(Clone, Copy)]
struct Panel<const N: usize> {
    /// The break interval that this panel is a part of.
    base: (f64, f64),
    /// The part of it, in the smoothed variable w of 0 … 1.
    low: f64,
    high: f64,
    values: [f64; N],
    /// Error of the rule, and error inherited from the integrand.
    rule: f64,
    inherited: f64,
}

impl<const N: usize> Panel<N> {
    /// The greatest size of its values.
    fn size(&self) -> f64 {
        self.values.iter().fold(0.0, |most, v| v.abs().max(most))
    }
}

/// The integral of `f` over the intervals between consecutive `breaks` (ascending).
///
/// `f` returns a value and its own error. Within each interval the substitution
/// s = a + (b − a)(3w² − 2w³) removes square-root behaviour at the ends. Panels are
/// halved, worst first, until the estimated error is below `tolerance` or rounding
/// is reached or there are `max_panels`; the returned error says how far it came.
pub fn adaptive(
    f: &mut dyn FnMut(f64) -> Estimate,
    breaks: &[f64],
    tolerance: f64,
    max_panels: usize,
) -> Estimate {
    adaptive_all::<1>(&mut |x| f(x).into(), breaks, tolerance, max_panels).into()
}

/// [`adaptive`] for several integrals over the same panels; the worst of them decides.
pub(super) fn adaptive_all<const N: usize>(
    f: &mut dyn FnMut(f64) -> Estimates<N>,
    breaks: &[f64],
    tolerance: f64,
    max_panels: usize,
) -> Estimates<N> {
    let mut panels: Vec<Panel<N>> = breaks
        .windows(2)
        .filter(|w| w[1] > w[0])
        .map(|w| rule(f, (w[0], w[1]), 0.0, 1.0))
        .collect();
    let most = max_panels + panels.len();
    loop {
        let total: f64 = panels.iter().map(|p| p.rule).sum();
        if total <= tolerance || panels.len() >= most {
            break;
        }
        let Some((i, worst)) = panels
            .iter()
            .copied()
            .enumerate()
            .filter(|(_, p)| p.high - p.low > 1e-12)
            .max_by(|a, b| a.1.rule.total_cmp(&b.1.rule))
        else {
            break;
        };
        // Rounding: halving the panel would not make it better.
        if worst.rule <= 2e-15 * worst.size() + 2.0 * worst.inherited {
            break;
        }
        let middle = 0.5 * (worst.low + worst.high);
        panels[i] = rule(f, worst.base, worst.low, middle);
        panels.push(rule(f, worst.base, middle, worst.high));
    }
    // Smallest first, for the least rounding.
    panels.sort_by(|a, b| a.size().total_cmp(&b.size()));
    panels.iter().fold(Estimates::ZERO, |sum, p| Estimates {
        values: std::array::from_fn(|k| sum.values[k] + p.values[k]),
        error: sum.error + p.rule + p.inherited + p.size() * f64::EPSILON,
    })
}

fn rule<const N: usize>(
    f: &mut dyn FnMut(f64) -> Estimates<N>,
    base: (f64, f64),
    low: f64,
    high: f64,
) -> Panel<N> {
    let (a, length) = (base.0, base.1 - base.0);
    let (centre, half) = (0.5 * (low + high), 0.5 * (high - low));
    let mut sample = |w: f64| {
        let s = a + length * (w * w * (3.0 - 2.0 * w));
        let slope = length * 6.0 * w * (1.0 - w) * half;
        f(s).scaled(slope)
    };
    let mut samples = [[0.0; N]; 21];
    let (mut kronrod, mut gauss, mut absolute) = ([0.0; N], [0.0; N], [0.0; N]);
    let mut inherited = 0.0;
    for (i, (&node, &weight)) in NODES.iter().zip(&KRONROD).enumerate() {
        let sides = if node == 0.0 { 1 } else { 2 };
        for side in 0..sides {
            let w = if side == 0 {
                centre + half * node
            } else {
                centre - half * node
            };
            let e = sample(w);
            samples[2 * i + side] = e.values;
            inherited += weight * e.error;
            for (k, value) in e.values.into_iter().enumerate() {
                kronrod[k] += weight * value;
                absolute[k] += weight * value.abs();
                if i % 2 == 1 {
                    gauss[k] += GAUSS[i / 2] * value;
                }
            }
        }
    }
    let error = |k: usize| {
        let mean = 0.5 * kronrod[k];
        let off = |sample: usize| (samples[sample][k] - mean).abs();
        let spread: f64 = (NODES.iter().zip(&KRONROD).enumerate())
            .map(|(i, (&node, &weight))| {
                let left = if node == 0.0 { 0.0 } else { off(2 * i + 1) };
                weight * (off(2 * i) + left)
            })
            .sum();
        // QUADPACK's reading of the difference of the two rules.
        let mut error = (kronrod[k] - gauss[k]).abs();
        if spread > 0.0 && error > 0.0 {
            error = spread * (200.0 * error / spread).powf(1.5).min(1.0);
        }
        error.max(absolute[k] * 1e-15)
    };
    Panel {
        base,
        low,
        high,
        values: kronrod,
        rule: (0..N).map(error).fold(0.0, f64::max),
        inherited,
    }
}

/// A root of `f` between `low` and `high`, where its signs differ (0 counts as positive).
///
/// Chandrupatla's method: inverse quadratic steps where they are safe, else bisection, so
/// that a jump is found as well as a root, to two units of rounding.
pub fn find_root(f: &mut dyn FnMut(f64) -> f64, low: f64, high: f64) -> f64 {
    let (at_high, at_low) = (f(high), f(low));
    root_between(f, (low, at_low), (high, at_high))
}

/// [`find_root`] where the values at both ends are known.
pub(super) fn root_between(
    f: &mut dyn FnMut(f64) -> f64,
    low: (f64, f64),
    high: (f64, f64),
) -> f64 {
    let ((mut a, mut fa), (mut b, mut fb)) = (high, low);
    let (mut c, mut fc);
    let mut t = 0.5;
    for _ in 0..200 {
        let x = a + t * (b - a);
        let fx = f(x);
        if (fx < 0.0) == (fa < 0.0) {
            (c, fc) = (a, fa);
        } else {
            (c, fc) = (b, fb);
            (b, fb) = (a, fa);
        }
        (a, fa) = (x, fx);
        let best = if fa.abs() < fb.abs() { a } else { b };
        let limit = (2.0 * f64::EPSILON * best.abs() + 1e-300) / (b - c).abs();
        if limit > 0.5 || fa == 0.0 {
            return best;
        }
        let xi = (a - b) / (c - b);
        let phi = (fa - fb) / (fc - fb);
        t = if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
            fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        } else {
            0.5
        };
        t = if t.is_finite() {
            t.clamp(limit, 1.0 - limit)
        } else {
            0.5
        };
    }
    0.5 * (a + b)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integrate(f: impl Fn(f64) -> f64, breaks: &[f64]) -> Estimate {
        adaptive(
            &mut |x| Estimate {
                value: f(x),
                error: 0.0,
            },
            breaks,
            1e-13,
            200,
        )
    }

    #[test]
    fn the_rule_is_exact_for_polynomials() {
        // Degree 9 in s is degree 29 in the smoothed variable: within the Kronrod rule's 31.
        let e = integrate(|x| 10.0 * x.powi(9), &[0.0, 1.0]);
        assert!((e.value - 1.0).abs() < 1e-15, "{e:?}");
    }

    #[test]
    fn ends_may_have_square_roots_and_steps_are_found() {
        let e = integrate(|x| x.sqrt() * (1.0 - x).sqrt(), &[0.0, 1.0]);
        assert!(
            (e.value - std::f64::consts::PI / 8.0).abs() < 1e-13,
            "{e:?}"
        );
        let e = integrate(|x| if x < 0.3 { 1.0 } else { 0.0 }, &[0.0, 1.0]);
        assert!((e.value - 0.3).abs() <= e.error + 1e-15, "{e:?}");
        let e = integrate(|x| if x < 0.3 { 1.0 } else { 0.0 }, &[0.0, 0.3, 1.0]);
        assert!((e.value - 0.3).abs() < 1e-15, "{e:?}");
    }

    #[test]
    fn roots_and_jumps_are_found_with_few_looks() {
        let mut looks = 0;
        let root = find_root(
            &mut |x| {
                looks += 1;
                x * x * x - 0.2
            },
            0.0,
            1.0,
        );
        assert!(
            (root - 0.2f64.cbrt()).abs() < 1e-15 && looks < 20,
            "{root}, {looks} looks"
        );
        let jump = find_root(&mut |x| if x < 0.3 { -1.0 } else { 1.0 }, 0.0, 1.0);
        assert!((jump - 0.3).abs() < 1e-15, "{jump}");
        let steep = find_root(&mut |x| (x - 1e-9).cbrt(), -1.0, 1.0);
        assert!((steep - 1e-9).abs() < 1e-20, "{steep}");
    }

    #[test]
    fn the_error_estimate_covers_a_peak() {
        // The abscissa's own rounding is worth 1e-16/w here.
        let w = 1e-4;
        let e = integrate(|x| w / (w * w + (x - 0.37).powi(2)), &[0.0, 1.0]);
        let exact = (0.63 / w).atan() + (0.37 / w).atan();
        assert!(
            (e.value - exact).abs() <= e.error.max(1e-12),
            "{e:?} {exact}"
        );
        assert!(e.error < 1e-10);
    }
}
