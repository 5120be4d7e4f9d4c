//! Albedo pumping-up (2.16): any symmetric model divided by a symmetric function of its
//! own albedo, any number of times.

mod grid;

use crate::geometry::below_horizon;
use crate::models::Phong;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, Estimate, adaptive};
use crate::{Brdf, Direction, ParameterError};
use grid::{add_gregory, cosine, node, read, sine};
use std::f64::consts::{FRAC_PI_2, PI};

/// What the model is divided by at each step, with a the albedo before the step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PumpRule {
    /// g1 = max(a(L), a(V)) (2.20). The mean albedo tends to 1.
    Full,
    /// g2 = max(a(L), a(V), NL, NV) (2.21), iterated as it is written: it too tends to 1.
    Controlled,
    /// The product of all g1 so far, never below max(NL, NV): tends to the original over
    /// max(NL, NV), (2.22), which is what the text says of the iteration.
    ControlledFloored,
}

/// An isotropic, symmetric model pumped up some number of times.
///
/// Each step's albedo is a table over the angle (cubic between entries); the mean
/// albedos of the thesis' examples (n = 20) come out to six digits (tested).
#[derive(Debug, Clone)]
pub struct Pumped<B> {
    base: B,
    rule: PumpRule,
    tables: Vec<Vec<f64>>,
}

/// Least and mean albedo after a number of steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PumpState {
    /// The least albedo over all angles.
    pub least: f64,
    /// The mean albedo.
    pub mean: f64,
    /// The greatest albedo.
    pub greatest: f64,
}

impl<B: Brdf> Pumped<B> {
    /// Pumped up `times` times (0 … 100) with as many cells as the lobe needs.
    ///
    /// Anisotropic and non-symmetric bases are refused.
    pub fn new(base: B, rule: PumpRule, times: usize) -> Result<Self, ParameterError> {
        let scale = base.chart(&Direction::NORMAL).scale;
        let cells = (12.0 * FRAC_PI_2 / scale).clamp(320.0, 2000.0) as usize;
        Self::with_cells(base, rule, times, cells)
    }

    /// With a chosen number of cells over 0 … 90° (16 … 4000).
    pub fn with_cells(
        base: B,
        rule: PumpRule,
        times: usize,
        cells: usize,
    ) -> Result<Self, ParameterError> {
        if times > 100 {
            return Err(ParameterError::new("times", times, "at most 100"));
        }
        if !(16..=4000).contains(&cells) {
            return Err(ParameterError::new("cells", cells, "16 to 4000"));
        }
        if !base.is_isotropic() {
            return Err(ParameterError::new(
                "base",
                "anisotropic",
                "an isotropic model",
            ));
        }
        let (l, v) = (
            Direction::from_degrees(20.0, 0.0),
            Direction::from_degrees(50.0, 140.0),
        );
        let (a, b) = (base.eval(&l, &v), base.eval(&v, &l));
        if (a - b).abs() > 1e-9 * a.abs() {
            return Err(ParameterError::new(
                "base",
                "not symmetric",
                "a symmetric model",
            ));
        }
        let tables = Pump::new(&base, rule, cells).tables(times);
        Ok(Self { base, rule, tables })
    }

    fn divisor(&self, l: &Direction, v: &Direction) -> f64 {
        let angle = |d: &Direction| d.z.atan2(d.x.hypot(d.y));
        let (tl, tv) = (angle(l), angle(v));
        let floor = l.z.max(v.z);
        self.tables.iter().fold(1.0, |divisor, table| {
            let a = read(table, tl).max(read(table, tv));
            self.rule.next(divisor, a, floor)
        })
    }
}

