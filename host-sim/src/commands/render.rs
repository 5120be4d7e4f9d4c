//! `microbrdf render`.

use microbrdf_scene::Description;

use super::Computed;
use crate::cli::Render;
use crate::exit::{Failure, Outcome};
use crate::{reference_picture, render};

/// Renders a scene to a picture, a panel's photograph, or both.
pub fn run(arguments: &Render) -> Outcome<()> {
    let computed = Computed::parse(&arguments.arithmetic)?;
    let description = Description::from_file(&arguments.scene)?;
    match computed {
        Computed::Core(arithmetic) => {
            let frame = render::frame(&description, arithmetic)?;
            if let Some(panel) = &arguments.panel {
                frame.panel().write_png(panel)?;
            }
            if let Some(output) = &arguments.rgb565 {
                frame.rgb565_shown().write_png(output)?;
            }
            if let Some(output) = &arguments.output {
                frame.srgb().write_png(output)?;
            }
        }
        Computed::Reference => {
            if arguments.panel.is_some() || arguments.rgb565.is_some() {
                return Err(Failure::Usage(
                    "--panel and --rgb565: show an arithmetic of the core, not the reference"
                        .to_owned(),
                ));
            }
            if let Some(output) = &arguments.output {
                reference_picture::render(&description)
                    .srgb()
                    .write_png(output)?;
            }
        }
    }
    Ok(())
}
