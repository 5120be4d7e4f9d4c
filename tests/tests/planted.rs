//! The planted bugs can still be planted: `cargo run -p microbrdf-tests --bin
//! planted` shows that each is caught.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use microbrdf_tests::planted::all;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

#[test]
fn each_bugs_place_stands_in_the_source_once() {
    let mut files = BTreeMap::new();
    for bug in all() {
        let text: &String = files
            .entry(bug.file)
            .or_insert_with(|| fs::read_to_string(root().join(bug.file)).expect(bug.file));
        assert_eq!(
            text.matches(bug.from).count(),
            1,
            "{}: {} should have once\n{}",
            bug.name,
            bug.file,
            bug.from
        );
        assert_ne!(bug.from, bug.to, "{}", bug.name);
    }
}

#[test]
fn each_bug_names_tests_that_exist() {
    for bug in all() {
        assert!(!bug.tests.is_empty(), "{}", bug.name);
        for test in bug.tests {
            let file = |path: String| root().join(bug.package).join(path).is_file();
            let exists = if *test == "lib" {
                file("src/lib.rs".to_owned())
            } else {
                file(format!("tests/{test}.rs")) || file(format!("tests/{test}/main.rs"))
            };
            assert!(exists, "{}: {}/{test}", bug.name, bug.package);
        }
    }
}
