//! How soon pictures come on a host.

use super::counts::Tally;
use super::{Step, step};
use crate::host_sim::HostSim;

/// How many times as fast as the reference and as a plain renderer `f32` has to be. Undisturbed it is above 3, but this is no quiet place.
const LEAST: &str = "2";

/// The demo's pixels, against two other renderers in the same run.
pub fn host_rendering() -> Step {
    let run = step("host rendering", |bench| {
        let host = HostSim::build(bench.layout, true)?;
        let scene = bench.layout.at("scenes/demo.toml");
        let mut command = host.command(["bench", "--at-least", LEAST]);
        let output = bench.finish("host-rendering", command.arg(scene))?;
        print!("{output}");
        Ok(Tally::PASSED)
    });
    run.alone()
}
