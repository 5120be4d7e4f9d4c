//! Bugs of what only scenes have: the materials that came last, meshes,
//! shadows, samples, and where spheres are looked for.

use super::{Bug, bug};

/// Bugs of the core and of the scenes.
pub const SCENE_BUGS: &[Bug] = &[
    bug(
        "metallic paint takes Fresnel's factor at Θmin",
        "core/src/brdf/tinted.rs",
        "A::cos_theta_prime(geometry.separation(), geometry.cosines())",
        "A::larger(geometry.cosines().0, geometry.cosines().1)",
        &["scenes"],
    ),
    bug(
        "a metal of patches takes Fresnel's factor at V",
        "core/src/brdf/tinted.rs",
        "        A::larger(n_dot_l, n_dot_v)\n",
        "        core::cmp::PartialOrd::partial_cmp(&n_dot_l, &n_dot_v).map_or(n_dot_l, |_| n_dot_v)\n",
        &["scenes"],
    ),
    bug(
        "generalised Lambert has no colour",
        "core/src/brdf/generalised_lambert.rs",
        "self.body.coloured(share, geometry)",
        "{ let _ = geometry; Rgb::grey(share) }",
        // A scene has colours in its gains.
        &["golden"],
    )
    .of("core"),
    bug(
        "eight pixels: one seen from behind is lit beside another",
        "scene/src/wide/geometry.rs",
        "lit(n_dot_l, n_dot_v).or_zero(n_dot_l)",
        "{ let _ = lit; n_dot_l }",
        &["lib"],
    )
    .of("scene"),
    bug(
        "eight pixels: the last shape is taken, not the nearest",
        "scene/src/wide/scene.rs",
        "first.or(depths.below(self.depths))",
        "first.or(depths.numbers())",
        &["wide"],
    ),
    bug(
        "eight pixels: a lobe ends where it still shows",
        "scene/src/wide/arithmetic.rs",
        "const END: f32 = 105.0;",
        "const END: f32 = 5.0;",
        &["wide"],
    ),
    bug(
        "a highlight's row goes the other way across",
        "core/src/shade/highlight/rows.rs",
        "[p * x + q * y, p * y - q * x]",
        "[p * x + q * y, p * y + q * x]",
        &["highlight"],
    ),
    bug(
        "a sphere's edge is no wider where light ends steeply",
        "core/src/shade/highlight/edge.rs",
        "greater(product(z, z), ",
        "greater(0, ",
        &["highlight"],
    ),
    bug(
        "steps of a ratio are not finer where it is small",
        "core/src/shade/highlight/edge.rs",
        "            x = colours.halved(x);\n",
        "",
        &["highlight"],
    ),
    bug(
        "a light from behind has no more pixels at the edge",
        "core/src/shade/highlight/edge.rs",
        "if level > BRIGHT {",
        "if level > BRIGHT + 64 {",
        &["highlight"],
    ),
    bug(
        "a ratio moves x as if the lobe had not fallen",
        "core/src/shade/highlight/lobe_colours.rs",
        "(x as u32 >> X_DROP).wrapping_mul(self.rho());",
        "x as u32;",
        &["highlight"],
    ),
    bug(
        "a lobe of exponent 0 falls off as that of 1 does",
        "core/src/shade/highlight/lobe_colours.rs",
        "x >> SUM_BITS << SUM_BITS",
        "x",
        &["highlight"],
    ),
    bug(
        "a highlight's steps of z² end before the lobe does",
        "core/src/shade/highlight/lit_sphere.rs",
        "if above >> step_bits < STEPS as i64",
        "if above >> step_bits < 2 * STEPS as i64",
        &["highlight"],
    ),
    bug(
        "from the end of a highlight's row z² goes forwards",
        "core/src/shade/highlight/walk.rs",
        "self.square = self.square.wrapping_sub(step.square);",
        "self.square = self.square.wrapping_add(step.square);",
        &["highlight"],
    ),
    bug(
        "a word's slope is not taken off its offset",
        "core/src/shade/highlight/word.rs",
        "let upper = (offset - lower + (1 << (WAY_BITS - 1))) >> WAY_BITS;",
        "let upper = (offset + (1 << (WAY_BITS - 1))) >> WAY_BITS;",
        &["lib"],
    )
    .of("core"),
    bug(
        "a ceramic's glaze is a lobe's",
        "scene/src/prepare.rs",
        "                    Some(index) => Self::Metal {\n                        exponent: *exponent,",
        "                    Some(index) => Self::Metal {\n                        exponent: 2.0 * *exponent,",
        &["scenes"],
    ),
    bug(
        "a normal's fold goes the wrong way",
        "core/src/shade/octahedral.rs",
        "if c < 0 { c - fold } else { c + fold }",
        "if c < 0 { c + fold } else { c - fold }",
        &["mesh"],
    ),
    bug(
        "a span of a mesh begins one normal late",
        "core/src/shade/view.rs",
        "(first as usize).wrapping_add(x - usize::from(start))",
        "(first as usize).wrapping_add(1 + x - usize::from(start))",
        &["mesh"],
    ),
    bug(
        "a lamp's shadow is that of a light at infinity",
        "core/src/shade/placing_q31.rs",
        "Some(to) => ahead.wrapping_sub(along(to.map(|c| c >> shift))).max(0),",
        "Some(_) => 0,",
        &["shadows"],
    ),
    bug(
        "spheres throw shadows of twice their size",
        "core/src/shade/placing_q31.rs",
        "square < (radius.wrapping_mul(radius)) as u64",
        "square < 4 * (radius.wrapping_mul(radius)) as u64",
        &["shadows"],
    ),
    bug(
        "a ray of four is counted twice",
        "core/src/shade/samples.rs",
        "[[1, 0], [3, 1], [0, 2], [2, 3]]",
        "[[1, 0], [3, 1], [0, 2], [1, 0]]",
        &["shadows"],
    ),
    bug(
        "spheres are looked for a pixel too narrowly",
        "scene/src/extent.rs",
        "const MARGIN: f64 = 1.0;",
        "const MARGIN: f64 = -0.6;",
        &["extents"],
    ),
    bug(
        "rows are counted upwards where spheres are looked for",
        "scene/src/extent.rs",
        "rows: along(up.map(|c| -c), camera.height),",
        "rows: along(up, camera.height),",
        &["extents"],
    ),
];
