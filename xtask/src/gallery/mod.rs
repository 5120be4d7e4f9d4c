//! `cargo xtask gallery`: the scenes of the gallery on emulated boards, beside host and reference; makes `docs/gallery.md` and its pictures.

mod document;
mod exhibits;
mod hanging;

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::board::Board;
use crate::demo;
use crate::failure::{During, Failure, Outcome};
use crate::firmware::Order;
use crate::forecast::{Program, held};
use crate::host_sim::HostSim;
use crate::layout::Layout;
use crate::picture::Picture;
use crate::report;
use crate::toolchain::Cross;
use exhibits::{EXHIBITS, Exhibit};

/// Boards, each with the arithmetic that suits it; the pictures are the first one's.
const RUNS: [(&str, &str); 2] = [("lm3s6965evb", "q31"), ("microbit", "q15")];

/// One of so many rows is counted.
const EVERY: usize = 32;

/// The test card: no scene, so no device.
const CHART: &str = "chart";

/// What became of an exhibit: its picture, and a report of each run.
struct Shown {
    exhibit: &'static Exhibit,
    reports: Vec<Value>,
    picture: Picture,
    /// Where a forecast was off.
    off: Vec<String>,
}

/// `cargo xtask gallery`.
pub fn command(layout: &Layout, cross: &Cross) -> Outcome<()> {
    println!("{}", cross.chosen(layout));
    let host = HostSim::build(layout, false)?;
    let program = Program::build(layout, false)?;
    let mut shown = Vec::new();
    for exhibit in EXHIBITS {
        shown.push(show(layout, cross, &host, &program, exhibit)?);
    }
    let text = document::markdown(&shown, cross.version());
    let path = layout.at("docs/gallery.md");
    fs::write(&path, text).during(|| format!("writing {}", path.display()))?;
    let folder = layout.at("docs/gallery");
    fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
    for Shown {
        exhibit, picture, ..
    } in &shown
    {
        picture.write_png(&kept(layout, exhibit.name))?;
    }
    chart(layout, &host)?.write_png(&kept(layout, CHART))?;
    println!("wrote docs/gallery.md and docs/gallery/");
    outdated(shown.into_iter().flat_map(|shown| shown.off).collect())
}

/// Names of the exhibits, a step of the tests for each.
pub fn names() -> impl Iterator<Item = &'static str> {
    let scenes = EXHIBITS.iter().map(|exhibit| exhibit.name);
    scenes.chain([CHART])
}

/// Makes an exhibit anew and compares it with what is kept.
pub fn check(layout: &Layout, cross: &Cross, name: &str) -> Outcome<()> {
    let host = HostSim::build(layout, true)?;
    if name == CHART {
        return outdated(same(layout, name, &chart(layout, &host)?)?);
    }
    let Some(exhibit) = EXHIBITS.iter().find(|exhibit| exhibit.name == name) else {
        return Err(Failure::mistake(format!("no exhibit is called {name}")));
    };
    let program = Program::build(layout, true)?;
    let shown = show(layout, cross, &host, &program, exhibit)?;
    let mut faults = same(layout, name, &shown.picture)?;
    faults.extend(shown.off.iter().cloned());
    let path = layout.at("docs/gallery.md");
    let text = fs::read_to_string(&path).during(|| format!("reading {}", path.display()))?;
    let section = document::section(&shown);
    if !document::has(&text, &section) {
        faults.push(format!("docs/gallery.md does not have\n{section}"));
    }
    outdated(faults)
}

fn outdated(faults: Vec<String>) -> Outcome<()> {
    if faults.is_empty() {
        return Ok(());
    }
    Err(Failure::incomplete(format!(
        "{}\n`cargo xtask gallery` makes them anew",
        faults.join("\n")
    )))
}

fn kept(layout: &Layout, name: &str) -> PathBuf {
    layout.at(&format!("docs/gallery/{name}.png"))
}

/// Where a picture differs from the one that is kept.
fn same(layout: &Layout, name: &str, picture: &Picture) -> Outcome<Vec<String>> {
    let kept = kept(layout, name);
    Ok(match Picture::read_png(&kept)?.differing(picture) {
        Some(0) => Vec::new(),
        Some(pixels) => vec![format!("{} differs in {pixels} pixels", kept.display())],
        None => vec![format!("{} has another size", kept.display())],
    })
}

/// The test card of `q15`.
fn chart(layout: &Layout, host: &HostSim<'_>) -> Outcome<Picture> {
    let folder = layout.target().join("gallery");
    host.run([
        "chart".as_ref(),
        "--arithmetic".as_ref(),
        "q15".as_ref(),
        "--out".as_ref(),
        folder.as_os_str(),
    ])?;
    Picture::read_png(&folder.join("chart-q15.png"))
}

/// Runs an exhibit on every board. A frame that is not whole or not the host's is a failure.
fn show(
    layout: &Layout,
    cross: &Cross,
    host: &HostSim<'_>,
    program: &Program<'_>,
    exhibit: &'static Exhibit,
) -> Outcome<Shown> {
    let scene = ["scenes/gallery", "scenes"]
        .map(|folder| layout.at(&format!("{folder}/{}.toml", exhibit.name)))
        .into_iter()
        .find(|path| path.is_file());
    let Some(scene) = scene else {
        return Err(Failure::incomplete(format!(
            "there is no scene {}",
            exhibit.name
        )));
    };
    let (mut reports, mut off) = (Vec::new(), Vec::new());
    let folder = |board: &str| {
        layout
            .target()
            .join("gallery")
            .join(format!("{}-{board}", exhibit.name))
    };
    for (board, arithmetic) in RUNS {
        let order = Order {
            board: Board::named(board)?,
            scene: scene.clone(),
            arithmetic: arithmetic.to_owned(),
            features: Vec::new(),
        };
        let out = folder(board);
        let mut report = demo::run(layout, cross, host, &order, &out, true)?;
        held::add(
            layout,
            cross,
            host,
            program,
            (&order, &out),
            EVERY,
            &mut report,
        )?;
        print!("{}{}", report::lines(&report), held::line(&report));
        let faults = report::faults(&report);
        off.extend(held::faults(&report));
        if !faults.is_empty() {
            return Err(Failure::incomplete(faults.join("; ")));
        }
        reports.push(report);
    }
    let picture = picture(host, exhibit, &scene, &folder(RUNS[0].0))?;
    Ok(Shown {
        exhibit,
        reports,
        picture,
        off,
    })
}

/// The device's picture, the reference's and the error, side by side, and what stands beside them below.
fn picture(host: &HostSim<'_>, exhibit: &Exhibit, scene: &Path, folder: &Path) -> Outcome<Picture> {
    let read = |name: &str| Picture::read_png(&folder.join(name));
    let mut rows = vec![hanging::in_a_row(&[
        read("device.png")?,
        read("reference.png")?,
        read("error.png")?,
    ])];
    if let Some(beside) = exhibit.beside {
        rows.push(hanging::in_a_row(&hanging::beside(
            host, beside, scene, folder,
        )?));
    }
    Ok(hanging::stacked(&rows))
}
