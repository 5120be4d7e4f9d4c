//! Baked views of meshes: stored normals, tables, files, and pictures against
//! the reference.

use std::path::Path;

use microbrdf::arithmetic::{F32, Micromath, Q15, Q31};
use microbrdf::shade::{MeshView, NoDepths, Octahedral, Span, StoredDepths, View};
use microbrdf_scene::vector::{cross, dot, length, sub, unit};
use microbrdf_scene::{
    Description, HostArithmetic, Obj, Seen, StoredNormals, camera_frame, encode, greatest_error,
    half_pixel,
};
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_tests::baked::{MATT, MESH, description};
use microbrdf_tests::meshes::files;
use microbrdf_tests::pictures::{Case, faults};
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;

const ARITHMETICS: [ArithmeticName; 4] = [
    ArithmeticName::F32,
    ArithmeticName::Micromath,
    ArithmeticName::Q31,
    ArithmeticName::Q15,
];

/// The angle between two vectors of any length.
fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let across = cross(a, b);
    length(across).atan2(dot(a, b))
}

/// Directions evenly over the sphere.
fn directions(count: u32) -> impl Iterator<Item = [f64; 3]> {
    const TURN: f64 = 2.399_963_229_728_653;
    (0..count).map(move |i| {
        let z = 1.0 - f64::from(2 * i + 1) / f64::from(count);
        let (sin, cos) = (TURN * f64::from(i)).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        [radius * cos, radius * sin, z]
    })
}

