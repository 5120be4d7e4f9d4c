//! A scene in one arithmetic, row by row on all cores.

use microbrdf::arithmetic::Float;
use microbrdf::shade::Linear;
use microbrdf_scene::{Description, HostArithmetic, Native, Prepared, SceneParts, WideScene};
use rayon::prelude::*;

use super::Frame;
use super::encode::encode;
use crate::arithmetic::ArithmeticName;
use crate::exit::{Failure, Outcome};
use crate::picture::Picture;
use crate::progress::Progress;
use crate::with_arithmetic;

/// A scene, ready to be shaded as often as one likes.
pub struct Renderer<'a> {
    description: &'a Description,
    paint: Box<dyn Fn(Target<'_>) + 'a>,
}

/// What pixels are shaded into.
enum Target<'a> {
    Linear(&'a mut [Linear]),
    /// Encoded row by row: light in between does not leave the cache.
    Srgb(&'a mut [[u8; 3]]),
}

impl<'a> Renderer<'a> {
    /// The scene in an arithmetic.
    ///
    /// # Errors
    /// A material that the arithmetic does not take.
    pub fn new(description: &'a Description, arithmetic: ArithmeticName) -> Outcome<Self> {
        let paint = if arithmetic == ArithmeticName::F32 {
            // The same bits, sooner.
            let prepared = prepared::<Float<Native>>(description)?;
            match WideScene::new(&prepared) {
                Some(scene) => together(description, scene),
                None => one_by_one(description, prepared),
            }
        } else {
            with_arithmetic!(arithmetic, A => one_by_one(description, prepared::<A>(description)?))
        };
        Ok(Self { description, paint })
    }

    /// Pixels in linear light.
    pub fn frame(&self) -> Frame {
        let [width, height] = size(self.description);
        let mut pixels = vec![Linear::default(); width * height];
        (self.paint)(Target::Linear(&mut pixels));
        Frame {
            width,
            height,
            pixels,
            dither: self.description.dither,
        }
    }

    /// Pixels in 8-bit sRGB: those of [`Frame::srgb`].
    pub fn srgb(&self) -> Picture {
        let [width, height] = size(self.description);
        let mut pixels = vec![[0; 3]; width * height];
        (self.paint)(Target::Srgb(&mut pixels));
        Picture {
            width,
            height,
            pixels,
        }
    }
}

fn size(description: &Description) -> [usize; 2] {
    let camera = &description.camera;
    [camera.width, camera.height].map(usize::from)
}

fn prepared<A: HostArithmetic>(description: &Description) -> Outcome<Prepared<A>> {
    description.prepare::<A>().map_err(Failure::Usage)
}

/// Several pixels at a time.
fn together(description: &Description, scene: WideScene) -> Box<dyn Fn(Target<'_>) + '_> {
    Box::new(move |target| {
        paint(description, target, |y, row| scene.shade_row(y, row));
    })
}

/// Pixel by pixel, by the core's own row function.
fn one_by_one<A: HostArithmetic>(
    description: &Description,
    prepared: Prepared<A>,
) -> Box<dyn Fn(Target<'_>) + '_> {
    let parts = SceneParts::new(prepared);
    Box::new(move |target| {
        let surfaces = parts.surfaces();
        let scene = parts.scene(&surfaces);
        paint(description, target, |y, row| {
            scene.shade_row(y, |x, light| row[x] = light);
        });
    })
}

/// Shades all rows, on all cores.
fn paint(
    description: &Description,
    target: Target<'_>,
    shade: impl Fn(usize, &mut [Linear]) + Sync,
) {
    let [width, height] = size(description);
    let progress = Progress::new("shading", height);
    match target {
        Target::Linear(pixels) => {
            let rows = pixels.par_chunks_exact_mut(width).enumerate();
            rows.for_each(|(y, row)| {
                shade(y, row);
                progress.step();
            });
        }
        Target::Srgb(codes) => {
            let rows = codes.par_chunks_exact_mut(width).enumerate();
            let buffer = || vec![Linear::default(); width];
            rows.for_each_init(buffer, |row, (y, codes)| {
                shade(y, row);
                encode(row, codes);
                progress.step();
            });
        }
    }
}
