//! What the thesis' figures show, as curves: data, not drawings.
//!
//! [`figure`] computes one of those that are [`known`]. The thesis' pictures are not copied: every
//! curve follows from the models here, with the parameters that captions and text
//! give. Where they give none, the figure's notes name those chosen instead.
//! Renderings, sketches and the editor's window (1.1 to 1.4, 2.2, 2.8, 3.8 to 3.13,
//! 4.1 to 4.4, 4.7 to 4.11, 4.16 to 4.18, 5.1) show no curve and are left out.

mod basic_patch;
mod comparison;
mod curve;
mod exponential_patch;
mod gold;
mod metallic_phong;
pub mod of_model;
mod panel;
mod pumping;
mod specular_models;

pub use curve::curve;
pub use exponential_patch::{density, inverse};
pub use panel::{Axis, Kind, Panel, Series};

use crate::ParameterError;

/// A figure of the thesis.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Its number in the thesis.
    pub number: &'static str,
    /// What it shows, with the parameters.
    pub title: &'static str,
    /// What was left out, chosen or corrected against the thesis.
    pub notes: Vec<String>,
    /// One or two diagrams, from left to right.
    pub panels: Vec<Panel>,
}

/// A figure's number and the function that computes it.
type Entry = (&'static str, fn() -> Result<Figure, ParameterError>);

/// All figures, in the thesis' order.
const ENTRIES: [Entry; 19] = [
    ("2.1", specular_models::albedos_of_classics),
    ("2.3", pumping::phong),
    ("2.4", pumping::blinn),
    ("2.5", pumping::phong_controlled),
    ("2.6", pumping::blinn_controlled),
    ("2.7", metallic_phong::albedo_and_radiance),
    ("3.1", metallic_phong::albedos),
    ("3.2", metallic_phong::ratio_to_phong),
    ("3.3", specular_models::lobes),
    ("3.4", specular_models::albedos_with_the_new_model),
    ("3.5", comparison::brdfs),
    ("3.6", comparison::radiances),
    ("3.7", gold::albedo),
    ("4.5", basic_patch::albedos),
    ("4.6", basic_patch::mean_albedo),
    ("4.12", exponential_patch::densities),
    ("4.13", exponential_patch::inverses),
    ("4.14", exponential_patch::albedos),
    ("4.15", exponential_patch::lobes),
];

/// The numbers of the figures that [`figure`] knows, in the thesis' order.
pub fn known() -> impl Iterator<Item = &'static str> {
    ENTRIES.iter().map(|(number, _)| *number)
}

/// Computes the figure of the given number; nothing for one that is not in [`known`].
///
/// # Errors
/// None for the parameters in use: they lie within every model's range (tested).
pub fn figure(number: &str) -> Option<Result<Figure, ParameterError>> {
    ENTRIES
        .iter()
        .find(|(known, _)| *known == number)
        .map(|(_, compute)| compute())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_figure_is_computed_and_whole() {
        for number in known() {
            let figure = figure(number).unwrap().unwrap();
            assert_eq!(figure.number, number);
            // Where the thesis shows He–Torrance, its absence is said.
            let said = figure
                .notes
                .concat()
                .contains("Without the He–Torrance curve");
            assert_eq!(said, ["2.1", "3.3", "3.4"].contains(&number), "{number}");
            assert!(
                !figure.title.is_empty() && !figure.notes.is_empty(),
                "{number}"
            );
            assert!((1..=2).contains(&figure.panels.len()), "{number}");
            for panel in &figure.panels {
                assert!(panel.series.iter().any(|s| !s.name.is_empty()), "{number}");
                for series in &panel.series {
                    assert!(series.points.len() > 1, "{number}, {}", series.name);
                    assert!(series.points.len() < 3000, "{number}, {}", series.name);
                    for (x, y) in &series.points {
                        assert!(x.is_finite() && y.is_finite(), "{number}, {}", series.name);
                    }
                }
            }
        }
    }

    #[test]
    fn the_list_is_that_of_the_curves_in_the_thesis() {
        let known: Vec<_> = known().collect();
        assert_eq!(
            known,
            [
                "2.1", "2.3", "2.4", "2.5", "2.6", "2.7", "3.1", "3.2", "3.3", "3.4", "3.5", "3.6",
                "3.7", "4.5", "4.6", "4.12", "4.13", "4.14", "4.15"
            ]
        );
        assert!(figure("2.2").is_none() && figure("").is_none());
    }
}
