//! `microbrdf advise`.

use std::fmt::Write as _;
use std::path::PathBuf;

use microbrdf_scene::Material;

use super::print;
use crate::advice::{Cost, PixelError, costs, error_of};
use crate::cli::Advise;
use crate::exit::{Failure, Outcome};
use crate::progress::Progress;

/// A way to compute, what it costs and how exact it is.
struct Candidate {
    cost: Cost,
    error: Result<PixelError, String>,
}

impl Candidate {
    /// Why it does not do, or nothing.
    fn fault(&self, arguments: &Advise) -> Option<String> {
        match &self.error {
            Err(reason) => Some(reason.clone()),
            Ok(error) if error.lsb_max > arguments.max_error => {
                Some(format!("off by more than {} LSB", arguments.max_error))
            }
            Ok(_) => arguments
                .max_bytes
                .filter(|most| self.cost.bytes() > *most)
                .map(|most| format!("takes more than {most} bytes")),
        }
    }

    fn name(&self) -> String {
        let arithmetic = &self.cost.arithmetic;
        match (self.cost.size, self.cost.exposed) {
            (Some(size), true) => {
                format!("{arithmetic} with tables of {size}, for one light whose gain they hold")
            }
            (Some(size), false) => format!("{arithmetic} with tables of {size}"),
            (None, _) => arithmetic.clone(),
        }
    }

    fn line(&self) -> String {
        let Cost {
            cycles,
            code,
            tables,
            estimate,
            measured,
            ..
        } = &self.cost;
        let kind = if *estimate { "estimated" } else { "exact" };
        let error = match &self.error {
            Ok(error) => format!(
                "pixel error at most {:.2} LSB, {:.1} % of codes off",
                error.lsb_max,
                100.0 * error.off
            ),
            Err(_) => "no pixel error".to_owned(),
        };
        format!(
            "{}: {cycles:.0} cycles ({kind}, of {measured}), {code} bytes of code and {tables} \
             of tables; {error}",
            self.name()
        )
    }
}

/// Prints the cheapest way that holds the bounds, and the others.
pub fn run(arguments: &Advise) -> Outcome<()> {
    if !(arguments.max_error >= 0.5 && arguments.max_error <= 255.0) {
        return Err(Failure::Usage(format!(
            "--max-error {}: must be a number from 0.5, perfect rounding, to 255",
            arguments.max_error
        )));
    }
    if !(1e-3..=2e7).contains(&arguments.exposure) {
        return Err(Failure::Usage(format!(
            "--exposure {}: must be a number from 1e-3 to 2e7",
            arguments.exposure
        )));
    }
    let material = Material::from_argument(&arguments.material)?;
    let costs = costs(&data(arguments)?, &arguments.core, &material).map_err(Failure::Usage)?;
    let progress = Progress::new("ways to compute", costs.len());
    let mut candidates: Vec<_> = costs
        .into_iter()
        .map(|cost| {
            let error = error_of(&cost, &material, arguments.exposure);
            progress.step();
            Candidate {
                cost,
                error: match error {
                    Some(error) => error.map_err(|reason| reason.to_string()),
                    None => Err("is not built into this program".to_owned()),
                },
            }
        })
        .collect();
    drop(progress);
    candidates.sort_by(|a, b| {
        let key = |c: &Candidate| (c.cost.cycles, c.cost.bytes() as f64);
        key(a)
            .partial_cmp(&key(b))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    let (holding, failing): (Vec<_>, Vec<_>) = candidates
        .iter()
        .partition(|candidate| candidate.fault(arguments).is_none());
    let mut text = String::new();
    if let Some(best) = holding.first() {
        let _ = writeln!(text, "{}", best.line());
        let _ = writeln!(
            text,
            "\nWhy: the fewest cycles, and then bytes, of those that hold the bounds{}.",
            holding.get(1).map_or(String::new(), |next| format!(
                "; the next, {}, takes {:.0} cycles more and {} bytes {}",
                next.name(),
                next.cost.cycles - best.cost.cycles,
                next.cost.bytes().abs_diff(best.cost.bytes()),
                if next.cost.bytes() < best.cost.bytes() {
                    "fewer"
                } else {
                    "more"
                },
            ))
        );
    }
    if holding.len() > 1 {
        text.push_str("\nRunners-up:\n");
        for candidate in &holding[1..] {
            let _ = writeln!(text, "  {}", candidate.line());
        }
    }
    if !failing.is_empty() {
        text.push_str("\nRuled out:\n");
        for candidate in &failing {
            let fault = candidate.fault(arguments).unwrap_or_default();
            let _ = writeln!(text, "  {}: {fault}", candidate.line());
        }
    }
    print(text.trim_start())?;
    if holding.is_empty() {
        return Err(Failure::Incomplete(
            "nothing that was measured holds the bounds".to_owned(),
        ));
    }
    Ok(())
}

/// The measured data.
fn data(arguments: &Advise) -> Outcome<String> {
    match &arguments.data {
        Some(path) => std::fs::read_to_string(path)
            .map_err(|error| Failure::Usage(format!("--data {}: {error}", path.display()))),
        None => {
            let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), "data", "trade.json"]
                .iter()
                .collect();
            std::fs::read_to_string(&path).map_err(|error| {
                Failure::Environment(format!(
                    "{}: {error}; `cargo xtask measure` makes it, --data names another",
                    path.display()
                ))
            })
        }
    }
}
