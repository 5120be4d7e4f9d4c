//! Bugs that are planted to see the tests fail.

mod core;
mod reference;
mod scenes;

pub use core::CORE_BUGS;
pub use reference::REFERENCE_BUGS;
pub use scenes::SCENE_BUGS;

/// One change of the source, and the files of tests that must notice it.
#[derive(Clone, Copy, Debug)]
pub struct Bug {
    /// What is wrong.
    pub name: &'static str,
    /// The file, from the project's folder.
    pub file: &'static str,
    /// What stands there, once.
    pub from: &'static str,
    /// What is put in its place.
    pub to: &'static str,
    /// The folder of the package whose tests must notice.
    pub package: &'static str,
    /// Files of its `tests/`, each of which has a test that fails; `lib` for unit tests.
    pub tests: &'static [&'static str],
}

impl Bug {
    /// The same, to be noticed by another package's own tests.
    const fn of(self, package: &'static str) -> Self {
        Self { package, ..self }
    }
}

/// The bugs of all packages.
pub fn all() -> impl Iterator<Item = &'static Bug> {
    CORE_BUGS.iter().chain(SCENE_BUGS).chain(REFERENCE_BUGS)
}

const fn bug(
    name: &'static str,
    file: &'static str,
    from: &'static str,
    to: &'static str,
    tests: &'static [&'static str],
) -> Bug {
    Bug {
        name,
        file,
        from,
        to,
        package: "tests",
        tests,
    }
}
