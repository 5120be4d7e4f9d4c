//! Pictures put side by side.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;

use super::exhibits::Beside;
use crate::failure::{During, Outcome};
use crate::host_sim::HostSim;
use crate::picture::Picture;

/// Pixels between pictures, and their colour.
const GAP: u32 = 4;
const WALL: u8 = 40;

/// Further pictures of an exhibit, made by the host.
pub fn beside(
    host: &HostSim<'_>,
    beside: Beside,
    scene: &Path,
    folder: &Path,
) -> Outcome<Vec<Picture>> {
    let render = |scene: &Path, name: &str, options: &[&str], output: &str| -> Outcome<Picture> {
        let path = folder.join(name);
        let mut arguments = vec!["render".as_ref(), scene.as_os_str()];
        arguments.extend(options.iter().map(OsStr::new));
        arguments.extend([output.as_ref(), path.as_os_str()]);
        host.run(arguments)?;
        Picture::read_png(&path)
    };
    match beside {
        Beside::Facets => Ok(vec![render(
            scene,
            "facets.png",
            &["--arithmetic", "reference", "--facets", "0.1"],
            "--output",
        )?]),
        Beside::Dither => {
            let text =
                fs::read_to_string(scene).during(|| format!("reading {}", scene.display()))?;
            let banded = folder.join("banded.toml");
            fs::write(&banded, format!("dither = false\n{text}"))
                .during(|| format!("writing {}", banded.display()))?;
            Ok(vec![
                render(&banded, "banded.png", &[], "--rgb565")?,
                render(scene, "dithered.png", &[], "--rgb565")?,
            ])
        }
    }
}

/// From left to right, their tops in a line.
pub fn in_a_row(pictures: &[Picture]) -> Picture {
    let gaps = GAP * (pictures.len().max(1) as u32 - 1);
    let width = pictures.iter().map(|picture| picture.width).sum::<u32>() + gaps;
    let height = pictures.iter().map(|picture| picture.height).max();
    let mut wall = blank(width, height.unwrap_or(0));
    let mut x = 0;
    for picture in pictures {
        hang(&mut wall, picture, x, 0);
        x += picture.width + GAP;
    }
    wall
}

/// One below the other, their left edges in a line.
pub fn stacked(pictures: &[Picture]) -> Picture {
    let gaps = GAP * (pictures.len().max(1) as u32 - 1);
    let height = pictures.iter().map(|picture| picture.height).sum::<u32>() + gaps;
    let width = pictures.iter().map(|picture| picture.width).max();
    let mut wall = blank(width.unwrap_or(0), height);
    let mut y = 0;
    for picture in pictures {
        hang(&mut wall, picture, 0, y);
        y += picture.height + GAP;
    }
    wall
}

fn blank(width: u32, height: u32) -> Picture {
    Picture {
        width,
        height,
        rgb: vec![WALL; (3 * width * height) as usize],
    }
}

/// Copies a picture into a larger one.
fn hang(wall: &mut Picture, picture: &Picture, x: u32, y: u32) {
    let bytes = 3 * picture.width as usize;
    for (row, pixels) in picture.rgb.chunks_exact(bytes.max(1)).enumerate() {
        let start = 3 * ((y as usize + row) * wall.width as usize + x as usize);
        wall.rgb[start..start + bytes].copy_from_slice(pixels);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(value: u8) -> Picture {
        Picture {
            width: 1,
            height: 1,
            rgb: vec![value; 3],
        }
    }

    #[test]
    fn pictures_keep_their_places() {
        let row = in_a_row(&[one(1), one(2)]);
        assert_eq!((row.width, row.height), (2 + GAP, 1));
        assert_eq!((row.rgb[0], row.rgb[3 * (1 + GAP as usize)]), (1, 2));
        let both = stacked(&[row, one(3)]);
        assert_eq!((both.width, both.height), (2 + GAP, 2 + GAP));
        let below = 3 * (1 + GAP as usize) * both.width as usize;
        assert_eq!((both.rgb[below], both.rgb[below + 3]), (3, WALL));
    }
}
