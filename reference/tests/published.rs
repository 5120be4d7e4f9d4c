//! Every number that the texts print, against an independent computation.

use microbrdf_reference::published::{csv_of, given, rows};

/// Rows whose given digits go beyond what their computation could resolve.
///
/// E3.11-angle-1: the albedo is so flat at its maximum that a search over it in doubles
/// can't tell 12.9057644° from 12.9057694°: they differ by 2e-19. The slope's root, to
/// 30 digits, is 12.90576439687°.
const BEYOND: [(&str, f64); 1] = [("E3.11-angle-1", 12.905_764_396_87)];

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
        let beyond = BEYOND.iter().find(|(id, _)| *id == row.id);
        if let Some((_, exact)) = beyond {
            assert!(!row.agrees, "{}: agrees after all", row.id);
            assert!(
                (row.value - exact).abs() < 1e-9,
                "{}: {}",
                row.id,
                row.value
            );
        } else {
            assert!(
                row.agrees,
                "{}: {} is not {}",
                row.id, row.value, given.computed
            );
        }
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
