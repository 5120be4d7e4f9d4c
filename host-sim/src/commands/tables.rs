//! `microbrdf tables`.

use microbrdf_reference::published::{self, Row};

use super::print;
use crate::cli::Tables;
use crate::exit::{Failure, Outcome};
use crate::progress::Progress;

const HEADER: [&str; 6] = [
    "id",
    "quantity",
    "params",
    "published",
    "computed",
    "verdict",
];
/// A column is as wide as its widest cell, but no wider than this; a longer cell
/// shifts what follows in its row.
const WIDEST: usize = 42;

/// Computes every printed number again, and prints both.
pub fn run(arguments: &Tables) -> Outcome<()> {
    let rows = computed();
    print(&if arguments.csv {
        published::csv_of(&rows)
    } else {
        aligned(&rows)
    })?;
    check(&rows)
}

fn computed() -> Vec<Row> {
    let progress = Progress::new("rows", published::given().len());
    published::rows_with(&mut |done, _| {
        if done > 0 {
            progress.step();
        }
    })
}

/// Fails where a value is not confirmed by the independent computation in the data.
fn check(rows: &[Row]) -> Outcome<()> {
    let differing: Vec<_> = rows
        .iter()
        .filter(|row| !row.is_confirmed())
        .map(|row| row.id.as_str())
        .collect();
    if differing.is_empty() {
        return Ok(());
    }
    Err(Failure::Incomplete(format!(
        "{} of {} rows differ from the independent computation: {}",
        differing.len(),
        rows.len(),
        differing.join(", ")
    )))
}

fn aligned(rows: &[Row]) -> String {
    let mut cells = vec![HEADER];
    cells.extend(rows.iter().map(|row| {
        [
            row.id.as_str(),
            &row.quantity,
            &row.params,
            &row.published,
            &row.computed,
            &row.verdict,
        ]
    }));
    let length = |text: &str| text.chars().count();
    let widths = [0, 1, 2, 3, 4].map(|column| {
        let lengths = cells.iter().map(|row| length(row[column]));
        lengths.filter(|n| *n <= WIDEST).max().unwrap_or(0)
    });
    let mut text = String::new();
    for row in cells {
        for (cell, width) in row.iter().zip(widths) {
            text.push_str(cell);
            text.push_str(&" ".repeat(width.saturating_sub(length(cell)) + 2));
        }
        text.push_str(row[5]);
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(id: &str, agrees: bool) -> Row {
        Row {
            id: id.to_owned(),
            quantity: "albedo – mean".to_owned(),
            params: "n=1".to_owned(),
            published: "0.7".to_owned(),
            computed: "0.71".to_owned(),
            verdict: "truncated, \"roughly\"".to_owned(),
            value: 0.71,
            agrees,
        }
    }

    #[test]
    fn columns_stand_below_each_other() {
        let long = Row {
            params: "x".repeat(WIDEST + 1),
            ..row("L", true)
        };
        let text = aligned(&[row("A", true), long, row("LONGER", true)]);
        let lines: Vec<_> = text.lines().collect();
        let column = |line: &str, of: &str| {
            line.chars().count() - line[line.find(of).unwrap()..].chars().count()
        };
        assert_eq!(column(lines[0], "published"), column(lines[1], "0.7"));
        assert_eq!(column(lines[1], "0.71"), column(lines[3], "0.71"));
        assert!(lines[2].contains(&"x".repeat(WIDEST + 1)));
        assert_eq!(lines.len(), 4);
    }

    #[test]
    fn a_row_that_differs_is_named() {
        assert!(check(&[row("A", true)]).is_ok());
        let failure = check(&[row("A", true), row("B", false)]).unwrap_err();
        assert_eq!(failure.status(), 1);
        assert!(failure.to_string().ends_with(": B"), "{failure}");
    }
}
