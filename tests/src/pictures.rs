//! A scene beside its reference picture, and what a picture of it may differ in.

use microbrdf_scene::Description;
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_sim::measure::Measured;
use microbrdf_sim::picture::Picture;
use microbrdf_sim::reference_picture::{self, Exact};
use microbrdf_sim::render;

/// A scene and its reference picture.
pub struct Case {
    /// The scene.
    pub description: Description,
    /// The reference picture.
    pub exact: Exact,
}

impl Case {
    /// Renders the reference.
    #[must_use]
    pub fn new(description: Description) -> Self {
        let exact = reference_picture::render(&description);
        Self { description, exact }
    }

    /// A scene of the tests' own.
    ///
    /// # Panics
    /// On a mistake in it.
    #[must_use]
    pub fn of(text: &str) -> Self {
        Self::new(Description::from_toml("scene", "scene", text).expect("a scene"))
    }

    /// The picture in an arithmetic.
    ///
    /// # Panics
    /// On a material that the arithmetic does not take.
    #[must_use]
    pub fn picture(&self, arithmetic: ArithmeticName) -> Picture {
        render::frame(&self.description, arithmetic)
            .expect("a picture")
            .srgb()
    }

    /// What is wrong with the picture in an arithmetic.
    #[must_use]
    pub fn measured(&self, arithmetic: ArithmeticName) -> Measured {
        Measured::new(&self.picture(arithmetic), &self.exact)
    }

    /// Pixels that are near enough to a jump to be counted as class flips.
    #[must_use]
    pub fn exempt(&self) -> usize {
        self.exact
            .pixels
            .iter()
            .filter(|pixel| pixel.may_flip())
            .count()
    }
}

/// At most one code off but for class flips, at most 20 of those, at least
/// 99 % of codes identical.
#[must_use]
pub fn faults(found: &Measured) -> Vec<&'static str> {
    [
        (found.code_error_max > 1, "a code is off by more than one"),
        (
            found.lsb_error_max > 1.0,
            "a code is off by more than 1 LSB",
        ),
        (found.off_by_more > 0.0, "codes are off by more than one"),
        (found.off_by_one > 0.01, "too many codes are off by one"),
        (found.class_flips > 20, "too many class flips"),
        (found.delta_e_p95 > 0.5, "the colours differ"),
    ]
    .into_iter()
    .filter_map(|(fault, text)| fault.then_some(text))
    .collect()
}
