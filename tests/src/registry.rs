//! Every model with parameters that reach its ends.

use microbrdf_scene::Material;

use crate::domain::{Pair, Set};

/// A material by its TOML, and what a set of samples needs to know of it.
pub struct Entry {
    /// Name of the model, as in material files, but for a plastic with an index.
    pub model: &'static str,
    /// The table, as one line.
    pub toml: String,
    /// Exponent of a lobe that is about as wide.
    pub n: f64,
}

impl Entry {
    /// The material.
    ///
    /// # Panics
    /// If the table is wrong.
    pub fn material(&self) -> Material {
        Material::from_argument(&self.toml).expect("a material of the registry")
    }

    /// `count` pairs of a set, about where this model's lobe is; τ = n·x
    /// reaches `reach`.
    pub fn pairs(&self, set: Set, reach: f64, count: usize) -> Vec<Pair> {
        let mut pairs = set.pairs(self.n, reach, count);
        if self.model == "retro-phong" {
            // Its lobe is about L, where the others' is about R.
            for [_, v] in &mut pairs {
                *v = [-v[0], -v[1], v[2]];
            }
        }
        pairs
    }
}

/// Exponents that every arithmetic takes.
pub const EXPONENTS: [f64; 12] = [
    0.0, 1.0, 1.5, 2.0, 3.7, 8.0, 20.0, 100.0, 500.0, 5e3, 1e5, 1e8,
];

/// All models at many parameters.
pub fn all() -> Vec<Entry> {
    let mut entries = Vec::new();
    let mut add = |model: &'static str, fields: String, n: f64| {
        entries.push(Entry {
            model: if fields.contains("index = ") {
                "plastic with index"
            } else {
                model
            },
            toml: format!("model = \"{model}\", {fields}"),
            n,
        });
    };
    add("lambert", "albedo = 0.8".into(), 0.5);
    add("lambert", "albedo = [0.9, 0.5, 0.1]".into(), 0.5);
    for n in EXPONENTS {
        add("phong", format!("exponent = {n}"), n);
        add("phong", format!("exponent = {n}, p = 0.5"), n);
        add("metallic-phong", format!("exponent = {n}"), n);
        add("retro-phong", format!("exponent = {n}"), n);
        add(
            "plastic",
            format!("albedo = [0.6, 0.2, 0.1], specular = 0.3, exponent = {n}"),
            n,
        );
    }
    for n in [1.0, 20.0, 500.0, 5e3] {
        add(
            "plastic",
            format!(
                "albedo = [0.6, 0.2, 0.1], specular = [0.3, 0.2, 0.4], exponent = {n}, index = 1.5"
            ),
            n,
        );
    }
    for radius in [1e-4, 0.01, 0.3, 1.0, 1.5, 2.0] {
        add(
            "patch",
            format!("radius = {radius}"),
            1.0 / (radius * radius),
        );
    }
    for s in [0.0f64, 0.05, 0.5, 4.0, 16.0, 128.0, 4096.0] {
        add(
            "patch-exponential",
            format!("sharpness = {s}"),
            (s * s).max(1.0) / 8.0,
        );
    }
    for (points, n) in [
        ("[0, 1], [0.25, 0.375], [1, 0]", 8.0),
        ("[0, 1], [0.01, 0.9], [0.1, 0.1], [2, 0.02]", 40.0),
        ("[0, 1], [0.0009, 0]", 1e6),
    ] {
        add("profile", format!("points = [{points}]"), n);
    }
    for metal in ["gold", "silver", "copper", "aluminium"] {
        for n in [1.0, 20.0, 190.0, 5e3] {
            add("metal", format!("metal = \"{metal}\", exponent = {n}"), n);
        }
    }
    // Chromium-like and glass.
    add(
        "metal",
        "eta = [3.18, 3.2, 2.3], k = [3.3, 3.3, 3.1], exponent = 40".into(),
        40.0,
    );
    add(
        "metal",
        "eta = [1.5, 1.5, 1.5], k = [0, 0, 0], exponent = 40".into(),
        40.0,
    );
    for s in [0.5f64, 4.0, 10.0, 20.0, 60.0] {
        let n = (s * s).max(1.0) / 8.0;
        let gold = format!("sharpness = {s}, metal = \"gold\"");
        add("patch-metal", gold.clone(), n);
        add("metallic-paint", gold, n);
    }
    let chromium = "eta = [3.18, 3.2, 2.3], k = [3.3, 3.3, 3.1]";
    add(
        "metallic-paint",
        format!("sharpness = 12, {chromium}"),
        18.0,
    );
    add(
        "patch-metal",
        format!("radius = 0.3, {chromium}"),
        1.0 / 0.09,
    );
    for (d, clip) in [(0.0, 1.9), (0.25, 1.9), (0.5, 1.0), (1.0, 1.9)] {
        add(
            "generalised-lambert",
            format!("albedo = [0.9, 0.5, 0.1], smoothness = {d}, clip = {clip}"),
            0.5,
        );
    }
    entries
}
