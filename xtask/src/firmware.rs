//! `cargo xtask firmware`: bakes a scene into constants and links it for a board.

use std::fs::{self, File};
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{self, Stdio};

use crate::board::Board;
use crate::failure::{During, Failure, Outcome};
use crate::host_sim::HostSim;
use crate::layout::Layout;
use crate::lock;
use crate::sizes::{self, Sizes};
use crate::toolchain::Cross;

/// The firmware's feature for boards with little flash.
pub const BRIEF: &str = "brief";

/// The environment's variable that tells a build which baked scene to take.
pub const SCENE: &str = "MICROBRDF_SCENE_RS";

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

    /// Where its image is kept.
    pub fn elf(&self, layout: &Layout) -> PathBuf {
        layout
            .target()
            .join("firmware")
            .join(format!("{}.elf", self.name()))
    }

    /// Cargo's profile: where features ask for few bytes, so does it.
    pub fn profile(&self) -> &'static str {
        if self.features.iter().any(|feature| feature == BRIEF) {
            "firmware-small"
        } else {
            "firmware"
        }
    }

    /// Cargo's list of features.
    pub fn feature_list(&self) -> String {
        let mut features = vec![self.board.feature()];
        features.extend(self.features.iter().cloned());
        features.join(",")
    }
}

/// A linked image.
#[derive(Debug)]
pub struct Image {
    /// The ELF file.
    pub elf: PathBuf,
    /// What it takes.
    pub sizes: Sizes,
    /// So that no other step makes or runs the same image meanwhile.
    _held: File,
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

/// Where a scene's constants are kept.
pub fn baked(layout: &Layout, scene: &Path, arithmetic: &str) -> PathBuf {
    let name = format!("{}-{arithmetic}.rs", stem(scene));
    layout.target().join("firmware").join(name)
}

/// Writes the scene as Rust constants and returns the file's path. Unchanged constants leave the file untouched, so that nothing is compiled again.
pub fn bake(
    layout: &Layout,
    host: &HostSim<'_>,
    scene: &Path,
    arithmetic: &str,
) -> Outcome<PathBuf> {
    let baked = baked(layout, scene, arithmetic);
    let folder = layout.target().join("firmware");
    fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
    // Others may bake the same at the same time.
    let fresh = baked.with_extension(format!("rs.{}", process::id()));
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
    let elf = order.elf(layout);
    let held = lock::hold(&elf.with_extension("lock"))?;
    // One of an earlier scene must not be taken for this one's.
    let _ = fs::remove_file(&elf);
    // Until the image is copied, nobody may build another scene's.
    let building = lock::hold(&layout.cross_lock())?;
    let mut cargo = cross
        .cargo(layout, "build", order.board.target)
        .args([
            "--profile",
            order.profile(),
            "--package",
            "microbrdf-firmware",
        ])
        .args([
            "--bin",
            "microbrdf-firmware",
            "--features",
            &order.feature_list(),
        ])
        .args(quiet.then_some("--quiet"))
        .env(SCENE, baked)
        .stdin(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .during(|| "starting the cross compiler".to_string())?;
    let said = cargo.stderr.take().map(repeated).unwrap_or_default();
    let status = cargo
        .wait()
        .during(|| "waiting for the cross compiler".to_string())?;
    if !status.success() {
        if let Some(failure) = overflow(order, &said) {
            return Err(failure);
        }
        return Err(Failure::incomplete(format!(
            "the firmware for {} does not build (see above)",
            order.board.name
        )));
    }
    let made = layout
        .cross_target()
        .join(order.board.target)
        .join(order.profile())
        .join("microbrdf-firmware");
    fs::copy(&made, &elf).during(|| format!("copying {} to {}", made.display(), elf.display()))?;
    drop(building);
    let sizes = sizes::of(&elf)?;
    let ram = sizes.ram + STACK;
    if ram > order.board.ram {
        let _ = fs::remove_file(&elf);
        return Err(Failure::mistake(format!(
            "{} is too large for {}: it needs {ram} bytes of RAM, of which {STACK} for the stack; \
             the board has {}",
            layout.shown(&order.scene),
            order.board.name,
            order.board.ram
        )));
    }
    Ok(Image {
        elf,
        sizes,
        _held: held,
    })
}

/// Bytes of stack that an image must leave; the demo's runs, whose report says what they used, take less.
const STACK: u64 = 4 << 10;

/// Passes on what a program says, line by line, and returns it.
fn repeated(from: impl Read) -> String {
    let mut said = String::new();
    for line in BufReader::new(from).lines().map_while(Result::ok) {
        // One line for each section behind the end, which `overflow` sums up.
        if !line.contains("will not fit in region") {
            eprintln!("{line}");
        }
        said += &line;
        said.push('\n');
    }
    said
}

/// What to say where the linker complains that a region overflows.
fn overflow(order: &Order, said: &str) -> Option<Failure> {
    let excess = |region: &str| -> Option<u64> {
        // `will not fit in region 'FLASH': overflowed by 12 bytes`, once for each section.
        said.lines()
            .filter(|line| line.contains(&format!("region '{region}'")))
            .filter_map(|line| line.split("overflowed by ").nth(1)?.split(' ').next())
            .filter_map(|number| number.parse().ok())
            .max()
    };
    let (flash, ram) = (excess("FLASH"), excess("RAM"));
    let of = |excess: Option<u64>, size: u64, what: &str| {
        excess.map(|excess| format!("{} bytes of {what}, the board has {size}", size + excess))
    };
    let figures: Vec<_> = [
        of(flash, order.board.flash, "flash"),
        of(ram, order.board.ram, "RAM"),
    ]
    .into_iter()
    .flatten()
    .collect();
    (!figures.is_empty()).then(|| {
        Failure::mistake(format!(
            "{} is too large for {} in {}: it needs {}",
            order.scene.display(),
            order.board.name,
            order.arithmetic,
            figures.join("; and ")
        ))
    })
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

#[cfg(test)]
mod tests {
    use super::*;

    fn order() -> Order {
        Order {
            board: Board::named("microbit").unwrap(),
            scene: "large.toml".into(),
            arithmetic: "q31".into(),
            features: Vec::new(),
        }
    }

    #[test]
    fn an_overflow_is_told_with_its_figures() {
        let said = "error: linking failed\n\
            rust-lld: error: section '.text' will not fit in region 'FLASH': overflowed by 100 bytes\n\
            rust-lld: error: section '.rodata' will not fit in region 'FLASH': overflowed by 3000 bytes\n";
        let failure = overflow(&order(), said).unwrap();
        assert_eq!(failure.status, 2);
        for part in ["large.toml", "microbit", "265144 bytes of flash", "262144"] {
            assert!(failure.message.contains(part), "{failure}");
        }
        assert!(!failure.message.contains("RAM"), "{failure}");
        let said = "section '.bss' will not fit in region 'RAM': overflowed by 8 bytes";
        let failure = overflow(&order(), said).unwrap();
        assert!(failure.message.contains("16392 bytes of RAM"), "{failure}");
    }

    #[test]
    fn other_errors_are_no_overflow() {
        assert!(overflow(&order(), "error[E0425]: cannot find value").is_none());
    }
}
