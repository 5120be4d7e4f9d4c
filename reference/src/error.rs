//! What a constructor says when a parameter is outside its range.

/// A parameter that a model can't take. Evaluation never fails; construction can.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{parameter} = {value}: must be {accepted}")]
pub struct ParameterError {
    /// The parameter's name, as in the constructor.
    pub parameter: &'static str,
    /// The value that was given, as text.
    pub value: String,
    /// The accepted range, as text.
    pub accepted: String,
}

impl ParameterError {
    /// An error for `parameter` with the offending value and the accepted range.
    pub fn new(parameter: &'static str, value: impl ToString, accepted: impl ToString) -> Self {
        Self {
            parameter,
            value: value.to_string(),
            accepted: accepted.to_string(),
        }
    }
}

/// `value` if it is finite and in `low ..= high`.
pub(crate) fn within(
    parameter: &'static str,
    value: f64,
    low: f64,
    high: f64,
) -> Result<f64, ParameterError> {
    if value.is_finite() && value >= low && value <= high {
        return Ok(value);
    }
    let accepted = if high == f64::INFINITY {
        format!("finite and at least {low}")
    } else {
        format!("in {low} to {high}")
    };
    Err(ParameterError::new(parameter, value, accepted))
}

/// `value` if it is finite and in `low < value <= high`.
pub(crate) fn above(
    parameter: &'static str,
    value: f64,
    low: f64,
    high: f64,
) -> Result<f64, ParameterError> {
    if value.is_finite() && value > low && value <= high {
        return Ok(value);
    }
    let accepted = if high == f64::INFINITY {
        format!("finite and above {low}")
    } else {
        format!("above {low} and at most {high}")
    };
    Err(ParameterError::new(parameter, value, accepted))
}

/// All three channels in `low ..= high`.
pub(crate) fn channels_within(
    parameter: &'static str,
    value: [f64; 3],
    low: f64,
    high: f64,
) -> Result<[f64; 3], ParameterError> {
    for c in value {
        within(parameter, c, low, high)?;
    }
    Ok(value)
}
