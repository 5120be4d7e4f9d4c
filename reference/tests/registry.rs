//! A model can't be left out: of the list, of its own tests, or of the documentation.

use microbrdf_reference::models::ALL;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Files in `models/` that are not models.
const SUPPORT: [&str; 5] = ["mod", "entry", "metric", "registry", "tint"];

fn files() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/models");
    fs::read_dir(folder)
        .expect("the models' folder")
        .map(|e| e.expect("an entry").path())
        .filter(|p| p.extension().is_some_and(|e| e == "rs"))
        .map(|p| {
            let name = p
                .file_stem()
                .expect("a stem")
                .to_string_lossy()
                .into_owned();
            (name, fs::read_to_string(&p).expect("a readable file"))
        })
        .filter(|(name, _)| !SUPPORT.contains(&name.as_str()))
        .collect()
}

#[test]
fn every_file_is_in_the_list_and_the_other_way_round() {
    let files: BTreeSet<String> = files().into_iter().map(|f| f.0).collect();
    let listed: BTreeSet<String> = ALL.iter().map(|m| m.name.to_owned()).collect();
    assert_eq!(files, listed);
    let mut names: Vec<_> = ALL.iter().map(|m| m.name).collect();
    names.dedup();
    assert!(names.is_sorted() && names.len() == ALL.len());
}

#[test]
fn every_file_has_the_same_shape() {
    for (name, text) in files() {
        let lines = text.lines().count();
        assert!(lines <= 370, "{name}: {lines} lines");
        let doc = text.find("//! ").expect("a description");
        let parameters = text.find("pub struct").expect("parameters");
        let checks = text
            .find("ParameterError")
            .or(text.find("pub fn new"))
            .expect("a constructor");
        let evaluation = text.find("Brdf for ").unwrap_or_else(|| {
            text.find("microbrdf_brdf!")
                .or(text.find("microfacet_brdf!("))
                .expect("an evaluation")
        });
        let entry = text.find("pub const ENTRY").expect("an entry of the list");
        let tests = text.find("#[cfg(test)]").expect("tests of its own");
        assert!(text[tests..].contains("#[test]"), "{name}: no test");
        assert!(
            doc < parameters && parameters < evaluation && evaluation < entry && entry < tests,
            "{name}"
        );
        assert!(checks < tests, "{name}");
    }
}

#[test]
fn every_entry_can_be_built() {
    for entry in ALL {
        assert!(!(entry.examples)().is_empty(), "{}", entry.name);
        assert!(!entry.formula.is_empty() && !entry.source.is_empty() && !entry.grazing.is_empty());
    }
}
