//! A lobe's highlight on a sphere that is seen from afar, in levels of RGB565
//! against the reference.

use microbrdf::Rgb;
use microbrdf::arithmetic::Q31;
use microbrdf::fixed::types::{I2F30, U32F32};
use microbrdf::geometry::Direction;
use microbrdf::shade::{LitSphere, LobeColours};
use microbrdf_reference::encode_srgb;
use microbrdf_reference::models::{Energy, MetallicPhong};
use microbrdf_reference::{Brdf as _, Direction as Exact};
use microbrdf_tests::frame::in_frame;

/// Red, green and blue of the light on the metal.
const TINT: [f64; 3] = [1.0, 0.75, 1.0 / 3.0];
/// Pixels whose centre is so near to the sphere's edge, in radii, are not held
/// to a bound: there z, and with it the picture, changes without one.
const EDGE: f64 = 1e-5;

/// The same for where a lobe of exponent 0 ends, in cosα.
const LAST: f64 = 4e-3;

fn number(value: f64) -> U32F32 {
    U32F32::from_num(value)
}

fn gain(k: f64) -> Rgb<U32F32> {
    Rgb::from_array(TINT.map(|tint| number(k * tint)))
}

fn colours<const CELLS: usize>(n: f64, k: f64) -> LobeColours<CELLS> {
    LobeColours::new(number(n), gain(k)).expect("an exponent")
}

/// L at an angle from V, turned about it.
fn light(angle: f64, azimuth: f64) -> [I2F30; 3] {
    let (sine, cosine) = angle.sin_cos();
    [sine * azimuth.cos(), sine * azimuth.sin(), cosine].map(I2F30::from_num)
}

fn direction([x, y, z]: [I2F30; 3]) -> Direction<Q31> {
    Direction::new(x, y, z)
}

/// A square picture: its left upper pixel, and what pixels are apart.
struct Picture {
    start: [I2F30; 2],
    step: I2F30,
    side: usize,
}

impl Picture {
    /// About a point, as far as pixels may be from the centre.
    fn about([x, y]: [f64; 2], step: f64, side: usize) -> Self {
        let wide = (side - 1) as f64 * step;
        let within = |c: f64| (c - wide / 2.0).min(1.9 - wide).max(-1.9);
        Self {
            start: [within(x), -within(-y)].map(I2F30::from_num),
            step: I2F30::from_num(step),
            side,
        }
    }

    fn shade<const CELLS: usize, const STEPS: usize, const FLAT: bool>(
        &self,
        lit: &LitSphere<STEPS>,
        colours: &LobeColours<CELLS, FLAT>,
    ) -> Vec<([f64; 2], u16)> {
        let mut rows = lit.rows(colours, self.start, [self.step, -self.step]);
        let mut found = Vec::new();
        let [x, y] = self.start.map(I2F30::to_num::<f64>);
        let step = self.step.to_num::<f64>();
        for row in 0..self.side {
            // What was there before is not to be seen.
            let mut pixels = vec![0xAAAA; self.side];
            rows.shade(&mut pixels);
            let point = |column: usize| [x + column as f64 * step, y - row as f64 * step];
            found.extend((0..self.side).map(|column| (point(column), pixels[column])));
        }
        found
    }
}

/// Levels of the exact picture, not rounded; black beside the sphere.
fn exact(model: &MetallicPhong, k: f64, l: [f64; 3], [x, y]: [f64; 2]) -> [f64; 3] {
    let square = 1.0 - x * x - y * y;
    if square <= 0.0 {
        return [0.0; 3];
    }
    let normal = [x, y, square.sqrt()];
    let [l, v] =
        in_frame(normal, l, [0.0, 0.0, 1.0]).map(|[x, y, z]: [f64; 3]| Exact::new(x, y, z));
    let light = k * model.rho(&l, &v)[0];
    let level =
        |channel: usize, most: f64| most * encode_srgb((light * TINT[channel]).clamp(0.0, 1.0));
    [level(0, 31.0), level(1, 63.0), level(2, 31.0)]
}

