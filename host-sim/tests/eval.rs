//! `microbrdf eval`: values that read back exactly, and malformed lines.

mod support;

use microbrdf::arithmetic::{F32, Q31};
use microbrdf::brdf::Brdf;
use microbrdf::fixed::types::{I2F30, U32F32, U64F64};
use microbrdf::geometry::{Direction, ShadingFrame};
use microbrdf_scene::{AnyModel, HostArithmetic, Material};
use support::{Folder, run_with};

const LINES: &str = "0.6,0,0.8,-0.6,0,0.8\n\
    0.1,0.2,0.9,0.3,-0.1,0.7\n\
    1,1,1e-7,-1,-1,2e-7\n\
    1e300,0,1e300,-3e-300,1e-301,4e-300\n\
    0,0,1,0,0,-1\n\
    1,0,0,-1,0,0\n";

const GOLD: &str = "model = \"metal\", metal = \"gold\", exponent = 20";
const STEEL: &str = "model = \"metallic-phong\", exponent = 33.3";

fn lines<T: std::str::FromStr>(text: &str) -> Vec<Vec<T>>
where
    T::Err: std::fmt::Debug,
{
    text.lines()
        .map(|line| {
            line.split(',')
                .map(|field| field.parse().expect(field))
                .collect()
        })
        .collect()
}

/// The pairs of [`LINES`], normalised and rounded.
fn pairs<A: HostArithmetic>() -> Vec<ShadingFrame<A>> {
    let unit = |v: [f64; 3]| {
        let greatest = v.iter().fold(0.0f64, |a, b| a.max(b.abs()));
        let v = v.map(|c| c / greatest);
        let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
        let [x, y, z] = v.map(|c| A::component(c / length));
        Direction::new(x, y, z)
    };
    lines::<f64>(LINES)
        .into_iter()
        .map(|c| ShadingFrame::new(unit([c[0], c[1], c[2]]), unit([c[3], c[4], c[5]])))
        .collect()
}

fn model<A: HostArithmetic>(toml: &str) -> AnyModel<A> {
    Material::from_argument(toml)
        .expect("a material")
        .model()
        .expect("a material that the arithmetic takes")
}

fn eval(material: &str, arithmetic: &str, more: &[&str]) -> String {
    let mut arguments = vec!["eval", "--material", material, "--arithmetic", arithmetic];
    arguments.extend(more);
    run_with(&arguments, LINES.as_bytes()).output()
}

#[test]
fn f32_values_read_back_exactly() {
    for material in [GOLD, STEEL] {
        let model = model::<F32>(material);
        let channels = if material == GOLD { 3 } else { 1 };
        let brdf = lines::<f32>(&eval(material, "f32", &[]));
        let reflect = lines::<f32>(&eval(material, "f32", &["--quantity", "reflect"]));
        for (index, pair) in pairs::<F32>().iter().enumerate() {
            assert_eq!(brdf[index], model.brdf(pair).to_array()[..channels]);
            assert_eq!(reflect[index], model.reflect(pair).to_array()[..channels]);
        }
        assert_eq!(brdf.len(), 6);
    }
}

#[test]
fn q31_values_read_back_exactly() {
    for material in [GOLD, STEEL] {
        let model = model::<Q31>(material);
        let channels = if material == GOLD { 3 } else { 1 };
        let brdf = lines::<U64F64>(&eval(material, "q31", &["--quantity", "brdf"]));
        let reflect = lines::<U32F32>(&eval(material, "q31", &["--quantity", "reflect"]));
        for (index, pair) in pairs::<Q31>().iter().enumerate() {
            assert_eq!(brdf[index], model.brdf(pair).to_array()[..channels]);
            assert_eq!(reflect[index], model.reflect(pair).to_array()[..channels]);
        }
        assert_eq!(brdf.len(), 6);
    }
}

#[test]
fn the_reference_reads_back_exactly() {
    use microbrdf_reference as reference;
    let model = Material::from_argument(STEEL).expect("steel").reference();
    let found = lines::<f64>(&eval(STEEL, "reference", &[]));
    assert_eq!(eval(STEEL, "f64", &[]), eval(STEEL, "reference", &[]));
    let l = reference::Direction::new(0.6 / 0.8, 0.0, 1.0);
    let length = f64::sqrt(0.75f64 * 0.75 + 1.0);
    let l = reference::Direction::new(l.x / length, 0.0, l.z / length);
    assert_eq!(found[0], [model.eval(&l, &l.mirrored())]);
    assert_eq!(found.len(), 6);
}

#[test]
fn directions_are_printed_as_rounded() {
    let single = lines::<f32>(&eval(STEEL, "f32", &["--print-directions"]));
    for (line, pair) in single.iter().zip(pairs::<F32>()) {
        let (l, v) = (pair.l, pair.v);
        assert_eq!(line[..6], [l.x, l.y, l.z, v.x, v.y, v.z]);
        assert_eq!(line.len(), 7);
    }
    let gold = eval(GOLD, "q31", &["--print-directions"]);
    for (line, pair) in gold.lines().zip(pairs::<Q31>()) {
        let fields: Vec<_> = line.split(',').collect();
        assert_eq!(fields.len(), 9);
        let found: Vec<I2F30> = fields[..6]
            .iter()
            .map(|field| field.parse().expect("a component"))
            .collect();
        let (l, v) = (pair.l, pair.v);
        assert_eq!(found, [l.x, l.y, l.z, v.x, v.y, v.z]);
    }
    assert_eq!(single.len(), 6);
}

