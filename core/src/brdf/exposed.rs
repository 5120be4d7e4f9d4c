//! A metallic lobe with a light's gain in its table.

use fixed::types::{U1F31, U32F32};

use super::foreshortening::Metallic;
use super::phong::MetallicPhong;
use crate::arithmetic::{Arithmetic, Q15};
use crate::colour::Rgb;
use crate::error::ParameterError;
use crate::geometry::Geometry;
use crate::table::{CosineCurve, ExposedCurve, ExposedGain};

/// K · cosⁿα · cosΘL/cosΘmin (3.7), perhaps times F(Θmin) (3.29), as linear
/// light of 16 bits: a metallic lobe under one light, its gain K folded into
/// the colour `C`.
///
/// For a scene with one light it is the quicker way, in 16-bit fixed point
/// alone; with several lights each takes a table of its own. For n = 1 and from
/// 1.5 to 1e8, and with 257 knots of the lobe between these, the sRGB code is within
/// 0.75 LSB of the exact one at K = 1, and at K = c_n for n to 500: lobes, and metals
/// whose curve has knots enough (65 for gold, silver and copper, 129 for aluminium
/// and chromium). Of a dielectric, whose F spans a factor of 25, 257 knots are within
/// 1.05 LSB. Tested in
/// `tests/tests/exposed.rs`.
///
/// ```
/// use microbrdf::arithmetic::Q15;
/// use microbrdf::brdf::{ExposedPhong, MetallicPhong};
/// use microbrdf::fixed::types::{I2F14, U32F32};
/// use microbrdf::geometry::{Direction, ShadingFrame};
/// use microbrdf::shade::srgb8_direct;
/// use microbrdf::{Rgb, constant};
///
/// const LOBE: MetallicPhong<Q15> = constant!(MetallicPhong::<Q15>::new(U32F32::lit("20")));
/// const RED: Rgb<U32F32> = Rgb { r: U32F32::ONE, g: U32F32::ZERO, b: U32F32::ZERO };
/// static LAMP_ON_STEEL: ExposedPhong = constant!(ExposedPhong::new(LOBE, RED));
///
/// let up = Direction::new(I2F14::ZERO, I2F14::ZERO, I2F14::ONE);
/// let light = LAMP_ON_STEEL.shade(&ShadingFrame::new(up, up));
/// assert_eq!(light.map(srgb8_direct), Rgb { r: 255, g: 0, b: 0 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposed<C, const KNOTS: usize = 129> {
    lobe: MetallicPhong<Q15<KNOTS>>,
    colour: C,
}

/// A [`Metal`](super::Metal) under one light: 1.3 KiB with 129 knots of the
/// lobe and 65 of the colour.
pub type ExposedMetal<const KNOTS: usize = 129, const COLOUR_KNOTS: usize = 65> =
    Exposed<ExposedCurve<COLOUR_KNOTS>, KNOTS>;

/// [`MetallicPhong`] under one light.
pub type ExposedPhong<const KNOTS: usize = 129> = Exposed<ExposedGain, KNOTS>;

/// What a share of a lobe's peak becomes.
pub trait Exposing {
    /// Light of 16 bits of a share, at most 1 with 25 fraction bits, at cosΘmin
    /// with 30 fraction bits, not negative.
    fn expose(&self, share: u32, cos_min: i32) -> Rgb<u16>;
}

impl<const KNOTS: usize> Exposing for ExposedCurve<KNOTS> {
    #[inline(always)]
    fn expose(&self, share: u32, cos_min: i32) -> Rgb<u16> {
        self.expose(share, cos_min)
    }
}

impl Exposing for ExposedGain {
    #[inline(always)]
    fn expose(&self, share: u32, _: i32) -> Rgb<u16> {
        self.expose(share)
    }
}

impl<const KNOTS: usize, const COLOUR_KNOTS: usize> Exposed<ExposedCurve<COLOUR_KNOTS>, KNOTS> {
    /// The lobe of `lobe`, coloured by `fresnel`, the reflectance over cosΘmin,
    /// and by the `gain` K of each channel.
    ///
    /// # Errors
    /// As [`ExposedCurve::new`].
    pub const fn new(
        lobe: MetallicPhong<Q15<KNOTS>>,
        fresnel: &CosineCurve,
        gain: Rgb<U32F32>,
    ) -> Result<Self, ParameterError> {
        match ExposedCurve::new(fresnel, gain) {
            Ok(colour) => Ok(Self { lobe, colour }),
            Err(error) => Err(error),
        }
    }
}

impl<const KNOTS: usize> Exposed<ExposedGain, KNOTS> {
    /// The lobe of `lobe` with the `gain` K of each channel.
    ///
    /// # Errors
    /// As [`ExposedGain::new`].
    pub const fn new(
        lobe: MetallicPhong<Q15<KNOTS>>,
        gain: Rgb<U32F32>,
    ) -> Result<Self, ParameterError> {
        match ExposedGain::new(gain) {
            Ok(colour) => Ok(Self { lobe, colour }),
            Err(error) => Err(error),
        }
    }
}

impl<C: Exposing, const KNOTS: usize> Exposed<C, KNOTS> {
    /// Exposed light, 16 bits a channel: [`ExposedCurve`] says what they stand
    /// for. Below the horizon and beyond the lobe it is 0.
    #[inline(always)]
    pub fn shade(&self, geometry: &impl Geometry<Q15<KNOTS>>) -> Rgb<u16> {
        self.light(geometry).unwrap_or_default()
    }

    /// As [`Self::shade`]; `None` below the horizon and beyond the lobe.
    // A shading loop calls it once for a material: let the loop hold it.
    #[inline(always)]
    pub fn light(&self, geometry: &impl Geometry<Q15<KNOTS>>) -> Option<Rgb<u16>> {
        let (n_dot_l, n_dot_v) = geometry.cosines();
        if !Q15::<KNOTS>::lit(n_dot_l, n_dot_v) {
            return None;
        }
        // As the table holds it: a share is any number times 2⁻²⁵ here.
        let lobe = U1F31::from_bits(self.lobe.power().entry_at(geometry.versine())?);
        let (share, cos_min) = Metallic::attenuated::<Q15<KNOTS>>(lobe, n_dot_l, n_dot_v);
        Some(self.colour.expose(share.to_bits(), cos_min))
    }
}
