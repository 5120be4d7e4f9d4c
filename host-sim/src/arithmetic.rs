//! Arithmetics by name.

use clap::ValueEnum;

/// How the core computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ArithmeticName {
    /// Single precision with libm.
    F32,
    /// Single precision with micromath.
    Micromath,
    /// 32-bit fixed point.
    Q31,
    /// 16-bit fixed point.
    Q15,
}

impl ArithmeticName {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::F32, Self::Micromath, Self::Q31, Self::Q15];

    /// The name on command lines and on the wire.
    pub fn name(self) -> &'static str {
        use microbrdf::arithmetic::{Arithmetic, F32, Micromath, Q15, Q31};
        match self {
            Self::F32 => F32::NAME,
            Self::Micromath => Micromath::NAME,
            Self::Q31 => <Q31>::NAME,
            Self::Q15 => <Q15>::NAME,
        }
    }
}

/// `$result` with `$marker` naming the type of the arithmetic.
#[macro_export]
macro_rules! with_arithmetic {
    ($name:expr, $marker:ident => $result:expr) => {
        match $name {
            $crate::arithmetic::ArithmeticName::F32 => {
                type $marker = microbrdf::arithmetic::F32;
                $result
            }
            $crate::arithmetic::ArithmeticName::Micromath => {
                type $marker = microbrdf::arithmetic::Micromath;
                $result
            }
            $crate::arithmetic::ArithmeticName::Q31 => {
                type $marker = microbrdf::arithmetic::Q31;
                $result
            }
            $crate::arithmetic::ArithmeticName::Q15 => {
                type $marker = microbrdf::arithmetic::Q15;
                $result
            }
        }
    };
}