/// 8-bit codes of the clamped product of exposure and share, by hand.
#[test]
fn codes() {
    let code = |arithmetic: &str, exposure: &str, encoding: &str| {
        let text = run_with(
            &[
                "eval",
                "--material",
                "model = \"phong\", exponent = 0",
                "--arithmetic",
                arithmetic,
                "--quantity",
                "code",
                "--exposure",
                exposure,
                "--encoding",
                encoding,
            ],
            b"0,0.8660254037844386,0.5,0,-0.5,0.8660254037844386\n",
        )
        .output();
        text.trim().parse::<u8>().expect("a code")
    };
    for arithmetic in ["f32", "q31", "reference"] {
        // A share of 0.5 is code 127.5 · …: 188 in sRGB, 128 in linear light.
        assert_eq!(code(arithmetic, "1", "srgb"), 188, "{arithmetic}");
        assert_eq!(code(arithmetic, "0.25", "srgb"), 99, "{arithmetic}");
        assert_eq!(code(arithmetic, "0.25", "linear"), 32, "{arithmetic}");
        assert_eq!(code(arithmetic, "3", "srgb"), 255, "{arithmetic}");
        assert_eq!(code(arithmetic, "2e7", "linear"), 255, "{arithmetic}");
        assert_eq!(code(arithmetic, "1e-3", "linear"), 0, "{arithmetic}");
    }
}

#[test]
fn a_malformed_line_stops_it_with_its_number() {
    for (line, parts) in [
        ("0,0,1,0,0", ["5 fields", "must be 6"]),
        ("0,0,1,0,0,1,0", ["7 fields", "must be 6"]),
        ("0,0,one,0,0,1", ["\"one\"", "a finite number"]),
        ("0,0,nan,0,0,1", ["\"nan\"", "a finite number"]),
        ("0,0,1,inf,0,1", ["\"inf\"", "a finite number"]),
        ("0,0,1,0,0,1e999", ["\"1e999\"", "a finite number"]),
        ("0,0,0,0,0,1", ["l = 0,0,0", "longer than 0"]),
        ("0,0,1,0,-0,0", ["v = 0,0,0", "longer than 0"]),
        ("0;0;1;0;0;1", ["1 fields", "must be 6"]),
        ("0,0,,0,0,1", ["\"\"", "a finite number"]),
    ] {
        let input = format!("0,0,1,0,0,1\n\n 0, 0, 1, 0, 0, 1 \r\n{line}\n0,0,1,0,0,1\n");
        let ran = run_with(
            &["eval", "--material", STEEL, "--arithmetic", "q31"],
            input.as_bytes(),
        );
        // What came before has been printed, what comes after has not.
        assert_eq!(ran.stdout.lines().count(), 2, "{ran:?}");
        ran.mistake(&["standard input, line 4: ", parts[0], parts[1]]);
    }
    let ran = run_with(
        &["eval", "--material", STEEL],
        b"0,0,1,0,0,1\n0,0,1,0,\xFF,1\n",
    );
    assert_eq!(ran.stdout.lines().count(), 1);
    ran.mistake(&["standard input, line 2: "]);
}

/// A negative zero is the cosine 0.
#[test]
fn negative_zero_is_never_printed() {
    for arithmetic in ["f32", "q31"] {
        for quantity in ["brdf", "reflect"] {
            for material in [STEEL, "model = \"lambert\", albedo = 0.5"] {
                let text = run_with(
                    &[
                        "eval",
                        "--material",
                        material,
                        "--arithmetic",
                        arithmetic,
                        "--quantity",
                        quantity,
                    ],
                    b"1,0,-0,-1,0,-0\n1,0,-0,-0.6,0,0.8\n",
                )
                .output();
                assert!(!text.contains('-'), "{arithmetic}, {quantity}: {text}");
            }
        }
    }
}

#[test]
fn options_out_of_range() {
    let with = |more: &[&str]| {
        let mut arguments = vec!["eval", "--material", STEEL];
        arguments.extend(more);
        run_with(&arguments, LINES.as_bytes())
    };
    for exposure in ["0", "0.0009", "2.1e7", "nan", "inf"] {
        with(&["--exposure", exposure]).mistake(&["--exposure", "from 1e-3 to 2e7"]);
    }
    with(&["--exposure=-1"]).mistake(&["--exposure", "from 1e-3 to 2e7"]);
    with(&["--exposure", "bright"]).mistake(&["--exposure", "bright"]);
    with(&["--arithmetic", "q99"]).mistake(&["--arithmetic q99", "f32", "q31", "reference"]);
    with(&["--quantity", "albedo"]).mistake(&["albedo", "brdf", "reflect", "code"]);
    with(&["--encoding", "gamma"]).mistake(&["gamma", "srgb", "linear"]);
    with(&["--colour"]).mistake(&["--colour"]);
}

#[test]
fn materials_out_of_range() {
    let with = |material: &str, arithmetic: &str| {
        run_with(
            &["eval", "--material", material, "--arithmetic", arithmetic],
            LINES.as_bytes(),
        )
    };
    let half = "model = \"metallic-phong\", exponent = 0.5";
    with(half, "q31").mistake(&["--material", "exponent", "0 or a number from 1 to 1e8"]);
    with(half, "f32").output();
    with("model = \"patch\", radius = 2.5", "q31").mistake(&["radius = 2.5", "0.0001 to 2"]);
    with("model = \"patch\", radus = 1", "q31").mistake(&["radus"]);
    with("steel.toml", "q31").mistake(&["steel.toml", "can't be read"]);
    let folder = Folder::new("materials_out_of_range");
    let file = folder.file("bad.toml", "model = \"patch\"\nradius = -1\n");
    with(&file, "q31").mistake(&[&format!("{file}:2:10: radius = -1"), "0.0001 to 2"]);
    let file = folder.file("good.toml", "model = \"patch\"\nradius = 1\n");
    with(&file, "q31").output();
}
