//! Bugs that are planted to see the tests fail.

mod reference;
mod scenes;

pub use reference::REFERENCE_BUGS;
pub use scenes::SCENE_BUGS;

/// One change of the source, and the files of tests that must notice it.
#[derive(Clone, Copy, Debug)]
pub struct Bug {
    /// What is wrong.
    pub name: &'static str,
    /// The file, from the project's folder.
    pub file: &'static str,
    /// What stands there, once.
    pub from: &'static str,
    /// What is put in its place.
    pub to: &'static str,
    /// The folder of the package whose tests must notice.
    pub package: &'static str,
    /// Files of its `tests/`, each of which has a test that fails; `lib` for unit tests.
    pub tests: &'static [&'static str],
}

impl Bug {
    /// The same, to be noticed by another package's own tests.
    const fn of(self, package: &'static str) -> Self {
        Self { package, ..self }
    }
}

/// The bugs of all packages.
pub fn all() -> impl Iterator<Item = &'static Bug> {
    BUGS.iter().chain(SCENE_BUGS).chain(REFERENCE_BUGS)
}

const fn bug(
    name: &'static str,
    file: &'static str,
    from: &'static str,
    to: &'static str,
    tests: &'static [&'static str],
) -> Bug {
    Bug {
        name,
        file,
        from,
        to,
        package: "tests",
        tests,
    }
}

const STEPS: &str = "core/src/arithmetic/mod.rs";
const F32: &str = "core/src/arithmetic/f32.rs";
const Q31: &str = "core/src/arithmetic/q31.rs";
const SHORT: &str = "core/src/arithmetic/short.rs";
const METAL: &str = "core/src/brdf/metal.rs";
const PHONG: &str = "core/src/brdf/phong.rs";
const FRAME: &str = "core/src/geometry/shading_frame.rs";
const WORLD: &str = "core/src/geometry/world.rs";
const EXPOSURE: &str = "core/src/table/exposure.rs";
const UNIFORM: &str = "core/src/table/uniform.rs";
const CURVE: &str = "core/src/table/cosine_curve.rs";

