//! Steps of 16-bit arithmetic, for cores with and without the instruction
//! that would do them at once.

/// Bits of a factor that count: the upper half of a word.
pub(crate) const FACTOR: u32 = 0xFFFF_0000;

/// share · factor for a factor with 32 fraction bits, of which the upper 16
/// are taken; rounded down.
#[inline]
pub(crate) fn scale(share: u32, factor: u32) -> u32 {
    scale_by_half(share, factor >> 16)
}

/// share · factor for a factor below 2¹⁶ with 16 fraction bits; rounded down.
#[inline]
pub(crate) fn scale_by_half(share: u32, factor: u32) -> u32 {
    if cfg!(long_multiply) {
        scale_at_once(share, factor)
    } else {
        scale_by_halves(share, factor)
    }
}

#[inline]
fn scale_at_once(share: u32, factor: u32) -> u32 {
    ((u64::from(share) * u64::from(factor << 16)) >> 32) as u32
}

/// In products of 32 bits.
#[inline]
fn scale_by_halves(share: u32, factor: u32) -> u32 {
    (share >> 16) * factor + (((share & 0xFFFF) * factor) >> 16)
}

/// Of the components of two directions, 28 fraction bits; wraps for directions that
/// are far too long.
#[inline(always)]
pub(crate) fn sum_of_products(a: [i32; 3], b: [i32; 3]) -> i32 {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    let first = ax.wrapping_mul(bx).wrapping_add(ay.wrapping_mul(by));
    first.wrapping_add(az.wrapping_mul(bz))
}

/// a · b / 2^`DOWN` for a of at most 2³¹ and b below it, `DOWN` 30 or 32; rounded down.
#[inline(always)]
pub(crate) fn product_down<const DOWN: u32>(a: u32, b: u32) -> u32 {
    if cfg!(long_multiply) {
        product_down_at_once::<DOWN>(a, b)
    } else {
        product_down_by_halves::<DOWN>(a, b)
    }
}

#[inline(always)]
fn product_down_at_once<const DOWN: u32>(a: u32, b: u32) -> u32 {
    ((u64::from(a) * u64::from(b)) >> DOWN) as u32
}

/// In products of 32 bits.
// Where b is known to have no lower half, half of it is left.
#[inline(always)]
fn product_down_by_halves<const DOWN: u32>(a: u32, b: u32) -> u32 {
    let (upper, lower) = (|word: u32| word >> 16, |word: u32| word & 0xFFFF);
    let product = |a: u32, b: u32| a.wrapping_mul(b);
    // Less than 2³¹ each, by a's and b's bounds.
    let crossed = product(upper(b), lower(a)).wrapping_add(product(upper(a), lower(b)));
    let middle = crossed.wrapping_add(upper(product(lower(a), lower(b))));
    (product(upper(a), upper(b)) << (32 - DOWN)).wrapping_add(middle >> (DOWN - 16))
}

/// The product of two cosines with 28 fraction bits, with `BITS` of them, 26 or 28;
/// rounded down. Of numbers from 2 on it is any.
#[inline(always)]
pub(crate) fn product_of_cosines<const BITS: u32>(a: i32, b: i32) -> i32 {
    if cfg!(long_multiply) {
        product_at_once::<BITS>(a, b)
    } else {
        product_by_halves::<BITS>(a, b)
    }
}

#[inline(always)]
fn product_at_once<const BITS: u32>(a: i32, b: i32) -> i32 {
    // With 26 bits it is a word's upper half: fewer registers.
    let room = if BITS == 26 { 2 } else { 0 };
    ((i64::from(a << room) * i64::from(b)) >> (56 + room - BITS)) as i32
}

/// In products of 32 bits: halves of 14.
#[inline(always)]
fn product_by_halves<const BITS: u32>(a: i32, b: i32) -> i32 {
    let (high, low) = (|c: i32| c >> 14, |c: i32| c & 0x3FFF);
    let product = |a: i32, b: i32| a.wrapping_mul(b);
    let crossed = product(high(a), low(b)).wrapping_add(product(low(a), high(b)));
    let middle = crossed.wrapping_add(product(low(a), low(b)) >> 14) >> 14;
    product(high(a), high(b)).wrapping_add(middle) >> (28 - BITS)
}

