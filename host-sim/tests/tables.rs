//! `microbrdf tables`: every printed number, computed again.

mod support;

use microbrdf_reference::published;
use support::run;

#[test]
fn csv_holds_every_row_and_agrees_with_the_data() {
    let text = run(&["tables", "--csv"]).output();
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header: Vec<_> = reader
        .headers()
        .expect("a header")
        .iter()
        .map(str::to_owned)
        .collect();
    assert_eq!(
        header,
        [
            "id",
            "quantity",
            "params",
            "published",
            "computed",
            "verdict"
        ]
    );
    let rows: Vec<_> = reader
        .records()
        .map(|row| row.expect("six fields"))
        .collect();
    let given = published::given();
    assert_eq!(rows.len(), given.len());
    for (row, given) in rows.iter().zip(given) {
        assert_eq!(
            [&row[0], &row[1], &row[2], &row[3]],
            [&given.id, &given.quantity, &given.params, &given.published].map(String::as_str)
        );
        let ours: f64 = row[4].parse().expect("a number");
        let theirs: f64 = given.computed.parse().expect("a number");
        // Half a unit of the last digit that the data have, or of ten digits.
        let (mantissa, power) = given
            .computed
            .split_once('e')
            .unwrap_or((&given.computed, "0"));
        let decimals = mantissa
            .split_once('.')
            .map_or(0, |(_, digits)| digits.len() as i32);
        let unit = 10f64.powi(power.parse::<i32>().expect("a power") - decimals);
        let tolerance = 0.51 * unit + 1e-9 * theirs.abs();
        // Better known than the data have it: see the list.
        let better = published::BEYOND.iter().find(|(id, _)| *id == given.id);
        let theirs = better.map_or(theirs, |(_, exact)| *exact);
        assert!(
            (ours - theirs).abs() <= tolerance,
            "{}: {ours} {theirs}",
            given.id
        );
        assert!(!row[5].is_empty(), "{}", given.id);
    }
}

#[test]
fn help_has_an_example() {
    let help = run(&["tables", "--help"]).output();
    assert!(help.contains("microbrdf tables --csv"), "{help}");
    run(&["tables", "--cvs"]).mistake(&["--cvs"]);
}