/// Bugs of the core.
pub const BUGS: &[Bug] = &[
    bug(
        "cosΘmin is the smaller cosine",
        STEPS,
        "if n_dot_l >= n_dot_v { n_dot_l } else { n_dot_v }",
        "if n_dot_l >= n_dot_v { n_dot_v } else { n_dot_l }",
        &["values"],
    ),
    bug(
        "the lobe points to L, not to R",
        PHONG,
        "        geometry.versine()\n",
        "        geometry.retro_versine()\n",
        &["values"],
    ),
    bug(
        "the retro lobe points to R, not to L",
        PHONG,
        "        geometry.retro_versine()\n",
        "        geometry.versine()\n",
        &["values"],
    ),
    bug(
        "Fresnel's factor at the larger angle",
        METAL,
        "A::larger(n_dot_l, n_dot_v)",
        "if n_dot_l >= n_dot_v { n_dot_v } else { n_dot_l }",
        &["values"],
    ),
    bug(
        "red and blue swapped in a Fresnel curve",
        Q31,
        "Rgb::from_array(curve.at(cosine.to_bits())).map(U1F31::from_bits)",
        "{ let [r, g, b] = curve.at(cosine.to_bits()); Rgb { r: b, g, b: r } }.map(U1F31::from_bits)",
        &["values"],
    ),
    bug(
        "green and blue swapped in an albedo",
        "core/src/brdf/lambert.rs",
        "self.albedo.map(|albedo| A::product(share, albedo))",
        "Rgb { r: self.albedo.r, g: self.albedo.b, b: self.albedo.g }.map(|albedo| A::product(share, albedo))",
        &["values"],
    ),
    bug(
        "red and blue swapped in the pixel",
        "core/src/shade/linear.rs",
        "            r: clamp(r),\n            g: clamp(g),\n            b: clamp(b),",
        "            r: clamp(b),\n            g: clamp(g),\n            b: clamp(r),",
        &["values"],
    ),
    bug(
        "a table is read one cell too far",
        UNIFORM,
        "let cell = (position >> FRACTION_BITS) as usize;",
        "let cell = (position >> FRACTION_BITS) as usize + 1;",
        &["tables"],
    ),
    bug(
        "a Fresnel curve is read one knot too far",
        CURVE,
        "let cell = cell as usize;",
        "let cell = cell as usize + 1;",
        &["tables"],
    ),
    bug(
        "a power of a cosine is read one octave too far",
        "core/src/table/cosine_power.rs",
        "self.octaves.get(octave as usize)",
        "self.octaves.get(octave as usize + 1)",
        &["tables"],
    ),
    bug(
        "x = (Lx − Vx)² + …",
        FRAME,
        "            A::sum(l.x, v.x),\n            A::sum(l.y, v.y),\n            A::difference",
        "            A::difference(l.x, v.x),\n            A::sum(l.y, v.y),\n            A::difference",
        &["values"],
    ),
    bug(
        "x = … + (Lz + Vz)²",
        FRAME,
        "A::difference(l.z, v.z)",
        "A::sum(l.z, v.z)",
        &["values"],
    ),
    bug(
        "the height is left out of x in world space",
        WORLD,
        "            A::height(self.cosines.0, self.cosines.1),\n",
        "",
        &["frames"],
    ),
    bug(
        "h = L + V + (N·h)N",
        F32,
        "(l + v) - (cosines.0 + cosines.1) * n",
        "(l + v) + (cosines.0 + cosines.1) * n",
        &["frames"],
    ),
    bug(
        "the lobe goes on beyond a right angle",
        F32,
        "if x < 1.0 {",
        "if x < 1.5 {",
        &["corners"],
    ),
    bug(
        "1 − x is formed",
        F32,
        "M::exp(n * M::ln_one_minus(x))",
        "libm::powf(1.0 - x, *n)",
        &["accuracy"],
    ),
    bug(
        "e^(−n·x) for (1 − x)ⁿ",
        F32,
        "M::exp(n * M::ln_one_minus(x))",
        "M::exp(-n * x)",
        &["values"],
    ),
    bug(
        "a cosine above 1 is not clamped (q31)",
        Q31,
        "cosine.to_bits().clamp(0, 1 << COMPONENT_BITS)",
        "cosine.to_bits().max(0)",
        &["corners"],
    ),
    bug(
        "a cosine above 1 is not clamped (f32)",
        F32,
        "share * cosine.min(1.0)",
        "share * cosine",
        &["corners"],
    ),
    bug(
        "exposed light wraps around",
        Q31,
        "        if light > u64::from(u32::MAX) {\n            u32::MAX\n        } else {\n            light as u32\n        }",
        "        light as u32",
        &["corners"],
    ),
    bug(
        "light above 1 is not clamped in the pixel",
        "core/src/shade/linear.rs",
        "    if component < LINEAR_ONE {\n        component\n    } else {\n        LINEAR_ONE\n    }",
        "    component",
        &["corners"],
    ),
    bug(
        "a product of shares is rounded down",
        Q31,
        "(product + (1 << (UNIT_BITS - 1))) >> UNIT_BITS",
        "product >> UNIT_BITS",
        &["rounding"],
    ),
    bug(
        "a dot product is rounded down",
        Q31,
        "sum.wrapping_add(1 << (COMPONENT_BITS - 1)) >> COMPONENT_BITS",
        "sum >> COMPONENT_BITS",
        &["rounding"],
    ),
    bug(
        "a table's entry is rounded down",
        "core/src/table/integer.rs",
        "((value + (1 << (drop - 1))) >> drop) as u32",
        "(value >> drop) as u32",
        &["rounding"],
    ),
    bug(
        "linear light is rounded down",
        F32,
        "(light * LINEAR_ONE as f32 + 0.5) as u32",
        "(light * LINEAR_ONE as f32) as u32",
        &["rounding"],
    ),
    bug(
        "an sRGB threshold is a step too high",
        "core/src/shade/srgb.rs",
        "round_to(linear + step / 2 - 1, LINEAR_BITS)",
        "round_to(linear + step + step / 2, LINEAR_BITS)",
        &["srgb"],
    ),
    bug(
        "chords are not centred",
        UNIFORM,
        "value.saturating_sub((sag_before + sag) / 4)",
        "value",
        &["tables"],
    ),
    bug(
        "c = (n + 1)/2π",
        PHONG,
        "(n + (2 << 32)) as u128",
        "(n + (1 << 32)) as u128",
        &["physics"],
    ),
    bug(
        "C(s) without its series",
        "core/src/brdf/patch_exponential.rs",
        "divide(ONE * (k as u128 + 1), factorial)",
        "divide(ONE, factorial)",
        &["physics"],
    ),
    bug(
        "a wide patch's peak goes on falling",
        "core/src/brdf/patch.rs",
        "let divisor = if square < 1 << 60 { square } else { 1 << 60 };",
        "let divisor = square;",
        &["values"],
    ),
    bug(
        "R = 2 is compared",
        "core/src/brdf/patch.rs",
        "let radius_squared = if radius == 2.0 { f32::MAX } else { square };",
        "let radius_squared = if radius == 2.0 { 3.9 } else { square };",
        &["physics"],
    ),
    bug(
        "the ratio upside down",
        "core/src/brdf/foreshortening.rs",
        "match A::ratio(n_dot_l, n_dot_v) {",
        "match A::ratio(n_dot_v, n_dot_l) {",
        &["values"],
    ),
    bug(
        "below the horizon there is light",
        Q31,
        "n_dot_l > I2F30::ZERO && n_dot_v >= I2F30::ZERO",
        "n_dot_l > I2F30::ZERO || n_dot_v >= I2F30::ZERO",
        &["physics"],
    ),
    bug(
        "p in place of 1 − p",
        "core/src/brdf/foreshortening.rs",
        "Ok(Self { rest: 1.0 - p })",
        "Ok(Self { rest: p })",
        &["values"],
    ),
    bug(
        "L and V enter a sum differently",
        F32,
        "(l + v) - (cosines.0 + cosines.1) * n",
        "l - (cosines.0 + cosines.1) * n + v",
        &["physics"],
    ),
    bug(
        "a sphere is seen from inside",
        "core/src/shade/tracing_q31.rs",
        "(nearest << (DIRECTION - NEAR)).wrapping_sub(back as i32)",
        "(nearest << (DIRECTION - NEAR)).wrapping_add(back as i32)",
        &["picture"],
    ),
    bug(
        "rows from the bottom",
        "core/src/shade/camera.rs",
        "i32::from(self.height) - 1 - 2 * y",
        "2 * y + 1 - i32::from(self.height)",
        &["picture"],
    ),
    bug(
        "a lobe is drawn as for n + 1",
        "core/src/sampling/phong.rs",
        "concentration: 1.0 / (n + 1.0)",
        "concentration: 1.0 / (n + 2.0)",
        &["sampling"],
    ),
    bug(
        "a mixture's far points lie on the wrong side",
        "core/src/sampling/patch_exponential.rs",
        "A::mirrored(&A::raised(offset))",
        "A::raised(offset)",
        &["sampling"],
    ),
    bug(
        "a sample below the horizon is kept",
        "core/src/sampling/phong.rs",
        "A::above_horizon(l.cosine(), v.cosine()).then_some(l)",
        "Some(l)",
        &["sampling"],
    ),
    bug(
        "a sample's Fresnel factor is V's",
        "core/src/sampling/metal.rs",
        "A::larger(direction.cosine(), v.cosine())",
        "v.cosine()",
        &["sampling"],
    ),
    bug(
        "a scaled table is read one cell too far",
        "core/src/table/scaled.rs",
        "let cell = (position >> (32 - Self::CELL_BITS)) as usize;",
        "let cell = (position >> (32 - Self::CELL_BITS)) as usize + 1;",
        &["values"],
    ),
    bug(
        "a scaled table is read where it ends",
        "core/src/table/scaled.rs",
        "if coordinate > self.limit {",
        "if coordinate == u32::MAX {",
        &["values"],
    ),
    bug(
        "a ratio of cosines just below 1 wraps around",
        "core/src/table/reciprocal.rs",
        "/ (c * c * c) + 4;",
        "/ (c * c * c);",
        &["lib"],
    )
    .of("core"),
    bug(
        "a quotient of two cosines is cut to 16 bits",
        "core/src/table/reciprocal.rs",
        "            dividend: a,\n",
        "            dividend: a & !0xFFFF,\n",
        &["accuracy"],
    ),
    bug(
        "a cosine is cut to 15 bits (q15)",
        "core/src/arithmetic/q15.rs",
        "product_down::<30>(share.to_bits(), cosine as u32)",
        "product_down::<30>(share.to_bits(), cosine as u32 & !0x7FFF)",
        &["accuracy"],
    ),
    bug(
        "a quotient of one look-up takes the next divisor's cell",
        "core/src/table/reciprocal.rs",
        "let cell = (b >> (31 - DIRECT_BITS)) as usize % DIRECT.len();",
        "let cell = ((b >> (31 - DIRECT_BITS)) as usize + 1) % DIRECT.len();",
        &["lib"],
    )
    .of("core"),
    bug(
        "1 − R·V does not make good that N is rounded",
        "core/src/geometry/short_world.rs",
        "let scaled = square.wrapping_add(((square >> 16) * excess) >> 12);",
        "let _ = excess; let scaled = square;",
        &["lib"],
    )
    .of("core"),
    bug(
        "a cell without interpolation has the curve at its beginning",
        "core/src/table/direct.rs",
        "let middle = ((2 * cell as u64 + 1) << width) / 2;",
        "let middle = ((2 * cell as u64) << width) / 2;",
        &["direct"],
    ),
    bug(
        "exposed light wraps around (q15)",
        "core/src/arithmetic/q15.rs",
        "if product > gain.limit {",
        "if product == u32::MAX {",
        &["corners"],
    ),
    bug(
        "a product loses its lower half (q15)",
        SHORT,
        "u64::from(share) * u64::from(factor << 16)",
        "u64::from(share & FACTOR) * u64::from(factor << 16)",
        &["accuracy"],
    ),
    bug(
        "a product of halves loses its lower one",
        SHORT,
        "(share >> 16) * factor + (((share & 0xFFFF) * factor) >> 16)",
        "(share >> 16) * factor",
        &["lib"],
    )
    .of("core"),
    bug(
        "zeros are counted from the second byte on",
        SHORT,
        "        8 + zeros(number >> 16)",
        "        zeros(number >> 16)",
        &["lib"],
    )
    .of("core"),
    bug(
        "a bright light is not limited before the product (exposed)",
        EXPOSURE,
        "let share = share.min(self.limit);",
        "let share = share.min(1 << 31);",
        &["exposed"],
    ),
    bug(
        "a factor is cut off, not rounded (exposed)",
        EXPOSURE,
        "(word as u32 + HALF) as i32",
        "word as i32",
        &["exposed"],
    ),
    bug(
        "light of 16 bits wraps around (exposed)",
        EXPOSURE,
        "(light as u32).min(0xFFFF) as u16",
        "light as u16",
        &["exposed"],
    ),
    bug(
        "a cell's line starts where the next one does (exposed)",
        "core/src/table/exposed_curve.rs",
        "slope.wrapping_mul((cell as i32) << POSITION_BITS)",
        "slope.wrapping_mul((cell as i32 + 1) << POSITION_BITS)",
        &["exposed"],
    ),
    bug(
        "a disc is lit from below the horizon (exposed)",
        "core/src/brdf/exposed_patch.rs",
        "if !Q15::<KNOTS>::lit(n_dot_l, n_dot_v) {",
        "if n_dot_l < 0 {",
        &["exposed"],
    ),
];
