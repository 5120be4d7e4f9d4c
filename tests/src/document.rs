//! Documents that hold figures, made from what the tests hold to.

use std::fmt::Write as _;

use crate::curves::CURVES;
use crate::tolerance::{Exposure, TABLE, Tolerance};

/// `docs/accuracy.md`: the table of tolerances for people.
pub fn accuracy() -> String {
    let mut text = String::from(
        "# Accuracy\n\n\
         Made by `cargo run -p microbrdf-tests --bin accuracy`; `tests/tests/documents.rs` fails \
         when it is out of date.\n\n\
         Arithmetic error of the displayed 8-bit sRGB code (see [conventions.md](conventions.md)): \
         against double precision at the very directions and parameters that the arithmetic \
         holds. The greatest over seeded samples within the lobe, at the mirror direction, at \
         grazing (cosines down to 1e-8), all over both hemispheres, and below the horizon, for \
         every entry of `tests/src/registry.rs`: exponents 0 to 1e8, radii 1e-4 to 2, \
         sharpnesses 0 to 4096, six metals. 0.50 is perfect rounding. \
         `tests/tests/accuracy.rs` fails when a bound is passed, and when it lies more than 0.02 \
         above what is found.\n\n\
         K = 1 puts the peak at full scale; K = c is unit irradiance on the model's own peak.\n\n\
         | arithmetic | model | exposure | peak c in sr⁻¹ | greatest error, LSB | codes off by one, at most |\n\
         | --- | --- | --- | --- | --- | --- |\n",
    );
    for row in TABLE {
        let _ = writeln!(text, "{}", line(row));
    }
    text.push_str(
        "\nNo code is off by more than one but in the rows above 1.5 LSB: exposed at a peak above \
         2e4 (n > 1e5, s > 350), `q31` shows the last of a share's 31 bits and `q15` that of a \
         table's 25.\n",
    );
    text.push_str(
        "\n## Fresnel curves\n\n\
         Greatest error of a metal's tabulated reflectance, in any arithmetic, over every \
         cosine of 16 bits; `tests/tests/tables.rs` fails when it is passed, and when it lies \
         more than a twentieth above what is found. Chromium stands for metals of low, glass \
         for dielectrics of no absorption: a bound for these six, not for all.\n\n\
         | metal | fields | error |\n\
         | --- | --- | --- |\n",
    );
    for curve in CURVES {
        let _ = writeln!(
            text,
            "| {} | `{}` | {:.1e} |",
            curve.name, curve.fields, curve.error
        );
    }
    text
}

fn line(row: &Tolerance) -> String {
    let exposure = match row.exposure {
        Exposure::One => "K = 1",
        Exposure::Peak => "K = c",
    };
    let peaks = match row.peaks {
        [0.0, f64::INFINITY] => "any".to_owned(),
        [0.0, to] => format!("below {to:e}"),
        [from, _] => format!("from {from:e}"),
    };
    format!(
        "| `{}` | `{}` | {exposure} | {peaks} | {:.2} | {:.0} % |",
        row.arithmetic,
        row.model,
        row.lsb_max,
        100.0 * row.off_by_one
    )
}
