//! The closed list of models: what the tests and the documentation go through.

use super::measured_irregular::Sample;
use super::microfacet::{Attenuation, Distribution, Facet};
use super::*;
use crate::fresnel::Index;
use crate::sampling::{
    Cosine, Elliptic, Mixture, MixtureMethod, PatchDisc, PatchMethod, PhongLobe, Sampler,
    ToblerLobe, ToblerProfile, Weighted,
};
use crate::{Brdf, Direction, MetalName};

/// What a parameter set is expected to do with energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Claim {
    /// The albedo never exceeds 1.
    Conserves,
    /// It does somewhere.
    Exceeds,
}

/// A model with parameters, for tests and documentation.
pub struct Example {
    /// The parameters as text.
    pub parameters: &'static str,
    /// The model.
    pub model: Box<dyn Brdf>,
    /// What it is expected to do with energy.
    pub claim: Claim,
}

/// Calls back with a model, a V and a sampler of it.
pub type WithSampler = fn(Direction, &mut dyn FnMut(&dyn Brdf, &dyn Sampler));

/// An entry of the list.
pub struct ModelEntry {
    /// The name of its file in `models/`.
    pub name: &'static str,
    /// Where it is from.
    pub source: &'static str,
    /// The formula.
    pub formula: &'static str,
    /// Its parameters and their ranges.
    pub parameters: &'static str,
    /// Whether f(L, V) = f(V, L).
    pub reciprocal: bool,
    /// What it does at grazing angles.
    pub grazing: &'static str,
    /// Parameter sets; the first is the one that the cost is counted for.
    pub examples: fn() -> Vec<Example>,
    /// A sampler, where the texts give one.
    pub sampler: Option<WithSampler>,
}

fn example(parameters: &'static str, model: impl Brdf + 'static, claim: Claim) -> Example {
    Example {
        parameters,
        model: Box::new(model),
        claim,
    }
}

fn index(eta: f64, k: f64) -> Index {
    Index::new(eta, k).expect("a plausible index")
}

fn gold() -> [Index; 3] {
    // About gold at 610, 550 and 465 nm.
    [index(0.50, 3.2), index(0.69, 2.4), index(1.64, 1.74)]
}

use Claim::{Conserves, Exceeds};

