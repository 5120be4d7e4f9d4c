//! Shadows and several rays a pixel: against the reference, and what they do.

use microbrdf::arithmetic::{F32, Q15, Q31};
use microbrdf::geometry::Direction;
use microbrdf::shade::{Camera, Extent, Sphere};
use microbrdf_scene::vector::{cross, length, scaled};
use microbrdf_scene::{Description, HostArithmetic};
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_tests::baked::{MESH, SHADOWS, description};
use microbrdf_tests::pictures::{Case, faults};
use rand_core::{RngCore as _, SeedableRng as _};
use rand_pcg::Pcg64Mcg;

const ARITHMETICS: [ArithmeticName; 3] = [
    ArithmeticName::F32,
    ArithmeticName::Q31,
    ArithmeticName::Q15,
];

fn with(text: &str, part: &str, other: &str) -> String {
    assert_eq!(text.matches(part).count(), 1, "{part}");
    text.replace(part, other)
}

fn holds(case: &Case) {
    assert!(case.exempt() <= 40, "{} pixels are exempt", case.exempt());
    for arithmetic in ARITHMETICS {
        let found = case.measured(arithmetic);
        println!("{}: {found:?}", arithmetic.name());
        assert!(
            faults(&found).is_empty(),
            "{}: {:?}: {found:?}",
            arithmetic.name(),
            faults(&found)
        );
    }
}

#[test]
fn shadows_with_four_rays_are_the_references() {
    holds(&Case::of(SHADOWS));
}

#[test]
fn shadows_with_one_ray_are_the_references() {
    holds(&Case::of(&with(SHADOWS, "samples = 4", "samples = 1")));
}

#[test]
fn spheres_throw_shadows_on_a_mesh() {
    let low = with(MESH, "[-0.5, -0.7, 0.9]", "[0.1, -0.9, 0.15]");
    let shadowed = format!("shadows = true\n{low}");
    let case = Case::new(description("mesh", &shadowed));
    holds(&case);
    let without = Case::new(description("mesh", &low)).exact.srgb().pixels;
    let changed = case.exact.srgb().pixels;
    let on_mesh = case.description.view.as_ref().unwrap();
    let pixels = (0..changed.len())
        .filter(|i| on_mesh.at(i % 64, i / 64).is_some() && changed[*i] != without[*i])
        .count();
    // That the shadow is right is held above; here, that there is one.
    assert!(pixels > 0, "no pixel of the mesh lies in shadow");
}

/// Of each light something is kept, and nothing but light is taken away.
#[test]
fn each_light_throws_shadows() {
    let one = with(SHADOWS, "samples = 4", "samples = 1");
    let without = with(&one, "shadows = true", "shadows = false");
    for kept in ["[2.0, 1.9, 1.7]", "[6.0, 5.0, 4.0]", "[9.0, 12.0, 20.0]"] {
        let mut pair = [one.clone(), without.clone()];
        for other in ["[2.0, 1.9, 1.7]", "[6.0, 5.0, 4.0]", "[9.0, 12.0, 20.0]"] {
            if other != kept {
                pair = pair.map(|text| with(&text, other, "0"));
            }
        }
        let [dark, light] = pair.map(|text| Case::of(&text).exact.pixels);
        let darker = dark
            .iter()
            .zip(&light)
            .filter(|(dark, light)| dark.linear[1] < light.linear[1] - 0.01)
            .count();
        assert!(darker > 40, "{kept}: {darker} pixels");
        assert!(
            dark.iter()
                .zip(&light)
                .all(|(dark, light)| dark.linear[1] <= light.linear[1])
        );
    }
}

