//! Sixty-four bits of 30 fraction bits, for what is made once a light.

/// Fraction bits.
pub(super) const UNIT_BITS: u32 = 30;
pub(super) const UNIT: i64 = 1 << UNIT_BITS;

/// a / b; 0 for b = 0, which no caller passes.
pub(super) const fn quotient(a: i64, b: i64) -> i64 {
    match a.checked_div(b) {
        Some(quotient) => quotient,
        None => 0,
    }
}

/// Of a square that is not negative.
pub(super) const fn root(square: i64) -> i64 {
    (square as u64).isqrt() as i64
}

pub(super) const fn product(a: i64, b: i64) -> i64 {
    (a * b) >> UNIT_BITS
}

pub(super) const fn clamp(value: i64, least: i64, most: i64) -> i64 {
    if value < least {
        least
    } else if value > most {
        most
    } else {
        value
    }
}

#[cfg(test)]
mod tests {
    use super::clamp;

    #[test]
    fn what_is_outside_is_at_the_nearer_end() {
        let clamped = [-9, -2, -1, 0, 3, 4, 9].map(|value| clamp(value, -1, 3));
        assert_eq!(clamped, [-1, -1, -1, 0, 3, 3, 3]);
    }
}
