//! Comparing a value with digits.

/// The number at the start of a text like "10430." or "7.8e-3", and the unit of its last digit.
pub(super) fn digits(text: &str) -> Option<(f64, f64)> {
    let text = text.trim();
    let value: f64 = text.parse().ok()?;
    let (mantissa, exponent) = match text.find(['e', 'E']) {
        Some(at) => (&text[..at], text[at + 1..].parse::<i32>().ok()?),
        None => (text, 0),
    };
    let decimals = mantissa.find('.').map_or(0, |at| mantissa.len() - at - 1);
    Some((value, 10f64.powi(exponent - decimals as i32)))
}

/// Whether a value rounds to the digits of a text. A half unit counts as both, and so does
/// what f64 can't tell from it.
pub(super) fn agrees(text: &str, value: f64) -> bool {
    match digits(text) {
        Some((given, unit)) => {
            (value - given).abs() <= 0.5 * unit + 4.0 * f64::EPSILON * given.abs()
        }
        None => false,
    }
}

/// A value with ten significant digits, short where it can be.
pub(super) fn ten_digits(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let magnitude = value.abs().log10().floor() as i32;
    if (-5..10).contains(&magnitude) {
        let decimals = (9 - magnitude).max(0) as usize;
        let text = format!("{value:.decimals$}");
        if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        } else {
            text
        }
    } else {
        format!("{value:.9e}")
    }
}

/// What a computed value says about a printed one.
pub(super) fn verdict(id: &str, published: &str, value: f64) -> String {
    if let Some(text) = special(id, published, value) {
        return text;
    }
    let Some((printed, unit)) = digits(published) else {
        return format!("not a number in print: {published}");
    };
    let off = (value - printed).abs() / unit;
    if off <= 0.5 + 1e-9 {
        "agrees to printed digits".into()
    } else if off < 1.05 {
        // One unit, to a tenth.
        "truncated / last digit off by one".into()
    } else {
        let relative = (printed - value).abs() / value.abs();
        format!("wrong by {off:.1} units of the last digit ({relative:.2e} relative)")
    }
}

fn special(id: &str, published: &str, value: f64) -> Option<String> {
    let says = |holds: bool, yes: &str, no: &str| Some(if holds { yes } else { no }.to_owned());
    // Limits: a printed integer or half has no unit to speak of.
    if id.ends_with("-inf") || id.starts_with("T4.2-") {
        let printed: f64 = published.parse().ok()?;
        return says(
            (value - printed).abs() < 1e-3,
            "agrees (limit)",
            "wrong: another limit",
        );
    }
    if published == "1/pi" {
        return says(
            (value - std::f64::consts::FRAC_1_PI).abs() < 1e-9,
            "agrees",
            "wrong",
        );
    }
    if let Some(rest) = published.strip_prefix(">=") {
        return says(value >= rest.trim().parse().ok()?, "agrees", "wrong: below");
    }
    if let Some(rest) = published.strip_prefix('>') {
        return says(value > rest.trim().parse().ok()?, "agrees", "wrong: below");
    }
    if let Some(rest) = published.strip_prefix("<=") {
        return says(
            value <= 1e-9 + rest.trim().parse::<f64>().ok()?,
            "agrees",
            "wrong: above",
        );
    }
    match published {
        "infinity (claimed)" => says(value <= 1.0 + 1e-9, "wrong: bounded by 1", "agrees"),
        "->1" => says(
            value > 0.9999 && value <= 1.0,
            "agrees (monotone to 1)",
            "wrong: below 1",
        ),
        "< 1, = (2.22)" => says(
            value < 0.9999,
            "agrees with (2.22): the accumulated divisor is floored at max(NL,NV)",
            "text not literally true: (2.21) iterated literally tends to 1",
        ),
        "small" => says(value < 1e-3, "agrees", "wrong: not small"),
        "eta,k only" | "eta only" => Some("inputs (plausible)".into()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_the_last_digit() {
        assert_eq!(digits("0.350").map(|d| d.0), Some(0.35));
        for (text, unit) in [
            ("0.350", 1e-3),
            ("10430.", 1.0),
            ("7.8e-3", 1e-4),
            ("82", 1.0),
        ] {
            assert!(
                (digits(text).unwrap().1 / unit - 1.0).abs() < 1e-12,
                "{text}"
            );
        }
        assert_eq!(digits("> 0.85"), None);
    }

    #[test]
    fn verdicts_are_two_sided() {
        assert_eq!(verdict("x", "0.350", 0.3496), "agrees to printed digits");
        assert_eq!(
            verdict("x", "5.34", 5.3342),
            "truncated / last digit off by one"
        );
        assert!(verdict("x", "69.8", 67.66).starts_with("wrong by 21.4"));
        assert_eq!(verdict("x", ">= 0.5", 0.49), "wrong: below");
        assert!(agrees("0.3496155268", 0.349_615_526_83));
        assert!(!agrees("0.3496155268", 0.349_615_526_9));
    }

    #[test]
    fn ten_digits_are_short() {
        assert_eq!(ten_digits(0.25), "0.25");
        assert_eq!(ten_digits(2.0), "2");
        assert_eq!(ten_digits(1.0 / 3.0), "0.3333333333");
        assert_eq!(ten_digits(41_721.513_4), "41721.5134");
        assert_eq!(ten_digits(8.211_511_76e-26), "8.211511760e-26");
    }
}
