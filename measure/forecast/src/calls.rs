//! The rows that an emulated core is to shade, with what they must give.

use std::path::Path;

use anyhow::{Result, anyhow};
use clap::ValueEnum as _;
use microbrdf_scene::Description;
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_sim::picture::Picture;
use microbrdf_sim::render;
use serde_json::{Value, json};

/// Where the results lie in an emulated core's RAM.
const BASE: u32 = 0x2000_0000;

/// Rows of a scene that are counted: every so many.
pub fn rows(height: usize, every: usize) -> impl Iterator<Item = usize> {
    (every / 2..height).step_by(every.max(1))
}

/// A scene and its arithmetic, by name.
pub fn read(scene: &Path, arithmetic: &str) -> Result<(Description, ArithmeticName)> {
    let description = Description::from_file(scene).map_err(|error| anyhow!("{error}"))?;
    let name = ArithmeticName::from_str(arithmetic, false).map_err(|error| anyhow!(error))?;
    Ok((description, name))
}

/// The picture of a scene, rendered here.
pub fn picture_of(scene: &Path, arithmetic: &str) -> Result<Picture> {
    let (description, name) = read(scene, arithmetic)?;
    let frame = render::frame(&description, name).map_err(|error| anyhow!("{error}"))?;
    Ok(frame.srgb())
}

/// The picture in a file.
pub fn picture_in(path: &Path) -> Result<Picture> {
    Picture::read_png(path).map_err(|error| anyhow!("{error}"))
}

/// The calls for a picture's rows.
pub fn of_picture(picture: &Picture, every: usize) -> Value {
    let call = |y: usize| {
        let row = &picture.pixels[y * picture.width..(y + 1) * picture.width];
        let bytes: Vec<u8> = row.iter().flatten().copied().collect();
        let words: Vec<u32> = bytes
            .chunks(4)
            .map(|chunk| {
                let mut word = [0; 4];
                word[..chunk.len()].copy_from_slice(chunk);
                u32::from_le_bytes(word)
            })
            .collect();
        json!({ "arguments": [y, BASE], "memory": [], "results": words, "in_memory": true })
    };
    let calls: Vec<_> = rows(picture.height, every).map(call).collect();
    json!([{ "kernel": "row", "groups": [{ "kind": "row", "calls": calls }] }])
}

/// The calls that tell what packing takes: one row, and three.
pub fn of_packing() -> Value {
    let call = |rows: u32| {
        json!({
            "arguments": [rows],
            "memory": [],
            "results": [microbrdf_row::pack(rows)],
            "in_memory": false,
        })
    };
    let calls = PACKED.map(call);
    json!([{ "kernel": "pack", "groups": [{ "kind": "row", "calls": calls }] }])
}

/// Rows of the two calls.
const PACKED: [u32; 2] = [1, 3];

/// Cycles a byte from the cycles of the two calls.
pub fn packing(cycles: &[f64]) -> Option<f64> {
    let [one, three] = cycles else { return None };
    let rows = f64::from(PACKED[1] - PACKED[0]);
    Some((three - one) / rows / microbrdf_row::ROW_BYTES as f64)
}
