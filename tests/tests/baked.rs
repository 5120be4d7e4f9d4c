//! What `microbrdf bake` writes compiles, and shades what the host shades, bit
//! for bit. `tests/baked` is made by `cargo run -p microbrdf-tests --bin baked`.

use microbrdf::shade::Linear;
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_sim::render;
use microbrdf_tests::baked::{SCENES, description, source};

macro_rules! baked {
    ($($module:ident $scene:literal $arithmetic:literal),* $(,)?) => {
        $(
            #[allow(unused, missing_docs)]
            mod $module {
                include!(concat!("../baked/", $scene, "-", $arithmetic, ".rs"));

                #[test]
                fn is_fresh_and_the_hosts() {
                    let text = include_str!(concat!("../baked/", $scene, "-", $arithmetic, ".rs"));
                    super::holds($scene, $arithmetic, text, WIDTH, HEIGHT, |y, sink| {
                        shade_row(y, sink);
                    });
                }
            }
        )*
    };
}

baked! {
    lamps_f32 "lamps" "f32",
    lamps_q31 "lamps" "q31",
    lamps_q15 "lamps" "q15",
    mesh_f32 "mesh" "f32",
    mesh_q31 "mesh" "q31",
    mesh_q15 "mesh" "q15",
    matt_f32 "matt" "f32",
    matt_q31 "matt" "q31",
    matt_q15 "matt" "q15",
    materials_f32 "materials" "f32",
    materials_q31 "materials" "q31",
    materials_q15 "materials" "q15",
    shadows_f32 "shadows" "f32",
    shadows_q31 "shadows" "q31",
    shadows_q15 "shadows" "q15",
}

/// The file is what the scene bakes to now, and its rows are the host's.
fn holds(
    name: &str,
    arithmetic: &str,
    text: &str,
    width: usize,
    height: usize,
    shade_row: impl Fn(usize, &mut dyn FnMut(usize, Linear)),
) {
    let (_, scene) = SCENES
        .into_iter()
        .find(|(known, _)| *known == name)
        .expect("a scene of the list");
    let arithmetic = ArithmeticName::ALL
        .into_iter()
        .find(|known| known.name() == arithmetic)
        .expect("an arithmetic");
    assert!(
        text == source(name, scene, arithmetic),
        "out of date: cargo run -p microbrdf-tests --bin baked"
    );
    let frame = render::frame(&description(name, scene), arithmetic).expect("a picture");
    assert_eq!((frame.width, frame.height), (width, height));
    for y in 0..height {
        shade_row(y, &mut |x, light| {
            assert_eq!(light, frame.pixels[y * width + x], "({x}, {y})");
        });
    }
}