/// Zeros above the highest bit of a number, 32 for 0.
#[inline]
pub(crate) fn leading_zeros(number: u32) -> u32 {
    if cfg!(count_zeros) || cfg!(feature = "small") {
        number.leading_zeros()
    } else {
        leading_zeros_by_table(number)
    }
}

/// Zeros above the highest bit of a byte.
static ZEROS: [u8; 256] = {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        table[byte] = (byte as u8).leading_zeros() as u8;
        byte += 1;
    }
    table
};

/// 256 bytes of table.
#[inline]
fn leading_zeros_by_table(number: u32) -> u32 {
    let zeros = |byte: u32| u32::from(ZEROS[byte as usize % ZEROS.len()]);
    // Shifts tell in one instruction what the bytes of a word take two for.
    if number >> 24 != 0 {
        zeros(number >> 24)
    } else if number >> 16 != 0 {
        8 + zeros(number >> 16)
    } else if number >> 8 != 0 {
        16 + zeros(number >> 8)
    } else {
        24 + zeros(number)
    }
}

#[cfg(test)]
mod tests {
    use super::{
        leading_zeros_by_table, product_at_once, product_by_halves, product_down_at_once,
        product_down_by_halves, scale_at_once, scale_by_halves,
    };

    #[test]
    fn both_ways_to_take_a_product_down_agree() {
        fn agree<const DOWN: u32>(a: u32, b: u32) {
            assert_eq!(
                product_down_by_halves::<DOWN>(a, b),
                product_down_at_once::<DOWN>(a, b),
                "{a}, {b}"
            );
        }
        let mut word = 1u32;
        for i in 0..1u32 << 22 {
            word = word.wrapping_mul(0x9E37_79B1).wrapping_add(i);
            let (a, b) = (word >> (1 + i % 16), word.rotate_left(13) >> (1 + i % 5));
            agree::<30>(a, b);
            agree::<32>(a, b);
        }
        for a in [0, 1, 0xFFFF, 0x7FFF_FFFF, 0x8000_0000] {
            for b in [0, 1, 0xFFFF, 0x7FFF_0000, 0x7FFF_FFFF] {
                agree::<30>(a, b);
                agree::<32>(a, b);
            }
        }
    }

    #[test]
    fn both_ways_to_multiply_cosines_give_the_same_bits() {
        let mut a = 1i32;
        for i in 0..1i32 << 20 {
            a = a.wrapping_mul(0x1E37_79B1).wrapping_add(i);
            for b in [0, 1, -1, -1 << 28, 1 << 28, a.rotate_left(9) >> 3] {
                let a = a >> 3;
                assert_eq!(product_by_halves::<26>(a, b), product_at_once::<26>(a, b));
                assert_eq!(product_by_halves::<28>(a, b), product_at_once::<28>(a, b));
            }
        }
        assert_eq!(product_by_halves::<26>(1 << 28, -1 << 28), -1 << 26);
    }

    #[test]
    fn both_ways_to_scale_give_the_same_bits() {
        let mut share = 1u32;
        for i in 0..1u32 << 20 {
            share = share.wrapping_mul(0x9E37_79B1).wrapping_add(i);
            for factor in [0, 1, share.rotate_left(7) >> 16, 1 << 15, 0xFFFF] {
                assert_eq!(scale_by_halves(share, factor), scale_at_once(share, factor));
            }
        }
        assert_eq!(scale_by_halves(u32::MAX, 0xFFFF), 0xFFFE_FFFF);
    }

    #[test]
    fn both_ways_to_count_zeros_agree() {
        for bit in 0..32 {
            for number in [1u32 << bit, (1 << bit) | 1, u32::MAX >> (31 - bit)] {
                assert_eq!(leading_zeros_by_table(number), number.leading_zeros());
            }
        }
        assert_eq!(leading_zeros_by_table(0), 32);
    }
}