/// Least, mean and greatest albedo after 0, 1, … `times` steps with `cells` cells, for
/// each rule; the model is integrated over the azimuth once.
pub fn pump_states<B: Brdf>(
    base: &B,
    rules: &[(PumpRule, usize)],
    cells: usize,
) -> Vec<Vec<PumpState>> {
    let fresh = Pump::new(base, PumpRule::Full, cells);
    rules
        .iter()
        .map(|&(rule, times)| {
            let mut pump = fresh.clone();
            pump.rule = rule;
            (0..=times)
                .map(|k| {
                    if k > 0 {
                        pump.step();
                    }
                    pump.state()
                })
                .collect()
        })
        .collect()
}

impl PumpRule {
    fn next(self, divisor: f64, albedo: f64, floor: f64) -> f64 {
        match self {
            Self::Full => divisor * albedo,
            Self::Controlled => divisor * albedo.max(floor),
            Self::ControlledFloored => (divisor * albedo).max(floor),
        }
    }
}

/// The iteration on a grid of angles that L and V share, so that the crease at equal
/// angles falls on entries.
#[derive(Clone)]
struct Pump {
    rule: PumpRule,
    cells: usize,
    /// 2∫₀^π f dφ for each pair of angles, then divided step by step.
    kernel: Vec<f64>,
    divisor: Vec<f64>,
    albedo: Vec<f64>,
}

impl Pump {
    fn new<B: Brdf>(base: &B, rule: PumpRule, cells: usize) -> Self {
        let n = cells + 1;
        let mut kernel = vec![0.0; n * n];
        for i in 0..n {
            let l = node(i, cells, 0.0);
            for j in 0..=i {
                let around = |phi: f64| base.eval(&l, &node(j, cells, phi));
                let visible = [0.0, 0.5 * FRAC_PI_2, FRAC_PI_2, 1.5 * FRAC_PI_2, PI]
                    .iter()
                    .any(|&phi| around(phi) > 1e-14 * base.peak());
                if !visible {
                    continue;
                }
                let integral = adaptive(
                    &mut |phi| Estimate {
                        value: around(phi),
                        error: 0.0,
                    },
                    &[0.0, 0.25, FRAC_PI_2, PI - 0.25, PI],
                    1e-12 * base.peak(),
                    40,
                );
                kernel[i * n + j] = 2.0 * integral.value;
                kernel[j * n + i] = 2.0 * integral.value;
            }
        }
        let mut pump = Self {
            rule,
            cells,
            kernel,
            divisor: vec![1.0; n * n],
            albedo: Vec::new(),
        };
        pump.albedo = pump.integrate();
        pump
    }

    fn integrate(&self) -> Vec<f64> {
        let n = self.cells + 1;
        (0..n)
            .map(|i| {
                // The integrand has a crease at equal angles: two intervals.
                let mut weights = vec![0.0; n];
                add_gregory(&mut weights, 0, i);
                add_gregory(&mut weights, i, self.cells);
                (0..n)
                    .map(|j| {
                        let f = self.kernel[i * n + j] / self.divisor[i * n + j];
                        f * weights[j] * self.projected(j)
                    })
                    .sum()
            })
            .collect()
    }

    /// cosΘ sinΘ dΘ of an entry.
    fn projected(&self, j: usize) -> f64 {
        let h = 1.0 / self.cells as f64;
        let slope = PI * (1.0 - j as f64 * h);
        sine(j, self.cells) * cosine(j, self.cells) * slope * h
    }

    fn step(&mut self) {
        let n = self.cells + 1;
        for i in 0..n {
            for j in 0..n {
                let a = self.albedo[i].max(self.albedo[j]);
                let floor = cosine(i.min(j), self.cells);
                let d = &mut self.divisor[i * n + j];
                *d = self.rule.next(*d, a, floor);
            }
        }
        self.albedo = self.integrate();
    }

    fn state(&self) -> PumpState {
        let mut weights = vec![0.0; self.cells + 1];
        add_gregory(&mut weights, 0, self.cells);
        let mean: f64 = (weights.iter().zip(&self.albedo).enumerate())
            .map(|(j, (w, a))| 2.0 * w * a * self.projected(j))
            .sum();
        PumpState {
            least: self.albedo.iter().copied().fold(f64::INFINITY, f64::min),
            mean,
            greatest: self.albedo.iter().copied().fold(0.0, f64::max),
        }
    }

