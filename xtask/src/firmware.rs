//! `cargo xtask firmware`: bakes a scene into constants and links it for a board.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use crate::board::Board;
use crate::failure::{During, Failure, Outcome};
use crate::host_sim::HostSim;
use crate::layout::Layout;
use crate::sizes::{self, Sizes};
use crate::toolchain::Cross;

/// What to build.
#[derive(Debug, Clone)]
pub struct Order {
    /// For which board.
    pub board: Board,
    /// Which scene.
    pub scene: PathBuf,
    /// How it is computed.
    pub arithmetic: String,
    /// Further cargo features of the firmware.
    pub features: Vec<String>,
}

impl Order {
    /// Name of its files: board, arithmetic, scene, features.
    fn name(&self) -> String {
        let mut name = format!(
            "{}-{}-{}",
            self.board.name,
            self.arithmetic,
            stem(&self.scene)
        );
        for feature in &self.features {
            name.push('-');
            name.push_str(feature);
        }
        name
    }

    /// Cargo's list of features.
    pub fn feature_list(&self) -> String {
        let mut features = vec![self.board.feature()];
        features.extend(self.features.iter().cloned());
        features.join(",")
    }
}

/// A linked image.
#[derive(Debug, Clone)]
pub struct Image {
    /// The ELF file.
    pub elf: PathBuf,
    /// What it takes.
    pub sizes: Sizes,
}

/// Refuses a scene that is not there, before anything is built or installed.
pub fn check_scene(scene: &Path) -> Outcome<()> {
    if scene.is_file() {
        return Ok(());
    }
    Err(Failure::mistake(format!(
        "--scene {}: no such file",
        scene.display()
    )))
}

/// Writes the scene as Rust constants and returns the file's path. Unchanged constants leave the file untouched, so that nothing is compiled again.
pub fn bake(
    layout: &Layout,
    host: &HostSim<'_>,
    scene: &Path,
    arithmetic: &str,
) -> Outcome<PathBuf> {
    let folder = layout.target().join("firmware");
    fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
    let baked = folder.join(format!("{}-{arithmetic}.rs", stem(scene)));
    let fresh = baked.with_extension("rs.new");
    host.run([
        "bake".as_ref(),
        scene.as_os_str(),
        "--arithmetic".as_ref(),
        arithmetic.as_ref(),
        "-o".as_ref(),
        fresh.as_os_str(),
    ])?;
    let text = fs::read(&fresh).during(|| format!("reading {}", fresh.display()))?;
    if fs::read(&baked).is_ok_and(|old| old == text) {
        let _ = fs::remove_file(&fresh);
    } else {
        fs::rename(&fresh, &baked).during(|| format!("writing {}", baked.display()))?;
    }
    Ok(baked)
}

/// Bakes, compiles and links; the image is kept under its own name.
pub fn build(
    layout: &Layout,
    cross: &Cross,
    host: &HostSim<'_>,
    order: &Order,
    quiet: bool,
) -> Outcome<Image> {
    let baked = bake(layout, host, &order.scene, &order.arithmetic)?;
    let status = cross
        .cargo(layout, "build", order.board.target)
        .args(["--profile", "firmware", "--package", "microbrdf-firmware"])
        .args([
            "--bin",
            "microbrdf-firmware",
            "--features",
            &order.feature_list(),
        ])
        .args(quiet.then_some("--quiet"))
        .env("MICROBRDF_SCENE_RS", baked)
        .stdin(Stdio::null())
        .status()
        .during(|| "starting the cross compiler".to_string())?;
    if !status.success() {
        return Err(Failure::incomplete(format!(
            "the firmware for {} does not build (see above)",
            order.board.name
        )));
    }
    let made = layout
        .cross_target()
        .join(order.board.target)
        .join("firmware")
        .join("microbrdf-firmware");
    let elf = layout
        .target()
        .join("firmware")
        .join(format!("{}.elf", order.name()));
    fs::copy(&made, &elf).during(|| format!("copying {} to {}", made.display(), elf.display()))?;
    let sizes = sizes::of(&elf)?;
    Ok(Image { elf, sizes })
}

/// `cargo xtask firmware`.
pub fn command(layout: &Layout, cross: &Cross, order: &Order) -> Outcome<()> {
    println!("{}", cross.chosen(layout));
    let host = HostSim::build(layout, false)?;
    let image = build(layout, cross, &host, order, false)?;
    println!("{}", describe(layout, order, &image));
    Ok(())
}

/// One line: what was built, and how big it is.
pub fn describe(layout: &Layout, order: &Order, image: &Image) -> String {
    format!(
        "{} ({}), {}: {} bytes of flash, {} bytes of RAM and a stack; {}",
        order.board.name,
        order.board.core,
        order.arithmetic,
        image.sizes.flash,
        image.sizes.ram,
        layout.shown(&image.elf)
    )
}

/// A scene's file name without its ending.
fn stem(scene: &Path) -> String {
    scene
        .file_stem()
        .map(|stem| stem.to_string_lossy().into_owned())
        .unwrap_or_default()
}