/// The greatest angle between a direction and what is stored for it.
fn worst<N: Octahedral>() -> f64 {
    // Every half cell near the middle of a face, where cells are largest, and
    // about an axis and an edge, where they change.
    let step = 1.0 / f64::from(N::GREATEST);
    let about = [
        [1.0, 1.0, 1.0],
        [-1.0, 1.0, -1.0],
        [1.0, -1.0, -1.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
        [1.0, 0.0, 0.0],
        [0.0, -1.0, 1e-9],
        [1.0, 1.0, 0.0],
        [1.0, 0.0, -1.0],
    ];
    let near = about.into_iter().flat_map(|centre: [f64; 3]| {
        let sum: f64 = centre.iter().map(|c| c.abs()).sum();
        (-24..=24).flat_map(move |i| {
            (-24..=24).map(move |j| {
                let [x, y, z] = centre.map(|c| c / sum);
                let moved = [
                    x + f64::from(i) * step / 6.0,
                    y + f64::from(j) * step / 6.0,
                    z,
                ];
                unit(moved)
            })
        })
    });
    directions(100_000)
        .chain(near)
        .map(|normal| angle(encode::<N>(normal).vector().map(f64::from), normal))
        .fold(0.0, f64::max)
}

#[test]
fn stored_normals_are_within_their_bounds() {
    for (found, stated, bytes) in [
        (worst::<[u8; 3]>(), greatest_error::<[u8; 3]>(), 3),
        (worst::<[i16; 2]>(), greatest_error::<[i16; 2]>(), 4),
    ] {
        println!("{bytes} bytes: {found:e} of {stated:e}");
        assert!(found <= stated, "{bytes} bytes: {found:e} > {stated:e}");
        assert!(found >= 0.97 * stated, "{bytes} bytes: {found:e}");
    }
}

/// The greatest angle between the decoded direction and the exact one, and
/// the greatest fault of its length.
fn decoded<A: HostArithmetic, N: Octahedral>(stored: impl Iterator<Item = N>) -> [f64; 2] {
    stored.fold([0.0; 2], |[turn, stretch], stored| {
        let normal = stored.normal::<A>();
        let found = [normal.x, normal.y, normal.z].map(A::component_value);
        let exact = stored.vector().map(f64::from);
        [
            turn.max(angle(found, exact)),
            stretch.max((length(found) - 1.0).abs()),
        ]
    })
}

fn every_third<A: HostArithmetic>(step: usize) -> [f64; 2] {
    let three = (0..1u32 << 24).step_by(step).map(|code| {
        let [a, b, c, _] = code.to_le_bytes();
        [a, b, c]
    });
    let four = (0..=u32::MAX)
        .step_by(step * 257)
        .map(|code| [code as i16, (code >> 16) as i16]);
    let ([a, b], [c, d]) = (decoded::<A, _>(three), decoded::<A, _>(four));
    [a.max(c), b.max(d)]
}

/// Codes over all that there are, those included that nothing is stored as.
#[test]
fn decoding_is_as_fine_as_the_arithmetic() {
    for (name, found, bounds) in [
        ("f32", every_third::<F32>(61), [2e-7, 2e-7]),
        ("micromath", every_third::<Micromath>(61), [2e-7, 2e-5]),
        ("q31", every_third::<Q31>(61), [4e-9, 2e-8]),
        ("q15", every_third::<Q15>(61), [6e-5, 6e-5]),
    ] {
        println!("{name}: {found:?}");
        for (found, bound) in found.into_iter().zip(bounds) {
            assert!(found <= bound, "{name}: {found:e} > {bound:e}");
            assert!(found > bound / 20.0, "{name}: {found:e}");
        }
    }
}

/// Tables of nothing but chance are looked up everywhere.
fn any_table<A: HostArithmetic>() {
    let mut random = Pcg64Mcg::seed_from_u64(5);
    let mut shown = 0;
    for _ in 0..4000 {
        let mut number = |below: u32| random.next_u32() % below;
        let (height, spans) = (number(6), number(8));
        let rows: Vec<_> = (0..height)
            .map(|_| {
                if number(20) == 0 {
                    u32::MAX
                } else {
                    number(10)
                }
            })
            .collect();
        let spans: Vec<_> = (0..spans)
            .map(|_| {
                let start = number(8) as u16;
                let first = if number(20) == 0 { u32::MAX } else { number(8) };
                Span::new(start, number(12) as u16, first, number(256) as u8)
            })
            .collect();
        let normals: Vec<_> = (0..number(30))
            .map(|_| number(1 << 24).to_le_bytes())
            .map(|[a, b, c, _]| [a, b, c])
            .collect();
        let codes: Vec<_> = (0..number(30)).map(|_| number(1 << 16) as u16).collect();
        let depths = StoredDepths::<A> {
            near: A::length(number(127).into()),
            range: A::length(number(127).into()),
            codes: &codes,
        };
        let without = MeshView {
            rows: &rows,
            spans: &spans,
            normals: &normals,
            depths: NoDepths,
        };
        let with = MeshView {
            rows: &rows,
            spans: &spans,
            normals: &normals,
            depths,
        };
        for y in (0..8).chain([usize::MAX]) {
            for x in (0..14).chain([65_535, 65_536, usize::MAX]) {
                let seen: Option<_> = View::<A>::at(&without, x, y);
                assert_eq!(seen.is_some(), View::<A>::at(&with, x, y).is_some());
                shown += u32::from(seen.is_some());
            }
        }
    }
    assert!(shown > 1000, "{shown}");
}

#[test]
fn a_table_never_panics() {
    any_table::<F32>();
    any_table::<Q31>();
    any_table::<Q15>();
}

/// Beside [`faults`]: `one` is the greatest share of codes off by one.
fn holds(name: &str, case: &Case, one: f64) {
    let seen = case.description.view.as_ref().expect("a mesh");
    let pixels = seen.pixels.iter().flatten().count();
    assert!(pixels > 200, "{name}: {pixels} pixels of a mesh");
    for arithmetic in ARITHMETICS {
        let found = case.measured(arithmetic);
        println!("{name}, {}: {found:?}", arithmetic.name());
        let share = "too many codes are off by one";
        let faults: Vec<_> = faults(&found).into_iter().filter(|f| *f != share).collect();
        assert!(faults.is_empty(), "{faults:?}: {found:?}");
        assert!(found.off_by_one <= one, "{found:?}");
        // What is seen of a mesh has no edge that arithmetics could find elsewhere.
        assert_eq!(found.class_flips, 0);
    }
}

/// Under a lamp, half behind a sphere and in a plane; matt and metal. Normals
/// of three bytes are off by up to a quarter of a code, and nothing else is in
/// that picture.
#[test]
fn meshes_are_the_references() {
    holds("mesh", &Case::new(description("mesh", MESH)), 0.002);
    holds("matt", &Case::new(description("matt", MATT)), 0.02);
}

#[test]
fn the_teapot_is_the_references() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/teapot.toml");
    let case = Case::new(Description::from_file(&path).expect("a scene"));
    holds("teapot", &case, 0.002);
}

/// Where the table says nothing else, a scene has no other picture for it.
#[test]
fn each_part_of_a_mesh_matters() {
    let whole = Case::new(description("mesh", MESH)).exact.srgb().pixels;
    for (part, other) in [
        ("rotate = [0, 0, 30]", "rotate = [0, 0, 33]"),
        ("scale = 1.1", "scale = 1.15"),
        ("position = [0.1, 0, -1.05]", "position = [0.1, 0, -1]"),
        ("knob = \"gold\"", "lid = \"gold\""),
        ("material = \"clay\"", "material = \"gold\""),
        ("intensity = 14", "intensity = 7"),
        ("[0.45, -1.7, -0.3]", "[0.45, 1.7, -0.3]"),
    ] {
        assert_eq!(MESH.matches(part).count(), 1, "{part}");
        let changed = Case::new(description("mesh", &MESH.replace(part, other)));
        let changed = changed.exact.srgb().pixels;
        let pixels = whole.iter().zip(&changed).filter(|(a, b)| a != b).count();
        assert!(pixels > 10, "{part}: {pixels} pixels");
    }
}

