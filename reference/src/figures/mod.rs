//! What the thesis' figures show, as curves: data, not drawings.
//!
//! [`figure`] computes one of [`KNOWN`]. The thesis' pictures are not copied: every
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
const ENTRIES: [Entry; 17] = [
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
