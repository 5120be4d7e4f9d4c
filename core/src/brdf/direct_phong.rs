//! A metallic lobe under one light, in look-ups alone.

use fixed::types::U32F32;

use super::phong::MetallicPhong;
use crate::arithmetic::{Arithmetic as _, Q15};
use crate::colour::Rgb;
use crate::error::ParameterError;
use crate::geometry::Products;
use crate::table::{DirectTable, ENTRY_BITS, Ratio15};

/// Bits of light.
const LIGHT_BITS: u32 = 16;
/// Bits of an entry: twice it is not negative.
const WORD_BITS: u32 = 30;
/// Bits of a factor, and of the entry that it is multiplied by.
const FACTOR_BITS: u32 = 12;
const WHITE: u32 = 1 << FACTOR_BITS;

/// K · cosⁿα · cosΘL/cosΘmin (3.7) as linear light of 16 bits: a metallic lobe
/// under one light, in two look-ups without interpolation.
///
/// The quickest way to a lobe that any N, L and V have, for cores with flash to
/// spare: four bytes a cell, and 4 KiB for the ratio of the cosines, which all
/// lobes share; [`ExposedPhong`](super::ExposedPhong) takes 1.3 KiB in all. In 16-bit
/// fixed point alone; with several lights each takes a table of its own.
///
/// With 4096 cells, of a lobe with 513 knots, the sRGB code is within 0.75 LSB of
/// the exact one for n from 1.5 to 1e8 at K = 1, and at K = c_n for n to 500; in
/// world space within 0.78 for n to 5000 at K = 1, and 0.85 at K = c_n for n to 500.
/// With 8192 cells it is within 0.75 there for n from 1 to 5000 at K = 1.
/// Of the light, a cell is off by 2.5e-3 at most and the ratio by 2.8e-4. Tested in
/// `tests/tests/direct.rs`. The peak itself lies within a cell: it is a little
/// below K.
///
/// ```
/// use microbrdf::arithmetic::Q15;
/// use microbrdf::brdf::{DirectPhong, MetallicPhong};
/// use microbrdf::fixed::types::{I2F14, U32F32};
/// use microbrdf::geometry::{Direction, ShortWorld};
/// use microbrdf::shade::srgb8_direct;
/// use microbrdf::{Rgb, constant};
///
/// const LOBE: MetallicPhong<Q15<513>> = constant!(MetallicPhong::<Q15<513>>::new(U32F32::lit("20")));
/// const RED: Rgb<U32F32> = Rgb { r: U32F32::ONE, g: U32F32::ZERO, b: U32F32::ZERO };
/// static LAMP_ON_STEEL: DirectPhong = constant!(DirectPhong::new(&LOBE, RED));
///
/// let up = Direction::<Q15>::new(I2F14::ZERO, I2F14::ZERO, I2F14::ONE);
/// let light = LAMP_ON_STEEL.shade(&ShortWorld::new(up, up, up));
/// assert_eq!(light.map(srgb8_direct), Rgb { r: 255, g: 0, b: 0 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct DirectPhong<const CELLS: usize = 4096> {
    /// Times the greatest channel's gain, `down` bits below light.
    lobe: DirectTable<CELLS>,
    down: u32,
    /// Each channel's gain in the greatest.
    factors: [u32; 3],
}

const GAIN_RANGE: ParameterError = ParameterError::new("gain", "below 16384");

impl<const CELLS: usize> DirectPhong<CELLS> {
    /// The lobe of `lobe` with the `gain` K of each channel, below 16384.
    /// Its knots say how exact a cell is.
    ///
    /// # Errors
    /// A gain from 16384 on.
    pub const fn new<const KNOTS: usize>(
        lobe: &MetallicPhong<Q15<KNOTS>>,
        gain: Rgb<U32F32>,
    ) -> Result<Self, ParameterError> {
        let gains = [gain.r.to_bits(), gain.g.to_bits(), gain.b.to_bits()];
        let greatest = greatest(gains);
        if greatest >> 32 >= 1 << (WORD_BITS - LIGHT_BITS) {
            return Err(GAIN_RANGE);
        }
        // K is below 2^whole.
        let whole = 32 - (greatest >> 32).leading_zeros().saturating_sub(32);
        let room = WORD_BITS - LIGHT_BITS - whole;
        let most = ENTRY_BITS - LIGHT_BITS;
        let down = if room < most { room } else { most };
        // The least share that gives light.
        let least = match (1u64 << (most + 32)).checked_div(greatest) {
            Some(least) if least < u32::MAX as u64 => least as u32,
            _ => u32::MAX,
        };
        Ok(Self {
            lobe: DirectTable::new(lobe.power(), least, greatest, most - down),
            down,
            factors: [
                factor(gains[0], greatest),
                factor(gains[1], greatest),
                factor(gains[2], greatest),
            ],
        })
    }

    /// Exposed light, 16 bits a channel. Below the horizon and beyond the lobe
    /// it is 0.
    #[inline(always)]
    pub fn shade<const KNOTS: usize>(&self, geometry: &impl Products<KNOTS>) -> Rgb<u16> {
        self.light(geometry).unwrap_or_default()
    }

    /// As [`Self::shade`]; `None` below the horizon and beyond the lobe.
    // A shading loop calls it once for a material: let the loop hold it.
    #[inline(always)]
    pub fn light<const KNOTS: usize, G: Products<KNOTS>>(&self, geometry: &G) -> Option<Rgb<u16>> {
        // Where there is light both are positive.
        let (n_dot_l, n_dot_v) = geometry.products();
        let (n_dot_l, n_dot_v) = (n_dot_l as u32, n_dot_v as u32);
        let peak = self.lobe.entry_at(lit_versine(geometry)?)?;
        let light = if n_dot_l < n_dot_v {
            Ratio15::direct(n_dot_l, n_dot_v).of(peak)
        } else {
            peak
        };
        Some(Rgb::from_array(self.factors.map(|factor| {
            // A material that is a constant has no decision here.
            let light = if factor == WHITE {
                light
            } else {
                (light >> FACTOR_BITS) * factor
            };
            (light as i32 >> (self.down % 32)).clamp(0, 0xFFFF) as u16
        })))
    }
}

const fn greatest([r, g, b]: [u64; 3]) -> u64 {
    let greatest = if r >= g { r } else { g };
    if greatest >= b { greatest } else { b }
}

/// A gain in the greatest, rounded.
const fn factor(gain: u64, greatest: u64) -> u32 {
    if greatest == 0 {
        return 0;
    }
    let twice = ((gain as u128) << (FACTOR_BITS + 1)) / greatest as u128;
    (twice as u32).div_ceil(2)
}

/// 1 − R·V, beyond every lobe where nothing is lit: one decision for both. `None`
/// where it is dearer to form than to ask first.
#[inline(always)]
fn lit_versine<const KNOTS: usize, G: Products<KNOTS>>(geometry: &G) -> Option<u32> {
    let (n_dot_l, n_dot_v) = geometry.products();
    let lit = Q15::<KNOTS>::lit(n_dot_l, n_dot_v);
    if G::DEAR && cfg!(not(long_multiply)) && !lit {
        return None;
    }
    Some(geometry.versine() | u32::from(!lit).wrapping_neg())
}