/// Every model, in the order of its file's name.
pub const ALL: &[ModelEntry] = &[
    ModelEntry {
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
        sampler: None,
    },
    ModelEntry {
        name: "anisotropic_sum",
        source: "(3.16)",
        formula: "Σ wᵢ fᵢ of anisotropic Phong lobes",
        parameters: "weights wᵢ 0 … 1 with a sum of at most 1",
        reciprocal: true,
        grazing: "the sum of its lobes'",
        examples: || {
            let wide = AnisotropicPhong::new([1.0; 3], 4.0, 1.0).expect("in range");
            let narrow = AnisotropicPhong::new([0.9, 1.0, 1.0], 40.0, 1.0).expect("in range");
            vec![example(
                "0.4 × (1, 1, 1), n = 4 and 0.6 × (0.9, 1, 1), n = 40, p = 1",
                AnisotropicSum::new(&[(0.4, wide), (0.6, narrow)]).expect("in range"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "beard_maxwell",
        source: "(1.55), first-surface term from Maxwell et al. 1973, Westlund and Meyer 2002",
        formula: "ρ_D/π + F(β)/F(0) f_ZBS(δ) cos²δ/(NL·NV) · shadowing + 2ρ_V/(NL + NV)",
        parameters: "ρ_D, ρ_V 0 … 1; index; τ, Ω above 0; measured f_ZBS(δ)",
        reciprocal: true,
        grazing: "unbounded: f_ZBS/(NL·NV), and ρ_V/(NL + NV)",
        examples: || {
            vec![example(
                "ρ_D = 0.1, ρ_V = 0.05, glass, τ = 0.3, Ω = 0.5, f_ZBS = 0.3 to 0",
                BeardMaxwell::new(0.1, 0.05, index(1.5, 0.0), 0.3, 0.5, &[0.3, 0.1, 0.02, 0.0])
                    .expect("in range"),
                Exceeds,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "bisector_phong",
        source: "(5.15) to (5.17)",
        formula: "C cosⁿα / cosΘ_H with a bisector H of R and V",
        parameters: "n 0 … 1e5; power mean p above 0, maximum, or spherical",
        reciprocal: true,
        grazing: "radiance bounded; power means with p at or below 0 are refused: unbounded albedo",
        examples: || {
            vec![
                example(
                    "n = 20, spherical",
                    BisectorPhong::new(20.0, Bisector::Spherical).expect("in range"),
                    Conserves,
                ),
                example(
                    "n = 20, arithmetic mean",
                    BisectorPhong::new(20.0, Bisector::PowerMean(1.0)).expect("in range"),
                    Conserves,
                ),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "blinn",
        source: "(1.34), (3.33), constant in closed form",
        formula: "C_n (N·H)ⁿ, C_n = (n + 2)(n + 4)/(8π(n + 2^(−n/2)))",
        parameters: "n 0 … 1e8",
        reciprocal: true,
        grazing: "albedo falls to 1/(n + 2^(−n/2)), radiance to 0",
        examples: || {
            vec![example(
                "n = 20",
                Blinn::new(20.0).expect("in range"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "blinn_cos",
        source: "(3.34)",
        formula: "C_n (N·H)ⁿ / max(NL, NV)",
        parameters: "n 0 … 1e8",
        reciprocal: true,
        grazing: "radiance bounded by C_n; albedo still falls, N·H lobes are too wide there",
        examples: || {
            vec![
                example("n = 20", BlinnCos::new(20.0).expect("in range"), Conserves),
                example("n = 2", BlinnCos::new(2.0).expect("in range"), Conserves),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "blinn_original",
        source: "(2.5)",
        formula: "C_n (N·H)ⁿ / cosΘL",
        parameters: "n 0 … 1e8",
        reciprocal: false,
        grazing: "albedo unbounded",
        examples: || {
            vec![example(
                "n = 20",
                BlinnOriginal::new(20.0).expect("in range"),
                Exceeds,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "cook_torrance",
        source: "(1.35) to (1.38), (2.9), (2.10)",
        formula: "D G F/(4 NL·NV)",
        parameters: "Beckmann m, Gaussian s, Trowbridge q or Blinn t; V-cavity, He–Torrance's or Smith's G; F",
        reciprocal: true,
        grazing: "with V-cavities the albedo tends to 1 and f stays at most D/(2 LH max(NL, NV)); without G it is unbounded",
        examples: || {
            let gaussian = Distribution::gaussian(5.0).expect("in range");
            let trowbridge = Distribution::trowbridge(0.3).expect("in range");
            let blinn = Distribution::blinn(30.0).expect("in range");
            let beckmann = Distribution::beckmann(0.3).expect("in range");
            let new = |d, a| CookTorrance::new(d, a, Facet::White).expect("they fit");
            vec![
                example(
                    "Beckmann m = 0.3, V-cavity",
                    new(beckmann, Attenuation::VCavity),
                    Conserves,
                ),
                example(
                    "Beckmann m = 0.1, V-cavity",
                    CookTorrance::beckmann(0.1).expect("in range"),
                    Conserves,
                ),
                example(
                    "Gaussian s = 5, V-cavity",
                    new(gaussian, Attenuation::VCavity),
                    Conserves,
                ),
                example(
                    "Trowbridge q = 0.3, V-cavity",
                    new(trowbridge, Attenuation::VCavity),
                    Conserves,
                ),
                example(
                    "Blinn t = 30, V-cavity",
                    new(blinn, Attenuation::VCavity),
                    Conserves,
                ),
                example(
                    "Beckmann m = 0.3, Smith",
                    new(beckmann, Attenuation::Smith),
                    Conserves,
                ),
                example(
                    "Beckmann m = 0.3, He–Torrance",
                    new(beckmann, Attenuation::HeTorrance),
                    Conserves,
                ),
                example(
                    "Beckmann m = 0.3, G = 1",
                    new(beckmann, Attenuation::None),
                    Exceeds,
                ),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "generalised_lambert",
        source: "(4.58), (4.59)",
        formula: "C min((1 − m²/4)^(−d/2), ξ_max)",
        parameters: "d 0 … 1; clip above 0 and below 2",
        reciprocal: true,
        grazing: "albedo greatest, 1, at the horizon",
        examples: || {
            vec![
                example(
                    "d = 1, clip 1.9",
                    GeneralisedLambert::new(1.0, 1.9).expect("in range"),
                    Conserves,
                ),
                example(
                    "d = 0.3, clip 1.9",
                    GeneralisedLambert::new(0.3, 1.9).expect("in range"),
                    Conserves,
                ),
            ]
        },
        sampler: Some(|v, visit| {
            let m = GeneralisedLambert::new(1.0, 1.9).expect("in range");
            visit(&m, &Cosine::new(&m, v));
        }),
    },
    ModelEntry {
        name: "ggx",
        source: "Walter et al. 2007; not in the thesis",
        formula: "D G1(L) G1(V) F/(4 NL·NV), D = α²/(π((α² − 1)cos²δ + 1)²)",
        parameters: "α 1e-4 … 1; F",
        reciprocal: true,
        grazing: "loses what is scattered more than once",
        examples: || {
            vec![
                example(
                    "α = 0.3",
                    Ggx::new(0.3, Facet::White).expect("in range"),
                    Conserves,
                ),
                example(
                    "α = 0.05, gold",
                    Ggx::new(0.05, Facet::Coloured(gold())).expect("in range"),
                    Conserves,
                ),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "lacquer",
        source: "(1.60), (1.61)",
        formula: "F mirror + (1 − F(angle(L, H))) e^(−s(1/NL + 1/NV)) f_base",
        parameters: "absorbance s at least 0; index of the surface, or none; any base",
        reciprocal: true,
        grazing: "absorption takes the base to 0; thin absorbance under a reflecting surface exceeds 1",
        examples: || {
            let base = Lambert::grey(1.0).expect("in range");
            vec![
                example(
                    "s = 0.3 over white, no surface",
                    Lacquer::new(base, [0.3; 3], None).expect("in range"),
                    Conserves,
                ),
                example(
                    "s = 0.3 over white, glass",
                    Lacquer::new(base, [0.3; 3], Some(index(1.5, 0.0))).expect("in range"),
                    Conserves,
                ),
                example(
                    "s = 0.01 over white, glass",
                    Lacquer::new(base, [0.01; 3], Some(index(1.5, 0.0))).expect("in range"),
                    Exceeds,
                ),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "lafortune",
        source: "(1.66), slides",
        formula: "ρ/π + Σ ((Cx LxVx + Cy LyVy + Cz LzVz)⁺)ⁿ",
        parameters: "ρ 0 … 1; Cx, Cy, Cz, n 0 … 1e8 of each lobe: energy is in the constants",
        reciprocal: true,
        grazing: "f bounded: radiance falls to 0",
        examples: || {
            vec![
                example(
                    "one Phong lobe, n = 20",
                    Lafortune::phong(20.0).expect("in range"),
                    Conserves,
                ),
                example(
                    "(−1.02, −1.02, 0.8), n = 12: off-specular",
                    Lafortune::new(
                        0.0,
                        &[LafortuneLobe {
                            weights: [-1.02, -1.02, 0.8],
                            exponent: 12.0,
                        }],
                    )
                    .expect("in range"),
                    Conserves,
                ),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "lambert",
        source: "(1.27), (1.28)",
        formula: "a/π",
        parameters: "a 0 … 1",
        reciprocal: true,
        grazing: "albedo constant",
        examples: || {
            vec![example(
                "a = 1",
                Lambert::grey(1.0).expect("in range"),
                Conserves,
            )]
        },
        sampler: Some(|v, visit| {
            let m = Lambert::new([0.9, 0.5, 0.2]).expect("in range");
            visit(&m, &Cosine::new(&m, v));
        }),
    },
    ModelEntry {
        name: "lommel_seeliger",
        source: "(1.52) to (1.54), Hapke 1963",
        formula: "ρ/π · B(γ) S(γ)/(NL + NV)",
        parameters: "ρ 0 … 1; compactness 0 … 10; isotropic, forward or backward S",
        reciprocal: true,
        grazing: "f unbounded; the albedo tends to 2 for ρ = S = B = 1",
        examples: || {
            vec![
                example(
                    "ρ = 1, S = B = 1",
                    LommelSeeliger::new(1.0, 0.0, Scattering::Isotropic).expect("in range"),
                    Exceeds,
                ),
                example(
                    "ρ = 1, h = 0.4, backward",
                    LommelSeeliger::new(1.0, 0.4, Scattering::Backward).expect("in range"),
                    Conserves,
                ),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "measured_half_angle",
        source: "slides; Matusik et al. 2003, BRDFRead",
        formula: "table over √θh, θd, φd",
        parameters: "a file in the MERL layout",
        reciprocal: true,
        grazing: "as measured",
        examples: || {
            let blinn = Blinn::new(10.0).expect("in range");
            let blinn = Mixed::new(vec![(0.9, Box::new(blinn))]).expect("in range");
            vec![example(
                "a table of 0.9 × Blinn, n = 10, 30 × 10 × 4",
                MeasuredHalfAngle::tabulate(&blinn, [30, 10, 4]).expect("a small table"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "measured_irregular",
        source: "slides, after pbrt",
        formula: "samples weighted by e^(−100d²) in (sinΘL sinΘV, Δφ/π, cosΘL cosΘV)",
        parameters: "samples (L, V, f)",
        reciprocal: true,
        grazing: "as measured",
        examples: || {
            let phong = Phong::new(3.0).expect("in range");
            let mut samples = Vec::new();
            for i in 0..5 {
                for j in 0..5 {
                    for k in 0..4 {
                        let l = Direction::from_degrees(f64::from(i) * 20.0, 0.0);
                        let v = Direction::from_degrees(f64::from(j) * 20.0, f64::from(k) * 60.0);
                        samples.push(Sample {
                            l,
                            v,
                            f: [0.6 * phong.eval(&l, &v); 3],
                        });
                    }
                }
            }
            vec![example(
                "100 samples of 0.6 × Phong, n = 3",
                MeasuredIrregular::new(&samples).expect("samples"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "metal",
        source: "(3.29)",
        formula: "c_n cosⁿα F(Θmin)/cosΘmin = cosⁿα/g(Θmin)",
        parameters: "n 0 … 1e8; a metal's name, or η and k of each channel",
        reciprocal: true,
        grazing: "as metallic Phong; the colour fades to white",
        examples: || {
            vec![
                example(
                    "gold (spectrum), n = 20",
                    Metal::named(20.0, MetalName::Gold).expect("in range"),
                    Conserves,
                ),
                example(
                    "η = 1.5, 0.9, 0.2, k = 1.8, 2.4, 3.5, n = 500",
                    Metal::from_indices(500.0, [1.5, 0.9, 0.2], [1.8, 2.4, 3.5]).expect("in range"),
                    Conserves,
                ),
            ]
        },
        sampler: Some(|v, visit| {
            let m = Metal::named(80.0, MetalName::Copper).expect("in range");
            visit(&m, &PhongLobe::new(&m, 80.0, v));
        }),
    },
    ModelEntry {
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
    },
    ModelEntry {
        name: "metallic_paint",
        source: "(4.51) to (4.54)",
        formula: "C e^(−s·m) F(θ'), sinθ' = |L_P − V_P|/2",
        parameters: "s 0 … 1e8; one index for each channel",
        reciprocal: true,
        grazing: "f bounded; albedo at least half of F's",
        examples: || {
            vec![example(
                "gold's indices, s = 12",
                MetallicPaint::new(12.0, gold()).expect("in range"),
                Conserves,
            )]
        },
        sampler: Some(|v, visit| {
            let m = MetallicPaint::new(12.0, gold()).expect("in range");
            let shape = PatchExponential::new(12.0).expect("in range");
            let directions = Box::new(Mixture::new(shape, v, MixtureMethod::Redraw));
            visit(&m, &Weighted::new(&m, v, directions));
        }),
    },
    ModelEntry {
        name: "metallic_phong",
        source: "(3.7), (3.10)",
        formula: "c_n cosⁿα/cosΘmin, c_n = (n + 2)/2π",
        parameters: "n 0 … 1e8; published or strict energy",
        reciprocal: true,
        grazing: "radiance of the mirror image constant; albedo (n + 2)/(2n + 2) at 90°",
        examples: || {
            let new = |n, energy| MetallicPhong::new(n, energy).expect("in range");
            vec![
                example("n = 20", new(20.0, Energy::Published), Conserves),
                example("n = 1e8", new(1e8, Energy::Published), Conserves),
                example("n = 1, published", new(1.0, Energy::Published), Exceeds),
                example("n = 0.5, published", new(0.5, Energy::Published), Exceeds),
                example("n = 0.5, strict", new(0.5, Energy::Strict), Conserves),
            ]
        },
        sampler: Some(|v, visit| {
            let m = MetallicPhong::new(20.0, Energy::Published).expect("in range");
            visit(&m, &PhongLobe::new(&m, 20.0, v));
        }),
    },
    ModelEntry {
        name: "minnaert",
        source: "(1.31), (1.32)",
        formula: "(k + 2)/2π (NL·NV)ᵏ",
        parameters: "k 0 … 100",
        reciprocal: true,
        grazing: "albedo cosᵏΘ; negative k is refused, its albedo is unbounded",
        examples: || {
            vec![example(
                "k = 1",
                Minnaert::new(1.0).expect("in range"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "mirror",
        source: "(1.29), (1.30)",
        formula: "F(Θ) Δ(V − R)/cosΘ",
        parameters: "one index for each channel, or ideal",
        reciprocal: true,
        grazing: "albedo F(Θ), 1 at 90°: a Dirac part only",
        examples: || {
            vec![
                example("gold's indices", Mirror::new(gold()), Conserves),
                example("ideal", Mirror::ideal(), Conserves),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "mixed",
        source: "(5.3), (5.4)",
        formula: "Σ cₖ fₖ",
        parameters: "weights 0 … 1 with a sum of at most 1; any models",
        reciprocal: true,
        grazing: "the sum of its parts'",
        examples: || {
            vec![example(
                "0.5 Lambert and 0.5 metallic Phong, n = 20",
                Mixed::new(vec![
                    (0.5, Box::new(Lambert::grey(1.0).expect("in range"))),
                    (
                        0.5,
                        Box::new(MetallicPhong::new(20.0, Energy::Published).expect("in range")),
                    ),
                ])
                .expect("in range"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "oren_nayar",
        source: "(1.56)",
        formula: "ρ/π (A + B (LV − NL·NV)⁺/max(NL, NV))",
        parameters: "ρ 0 … 1; σ 0 … π/2 radians",
        reciprocal: true,
        grazing: "f unbounded for L and V both at the horizon; albedo up to 1.015",
        examples: || {
            vec![
                example(
                    "ρ = 1, σ = 0.2",
                    OrenNayar::new(1.0, 0.2).expect("in range"),
                    Exceeds,
                ),
                example(
                    "ρ = 0.9, σ = 0.5",
                    OrenNayar::new(0.9, 0.5).expect("in range"),
                    Conserves,
                ),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "oren_nayar_full",
        source: "(1.57) to (1.59), Oren and Nayar 1994",
        formula: "ρ/π (A + B … + C₃ … ) + interreflections",
        parameters: "ρ 0 … 1; σ 0 … π/2 radians",
        reciprocal: true,
        grazing: "f unbounded; albedo up to 1.05",
        examples: || {
            vec![
                example(
                    "ρ = 1, σ = 0.3",
                    OrenNayarFull::new(1.0, 0.3).expect("in range"),
                    Exceeds,
                ),
                example(
                    "ρ = 0.8, σ = 0.5",
                    OrenNayarFull::new(0.8, 0.5).expect("in range"),
                    Conserves,
                ),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "p_model",
        source: "(3.12)",
        formula: "c_n cosⁿα/cosᵖΘmin",
        parameters: "n 0 … 1e8; p 0 … 1; published or strict energy",
        reciprocal: true,
        grazing: "between Phong's (p = 0) and metallic Phong's (p = 1)",
        examples: || {
            let new = |n, p, energy| PModel::new(n, p, energy).expect("in range");
            vec![
                example(
                    "n = 20, p = 0.5",
                    new(20.0, 0.5, Energy::Published),
                    Conserves,
                ),
                example(
                    "n = 1, p = 0.9",
                    new(1.0, 0.9, Energy::Published),
                    Conserves,
                ),
                example("n = 1, p = 1", new(1.0, 1.0, Energy::Published), Exceeds),
            ]
        },
        sampler: Some(|v, visit| {
            let m = PModel::new(7.0, 0.5, Energy::Published).expect("in range");
            visit(&m, &PhongLobe::new(&m, 7.0, v));
        }),
    },
    ModelEntry {
        name: "patch",
        source: "(4.2), (4.7)",
        formula: "1/(π min(1, R²)) where m ≤ R",
        parameters: "R above 0 and at most 2",
        reciprocal: true,
        grazing: "f bounded; albedo at least 0.391",
        examples: || {
            vec![
                example("R = 0.5", Patch::new(0.5).expect("in range"), Conserves),
                example("R = 1", Patch::new(1.0).expect("in range"), Conserves),
            ]
        },
        sampler: Some(|v, visit| {
            for (radius, method) in [
                (0.5, PatchMethod::Rejection),
                (1.2, PatchMethod::Rejection),
                (0.5, PatchMethod::Roulette),
            ] {
                let m = Patch::new(radius).expect("in range");
                visit(&m, &PatchDisc::new(radius, v, method));
            }
        }),
    },
    ModelEntry {
        name: "patch_elliptic",
        source: "(4.32) to (4.36)",
        formula: "c(b) where √((B/A x)² + y²) ≤ b",
        parameters: "b above 0 and at most 2; B/A above 0 and at most 1",
        reciprocal: true,
        grazing: "f bounded",
        examples: || {
            vec![example(
                "b = 0.4, B/A = 0.5",
                PatchElliptic::new(0.4, 0.5).expect("in range"),
                Conserves,
            )]
        },
        sampler: Some(|v, visit| {
            let m = PatchElliptic::new(0.4, 0.5).expect("in range");
            visit(&m, &Elliptic::new(m, v));
        }),
    },
    ModelEntry {
        name: "patch_exponential",
        source: "(4.45) to (4.47)",
        formula: "s²/(2π(1 − (1 + s)e^(−s))) e^(−s·m)",
        parameters: "s 0 … 1e8",
        reciprocal: true,
        grazing: "f bounded, radiance falls to 0; albedo at least about ½",
        examples: || {
            vec![
                example(
                    "s = 12",
                    PatchExponential::new(12.0).expect("in range"),
                    Conserves,
                ),
                example(
                    "s = 1",
                    PatchExponential::new(1.0).expect("in range"),
                    Conserves,
                ),
            ]
        },
        sampler: Some(|v, visit| {
            for (s, method) in [
                (4.0, MixtureMethod::Redraw),
                (40.0, MixtureMethod::Redraw),
                (1.0, MixtureMethod::Roulette),
            ] {
                let m = PatchExponential::new(s).expect("in range");
                visit(&m, &Mixture::new(m, v, method));
            }
        }),
    },
    ModelEntry {
        name: "patch_mixture",
        source: "(4.20) to (4.24), (4.40)",
        formula: "∫ₘ² p(R)/(π min(1, R²)) dR + p_Diffuse/π, and a mirror of weight p_Mirror",
        parameters: "any density p(R) ≥ 0; weights; a total of at most 1",
        reciprocal: true,
        grazing: "the mixture of the patches'",
        examples: || {
            vec![example(
                "p = 0.375 R(2 − R), p_Mirror = 0.2, p_Diffuse = 0.3",
                PatchMixture::new(|r: f64| 0.375 * r * (2.0 - r), 0.2, 0.3).expect("in range"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "patch_p_norm",
        source: "(4.38)",
        formula: "c where ((B/A |x|)ᵖ + |y|ᵖ)^(1/p) ≤ R",
        parameters: "R above 0 and at most 2; B/A above 0 and at most 1; p 1 … 100",
        reciprocal: true,
        grazing: "f bounded",
        examples: || {
            vec![example(
                "R = 0.5, B/A = 0.7, p = 4",
                PatchPNorm::new(0.5, 0.7, 4.0).expect("in range"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "patch_plastic",
        source: "(4.55)",
        formula: "a_d/π + (1 − a_d) C e^(−s·m) F(θ')",
        parameters: "a_d 0 … 1 of each channel; s 0 … 1e8; index",
        reciprocal: true,
        grazing: "f bounded",
        examples: || {
            vec![example(
                "a_d = 0.5, 0.3, 0.1, s = 30, glass",
                PatchPlastic::new([0.5, 0.3, 0.1], 30.0, index(1.5, 0.0)).expect("in range"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "patch_power",
        source: "(5.12)",
        formula: "(n + 1)(n + 2)/2π ((1 − m)⁺)ⁿ",
        parameters: "n 0 … 1e8",
        reciprocal: true,
        grazing: "f bounded; albedo about ½ at the horizon",
        examples: || {
            vec![example(
                "n = 12",
                PatchPower::new(12.0).expect("in range"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "patch_profile",
        source: "(4.39) to (4.43)",
        formula: "C ξ(m)",
        parameters: "any ξ ≥ 0 on 0 … 2; Euclidean, elliptic or p-norm metric, about R or L",
        reciprocal: true,
        grazing: "f bounded",
        examples: || {
            vec![
                example(
                    "ξ = 1/(1 + 30m²)",
                    PatchProfile::new(|m: f64| 1.0 / (1.0 + 30.0 * m * m), Metric::EUCLIDEAN)
                        .expect("a profile"),
                    Conserves,
                ),
                example(
                    "ξ = 1 + m (increasing)",
                    PatchProfile::new(|m: f64| 1.0 + m, Metric::EUCLIDEAN).expect("a profile"),
                    Conserves,
                ),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "patch_retro",
        source: "(4.29)",
        formula: "1/(π min(1, R²)) where |L_P − V_P| ≤ R",
        parameters: "R above 0 and at most 2",
        reciprocal: true,
        grazing: "as the basic patch's",
        examples: || {
            vec![example(
                "R = 0.5",
                PatchRetro::new(0.5).expect("in range"),
                Conserves,
            )]
        },
        sampler: Some(|v, visit| {
            let m = PatchRetro::new(0.5).expect("in range");
            visit(&m, &PatchDisc::retro(0.5, v, PatchMethod::Rejection));
        }),
    },
    ModelEntry {
        name: "phong",
        source: "(1.33), (3.5), (3.6)",
        formula: "c_n cosⁿα, c_n = (n + 2)/2π",
        parameters: "n 0 … 1e8",
        reciprocal: true,
        grazing: "albedo tends to cosΘ for large n, radiance to 0",
        examples: || {
            vec![example(
                "n = 20",
                Phong::new(20.0).expect("in range"),
                Conserves,
            )]
        },
        sampler: Some(|v, visit| {
            let m = Phong::new(1e8).expect("in range");
            visit(&m, &PhongLobe::new(&m, 1e8, v));
        }),
    },
    ModelEntry {
        name: "phong_original",
        source: "(2.5)",
        formula: "c_n (R·V)ⁿ/cosΘL",
        parameters: "n 0 … 1e8",
        reciprocal: false,
        grazing: "albedo unbounded",
        examples: || {
            vec![example(
                "n = 20",
                PhongOriginal::new(20.0).expect("in range"),
                Exceeds,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "plastic",
        source: "(3.31)",
        formula: "(r, g, b)/π + a_s c_n cosⁿα/cosΘmin",
        parameters: "albedo and specular 0 … 1 with a greatest sum of 1; n 0 … 1e8",
        reciprocal: true,
        grazing: "the highlight keeps its radiance",
        examples: || {
            vec![example(
                "albedo 0.6, 0.3, 0.1, specular 0.3, n = 50",
                Plastic::white_highlight([0.6, 0.3, 0.1], 0.3, 50.0).expect("in range"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "plastic_fresnel",
        source: "(3.30)",
        formula: "a_d/π + a_s c_n cosⁿα/cosΘmin F(Θmin)",
        parameters: "a_d and a_s with a greatest sum of 1; n 0 … 1e8; index",
        reciprocal: true,
        grazing: "the highlight grows with F",
        examples: || {
            vec![example(
                "a_d = 0.3, a_s = 0.7, n = 50, glass",
                PlasticFresnel::new([0.3; 3], 0.7, 50.0, index(1.5, 0.0)).expect("in range"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "polished",
        source: "(4.56), (4.57)",
        formula: "f_base + (1 − a(L)) F(Θ) Δ(V − R)/cosΘ",
        parameters: "any base; index of the polish, or ideal",
        reciprocal: true,
        grazing: "a mirror in the base's missing albedo",
        examples: || {
            vec![example(
                "basic patch R = 1, ideal mirror",
                Polished::new(Patch::new(1.0).expect("in range"), None),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
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
                    Pumped::with_cells(phong, PumpRule::ControlledFloored, 3, 240)
                        .expect("symmetric"),
                    Conserves,
                ),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "retro_phong",
        source: "(3.13)",
        formula: "c_n [(L·V)⁺]ⁿ/cosᵖΘmin",
        parameters: "n 0 … 1e8; p 0 … 1; published or strict energy",
        reciprocal: true,
        grazing: "as the p-model's",
        examples: || {
            vec![example(
                "n = 20, p = 1",
                RetroPhong::new(20.0, 1.0, Energy::Published).expect("in range"),
                Conserves,
            )]
        },
        sampler: Some(|v, visit| {
            let m = RetroPhong::new(20.0, 1.0, Energy::Published).expect("in range");
            visit(&m, &PhongLobe::retro(&m, 20.0, v));
        }),
    },
    ModelEntry {
        name: "sandwich",
        source: "(1.62), (1.63)",
        formula: "C f_base/(2 + k(1/NL + 1/NV))ⁿ",
        parameters: "k 0 … 1000; n 0 … 100; any base; printed or enhanced",
        reciprocal: true,
        grazing: "falls to 0 for k above 0",
        examples: || {
            let base = Lambert::grey(0.8).expect("in range");
            vec![example(
                "k = 0.5, n = 2 over Lambert",
                Sandwich::enhanced(base, 0.5, 2.0).expect("in range"),
                Conserves,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "schlick",
        source: "(1.49), (1.50), Schlick 1994",
        formula: "Z A/(4π (r + (1 − r)NL)(r + (1 − r)NV))",
        parameters: "r above 0 and at most 1; p above 0 and at most 1",
        reciprocal: true,
        grazing: "f bounded, but the albedo exceeds 1 for small r",
        examples: || {
            vec![
                example(
                    "r = 0.1, p = 1",
                    Schlick::new(0.1, 1.0).expect("in range"),
                    Exceeds,
                ),
                example(
                    "r = 0.5, p = 0.6",
                    Schlick::new(0.5, 0.6).expect("in range"),
                    Conserves,
                ),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "tobler_exponential",
        source: "(1.69), (1.70), (1.72)",
        formula: "2s/(π(1 − e^(−2s))) e^(−s(1 − R_S·V_S))",
        parameters: "s 0 … 1e8",
        reciprocal: true,
        grazing: "albedo 1 at every angle; the lobe becomes a ring at the horizon",
        examples: || {
            vec![example(
                "s = 10",
                ToblerExponential::new(10.0).expect("in range"),
                Conserves,
            )]
        },
        sampler: Some(|v, visit| {
            let m = ToblerExponential::new(10.0).expect("in range");
            visit(&m, &ToblerLobe::new(ToblerProfile::Exponential(m), v));
        }),
    },
    ModelEntry {
        name: "tobler_power",
        source: "(1.69) to (1.71)",
        formula: "2(n + 1)/π (R_S·V_S)⁺ⁿ",
        parameters: "n 0 … 1e8",
        reciprocal: true,
        grazing: "albedo 1 at every angle",
        examples: || {
            vec![example(
                "n = 10",
                ToblerPower::new(10.0).expect("in range"),
                Conserves,
            )]
        },
        sampler: Some(|v, visit| {
            let m = ToblerPower::new(10.0).expect("in range");
            visit(&m, &ToblerLobe::new(ToblerProfile::Power(m), v));
        }),
    },
    ModelEntry {
        name: "torrance_sparrow",
        source: "slides, after pbrt",
        formula: "D G F/(4 NL·NV), Blinn's or Ashikhmin's and Shirley's D",
        parameters: "exponents 0 … 1e8; F",
        reciprocal: true,
        grazing: "as Cook–Torrance with V-cavities",
        examples: || {
            vec![
                example(
                    "Blinn, e = 30",
                    TorranceSparrow::blinn(30.0, Facet::White).expect("in range"),
                    Conserves,
                ),
                example(
                    "Ashikhmin–Shirley, 10 and 100",
                    TorranceSparrow::ashikhmin_shirley(10.0, 100.0, Facet::White)
                        .expect("in range"),
                    Conserves,
                ),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "ward",
        source: "(1.46), (2.8), (3.35)",
        formula: "e^(−tan²δ/m²)/(4πm² √(NL·NV))",
        parameters: "m 1e-4 … 10",
        reciprocal: true,
        grazing: "albedo grows as 1/√cosΘ: 1.175 at 89.995°, 3.710 at 89.9995° for m = 0.1",
        examples: || {
            vec![
                example("m = 0.1", Ward::new(0.1).expect("in range"), Exceeds),
                example("m = 0.2", Ward::new(0.2).expect("in range"), Exceeds),
            ]
        },
        sampler: None,
    },
    ModelEntry {
        name: "ward_anisotropic",
        source: "(1.47)",
        formula: "e^(−tan²δ(cos²φ/σx² + sin²φ/σy²))/(4πσxσy √(NL·NV))",
        parameters: "σx, σy 1e-4 … 10",
        reciprocal: true,
        grazing: "as Ward's",
        examples: || {
            vec![example(
                "σ = 0.3, 0.1",
                WardAnisotropic::new(0.3, 0.1).expect("in range"),
                Exceeds,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "ward_convenient",
        source: "(1.48)",
        formula: "a_D/π + a_S e^(−2((Hu/σx)² + (Hv/σy)²)/(1 + NH))/(4πσxσy √(NL·NV))",
        parameters: "a_D + a_S at most 1; σx, σy 1e-4 … 10",
        reciprocal: true,
        grazing: "as Ward's",
        examples: || {
            vec![example(
                "a_D = 0.3, a_S = 0.7, σ = 0.3, 0.1",
                WardConvenient::new(0.3, 0.7, 0.3, 0.1).expect("in range"),
                Exceeds,
            )]
        },
        sampler: None,
    },
    ModelEntry {
        name: "ward_corrected",
        source: "(3.36), Table 3.2",
        formula: "C/(4πσxσy) e^(−tan²δ(…))/max(NL, NV)",
        parameters: "σx, σy 1e-4 … 10",
        reciprocal: true,
        grazing: "radiance bounded; albedo falls",
        examples: || {
            vec![
                example(
                    "m = 0.2",
                    WardCorrected::new(0.2).expect("in range"),
                    Conserves,
                ),
                example(
                    "σ = 0.3, 0.1",
                    WardCorrected::anisotropic(0.3, 0.1).expect("in range"),
                    Conserves,
                ),
            ]
        },
        sampler: None,
    },
];

/// What the texts name without defining it: listed, not invented.
pub const NAMED_ONLY: &[(&str, &str)] = &[
    (
        "He–Torrance in full",
        "its 86 formulas are in X. He and others, *A comprehensive physical model for light \
         reflection* (1991), not in the texts; only its shadowing term (1.38) is here, in `cook_torrance`",
    ),
    (
        "Stam's diffraction model (1.51)",
        "needs the spectral density of a surface, which the text leaves open, and an occlusion factor that it says is missing",
    ),
];

/// The entry of a model's file name.
pub fn find(name: &str) -> Option<&'static ModelEntry> {
    ALL.iter().find(|m| m.name == name)
}
