//! A peak times a share, in fixed point: what is asked for once a direction
//! pair, not once a light and pixel.

use fixed::types::{U1F31, U32F32, U64F64};

/// peak · share.
#[inline]
pub(super) fn radiance(peak: U32F32, share: U1F31) -> U32F32 {
    let (peak, share) = (peak.to_bits(), u64::from(share.to_bits()));
    let high = (peak >> 32) * share;
    let low = (peak & 0xFFFF_FFFF) * share;
    // A share of at most 1 keeps the sum below the peak's own bits.
    U32F32::from_bits((high << 1).saturating_add(low >> 31))
}

/// peak · share, as a BRDF value.
#[inline]
pub(super) fn value(peak: U32F32, share: U1F31) -> U64F64 {
    let product = u128::from(peak.to_bits()) * u128::from(share.to_bits());
    // 63 fraction bits, to 64.
    U64F64::from_bits(product << 1)
}

/// peak · share / cosine, `cosine` with 30 fraction bits; the greatest value
/// where it is 0, unless the share is 0, too.
#[inline]
pub(super) fn value_over(peak: U32F32, share: U1F31, cosine: i32) -> U64F64 {
    if share == U1F31::ZERO {
        U64F64::ZERO
    } else if cosine <= 0 {
        U64F64::MAX
    } else {
        // 63 fraction bits over 30, to 64; below 2⁹⁶, so nothing is lost.
        let product = u128::from(peak.to_bits()) * u128::from(share.to_bits());
        U64F64::from_bits((product << 31) / u128::from(cosine as u32))
    }
}
