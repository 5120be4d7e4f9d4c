//! Small scenes that differ in one thing at a time.

use std::fmt::Write as _;

/// A scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Small {
    /// Its name.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Whether its stack is measured, which takes an emulated board.
    pub stack: bool,
}

/// The mesh that some of them show: beside them, as `mesh.obj`.
pub const MESH: &str = include_str!("../../../scenes/meshes/teapot.obj");

/// A material of each kind, twice: a wide lobe and a narrower one.
const KINDS: [(&str, [&str; 2]); 17] = [
    (
        "lambert",
        ["model = \"lambert\"\nalbedo = [0.7, 0.5, 0.3]"; 2],
    ),
    (
        "phong",
        [
            "model = \"phong\"\nexponent = 6",
            "model = \"phong\"\nexponent = 60",
        ],
    ),
    (
        "metallic-phong",
        [
            "model = \"metallic-phong\"\nexponent = 7",
            "model = \"metallic-phong\"\nexponent = 70",
        ],
    ),
    (
        "p-model",
        [
            "model = \"phong\"\nexponent = 8\np = 0.5",
            "model = \"phong\"\nexponent = 80\np = 0.25",
        ],
    ),
    (
        "retro-phong-flat",
        [
            "model = \"retro-phong\"\nexponent = 9\np = 0",
            "model = \"retro-phong\"\nexponent = 90\np = 0",
        ],
    ),
    (
        "retro-phong",
        [
            "model = \"retro-phong\"\nexponent = 10",
            "model = \"retro-phong\"\nexponent = 100",
        ],
    ),
    (
        "retro-p-model",
        [
            "model = \"retro-phong\"\nexponent = 11\np = 0.5",
            "model = \"retro-phong\"\nexponent = 110\np = 0.25",
        ],
    ),
    (
        "patch",
        [
            "model = \"patch\"\nradius = 0.9",
            "model = \"patch\"\nradius = 0.3",
        ],
    ),
    (
        "patch-exponential",
        [
            "model = \"patch-exponential\"\nsharpness = 3",
            "model = \"patch-exponential\"\nsharpness = 13",
        ],
    ),
    (
        "profile",
        [
            "model = \"profile\"\npoints = [[0, 1], [0.4, 0.7], [1.1, 0]]",
            "model = \"profile\"\npoints = [[0, 1], [0.1, 0.7], [0.4, 0]]",
        ],
    ),
    (
        "metal",
        [
            "model = \"metal\"\nmetal = \"copper\"\nexponent = 12",
            "model = \"metal\"\nmetal = \"gold\"\nexponent = 120",
        ],
    ),
    (
        "plastic",
        [
            "model = \"plastic\"\nalbedo = 0.5\nspecular = 0.25\nexponent = 13",
            "model = \"plastic\"\nalbedo = 0.3\nspecular = 0.2\nexponent = 130",
        ],
    ),
    (
        "ceramic",
        [
            "model = \"plastic\"\nalbedo = 0.5\nspecular = 0.5\nexponent = 14\nindex = 1.5",
            "model = \"plastic\"\nalbedo = 0.3\nspecular = 0.7\nexponent = 140\nindex = 1.6",
        ],
    ),
    (
        "patch-metal",
        [
            "model = \"patch-metal\"\nmetal = \"silver\"\nsharpness = 4",
            "model = \"patch-metal\"\nmetal = \"gold\"\nsharpness = 14",
        ],
    ),
    (
        "patch-metal-basic",
        [
            "model = \"patch-metal\"\nmetal = \"gold\"\nradius = 0.8",
            "model = \"patch-metal\"\nmetal = \"silver\"\nradius = 0.35",
        ],
    ),
    (
        "metallic-paint",
        [
            "model = \"metallic-paint\"\nmetal = \"aluminium\"\nsharpness = 5",
            "model = \"metallic-paint\"\nmetal = \"copper\"\nsharpness = 15",
        ],
    ),
    (
        "generalised-lambert",
        [
            "model = \"generalised-lambert\"\nalbedo = 0.6\nsmoothness = 0.75",
            "model = \"generalised-lambert\"\nalbedo = 0.7\nsmoothness = 0.5",
        ],
    ),
];

