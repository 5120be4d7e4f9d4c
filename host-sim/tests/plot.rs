//! `microbrdf plot`: figures and materials, as files that decode.

mod support;

use std::fs;
use std::path::Path;
use std::sync::Arc;

use microbrdf_reference::figures;
use microbrdf_sim::picture::Picture;
use resvg::usvg::{Group, Node, Options, Rect, Tree, fontdb};
use support::{Folder, run};

const PHONG: &str = "model = \"phong\", exponent = 20";
const MIXTURE: &str = "model = \"patch-exponential\", sharpness = 8";

/// An SVG read by a library that knows the program's own font and no other.
fn tree(svg: &str) -> Tree {
    let mut fonts = fontdb::Database::new();
    let font = concat!(env!("CARGO_MANIFEST_DIR"), "/fonts/DejaVuSans-subset.ttf");
    fonts.load_font_data(fs::read(font).expect("the font"));
    let options = Options {
        fontdb: Arc::new(fonts),
        ..Options::default()
    };
    Tree::from_str(svg, &options).expect("an SVG")
}

/// What is drawn in a group: texts with their boxes, and the number of curves.
#[derive(Default)]
struct Drawn {
    texts: Vec<(String, Rect)>,
    curves: usize,
}

impl Drawn {
    fn of(group: &Group) -> Self {
        let mut drawn = Self::default();
        drawn.collect(group);
        drawn
    }

    fn collect(&mut self, group: &Group) {
        for node in group.children() {
            match node {
                Node::Group(inner) => self.collect(inner),
                Node::Text(text) => {
                    let content: String = text.chunks().iter().map(|chunk| chunk.text()).collect();
                    for span in text.layouted() {
                        for glyph in &span.positioned_glyphs {
                            assert_ne!(glyph.id.0, 0, "no glyph for {:?}", glyph.text);
                        }
                    }
                    let glyphs: usize = text
                        .layouted()
                        .iter()
                        .map(|span| span.positioned_glyphs.len())
                        .sum();
                    assert!(glyphs > 0 || content.trim().is_empty(), "{content:?}");
                    self.texts.push((content, node.abs_bounding_box()));
                }
                Node::Path(path) if path.stroke().is_some_and(|s| s.width().get() > 1.5) => {
                    self.curves += 1;
                }
                _ => {}
            }
        }
    }
}

/// Every text within the sheet, none over another.
fn check_layout(name: &str, tree: &Tree) -> Drawn {
    let drawn = Drawn::of(tree.root());
    let size = tree.size();
    for (i, (text, a)) in drawn.texts.iter().enumerate() {
        assert!(
            a.left() >= 0.0
                && a.top() >= 0.0
                && a.right() <= size.width()
                && a.bottom() <= size.height(),
            "{name}: {text:?} leaves the sheet"
        );
        for (other, b) in &drawn.texts[..i] {
            let apart = a.right() <= b.left()
                || b.right() <= a.left()
                || a.bottom() <= b.top()
                || b.bottom() <= a.top();
            assert!(apart, "{name}: {text:?} overlaps {other:?}");
        }
    }
    drawn
}

fn dark_pixels(path: &str) -> (Picture, usize) {
    let picture = Picture::read_png(Path::new(path)).expect("a PNG");
    let dark = picture.pixels.iter().filter(|p| p[0] < 128).count();
    (picture, dark)
}

#[test]
fn every_figure_is_drawn_both_ways_and_says_what_it_omits() {
    let folder = Folder::new("plot-all");
    let out = folder.path("");
    let printed = run(&["plot", "--figure", "all", "--out", &out]).output();
    let numbers: Vec<_> = figures::known().collect();
    assert_eq!(folder.names().len(), 2 * numbers.len());
    let sections: Vec<_> = printed.split("Figure ").skip(1).collect();
    assert_eq!(sections.len(), numbers.len());
    for (number, section) in numbers.iter().zip(sections) {
        assert!(section.starts_with(&format!("{number}: ")), "{section}");
        let svg = fs::read_to_string(folder.path(&format!("figure-{number}.svg"))).expect("SVG");
        let tree = tree(&svg);
        let drawn = check_layout(number, &tree);
        // A sheet holds its curves and a sample of most of them.
        assert!(drawn.curves >= 2, "{number}: {} curves", drawn.curves);
        let words: String = drawn.texts.iter().map(|(t, _)| format!("{t} ")).collect();
        assert!(words.contains(&format!("Figure {number}: ")), "{words}");
        let missing = "Without the He–Torrance curve";
        let expected = ["2.1", "3.3", "3.4"].contains(number);
        assert_eq!(
            words.contains(missing),
            expected,
            "{number}, in the picture"
        );
        assert_eq!(section.contains(missing), expected, "{number}, in print");
        let (picture, dark) = dark_pixels(&folder.path(&format!("figure-{number}.png")));
        let size = tree.size();
        assert_eq!(picture.width, 2 * size.width() as usize, "{number}");
        assert_eq!(picture.height, 2 * size.height() as usize, "{number}");
        assert!(dark > 5000, "{number}: {dark} dark pixels");
    }
}

#[test]
fn one_figure_goes_where_it_is_asked_to() {
    let folder = Folder::new("plot-one");
    for name in ["a.svg", "b.svg", "c.png", "d.PNG"] {
        let printed = run(&["plot", "--figure", "3.2", "-o", &folder.path(name)]).output();
        assert!(printed.starts_with("Figure 3.2: "), "{printed}");
        assert!(printed.contains(name), "{printed}");
    }
    let read = |name: &str| fs::read(folder.path(name)).expect("a file");
    assert_eq!(read("a.svg"), read("b.svg"), "twice the same");
    assert_eq!(read("c.png"), read("d.PNG"), "twice the same");
    assert_eq!(folder.names(), ["a.svg", "b.svg", "c.png", "d.PNG"]);
}

