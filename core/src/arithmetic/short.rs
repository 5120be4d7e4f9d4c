//! Steps of 16-bit arithmetic, for cores with and without the instruction
//! that would do them at once.

/// share · factor, `factor` with 16 fraction bits and at most 1; rounded down.
#[inline]
pub(crate) fn scale(share: u32, factor: u32) -> u32 {
    if cfg!(long_multiply) {
        scale_long(share, factor)
    } else {
        scale_short(share, factor)
    }
}

#[inline]
fn scale_long(share: u32, factor: u32) -> u32 {
    ((u64::from(share) * u64::from(factor)) >> 16) as u32
}

/// In products of 32 bits.
#[inline]
fn scale_short(share: u32, factor: u32) -> u32 {
    let high = (share >> 16).wrapping_mul(factor);
    let low = (share & 0xFFFF).wrapping_mul(factor) >> 16;
    high.wrapping_add(low)
}

/// By how many bits a number above 0 can be shifted until its bit 30 or 31 is
/// set.
#[inline]
pub(crate) fn room(number: u32) -> u32 {
    if cfg!(count_zeros) {
        number.leading_zeros().saturating_sub(1)
    } else {
        room_in_steps(number)
    }
}

/// By halves.
#[inline]
fn room_in_steps(mut number: u32) -> u32 {
    let mut room = 0;
    let mut step = 16;
    while step > 0 {
        if number < 1 << (31 - step) {
            number <<= step;
            room += step;
        }
        step /= 2;
    }
    room
}

#[cfg(test)]
mod tests {
    use super::{room_in_steps, scale_long, scale_short};

    #[test]
    fn both_ways_to_scale_give_the_same_bits() {
        let mut share = 1u32;
        for i in 0..1u32 << 20 {
            share = share.wrapping_mul(0x9E37_79B1).wrapping_add(i);
            for factor in [0, 1, i & 0xFFFF, 0x8000, 0xFFFF, 0x1_0000] {
                assert_eq!(scale_short(share, factor), scale_long(share, factor));
            }
        }
        assert_eq!(scale_short(u32::MAX, 1 << 16), u32::MAX);
    }

    #[test]
    fn both_ways_to_find_room_agree() {
        for bit in 0..32 {
            for number in [1u32 << bit, (1 << bit) | 1, u32::MAX >> (31 - bit)] {
                let room = room_in_steps(number);
                assert_eq!(room, number.leading_zeros().saturating_sub(1), "{number}");
            }
        }
    }
}
