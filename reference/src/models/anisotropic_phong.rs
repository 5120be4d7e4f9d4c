//! Anisotropic metallic Phong, f = C [(RᵀMV)⁺]ⁿ / cosᵖΘmin with a diagonal M (3.14, 3.15).

use crate::albedo::greatest_albedo;
use crate::error::{above, within};
use crate::geometry::{below_horizon, bounded_ratio, over_cos_theta_min};
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::PhongLobe;
use crate::{Brdf, Direction, ParameterError};

/// The weights of x, y and z (above 0, at most 100), exponent n (0 … 1e5) and p (0 … 1).
///
/// Lafortune's lobe is p = 0. A negative product counts as 0. C is 1 over the greatest
/// albedo, found numerically.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnisotropicPhong {
    weights: [f64; 3],
    exponent: f64,
    p: f64,
    constant: f64,
}

impl AnisotropicPhong {
    /// With C_max found numerically: takes a moment.
    pub fn new(weights: [f64; 3], exponent: f64, p: f64) -> Result<Self, ParameterError> {
        let mut model = Self::unnormalised(weights, exponent, p)?;
        model.constant /= greatest_albedo(&model).1.value;
        Ok(model)
    }

    /// With Phong's constant, whatever the energy.
    pub fn unnormalised(weights: [f64; 3], exponent: f64, p: f64) -> Result<Self, ParameterError> {
        for w in weights {
            above("weights", w, 0.0, 100.0)?;
        }
        // Scale the lobe to about 1 at the normal, so that nothing overflows.
        let greatest = weights[0].max(weights[1]).max(weights[2]);
        Ok(Self {
            weights: weights.map(|w| w / greatest),
            exponent: within("exponent", exponent, 0.0, 1e5)?,
            p: within("p", p, 0.0, 1.0)?,
            constant: super::phong::published_constant(exponent),
        })
    }

    /// Directions of the lobe, which is cosⁿ about the weighted R of V (3.4, as for
    /// Phong's).
    pub fn directions<'a>(&self, brdf: &'a dyn Brdf, v: Direction) -> PhongLobe<'a> {
        let [x, y, z] = self.weights;
        PhongLobe::weighted(brdf, [-x, -y, z], self.exponent, v)
    }

    fn lobe(&self, l: &Direction, v: &Direction) -> f64 {
        let [x, y, z] = self.weights;
        // R = (−Lx, −Ly, Lz).
        let base = z * (l.z * v.z) - x * (l.x * v.x) - y * (l.y * v.y);
        if base > 0.0 {
            base.powf(self.exponent)
        } else {
            0.0
        }
    }
}

impl Brdf for AnisotropicPhong {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        over_cos_theta_min(self.constant * self.lobe(l, v), l, v, self.p)
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        [self.lobe(l, v) * bounded_ratio(l, v, self.p); 3]
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::power(ChartKind::Mirror, self.exponent)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        out.push(l.z - v.z);
    }

    fn is_isotropic(&self) -> bool {
        self.weights[0] == self.weights[1]
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "anisotropic_phong",
    source: "(3.14), (3.15)",
    formula: "C [(Cx RxVx + Cy RyVy + Cz RzVz)⁺]ⁿ / cosᵖΘmin",
    parameters: "Cx, Cy, Cz above 0; n 0 … 1e5; p 0 … 1",
    reciprocal: true,
    grazing: "as the p-model's along the axis of the greatest weight; across it the lobe fades as the n-th power of the weights' ratio",
    examples: || {
        vec![
            example(
                "(0.8, 1, 1), n = 20, p = 1",
                AnisotropicPhong::new([0.8, 1.0, 1.0], 20.0, 1.0).expect("in range"),
                Conserves,
            ),
            example(
                "(1, 0.5, 0.9), n = 6, p = 0.5",
                AnisotropicPhong::new([1.0, 0.5, 0.9], 6.0, 0.5).expect("in range"),
                Conserves,
            ),
        ]
    },
    sampler: Some(|v, visit| {
        let m = AnisotropicPhong::new([0.8, 1.0, 1.0], 20.0, 1.0).expect("in range");
        visit(&m, &m.directions(&m, v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::{Energy, MetallicPhong};

    #[test]
    fn equal_weights_are_metallic_phong() {
        let a = AnisotropicPhong::new([2.0; 3], 10.0, 1.0).unwrap();
        let b = MetallicPhong::new(10.0, Energy::Published).unwrap();
        let (l, v) = (
            Direction::from_degrees(50.0, 0.0),
            Direction::from_degrees(60.0, 170.0),
        );
        assert!((a.eval(&l, &v) / b.eval(&l, &v) - 1.0).abs() < 1e-8);
    }

    #[test]
    fn a_smaller_weight_widens_the_lobe_along_that_axis() {
        let m = AnisotropicPhong::new([0.8, 1.0, 1.0], 20.0, 1.0).unwrap();
        let turned = |phi: f64| {
            let l = Direction::from_degrees(40.0, phi);
            m.eval(&l, &l.mirrored())
        };
        assert!(turned(90.0) > turned(0.0));
        assert!(!m.is_isotropic());
    }
}
