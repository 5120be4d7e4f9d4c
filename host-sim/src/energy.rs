//! Albedo of what is shipped: quadrature over the core's own outputs.

use std::f64::consts::{PI, TAU};

use microbrdf::ParameterError;
use microbrdf::brdf::Brdf;
use microbrdf::geometry::{Direction, ShadingFrame};
use microbrdf_reference as reference;
use microbrdf_scene::{AnyModel, HostArithmetic, Material, PatchShape};

/// Nodes of each of the two grids, radially and around.
const RADIAL: usize = 96;
const AROUND: usize = 192;
/// Gauss–Legendre nodes of the mean albedo.
const MEAN_NODES: usize = 64;

/// A material in one arithmetic, beside its reference.
///
/// The core's values are steps, which no adaptive rule can integrate; the
/// reference is smooth. So the albedo is the reference's, exactly, plus the
/// difference of the two on a fixed grid that follows the lobe.
pub struct Shipped<A: HostArithmetic> {
    model: AnyModel<A>,
    exact: Box<dyn reference::Brdf + Send + Sync>,
    lobe: Lobe,
}

/// Where the grid concentrates.
#[derive(Clone, Copy, Debug)]
enum Lobe {
    /// cosⁿα about R, or about L.
    Cosine { n: f64, retro: bool },
    /// A disc of this radius about the projection of R.
    Disc { radius: f64 },
}

impl<A: HostArithmetic> Shipped<A> {
    /// The material as the arithmetic holds it.
    ///
    /// # Errors
    /// A parameter that the arithmetic does not take.
    pub fn new(material: &Material) -> Result<Self, ParameterError> {
        let lobe = match material {
            Material::Phong {
                exponent, retro, ..
            } => Lobe::Cosine {
                n: *exponent,
                retro: *retro,
            },
            Material::Metal { exponent, .. } | Material::Plastic { exponent, .. } => Lobe::Cosine {
                n: *exponent,
                retro: false,
            },
            Material::Patch { radius }
            | Material::PatchMetal {
                shape: PatchShape::Basic { radius },
                ..
            } => Lobe::Disc { radius: *radius },
            Material::PatchExponential { sharpness }
            | Material::MetallicPaint { sharpness, .. }
            | Material::PatchMetal {
                shape: PatchShape::Exponential { sharpness },
                ..
            } => Lobe::Disc {
                radius: (12.0 / sharpness).min(2.0),
            },
            Material::PatchProfile { profile } => Lobe::Disc {
                radius: profile.reach(),
            },
            Material::Lambert { .. } | Material::GeneralisedLambert { .. } => {
                Lobe::Disc { radius: 2.0 }
            }
        };
        Ok(Self {
            model: material.model()?,
            exact: material.reference(),
            lobe,
        })
    }

    /// Directional albedo at a cosine, per channel.
    pub fn albedo(&self, cosine: f64) -> [f64; 3] {
        let exact = reference::directional_albedo_rgb(&*self.exact, cosine);
        let difference = self.difference(cosine);
        [0, 1, 2].map(|channel| exact[channel].value + difference[channel])
    }

    /// The albedo less the reference's, at a cosine, per channel.
    pub fn difference(&self, cosine: f64) -> [f64; 3] {
        let l = [(1.0 - cosine * cosine).max(0.0).sqrt(), 0.0, cosine];
        let mut difference = [0.0; 3];
        self.each_node(l, |v, weight| {
            let error = self.error(l, v);
            for channel in 0..3 {
                difference[channel] += weight * error[channel];
            }
        });
        difference
    }

    /// Cosine-weighted mean of the directional albedo.
    pub fn mean_albedo(&self) -> [f64; 3] {
        let exact = reference::mean_albedo_rgb(&*self.exact).map(|estimate| estimate.value);
        let mut difference = [0.0; 3];
        for step in 0..MEAN_NODES {
            // Midpoints in cos²Θ: 2∫a cosΘ dcosΘ.
            let cosine = ((step as f64 + 0.5) / MEAN_NODES as f64).sqrt();
            for (sum, part) in difference.iter_mut().zip(self.difference(cosine)) {
                *sum += part / MEAN_NODES as f64;
            }
        }
        [0, 1, 2].map(|channel| exact[channel] + difference[channel])
    }

