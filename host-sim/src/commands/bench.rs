//! `microbrdf bench`.

use std::hint::black_box;
use std::time::Instant;

use microbrdf_scene::Description;

use crate::arithmetic::ArithmeticName;
use crate::bench::plain::Plain;
use crate::cli::Bench;
use crate::exit::{Failure, Outcome};
use crate::{reference_picture, render};

/// Most columns and rows of the enlarged scene.
const GREATEST: u16 = 1024;

/// Measures the renderers in turn, in one run, and prints the medians and
/// their ratios.
pub fn run(arguments: &Bench) -> Outcome<()> {
    let mut scene = Description::from_file(&arguments.scene)?;
    // The same picture in more pixels: nothing but pixels is to be measured.
    let side = scene.camera.width.max(scene.camera.height);
    let factor = (GREATEST / side).max(1);
    scene.camera.width *= factor;
    scene.camera.height *= factor;
    let plain = Plain::new(&scene).map_err(Failure::Usage)?;
    let mut names: Vec<String> = ArithmeticName::ALL
        .iter()
        .map(|name| name.name().to_owned())
        .collect();
    names.extend(["reference, f64".to_owned(), "plain, f32 powf".to_owned()]);
    let mut times = vec![Vec::new(); names.len()];
    for _ in 0..arguments.repeat {
        let mut turns = times.iter_mut();
        let mut timed = |render: &dyn Fn() -> Outcome<()>| -> Outcome<()> {
            let started = Instant::now();
            render()?;
            if let Some(times) = turns.next() {
                times.push(started.elapsed().as_secs_f64());
            }
            Ok(())
        };
        for name in ArithmeticName::ALL {
            timed(&|| {
                black_box(render::frame(&scene, name)?.srgb());
                Ok(())
            })?;
        }
        timed(&|| {
            black_box(reference_picture::render(&scene).srgb());
            Ok(())
        })?;
        timed(&|| {
            black_box(plain.render());
            Ok(())
        })?;
    }
    let medians: Vec<f64> = times.iter_mut().map(|times| median(times)).collect();
    let pixels = f64::from(scene.camera.width) * f64::from(scene.camera.height);
    let [.., reference, plain] = medians[..] else {
        return Ok(());
    };
    let mut text = format!(
        "{} x {} pixels, {} threads, medians of {}\n",
        scene.camera.width,
        scene.camera.height,
        rayon::current_num_threads(),
        arguments.repeat
    );
    for (name, median) in names.iter().zip(&medians) {
        text.push_str(&format!(
            "{name:16} {:7.1} ns a pixel; {:5.2} times as fast as the reference, {:5.2} as plain f32\n",
            1e9 * median / pixels,
            reference / median,
            plain / median
        ));
    }
    super::print(&text)
}

fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(f64::NAN)
}
