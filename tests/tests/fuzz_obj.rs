//! OBJ files at random.

use std::path::PathBuf;

use microbrdf_scene::{HostArithmetic, Obj};
use microbrdf_tests::fuzz_files::Files;
use microbrdf_tests::fuzz_obj::{BYTES, check, text};
use microbrdf_tests::in_every_arithmetic;

in_every_arithmetic!(any_file);

const FILES: Files = Files {
    what: "meshes",
    bytes: BYTES,
    text,
    all_are_timed: true,
};

/// A folder that goes with the test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let name = format!("microbrdf-obj-{name}-{}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        std::fs::create_dir_all(&folder).expect("a folder");
        Self(folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn any_file<A: HostArithmetic>() {
    let folder = Folder::new(A::NAME);
    FILES.run(A::NAME, |text| check::<A>(text, &folder.0));
}

/// The files reach what they are there for: meshes, and refusals of many kinds.
#[test]
fn files_are_of_many_kinds() {
    let mut refusals = std::collections::BTreeSet::new();
    let mut meshes = 0;
    for seed in 0..2000 {
        match Obj::read("it.obj", &FILES.file(seed)) {
            Ok(_) => meshes += 1,
            Err(error) => {
                // Without what is quoted: which mistake it is.
                let kind = error.message.rsplit('`').next().unwrap_or_default();
                refusals.insert(kind.to_owned());
            }
        }
    }
    assert!((200..1800).contains(&meshes), "{meshes} meshes");
    assert!(
        refusals.len() > 12,
        "{} kinds: {refusals:?}",
        refusals.len()
    );
    // Bytes that end early are a case, too.
    assert_eq!(text(&[]), "");
}