/// A light below the floor reaches nothing that is seen; without shadows it
/// does.
#[test]
fn a_light_behind_a_plane_reaches_nothing() {
    let one = with(SHADOWS, "samples = 4", "samples = 1");
    for below in [
        "kind = \"directional\"\ndirection = [-0.2, -0.7, -0.4]\ncolor = 3",
        "kind = \"point\"\nposition = [0.5, -3, -2]\nintensity = 30",
        "kind = \"flood\"\nposition = [0.5, -3, -2]\naxis = [0, 1, 1]\nexponent = 2\nintensity = 30",
    ] {
        let more = format!("{one}\n[[light]]\n{below}\n");
        for arithmetic in ARITHMETICS {
            let picture = |text: &str| Case::of(text).picture(arithmetic).pixels;
            assert!(picture(&more) == picture(&one), "{below}");
        }
        holds(&Case::of(&more));
        let lit = with(&more, "shadows = true", "shadows = false");
        let unlit = with(&one, "shadows = true", "shadows = false");
        assert!(Case::of(&lit).exact.srgb().pixels != Case::of(&unlit).exact.srgb().pixels);
    }
}

/// Where a shadow's edge is: rays of light that pass a sphere's rim by ever
/// less are judged alike by the core and by f64, up to the displacement that
/// is stated.
struct Edges(Pcg64Mcg);

impl Edges {
    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn unit(&mut self) -> [f64; 3] {
        let z = self.uniform(-1.0, 1.0);
        let angle = self.uniform(0.0, std::f64::consts::TAU);
        let r = (1.0 - z * z).sqrt();
        [r * angle.cos(), r * angle.sin(), z]
    }
}

