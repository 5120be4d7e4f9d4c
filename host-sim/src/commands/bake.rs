//! `microbrdf bake`.

use microbrdf_scene::{Description, bake};

use crate::cli::Bake;
use crate::exit::{Failure, Outcome};
use crate::picture::write_whole;
use crate::with_arithmetic;

/// Writes a scene as Rust source.
pub fn run(arguments: &Bake) -> Outcome<()> {
    let description = Description::from_file(&arguments.scene)?;
    let code = with_arithmetic!(arguments.arithmetic, A => bake::<A>(&description))
        .map_err(|error| Failure::Usage(format!("{}: {error}", arguments.scene.display())))?;
    write_whole(&arguments.output, code.as_bytes())
}
