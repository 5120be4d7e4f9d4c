//! How each row is computed.

use super::Given;
use crate::albedo::{
    directional_albedo, directional_albedo_at, directional_albedo_for, mean_albedo_to,
};
use crate::fresnel::{Index, dielectric};
use crate::half::Half;
use crate::models::microfacet::Distribution;
use crate::models::pumped::{PumpRule, PumpState, pump_states};
use crate::models::{
    Blinn, BlinnCos, CookTorrance, Energy, GeneralisedLambert, MetallicPhong, PModel, Patch,
    PatchExponential, Phong, Ward, WardCorrected, blinn, minnaert,
};
use crate::quadrature::{Accuracy, Chart, ChartKind, hemisphere};
use crate::{Brdf, Direction};
use std::collections::HashMap;
use std::f64::consts::PI;

/// Cells of the grid on which albedos are pumped up.
const CELLS: usize = 240;

/// Keeps what several rows share.
#[derive(Default)]
pub(super) struct Computer {
    means: HashMap<String, f64>,
    pumped: HashMap<&'static str, Vec<Vec<PumpState>>>,
}

impl Computer {
    /// The value of a row; NaN if its id is not known.
    pub fn value(&mut self, given: &Given) -> f64 {
        let id = given.id.as_str();
        let after = |prefix: &str| id.strip_prefix(prefix).and_then(|t| t.parse::<f64>().ok());
        if let Some(n) = after("T1.1/T3.1-") {
            // The closed form, and the albedo at the normal by quadrature.
            let model = Blinn::new(n).expect("in range");
            return blinn::greatest_constant(n) / directional_albedo(&model, 1.0).value;
        }
        if let Some(n) = after("T3.1m-") {
            return BlinnCos::greatest_constant(n).0;
        }
        if id.starts_with("T1.2-") {
            return 100.0 * index(&given.params).reflectance(1.0);
        }
        if let Some(m) = after("T3.2-") {
            return WardCorrected::new(m).expect("in range").greatest_constant();
        }
        if let Some(rest) = id.strip_prefix("T3.3-") {
            return self.table_3_3(rest);
        }
        if let Some(rest) = id.strip_prefix("T4.1-") {
            return table_4_1(rest);
        }
        if let Some(rest) = id.strip_prefix("T4.3-") {
            return table_4_3(rest);
        }
        if let Some(n) = after("E3.27-") {
            return directional_albedo_at(&metallic(n), 90.0).value;
        }
        if let Some(n) = after("E3.11-over-") {
            return overshoot(n).1 - 1.0;
        }
        if let Some(n) = after("E3.11-angle-") {
            return overshoot(n).0;
        }
        if let Some(degrees) = after("T-ward-") {
            return directional_albedo_at(&Ward::new(0.1).expect("in range"), degrees).value;
        }
        if let Some(degrees) = after("T-cook-") {
            let model = CookTorrance::beckmann(0.1).expect("in range");
            return directional_albedo_at(&model, degrees).value;
        }
        if let Some(m) = after("X-cookmax-") {
            let model = CookTorrance::beckmann(m).expect("in range");
            let angles = (0..90)
                .map(f64::from)
                .chain([89.5, 89.9, 89.99, 89.999, 89.9999]);
            return angles
                .map(|d| directional_albedo_at(&model, d).value)
                .fold(0.0, f64::max);
        }
        if let Some(rest) = id.strip_prefix("S2.3.") {
            return self.pumping(rest);
        }
        if let Some(rest) = id.strip_prefix("SL-") {
            return slides(rest, &given.params);
        }
        self.single(id)
    }

    fn mean(&mut self, name: &str, n: f64) -> f64 {
        let key = format!("{name} {n}");
        if let Some(known) = self.means.get(&key) {
            return *known;
        }
        let model: Box<dyn Brdf> = match name {
            "Phong" => Box::new(Phong::new(n).expect("in range")),
            "Phong/cos" => Box::new(metallic(n)),
            "Blinn" => Box::new(Blinn::new(n).expect("in range")),
            _ => Box::new(BlinnCos::new(n).expect("in range")),
        };
        let mean = mean_albedo_to(model.as_ref(), 4e-11).value;
        self.means.insert(key, mean);
        mean
    }

    fn table_3_3(&mut self, rest: &str) -> f64 {
        let Some((name, n)) = rest.rsplit_once('-') else {
            return f64::NAN;
        };
        let n = match (n, name) {
            // The limit, by an exponent that is large enough for the digits given.
            ("inf", "Phong" | "Phong/cos") => 1e8,
            ("inf", _) => 1e6,
            (n, _) => n.parse().unwrap_or(f64::NAN),
        };
        self.mean(name, n)
    }

