//! What a test hands to the core, made of integers.

use microbrdf::ParameterError;
use microbrdf::arithmetic::{F32, Float, Math, Q15, Q31};
use microbrdf::fixed::types::{I2F14, I2F30, I8F24, I24F40, U0F32, U32F32};
use microbrdf::geometry::Direction;
use microbrdf::sampling::Sampling;
use microbrdf::shade::{FloodLight, Placing, PointLight};
use microbrdf::table::{
    COSINE_KNOTS, CosineCurve, PROFILE_KNOTS, ProfileCurve, SQUARE_KNOTS, SquareCurve,
};
use microbrdf_bits::{Raw, Sampled};

/// An arithmetic with its components as bits.
pub trait Given: Sampled {
    /// A component of any bits.
    fn any(bits: u32) -> Self::Component;
    /// Its bits.
    fn bits(component: Self::Component) -> u32;
}

/// One that traces rays.
pub trait Viewed: Given + Placing {
    /// A step of the camera, a rounded number.
    fn fine(number: f64) -> Self::Fine;
    /// A length, a rounded number.
    fn length(number: f64) -> Self::Length;
    /// Its bits.
    fn length_bits(length: Self::Length) -> u32;
    /// A flood whose light falls with the power `n`.
    ///
    /// # Errors
    /// `n` outside its range.
    fn flood(
        lamp: PointLight<Self>,
        back: Direction<Self>,
        n: u16,
    ) -> Result<FloodLight<Self>, ParameterError>;
}

/// One that draws directions.
pub trait Drawing: Given + Sampling<Radiance: Raw> {
    /// A random number from its 32 bits.
    fn uniform(bits: u32) -> Self::Uniform;
}

impl<M: Math> Given for Float<M> {
    fn any(bits: u32) -> f32 {
        f32::from_bits(bits)
    }
    fn bits(component: f32) -> u32 {
        // One bit pattern for what is not a number.
        if component.is_nan() {
            0x7FC0_0000
        } else {
            component.to_bits()
        }
    }
}

impl<const CELLS: usize> Given for Q31<CELLS> {
    fn any(bits: u32) -> I2F30 {
        I2F30::from_bits(bits as i32)
    }
    fn bits(component: I2F30) -> u32 {
        component.to_bits() as u32
    }
}

impl<const KNOTS: usize> Given for Q15<KNOTS> {
    fn any(bits: u32) -> I2F14 {
        I2F14::from_bits((bits >> 16) as i16)
    }
    fn bits(component: I2F14) -> u32 {
        component.to_bits() as u32
    }
}

impl<M: Math> Viewed for Float<M> {
    fn fine(number: f64) -> f32 {
        number as f32
    }
    fn length(number: f64) -> f32 {
        number as f32
    }
    fn length_bits(length: f32) -> u32 {
        Self::bits(length)
    }
    fn flood(
        lamp: PointLight<Self>,
        back: Direction<Self>,
        n: u16,
    ) -> Result<FloodLight<Self>, ParameterError> {
        FloodLight::<Self>::new(lamp, back, f32::from(n))
    }
}

impl<const CELLS: usize> Viewed for Q31<CELLS> {
    fn fine(number: f64) -> I24F40 {
        I24F40::from_num(number)
    }
    fn length(number: f64) -> I8F24 {
        I8F24::from_num(number)
    }
    fn length_bits(length: I8F24) -> u32 {
        length.to_bits() as u32
    }
    fn flood(
        lamp: PointLight<Self>,
        back: Direction<Self>,
        n: u16,
    ) -> Result<FloodLight<Self>, ParameterError> {
        FloodLight::<Self>::new(lamp, back, U32F32::from_num(n))
    }
}

impl<const KNOTS: usize> Viewed for Q15<KNOTS> {
    fn fine(number: f64) -> I24F40 {
        I24F40::from_num(number)
    }
    fn length(number: f64) -> I8F24 {
        I8F24::from_num(number)
    }
    fn length_bits(length: I8F24) -> u32 {
        length.to_bits() as u32
    }
    fn flood(
        lamp: PointLight<Self>,
        back: Direction<Self>,
        n: u16,
    ) -> Result<FloodLight<Self>, ParameterError> {
        FloodLight::<Self>::new(lamp, back, U32F32::from_num(n))
    }
}

impl Drawing for F32 {
    fn uniform(bits: u32) -> f32 {
        (bits >> 8) as f32 / (1 << 24) as f32
    }
}

impl<const CELLS: usize> Drawing for Q31<CELLS> {
    fn uniform(bits: u32) -> U0F32 {
        U0F32::from_bits(bits)
    }
}

/// A parameter with 16 fraction bits as fixed point takes it.
pub fn parameter(bits: u64) -> U32F32 {
    U32F32::from_bits(bits << 16)
}

/// A direction from components with 30 fraction bits.
pub fn direction<A: Given>([x, y, z]: [i32; 3]) -> Direction<A> {
    Direction::new(A::component(x), A::component(y), A::component(z))
}

/// Three curves that differ, bend, fall, and pass 1.
pub fn curve() -> CosineCurve {
    let mut entries = [[0; 3]; COSINE_KNOTS];
    for (index, entry) in entries.iter_mut().enumerate() {
        let cosine = CosineCurve::knot(index);
        *entry = [
            33_000 + 7 * cosine,
            60_000 - 200 * cosine,
            (cosine / 2) * (cosine / 2),
        ];
    }
    CosineCurve::from_entries(entries)
}

/// A profile that rises, falls and has an end of its own.
pub fn profile(halvings: u32) -> Result<ProfileCurve, ParameterError> {
    let mut knots = [0; PROFILE_KNOTS];
    for (index, knot) in knots.iter_mut().enumerate() {
        let index = index as u32;
        *knot = (1 << 31) - index * index % 1_999 * 1_000_003 - 12_345 * index;
    }
    ProfileCurve::new(knots, halvings)
}

/// A profile over the square of a distance that rises and falls, too; its reach
/// is 65536/`inverse`.
pub fn square(inverse: u16) -> Result<SquareCurve, ParameterError> {
    let mut knots = [0; SQUARE_KNOTS];
    for (index, knot) in knots.iter_mut().enumerate() {
        let index = index as u32;
        *knot = ((1 << 15) - index * index % 1_999 * 13 - 47 * index) as u16;
    }
    SquareCurve::new(knots, inverse)
}

/// An endless sequence of words (SplitMix64).
pub struct Words(u64);

impl Words {
    /// The sequence of a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next.
    pub fn word(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z ^ (z >> 31)) as u32
    }

    /// A component: of any bits, at an end, or of a usual size; longer than 1
    /// more often than not.
    pub fn component<A: Given>(&mut self, round: usize) -> A::Component {
        let word = self.word();
        match (round % 4, self.word() % 6) {
            (0, _) | (1, 0) => A::any(word),
            (1, 1) => A::any([0, 0x8000_0000, 0x7FFF_FFFF, 0x7F80_0000][word as usize % 4]),
            (1, 2) => A::component(if word & 1 == 0 { 1 << 30 } else { -(1 << 30) }),
            (2, _) => A::component((word >> 1) as i32 >> (word & 31)),
            _ => A::component(word as i32 >> 1),
        }
    }
}