    /// f·cosΘV as shipped less the reference's: reciprocity makes it the
    /// radiance that V's light reflects towards L.
    fn error(&self, l: [f64; 3], v: [f64; 3]) -> [f64; 3] {
        let core =
            |[x, y, z]: [f64; 3]| Direction::new(A::component(x), A::component(y), A::component(z));
        let exact = |[x, y, z]: [f64; 3]| reference::Direction::new(x, y, z);
        let share = self
            .model
            .share(&ShadingFrame::new(core(v), core(l)))
            .to_array();
        let rho = self.exact.rho(&exact(v), &exact(l));
        let peak = self.exact.peak();
        [0, 1, 2].map(|channel| peak * (A::unit_value(share[channel]) - rho[channel]))
    }

    /// Calls `each` with directions and their weights in solid angle: a grid
    /// that is uniform on the base plane and one that follows the lobe,
    /// combined by the balance heuristic.
    fn each_node(&self, l: [f64; 3], mut each: impl FnMut([f64; 3], f64)) {
        let count = (RADIAL * AROUND) as f64;
        for i in 0..RADIAL {
            for j in 0..AROUND {
                let (u, w) = (
                    (i as f64 + 0.5) / RADIAL as f64,
                    (j as f64 + 0.5) / AROUND as f64,
                );
                for v in [on_disc([0.0; 2], 1.0, u, w), self.lobe.sample(l, u, w)] {
                    let Some(v) = v else { continue };
                    let density = v[2] / PI + self.lobe.density(l, v);
                    each(v, 1.0 / (count * density));
                }
            }
        }
    }
}

impl Lobe {
    fn sample(self, l: [f64; 3], u: f64, w: f64) -> Option<[f64; 3]> {
        match self {
            Self::Disc { radius } => on_disc([-l[0], -l[1]], radius, u, w),
            Self::Cosine { n, retro } => {
                let x = -(u.ln() / (n + 1.0)).exp_m1();
                let sine = (x * (2.0 - x)).max(0.0).sqrt();
                let axis = Self::axis(l, retro);
                // The axis lies in the xz plane.
                let (along, across) = ([axis[2], 0.0, -axis[0]], [0.0, 1.0, 0.0]);
                let (sin_phi, cos_phi) = (TAU * w).sin_cos();
                let v = [0, 1, 2].map(|i| {
                    axis[i] * (1.0 - x) + sine * (cos_phi * along[i] + sin_phi * across[i])
                });
                (v[2] > 0.0).then_some(v)
            }
        }
    }

    fn axis(l: [f64; 3], retro: bool) -> [f64; 3] {
        if retro { l } else { [-l[0], -l[1], l[2]] }
    }

    fn density(self, l: [f64; 3], v: [f64; 3]) -> f64 {
        match self {
            Self::Disc { radius } => {
                let inside = (l[0] + v[0]).hypot(l[1] + v[1]) <= radius;
                if inside {
                    v[2] / (PI * radius * radius)
                } else {
                    0.0
                }
            }
            Self::Cosine { n, retro } => {
                let axis = Self::axis(l, retro);
                let square: f64 = (0..3).map(|i| (axis[i] - v[i]) * (axis[i] - v[i])).sum();
                let x = 0.5 * square;
                if x < 1.0 {
                    (n + 1.0) / TAU * (n * (-x).ln_1p()).exp()
                } else {
                    0.0
                }
            }
        }
    }
}

/// A direction whose projection is uniform on a disc; `None` off the base.
fn on_disc(centre: [f64; 2], radius: f64, u: f64, w: f64) -> Option<[f64; 3]> {
    let (sin_phi, cos_phi) = (TAU * w).sin_cos();
    let r = radius * u.sqrt();
    let (x, y) = (centre[0] + r * cos_phi, centre[1] + r * sin_phi);
    let rest = 1.0 - x * x - y * y;
    (rest > 0.0).then(|| [x, y, rest.sqrt()])
}
