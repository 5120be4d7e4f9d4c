//! A metal and a light's exposure in one table.

use fixed::types::{U1F31, U32F32};

use super::foreshortening::Metallic;
use super::phong::MetallicPhong;
use crate::arithmetic::{Arithmetic, Q15};
use crate::colour::Rgb;
use crate::error::ParameterError;
use crate::geometry::Geometry;
use crate::table::{CosineCurve, ExposedCurve};

/// K · cosⁿα · F(Θmin) · cosΘL/cosΘmin (3.29): a [`Metal`](super::Metal) under
/// one light, its gain K folded into Fresnel's curve.
///
/// For a scene with one light it is the quicker of both, with as many bytes:
/// 1188 with 129 knots and 64 cells of twelve bytes. With several lights it
/// takes a table for each. The sRGB code is within 0.75 LSB of the exact one
/// at K = 1 and within 1.0 LSB at K = c_n for n to 500, where the curve's
/// cells hold the metal: for which metals 64 do, and which need 128 or 256,
/// is tested in `tests/tests/exposed.rs`.
///
/// ```
/// use microbrdf::arithmetic::Q15;
/// use microbrdf::brdf::{ExposedMetal, MetallicPhong};
/// use microbrdf::fixed::types::{I2F14, U32F32};
/// use microbrdf::geometry::{Direction, ShadingFrame};
/// use microbrdf::table::{COSINE_KNOTS, CosineCurve};
/// use microbrdf::{Rgb, constant};
///
/// const HALF: CosineCurve = CosineCurve::from_entries([[16384; 3]; COSINE_KNOTS]);
/// const LOBE: MetallicPhong<Q15> = constant!(MetallicPhong::<Q15>::new(U32F32::lit("20")));
/// static DULL: ExposedMetal = constant!(ExposedMetal::new(LOBE, &HALF, Rgb::grey(U32F32::ONE)));
///
/// let up = Direction::new(I2F14::ZERO, I2F14::ZERO, I2F14::ONE);
/// let light = DULL.shade(&ShadingFrame::new(up, up));
/// assert!(light.r.abs_diff(1 << 15) < 1 << 4);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExposedMetal<const KNOTS: usize = 129, const CELLS: usize = 64> {
    lobe: MetallicPhong<Q15<KNOTS>>,
    curve: ExposedCurve<CELLS>,
}

impl<const KNOTS: usize, const CELLS: usize> ExposedMetal<KNOTS, CELLS> {
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
            Ok(curve) => Ok(Self { lobe, curve }),
            Err(error) => Err(error),
        }
    }

    /// Exposed light of 16 bits per channel, as [`ExposedCurve`] gives it.
    // A shading loop calls it once for a material: let the loop hold it.
    #[inline(always)]
    pub fn shade(&self, geometry: &impl Geometry<Q15<KNOTS>>) -> Rgb<u16> {
        let (n_dot_l, n_dot_v) = geometry.cosines();
        if !Q15::<KNOTS>::lit(n_dot_l, n_dot_v) {
            return Rgb::grey(0);
        }
        let Some(lobe) = self.lobe.power().within(geometry.versine()) else {
            return Rgb::grey(0);
        };
        let lobe = U1F31::from_bits(lobe);
        let (share, cos_min) = Metallic::attenuated::<Q15<KNOTS>>(lobe, n_dot_l, n_dot_v);
        self.curve.expose(share, cos_min)
    }
}
