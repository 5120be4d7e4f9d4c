//! Arithmetics by name.

use clap::ValueEnum;

/// How the core computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ArithmeticName {
    /// Single precision with libm.
    F32,
    /// 32-bit fixed point.
    Q31,
}

impl ArithmeticName {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::F32, Self::Q31];

    /// The name on command lines and on the wire.
    pub fn name(self) -> &'static str {
        use microbrdf::arithmetic::{Arithmetic, F32, Q31};
        match self {
            Self::F32 => F32::NAME,
            Self::Q31 => Q31::<1024>::NAME,
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
            $crate::arithmetic::ArithmeticName::Q31 => {
                type $marker = microbrdf::arithmetic::Q31;
                $result
            }
        }
    };
}
