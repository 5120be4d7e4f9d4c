//! What the linked core does not contain: a reachable panic, in fixed point a float, and stack without a bound.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use object::Endianness;
use object::elf::FileHeader32;
use object::read::elf::{FileHeader, Sym};

use super::counts::Tally;
use super::{Bench, Step, step};
use crate::failure::{During, Failure, Outcome};

/// A core without FPU, whose float operations are calls with names; one with; and a RISC-V core.
const TARGETS: [&str; 3] = [
    "thumbv6m-none-eabi",
    "thumbv7em-none-eabihf",
    "riscv32imc-unknown-none-elf",
];

/// Probes, and whether they compute with floats.
const PROBES: [(&str, bool); 8] = [
    ("q15", false),
    ("exposed", false),
    ("q31", false),
    ("sampling_q31", false),
    ("scene", false),
    ("scene_q15", false),
    ("f32", true),
    ("sampling_f32", true),
];

/// The probe that must not link.
const MUST_FAIL: &str = "must_fail";

/// The symbol that a reachable panic needs, and nobody has.
const PANIC: &str = "a_panic_is_reachable";

/// One step for each target.
pub fn steps() -> Vec<Step> {
    TARGETS
        .into_iter()
        .map(|target| {
            step(format!("probes, {target}"), move |bench| {
                probe(bench, target)
            })
        })
        .collect()
}

fn probe(bench: &Bench<'_>, target: &str) -> Outcome<Tally> {
    let mut tally = Tally::default();
    for (name, floats) in PROBES {
        let (linked, output) = link(bench, target, name)?;
        if !linked {
            return Err(Failure::incomplete(output));
        }
        // Hardware floats leave no symbol: the core without FPU is the witness.
        if target == TARGETS[0] && has_floats(&elf(bench, target, name))? != floats {
            return Err(Failure::incomplete(format!(
                "probe {name}: calls float routines must be {floats}, is {}",
                !floats
            )));
        }
        tally += Tally::PASSED;
    }
    stack(bench, target)?;
    tally += Tally::PASSED;
    let (linked, output) = link(bench, target, MUST_FAIL)?;
    if linked || !output.contains(PANIC) {
        return Err(Failure::incomplete(format!(
            "the probe that must not link for want of `{PANIC}` did not fail so:\n{output}"
        )));
    }
    tally += Tally::PASSED;
    Ok(tally)
}

/// Prints how much stack each probe takes at most; fails where that has no bound.
fn stack(bench: &Bench<'_>, target: &str) -> Outcome<()> {
    let mut command = Command::new(bench.layout.venv_program("microbrdf-stack"));
    command.args(PROBES.map(|(name, _)| elf(bench, target, name)));
    let output = bench.finish(&format!("stack-{target}"), &mut command)?;
    print!("{output}");
    Ok(())
}

/// Links a probe; whether it did, and what was said.
fn link(bench: &Bench<'_>, target: &str, name: &str) -> Outcome<(bool, String)> {
    let mut cargo = bench.cross.cargo(bench.layout, "build", target);
    cargo.args(["--locked", "--profile", "firmware"]);
    cargo.args(["--package", "microbrdf-probes", "--bin", name]);
    let (status, output) = bench.ended(&format!("probe-{target}-{name}"), &mut cargo)?;
    Ok((status == Some(0), output))
}

fn elf(bench: &Bench<'_>, target: &str, name: &str) -> PathBuf {
    bench
        .layout
        .cross_target()
        .join(target)
        .join("firmware")
        .join(name)
}

/// Whether an image holds one of the ABI's float routines (`__aeabi_f…`, `__aeabi_d…`).
fn has_floats(path: &Path) -> Outcome<bool> {
    let data = fs::read(path).during(|| format!("reading {}", path.display()))?;
    symbols(&data)
        .map(|names| {
            names
                .iter()
                .any(|name| name.starts_with("__aeabi_f") || name.starts_with("__aeabi_d"))
        })
        .map_err(|error| Failure::incomplete(format!("{}: {error}", path.display())))
}

/// Names of all symbols.
fn symbols(data: &[u8]) -> object::read::Result<Vec<String>> {
    let header = FileHeader32::<Endianness>::parse(data)?;
    let endian = header.endian()?;
    let sections = header.sections(endian, data)?;
    let table = sections.symbols(endian, data, object::elf::SHT_SYMTAB)?;
    table
        .iter()
        .map(|symbol| {
            let name = symbol.name(endian, table.strings())?;
            Ok(String::from_utf8_lossy(name).into_owned())
        })
        .collect()
}