    fn pumping(&mut self, rest: &str) -> f64 {
        // "1-phong", "2-phong-g2cap" and so on: the mean after the last step listed.
        let name = if rest.contains("phong") {
            "phong"
        } else {
            "blinn"
        };
        let states = self.pumped.entry(name).or_insert_with(|| {
            let rules = [
                (PumpRule::Full, 30),
                (PumpRule::Controlled, 60),
                (PumpRule::ControlledFloored, 60),
            ];
            if name == "phong" {
                pump_states(&Phong::new(20.0).expect("in range"), &rules, CELLS)
            } else {
                pump_states(&Blinn::new(20.0).expect("in range"), &rules, CELLS)
            }
        });
        let rule = if rest.ends_with("g2cap") {
            2
        } else if rest.ends_with("g2") {
            1
        } else {
            0
        };
        states[rule].last().map_or(f64::NAN, |s| s.mean)
    }

    fn single(&mut self, id: &str) -> f64 {
        match id {
            "T4.2-amean-Phong" => self.mean("Phong", 1e8),
            "T4.2-amean-new" => mean_albedo_to(&patch_exponential(1e8), 1e-7).value,
            "T4.2-a90-Phong" => {
                // a(90°) of Phong falls as n^(−1/2).
                directional_albedo_at(&Phong::new(1e8).expect("in range"), 90.0).value
            }
            "T4.2-a90-new" => directional_albedo_at(&patch_exponential(1e7), 89.9).value,
            "T4.2-L90" => {
                let l = Direction::from_cosine(1e-12, 0.0);
                patch_exponential(1e4).rho(&l, &l.mirrored())[0]
            }
            "B-0.391" => Patch::new(1.0).expect("in range").exact_albedo(0.0),
            // Over the row's own grid, 400 radii from 0.01 to 2, which misses R = 1 by a hair.
            "B-min" => (0..400)
                .map(|i| 0.01 + 1.99 * f64::from(i) / 399.0)
                .map(|r| Patch::new(r.min(2.0)).expect("in range").exact_albedo(0.0))
                .fold(f64::INFINITY, f64::min),
            "F4.6-min" => least_mean_radius(),
            "S3.7.4-a" => directional_albedo_at(&Blinn::new(128.0).expect("in range"), 90.0).value,
            "S3.7.4-b" => {
                directional_albedo_at(&BlinnCos::new(128.0).expect("in range"), 90.0).value
            }
            "S3.7.4-c" => self.mean("Blinn", 128.0),
            "S3.7.4-d" => self.mean("Blinn/cos", 128.0),
            "S3.7.2-0.85" => {
                let ward = Ward::new(0.2).expect("in range");
                (0..=89)
                    .map(|d| directional_albedo_at(&ward, f64::from(d)).value)
                    .fold(0.0, f64::max)
            }
            "S3.2.4-0.5" => directional_albedo_at(&metallic(1e8), 90.0).value,
            "S3.5.1-45" => {
                let half = Half::of(&Direction::NORMAL, &Direction::new(1.0, 0.0, 0.0));
                half.map_or(f64::NAN, |h| h.lh.acos().to_degrees())
            }
            "E1.32" => minnaert::Minnaert::new(1.0).expect("in range").peak(),
            "S1.2.7-0.04" => dielectric(1.5, 1.0),
            "E4.48" => {
                let s = 10.0f64;
                1.0 - s * s / (2.0 * PI) / patch_exponential(s).peak()
            }
            "E3.12-all" => {
                let mut greatest = 0.0f64;
                for p in [0.25, 0.5, 0.75, 0.9] {
                    for n in [1.0, 1.5, 2.0, 20.0] {
                        let model = PModel::new(n, p, Energy::Published).expect("in range");
                        for degrees in (0..=90).step_by(3) {
                            let a = directional_albedo_at(&model, f64::from(degrees)).value;
                            greatest = greatest.max(a);
                        }
                    }
                }
                greatest
            }
            _ => f64::NAN,
        }
    }
}

fn metallic(n: f64) -> MetallicPhong {
    MetallicPhong::new(n, Energy::Published).expect("in range")
}

fn patch_exponential(s: f64) -> PatchExponential {
    PatchExponential::new(s).expect("in range")
}

/// "n=0.93 k=6.33" or "eta=0.37 k=2.82".
fn index(params: &str) -> Index {
    let number = |names: [&str; 2]| {
        params
            .split_whitespace()
            .filter_map(|part| part.split_once('='))
            .find(|(name, _)| names.contains(name))
            .and_then(|(_, value)| value.parse().ok())
            .unwrap_or(0.0)
    };
    Index::new(number(["n", "eta"]), number(["k", "k"])).expect("a row's index")
}

