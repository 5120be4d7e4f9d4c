//! Steps over the Rust crates.

use std::process::Command;
use std::time::SystemTime;

use super::counts::{self, Tally};
use super::{Bench, Step, binaries, cargo, step};
use crate::board::{ARITHMETICS, BOARDS, Board};
use crate::command::Machine;
use crate::failure::{Failure, Outcome};
use crate::firmware::{self, Order};
use crate::host_sim::HostSim;
use crate::setup::deny;

/// The firmware's further features, which are linted all at once and not at all.
const FEATURES: [&str; 5] = [
    "rgb565",
    "defmt",
    "brief",
    "provoke-panic",
    "provoke-hardfault",
];

/// Lock file, format, lints: what fails most, and soonest.
pub fn style() -> Vec<Step> {
    let mut steps = vec![
        step("lock file", |bench| {
            let mut cargo = cargo(bench, &["metadata", "--locked", "--format-version", "1"]);
            bench.finish("lock-file", &mut cargo).map(|_| Tally::PASSED)
        })
        .early(),
        step("format", |bench| {
            bench
                .finish("format", &mut cargo(bench, &["fmt", "--all", "--check"]))
                .map(|_| Tally::PASSED)
        })
        .early(),
        step("lints, host", |bench| {
            let mut cargo = cargo(
                bench,
                &["clippy", "--workspace", "--all-targets", "--locked"],
            );
            cargo.args(["--", "-D", "warnings"]);
            bench
                .finish("lints-host", &mut cargo)
                .map(|_| Tally::PASSED)
        }),
    ];
    for board in BOARDS {
        steps.push(step(format!("lints, {}", board.name), move |bench| {
            lint(bench, board)
        }));
    }
    steps
}

/// Clippy over the firmware for a board, plain and with every further feature.
fn lint(bench: &Bench<'_>, board: Board) -> Outcome<Tally> {
    let host = HostSim::build(bench.layout, true)?;
    let scene = bench.layout.at("scenes/demo.toml");
    let baked = firmware::bake(bench.layout, &host, &scene, ARITHMETICS[0])?;
    let mut tally = Tally::default();
    for (kind, features) in [("plain", &[][..]), ("all", &FEATURES[..])] {
        let order = Order {
            board,
            scene: scene.clone(),
            arithmetic: ARITHMETICS[0].to_string(),
            features: features.iter().map(ToString::to_string).collect(),
        };
        let mut cargo = bench.cross.cargo(bench.layout, "clippy", board.target);
        cargo
            .args(["--locked", "--package", "microbrdf-firmware", "--features"])
            .arg(order.feature_list())
            .args(["--", "-D", "warnings"])
            .env("MICROBRDF_SCENE_RS", &baked);
        let name = format!("lints-{}-{kind}", board.name);
        bench.finish(&name, &mut cargo)?;
        tally += Tally::PASSED;
    }
    Ok(tally)
}

/// Seconds that materials and directions are drawn for, in each arithmetic:
/// 30 on two cores.
const FUZZ_SECONDS: u64 = 15;
/// Seconds that files are drawn for, in each arithmetic.
const FUZZ_FILES_SECONDS: u64 = 5;

/// A fuzz target, each time from another seed.
fn fuzz(bench: &Bench<'_>, target: &str, seconds: u64, counted: &str) -> Outcome<Tally> {
    let seed = SystemTime::now()
        .duration_since(SystemTime::UNIX_EPOCH)
        .map_or(0, |time| time.as_secs())
        << 20;
    println!("seed {seed}");
    let mut cargo = cargo(
        bench,
        &[
            "test",
            // Features as for the other tests, so that nothing is built again.
            "--workspace",
            "--locked",
            "--test",
            target,
        ],
    );
    cargo
        .args(["--", "--nocapture"])
        .env("MICROBRDF_FUZZ_SECONDS", seconds.to_string())
        .env("MICROBRDF_FUZZ_SEED", seed.to_string());
    let output = bench.finish(target, &mut cargo)?;
    for line in output.lines().filter(|line| line.ends_with(counted)) {
        println!("{line}");
    }
    Ok(counts::read(&output))
}

/// The tests that run on the host, with overflow checks as the profile says.
pub fn tests() -> Vec<Step> {
    let fuzz_models = step("fuzz", |bench| fuzz(bench, "fuzz", FUZZ_SECONDS, " pairs"));
    let fuzz_scenes = step("fuzz, scene files", |bench| {
        fuzz(bench, "fuzz_scene", FUZZ_FILES_SECONDS, " scenes")
    });
    let fuzz_meshes = step("fuzz, OBJ files", |bench| {
        fuzz(bench, "fuzz_obj", FUZZ_FILES_SECONDS, " meshes")
    });
    // They take every core themselves, and limit time.
    let host = step("host tests", binaries::run);
    [host, fuzz_models, fuzz_scenes, fuzz_meshes]
        .map(Step::alone)
        .into()
}

/// Documents, the package, licences: what a release needs.
pub fn release() -> Vec<Step> {
    vec![
        step("documents", |bench| {
            let mut cargo = cargo(bench, &["doc", "--workspace", "--no-deps", "--locked"]);
            cargo.env("RUSTDOCFLAGS", "-D warnings");
            bench.finish("documents", &mut cargo).map(|_| Tally::PASSED)
        }),
        step("package", |bench| {
            // Builds what would be published, from the packed archive; work in progress may be packed too.
            let mut cargo = cargo(bench, &["package", "--locked", "--allow-dirty"]);
            cargo.args(["--package", "microbrdf"]);
            bench.finish("package", &mut cargo).map(|_| Tally::PASSED)
        }),
        step("licences and sources", |bench| {
            let program = deny::program(bench.layout, &Machine)
                .ok_or_else(|| Failure::lacking("cargo-deny is missing"))?;
            let mut deny = Command::new(program);
            deny.current_dir(bench.layout.root());
            // Advisories need a database that is fetched from elsewhere than the registry.
            deny.args([
                "--locked",
                "check",
                "--hide-inclusion-graph",
                "licenses",
                "bans",
                "sources",
            ]);
            bench.finish("licences", &mut deny).map(|_| Tally::PASSED)
        }),
    ]
}