/// cosα from a light to a point of the sphere.
fn mirrored([lx, ly, lz]: [f64; 3], [x, y]: [f64; 2]) -> f64 {
    let z = (1.0 - x * x - y * y).max(0.0).sqrt();
    2.0 * (x * lx + y * ly + z * lz) * z - lz
}

/// The greatest error in levels over the pictures that are given for an angle and
/// an azimuth of the light, and how many pixels were lit.
fn worst_over<const CELLS: usize, const STEPS: usize>(
    n: f64,
    k: f64,
    angles: &[f64],
    pictures: impl Fn(f64, f64) -> Vec<Picture>,
) -> (f64, usize) {
    worst_of::<CELLS, STEPS, false>(&colours(n, k), n, k, angles, pictures)
}

/// The same for colours that are given.
fn worst_of<const CELLS: usize, const STEPS: usize, const FLAT: bool>(
    colours: &LobeColours<CELLS, FLAT>,
    n: f64,
    k: f64,
    angles: &[f64],
    pictures: impl Fn(f64, f64) -> Vec<Picture>,
) -> (f64, usize) {
    let model = MetallicPhong::new(n, Energy::Published).expect("an exponent");
    let (mut worst, mut lit) = (0.0f64, 0);
    for &angle in angles {
        let azimuth = 0.3 + 5.0 * angle;
        let given = light(angle, azimuth);
        let sphere = LitSphere::<STEPS>::new(colours, direction(given));
        let l = given.map(I2F30::to_num::<f64>);
        for picture in pictures(angle, azimuth) {
            for (point, code) in picture.shade(&sphere, colours) {
                if (point[0].hypot(point[1]) - 1.0).abs() < EDGE
                    || FLAT && mirrored(l, point).abs() < LAST
                {
                    continue;
                }
                lit += usize::from(code != 0);
                worst = worst.max(levels_off(code, exact(&model, k, l, point)));
            }
        }
    }
    (worst, lit)
}

/// How far a code is from the levels that are exact.
fn levels_off(code: u16, levels: [f64; 3]) -> f64 {
    let shown = [code >> 11, code >> 5 & 63, code & 31];
    (shown.into_iter().zip(levels))
        .map(|(shown, exact)| (f64::from(shown) - exact.round()).abs())
        .fold(0.0, f64::max)
}

/// Over pictures of spheres of these sizes.
fn worst<const CELLS: usize, const STEPS: usize>(n: f64, k: f64, angles: &[f64]) -> (f64, usize) {
    worst_over::<CELLS, STEPS>(n, k, angles, pictures)
}

fn pictures(angle: f64, azimuth: f64) -> Vec<Picture> {
    let picture = |(side, radius): (usize, f64)| {
        // The whole sphere, or the part about the highlight.
        let half = if 2.0 * radius > side as f64 {
            (angle / 2.0).sin()
        } else {
            0.0
        };
        Picture::about(
            [half * azimuth.cos(), half * azimuth.sin()],
            1.0 / radius,
            side,
        )
    };
    PICTURES.map(picture).into()
}

/// Pixels of a picture's side, and of the sphere's radius.
const PICTURES: [(usize, f64); 6] = [
    (77, 20.0),
    (133, 50.0),
    (133, 64.0),
    (133, 150.0),
    (133, 1000.0),
    (640, 300.0),
];
/// Between L and V, to 179.96°.
const ANGLES: [f64; 18] = [
    0.0, 1e-3, 0.1, 0.3, 0.66, 0.9, 1.2, 1.35, 1.5, 1.7, 2.0, 2.3, 2.6, 2.8, 3.0, 3.1, 3.139,
    3.1409,
];

#[test]
fn at_most_one_level_off_at_full_light() {
    let mut lit = 0;
    for n in [1.5, 2.0, 5.0, 20.0, 100.0, 500.0, 5000.0, 1e5, 1e8] {
        let found = worst::<512, 512>(n, 1.0, &ANGLES);
        assert!(found.0 <= 1.0, "n = {n}: {found:?}");
        lit += found.1;
    }
    assert!(lit > 100_000, "{lit}");
    // Steeper in the dark, and wider, so that its edge counts.
    for n in [1.0, 1.1, 1.25] {
        let found = worst::<1024, 1024>(n, 1.0, &ANGLES);
        assert!(found.0 <= 1.0, "n = {n}: {found:?}");
    }
}

