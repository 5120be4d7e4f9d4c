//! What the card shows.

/// What runs across a band, as a signed number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Across {
    /// τ = n·x of a cosⁿα lobe, −12 to 12.
    Tau(f64),
    /// s·m of an exponential mixture, −12 to 12.
    Sharpness(f64),
    /// m/R of a basic patch, −2 to 2.
    Radius(f64),
}

impl Across {
    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Tau(_) => "τ = n(1 − cos α)",
            Self::Sharpness(_) => "s·m",
            Self::Radius(_) => "m/R",
        }
    }

    /// Its greatest value.
    #[must_use]
    pub fn reach(self) -> f64 {
        match self {
            Self::Tau(_) | Self::Sharpness(_) => 12.0,
            Self::Radius(_) => 2.0,
        }
    }
}

/// A material and what runs across its pictures.
#[derive(Clone, Copy, Debug)]
pub struct Band {
    /// What it is called.
    pub label: &'static str,
    /// The material.
    pub material: &'static str,
    /// What runs across.
    pub across: Across,
}

const fn band(label: &'static str, material: &'static str, across: Across) -> Band {
    Band {
        label,
        material,
        across,
    }
}

/// From above to below.
pub const BANDS: [Band; 14] = [
    band(
        "metallic Phong, n = 1",
        "model = \"metallic-phong\", exponent = 1",
        Across::Tau(1.0),
    ),
    band(
        "metallic Phong, n = 2",
        "model = \"metallic-phong\", exponent = 2",
        Across::Tau(2.0),
    ),
    band(
        "metallic Phong, n = 20",
        "model = \"metallic-phong\", exponent = 20",
        Across::Tau(20.0),
    ),
    band(
        "metallic Phong, n = 500",
        "model = \"metallic-phong\", exponent = 500",
        Across::Tau(500.0),
    ),
    band(
        "metallic Phong, n = 5000",
        "model = \"metallic-phong\", exponent = 5000",
        Across::Tau(5e3),
    ),
    band(
        "metallic Phong, n = 1e5",
        "model = \"metallic-phong\", exponent = 1e5",
        Across::Tau(1e5),
    ),
    band(
        "metallic Phong, n = 1e8",
        "model = \"metallic-phong\", exponent = 1e8",
        Across::Tau(1e8),
    ),
    band(
        "gold, n = 20",
        "model = \"metal\", metal = \"gold\", exponent = 20",
        Across::Tau(20.0),
    ),
    band(
        "patch, R = 1e-4",
        "model = \"patch\", radius = 1e-4",
        Across::Radius(1e-4),
    ),
    band(
        "patch, R = 0.01",
        "model = \"patch\", radius = 0.01",
        Across::Radius(0.01),
    ),
    band(
        "patch, R = 0.5",
        "model = \"patch\", radius = 0.5",
        Across::Radius(0.5),
    ),
    band(
        "mixture, s = 4",
        "model = \"patch-exponential\", sharpness = 4",
        Across::Sharpness(4.0),
    ),
    band(
        "mixture, s = 128",
        "model = \"patch-exponential\", sharpness = 128",
        Across::Sharpness(128.0),
    ),
    band(
        "mixture, s = 4096",
        "model = \"patch-exponential\", sharpness = 4096",
        Across::Sharpness(4096.0),
    ),
];
