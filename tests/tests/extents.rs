//! Where spheres are looked for changes no pixel, and spares most tests.

use microbrdf::arithmetic::{F32, Q15, Q31};
use microbrdf::shade::{Extent, Samples as _};
use microbrdf_scene::{Description, HostArithmetic, Prepared, SceneParts};

/// A camera at the origin that looks along y, and spheres about it: in the
/// middle, at each edge, so near that they fill the picture, and behind.
fn scene(head: &str, fov: f64, target: &str) -> Description {
    let mut text = format!(
        "widen = false\n{head}background = [0.2, 0.1, 0.3]\n[camera]\nwidth = 60\nheight = 44\n\
         eye = [0, 0, 0]\ntarget = {target}\nfov = {fov}\n[[light]]\nkind = \"directional\"\n\
         direction = [-1, -2, 2]\ncolor = 1\n[material.m]\nmodel = \"lambert\"\nalbedo = 0.5\n"
    );
    for (center, radius) in [
        ("[0, 9, 0]", 1.0),
        ("[-4, 8, 0.3]", 1.2),
        ("[4.5, 8, -2]", 0.9),
        ("[0.4, 7, 3]", 1.1),
        ("[1, 6, -3.2]", 1.3),
        ("[2, 3, 2.5]", 1.5),
        ("[-60, 80, 40]", 20.0),
        ("[3, 0.1, 0]", 2.4),
        ("[0, -2, 1]", 1.9),
        ("[-1.2, -0.5, -1]", 1.2),
        ("[0.02, 90, 0.01]", 0.8),
    ] {
        text += &format!("[[sphere]]\ncenter = {center}\nradius = {radius}\nmaterial = \"m\"\n");
    }
    Description::from_toml("here", "here", &text).expect("a scene")
}

fn picture<A: HostArithmetic>(prepared: &Prepared<A>) -> Vec<[u32; 3]> {
    let height = prepared.camera.height / prepared.samples.side();
    let parts = SceneParts::new(prepared.clone());
    let surfaces = parts.surfaces();
    let scene = parts.scene(&surfaces);
    let mut pixels = Vec::new();
    for y in 0..usize::from(height) {
        scene.shade_row(y, |_, light| pixels.push(light.to_raw()));
    }
    pixels
}

fn same<A: HostArithmetic>(description: &Description) {
    let prepared = description.prepare::<A>().expect("a scene");
    let mut sought = prepared.clone();
    for sphere in &mut sought.spheres {
        sphere.extent = Extent::EVERYWHERE;
    }
    assert!(picture(&prepared) == picture(&sought), "{}", A::TYPE);
}

#[test]
fn no_sphere_is_missed() {
    for head in ["", "samples = 4\n", "shadows = true\n"] {
        for (fov, target) in [
            (40.0, "[0, 1, 0]"),
            (90.0, "[0.3, 1, -0.2]"),
            (4.0, "[0, 9, 1.02]"),
            (70.0, "[1, -0.2, 0.5]"),
            (60.0, "[0.01, 0, 1]"),
            (60.0, "[-1, 0.3, -0.4]"),
        ] {
            let description = scene(head, fov, target);
            same::<F32>(&description);
            same::<Q31>(&description);
            same::<Q15>(&description);
        }
    }
}

#[test]
fn extents_are_tight() {
    let prepared = scene("", 40.0, "[0, 1, 0]").prepare::<Q31>().expect("q31");
    // asin(1/9) to each side, at 22 rows to tan 20°: pixels from 14.7 to 28.3.
    let middle = prepared.spheres[0].extent;
    assert_eq!(middle.rows, [14, 30]);
    assert_eq!(middle.columns, [22, 38]);
    let behind = prepared.spheres[8].extent;
    assert!(behind.columns[0] >= behind.columns[1] || behind.rows[0] >= behind.rows[1]);
    // The last is a point, far off.
    let far = prepared.spheres[10].extent;
    assert!(far.columns[1] - far.columns[0] <= 4, "{far:?}");
}
