//! What needs no arithmetic: encodings, and the knots of curves.

use microbrdf::shade::{LINEAR_ONE, Linear, grey16, srgb8};
use microbrdf::table::{COSINE_KNOTS, CosineCurve};
use microbrdf_bits::Checksum;

use crate::Sums;

/// Adds a sum for each.
pub fn add(sums: &mut Sums) {
    let steps: Vec<u32> = (0..=255u8).map(first).collect();
    let mut sum = Checksum::new();
    for step in &steps {
        sum.feed(*step);
    }
    for linear in (0..LINEAR_ONE + 5_000).step_by(61).chain([u32::MAX]) {
        sum.feed(u32::from(srgb8(linear)));
    }
    sums.push("srgb", sum.value());

    let mut sum = Checksum::new();
    for (code, step) in steps.iter().enumerate() {
        let (next, last) = (steps[(code + 85) % 256], steps[255 - code]);
        let pixel = Linear::from_raw(*step, next, last);
        sum.feed(u32::from(pixel.rgb565()));
        for code in pixel.srgb8() {
            sum.feed(u32::from(code));
        }
        sum.feed(pixel.luminance());
        for component in Linear::from_raw(step + LINEAR_ONE / 2, last + 4_095, !*step).to_raw() {
            sum.feed(component);
        }
        for at in 0..25 {
            sum.feed(u32::from(grey16(*step, at % 5, at / 5)));
        }
    }
    sums.push("pixels", sum.value());

    let mut sum = Checksum::new();
    for index in 0..COSINE_KNOTS + 3 {
        sum.feed(u32::from(CosineCurve::knot(index)));
    }
    sums.push("knots", sum.value());
}

/// The least linear value with a code.
fn first(code: u8) -> u32 {
    let (mut low, mut high) = (0, LINEAR_ONE);
    while low < high {
        let middle = (low + high) / 2;
        if srgb8(middle) < code {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    low
}
