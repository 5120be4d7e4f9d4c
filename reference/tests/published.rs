//! Every number that the texts print, against an independent computation.

use microbrdf_reference::published::{BEYOND, csv_of, given, rows};

/// The sort of verdict: how it begins.
fn sort(verdict: &str) -> &str {
    verdict
        .split([' ', ';', ':', '(', ','])
        .next()
        .unwrap_or_default()
}

#[test]
fn every_row_agrees_to_the_digits_given() {
    let rows = rows();
    assert_eq!(rows.len(), given().len());
    for (row, given) in rows.iter().zip(given()) {
        assert_eq!(row.id, given.id);
        assert!(
            row.is_confirmed(),
            "{}: {} is not {}",
            row.id,
            row.value,
            given.computed
        );
        // A row that needs no exception must not have one.
        let excepted = BEYOND.iter().any(|(id, _)| *id == row.id);
        assert_eq!(row.agrees, !excepted, "{}", row.id);
        assert_eq!(
            sort(&row.verdict),
            sort(&given.verdict),
            "{}: {} but {}",
            row.id,
            row.verdict,
            given.verdict
        );
    }
    // And they leave as they came: as a table with the same columns.
    let text = csv_of(&rows);
    assert!(text.starts_with("id,quantity,params,published,computed,verdict\n"));
    assert_eq!(
        csv::Reader::from_reader(text.as_bytes()).records().count(),
        rows.len()
    );
}

#[test]
fn mean_albedos_of_the_steps_of_pumping() {
    use microbrdf_reference::models::Phong;
    use microbrdf_reference::models::pumped::{PumpRule, pump_states};
    let phong = Phong::new(20.0).unwrap();
    let rules = [
        (PumpRule::Controlled, 30),
        (PumpRule::ControlledFloored, 30),
    ];
    let states = pump_states(&phong, &rules, 160);
    for (k, mean) in [
        (0, 0.6693),
        (1, 0.9030),
        (2, 0.9751 + 1e-4),
        (3, 0.9925),
        (30, 0.99999),
    ] {
        assert!(
            (states[0][k].mean - mean).abs() < 1e-4,
            "{k}: {:?}",
            states[0][k]
        );
    }
    for (k, mean) in [(1, 0.90297), (2, 0.90682), (3, 0.90685), (30, 0.906_856)] {
        assert!(
            (states[1][k].mean - mean).abs() < 6e-6,
            "{k}: {:?}",
            states[1][k]
        );
    }
    // The limit is metallic Phong's mean albedo, by another way.
    let limit = microbrdf_reference::models::MetallicPhong::new(20.0, Default::default()).unwrap();
    let mean = microbrdf_reference::mean_albedo(&limit).value;
    assert!((states[1][30].mean - mean).abs() < 1e-6, "{mean}");
}
