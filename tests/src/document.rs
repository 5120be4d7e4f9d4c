//! Documents that hold figures, made from what the tests hold to.

use std::fmt::Write as _;

use crate::curves::CURVES;
use crate::steps::{BOUNDS, Step};
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
    text.push_str(&crate::grazing::section());
    text.push_str(&crate::broad::section());
    steps(&mut text);
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

/// The table of scalar steps.
fn steps(text: &mut String) {
    let names = ["f32", "micromath", "q31", "q15"];
    text.push_str(
        "\n## Scalar steps\n\n\
         Greatest error of each step over every input of 16 bits, spread over where the step is \
         not constant, each with 64 exponents, sharpnesses, powers, cosines, shares or gains; \
         2⁻¹² is 0.8 of a code. `tests/tests/exhaustive.rs` runs them all, and fails when a bound \
         is passed or lies more than a tenth above what is found.\n\n| step, error |",
    );
    for name in names {
        let _ = write!(text, " `{name}` |");
    }
    let _ = writeln!(text, "\n| --- |{}", " ---: |".repeat(names.len()));
    for step in Step::ALL {
        let _ = write!(text, "| {} |", step.name());
        for name in names {
            let bound = BOUNDS
                .iter()
                .find(|bound| bound.arithmetic == name && bound.step == step);
            let _ = match bound {
                Some(bound) => write!(text, " {:.1e} |", bound.error),
                None => write!(text, " |"),
            };
        }
        text.push('\n');
    }
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
