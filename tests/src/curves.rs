//! Greatest errors of the stored Fresnel curves.

/// A metal's fields, and the greatest error of its curve.
#[derive(Clone, Copy, Debug)]
pub struct CurveBound {
    /// What it is called in documents.
    pub name: &'static str,
    /// The fields of its material.
    pub fields: &'static str,
    /// Greatest error of the reflectance, over every cosine.
    pub error: f64,
}

const fn bound(name: &'static str, fields: &'static str, error: f64) -> CurveBound {
    CurveBound {
        name,
        fields,
        error,
    }
}

/// Half a step of an entry is 1.5e-5 of each.
pub const CURVES: [CurveBound; 6] = [
    bound("gold", "metal = \"gold\"", 9.7e-5),
    bound("silver", "metal = \"silver\"", 3.3e-5),
    bound("copper", "metal = \"copper\"", 8.6e-5),
    bound("aluminium", "metal = \"aluminium\"", 4.5e-5),
    bound(
        "chromium",
        "eta = [3.18, 3.2, 2.3], k = [3.3, 3.3, 3.1]",
        1.25e-4,
    ),
    bound("glass", "eta = [1.5, 1.5, 1.5], k = [0, 0, 0]", 1.4e-4),
];