/// Those whose code others take, too, in part.
const ALONE: [&str; 7] = [
    "lambert",
    "phong",
    "metallic-phong",
    "patch",
    "patch-exponential",
    "metal",
    "plastic",
];

const SUN: &str = "[[light]]\nkind = \"directional\"\ndirection = [-1, -2, 2]\ncolor = 1\n";
const MOON: &str =
    "[[light]]\nkind = \"directional\"\ndirection = [2, -1, 1]\ncolor = [0.5, 0.4, 0.3]\n";
const LAMP: &str = "[[light]]\nkind = \"point\"\nposition = [1.5, -3, 2]\nintensity = 9\n";
const BULB: &str = "[[light]]\nkind = \"point\"\nposition = [-2, -2, 3]\nintensity = 9\n";
const FLOOD: &str = "[[light]]\nkind = \"flood\"\nposition = [-2, -3, 3]\naxis = [0.5, 0.8, -0.8]\nexponent = 5\nintensity = 20\n";
const SKY: &str = "[daylight]\ncolor = [0.4, 0.5, 0.6]\n";
const FLOOR: &str = "[[plane]]\npoint = [0, 0, -1.2]\nnormal = [0, 0, 1]\nmaterial = \"m0\"\n";
const WALL: &str = "[[plane]]\npoint = [0, 6, 0]\nnormal = [0, -1, 0.2]\nmaterial = \"m1\"\n";
const SQUARES: &str = "checker = { material = \"m1\", size = 0.7 }\n";

/// What a small scene is made of.
struct Made<'a> {
    head: &'a str,
    size: [u16; 2],
    /// Of each sphere, which stand side by side.
    materials: &'a [&'a str],
    radius: f64,
    lights: &'a [&'a str],
    more: &'a str,
}

impl Made<'_> {
    fn text(&self) -> String {
        let mut text = String::from("widen = false\n");
        let _ = write!(
            text,
            "{}[camera]\nwidth = {}\nheight = {}\neye = [0, -7, 1.4]\ntarget = [0, 0, 0]\nfov = 32\n",
            self.head, self.size[0], self.size[1]
        );
        text += &self.lights.concat();
        text += self.more;
        for index in 0..self.materials.len() {
            // In rows of four, each a little behind and above the one before.
            let (x, y) = (index % 4, index / 4);
            let _ = write!(
                text,
                "[[sphere]]\ncenter = [{}, {}, {}]\nradius = {}\nmaterial = \"m{index}\"\n",
                1.1 * x as f64 - 0.55 * (self.materials.len().min(4) - 1) as f64,
                y as f64,
                0.7 * y as f64 - 0.4,
                self.radius,
            );
        }
        for (index, material) in self.materials.iter().enumerate() {
            let _ = write!(text, "[material.m{index}]\n{material}\n");
        }
        text
    }
}

