//! Every number that the texts print, computed again.
//!
//! `data/published.csv` holds the printed value of each row and the same quantity from an
//! independent computation; [`rows`] computes it a third time, with this crate.

mod compute;
mod verdict;

use std::sync::OnceLock;

/// The table: id, quantity, params, published, computed, verdict.
pub const DATA: &str = include_str!("../../data/published.csv");

/// Rows whose given digits go beyond what their computation could resolve, with the
/// value that can be had.
///
/// E3.11-angle-1: the albedo is so flat at its maximum that a search over it in doubles
/// can't tell 12.9057644° from 12.9057694°: they differ by 2e-19. The slope's root, to
/// 30 digits, is 12.90576439687°.
pub const BEYOND: [(&str, f64); 1] = [("E3.11-angle-1", 12.905_764_396_87)];

/// A row as it is in the data.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Given {
    /// The row's name.
    pub id: String,
    /// What is computed.
    pub quantity: String,
    /// Its parameters.
    pub params: String,
    /// The printed value, as text.
    pub published: String,
    /// The independent computation, as text: its digits are what this crate must meet.
    pub computed: String,
    /// The verdict that goes with it.
    pub verdict: String,
}

/// A row as computed here.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The row's name.
    pub id: String,
    /// What is computed.
    pub quantity: String,
    /// Its parameters.
    pub params: String,
    /// The printed value, as text.
    pub published: String,
    /// This crate's value, to ten digits.
    pub computed: String,
    /// What follows for the printed value.
    pub verdict: String,
    /// This crate's value.
    pub value: f64,
    /// Whether `value` agrees with the independent computation to the digits given there.
    pub agrees: bool,
}

impl Row {
    /// Whether the value is what it should be: that of the independent computation, or
    /// the better one of [`BEYOND`] within 1e-9.
    pub fn is_confirmed(&self) -> bool {
        let better = BEYOND.iter().find(|(id, _)| *id == self.id);
        better.map_or(self.agrees, |(_, exact)| (self.value - exact).abs() < 1e-9)
    }
}

/// The rows of the data, in their order.
pub fn given() -> &'static [Given] {
    static GIVEN: OnceLock<Vec<Given>> = OnceLock::new();
    GIVEN.get_or_init(|| {
        csv::Reader::from_reader(DATA.as_bytes())
            .records()
            .map(|record| {
                let record = record.expect("published.csv is well-formed");
                let field = |i: usize| record.get(i).unwrap_or_default().to_owned();
                Given {
                    id: field(0),
                    quantity: field(1),
                    params: field(2),
                    published: field(3),
                    computed: field(4),
                    verdict: field(5),
                }
            })
            .collect()
    })
}

/// Computes every row. Takes some seconds; `progress` is told how many are done, of how many.
pub fn rows_with(progress: &mut dyn FnMut(usize, usize)) -> Vec<Row> {
    let all = given();
    let mut computer = compute::Computer::default();
    let mut rows = Vec::with_capacity(all.len());
    for (i, given) in all.iter().enumerate() {
        progress(i, all.len());
        rows.push(row(given, computer.value(given)));
    }
    progress(all.len(), all.len());
    rows
}

/// Computes every row.
pub fn rows() -> Vec<Row> {
    rows_with(&mut |_, _| {})
}

/// The rows as CSV, with the data's own columns.
pub fn csv_of(rows: &[Row]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let header = [
        "id",
        "quantity",
        "params",
        "published",
        "computed",
        "verdict",
    ];
    writer.write_record(header).expect("writing to memory");
    for r in rows {
        let fields = [
            &r.id,
            &r.quantity,
            &r.params,
            &r.published,
            &r.computed,
            &r.verdict,
        ];
        writer.write_record(fields).expect("writing to memory");
    }
    String::from_utf8(writer.into_inner().expect("flushed")).expect("text")
}

fn row(given: &Given, value: f64) -> Row {
    Row {
        id: given.id.clone(),
        quantity: given.quantity.clone(),
        params: given.params.clone(),
        published: given.published.clone(),
        computed: verdict::ten_digits(value),
        verdict: verdict::verdict(&given.id, &given.published, value),
        value,
        agrees: verdict::agrees(&given.computed, value),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn the_data_are_read() {
        assert_eq!(given().len(), DATA.trim_end().lines().count() - 1);
        let ids: BTreeSet<_> = given().iter().map(|g| &g.id).collect();
        assert_eq!(ids.len(), given().len(), "ids are unique");
    }

    #[test]
    fn the_copy_is_the_original_where_that_exists() {
        let mut places = Vec::new();
        for name in ["published.csv", "metals.csv"] {
            let original = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/papers/");
            let original = format!("{original}{name}");
            let Ok(text) = std::fs::read_to_string(&original) else {
                eprintln!("skipped: there is no {name} beside the repository");
                continue;
            };
            let copy = concat!(env!("CARGO_MANIFEST_DIR"), "/data/");
            let copy = std::fs::read_to_string(format!("{copy}{name}")).expect("the copy");
            assert!(text == copy, "data/{name} differs from its original");
            places.push(name);
        }
        eprintln!("compared: {places:?}");
    }
}
