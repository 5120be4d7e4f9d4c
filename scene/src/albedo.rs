//! Albedo under a uniform sky, for pictures.

use std::sync::{Arc, Mutex, PoisonError};

use microbrdf_reference::quadrature::Accuracy;
use microbrdf_reference::{Brdf, Direction, albedo::directional_albedo_rgb_for};
use rayon::prelude::*;

use crate::material::Material;

/// Nodes of an [`AlbedoTable`].
const NODES: usize = 257;

/// The directional albedo of a model at a cosine, per channel, to 1e-6: less
/// than a hundredth of an sRGB code where the sky alone would fill the scale.
#[must_use]
pub fn directional_albedo(model: &(dyn Brdf + Send + Sync), cosine: f64) -> [f64; 3] {
    let l = Direction::from_cosine(cosine, 0.0);
    let accuracy = Accuracy {
        tolerance: 1e-6,
        ..Accuracy::FINE
    };
    directional_albedo_rgb_for(model, &l, accuracy).map(|albedo| albedo.value)
}

/// The directional albedo of a model over the cosine, for use at every pixel.
///
/// Nodes are even in √cosΘ, which crowds them where albedo bends, and read
/// by cubic interpolation; for n up to 1e4 it is within 1e-5 of the
/// integral, tested here.
#[derive(Clone, Debug, PartialEq)]
pub struct AlbedoTable {
    nodes: Vec<[f64; 3]>,
}

impl AlbedoTable {
    /// The table of a material; the same one if asked again. That of a sum is summed
    /// from its parts', which materials that differ in colour alone have in common.
    #[must_use]
    pub fn of(material: &Material) -> Arc<Self> {
        static KNOWN: Mutex<Vec<(Material, Arc<AlbedoTable>)>> = Mutex::new(Vec::new());
        let known = || KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        let find = |known: &[(Material, Arc<Self>)]| {
            let found = known.iter().find(|(other, _)| other == material);
            found.map(|(_, table)| Arc::clone(table))
        };
        if let Some(table) = find(&known()) {
            return table;
        }
        // Not locked meanwhile: the parts are asked for here too.
        let parts = material.parts();
        let table = match &parts[..] {
            [(part, _)] if part == material => Self::new(&*material.reference()),
            parts => Self::sum(parts),
        };
        let mut known = known();
        find(&known).unwrap_or_else(|| {
            let table = Arc::new(table);
            known.push((material.clone(), Arc::clone(&table)));
            table
        })
    }

    /// The table of a sum, each part's multiplied by its tint.
    fn sum(parts: &[(Material, [f64; 3])]) -> Self {
        let mut nodes = vec![[0.0; 3]; NODES];
        for (part, tint) in parts {
            for (sum, albedo) in nodes.iter_mut().zip(&Self::of(part).nodes) {
                *sum = [0, 1, 2].map(|i| sum[i] + tint[i] * albedo[i]);
            }
        }
        Self { nodes }
    }

    /// Tabulates a model.
    #[must_use]
    pub fn new(model: &(dyn Brdf + Send + Sync)) -> Self {
        let cosine = |node: usize| (node as f64 / (NODES - 1) as f64).powi(2);
        let nodes = (0..NODES)
            .into_par_iter()
            .map(|node| directional_albedo(model, cosine(node)))
            .collect();
        Self { nodes }
    }

    /// The albedo at a cosine, clamped to [0, 1], per channel.
    #[must_use]
    pub fn at(&self, cosine: f64) -> [f64; 3] {
        let position = cosine.clamp(0.0, 1.0).sqrt() * (NODES - 1) as f64;
        let cell = (position as usize).min(NODES - 2);
        let t = position - cell as f64;
        let node = |i: usize| self.nodes[i];
        // Catmull–Rom; beyond the ends the chord goes on.
        let beyond = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| 2.0 * a[i] - b[i]);
        let (b, c) = (node(cell), node(cell + 1));
        let a = if cell == 0 {
            beyond(b, c)
        } else {
            node(cell - 1)
        };
        let d = if cell + 2 == NODES {
            beyond(c, b)
        } else {
            node(cell + 2)
        };
        [0, 1, 2].map(|i| {
            let (slope_b, slope_c) = (0.5 * (c[i] - a[i]), 0.5 * (d[i] - b[i]));
            let rise = c[i] - b[i];
            let (p, q) = (slope_b - rise, rise - slope_c);
            b[i] + t * rise + t * (1.0 - t) * ((1.0 - t) * p + t * q)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_follows_the_integral() {
        for (material, tolerance) in [
            ("model = \"metallic-phong\"\nexponent = 20", 1e-6),
            ("model = \"metallic-phong\"\nexponent = 1e4", 1e-5),
            ("model = \"metal\"\nmetal = \"gold\"\nexponent = 60", 1e-6),
            ("model = \"patch-exponential\"\nsharpness = 5", 1e-5),
            // Sums of parts.
            ("model = \"lambert\"\nalbedo = [0.6, 0.3, 0.1]", 1e-6),
            (
                "model = \"plastic\"\nalbedo = [0.6, 0.3, 0.1]\nspecular = [0.1, 0.2, 0.3]\nexponent = 30",
                1e-6,
            ),
            (
                "model = \"plastic\"\nalbedo = [0.6, 0.3, 0.1]\nspecular = 0.3\nexponent = 30\nindex = 1.5",
                1e-6,
            ),
        ] {
            let made = Material::from_toml("test", material).unwrap();
            let (model, table) = (made.reference(), AlbedoTable::of(&made));
            for i in 0..40 {
                let cosine = (f64::from(i) / 39.0).powi(3);
                let (read, exact) = (table.at(cosine), directional_albedo(&*model, cosine));
                for channel in 0..3 {
                    let error = (read[channel] - exact[channel]).abs();
                    assert!(error <= tolerance, "{material} at {cosine}: {error:e}");
                }
            }
        }
    }
}
