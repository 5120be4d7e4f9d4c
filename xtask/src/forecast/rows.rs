//! Rows of a baked scene, shaded on an emulated core that counts cycles.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::{Program, folder};
use crate::board::Board;
use crate::failure::{During, Failure, Outcome};
use crate::firmware;
use crate::host_sim::HostSim;
use crate::layout::Layout;
use crate::measure::Library;
use crate::toolchain::Cross;

/// Some rows of a scene.
pub struct Rows {
    /// Scene file.
    pub scene: PathBuf,
    /// How it is computed.
    pub arithmetic: String,
    /// Compiler target.
    pub target: &'static str,
    /// One of so many rows.
    pub every: usize,
    /// Its picture, if a device has sent one.
    pub picture: Option<PathBuf>,
}

impl Rows {
    /// Builds the row function of the scene, which is baked already, runs it, compares its pixels with the picture's, and returns the file with its cycles.
    pub fn count(&self, layout: &Layout, cross: &Cross, program: &Program<'_>) -> Outcome<PathBuf> {
        let stem = self.scene.file_stem().unwrap_or_default();
        let (stem, target) = (stem.to_string_lossy(), self.target);
        let name = format!("{stem}-{}-{target}", self.arithmetic);
        let folder = folder(layout);
        fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
        let library = Library {
            package: "microbrdf-row",
            calls: folder.join(format!("{name}-calls.json")),
            images: folder.join(&name),
            scene: Some(firmware::baked(layout, &self.scene, &self.arithmetic)),
        };
        program.calls(self, &library.calls)?;
        let output = folder.join(format!("{name}.json"));
        run(layout, cross, &library, self.target, &output)?;
        Ok(output)
    }
}

/// What packing takes on a board's core: the file with its cycles.
pub(super) fn packing(
    layout: &Layout,
    cross: &Cross,
    host: &HostSim<'_>,
    program: &Program<'_>,
    board: Board,
) -> Outcome<PathBuf> {
    let folder = folder(layout);
    // The library holds a scene, too, though nobody asks for it.
    let scene = firmware::bake(layout, host, &layout.at("scenes/demo.toml"), "q15")?;
    let library = Library {
        package: "microbrdf-row",
        calls: folder.join("packing-calls.json"),
        images: folder.join(board.target),
        scene: Some(scene),
    };
    program.packing(&library.calls)?;
    let output = folder.join(format!("packing-{}.json", board.target));
    run(layout, cross, &library, board.target, &output)?;
    Ok(output)
}

fn run(
    layout: &Layout,
    cross: &Cross,
    library: &Library,
    target: &str,
    output: &Path,
) -> Outcome<()> {
    library.link(layout, cross, target, true)?;
    library.count(layout, target, output)
}

/// Numbers of the rows that are counted: one of `every`, from the middle of the first so many on, as `microbrdf-forecast calls` chooses them.
pub fn numbers(height: usize, every: usize) -> impl Iterator<Item = usize> {
    (every / 2..height).step_by(every.max(1))
}

/// Cycles of each row that was counted, on a core.
pub fn cycles(path: &Path, core: &str) -> Outcome<Vec<f64>> {
    let text = fs::read(path).during(|| format!("reading {}", path.display()))?;
    let counts: Value =
        serde_json::from_slice(&text).during(|| format!("reading {}", path.display()))?;
    let rows = counts[0]["cycles"][core]["row"].as_array();
    let cycles: Option<Vec<f64>> = rows.map(|rows| rows.iter().filter_map(Value::as_f64).collect());
    match cycles {
        Some(cycles) if !cycles.is_empty() => Ok(cycles),
        _ => Err(Failure::incomplete(format!(
            "{}: no row was counted for {core}",
            path.display()
        ))),
    }
}