fn table_4_1(rest: &str) -> f64 {
    let Some((what, s)) = rest.split_once('-') else {
        return f64::NAN;
    };
    let Ok(s) = s.parse::<f64>() else {
        return f64::NAN;
    };
    let model = patch_exponential(s);
    match what {
        "C" => model.peak(),
        // ∫₁² p dR = π C (e^(−s) − e^(−2s)), which a difference of F would lose.
        "I" => -PI * model.peak() * (-s).exp() * (-s).exp_m1(),
        "a" => model.diffuse_weight(),
        _ => f64::NAN,
    }
}

fn table_4_3(rest: &str) -> f64 {
    let Some((what, d)) = rest.split_once('-') else {
        return f64::NAN;
    };
    let Ok(d) = d.parse::<f64>() else {
        return f64::NAN;
    };
    let model = GeneralisedLambert::new(d, 1.9).expect("in range");
    match what {
        "C" => model.removable_diffuse() / PI,
        "f" => model.greatest_profile(),
        "a" => directional_albedo(&model, 1.0).value,
        _ => f64::NAN,
    }
}

/// Where metallic Phong's albedo is greatest (degrees) and what it is there.
///
/// The maximum of the polynomial through the albedo at Chebyshev nodes around it: the
/// angle follows from the slope, where the albedo itself is too flat.
fn overshoot(n: f64) -> (f64, f64) {
    let model = metallic(n);
    let accuracy = Accuracy {
        tolerance: 1e-15,
        ..Accuracy::FINE
    };
    let at = |degrees: f64| {
        directional_albedo_for(&model, &Direction::from_degrees(degrees, 0.0), accuracy).value
    };
    let (c, _) = crate::albedo::greatest(&|c| directional_albedo(&model, c).value);
    let middle = c.acos().to_degrees();
    const NODES: usize = 12;
    let half = 3.0;
    let nodes: Vec<f64> = (0..NODES)
        .map(|i| (PI * (i as f64 + 0.5) / NODES as f64).cos())
        .collect();
    let values: Vec<f64> = nodes.iter().map(|x| at(middle + half * x) - 1.0).collect();
    let coefficients: Vec<f64> = (0..NODES)
        .map(|k| {
            let sum: f64 = (nodes.iter().zip(&values))
                .map(|(x, v)| v * (k as f64 * x.acos()).cos())
                .sum();
            sum * if k == 0 { 1.0 } else { 2.0 } / NODES as f64
        })
        .collect();
    let polynomial = |x: f64| -> f64 {
        coefficients
            .iter()
            .enumerate()
            .map(|(k, c)| c * (k as f64 * x.acos()).cos())
            .sum()
    };
    // d/dx cos(k acos x) = k sin(k acos x)/sin(acos x).
    let mut slope = |x: f64| -> f64 {
        let t = x.acos();
        coefficients
            .iter()
            .enumerate()
            .map(|(k, c)| c * k as f64 * (k as f64 * t).sin() / t.sin())
            .sum()
    };
    let x = crate::quadrature::find_root(&mut slope, -0.5, 0.5);
    (middle + half * x, 1.0 + polynomial(x))
}

/// The radius of the basic patch with the least mean albedo, from the closed albedo.
fn least_mean_radius() -> f64 {
    let mean = |r: f64| {
        let patch = Patch::new(r).expect("in range");
        crate::albedo::mean_of(
            &|c| crate::Estimate::exact(patch.exact_albedo(c)),
            1.0,
            1e-11,
        )
        .value
    };
    let grid = (1..=80).map(|i| f64::from(i) * 0.025);
    grid.min_by(|a, b| mean(*a).total_cmp(&mean(*b)))
        .unwrap_or(f64::NAN)
}

fn slides(rest: &str, params: &str) -> f64 {
    let projected = |d: Distribution| {
        hemisphere(
            &Direction::NORMAL,
            &Chart::new(ChartKind::Plane, 0.3),
            false,
            Accuracy::FINE,
            &|_, _| {},
            &|v| Half::of(v, v).map_or(0.0, |h| d.density(&h)),
        )
        .value
    };
    match rest {
        "blinnD" => projected(Distribution::blinn(30.0).expect("in range")),
        "AS" => projected(Distribution::ashikhmin_shirley(10.0, 1000.0).expect("in range")),
        _ => index(params).reflectance(1.0),
    }
}
