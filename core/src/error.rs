//! Why a material could not be built.

use core::fmt;

/// A parameter outside its range; the only error that core has. It arises at
/// construction, never in evaluation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParameterError {
    /// Name of the parameter, as in the constructor's documentation.
    pub parameter: &'static str,
    /// What it must be.
    pub accepted: &'static str,
}

impl ParameterError {
    pub(crate) const fn new(parameter: &'static str, accepted: &'static str) -> Self {
        Self {
            parameter,
            accepted,
        }
    }
}

impl fmt::Display for ParameterError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} must be {}", self.parameter, self.accepted)
    }
}

impl core::error::Error for ParameterError {}

/// The value of a `Result` in a `const`: an error stops the compilation.
///
/// ```
/// use microbrdf::{arithmetic::Q31, brdf::MetallicPhong, constant};
/// use microbrdf::fixed::types::U32F32;
///
/// static SILVER: MetallicPhong<Q31> = constant!(MetallicPhong::<Q31>::new(U32F32::lit("60")));
/// ```
#[macro_export]
macro_rules! constant {
    ($result:expr) => {
        match $result {
            Ok(value) => value,
            Err(_) => panic!("a parameter is outside its range"),
        }
    };
}
