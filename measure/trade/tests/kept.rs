//! What is kept in the repository is what this crate makes.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use microbrdf_kernels::{kernels, profile::PROFILE};
use microbrdf_scene::Material;
use microbrdf_trade::row::{self, Row};
use microbrdf_trade::subject::Subject;
use microbrdf_trade::{curve, document, goals, plot, samples};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn text(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn rows() -> Vec<Row> {
    row::read(&root().join("host-sim/data/trade.json")).expect("the kept figures")
}

#[test]
fn the_document_and_its_plots_show_the_kept_figures() {
    let rows = rows();
    assert!(
        text("docs/trade.md") == document::markdown(&rows),
        "docs/trade.md is out of date: cargo xtask measure"
    );
    for (core, _) in document::CORES {
        if rows.iter().any(|row| row.core == core) {
            let path = format!("docs/{}", plot::file(core));
            assert!(text(&path) == plot::svg(&rows, core), "{path}");
        }
    }
}

#[test]
fn goals_are_reached_and_a_miss_is_told() {
    let mut rows = rows();
    assert_eq!(goals::missed(&rows), [""; 0]);
    for row in &mut rows {
        if row.core == "cortex-m4f" && !row.kernel.starts_with("powf_libm") {
            row.cycles_mean *= 2.0;
        }
    }
    let missed = goals::missed(&rows);
    // Each of the table, and the factor of each exponent.
    assert_eq!(missed.len(), 7 + 3, "{missed:?}");
}

#[test]
fn every_kernel_is_in_the_document_s_figures_and_no_other() {
    let names: BTreeSet<_> = kernels().map(|kernel| kernel.name.to_owned()).collect();
    assert_eq!(names.len(), kernels().count(), "two kernels of one name");
    let rows = rows();
    for (core, _) in document::CORES {
        let kept: BTreeSet<_> = rows
            .iter()
            .filter(|row| row.core == core)
            .map(|row| row.kernel.clone())
            .collect();
        assert!(
            kept == names,
            "{core}: {:?}",
            kept.symmetric_difference(&names)
        );
    }
    let headed = document::markdown(&rows);
    for row in &rows {
        let title = document::title(&row.model);
        assert!(headed.contains(&format!("\n## {title}\n")), "{}", row.model);
    }
}

#[test]
fn curves_are_what_a_scene_would_bake() {
    for of in curve::Of::ALL {
        let path = format!("measure/kernels/src/{}.rs", of.file());
        assert!(
            text(&path) == of.source(),
            "cargo run -p microbrdf-trade -- curve {} > {path}",
            of.file()
        );
    }
}

#[test]
fn the_profile_is_what_a_scene_would_bake() {
    let kernel = kernels().find(|kernel| kernel.model == "profile");
    let fields = kernel.expect("a kernel of a profile").fields;
    match Material::from_argument(&format!("model = \"profile\", {fields}")) {
        Ok(Material::PatchProfile { profile }) => assert!(profile.curve() == PROFILE),
        other => panic!("{other:?} is no profile"),
    }
}

#[test]
fn exposed_at_the_peak_means_the_model_s_own() {
    for subject in kernels().filter_map(Subject::new) {
        let kernel = subject.kernel;
        let k = match kernel.exposure {
            "1" => 1.0,
            _ => subject.peak(),
        };
        let off = (kernel.k / k - 1.0).abs();
        assert!(off < 1e-6, "{}: {} is not {k}", kernel.name, kernel.k);
    }
}

#[test]
fn calls_within_the_lobe_are_lit_and_those_below_the_horizon_are_not() {
    for kernel in kernels().filter(|kernel| kernel.name.ends_with("_k1")) {
        let calls = samples::of(kernel, 64);
        let lit = |kind: &str| {
            let group = calls.groups.iter().find(|group| group.kind == kind);
            let group = group.unwrap_or_else(|| panic!("{}: no {kind}", kernel.name));
            assert!(group.calls.len() >= 4, "{}: {kind}", kernel.name);
            let lit = group
                .calls
                .iter()
                .filter(|c| c.results.iter().any(|r| *r > 0));
            lit.count() as f64 / group.calls.len() as f64
        };
        assert_eq!(lit("unlit"), 0.0, "{}", kernel.name);
        // The faintest light rounds to nothing: of 16 bits sooner than of 24.
        let short = kernel.variant.contains("gain in the table");
        let least = if short { 0.5 } else { 0.7 };
        assert!(lit("lobe") > least, "{}: {}", kernel.name, lit("lobe"));
    }
}
