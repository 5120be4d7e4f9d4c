//! `microbrdf bench`.

use std::hint::black_box;
use std::time::Instant;

use microbrdf_scene::Description;

use crate::arithmetic::ArithmeticName;
use crate::bench::plain::Plain;
use crate::cli::Bench;
use crate::exit::{Failure, Outcome};
use crate::reference_picture::Renderer;
use crate::render;

/// Renders the scene once.
type Turn<'a> = Box<dyn Fn() + 'a>;

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
    // Ready before the clock starts: tables and models are not pixels.
    let plain = Plain::new(&scene).map_err(Failure::Usage)?;
    let exact = Renderer::new(&scene);
    let mut renderers: Vec<(&str, Turn<'_>)> = Vec::new();
    for name in ArithmeticName::ALL {
        let renderer = render::Renderer::new(&scene, name)?;
        let turn = move || drop(black_box(renderer.srgb()));
        renderers.push((name.name(), Box::new(turn)));
    }
    renderers.push((
        "reference, f64",
        Box::new(|| drop(black_box(exact.render().srgb()))),
    ));
    renderers.push((
        "plain, f32 powf",
        Box::new(|| drop(black_box(plain.render()))),
    ));
    let mut times = vec![Vec::new(); renderers.len()];
    for _ in 0..arguments.repeat {
        for ((_, render), times) in renderers.iter().zip(&mut times) {
            let started = Instant::now();
            render();
            times.push(started.elapsed().as_secs_f64());
        }
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
    for ((name, _), median) in renderers.iter().zip(&medians) {
        text.push_str(&format!(
            "{name:16} {:7.1} ns a pixel; {:5.2} times as fast as the reference, {:5.2} as plain f32\n",
            1e9 * median / pixels,
            reference / median,
            plain / median
        ));
    }
    super::print(&text)?;
    // The first is f32, which is what pictures are to come fast in.
    let slower = reference.min(plain) / medians.first().copied().unwrap_or(f64::INFINITY);
    match arguments.at_least {
        Some(least) if slower.is_nan() || slower < least => Err(Failure::Incomplete(format!(
            "f32 is {slower:.2} times as fast as another renderer: --at-least {least}"
        ))),
        _ => Ok(()),
    }
}

fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(f64::NAN)
}
