//! Costs of single things from the costs of their sums.

use std::collections::BTreeMap;

/// Something measured, and how much of each thing is in it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sample {
    /// How often each thing is in it.
    pub counts: BTreeMap<String, f64>,
    /// What the whole takes.
    pub measured: f64,
    /// What an error counts beside, above 0: `measured`, or the mean of those
    /// samples that will be added up.
    pub scale: f64,
}

impl Sample {
    /// A sample by itself.
    #[must_use]
    pub fn alone(counts: BTreeMap<String, f64>, measured: f64) -> Self {
        Self {
            counts,
            measured,
            scale: measured,
        }
    }
}

/// What one of each thing costs.
pub type Costs = BTreeMap<String, f64>;

/// Turns of the descent; far more than change a result.
const TURNS: usize = 20_000;
/// Weight, beside a sample, of a cost of a whole: what samples can't tell
/// apart is shared out, not left to chance.
const EVEN: f64 = 1e-7;

/// The costs, none negative, with which the sums come nearest to what was
/// measured: least squares of relative errors.
///
/// Things that always come together can't be told apart; their sum is right.
#[must_use]
pub fn fit(samples: &[Sample]) -> Costs {
    let mut names: Vec<&str> = samples
        .iter()
        .flat_map(|sample| sample.counts.keys().map(String::as_str))
        .collect();
    names.sort_unstable();
    names.dedup();
    let rows: Vec<Vec<f64>> = samples
        .iter()
        .map(|sample| {
            let share =
                |name: &&str| sample.counts.get(*name).copied().unwrap_or(0.0) / sample.scale;
            names.iter().map(share).collect()
        })
        .collect();
    // Each column in its own unit, so that all are alike.
    let units: Vec<f64> = (0..names.len())
        .map(|j| rows.iter().map(|row| row[j]).fold(0.0, f64::max))
        .map(|greatest| if greatest > 0.0 { 1.0 / greatest } else { 0.0 })
        .collect();
    let scaled = |row: &Vec<f64>, j: usize| row[j] * units[j];
    let count = names.len();
    let mut gram = vec![vec![0.0; count]; count];
    let mut sums = vec![0.0; count];
    for (row, sample) in rows.iter().zip(samples) {
        let target = sample.measured / sample.scale;
        for i in 0..count {
            sums[i] += scaled(row, i) * target;
            for (j, cell) in gram[i].iter_mut().enumerate() {
                *cell += scaled(row, i) * scaled(row, j);
            }
        }
    }
    let mut found = vec![0.0_f64; count];
    for _ in 0..TURNS {
        for i in 0..count {
            let weight = gram[i][i] + EVEN;
            let others: f64 = gram[i].iter().zip(&found).map(|(g, x)| g * x).sum();
            let rest = sums[i] - (others - gram[i][i] * found[i]);
            found[i] = (rest / weight).max(0.0);
        }
    }
    let costs = found.iter().zip(&units).map(|(found, unit)| found * unit);
    names.into_iter().map(str::to_owned).zip(costs).collect()
}

/// The sum of the costs of all that is counted; `Err` names the first thing of
/// which no cost is known.
///
/// # Errors
/// The name.
pub fn sum<'a>(
    costs: &Costs,
    counts: impl IntoIterator<Item = (&'a String, &'a f64)>,
) -> Result<f64, String> {
    let mut sum = 0.0;
    for (name, count) in counts {
        let cost = costs.get(name).ok_or_else(|| name.clone())?;
        sum += cost * count;
    }
    Ok(sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(counts: &[(&str, f64)], measured: f64) -> Sample {
        let counts = counts.iter().map(|(n, c)| ((*n).to_owned(), *c));
        Sample::alone(counts.collect(), measured)
    }

    #[test]
    fn costs_of_exact_sums_are_found() {
        let samples = [
            sample(&[("a", 1.0), ("b", 10.0)], 1.0 * 100.0 + 10.0 * 7.0),
            sample(&[("a", 1.0), ("b", 30.0)], 1.0 * 100.0 + 30.0 * 7.0),
            sample(&[("a", 1.0), ("b", 20.0), ("c", 2.0)], 240.0 + 2.0 * 500.0),
        ];
        let costs = fit(&samples);
        for (name, cost) in [("a", 100.0), ("b", 7.0), ("c", 500.0)] {
            assert!((costs[name] - cost).abs() < 1e-3 * cost, "{costs:?}");
        }
        let found = sum(&costs, &samples[2].counts).expect("all are known");
        assert!((found - 1240.0).abs() < 0.1, "{found}");
    }

    #[test]
    fn nothing_costs_less_than_nothing() {
        let samples = [
            sample(&[("a", 1.0)], 100.0),
            sample(&[("a", 1.0), ("b", 1.0)], 90.0),
        ];
        let costs = fit(&samples);
        assert_eq!(costs["b"], 0.0);
        assert!((costs["a"] - 94.5).abs() < 0.5, "{costs:?}");
    }

    #[test]
    fn what_has_no_cost_is_named() {
        let costs = fit(&[sample(&[("a", 1.0)], 100.0)]);
        let counts = sample(&[("a", 1.0), ("new", 1.0)], 1.0).counts;
        assert_eq!(sum(&costs, &counts), Err("new".to_owned()));
    }
}