#[test]
fn at_most_one_level_off_at_the_lobes_own_peak() {
    for n in [1.5, 2.0, 20.0, 100.0, 500.0] {
        let peak = (n + 2.0) / std::f64::consts::TAU;
        let found = worst::<512, 512>(n, peak, &ANGLES);
        assert!(found.0 <= 1.0, "n = {n}: {found:?}");
    }
    let found = worst::<1024, 1024>(1.0, 3.0 / std::f64::consts::TAU, &ANGLES);
    assert!(found.0 <= 1.0, "n = 1: {found:?}");
}

/// Over parts of large spheres, here and there in the lobe.
fn worst_of_parts(n: f64, k: f64, angles: &[f64]) -> (f64, usize) {
    // Where no channel shows the light, from the middle of the lobe.
    let reach = (0.5 * (1.0 - (-(8.0 + k.ln()) / n).exp())).sqrt();
    worst_over::<512, 512>(n, k, angles, parts(reach))
}

/// As far from the middle of the lobe.
fn parts(reach: f64) -> impl Fn(f64, f64) -> Vec<Picture> {
    let radii = [300.0, 700.0, 1500.0, 3000.0, 8192.0];
    move |angle, azimuth| {
        let half = (angle / 2.0).sin();
        let part = |(part, radius): (i32, f64)| {
            let (turn, away) = (f64::from(part), reach * f64::from(part % 11) / 10.0);
            let middle = [
                half * azimuth.cos() + away * turn.cos(),
                half * azimuth.sin() + away * turn.sin(),
            ];
            Picture::about(middle, 1.0 / radius, 70)
        };
        (0..60).zip(radii.into_iter().cycle()).map(part).collect()
    }
}

#[test]
fn at_most_one_level_off_in_parts_of_large_spheres() {
    let mut lit = 0;
    for n in [1.5, 2.0, 5.0, 20.0, 100.0, 500.0, 5000.0, 1e5, 1e8] {
        let found = worst_of_parts(n, 1.0, &ANGLES);
        assert!(found.0 <= 1.0, "n = {n}: {found:?}");
        lit += found.1;
    }
    let peak = |n: f64| (n + 2.0) / std::f64::consts::TAU;
    for n in [1.5, 2.0, 20.0, 100.0, 500.0] {
        let found = worst_of_parts(n, peak(n), &ANGLES);
        assert!(found.0 <= 1.0, "n = {n} at its peak: {found:?}");
        lit += found.1;
    }
    assert!(lit > 1_000_000, "{lit}");
}

/// K = c = 1/π among the gains.
#[test]
fn at_most_one_level_off_for_an_exponent_of_0() {
    for k in [2e-3, 0.02, std::f64::consts::FRAC_1_PI, 1.0] {
        let colours = LobeColours::<1024, true>::flat(gain(k));
        let whole = worst_of::<1024, 1024, true>(&colours, 0.0, k, &ANGLES, pictures);
        assert!(whole.0 <= 1.0 && whole.1 > 10_000, "K = {k}: {whole:?}");
        let parts = parts(std::f64::consts::FRAC_1_SQRT_2);
        let parts = worst_of::<1024, 1024, true>(&colours, 0.0, k, &ANGLES, parts);
        assert!(parts.0 <= 1.0 && parts.1 > 10_000, "K = {k}: {parts:?}");
    }
}

/// From one end of a long row to the other what is rounded adds up.
#[test]
fn at_most_one_level_off_in_a_picture_of_3000_pixels() {
    let found = worst_over::<512, 512>(1e5, 1.0, &ANGLES[4..5], |_, _| {
        vec![Picture::about([0.0, 0.0], 1.0 / 1500.0, 3000)]
    });
    assert!(found.0 <= 1.0 && found.1 > 100, "{found:?}");
}

/// Half of the tables, at full light.
#[test]
fn small_tables_are_enough_from_20_on() {
    for n in [20.0, 100.0, 500.0, 5000.0, 1e5] {
        let found = worst::<256, 256>(n, 1.0, &ANGLES);
        assert!(found.0 <= 1.0, "n = {n}: {found:?}");
    }
}

