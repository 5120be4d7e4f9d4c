//! What needs no arithmetic: encodings, and the knots of curves.

use microbrdf::shade::{
    LINEAR_ONE, Linear, Octahedral, Palette565, grey16, srgb8, srgb8_bisected, srgb8_direct,
    srgb8_quick,
};
use microbrdf::table::{COSINE_KNOTS, CosineCurve, ProfileCurve};
use microbrdf_bits::Checksum;

use crate::Sums;

/// Linear light to a code.
type Encoder = fn(u32) -> u8;

/// Adds a sum for each.
pub fn add(sums: &mut Sums) {
    let encoders: [(&str, Encoder); 3] = [
        ("srgb", srgb8),
        ("srgb, bisected", srgb8_bisected),
        ("srgb, quick", srgb8_quick),
    ];
    for (name, encoder) in encoders {
        let mut sum = Checksum::new();
        for code in 0..=255 {
            sum.feed(first(encoder, code));
        }
        for linear in (0..LINEAR_ONE + 5_000).step_by(61).chain([u32::MAX]) {
            sum.feed(u32::from(encoder(linear)));
        }
        sums.push(name, sum.value());
    }

    let steps: Vec<u32> = (0..=255).map(|code| first(srgb8, code)).collect();

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
    for (code, step) in steps.iter().enumerate() {
        let pixel = Linear::from_raw(*step, steps[(code + 85) % 256], steps[255 - code]);
        for at in 0..25 {
            sum.feed(u32::from(pixel.rgb565_dithered(at % 5, at / 5)));
        }
    }
    sums.push("dithered pixels", sum.value());

    let mut sum = Checksum::new();
    for tint in [
        [LINEAR_ONE; 3],
        [LINEAR_ONE / 2, LINEAR_ONE / 3, 5],
        [u32::MAX, 0, 12_345_678],
    ] {
        let palette = Palette565::new(tint);
        for light in (0..LINEAR_ONE + 70_000).step_by(509).chain([u32::MAX]) {
            sum.feed(u32::from(palette.at(light)));
        }
    }
    sums.push("palettes", sum.value());

    let mut sum = Checksum::new();
    let palette = Palette565::new([LINEAR_ONE, LINEAR_ONE / 3, 12_345]);
    for light in 0..=u16::MAX {
        sum.feed(u32::from(srgb8_direct(light)));
        sum.feed(u32::from(palette.at_short(light)));
    }
    sums.push("light of 16 bits", sum.value());

    let codes = (0..=u32::MAX).step_by(65_521 * 9);
    sums.push(
        "normals of three bytes",
        normals(codes.clone().map(|code| {
            let [_, a, b, c] = code.to_le_bytes();
            [a, b, c]
        })),
    );
    sums.push(
        "normals of four bytes",
        normals(codes.map(|code| [code as i16, (code >> 16) as i16])),
    );

    let mut sum = Checksum::new();
    for index in 0..COSINE_KNOTS + 3 {
        sum.feed(u32::from(CosineCurve::knot(index)));
    }
    for halvings in 0..=ProfileCurve::MOST_HALVINGS {
        sum.feed(ProfileCurve::distance(halvings, 97));
    }
    sums.push("knots", sum.value());
}

/// Stored normals, there and back; those at the corners first.
fn normals<N: Octahedral>(stored: impl Iterator<Item = N>) -> u64 {
    let mut sum = Checksum::new();
    let ends = [-N::GREATEST, -1, 0, 1, N::GREATEST];
    let corners = ends
        .into_iter()
        .flat_map(|x| ends.map(|y| N::from_coordinates([x, y])));
    for normal in corners.chain(stored) {
        let again = N::from_coordinates(normal.coordinates());
        for numbers in [normal.vector(), again.vector()] {
            for number in numbers {
                sum.feed(number as u32);
            }
        }
    }
    sum.value()
}

/// The least linear value with a code.
fn first(encoder: Encoder, code: u8) -> u32 {
    let (mut low, mut high) = (0, LINEAR_ONE);
    while low < high {
        let middle = (low + high) / 2;
        if encoder(middle) < code {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    low
}
