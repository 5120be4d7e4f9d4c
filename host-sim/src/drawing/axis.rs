//! Ticks of an axis and where a value lies on it.

use microbrdf_reference::figures::Axis;

/// A mark: its place from 0 (at `from`) to 1 (at `to`), and its label.
#[derive(Debug, PartialEq)]
pub struct Tick {
    pub place: f64,
    pub label: String,
}

/// Where a value lies: 0 at the axis's `from`, 1 at its `to`.
pub fn place(axis: &Axis, value: f64) -> f64 {
    if axis.logarithmic {
        (value / axis.from).ln() / (axis.to / axis.from).ln()
    } else {
        (value - axis.from) / (axis.to - axis.from)
    }
}

/// At least two and at most about `most` ticks at round values.
pub fn ticks(axis: &Axis, most: usize) -> Vec<Tick> {
    let values = if axis.logarithmic {
        powers_of_ten(axis)
    } else {
        multiples(axis, step(axis, most))
    };
    values
        .into_iter()
        .map(|(value, label)| Tick {
            place: place(axis, value),
            label,
        })
        .collect()
}

/// A round distance between ticks: 1, 2 or 5 times a power of ten; angles by 15, 30 or 45.
fn step(axis: &Axis, most: usize) -> f64 {
    let least = (axis.to - axis.from).abs() / most as f64;
    if axis.label.ends_with("[°]") && least > 5.0 {
        return [10.0, 15.0, 30.0]
            .into_iter()
            .find(|step| *step >= least)
            .unwrap_or(45.0);
    }
    let power = 10f64.powf(least.log10().floor());
    let factor = [1.0, 2.0, 5.0]
        .into_iter()
        .find(|f| f * power >= least * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

fn multiples(axis: &Axis, step: f64) -> Vec<(f64, String)> {
    let (low, high) = (axis.from.min(axis.to), axis.from.max(axis.to));
    let decimals = (-step.log10().floor()).clamp(0.0, 12.0) as usize;
    let first = (low / step - 1e-9).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    (first..=last)
        .map(|i| {
            let value = i as f64 * step;
            let text = if high.abs() >= 1e5 || step < 1e-4 {
                scientific(value)
            } else {
                format!("{value:.decimals$}")
            };
            (value, text.replace('-', "−"))
        })
        .collect()
}

/// Three digits at most and a power of ten, such as 2.5e6.
fn scientific(value: f64) -> String {
    let text = format!("{value:.2e}");
    match text.split_once('e') {
        _ if value == 0.0 => "0".to_owned(),
        Some((digits, power)) => {
            let digits = digits.trim_end_matches('0').trim_end_matches('.');
            format!("{digits}e{power}")
        }
        None => text,
    }
}

fn powers_of_ten(axis: &Axis) -> Vec<(f64, String)> {
    let (low, high) = (axis.from.min(axis.to), axis.from.max(axis.to));
    let first = (low.log10() - 1e-9).ceil() as i32;
    let last = (high.log10() + 1e-9).floor() as i32;
    (first..=last)
        .map(|power| {
            let value = 10f64.powi(power);
            (value, value.to_string())
        })
        .collect()
}

/// The end of an axis that starts at 0 and holds `greatest` with a little to spare.
pub fn rounded_up(greatest: f64) -> f64 {
    if !(greatest > 0.0 && greatest.is_finite()) {
        return 1.0;
    }
    let wanted = 1.04 * greatest;
    let power = 10f64.powf(wanted.log10().floor());
    let factors = [1.0, 1.1, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0];
    let factor = factors.into_iter().find(|f| f * power >= wanted);
    factor.unwrap_or(10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis, most: usize) -> Vec<String> {
        ticks(axis, most).into_iter().map(|t| t.label).collect()
    }

    #[test]
    fn ticks_are_round() {
        let angle = Axis::angle("Θ [°]");
        assert_eq!(labels(&angle, 7), ["0", "15", "30", "45", "60", "75", "90"]);
        let both = Axis::linear("view [°]", -90.0, 90.0);
        assert_eq!(
            labels(&both, 7),
            ["−90", "−60", "−30", "0", "30", "60", "90"]
        );
        let unit = Axis::linear("a", 0.0, 1.1);
        assert_eq!(labels(&unit, 6), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        let large = Axis::linear("f", 0.0, 2.5e6);
        assert_eq!(
            labels(&large, 6),
            ["0", "5e5", "1e6", "1.5e6", "2e6", "2.5e6"]
        );
        let small = Axis::linear("f", 0.0, 0.03);
        assert_eq!(
            labels(&small, 6),
            [
                "0.000", "0.005", "0.010", "0.015", "0.020", "0.025", "0.030"
            ]
        );
    }

    #[test]
    fn a_backward_logarithmic_axis_runs_from_left_to_right() {
        let axis = Axis::logarithmic("e [°]", 10.0, 1e-2);
        let ticks = ticks(&axis, 7);
        assert_eq!(ticks.len(), 4);
        assert_eq!(
            (ticks[3].label.as_str(), ticks[0].label.as_str()),
            ("10", "0.01")
        );
        assert!(ticks[3].place.abs() < 1e-12 && (ticks[0].place - 1.0).abs() < 1e-12);
        assert!((place(&axis, 1.0) - 1.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn ends_hold_what_they_must() {
        for greatest in [1e-9, 0.3, 0.97, 1.0, 3.5, 16.2, 9.99, 1e12] {
            let end = rounded_up(greatest);
            assert!(
                end >= greatest && end <= 2.6 * greatest,
                "{greatest}: {end}"
            );
        }
        assert_eq!(
            [
                rounded_up(0.0),
                rounded_up(f64::NAN),
                rounded_up(f64::INFINITY)
            ],
            [1.0; 3]
        );
    }
}
