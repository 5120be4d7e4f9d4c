//! `microbrdf chart`.

use microbrdf_scene::HostArithmetic;

use crate::arithmetic::ArithmeticName;
use crate::chart::{BANDS, Band, Panel, Plane, panel};
use crate::cli::Chart;
use crate::drawing::card;
use crate::exit::{Failure, Outcome};
use crate::progress::Progress;
use crate::with_arithmetic;

/// Draws the test card of each arithmetic that is asked for.
pub fn run(arguments: &Chart) -> Outcome<()> {
    if !(1e-3..=2e7).contains(&arguments.exposure) {
        return Err(Failure::Usage(format!(
            "--exposure {}: must be a number from 1e-3 to 2e7",
            arguments.exposure
        )));
    }
    let out = &arguments.out;
    std::fs::create_dir_all(out)
        .map_err(|error| Failure::Usage(format!("--out {}: {error}", out.display())))?;
    let names = if arguments.arithmetic.is_empty() {
        &ArithmeticName::ALL[..]
    } else {
        &arguments.arithmetic
    };
    let panels = names.len() * BANDS.len() * Plane::ALL.len();
    let progress = Progress::new("panels", panels);
    for &name in names {
        let bands = with_arithmetic!(name, A => bands::<A>(name, arguments.exposure, &progress))?;
        let path = out.join(format!("chart-{}.png", name.name()));
        card(name.name(), arguments.exposure, &bands)?.write_png(&path)?;
        super::print(&report(name, &bands))?;
    }
    Ok(())
}

fn bands<A: HostArithmetic>(
    name: ArithmeticName,
    exposure: f64,
    progress: &Progress,
) -> Outcome<Vec<(Band, [Panel; 2])>> {
    let draw = |band: &Band, plane| {
        let drawn = panel::<A>(band, plane, exposure);
        progress.step();
        drawn.map_err(|error| {
            Failure::Incomplete(format!("{}, {}: {error}", name.name(), band.label))
        })
    };
    BANDS
        .into_iter()
        .map(|band| {
            let [incidence, sideways] = Plane::ALL;
            Ok((band, [draw(&band, incidence)?, draw(&band, sideways)?]))
        })
        .collect()
}

/// One line a band: its greatest error and where.
fn report(name: ArithmeticName, bands: &[(Band, [Panel; 2])]) -> String {
    let mut text = String::new();
    for (band, [incidence, sideways]) in bands {
        let (plane, worst) = if incidence.worst.lsb >= sideways.worst.lsb {
            ("in the plane of incidence", incidence.worst)
        } else {
            ("sideways", sideways.worst)
        };
        text += &format!(
            "{}, {}: at most {:.3} LSB, {plane} at {} = {:.3}, cosine {:.2e}\n",
            name.name(),
            band.label,
            worst.lsb,
            band.across.name(),
            worst.across,
            worst.cosine
        );
    }
    text
}
