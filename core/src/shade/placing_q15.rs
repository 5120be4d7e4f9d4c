//! Places for 16-bit shading: traced in 32 bits, as shapes are; what arrives
//! is dimmed in products of 32 bits.

use fixed::types::{I8F24, I24F40, U1F31};

use super::tracing_q15::{rounded, widened};
use super::{Placing, Sphere};
use crate::arithmetic::{Q15, Q31};
use crate::geometry::Direction;

type Fine = Q31<1>;

/// A share as mantissa · 2^(−16 − shift), within 2⁻¹⁵ of its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimming15 {
    /// 16 bits.
    mantissa: u32,
    /// At most 31.
    shift: u32,
}

impl Dimming15 {
    /// The share with 32 fraction bits.
    #[inline]
    fn new(share: u32) -> Self {
        let shift = share.leading_zeros().min(31);
        Self {
            mantissa: (share << shift) >> 16,
            shift,
        }
    }
}

impl<const KNOTS: usize> Placing for Q15<KNOTS> {
    /// 24 fraction bits.
    type Place = [i64; 3];
    type Dimming = Dimming15;

    #[inline]
    fn place(d: &Direction<Fine>, depth: i64) -> [i64; 3] {
        Fine::place(d, depth)
    }

    #[inline]
    fn odd_stripe(eye: I24F40, across: &[I24F40; 3], d: &Direction<Fine>, depth: i64) -> bool {
        Fine::odd_stripe(eye, across, d, depth)
    }

    #[inline]
    fn towards(place: &[i64; 3], lamp: &[I8F24; 3], near: I8F24) -> (Direction<Self>, Dimming15) {
        let (l, dimming) = Fine::towards(place, lamp, near);
        (rounded(&l), Dimming15::new(dimming))
    }

    #[inline]
    fn hides(
        sphere: &Sphere<Self>,
        place: &[i64; 3],
        l: &Direction<Self>,
        lamp: Option<&[I8F24; 3]>,
    ) -> bool {
        let sphere = Sphere::<Fine> {
            eye: sphere.eye,
            radius: sphere.radius,
            material: sphere.material,
            extent: sphere.extent,
        };
        Fine::hides(&sphere, place, &widened(l), lamp)
    }

    #[inline]
    fn narrow(dimming: Dimming15, share: U1F31) -> Dimming15 {
        // 31 fraction bits; a lobe is at most 1.
        let narrow = Dimming15::new(share.to_bits().min(0x7FFF_FFFF) << 1);
        let product = dimming.mantissa * narrow.mantissa;
        let more = product.leading_zeros().min(31);
        Dimming15 {
            mantissa: (product << more) >> 16,
            shift: (dimming.shift + narrow.shift + more).min(31),
        }
    }

    #[inline]
    fn dim(share: U1F31, dimming: Dimming15) -> U1F31 {
        let share = share.to_bits();
        let high = (share >> 16) * dimming.mantissa;
        let low = ((share & 0xFFFF) * dimming.mantissa) >> 16;
        U1F31::from_bits((high + low) >> (dimming.shift % 32))
    }
}
