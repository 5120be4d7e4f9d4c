//! Steps of 16-bit arithmetic, for cores with and without the instruction
//! that would do them at once.

/// Bits of a factor that count: the upper half of a word.
pub(crate) const FACTOR: u32 = 0xFFFF_0000;

/// share · factor for a factor with 32 fraction bits, of which the upper 16
/// are taken; rounded down.
#[inline]
pub(crate) fn scale(share: u32, factor: u32) -> u32 {
    if cfg!(long_multiply) {
        scale_at_once(share, factor)
    } else {
        scale_by_halves(share, factor)
    }
}

#[inline]
fn scale_at_once(share: u32, factor: u32) -> u32 {
    ((u64::from(share) * u64::from(factor & FACTOR)) >> 32) as u32
}

/// In products of 32 bits.
#[inline]
fn scale_by_halves(share: u32, factor: u32) -> u32 {
    let factor = factor >> 16;
    (share >> 16) * factor + ((share & 0xFFFF) * factor >> 16)
}

/// Two numbers, shifted alike to where the second has its highest bit set,
/// unless it is 0; the first must not be greater.
#[inline]
pub(crate) fn normalise(a: u32, b: u32) -> (u32, u32) {
    if cfg!(count_zeros) {
        normalise_at_once(a, b)
    } else {
        normalise_in_steps(a, b)
    }
}

#[inline]
fn normalise_at_once(a: u32, b: u32) -> (u32, u32) {
    let room = b.leading_zeros() % 32;
    (a << room, b << room)
}

#[inline]
fn normalise_in_steps(mut a: u32, mut b: u32) -> (u32, u32) {
    if b == 0 {
        return (a, b);
    }
    while b < 1 << 24 {
        a <<= 8;
        b <<= 8;
    }
    if b < 1 << 28 {
        a <<= 4;
        b <<= 4;
    }
    if b < 1 << 30 {
        a <<= 2;
        b <<= 2;
    }
    if b < 1 << 31 {
        a <<= 1;
        b <<= 1;
    }
    (a, b)
}

#[cfg(test)]
mod tests {
    use super::{normalise_at_once, normalise_in_steps, scale_at_once, scale_by_halves};

    #[test]
    fn both_ways_to_scale_give_the_same_bits() {
        let mut share = 1u32;
        for i in 0..1u32 << 20 {
            share = share.wrapping_mul(0x9E37_79B1).wrapping_add(i);
            for factor in [0, 1, share.rotate_left(7), 1 << 31, u32::MAX] {
                assert_eq!(scale_by_halves(share, factor), scale_at_once(share, factor));
            }
        }
        assert_eq!(scale_by_halves(u32::MAX, u32::MAX), 0xFFFE_FFFF);
    }

    #[test]
    fn both_ways_to_normalise_agree() {
        for bit in 0..32 {
            for b in [1u32 << bit, (1 << bit) | 1, u32::MAX >> (31 - bit)] {
                for a in [0, 1, b / 2, b] {
                    let (found, divisor) = normalise_in_steps(a, b);
                    assert_eq!((found, divisor), normalise_at_once(a, b), "{a}, {b}");
                    assert!(divisor >= 1 << 31);
                    assert_eq!(u64::from(found) * u64::from(b), u64::from(a) * u64::from(divisor));
                }
            }
        }
        assert_eq!(normalise_in_steps(0, 0), normalise_at_once(0, 0));
    }
}
