//! Diagrams as SVG and PNG.
//!
//! A [`Sheet`] is composed as SVG, one text whatever becomes of it; a PNG is that
//! SVG rasterised with the font that the program carries, so no font and no
//! library of the system takes part.

mod axis;
mod card;
mod cartesian;
mod legend;
mod pen;
mod png;
mod polar;
mod sheet;

use std::path::Path;

use clap::ValueEnum;

pub use axis::rounded_up;
pub use card::card;
pub use sheet::Sheet;

use crate::exit::{Failure, Outcome};
use crate::picture::write_whole;

/// What a diagram can be written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Vectors, with text as text.
    Svg,
    /// Pixels, two for each unit of the SVG.
    Png,
}

impl Format {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Svg, Self::Png];

    /// The file name's extension.
    #[must_use]
    pub fn extension(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Png => "png",
        }
    }

    /// The format that a file's extension names.
    ///
    /// # Errors
    /// An extension that is neither; `option` says where the path was given.
    pub fn of(path: &Path, option: &str) -> Outcome<Self> {
        let extension = path.extension().map(|e| e.to_ascii_lowercase());
        Self::ALL
            .into_iter()
            .find(|format| extension.as_deref() == Some(format.extension().as_ref()))
            .ok_or_else(|| {
                Failure::Usage(format!(
                    "{option} {}: must end in .svg or .png",
                    path.display()
                ))
            })
    }
}

/// Writes a sheet; the file appears whole or not at all.
///
/// # Errors
/// A path that can't be written.
pub fn write(sheet: &Sheet<'_>, format: Format, path: &Path) -> Outcome<()> {
    let svg = sheet.svg();
    match format {
        Format::Svg => write_whole(path, svg.as_bytes()),
        Format::Png => {
            let fault = |message| Failure::Incomplete(format!("{}: {message}", path.display()));
            png::rasterised(&svg).map_err(fault)?.write_png(path)
        }
    }
}
