//! `cargo xtask demo`: shade a scene on an emulated board, receive it, and set it beside host and reference.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::failure::{During, Failure, Outcome};
use crate::firmware::{self, Order};
use crate::host_sim::HostSim;
use crate::layout::Layout;
use crate::picture::Picture;
use crate::qemu::Emulator;
use crate::receiver::Reception;
use crate::report;
use crate::toolchain::Cross;

/// Files that a run writes, beside the `device.png` of the receiver.
const MADE: [&str; 7] = [
    "host.png",
    "reference.png",
    "error.png",
    "panel.png",
    "panel-host.png",
    "receiver.json",
    "report.json",
];

/// `cargo xtask demo`. A failure of status 1 keeps, and reports, what arrived.
pub fn command(layout: &Layout, cross: &Cross, order: &Order, out: &Path) -> Outcome<()> {
    println!("{}", cross.chosen(layout));
    let host = HostSim::build(layout, false)?;
    let shown = layout.shown(out);
    let report = run(layout, cross, &host, order, out, false)?;
    print!("{}", report::lines(&report));
    let mut names = vec!["device.png", "host.png", "reference.png", "error.png"];
    if order.board.panel {
        names.push("panel.png");
    }
    names.retain(|name| out.join(name).is_file());
    println!(
        "pictures   {shown}: {}; figures in report.json",
        names.join(", ")
    );
    let faults = report::faults(&report);
    if faults.is_empty() {
        return Ok(());
    }
    Err(Failure::incomplete(format!(
        "{}; what arrived is kept in {shown}",
        faults.join("; ")
    )))
}

/// Builds, boots, receives, compares; writes the pictures and `report.json` into `out` and returns the report.
pub fn run(
    layout: &Layout,
    cross: &Cross,
    host: &HostSim<'_>,
    order: &Order,
    out: &Path,
    quiet: bool,
) -> Outcome<Value> {
    let image = firmware::build(layout, cross, host, order, quiet)?;
    println!("{}", firmware::describe(layout, order, &image));
    fs::create_dir_all(out).during(|| format!("creating {}", out.display()))?;
    let place = |name: &str| out.join(name);
    // Nothing of an earlier run is left to be taken for this one's.
    for name in MADE {
        let _ = fs::remove_file(place(name));
    }

    let mut emulator = Emulator::halted(layout, &order.board, &image.elf)?;
    let mut reception = Reception::into(out);
    if quiet {
        reception.messages = Some(place("receiver.log"));
    }
    let device = reception.picture.clone();
    let received = reception.run(layout, &mut emulator)?;
    let _ = fs::remove_file(&reception.report);
    if order.board.panel {
        photograph(&mut emulator, &place("panel.png"))?;
    }
    let stack = emulator.stack_used()?;
    drop(emulator);

    let compared = if device.is_file() {
        compare(host, order, &device, out)?
    } else {
        Value::Null
    };
    let panel_equals_host = match order.board.panel {
        true => Some(panel_equals_host(host, order, out)?),
        false => None,
    };
    let mut report = report::assemble(
        &order.board,
        cross.version(),
        &order.arithmetic,
        &received.report,
        &compared,
        panel_equals_host,
    );
    report["flash_bytes"] = image.sizes.flash.into();
    report["ram_bytes"] = image.sizes.ram.into();
    report["stack_bytes"] = stack.into();
    let path = place("report.json");
    let text = format!("{report:#}\n");
    fs::write(&path, text).during(|| format!("writing {}", path.display()))?;
    if !received.status.success() && report::faults(&report).is_empty() {
        return Err(Failure::incomplete(format!(
            "the receiver ended with {} but reports a whole frame",
            received.status
        )));
    }
    Ok(report)
}

/// Host's picture, reference, heat map, and the figures.
fn compare(host: &HostSim<'_>, order: &Order, device: &Path, out: &Path) -> Outcome<Value> {
    let figures = host.run_to_differ([
        "compare".as_ref(),
        order.scene.as_os_str(),
        "--arithmetic".as_ref(),
        order.arithmetic.as_ref(),
        "--device".as_ref(),
        device.as_os_str(),
        "--out".as_ref(),
        out.as_os_str(),
        "--json".as_ref(),
    ])?;
    serde_json::from_str(&figures)
        .during(|| format!("reading what `microbrdf compare` printed, {figures:?}"))
}

/// Photographs the board's display as it stands.
fn photograph(emulator: &mut Emulator, png: &Path) -> Outcome<()> {
    let ppm = png.with_extension("ppm");
    emulator.photograph(&ppm)?;
    let picture = Picture::read_ppm(&ppm)?;
    let _ = fs::remove_file(&ppm);
    picture.write_png(png)
}

/// Whether the photograph is what the host predicts, pixel for pixel.
fn panel_equals_host(host: &HostSim<'_>, order: &Order, out: &Path) -> Outcome<bool> {
    let predicted = out.join("panel-host.png");
    host.run([
        "render".as_ref(),
        order.scene.as_os_str(),
        "--arithmetic".as_ref(),
        order.arithmetic.as_ref(),
        "--panel".as_ref(),
        predicted.as_os_str(),
    ])?;
    let photograph = Picture::read_png(&out.join("panel.png"))?;
    Ok(photograph.differing(&Picture::read_png(&predicted)?) == Some(0))
}
