//! `microbrdf compare`.

use std::fs;
use std::path::Path;

use microbrdf_scene::Description;
use serde_json::{Value, json};

use crate::arithmetic::ArithmeticName;
use crate::cli::Compare;
use crate::exit::{Failure, Outcome};
use crate::measure::{JUMP, Measured, heat_map};
use crate::picture::Picture;
use crate::reference_picture::Exact;
use crate::{reference_picture, render};

/// Measures renderings, or what a device sent, against the reference.
pub fn run(arguments: &Compare) -> Outcome<()> {
    let one = arguments.arithmetic.len() == 1;
    if arguments.device.is_some() && !one {
        return Err(Failure::Usage(
            "--device: needs exactly one --arithmetic".to_owned(),
        ));
    }
    let description = Description::from_file(&arguments.scene)?;
    let device = arguments
        .device
        .as_deref()
        .map(Picture::read_png)
        .transpose()?;
    if let Some(device) = &device {
        let size = (device.width, device.height);
        let expected = (
            usize::from(description.camera.width),
            usize::from(description.camera.height),
        );
        if size != expected {
            return Err(Failure::Usage(format!(
                "--device: a picture of {} x {} pixels: must be {} x {}, as the scene's",
                size.0, size.1, expected.0, expected.1,
            )));
        }
    }
    let exact = reference_picture::render(&description);
    if let Some(out) = &arguments.out {
        fs::create_dir_all(out)
            .map_err(|error| Failure::Usage(format!("{}: {error}", out.display())))?;
        exact.srgb().write_png(&out.join("reference.png"))?;
    }
    let mut reports = Vec::new();
    let mut differs = None;
    for &arithmetic in &arguments.arithmetic {
        let host = render::frame(&description, arithmetic)?.srgb();
        let shown = device.as_ref().unwrap_or(&host);
        if let Some(out) = &arguments.out {
            write_pictures(
                out,
                if one { None } else { Some(arithmetic) },
                &host,
                shown,
                &exact,
            )?;
        }
        let measured = Measured::new(shown, &exact);
        let equal = device.as_ref().map(|device| *device == host);
        if equal == Some(false) {
            differs = arguments.device.as_deref();
        }
        if !arguments.json {
            print(arithmetic, &measured, equal)?;
        }
        reports.push(report(&description, arithmetic, &measured, equal));
    }
    if arguments.json {
        let report = if one {
            reports.remove(0)
        } else {
            Value::Array(reports)
        };
        super::print(&format!("{report:#}\n"))?;
    }
    match differs {
        Some(file) => Err(Failure::Incomplete(format!(
            "{}: differs from the host's picture",
            file.display()
        ))),
        None => Ok(()),
    }
}

fn write_pictures(
    out: &Path,
    name: Option<ArithmeticName>,
    host: &Picture,
    shown: &Picture,
    exact: &Exact,
) -> Outcome<()> {
    let file = |stem: &str| match name {
        None => out.join(format!("{stem}.png")),
        Some(name) => out.join(format!("{stem}-{}.png", name.name())),
    };
    host.write_png(&file("host"))?;
    heat_map(shown, exact).write_png(&file("error"))
}

fn report(
    description: &Description,
    arithmetic: ArithmeticName,
    measured: &Measured,
    equal: Option<bool>,
) -> Value {
    let mut report = measured.json();
    report["arithmetic"] = json!(arithmetic.name());
    report["exposure"] = json!(description.exposure);
    if let Some(equal) = equal {
        report["device_equals_host"] = json!(equal);
    }
    report
}

/// What is printed for an arithmetic.
#[must_use]
pub fn line(arithmetic: ArithmeticName, measured: &Measured) -> String {
    format!(
        "{}: greatest error {:.3} LSB, {} codes; {:.3} % off by one, {:.3} % by more; \
         {} class flips (within {JUMP:e} of a jump); CIEDE2000 {:.3} at most",
        arithmetic.name(),
        measured.lsb_error_max,
        measured.code_error_max,
        100.0 * measured.off_by_one,
        100.0 * measured.off_by_more,
        measured.class_flips,
        measured.delta_e_max,
    )
}

fn print(arithmetic: ArithmeticName, measured: &Measured, equal: Option<bool>) -> Outcome<()> {
    super::print(&format!("{}\n", line(arithmetic, measured)))?;
    match equal {
        Some(true) => super::print("the device's picture equals the host's\n"),
        _ => Ok(()),
    }
}
