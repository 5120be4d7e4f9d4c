//! A kernel beside the reference: how its directions round, and what is exact.

use fixed::types::I16F16;
use microbrdf::arithmetic::{F32, Q15, Q31};
use microbrdf_kernels::{Input, Kernel};
use microbrdf_reference::{Brdf, Direction};
use microbrdf_scene::{HostArithmetic, Material};
use microbrdf_tests::domain::Pair;
use microbrdf_tests::frame::{Rotations, in_frame};

/// How an arithmetic holds a component.
#[derive(Clone, Copy)]
struct Rounding {
    bits: fn(f64) -> u32,
    value: fn(u32) -> f64,
    material: fn(&Material) -> Material,
}

impl Rounding {
    fn of(arithmetic: &str) -> Self {
        match arithmetic {
            "f32" | "micromath" => Self {
                bits: |value| (value as f32).to_bits(),
                value: |bits| f64::from(f32::from_bits(bits)),
                material: Material::rounded::<F32>,
            },
            "q31" => Self {
                bits: |value| Q31::<1024>::component(value).to_bits() as u32,
                value: |bits| f64::from(bits as i32) / (1u32 << 30) as f64,
                material: Material::rounded::<Q31>,
            },
            "q15" => Self {
                bits: |value| Q15::<129>::component(value).to_bits() as u32,
                value: |bits| f64::from(bits as i16) / f64::from(1 << 14),
                material: Material::rounded::<Q15>,
            },
            "i16f16" => Self {
                bits: |value| I16F16::from_num(value).to_bits() as u32,
                value: |bits| f64::from(bits as i32) / 65536.0,
                material: Material::clone,
            },
            other => unreachable!("no kernel takes directions in {other}"),
        }
    }
}

/// A kernel that evaluates a model, with the reference of the same, rounded,
/// material.
pub struct Subject {
    /// The kernel.
    pub kernel: &'static Kernel,
    rounding: Rounding,
    exact: Box<dyn Brdf + Send + Sync>,
}

impl Subject {
    /// The subject of a kernel; `None` for a step, which has no material.
    ///
    /// # Panics
    /// If the kernel's fields are no material.
    #[must_use]
    pub fn new(kernel: &'static Kernel) -> Option<Self> {
        if kernel.fields.is_empty() || kernel.model == "sphere" {
            return None;
        }
        let toml = format!("model = \"{}\", {}", kernel.model, kernel.fields);
        let material = Material::from_argument(&toml).expect("a kernel's material");
        let rounding = Rounding::of(kernel.arithmetic);
        Some(Self {
            kernel,
            rounding,
            exact: (rounding.material)(&material).reference(),
        })
    }

    /// The reference's peak.
    #[must_use]
    pub fn peak(&self) -> f64 {
        self.exact.peak()
    }

    /// What the kernel is given for pairs of directions; world-space kernels
    /// get them turned at random.
    #[must_use]
    pub fn inputs(&self, pairs: &[Pair]) -> Vec<Input> {
        let mut rotations = Rotations::new(0x5EED);
        pairs
            .iter()
            .map(|&pair| {
                let vectors = if self.kernel.takes_normal() {
                    rotations.turn(pair)
                } else {
                    [[0.0, 0.0, 1.0], pair[0], pair[1]]
                };
                Input {
                    vectors: vectors.map(|vector| vector.map(self.rounding.bits)),
                }
            })
            .collect()
    }

    /// Whether a pair reflects anything.
    #[must_use]
    pub fn is_lit(&self, pair: Pair) -> bool {
        let [l, v] = pair.map(|[x, y, z]| Direction::new(x, y, z));
        self.exact.rho(&l, &v).iter().any(|rho| *rho > 0.0)
    }

    /// The exact 8-bit sRGB codes of an input, real numbers.
    #[must_use]
    pub fn codes(&self, input: &Input) -> [f64; 3] {
        let [n, l, v] = input.vectors.map(|vector| vector.map(self.rounding.value));
        let [l, v] = if self.kernel.takes_normal() {
            in_frame(n, l, v)
        } else {
            [l, v]
        };
        let direction = |[x, y, z]: [f64; 3]| Direction::new(x, y, z);
        self.exact.rho(&direction(l), &direction(v)).map(|rho| {
            255.0 * microbrdf_reference::encode_srgb((self.kernel.k * rho).clamp(0.0, 1.0))
        })
    }
}
