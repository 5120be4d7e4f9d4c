//! `microbrdf advise`: the cheapest way that holds the bounds, and why.

mod support;

use std::path::Path;

use microbrdf::arithmetic::{F32, Q15, Q31};
use microbrdf_scene::Material;
use microbrdf_sim::advice::pixel_error;
use support::{Folder, run};

/// Figures made up for these tests, in the form that is measured.
const DATA: &str = r#"[
{"model":"metallic-phong","parameters":"exponent = 1","arithmetic":"q31","variant":"core, 1024 cells","core":"cortex-m3","exposure":"1","cycles_mean":900,"code_bytes":1000,"flash_table_bytes":4112,"estimate":true},
{"model":"metallic-phong","parameters":"exponent = 20","arithmetic":"q31","variant":"core, 1024 cells","core":"cortex-m3","exposure":"1","cycles_mean":260,"code_bytes":1118,"flash_table_bytes":4112,"estimate":true},
{"model":"metallic-phong","parameters":"exponent = 20","arithmetic":"q31","variant":"core, 64 cells","core":"cortex-m3","exposure":"1","cycles_mean":250,"code_bytes":1100,"flash_table_bytes":272,"estimate":true},
{"model":"metallic-phong","parameters":"exponent = 20","arithmetic":"q15","variant":"core, 129 knots","core":"cortex-m3","exposure":"1","cycles_mean":79,"code_bytes":322,"flash_table_bytes":920,"estimate":true},
{"model":"metallic-phong","parameters":"exponent = 20","arithmetic":"f32","variant":"core","core":"cortex-m3","exposure":"1","cycles_mean":6181,"code_bytes":3462,"flash_table_bytes":8,"estimate":true},
{"model":"metallic-phong","parameters":"exponent = 20","arithmetic":"f32","variant":"squaring","core":"cortex-m3","exposure":"1","cycles_mean":1,"code_bytes":1,"flash_table_bytes":1,"estimate":true},
{"model":"lambert","parameters":"albedo = 0.8","arithmetic":"q15","variant":"core, 129 knots","core":"cortex-m3","exposure":"1","cycles_mean":50,"code_bytes":200,"flash_table_bytes":0,"estimate":true}
]
"#;

const PHONG: &str = "model = \"metallic-phong\", exponent = 30";

fn advise(folder: &Folder, more: &[&str]) -> support::Ran {
    let data = folder.file("trade.json", DATA);
    let mut arguments = vec!["advise", "--core", "cortex-m3", "--data", &data];
    arguments.extend(["--material", PHONG]);
    arguments.extend(more);
    run(&arguments)
}

fn first(text: &str) -> &str {
    text.lines().next().expect("a line")
}

#[test]
fn the_cheapest_that_is_exact_enough_is_chosen() {
    let folder = Folder::new("advise-chooses");
    // A tight bound leaves the fine table and floats, a loose one q15.
    let tight = advise(&folder, &["--max-error", "0.52"]).output();
    assert!(
        first(&tight)
            .starts_with("q31 with tables of 1024: 260 cycles (estimated, of exponent = 20)"),
        "{tight}"
    );
    assert!(tight.contains("Runners-up:\n  f32: 6181"), "{tight}");
    assert!(
        tight.contains("the next, f32, takes 5921 cycles more and 1760 bytes fewer"),
        "{tight}"
    );
    let loose = advise(&folder, &["--max-error", "0.9"]).output();
    assert!(
        first(&loose).starts_with("q15 with tables of 129: 79 cycles"),
        "{loose}"
    );
    assert!(
        loose.contains("Ruled out:\n  q31 with tables of 64"),
        "{loose}"
    );
}

/// Of a metal under one light, and of one whose error is too great.
#[test]
fn a_lights_gain_may_be_in_the_tables() {
    let folder = Folder::new("advise-exposed");
    let row = |arithmetic: &str, variant: &str, cycles: u32| {
        format!(
            r#"{{"model":"metal","parameters":"metal = \"gold\", exponent = 20","arithmetic":"{arithmetic}","variant":"{variant}","core":"cortex-m3","exposure":"1","cycles_mean":{cycles},"code_bytes":300,"flash_table_bytes":1700,"estimate":true}}"#
        )
    };
    let rows = [
        row("q15", "core, 129 knots", 141),
        row("q15", "gain in the table, 129 knots", 80),
        row("q15", "world space, gain in the table, 129 knots", 1),
    ];
    let data = folder.file("trade.json", format!("[{}]", rows.join(",")));
    let call = |metal: &str, exposure: &str, most: &str| {
        let material = format!("model = \"metal\", {metal}, exponent = 20");
        run(&[
            "advise",
            "--core",
            "cortex-m3",
            "--data",
            &data,
            "--max-error",
            most,
            "--exposure",
            exposure,
            "--material",
            &material,
        ])
        .output()
    };
    let gold = call("metal = \"gold\"", "1", "0.75");
    assert!(
        first(&gold)
            .starts_with("q15 with tables of 129, for one light whose gain they hold: 80 cycles"),
        "{gold}"
    );
    assert!(
        gold.contains("Runners-up:\n  q15 with tables of 129: 141"),
        "{gold}"
    );
    // A tight bound rules it out.
    let glass = call("eta = [1.5, 1.5, 1.5], k = [0, 0, 0]", "3.5", "0.62");
    assert!(
        first(&glass).starts_with("q15 with tables of 129: 141"),
        "{glass}"
    );
    assert!(glass.contains("they hold: 80 cycles"), "{glass}");
}

