//! `microbrdf albedo`: the format of its lines, and their values.

mod support;

use support::run;

fn lines(material: &str, arithmetic: &str, more: &[&str]) -> Vec<(String, Vec<f64>)> {
    let mut arguments = vec!["albedo", "--material", material, "--arithmetic", arithmetic];
    arguments.extend(more);
    run(&arguments)
        .output()
        .lines()
        .map(|line| {
            let mut fields = line.split(',');
            let name = fields.next().expect("a first field").to_owned();
            let values = fields.map(|field| field.parse().expect(field)).collect();
            (name, values)
        })
        .collect()
}

#[test]
fn angles_come_as_they_were_given_and_the_mean_last() {
    for arithmetic in ["f32", "q31", "reference"] {
        let found = lines(
            "model = \"metallic-phong\", exponent = 20",
            arithmetic,
            &["--angles", "0,30,60,89.9,90", "--mean"],
        );
        let names: Vec<_> = found.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["0", "30", "60", "89.9", "90", "mean"]);
        for ((name, values), expected) in
            found
                .iter()
                .zip([1.0, 0.9702, 0.8713, 0.5254, 22.0 / 42.0, 0.906_856])
        {
            assert_eq!(values.len(), 1, "{name}");
            assert!(
                (values[0] - expected).abs() < 1e-4,
                "{arithmetic}, {name}: {} for {expected}",
                values[0]
            );
        }
    }
}

#[test]
fn metals_have_three_channels() {
    let gold = lines(
        "model = \"metal\", metal = \"gold\", exponent = 20",
        "q31",
        &["--angles", "15"],
    );
    let [(name, rgb)] = &gold[..] else {
        panic!("{gold:?}");
    };
    assert_eq!(name, "15");
    let [r, g, b] = rgb[..] else {
        panic!("{gold:?}");
    };
    assert!(r > g && g > b && b > 0.2 && r < 1.0, "{gold:?}");
}

/// A lambertian's albedo is its albedo, at every angle and on the mean.
#[test]
fn lambert() {
    for arithmetic in ["f32", "q31", "reference"] {
        let found = lines(
            "model = \"lambert\", albedo = [0.9, 0.5, 0.125]",
            arithmetic,
            &["--angles", "0,45,90", "--mean"],
        );
        assert_eq!(found.len(), 4);
        for (name, values) in found {
            for (value, expected) in values.iter().zip([0.9, 0.5, 0.125]) {
                assert!(
                    (value - expected).abs() < 1e-6,
                    "{arithmetic}, {name}: {values:?}"
                );
            }
        }
    }
}

#[test]
fn mistakes() {
    let with = |angles: &str| {
        let angles = format!("--angles={angles}");
        run(&[
            "albedo",
            "--material",
            "model = \"lambert\", albedo = 1",
            &angles,
        ])
    };
    for angle in ["90.1", "-1", "nan", "inf"] {
        with(&format!("0,{angle}")).mistake(&["--angles", "numbers from 0 to 90"]);
    }
    with("0,steep").mistake(&["--angles", "steep"]);
    with("").mistake(&["--angles"]);
    run(&["albedo", "--material", "model = \"lambert\", albedo = 1"]).mistake(&["--angles"]);
    run(&[
        "albedo",
        "--material",
        "model = \"metallic-phong\", exponent = 0.5",
        "--arithmetic",
        "q31",
        "--angles",
        "0",
    ])
    .mistake(&["exponent", "q31"]);
}