#[test]
fn nothing_is_lit_from_straight_behind_nor_without_light() {
    let picture = Picture::about([0.0, 0.0], 1.0 / 50.0, 133);
    let zero = I2F30::ZERO;
    let dark = |k: f64, l: [I2F30; 3]| {
        let colours = colours::<256>(20.0, k);
        let lit = LitSphere::<256>::new(&colours, direction(l));
        picture
            .shade(&lit, &colours)
            .iter()
            .all(|(_, code)| *code == 0)
    };
    assert!(dark(1.0, [zero, zero, I2F30::NEG_ONE]));
    assert!(dark(1.0, light(std::f64::consts::PI - 1e-4, 1.0)));
    assert!(dark(1.0, [zero; 3]));
    assert!(dark(0.0, light(0.5, 1.0)));
    assert!(dark(1e-4, light(0.5, 1.0)));
    assert!(!dark(1e-2, light(0.5, 1.0)));
}

#[test]
fn tables_have_the_size_that_is_documented() {
    assert_eq!(size_of::<LobeColours<512>>(), 2 * 512 + 2056);
    assert_eq!(size_of::<LitSphere<512>>(), 4 * 512 + 64);
}

/// The same picture, whatever the length of L.
#[test]
fn the_lights_direction_may_have_any_length() {
    let colours = colours::<256>(20.0, 1.0);
    let picture = Picture::about([0.0, 0.0], 1.0 / 50.0, 133);
    let [unit, half] = [1.0, 0.5].map(|length| {
        let l = light(0.8, 0.4).map(|c| c * I2F30::from_num(length));
        picture.shade(&LitSphere::<256>::new(&colours, direction(l)), &colours)
    });
    let differ = unit.iter().zip(&half).filter(|(a, b)| a.1 != b.1).count();
    assert_eq!(differ, 0);
}

/// A row may be shaded in parts, and a picture is the same from any start.
#[test]
fn a_row_of_any_length_is_the_beginning_of_a_longer_one() {
    let colours = colours::<256>(20.0, 1.0);
    let lit = LitSphere::<256>::new(&colours, direction(light(0.8, 0.4)));
    let start = [-0.9, 0.3].map(I2F30::from_num);
    let step = [I2F30::from_num(0.02), I2F30::ZERO];
    let mut long = [1; 90];
    lit.rows(&colours, start, step).shade(&mut long);
    assert!(long.iter().filter(|code| **code != 0).count() > 20);
    for length in [0, 1, 2, 3, 44, 89] {
        let mut row = vec![1; length];
        lit.rows(&colours, start, step).shade(&mut row);
        assert_eq!(row, long[..length]);
    }
}

#[test]
fn exponents_below_1_are_refused() {
    for n in [0.0, 0.5, 0.999, 1.1e8] {
        let error = LobeColours::<256>::new(number(n), gain(1.0)).expect_err("an error");
        assert_eq!(error.to_string(), "exponent must be a number from 1 to 1e8");
    }
}

/// Arithmetic that overflows would end these tests.
#[test]
fn wherever_the_picture_is_nothing_overflows() {
    let mut state = 1u64;
    let mut draw = |most: f64| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 11) as f64 / (1u64 << 53) as f64 * most
    };
    for _ in 0..300 {
        let n = 10f64.powf(draw(8.0));
        let colours = colours::<256>(n, 10f64.powf(draw(12.0) - 4.0));
        let l = light(draw(std::f64::consts::PI), draw(6.3));
        let lit = LitSphere::<256>::new(&colours, direction(l));
        let start = [draw(4.0) - 2.0, draw(4.0) - 2.0].map(I2F30::from_num);
        let step = 10f64.powf(-draw(8.0));
        let step = [draw(step) - step / 2.0, draw(step) - step / 2.0].map(I2F30::from_num);
        let mut rows = lit.rows(&colours, start, step);
        let mut pixels = [0; 40];
        for _ in 0..40 {
            rows.shade(&mut pixels);
        }
    }
}