/// All of them.
#[must_use]
pub fn all() -> Vec<Small> {
    let mut scenes = Vec::new();
    let mut add = |name: &str, stack: bool, made: &Made<'_>| {
        scenes.push(Small {
            name: name.to_owned(),
            text: made.text(),
            stack,
        });
    };
    let matt = KINDS[0].1[0];
    let gloss = KINDS[2].1;
    let plain = Made {
        head: "",
        size: [48, 36],
        materials: &[matt],
        radius: 1.0,
        lights: &[SUN],
        more: "",
    };
    add("plain", true, &plain);
    add(
        "wide",
        false,
        &Made {
            size: [160, 16],
            ..plain
        },
    );
    for (kind, [wide, narrow]) in KINDS {
        // By its code alone, where others share it, and twice, in daylight.
        if ALONE.contains(&kind) {
            add(
                &format!("{kind}-alone"),
                false,
                &Made {
                    materials: &[matt, wide],
                    ..plain
                },
            );
        }
        let three = [matt, wide, narrow];
        let more = SKY;
        let lights: &[&str] = &[SUN, MOON];
        add(
            &format!("{kind}-twice"),
            true,
            &Made {
                materials: &three,
                lights,
                more,
                ..plain
            },
        );
    }
    let all: Vec<&str> = KINDS.iter().map(|(_, [wide, _])| *wide).collect();
    let some = [0, 2, 8, 10, 11].map(|index| KINDS[index].1[1]);
    add(
        "many",
        true,
        &Made {
            materials: &all[..9],
            radius: 0.6,
            ..plain
        },
    );
    add(
        "many-others",
        true,
        &Made {
            materials: &all[8..],
            radius: 0.6,
            more: SKY,
            ..plain
        },
    );
    add(
        "some",
        true,
        &Made {
            materials: &some,
            radius: 0.8,
            lights: &[SUN, MOON],
            ..plain
        },
    );
    let two = [matt, gloss[0]];
    let two = Made {
        materials: &two,
        ..plain
    };
    add("small", false, &Made { radius: 0.3, ..two });
    add(
        "matt-many",
        false,
        &Made {
            materials: &[matt; 9],
            radius: 0.3,
            ..plain
        },
    );
    add(
        "glossy-many",
        false,
        &Made {
            materials: &[gloss[0]; 9],
            radius: 0.5,
            ..plain
        },
    );
    add("floor", true, &Made { more: FLOOR, ..two });
    add(
        "floor-alone",
        false,
        &Made {
            more: FLOOR,
            ..plain
        },
    );
    let squares = format!("{FLOOR}{SQUARES}");
    add(
        "squares",
        true,
        &Made {
            more: &squares,
            ..two
        },
    );
    let room = format!("{FLOOR}{WALL}");
    add("room", false, &Made { more: &room, ..two });
    let room_squares = format!("{FLOOR}{SQUARES}{WALL}{SQUARES}");
    add(
        "room-squares",
        false,
        &Made {
            more: &room_squares,
            lights: &[SUN, LAMP],
            ..two
        },
    );
    for (name, lights) in [
        ("suns", &[SUN, MOON][..]),
        ("suns-three", &[SUN, MOON, SUN]),
        ("lamp", &[LAMP]),
        ("lamps", &[LAMP, BULB]),
        ("flood", &[FLOOD]),
        ("flood-lamp", &[FLOOD, LAMP]),
        ("sun-lamp", &[SUN, LAMP]),
        ("sun-lamp-flood", &[SUN, LAMP, FLOOD]),
    ] {
        add(name, true, &Made { lights, ..two });
        if name.ends_with("lamp") {
            let name = format!("{name}-some");
            add(
                &name,
                true,
                &Made {
                    lights,
                    materials: &some,
                    radius: 0.8,
                    more: &room,
                    ..plain
                },
            );
        }
    }
    let head = "shadows = true\n";
    add(
        "shadows",
        true,
        &Made {
            head,
            more: FLOOR,
            ..two
        },
    );
    add(
        "shadows-lamps",
        true,
        &Made {
            head,
            more: &room,
            lights: &[SUN, LAMP],
            ..two
        },
    );
    add(
        "shadows-some",
        true,
        &Made {
            head,
            materials: &some,
            radius: 0.7,
            more: &squares,
            lights: &[SUN, MOON],
            ..plain
        },
    );
    let head = "samples = 4\n";
    let size = [24, 18];
    add("samples", true, &Made { head, size, ..two });
    add(
        "samples-some",
        true,
        &Made {
            head,
            size,
            materials: &some,
            radius: 0.7,
            more: SKY,
            ..plain
        },
    );
    let head = "shadows = true\nsamples = 4\n";
    add(
        "samples-shadows",
        true,
        &Made {
            head,
            size,
            more: &squares,
            lights: &[SUN, MOON],
            ..two
        },
    );
    let mesh = |material: &str| {
        format!(
            "[[mesh]]\nfile = \"mesh.obj\"\nposition = [0, 1.5, -1]\nscale = 1.5\nmaterial = \"{material}\"\n"
        )
    };
    let (rough, fine) = (mesh("m0"), mesh("m1"));
    let teapot = Made { radius: 0.3, ..two };
    add(
        "mesh",
        true,
        &Made {
            more: &rough,
            materials: &[matt],
            ..teapot
        },
    );
    add(
        "mesh-fine",
        true,
        &Made {
            more: &fine,
            ..teapot
        },
    );
    add(
        "mesh-lamp",
        true,
        &Made {
            more: &fine,
            lights: &[SUN, LAMP],
            ..teapot
        },
    );
    let floor = format!("{fine}{FLOOR}{SKY}");
    add(
        "mesh-floor",
        false,
        &Made {
            more: &floor,
            ..teapot
        },
    );
    scenes
}
