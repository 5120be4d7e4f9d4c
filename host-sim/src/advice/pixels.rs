//! Pixel error of a material on a sphere.

use std::f64::consts::TAU;

use microbrdf::brdf::Brdf as _;
use microbrdf::geometry::{Direction, ShadingFrame};
use microbrdf::{ParameterError, Rgb};
use microbrdf_reference as reference;
use microbrdf_scene::{HostArithmetic, Material, PatchShape};

/// Points of the sphere.
const POINTS: u32 = 20_000;
/// How near an edge of a patch a pixel may be on its other side: twice the
/// step of a 16-bit direction.
const JUMP: f64 = 1.3e-4;

/// What a sphere's pixels are off by in 8-bit sRGB.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PixelError {
    /// Greatest |code − 255 · encoded reference|.
    pub lsb_max: f64,
    /// Share of codes off by one or more, of those that are 1 … 254.
    pub off: f64,
}

/// The pixel error of a material: against double precision at directions and
/// parameters that are not rounded, over points that are uniform on a sphere's
/// picture (cos²Θ of the viewer is), each with lights in the lobe and one
/// anywhere.
///
/// # Errors
/// A parameter that the arithmetic does not take.
pub fn pixel_error<A: HostArithmetic>(
    material: &Material,
    exposure: f64,
) -> Result<PixelError, ParameterError> {
    let model = material.model::<A>()?;
    let gain = Rgb::grey(A::gain(exposure));
    Ok(graded(material, exposure, |pair| {
        A::linear(model.shade(&gain, pair)).srgb8()
    }))
}

/// The same of codes that are computed in any way.
pub(super) fn graded<A: HostArithmetic>(
    material: &Material,
    exposure: f64,
    codes: impl Fn(&ShadingFrame<A>) -> [u8; 3],
) -> PixelError {
    let exact = material.reference();
    let mut error = PixelError::default();
    let (mut counted, mut off) = (0u32, 0u32);
    for index in 0..POINTS {
        for l in lights(material, index) {
            let v = view(index);
            if at_jump(material, l, v) || l[2] < 0.0 {
                continue;
            }
            let [inner, outer] = [l, v]
                .map(|[x, y, z]| Direction::new(A::component(x), A::component(y), A::component(z)));
            let shown = codes(&ShadingFrame::new(inner, outer));
            let shares = exact.rho(
                &reference::Direction::from(l),
                &reference::Direction::from(v),
            );
            for channel in 0..3 {
                let light = (exposure * shares[channel]).clamp(0.0, 1.0);
                let code = 255.0 * reference::encode_srgb(light);
                let distance = (f64::from(shown[channel]) - code).abs();
                error.lsb_max = error.lsb_max.max(distance);
                let rounded = code.round() as u8;
                if (1..=254).contains(&rounded) {
                    counted += 1;
                    off += u32::from(shown[channel] != rounded);
                }
            }
        }
    }
    error.off = f64::from(off) / f64::from(counted.max(1));
    error
}

/// A number in [0, 1) that belongs to a point: the golden ratio's multiples
/// and those of its kin fill the unit cube evenly.
fn even(index: u32, axis: usize) -> f64 {
    const STEPS: [f64; 4] = [
        0.856_674_883_854_502_9,
        0.733_891_856_627_126,
        0.628_706_721_037_809_4,
        0.538_597_257_223_612,
    ];
    ((f64::from(index) + 0.5) * STEPS[axis]).fract()
}

fn view(index: u32) -> [f64; 3] {
    let cosine = even(index, 0).sqrt();
    let sine = (1.0 - cosine * cosine).sqrt();
    let (y, x) = (TAU * even(index, 1)).sin_cos();
    [sine * x, sine * y, cosine]
}

/// A light whose R is in the lobe about V, and one anywhere.
fn lights(material: &Material, index: u32) -> [[f64; 3]; 2] {
    let v = view(index);
    let width = |n: f64| (11.0 / n.max(1.0)).min(1.0);
    // x = 1 − cos α reaches about where the code falls to 0.
    let (x, retro) = match material {
        Material::Phong {
            exponent, retro, ..
        } => (width(*exponent), *retro),
        Material::Metal { exponent, .. } | Material::Plastic { exponent, .. } => {
            (width(*exponent), false)
        }
        Material::Patch { radius }
        | Material::PatchMetal {
            shape: PatchShape::Basic { radius },
            ..
        } => ((0.5 * radius * radius).min(1.0), false),
        Material::PatchExponential { sharpness }
        | Material::MetallicPaint { sharpness, .. }
        | Material::PatchMetal {
            shape: PatchShape::Exponential { sharpness },
            ..
        } => {
            let m = (9.0 / sharpness.max(1.0)).min(1.4);
            (0.5 * m * m, false)
        }
        Material::PatchProfile { profile } => {
            let m = profile.reach().min(1.4);
            (0.5 * m * m, false)
        }
        Material::Lambert { .. } | Material::GeneralisedLambert { .. } => (1.0, false),
    };
    let x = x * even(index, 2);
    let side = if retro { 1.0 } else { -1.0 };
    let axis = [side * v[0], side * v[1], v[2]];
    let lobe = turned(axis, x, TAU * even(index, 3));
    let cosine = even(index, 2);
    let sine = (1.0 - cosine * cosine).sqrt();
    let (y, x) = (TAU * even(index, 3)).sin_cos();
    [lobe, [sine * x, sine * y, cosine]]
}

/// The direction at versine `x` from an axis above the horizon, turned by
/// `phi` about it.
fn turned(axis: [f64; 3], x: f64, phi: f64) -> [f64; 3] {
    let sine = (x * (2.0 - x)).sqrt();
    let (second, first) = (sine * phi.sin(), sine * phi.cos());
    let along = first * axis[0] + second * axis[1];
    let factor = 1.0 - x - along / (1.0 + axis[2]);
    [
        axis[0] * factor + first,
        axis[1] * factor + second,
        axis[2] * (1.0 - x) - along,
    ]
}

/// Whether a patch's edge is so near that either side will do.
fn at_jump(material: &Material, l: [f64; 3], v: [f64; 3]) -> bool {
    match material {
        Material::Patch { radius }
        | Material::PatchMetal {
            shape: PatchShape::Basic { radius },
            ..
        } => ((l[0] + v[0]).hypot(l[1] + v[1]) - radius).abs() < JUMP,
        _ => false,
    }
}
