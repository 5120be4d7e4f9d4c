//! Kernels compiled for a target and linked, each alone, so that its bytes
//! are its own.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::command;
use crate::failure::{During, Failure, Outcome};
use crate::firmware::SCENE;
use crate::layout::Layout;
use crate::lock;
use crate::toolchain::Cross;

/// A library of exported functions, each of which is linked alone.
pub struct Library {
    /// The package; its library has the same name.
    pub package: &'static str,
    /// File with the calls, and so with the names of the functions.
    pub calls: PathBuf,
    /// Folder for the images.
    pub images: PathBuf,
    /// The baked scene that it holds, if it holds one.
    pub scene: Option<PathBuf>,
}

impl Library {
    /// What is measured.
    pub fn kernels(layout: &Layout, target: &str) -> Self {
        Self {
            package: "microbrdf-kernels",
            calls: super::folder(layout).join("calls.json"),
            images: super::folder(layout).join(target),
            scene: None,
        }
    }

    /// What sums up many results.
    pub fn checksums(layout: &Layout, target: &str) -> Self {
        let folder = super::folder(layout);
        Self {
            package: "microbrdf-checksum",
            calls: folder.join("checksums.json"),
            images: folder.join(format!("checksums-{target}")),
            scene: None,
        }
    }

    /// Compiles it, and links one image for each function that is to be called.
    pub fn link(&self, layout: &Layout, cross: &Cross, target: &str, quiet: bool) -> Outcome<()> {
        // A function that is gone must not be run from an old image.
        let _ = fs::remove_dir_all(&self.images);
        fs::create_dir_all(&self.images)
            .during(|| format!("creating {}", self.images.display()))?;
        let file = format!("lib{}.a", self.package.replace('-', "_"));
        let library = self.images.join(&file);
        let building = lock::hold(&layout.cross_lock())?;
        self.compile(layout, cross, target, quiet)?;
        let made = layout
            .cross_target()
            .join(target)
            .join("firmware")
            .join(file);
        fs::copy(&made, &library).during(|| format!("copying {}", made.display()))?;
        drop(building);
        for name in names(&self.calls)? {
            let image = self.images.join(format!("{name}.elf"));
            alone(layout, cross, target, &library, &name, &image)?;
        }
        Ok(())
    }

    fn compile(&self, layout: &Layout, cross: &Cross, target: &str, quiet: bool) -> Outcome<()> {
        let scene = self.scene.iter().map(|scene| (SCENE, scene));
        let status = cross
            .cargo(layout, "rustc", target)
            .envs(scene)
            .args(["--locked", "--profile", "firmware"])
            .args(["--package", self.package, "--lib"])
            .args(["--crate-type", "staticlib"])
            .args(quiet.then_some("--quiet"))
            .stdin(Stdio::null())
            .status()
            .during(|| "starting the cross compiler".to_string())?;
        if status.success() {
            return Ok(());
        }
        Err(Failure::incomplete(format!(
            "{} does not build for {target} (see above)",
            self.package
        )))
    }

    /// Runs every function's calls, and writes what they took.
    pub fn count(&self, layout: &Layout, target: &str, output: &Path) -> Outcome<()> {
        super::core::run(layout, target, self, &["-o".as_ref(), output.as_os_str()])
    }
}

fn read(calls: &Path) -> Outcome<Vec<Value>> {
    let text = fs::read(calls).during(|| format!("reading {}", calls.display()))?;
    serde_json::from_slice(&text).during(|| "reading the calls".to_string())
}

/// Names of the kernels that are to be called.
fn names(calls: &Path) -> Outcome<Vec<String>> {
    let names = read(calls)?;
    let names = names.iter().filter_map(|kernel| kernel["kernel"].as_str());
    Ok(names.map(str::to_owned).collect())
}

/// Compares the sums of an unoptimised build for this host, with every check that a build can
/// have, with those that were written for the targets.
pub fn compare_unoptimised(layout: &Layout) -> Outcome<()> {
    let library = Library::checksums(layout, "");
    let output = command::host_cargo(layout.root())
        .args(["run", "--quiet", "--locked", "--profile", "unoptimised"])
        .args(["--package", library.package, "--example", "host"])
        .stdin(Stdio::null())
        .output()
        .during(|| "starting cargo".to_string())?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        return Err(Failure::incomplete(format!(
            "the unoptimised build fails:\n{said}"
        )));
    }
    let wanted: String = read(&library.calls)?
        .iter()
        .map(|kernel| {
            let name = kernel["kernel"].as_str().unwrap_or_default();
            let result = &kernel["groups"][0]["calls"][0]["results"][0];
            format!("{name} {result}\n")
        })
        .collect();
    let found = String::from_utf8_lossy(&output.stdout);
    if found.lines().ne(wanted.lines()) {
        return Err(Failure::incomplete(format!(
            "an unoptimised build gives\n{found}a release gives\n{wanted}"
        )));
    }
    println!(
        "the host, unoptimised: {} as in a release",
        found.lines().count()
    );
    Ok(())
}

/// Links one kernel and all that it reaches, and nothing else.
fn alone(
    layout: &Layout,
    cross: &Cross,
    target: &str,
    library: &Path,
    kernel: &str,
    image: &Path,
) -> Outcome<()> {
    let emulation = if target.starts_with("thumb") {
        "armelf"
    } else {
        "elf32lriscv"
    };
    let output = linker(cross)?
        .args(["-m", emulation, "--gc-sections", "-T"])
        .arg(layout.at("measure/kernels/kernel.x"))
        .args(["-e", kernel])
        .arg(library)
        .arg("-o")
        .arg(image)
        .stdin(Stdio::null())
        .output()
        .during(|| "starting the linker".to_string())?;
    if output.status.success() {
        return Ok(());
    }
    Err(Failure::incomplete(format!(
        "{kernel} does not link for {target}:\n{}",
        String::from_utf8_lossy(&output.stderr)
    )))
}

/// The linker that the cross compiler would call.
fn linker(cross: &Cross) -> Outcome<Command> {
    match cross {
        Cross::Distribution { compiler, .. } => Ok(Command::new(&compiler.linker)),
        Cross::Active { .. } => {
            let mut command = Command::new(rust_lld()?);
            command.args(["-flavor", "gnu"]);
            Ok(command)
        }
    }
}

/// The linker that comes with the active toolchain.
fn rust_lld() -> Outcome<PathBuf> {
    let output = Command::new("rustc")
        .args(["--print", "sysroot"])
        .output()
        .during(|| "asking rustc where it lies".to_string())?;
    let sysroot = PathBuf::from(String::from_utf8_lossy(&output.stdout).trim());
    let hosts = sysroot.join("lib/rustlib");
    fs::read_dir(&hosts)
        .during(|| format!("reading {}", hosts.display()))?
        .flatten()
        .map(|host| host.path().join("bin").join("rust-lld"))
        .find(|program| program.is_file())
        .ok_or_else(|| Failure::lacking(format!("no rust-lld below {}", hosts.display())))
}
