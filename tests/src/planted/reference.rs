//! Bugs of the reference, which its own tests must notice: not by the printed numbers, which
//! are a test of their own.

use super::{Bug, bug};

/// Bugs of the reference.
pub const REFERENCE_BUGS: &[Bug] = &[
    bug(
        "Oren–Nayar brightens forwards",
        "reference/src/models/oren_nayar.rs",
        "    l.x * v.x + l.y * v.y\n",
        "    -(l.x * v.x + l.y * v.y)\n",
        &["lib"],
    )
    .of("reference"),
    bug(
        "a half is missing in the angle of metallic paint",
        "reference/src/models/metallic_paint.rs",
        "0.25 * h2 + 0.5",
        "0.5 * h2 + 0.5",
        &["lib"],
    )
    .of("reference"),
    bug(
        "a half is missing in the lens",
        "reference/src/models/patch.rs",
        "- 0.5 * kite",
        "- kite",
        &["lib"],
    )
    .of("reference"),
    bug(
        "a half is missing in Smith's term",
        "reference/src/models/microfacet/attenuation.rs",
        "let lambda = 0.5 * ((-a * a)",
        "let lambda = ((-a * a)",
        &["lib"],
    )
    .of("reference"),
    bug(
        "generalised Lambert is clipped 0.1 % too far out",
        "reference/src/models/generalised_lambert.rs",
        "greatest: (1.0 - 0.25 * clip * clip)",
        "greatest: (1.0 - 0.25 * 1.001 * clip * clip)",
        &["lib"],
    )
    .of("reference"),
    bug(
        "g1 and g2 swapped",
        "reference/src/models/pumped.rs",
        "            Self::Full => divisor * albedo,\n            Self::Controlled => divisor * albedo.max(floor),",
        "            Self::Controlled => divisor * albedo,\n            Self::Full => divisor * albedo.max(floor),",
        &["lib"],
    )
    .of("reference"),
    bug(
        "the retro lobe points to R",
        "reference/src/geometry.rs",
        "let (x, y, z) = (l.x - v.x, l.y - v.y, l.z - v.z);",
        "let (x, y, z) = (l.x + v.x, l.y + v.y, l.z - v.z);",
        &["lib"],
    )
    .of("reference"),
    bug(
        "Ward without its root",
        "reference/src/models/ward.rs",
        "(l.z * v.z).sqrt())",
        "(l.z * v.z))",
        &["energy"],
    )
    .of("reference"),
    bug(
        "Minnaert sees V alone",
        "reference/src/models/minnaert.rs",
        "(l.z * v.z).powf(self.k)",
        "v.z.powf(self.k)",
        &["reciprocity"],
    )
    .of("reference"),
    bug(
        "the mean albedo without its factor 2",
        "reference/src/albedo.rs",
        "albedo(c).scaled(2.0 * c * slope)",
        "albedo(c).scaled(c * slope)",
        &["lib"],
    )
    .of("reference"),
    bug(
        "a patch's plane is measured without its radius",
        "reference/src/quadrature/chart.rs",
        "measure: t * self.dt,",
        "measure: self.dt,",
        &["lib"],
    )
    .of("reference"),
    bug(
        "(n + 2)/2π in place of (n + 1)/2π in a density",
        "reference/src/sampling/phong_lobe.rs",
        "(self.exponent + 1.0) / TAU",
        "(self.exponent + 2.0) / TAU",
        &["sampling"],
    )
    .of("reference"),
    bug(
        "a density in the plane, not on the sphere",
        "reference/src/sampling/ball.rs",
        "self.brdf.eval(l, &self.v) * l.z.max(0.0) / self.albedo",
        "self.brdf.eval(l, &self.v) / self.albedo",
        &["sampling"],
    )
    .of("reference"),
    bug(
        "an ellipse that is not stretched",
        "reference/src/sampling/ball.rs",
        "return (a * x, b * y);",
        "return (x, y);",
        &["sampling"],
    )
    .of("reference"),
    bug(
        "radii of a profile without its Lambertian part",
        "reference/src/sampling/radii.rs",
        "        if height <= (self.profile)(2.0) {\n            return 2.0;\n        }\n",
        "",
        &["sampling"],
    )
    .of("reference"),
    bug(
        "a mirror's share is taken for Lambert's",
        "reference/src/sampling/radii.rs",
        "        if u < self.mirror {",
        "        if u < self.diffuse {",
        &["sampling"],
    )
    .of("reference"),
];
