//! Lobes in look-ups without interpolation: against the reference, in the shading
//! frame and in world space.

use microbrdf::Rgb;
use microbrdf::arithmetic::Q15;
use microbrdf::brdf::{DirectPhong, MetallicPhong};
use microbrdf::fixed::types::{I2F14, U32F32};
use microbrdf::geometry::{Direction, ShadingFrame, ShortWorld};
use microbrdf_scene::Material;
use microbrdf_tests::arithmetic::rounded;
use microbrdf_tests::exposed::{number, off, within, worst, worst_in_world};

#[test]
fn lobes_without_interpolation() {
    let (mut found, mut in_world) = ([0.0f64; 2], [0.0f64; 2]);
    for n in [1.5, 2.0, 3.7, 20.0, 100.0, 500.0, 5000.0, 1e5, 1e8] {
        let text = format!("model = \"metallic-phong\", exponent = {n}");
        let material = Material::from_argument(&text).expect("a lobe");
        let peak = (n + 2.0) / std::f64::consts::TAU;
        let lobe = MetallicPhong::<Q15<513>>::new(number(n)).expect("an exponent");
        for (column, k) in [1.0, peak].into_iter().enumerate() {
            if k > 100.0 {
                continue;
            }
            let model = DirectPhong::<4096>::new(&lobe, Rgb::grey(number(k))).expect("a gain");
            let off = worst(&material, n, k, |pair| model.shade(pair));
            found[column] = found[column].max(off);
            if n <= 5000.0 {
                let off = worst_in_world(&material, n, k, |[n, l, v]| {
                    model.shade(&ShortWorld::new(n, l, v))
                });
                in_world[column] = in_world[column].max(off);
            }
        }
    }
    println!("lobes without interpolation: {found:.3?}, in world space {in_world:.3?}");
    within(found[0], 0.62..=0.75);
    within(found[1], 0.62..=0.75);
    within(in_world[0], 0.62..=0.78);
    within(in_world[1], 0.62..=0.85);
    let mut fine = 0.0f64;
    for n in [1.0, 1.2, 1.5, 20.0, 500.0, 2000.0, 5000.0] {
        let text = format!("model = \"metallic-phong\", exponent = {n}");
        let material = Material::from_argument(&text).expect("a lobe");
        let lobe = MetallicPhong::<Q15<513>>::new(number(n)).expect("an exponent");
        let model = DirectPhong::<8192>::new(&lobe, Rgb::grey(U32F32::ONE)).expect("a gain");
        fine = fine.max(worst_in_world(&material, n, 1.0, |[n, l, v]| {
            model.shade(&ShortWorld::new(n, l, v))
        }));
    }
    println!("twice the cells, in world space: {fine:.3}");
    within(fine, 0.60..=0.70);
}

/// Where a lobe of exponent 1 ends, light falls to 0 along a straight line, which is
/// where a cell's width shows most.
#[test]
fn the_end_of_a_lobe_without_interpolation() {
    fn end<const CELLS: usize>() -> f64 {
        let lobe = MetallicPhong::<Q15<513>>::new(number(1.0)).expect("an exponent");
        let model = DirectPhong::<CELLS>::new(&lobe, Rgb::grey(U32F32::ONE)).expect("a gain");
        let up = Direction::new(I2F14::ZERO, I2F14::ZERO, I2F14::ONE);
        let at = |z: i16| {
            let cosine = f64::from(z) / 16_384.0;
            let v = rounded::<Q15>([(1.0 - cosine * cosine).sqrt(), 0.0, cosine]);
            let light = model.shade(&ShortWorld::new(up, up, v));
            off(light, 1.0, [cosine; 3])
        };
        (1..2000).map(at).fold(0.0, f64::max)
    }
    within(end::<4096>(), 0.75..=0.85);
    within(end::<8192>(), 0.60..=0.75);
}

/// Half of a cell, whose 4096 hold the lobe's 0.44, is what a peak lacks.
#[test]
fn channels_do_not_mix() {
    let up = Direction::new(I2F14::ZERO, I2F14::ZERO, I2F14::ONE);
    let pair = ShadingFrame::<Q15>::new(up, up);
    let lobe = MetallicPhong::<Q15>::new(number(20.0)).expect("an exponent");
    let gain = Rgb {
        r: U32F32::ONE,
        g: U32F32::ONE / 2,
        b: U32F32::ZERO,
    };
    let direct = DirectPhong::<4096>::new(&lobe, gain).expect("a gain");
    let Rgb { r, g, b } = direct.shade(&pair);
    assert!(
        (65_430..65_535).contains(&r) && g == r / 2 && b == 0,
        "{r}, {g}, {b}"
    );
    let dark = DirectPhong::<4096>::new(&lobe, Rgb::grey(U32F32::ZERO)).expect("a gain");
    assert_eq!(dark.shade(&pair), Rgb::grey(0));
    let most = Rgb::grey(number(16_383.9));
    let bright = DirectPhong::<4096>::new(&lobe, most).expect("a gain");
    assert_eq!(bright.shade(&pair), Rgb::grey(65_535));
    let error = DirectPhong::<4096>::new(&lobe, Rgb::grey(number(16_384.0)));
    assert_eq!(error.expect_err("too bright").parameter, "gain");
}