/// The first triangle that a ray meets, by another method (T. Möller,
/// B. Trumbore, 1997): depth and triangle.
fn cast(obj: &Obj, eye: [f64; 3], d: [f64; 3]) -> Option<(f64, usize)> {
    let mut nearest: Option<(f64, usize)> = None;
    for (index, triangle) in obj.triangles.iter().enumerate() {
        let [a, b, c] = triangle.corners.map(|corner| obj.positions[corner]);
        let (ab, ac) = (sub(b, a), sub(c, a));
        let p = cross(d, ac);
        let volume = dot(ab, p);
        let from = sub(eye, a);
        let u = dot(from, p) / volume;
        let q = cross(from, ab);
        let v = dot(d, q) / volume;
        let depth = dot(ac, q) / volume;
        let within = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && depth > 0.0;
        if within && nearest.is_none_or(|(least, _)| depth < least) {
            nearest = Some((depth, index));
        }
    }
    nearest
}

/// Without a hole and without a pixel too many.
#[test]
fn coverage_is_that_of_ray_casting() {
    let scene = description("matt", MATT);
    let camera = &scene.camera;
    let [_, text] = files();
    let obj = Obj::read("knot.obj", &text.1).expect("a mesh");
    let [ahead, right, up] = camera_frame(camera);
    let step = half_pixel(camera);
    let view = scene.view.as_ref().expect("a mesh");
    let mut covered = 0;
    for y in 0..usize::from(camera.height) {
        for x in 0..usize::from(camera.width) {
            let column = step * ((2 * x + 1) as f64 - f64::from(camera.width));
            let row = step * (f64::from(camera.height) - (2 * y + 1) as f64);
            let ray = [0, 1, 2].map(|i| ahead[i] + column * right[i] + row * up[i]);
            let d = unit(ray);
            match (view.at(x, y), cast(&obj, camera.eye, d)) {
                (None, None) => {}
                (Some(Seen { depth, normal, .. }), Some((exact, _))) => {
                    covered += 1;
                    assert!((depth - exact).abs() < 1e-9, "({x}, {y}): {depth}, {exact}");
                    assert!(dot(normal, d) <= -1.0 / 32.0 + 1e-12, "({x}, {y})");
                }
                other => panic!("({x}, {y}): {other:?}"),
            }
        }
    }
    assert!(covered > 500, "{covered} pixels");
}

/// Three bytes where a material lets them, else four; two more for a lamp.
#[test]
fn a_table_is_as_fine_as_its_materials_need() {
    let stored = |text: &str| {
        let scene = description("matt", text);
        let view = scene
            .prepare::<Q15>()
            .expect("a scene")
            .view
            .expect("a mesh");
        let pixels = match &view.normals {
            StoredNormals::Three(normals) => normals.len(),
            StoredNormals::Four(normals) => normals.len(),
        };
        let per_pixel = match view.normals {
            StoredNormals::Three(_) => 3,
            StoredNormals::Four(_) => 4,
        };
        assert_eq!(view.depths.is_some(), text.contains("\"point\""));
        let depths = if view.depths.is_some() { 2 } else { 0 };
        let spans = 4 * view.rows.len() + 8 * view.spans.len();
        assert_eq!(view.bytes(), (per_pixel + depths) * pixels + spans);
        per_pixel
    };
    let glossy = |n: u32| {
        MATT.replace(
            "model = \"lambert\"\nalbedo = [0.6, 0.3, 0.2]",
            &format!("model = \"metallic-phong\"\nexponent = {n}"),
        )
    };
    assert_eq!(stored(MATT), 3);
    assert_eq!(stored(&glossy(1)), 3);
    assert_eq!(stored(&glossy(2)), 4);
    let lamp = "[[light]]\nkind = \"point\"\nposition = [0, -3, 3]\nintensity = 3\n[[mesh]]";
    assert_eq!(stored(&MATT.replace("[[mesh]]", lamp)), 3);
}

