//! A lobe's highlight on a sphere, a row at a time, against the reference.

use microbrdf::Rgb;
use microbrdf::arithmetic::Q31;
use microbrdf::fixed::types::{I2F30, U32F32};
use microbrdf::geometry::Direction;
use microbrdf::shade::{LitSphere, LobeColours};
use microbrdf_reference::encode_srgb;

fn exact(n: f64, gain: [f64; 3], l: [f64; 3], x: f64, y: f64) -> [f64; 3] {
    let square = 1.0 - x * x - y * y;
    if square < 0.0 { return [0.0; 3]; }
    let normal = [x, y, square.sqrt()];
    let nl: f64 = (0..3).map(|i| normal[i] * l[i]).sum();
    let nv = normal[2];
    if nl <= 0.0 { return [0.0; 3]; }
    let cos = 2.0 * nl * nv - l[2];
    let share = if cos > 0.0 { (n * (cos.min(1.0)).ln()).exp() * nl / nl.max(nv) } else { 0.0 };
    gain.map(|k| encode_srgb((k * share).clamp(0.0, 1.0)))
}

#[test]
fn levels() {
    for n in [1.0f64, 1.5, 2.0, 20.0, 500.0, 5000.0, 1e5, 1e8] {
        for k in [1.0, (n + 2.0) / std::f64::consts::TAU] {
            let colours = LobeColours::<512>::new(U32F32::from_num(n), Rgb { r: U32F32::from_num(k), g: U32F32::from_num(0.75 * k), b: U32F32::from_num(k / 3.0) }).expect("fine");
            for angle in [0.0f64, 0.001, 0.3, 0.66, 1.2, 1.57, 2.0, 2.6, 3.0] {
                for radius in [20.0, 64.0, 150.0, 1000.0] {
                let azimuth = 0.7 * angle + 0.3;
                let l = [angle.sin() * azimuth.cos(), angle.sin() * azimuth.sin(), angle.cos()];
                let fixed = l.map(I2F30::from_num);
                let l = fixed.map(|c| c.to_num::<f64>());
                let lit = LitSphere::<512>::new(&colours, Direction::<Q31>::new(fixed[0], fixed[1], fixed[2]));
                let step = 1.0 / radius;
                // around the highlight
                let half = (angle / 2.0).sin();
                let (cx, cy) = if radius > 100.0 { (half * azimuth.cos(), half * azimuth.sin()) } else { (0.0, 0.0) };
                let mut histogram = [0usize; 70];
                let mut lit_pixels = 0;
                let mut worst = (0, [0.0; 2], [0u16; 3], [0.0f64; 3]);
                for row in -66..=66 {
                    let mut pixels = [0xAAAAu16; 133];
                    let x0 = I2F30::from_num(cx - 66.0 * step);
                    let y = I2F30::from_num(cy + f64::from(row) * step);
                    let s = I2F30::from_num(step);
                    if (cx - 66.0 * step).abs() > 1.9 || (cx + 66.0 * step).abs() > 1.9 || y.to_num::<f64>().abs() > 1.9 { continue; }
                    lit.row(&colours, [x0, y], s, &mut pixels);
                    for (i, code) in pixels.into_iter().enumerate() {
                        let x = x0.to_num::<f64>() + i as f64 * s.to_num::<f64>();
                        let y = y.to_num::<f64>();
                        let e = exact(n, [k, 0.75 * k, k / 3.0], l, x, y);
                        let e = [e[0] * 31.0, e[1] * 63.0, e[2] * 31.0];
                        let shown = [code >> 11, code >> 5 & 63, code & 31];
                        let off = (0..3).map(|c| (f64::from(shown[c]) - e[c].round()).abs() as usize).max().unwrap();
                        histogram[off] += 1;
                        if code != 0 { lit_pixels += 1; }
                        if off > worst.0 { worst = (off, [x, y], shown, e); }
                    }
                }
                if worst.0 > 1 || std::env::var("ALL").is_ok() {
                    let over: usize = histogram[2..].iter().sum();
                    println!("n {n} k {k:.1} angle {angle} radius {radius}: lit {lit_pixels}, one off {}, more {over}, worst {worst:.3?} r {:.4}", histogram[1], worst.1[0].hypot(worst.1[1]));
                }
                }
            }
        }
    }
}
