//! What a scene took, beside what was forecast.

use std::path::Path;

use serde_json::{Value, json};

use super::{Program, Rows, rows};
use crate::board::Board;
use crate::failure::{During, Outcome};
use crate::firmware::Order;
use crate::host_sim::HostSim;
use crate::layout::Layout;
use crate::toolchain::Cross;

/// By how much a forecast may be off: bytes and stack of what was measured, cycles of what was counted. Flash: 5 %, and the 1 % by which an image differs from machine to machine, because it holds the paths of its crates.
const BOUNDS: [(&str, f64); 4] = [
    ("flash_bytes", 0.06),
    ("ram_bytes", 0.05),
    ("stack_bytes", 0.15),
    ("cycles_per_pixel", 0.15),
];

/// Whether an arithmetic's costs are measured on a board: fixed point on all, single precision where there is an FPU.
pub fn is_forecast(board: Board, arithmetic: &str) -> bool {
    match arithmetic {
        "q31" | "q15" => true,
        "f32" => board.core == "cortex-m4f",
        _ => false,
    }
}

/// Adds to a run's report what was forecast for it, and the cycles of one of `every` rows; the run's picture is in `out`.
pub fn add(
    layout: &Layout,
    cross: &Cross,
    host: &HostSim<'_>,
    program: &Program<'_>,
    (order, out): (&Order, &Path),
    every: usize,
    report: &mut Value,
) -> Outcome<()> {
    let counted = Rows {
        scene: order.scene.clone(),
        arithmetic: order.arithmetic.clone(),
        target: order.board.target,
        every,
        picture: Some(out.join("device.png")),
    };
    let counts = counted.count(layout, cross, program)?;
    let cycles = rows::cycles(&counts, order.board.core)?;
    let size = |field: &str| report[field].as_u64().unwrap_or(0) as usize;
    let counted: Vec<usize> = rows::numbers(size("height"), every).collect();
    let pixels = (size("width") * cycles.len()) as f64;
    report["cycles_per_pixel"] = json!(cycles.iter().sum::<f64>() / pixels);
    let text = host.run([
        "budget".as_ref(),
        order.scene.as_os_str(),
        "--board".as_ref(),
        order.board.name.as_ref(),
        "--arithmetic".as_ref(),
        order.arithmetic.as_ref(),
        "--json".as_ref(),
    ])?;
    let forecast: Value =
        serde_json::from_str(&text).during(|| "reading the budget".to_string())?;
    let mut forecast = forecast[0].clone();
    // Of the same rows.
    let of_rows = &forecast["cycles_per_pixel_of_rows"];
    let of_row = |row: &usize| of_rows[*row].as_f64().unwrap_or(f64::NAN);
    let sum: f64 = counted.iter().map(of_row).sum();
    forecast["cycles_per_pixel"] = if counted.len() == cycles.len() {
        json!(sum / counted.len() as f64)
    } else {
        Value::Null
    };
    report["forecast"] = forecast;
    Ok(())
}

/// One line: each figure, and the forecast.
pub fn line(report: &Value) -> String {
    let figures = BOUNDS.map(|(field, _)| {
        let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
        let (took, forecast) = (number(&report[field]), number(&report["forecast"][field]));
        format!(
            "{} {took:.0}, {forecast:.0} ({:+.1} %)",
            field.replace('_', " "),
            100.0 * (forecast / took - 1.0)
        )
    });
    format!("forecast   {}\n", figures.join("; "))
}

/// Where a forecast is off by more than it may be.
pub fn faults(report: &Value) -> Vec<String> {
    BOUNDS
        .into_iter()
        .filter_map(|(field, bound)| {
            let took = report[field].as_f64();
            let forecast = report["forecast"][field].as_f64();
            // A figure that is missing is not a good one.
            let within = took
                .zip(forecast)
                .is_some_and(|(took, forecast)| (forecast - took).abs() <= bound * took);
            (!within).then(|| {
                format!(
                    "{field} is {}, its forecast {}: may be off by {} %",
                    report[field],
                    report["forecast"][field],
                    100.0 * bound
                )
            })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_forecast_that_is_off_is_told() {
        let took = json!({
            "flash_bytes": 40_000, "ram_bytes": 2_000, "stack_bytes": 1_000,
            "cycles_per_pixel": 500.0,
            "forecast": {
                "flash_bytes": 41_000, "ram_bytes": 2_000, "stack_bytes": 1_100,
                "cycles_per_pixel": 430.0,
            },
        });
        assert_eq!(faults(&took), Vec::<String>::new());
        assert!(line(&took).contains("flash bytes 40000, 41000 (+2.5 %)"));
        for (field, value) in [
            ("flash_bytes", json!(42_500)),
            ("ram_bytes", json!(1_800)),
            ("stack_bytes", json!(800)),
            ("cycles_per_pixel", json!(580)),
            ("cycles_per_pixel", Value::Null),
        ] {
            let mut off = took.clone();
            off["forecast"][field] = value;
            let faults = faults(&off);
            assert_eq!(faults.len(), 1, "{faults:?}");
            assert!(faults[0].contains(field), "{faults:?}");
        }
    }
}