#[test]
fn the_meshes_are_fresh() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/meshes");
    for (name, text) in files() {
        let found = std::fs::read_to_string(folder.join(name)).expect(name);
        assert!(
            found == text,
            "{name} is out of date: cargo run -p microbrdf-tests --bin meshes"
        );
        let obj = Obj::read(name, &text).expect(name);
        assert!((1000..9000).contains(&obj.triangles.len()), "{name}");
        assert_eq!(obj.normals.is_empty(), name == "knot.obj");
    }
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 2\n";

#[test]
fn what_a_file_may_say() {
    let read = |rest: &str| Obj::read("it.obj", &format!("{SQUARE}{rest}"));
    let obj = read("g a\ns off\nusemtl red\nf 1//1 2//1 3//1 4//1\n").unwrap();
    assert_eq!(obj.triangles.len(), 2);
    assert_eq!(obj.normals, [[0.0, 0.0, 1.0]]);
    assert_eq!(obj.materials, ["red"]);
    assert_eq!(obj.triangles[1].corners, [0, 2, 3]);
    // Backwards, with texture coordinates, a comment and a library.
    let obj = read("mtllib other.mtl\nvt 0 0\nf -4/1 -3/1 -1/1 # a triangle\n").unwrap();
    assert_eq!(obj.triangles[0].corners, [0, 1, 3]);
    assert_eq!(obj.triangles[0].normals, None);
    assert_eq!(obj.triangles[0].material, None);
}

#[test]
fn mistakes_of_a_file_are_named() {
    for (rest, line, message) in [
        ("f 1 2 5", 6, "`5` is no vertex: there are 4 so far"),
        ("f 1 2 -5", 6, "`-5` is no vertex"),
        ("f 0 1 2", 6, "`0` is no vertex"),
        ("f 1//2 2//2 3//2", 6, "`2` is no normal: there are 1"),
        ("f 1//-9223372036854775808 2 3", 6, "is no normal"),
        ("f 18446744073709551617 2 3", 6, "is no vertex"),
        ("f 1/1/1/1 2 3", 6, "more than three indices"),
        ("f 1 2", 6, "a face of 2 corners"),
        ("f", 6, "a face of no corner"),
        ("f 1//1 2 3", 6, "others have none"),
        ("f 1 2 2", 6, "lie on a line"),
        ("v nan 0 0", 6, "`nan` is no number"),
        ("v 0 inf 0", 6, "`inf` is no number"),
        ("v 0 0 1e7", 6, "`1e7` is no number"),
        ("v 0 0", 6, "three numbers are needed"),
        ("vn 0 0 0", 6, "a normal of length 0"),
        ("\n\nfoo 1", 8, "`foo` is no statement"),
        ("mtllib a.mtl it.obj", 6, "the file itself"),
        ("curv 0 1", 6, "`curv` is no statement"),
    ] {
        let error = Obj::read("it.obj", &format!("{SQUARE}{rest}\n")).unwrap_err();
        assert_eq!(error.line, Some(line), "{rest}: {error}");
        assert!(error.message.contains(message), "{rest}: {error}");
    }
    let error = Obj::read("it.obj", SQUARE).unwrap_err();
    assert_eq!((error.line, &error.message[..]), (None, "has no face"));
}

#[test]
fn mistakes_about_a_mesh_are_named() {
    for (part, other, message) in [
        ("knot.obj", "not.obj", "not.obj: can't be read"),
        (
            "material = \"clay\"",
            "",
            "`knot` has no entry in `materials`",
        ),
        (
            "material = \"clay\"",
            "materials = { not = \"clay\" }",
            "the file's faces have no such material, but `knot`",
        ),
        (
            "material = \"clay\"",
            "materials = { knot = \"brick\" }",
            "mesh[1].materials.knot = \"brick\"",
        ),
        (
            "position = [0, 0, 0]",
            "position = [0, -8, 0]",
            "ahead of the camera",
        ),
        (
            "position = [0, 0, 0]",
            "position = [0, 200, 0]",
            "from the camera",
        ),
        (
            "position = [0, 0, 0]",
            "scale = 0",
            "a number from 0.000001 to 1000000",
        ),
        (
            "position = [0, 0, 0]",
            "rotate = [0, 0, 361]",
            "from -360 to 360",
        ),
        ("position = [0, 0, 0]", "turn = 3", "unknown field `turn`"),
    ] {
        assert_eq!(MATT.matches(part).count(), 1, "{part}");
        let text = MATT.replace(part, other);
        let source = concat!(env!("CARGO_MANIFEST_DIR"), "/it.toml");
        let error = Description::from_toml(source, "it", &text).unwrap_err();
        assert!(error.to_string().contains(message), "{other}: {error}");
        assert!(error.place.is_some(), "{other}: {error}");
    }
}