fn added(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Greatest misjudged distance from an edge, in what is stated: `per_unit` of
/// the distance from the sphere, and `per_scene` of the greatest distance from
/// the eye, the sphere's radius and 1.
fn worst<A: HostArithmetic>(per_unit: f64, per_scene: f64) -> f64 {
    let mut random = Edges(Pcg64Mcg::seed_from_u64(5));
    let direction = |v: [f64; 3]| {
        let [x, y, z] = v.map(A::component);
        Direction::<A>::new(x, y, z)
    };
    let (mut worst, mut count) = (0.0f64, 0);
    while count < 60_000 {
        let radius = random.uniform(0.05f64.ln(), 20f64.ln()).exp();
        let depth = random.uniform(0.3, 120.0);
        let far = random.uniform(1.0, 120.0);
        let sight = random.unit();
        let place = scaled(sight, depth);
        let center = scaled(random.unit(), far);
        let to = added(center, scaled(place, -1.0));
        let distance = length(to);
        if far < 1.01 * radius || far / radius > 126.0 || distance < 1.01 * radius {
            continue;
        }
        let stated = per_unit * distance + per_scene * depth.max(far).max(radius).max(1.0);
        let side = if random.uniform(-1.0, 1.0) < 0.0 {
            -1.0
        } else {
            1.0
        };
        let margin = side * stated * 10f64.powf(random.uniform(-2.5, 1.0));
        let sine = (radius + margin) / distance;
        if !(0.0..1.0).contains(&sine) {
            continue;
        }
        count += 1;
        let ahead = scaled(to, 1.0 / distance);
        let across = cross(ahead, random.unit());
        let across = scaled(across, 1.0 / length(across));
        let l = added(
            scaled(ahead, (1.0 - sine * sine).sqrt()),
            scaled(across, sine),
        );
        let camera = Camera::<A> {
            width: 1,
            height: 1,
            forward: sight.map(A::fine),
            right: [A::fine(0.0); 3],
            up: [A::fine(0.0); 3],
        };
        let depth = A::stored_depth(A::length(depth), A::length(0.0), 0);
        let from = A::place(&A::ray(&camera, 0, 0), depth);
        let sphere = Sphere::<A> {
            eye: center.map(|c| A::length(-c / radius)),
            radius: A::length(radius),
            material: 0,
            extent: Extent::EVERYWHERE,
        };
        let l16 = direction(l);
        if A::hides(&sphere, &from, &l16, None) != (margin < 0.0) {
            worst = worst.max(margin.abs() / stated);
        }
        // A lamp well before the sphere, well behind it, and within.
        for (along, hidden) in [
            (distance - 1.1 * radius, false),
            (distance + 1.1 * radius, margin < -2.0 * stated),
        ] {
            let lamp = added(place, scaled(l, along));
            if along < 0.1 || lamp.iter().any(|c| c.abs() > 126.0) || margin.abs() < 2.0 * stated {
                continue;
            }
            let found = A::hides(&sphere, &from, &l16, Some(&lamp.map(A::length)));
            assert_eq!(found, hidden, "{} at {along}", std::any::type_name::<A>());
        }
        if center.iter().all(|c| c.abs() < 100.0) {
            let within = added(center, scaled(random.unit(), 0.9 * radius));
            let to = added(within, scaled(place, -1.0));
            let towards = direction(scaled(to, 1.0 / length(to)));
            assert!(A::hides(
                &sphere,
                &from,
                &towards,
                Some(&within.map(A::length))
            ));
        }
        // What is behind the place hides nothing.
        assert!(!A::hides(&sphere, &from, &direction(scaled(l, -1.0)), None));
    }
    worst
}

#[test]
fn edges_are_where_they_are_stated_to_be() {
    // 16 bits turn a light by 6e-5 at most.
    for (name, found) in [
        ("f32", worst::<F32>(0.0, 5e-7)),
        ("q31", worst::<Q31>(0.0, 1.5e-7)),
        ("q15", worst::<Q15>(6e-5, 1.5e-7)),
    ] {
        println!("{name}: {found}");
        assert!((0.2..=1.0).contains(&found), "{name}: {found}");
    }
}

/// A white disc before black: a pixel shows as many quarters as its rays meet.
#[test]
fn four_rays_give_four_steps() {
    let text = "samples = 4\n[camera]\nwidth = 64\nheight = 64\neye = [0, -9, 0]\n\
                target = [0, 0, 0]\nfov = 20\n[daylight]\ncolor = 5\n[[sphere]]\n\
                center = [0, 0, 0]\nradius = 1\nmaterial = \"white\"\n[material.white]\n\
                model = \"lambert\"\nalbedo = 1\n";
    let scene = Description::from_toml("scene", "scene", text).unwrap();
    for arithmetic in ARITHMETICS {
        let frame = microbrdf_sim::render::frame(&scene, arithmetic).unwrap();
        let mut seen = [0usize; 5];
        for pixel in &frame.pixels {
            let [r, g, b] = pixel.to_raw();
            assert!(r == g && g == b && r % (1 << 22) == 0, "{r}");
            seen[(r >> 22) as usize] += 1;
        }
        assert!(seen.iter().all(|count| *count > 5), "{seen:?}");
        // A disc of 1/√80 of tan 10° of half the picture: its area by quarters.
        let covered = (1..5).map(|i| i * seen[i]).sum::<usize>() as f64 / 4.0;
        let exact =
            std::f64::consts::PI * (32.0 / (80f64.sqrt() * 10f64.to_radians().tan())).powi(2);
        assert!(
            (covered / exact - 1.0).abs() < 2e-3,
            "{covered} for {exact}"
        );
    }
}

#[test]
fn mistakes_are_named() {
    for (part, wrong, message) in [
        (
            "samples = 4",
            "samples = 2",
            "scene:3:11: samples = 2: must be 1 or 4",
        ),
        ("samples = 4", "samples = 0", "must be 1 or 4"),
        ("samples = 4", "samples = -4", "must be 1 or 4"),
        ("samples = 4", "samples = 4.5", "must be 1 or 4"),
        ("samples = 4", "samples = nan", "must be 1 or 4"),
        ("samples = 4", "samples = \"4\"", "must be 1 or 4"),
        (
            "samples = 4",
            "samples = 99999999999999999999",
            "must be 1 or 4",
        ),
        (
            "shadows = true",
            "shadows = 1",
            "scene:2:11: shadows = 1: must be",
        ),
        (
            "shadows = true",
            "shadows = \"yes\"",
            "shadows = \"yes\": must be",
        ),
        ("shadows = true", "shadow = true", "shadow"),
    ] {
        let text = with(SHADOWS, part, wrong);
        let error = Description::from_toml("scene", "scene", &text).unwrap_err();
        assert!(error.to_string().contains(message), "{wrong}: {error}");
    }
    let text = format!("samples = 4\n{MESH}");
    let source = concat!(env!("CARGO_MANIFEST_DIR"), "/scene.toml");
    let error = Description::from_toml(source, "mesh", &text).unwrap_err();
    assert!(
        error.to_string().contains("1 in a scene with a mesh"),
        "{error}"
    );
}