#[test]
fn bytes_are_a_bound_too() {
    let folder = Folder::new("advise-bytes");
    let small = advise(&folder, &["--max-error", "0.52", "--max-bytes", "4000"]).output();
    assert!(first(&small).starts_with("f32: 6181 cycles"), "{small}");
    assert!(small.contains("takes more than 4000 bytes"), "{small}");
}

#[test]
fn nothing_that_holds_is_status_1() {
    let folder = Folder::new("advise-nothing");
    let ran = advise(&folder, &["--max-error", "0.52", "--max-bytes", "100"]);
    assert_eq!(ran.status, 1, "{ran:?}");
    assert!(ran.stdout.starts_with("Ruled out:"), "{ran:?}");
    assert!(ran.stderr.contains("holds the bounds"), "{ran:?}");
}

#[test]
fn mistakes_are_told() {
    let folder = Folder::new("advise-mistakes");
    let data = folder.file("trade.json", DATA);
    let call = |core: &str, error: &str, material: &str| {
        run(&[
            "advise",
            "--core",
            core,
            "--max-error",
            error,
            "--material",
            material,
            "--data",
            &data,
        ])
    };
    call("cortex-m9", "1", PHONG).mistake(&["--core cortex-m9", "cortex-m3"]);
    call("cortex-m3", "0.4", PHONG).mistake(&["--max-error 0.4"]);
    call("cortex-m3", "NaN", PHONG).mistake(&["--max-error"]);
    call("cortex-m3", "1", "model = \"patch\", radius = 9").mistake(&["radius"]);
    call("cortex-m3", "1", "model = \"patch\", radius = 1").mistake(&["patch", "cortex-m3"]);
    let broken = folder.file("broken.json", "[{]");
    run(&[
        "advise",
        "--core",
        "cortex-m3",
        "--max-error",
        "1",
        "--material",
        PHONG,
        "--data",
        &broken,
    ])
    .mistake(&["line 1"]);
    run(&["advise"]).mistake(&["--core"]);
}

/// With the project's own figures it runs, and where they are not made yet it
/// says so.
#[test]
fn the_projects_figures_are_read() {
    let ran = run(&[
        "advise",
        "--core",
        "cortex-m0plus",
        "--max-error",
        "0.75",
        "--material",
        PHONG,
    ]);
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/trade.json");
    if path.is_file() {
        assert!(ran.output().contains("cycles (estimated"));
    } else {
        assert_eq!(ran.status, 3, "{ran:?}");
        assert!(ran.stderr.contains("cargo xtask measure"), "{ran:?}");
    }
}

/// A glaze and another shape of a lobe are measured by themselves.
#[test]
fn materials_are_told_apart_by_their_fields() {
    let best = |material: &str| {
        run(&[
            "advise",
            "--core",
            "cortex-m0plus",
            "--max-error",
            "0.75",
            "--material",
            material,
        ])
    };
    let bare = "model = \"plastic\", albedo = 0.4, specular = 0.3, exponent = 25";
    assert!(!first(&best(bare).output()).contains("index = "));
    assert!(first(&best(&format!("{bare}, index = 1.6")).output()).contains("index = 1.5"));
    for material in [
        "model = \"generalised-lambert\", albedo = 0.6, smoothness = 0.8",
        "model = \"metallic-paint\", metal = \"copper\", sharpness = 9",
        "model = \"patch-metal\", metal = \"gold\", sharpness = 9",
    ] {
        assert!(first(&best(material).output()).contains("cycles (estimated"));
    }
    best("model = \"patch-metal\", metal = \"gold\", radius = 0.5")
        .mistake(&["patch-metal with radius"]);
}

/// Finer tables are more exact, and what 16-bit directions cost shows.
#[test]
fn pixel_errors_tell_tables_and_directions_apart() {
    let material = |toml: &str| Material::from_argument(toml).expect("a material");
    let phong = material(PHONG);
    let [fine, coarse, single] = [
        pixel_error::<Q31<1024>>(&phong, 1.0).expect("in range"),
        pixel_error::<Q31<64>>(&phong, 1.0).expect("in range"),
        pixel_error::<F32>(&phong, 1.0).expect("in range"),
    ];
    assert!(
        single.lsb_max < 0.51 && fine.lsb_max < 0.52,
        "{single:?} {fine:?}"
    );
    assert!(coarse.lsb_max > 1.0 && coarse.off > 0.05, "{coarse:?}");
    // At n = 5000 a step of a 16-bit direction is a part of the lobe.
    let sharp = material("model = \"metallic-phong\", exponent = 5000");
    let rounded = pixel_error::<Q15<257>>(&sharp, 1.0).expect("in range");
    assert!(rounded.lsb_max > 0.9, "{rounded:?}");
    let patch = material("model = \"patch\", radius = 0.3");
    let patch = pixel_error::<Q31<1024>>(&patch, 1.0).expect("in range");
    assert!(patch.lsb_max < 0.51 && patch.lsb_max > 0.45, "{patch:?}");
}

#[test]
fn help_has_an_example() {
    let help = run(&["advise", "--help"]).output();
    assert!(
        help.contains("microbrdf advise --core cortex-m0plus"),
        "{help}"
    );
}
