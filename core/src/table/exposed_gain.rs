//! A light's gain for what has no colour of its own.

use fixed::types::U32F32;

use super::exposure::{Exposure, factor};
use crate::colour::Rgb;
use crate::error::ParameterError;

/// A gain K of each channel, as factors of 12 bits of the greatest: within
/// 2⁻¹³ of it. What comes out is light of 16 bits, as
/// [`ExposedCurve`](super::ExposedCurve) says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExposedGain {
    factors: [i32; 3],
    exposure: Exposure,
}

impl ExposedGain {
    /// The `gain` of each channel.
    ///
    /// # Errors
    /// A gain above 256 with a channel, not 0, that is 128 times less than
    /// another.
    pub const fn new(gain: Rgb<U32F32>) -> Result<Self, ParameterError> {
        let gain = [gain.r.to_bits(), gain.g.to_bits(), gain.b.to_bits()];
        let (mut least, mut greatest) = (u128::MAX, 0);
        let mut products = [0; 3];
        let mut channel = 0;
        while channel < 3 {
            // 15 bits more, as beside a curve.
            let product = (gain[channel] as u128) << 15;
            if product > greatest {
                greatest = product;
            }
            if product > 0 && product < least {
                least = product;
            }
            products[channel] = product;
            channel += 1;
        }
        // A step more: a power of two is a shift.
        let exposure = match Exposure::new(least, greatest + 1) {
            Ok(exposure) => exposure,
            Err(error) => return Err(error),
        };
        let factors = [
            factor(exposure.word(products[0])),
            factor(exposure.word(products[1])),
            factor(exposure.word(products[2])),
        ];
        Ok(Self { factors, exposure })
    }

    /// `share` · K; the share is at most 1, with a lobe table's 25 fraction
    /// bits.
    #[inline(always)]
    pub(crate) fn expose(&self, share: u32) -> Rgb<u16> {
        let share = self.exposure.share(share);
        Rgb::from_array(
            self.factors
                .map(|factor| self.exposure.light(factor, share)),
        )
    }
}