    fn tables(mut self, times: usize) -> Vec<Vec<f64>> {
        (0..times)
            .map(|k| {
                if k > 0 {
                    self.step();
                }
                self.albedo.clone()
            })
            .collect()
    }
}

impl<B: Brdf> Brdf for Pumped<B> {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let f = self.base.eval(l, v);
        if f == 0.0 {
            0.0
        } else {
            (f / self.divisor(l, v)).min(f64::MAX)
        }
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let divisor = self.divisor(l, v);
        self.base.eval_rgb(l, v).map(|f| {
            if f == 0.0 {
                0.0
            } else {
                (f / divisor).min(f64::MAX)
            }
        })
    }

    fn is_coloured(&self) -> bool {
        self.base.is_coloured()
    }

    fn chart(&self, l: &Direction) -> Chart {
        self.base.chart(l)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        self.base.creases(l, v, out);
        out.push(l.z - v.z);
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "pumped",
    source: "(2.16) to (2.21)",
    formula: "f/Π g, g1 = max(a(L), a(V)), g2 = max(g1, NL, NV), or the product floored at max(NL, NV)",
    parameters: "any isotropic symmetric model; rule; 0 … 100 times",
    reciprocal: true,
    grazing: "the albedo is lifted; with g1 the radiance grows beyond the mirror's",
    examples: || {
        let phong = Phong::new(20.0).expect("in range");
        vec![
            example(
                "Phong n = 20, g1 twice",
                Pumped::with_cells(phong, PumpRule::Full, 2, 240).expect("symmetric"),
                Conserves,
            ),
            example(
                "Phong n = 20, g2 floored, 3 times",
                Pumped::with_cells(phong, PumpRule::ControlledFloored, 3, 240).expect("symmetric"),
                Conserves,
            ),
        ]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::Phong;
    use crate::{directional_albedo_at, mean_albedo};

    #[test]
    fn one_step_lifts_the_mean_albedo_as_published() {
        let m = Pumped::new(Phong::new(20.0).unwrap(), PumpRule::Full, 1).unwrap();
        let mean = mean_albedo(&m);
        assert!((mean.value - 0.90297).abs() < 1e-5, "{mean:?}");
        for degrees in [0.0, 40.0, 80.0, 90.0] {
            let a = directional_albedo_at(&m, degrees);
            assert!(a.value <= 1.0 + 1e-7, "{degrees}: {a:?}");
        }
    }

    #[test]
    fn the_floored_iteration_tends_to_metallic_phong() {
        let base = Phong::new(20.0).unwrap();
        let m = Pumped::new(base, PumpRule::ControlledFloored, 30).unwrap();
        let limit = crate::models::MetallicPhong::new(20.0, crate::Energy::Published).unwrap();
        for (t, p) in [(30.0, 180.0), (60.0, 170.0), (80.0, 181.0)] {
            let l = Direction::from_degrees(55.0, 0.0);
            let v = Direction::from_degrees(t, p);
            let (a, b) = (m.eval(&l, &v), limit.eval(&l, &v));
            assert!((a / b - 1.0).abs() < 1e-3, "{t}: {a} {b}");
        }
    }

    #[test]
    fn unsuitable_bases_are_refused() {
        let ward = crate::models::WardAnisotropic::new(0.1, 0.3).unwrap();
        assert_eq!(
            Pumped::new(ward, PumpRule::Full, 1).unwrap_err().parameter,
            "base"
        );
        let phong = Phong::new(20.0).unwrap();
        assert_eq!(
            Pumped::new(phong, PumpRule::Full, 101)
                .unwrap_err()
                .parameter,
            "times"
        );
    }
}