#[test]
fn every_quantity_of_materials_is_drawn() {
    let folder = Folder::new("plot-materials");
    let gold = "model = \"metal\", exponent = 50, metal = \"gold\"";
    let file = folder.file("sharp.toml", "model = \"phong\"\nexponent = 1e8\n");
    for (quantity, materials, curves) in [
        // Each curve has a sample beside it, in lobe diagrams the light, too.
        ("albedo", vec![PHONG, gold, &file], 2 * 5),
        ("lobe", vec![PHONG, MIXTURE], 2 * 3),
        ("radiance", vec![gold, MIXTURE], 2 * 4),
        ("density", vec![MIXTURE], 2),
        ("inverse", vec![MIXTURE], 2),
    ] {
        let svg = folder.path(&format!("{quantity}.svg"));
        let mut arguments = vec!["plot", "--quantity", quantity, "-o", &svg];
        for material in &materials {
            arguments.extend(["--material", material]);
        }
        assert_eq!(run(&arguments).output(), "");
        let drawn = check_layout(quantity, &tree(&fs::read_to_string(&svg).expect("SVG")));
        assert_eq!(drawn.curves, curves, "{quantity}");
        let png = folder.path(&format!("{quantity}.png"));
        arguments[4] = &png;
        run(&arguments).output();
        assert!(dark_pixels(&png).1 > 5000, "{quantity}");
    }
}

#[test]
fn incidences_of_one_material_are_named() {
    let folder = Folder::new("plot-incidence");
    let svg = folder.path("lobe.svg");
    let mut arguments = vec![
        "plot",
        "--quantity",
        "lobe",
        "--material",
        PHONG,
        "-o",
        &svg,
    ];
    arguments.extend(["--incidence", "0,40,89.99"]);
    run(&arguments).output();
    let drawn = check_layout("lobe", &tree(&fs::read_to_string(&svg).expect("SVG")));
    for name in ["Θ = 0°", "Θ = 40°", "Θ = 89.99°", "light"] {
        assert!(drawn.texts.iter().any(|(text, _)| text == name), "{name}");
    }
}

#[test]
fn mistakes_are_told_and_nothing_is_written() {
    let folder = Folder::new("plot-mistakes");
    let png = folder.path("out.png");
    let missing = folder.path("nowhere/out.png");
    let out = folder.path("figures");
    for (arguments, parts) in [
        (
            vec!["--figure", "2.2", "-o", &png],
            vec![
                "--figure 2.2",
                "2.1, 2.3, 2.4",
                "4.12, 4.13, 4.14, 4.15",
                "all",
            ],
        ),
        (vec!["--figure", "", "-o", &png], vec!["3.1"]),
        (vec!["--figure", "3.1"], vec!["-o"]),
        (vec!["--figure", "all"], vec!["--out"]),
        (vec!["--figure", "all", "-o", &png], vec!["--out"]),
        (vec!["--figure", "3.2", "--out", &out], vec!["-o"]),
        (
            vec!["--figure", "3.2", "-o", "out.pdf"],
            vec!["out.pdf", ".svg or .png"],
        ),
        (vec!["--figure", "3.2", "-o", "out"], vec![".svg or .png"]),
        (vec!["--figure", "3.2", "-o", &missing], vec!["nowhere"]),
        (vec!["-o", &png], vec!["--material"]),
        (vec!["--material", PHONG], vec!["-o"]),
        (
            vec!["--material", "model = \"phong\", exponent = -1", "-o", &png],
            vec!["exponent"],
        ),
        (
            vec!["--material", PHONG, "--quantity", "density", "-o", &png],
            vec!["Phong, n = 20", "patch-exponential"],
        ),
        (
            vec![
                "--material",
                "model = \"patch-exponential\", sharpness = 0",
                "--quantity",
                "inverse",
                "-o",
                &png,
            ],
            vec!["sharpness 0"],
        ),
        (
            vec![
                "--material",
                PHONG,
                "--quantity",
                "lobe",
                "--incidence",
                "90",
                "-o",
                &png,
            ],
            vec!["--incidence 90", "0 to 89.99"],
        ),
        (
            vec![
                "--material",
                PHONG,
                "--quantity",
                "lobe",
                "--incidence",
                "NaN",
                "-o",
                &png,
            ],
            vec!["--incidence NaN"],
        ),
        (
            vec!["--material", PHONG, "--incidence", "30", "-o", &png],
            vec!["--incidence", "lobe and radiance"],
        ),
        (
            vec!["--figure", "3.1", "--material", PHONG, "-o", &png],
            vec!["--figure", "--material"],
        ),
    ] {
        let all: Vec<_> = [&["plot"], &arguments[..]].concat();
        run(&all).mistake(&parts);
    }
    assert_eq!(folder.names(), Vec::<String>::new());
}

/// Where nothing can be printed, that is told, and is no panic.
#[cfg(target_os = "linux")]
#[test]
fn standard_output_that_fails() {
    let folder = Folder::new("plot-full");
    let full = fs::File::options().write(true).open("/dev/full");
    let output = support::command(&["plot", "--figure", "3.2", "-o", &folder.path("a.svg")])
        .stdout(full.expect("the device"))
        .output()
        .expect("the command ends");
    let told = String::from_utf8(output.stderr).expect("UTF-8");
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(
        told.contains("standard output") && !told.contains("panicked"),
        "{told}"
    );
}

#[test]
fn help_has_examples() {
    let help = run(&["plot", "--help"]).output();
    for part in ["Examples:", "--figure 3.1", "--quantity", "svg"] {
        assert!(help.contains(part), "{part}: {help}");
    }
}
