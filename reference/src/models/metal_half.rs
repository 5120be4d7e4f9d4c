//! Metal with the Fresnel term at the half vector's angle,
//! f = c_n cosⁿα/cosΘmin · F(angle(L, H)) (3.28).

use crate::brdf::luminance;
use crate::fresnel::Index;
use crate::half::Half;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example, gold};
use crate::models::{Energy, PModel};
use crate::quadrature::Chart;
use crate::sampling::PhongLobe;
use crate::{Brdf, Direction, ParameterError};

/// As [`super::Metal`], but F is taken between L and H rather than at Θmin: the two agree
/// in the mirror direction, and differ by 90° of angle for V = L at the horizon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MetalHalf {
    shape: PModel,
    indices: [Index; 3],
}

impl MetalHalf {
    /// Exponent 0 … 1e8 and one index for each channel.
    pub fn new(exponent: f64, indices: [Index; 3]) -> Result<Self, ParameterError> {
        Ok(Self {
            shape: PModel::new(exponent, 1.0, Energy::Published)?,
            indices,
        })
    }

    fn fresnel(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        let cos = Half::of(l, v).map_or(0.0, |h| h.lh);
        self.indices.map(|i| i.reflectance(cos))
    }
}

impl Brdf for MetalHalf {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        luminance(self.eval_rgb(l, v))
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        let f = self.shape.eval(l, v);
        if f == 0.0 {
            [0.0; 3]
        } else {
            self.fresnel(l, v).map(|r| (f * r).min(f64::MAX))
        }
    }

    fn is_coloured(&self) -> bool {
        self.indices[0] != self.indices[1] || self.indices[0] != self.indices[2]
    }

    fn peak(&self) -> f64 {
        self.shape.peak()
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        let rho = self.shape.rho(l, v)[0];
        self.fresnel(l, v).map(|r| rho * r)
    }

    fn chart(&self, l: &Direction) -> Chart {
        self.shape.chart(l)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        self.shape.creases(l, v, out);
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "metal_half",
    source: "(3.28)",
    formula: "c_n cosⁿα F(angle(L, H))/cosΘmin",
    parameters: "n 0 … 1e8; one index for each channel",
    reciprocal: true,
    grazing: "as metallic Phong; colour of the half vector's angle",
    examples: || {
        vec![example(
            "gold's indices, n = 20",
            MetalHalf::new(20.0, gold()).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let m = MetalHalf::new(20.0, gold()).expect("in range");
        visit(&m, &PhongLobe::new(&m, 20.0, v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::Metal;

    #[test]
    fn it_agrees_with_theta_min_in_the_mirror_direction_only() {
        let (eta, k) = ([0.2, 0.9, 1.4], [3.6, 2.2, 1.8]);
        let indices = [0, 1, 2].map(|i| Index::new(eta[i], k[i]).unwrap());
        let (half, min) = (
            MetalHalf::new(3.0, indices).unwrap(),
            Metal::from_indices(3.0, eta, k).unwrap(),
        );
        let l = Direction::from_degrees(75.0, 0.0);
        let r = l.mirrored();
        for i in 0..3 {
            let (a, b) = (half.eval_rgb(&l, &r)[i], min.eval_rgb(&l, &r)[i]);
            assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
        }
        let v = Direction::from_degrees(30.0, 150.0);
        let (a, b) = (half.eval_rgb(&l, &v)[2], min.eval_rgb(&l, &v)[2]);
        assert!((a / b - 1.0).abs() > 1e-3, "{a} {b}");
    }
}
