//! How far a picture is from the reference.

use microbrdf_reference::{ciede2000, decode_srgb};
use serde_json::{Value, json};

use crate::picture::Picture;
use crate::reference_picture::{Exact, ExactPixel};

/// A pixel this near to a jump may fall on its other side. Single precision
/// places a silhouette to about 3e-6 radii at 30 radii from the eye.
pub const JUMP: f64 = 1e-5;
/// A light need turn by no more for an edge of a shadow to pass: `q15` rounds
/// three components by 2⁻¹⁵ each.
pub const SHADOW_JUMP: f64 = 6e-5;

/// What the comparison of a picture with the reference found.
#[derive(Clone, Debug, Default)]
pub struct Measured {
    /// Greatest |code − exact code|, in codes.
    pub lsb_error_max: f64,
    /// Greatest |code − rounded exact code|.
    pub code_error_max: u8,
    /// Share of channels, of those whose exact code is 1 … 254, off by one.
    pub off_by_one: f64,
    /// Share of them off by more.
    pub off_by_more: f64,
    /// Pixels on the other side of a jump, exempt from all above.
    pub class_flips: usize,
    /// 95th percentile of CIEDE2000 between the 8-bit pictures.
    pub delta_e_p95: f64,
    /// Greatest CIEDE2000.
    pub delta_e_max: f64,
}

impl Measured {
    /// Compares a picture of the reference's size with it.
    pub fn new(picture: &Picture, exact: &Exact) -> Self {
        let mut result = Self::default();
        let (mut counted, mut one, mut more) = (0u32, 0u32, 0u32);
        let mut differences = Vec::with_capacity(exact.pixels.len());
        for (pixel, reference) in picture.pixels.iter().zip(&exact.pixels) {
            let codes = reference.code();
            let error = |i: usize| pixel[i].abs_diff(codes[i].round() as u8);
            let rounded = codes.map(|code| code.round() as u8);
            differences.push(difference(*pixel, rounded));
            if flipped(*pixel, rounded, reference) {
                result.class_flips += 1;
                continue;
            }
            for i in 0..3 {
                result.lsb_error_max = result
                    .lsb_error_max
                    .max((f64::from(pixel[i]) - codes[i]).abs());
                result.code_error_max = result.code_error_max.max(error(i));
                if (1..=254).contains(&rounded[i]) {
                    counted += 1;
                    match error(i) {
                        0 => {}
                        1 => one += 1,
                        _ => more += 1,
                    }
                }
            }
        }
        let share = |count: u32| f64::from(count) / f64::from(counted.max(1));
        result.off_by_one = share(one);
        result.off_by_more = share(more);
        differences.sort_by(f64::total_cmp);
        if let Some(last) = differences.last() {
            result.delta_e_max = *last;
            result.delta_e_p95 = differences[(differences.len() - 1) * 95 / 100];
        }
        result
    }

    /// The figures under the names of the report.
    pub fn json(&self) -> Value {
        json!({
            "lsb_error_max": self.lsb_error_max,
            "code_error_max": self.code_error_max,
            "code_error_share": self.off_by_one,
            "code_error_over_one_share": self.off_by_more,
            "class_flips": self.class_flips,
            "delta_e_p95": self.delta_e_p95,
            "delta_e_max": self.delta_e_max,
        })
    }
}

/// Whether a pixel that is more than one code off lies on a jump.
fn flipped(pixel: [u8; 3], exact: [u8; 3], reference: &ExactPixel) -> bool {
    reference.may_flip() && (0..3).any(|i| pixel[i].abs_diff(exact[i]) > 1)
}

fn difference(a: [u8; 3], b: [u8; 3]) -> f64 {
    if a == b {
        return 0.0;
    }
    let linear = |pixel: [u8; 3]| pixel.map(|code| decode_srgb(f64::from(code) / 255.0));
    ciede2000(linear(a), linear(b))
}

/// The errors as a picture: black where the code is exact, blue one off,
/// yellow two, red three or more; magenta for class flips.
pub fn heat_map(picture: &Picture, exact: &Exact) -> Picture {
    let heat = |(pixel, reference): (&[u8; 3], &ExactPixel)| {
        let codes = reference.code().map(|code| code.round() as u8);
        if flipped(*pixel, codes, reference) {
            return [255, 0, 255];
        }
        match (0..3)
            .map(|i| pixel[i].abs_diff(codes[i]))
            .max()
            .unwrap_or(0)
        {
            0 => [0, 0, 0],
            1 => [70, 110, 255],
            2 => [255, 220, 0],
            _ => [255, 30, 0],
        }
    };
    let pixels = picture.pixels.iter().zip(&exact.pixels).map(heat).collect();
    Picture {
        width: exact.width,
        height: exact.height,
        pixels,
    }
}
