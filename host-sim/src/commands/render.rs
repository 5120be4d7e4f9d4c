//! `microbrdf render`.

use microbrdf_reference::models::CookTorrance;
use microbrdf_scene::Description;

use super::Computed;
use crate::cli::Render;
use crate::exit::{Failure, Outcome};
use crate::reference_picture::{Exact, Renderer};
use crate::{reference_picture, render};

/// Renders a scene to a picture, a panel's photograph, or both.
pub fn run(arguments: &Render) -> Outcome<()> {
    let computed = Computed::parse(&arguments.arithmetic)?;
    let description = Description::from_file(&arguments.scene)?;
    match computed {
        Computed::Core(_) if arguments.facets.is_some() => {
            return Err(Failure::Usage(
                "--facets: is a model of the reference: needs --arithmetic reference".to_owned(),
            ));
        }
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
            let exact = match arguments.facets {
                None => reference_picture::render(&description),
                Some(slope) => faceted(&description, slope)?,
            };
            if let Some(output) = &arguments.output {
                exact.srgb().write_png(output)?;
            }
        }
    }
    Ok(())
}

/// The scene with facets in place of every material.
fn faceted(description: &Description, slope: f64) -> Outcome<Exact> {
    let fault = |message: String| Failure::Usage(format!("--facets {slope}: {message}"));
    if description.daylight.is_some() {
        return Err(fault(
            "the scene has daylight: must have lights only".into(),
        ));
    }
    let facets = CookTorrance::beckmann(slope).map_err(|error| fault(error.to_string()))?;
    Ok(Renderer::with_models(description, &|_| Box::new(facets)).render())
}
