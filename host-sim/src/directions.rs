//! Directions on standard input.

use std::io::BufRead;

use crate::exit::{Failure, Outcome};

/// L and V of one line, normalised.
pub type Pair = [[f64; 3]; 2];

/// Calls `each` with every pair of a CSV of lines `lx,ly,lz,vx,vy,vz`.
///
/// Empty lines are passed over. The first malformed line ends it with its
/// number; what came before it has been handed over.
pub fn read(input: impl BufRead, mut each: impl FnMut(Pair) -> Outcome<()>) -> Outcome<()> {
    for (index, line) in input.lines().enumerate() {
        let fault = |message: String| {
            Failure::Usage(format!("standard input, line {}: {message}", index + 1))
        };
        let line = line.map_err(|error| fault(error.to_string()))?;
        if line.trim().is_empty() {
            continue;
        }
        each(parse(&line).map_err(fault)?)?;
    }
    Ok(())
}

fn parse(line: &str) -> Result<Pair, String> {
    let fields: Vec<_> = line.split(',').map(str::trim).collect();
    if fields.len() != 6 {
        return Err(format!(
            "{} fields: must be 6, lx,ly,lz,vx,vy,vz",
            fields.len()
        ));
    }
    let mut numbers = [0.0; 6];
    for (number, field) in numbers.iter_mut().zip(&fields) {
        *number = match field.parse::<f64>() {
            Ok(value) if value.is_finite() => value,
            _ => return Err(format!("{field:?}: must be a finite number")),
        };
    }
    let [lx, ly, lz, vx, vy, vz] = numbers;
    Ok([
        normalised([lx, ly, lz], "l")?,
        normalised([vx, vy, vz], "v")?,
    ])
}

fn normalised(vector: [f64; 3], name: &str) -> Result<[f64; 3], String> {
    // Scaled first, so that no square overflows or vanishes.
    let greatest = vector
        .iter()
        .fold(0.0f64, |greatest, c| greatest.max(c.abs()));
    if greatest == 0.0 {
        return Err(format!("{name} = 0,0,0: must be longer than 0"));
    }
    let scaled = vector.map(|c| c / greatest);
    let length = scaled.iter().map(|c| c * c).sum::<f64>().sqrt();
    Ok(scaled.map(|c| c / length))
}
