//! Mistakes that a user makes: each is refused with its file, line or option, its value and what is accepted, and leaves nothing half-written.

use std::fs;
use std::net::TcpListener;
use std::path::Path;
use std::process::Command;

use super::counts::Tally;
use super::{Bench, Step, step};
use crate::failure::{During, Failure, Outcome};
use crate::host_sim::HostSim;

/// A scene without mistakes, of which each case spoils one line.
const SCENE: &str = r#"exposure = 1.0
[camera]
width = 8
height = 4
eye = [0, -5, 1]
target = [0, 0, 0]
fov = 40
[[light]]
kind = "directional"
direction = [0, -1, 1]
color = [1, 1, 1]
[[sphere]]
center = [0, 0, 0]
radius = 1
material = "it"
[material.it]
"#;

/// A material of each model that a case spoils.
const PHONG: &str = "model = \"metallic-phong\"\nexponent = 20\n";
const PATCH: &str = "model = \"patch\"\nradius = 1.25\n";
const METAL: &str =
    "model = \"metal\"\nexponent = 50\neta = [0.2, 0.4, 1.5]\nk = [3.9, 2.4, 1.9]\n";

/// One mistake in a scene.
struct Mistake {
    name: &'static str,
    /// The material, then what of the whole text is replaced by what.
    material: &'static str,
    from: &'static str,
    to: &'static str,
    /// What the message has to name.
    names: &'static [&'static str],
}

/// `names`: field, value, and what would be accepted.
const MISTAKES: [Mistake; 8] = [
    Mistake {
        name: "unknown model",
        material: PHONG,
        from: "metallic-phong",
        to: "velvet",
        names: &["model", "velvet", "metallic-phong"],
    },
    Mistake {
        name: "misspelt field",
        material: PHONG,
        from: "exponent =",
        to: "exponnent =",
        names: &["exponnent", "exponent"],
    },
    Mistake {
        name: "exponent NaN",
        material: PHONG,
        from: "exponent = 20",
        to: "exponent = nan",
        names: &["exponent", "nan"],
    },
    Mistake {
        name: "exponent negative",
        material: PHONG,
        from: "exponent = 20",
        to: "exponent = -3",
        names: &["exponent", "-3"],
    },
    Mistake {
        name: "radius above 2",
        material: PATCH,
        from: "radius = 1.25",
        to: "radius = 2.5",
        names: &["radius", "2.5", "2"],
    },
    Mistake {
        name: "eta of two entries",
        material: METAL,
        from: "[0.2, 0.4, 1.5]",
        to: "[0.2, 0.4]",
        names: &["eta", "2", "three"],
    },
    Mistake {
        name: "image of zero width",
        material: PHONG,
        from: "width = 8",
        to: "width = 0",
        names: &["width", "0", "1"],
    },
    Mistake {
        name: "not TOML",
        material: PHONG,
        from: "[camera]",
        to: "[camera",
        names: &["]"],
    },
];

/// Every step.
pub fn steps() -> Vec<Step> {
    vec![
        step("bad input, scenes", scenes),
        step("bad input, files", files),
        step("bad input, ports", ports),
    ]
}

/// Each mistake, through the command that renders; and the scene without a mistake, which must pass.
fn scenes(bench: &Bench<'_>) -> Outcome<Tally> {
    let host = HostSim::build(bench.layout, true)?;
    let folder = bench.layout.target().join("test").join("bad-input");
    fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
    let mut tally = Tally::default();
    for material in [PHONG, PATCH, METAL] {
        let (status, said, made) = render(bench, &host, &folder, "good", &text(material))?;
        if status != Some(0) || !made {
            return Err(Failure::incomplete(format!(
                "a scene without a mistake is refused ({status:?}): {said}"
            )));
        }
        tally += Tally::PASSED;
    }
    for mistake in &MISTAKES {
        let good = text(mistake.material);
        let bad = good.replacen(mistake.from, mistake.to, 1);
        let line = 1 + good
            .lines()
            .zip(bad.lines())
            .take_while(|(good, bad)| good == bad)
            .count();
        let (status, said, made) = render(bench, &host, &folder, "bad", &bad)?;
        let mut faults = refusal(status, 2, &said, mistake.names);
        if !said.contains(&format!("bad.toml:{line}")) {
            faults.push(format!("does not name line {line}"));
        }
        if made {
            faults.push("a picture was written all the same".into());
        }
        tally += judge(mistake.name, &faults, &said);
    }
    Ok(tally)
}

/// The scene with a material.
fn text(material: &str) -> String {
    format!("{SCENE}{material}")
}

/// Renders a text and returns exit status, messages, and whether a picture was made.
fn render(
    bench: &Bench<'_>,
    host: &HostSim<'_>,
    folder: &Path,
    name: &str,
    text: &str,
) -> Outcome<(Option<i32>, String, bool)> {
    let (scene, picture) = (
        folder.join(format!("{name}.toml")),
        folder.join(format!("{name}.png")),
    );
    fs::write(&scene, text).during(|| format!("writing {}", scene.display()))?;
    let _ = fs::remove_file(&picture);
    let mut command = host.command([
        "render".as_ref(),
        scene.as_os_str(),
        "--arithmetic".as_ref(),
        "f32".as_ref(),
        "-o".as_ref(),
        picture.as_os_str(),
    ]);
    let (status, said) = bench.ended(&format!("bad-input-{name}"), &mut command)?;
    Ok((status, said, picture.exists()))
}

/// Files and options of the project's own commands.
fn files(bench: &Bench<'_>) -> Outcome<Tally> {
    let host = HostSim::build(bench.layout, true)?;
    let out = bench.layout.target().join("test").join("bad-input-demo");
    let _ = fs::remove_dir_all(&out);
    let this = std::env::current_exe().during(|| "asking for this program".to_string())?;
    let xtask = |arguments: &[&str]| {
        let mut command = Command::new(&this);
        command
            .current_dir(bench.layout.root())
            .args(arguments)
            .arg("--out")
            .arg(&out);
        command
    };
    let mut tally = Tally::default();
    for (name, mut command, names) in [
        (
            "render: no such scene",
            host.command([
                "render",
                "no-such.toml",
                "--arithmetic",
                "f32",
                "-o",
                "no-such.png",
            ]),
            &["no-such.toml"][..],
        ),
        (
            "render: no such arithmetic",
            host.command([
                "render",
                "scenes/demo.toml",
                "--arithmetic",
                "f16",
                "-o",
                "no.png",
            ]),
            &["f16", "f32", "q31"],
        ),
        (
            "demo: no such scene",
            xtask(&["demo", "--scene", "no-such.toml"]),
            &["--scene", "no-such.toml"],
        ),
        (
            "demo: no such board",
            xtask(&["demo", "--board", "abacus"]),
            &["--board", "abacus", "microbit"],
        ),
        (
            "demo: no such arithmetic",
            xtask(&["demo", "--arithmetic", "f16"]),
            &["--arithmetic", "f16", "q31"],
        ),
    ] {
        let (status, said) = bench.ended("bad-input-files", &mut command)?;
        let mut faults = refusal(status, 2, &said, names);
        if out.exists() || bench.layout.at("no-such.png").exists() {
            faults.push("something was written all the same".into());
        }
        tally += judge(name, &faults, &said);
    }
    Ok(tally)
}

/// Ports that are not there, and one that nothing comes out of.
fn ports(bench: &Bench<'_>) -> Outcome<Tally> {
    let picture = bench.layout.target().join("test").join("no-port.png");
    let _ = fs::remove_file(&picture);
    let mut tally = Tally::default();
    for port in ["/dev/no-such-port", "nonsense://here"] {
        let mut command = Command::new(bench.layout.venv_program("microbrdf-receive"));
        command.arg(port).arg("-o").arg(&picture);
        let (status, said) = bench.ended("bad-input-ports", &mut command)?;
        let mut faults = refusal(status, 2, &said, &[port]);
        if picture.exists() {
            faults.push("a picture was written all the same".into());
        }
        tally += judge(port, &faults, &said);
    }
    // Connections wait in the listener's queue: open, and silent.
    let silent = TcpListener::bind("127.0.0.1:0").during(|| "opening a silent port".to_string())?;
    let address = silent
        .local_addr()
        .during(|| "asking for the silent port".to_string())?;
    let mut command = Command::new(bench.layout.venv_program("microbrdf-receive"));
    command
        .arg(format!("socket://{address}"))
        .arg("-o")
        .arg(&picture)
        .args(["--timeout", "1"]);
    let (status, said) = bench.ended("bad-input-ports", &mut command)?;
    let mut faults = refusal(status, 1, &said, &["1"]);
    if picture.exists() {
        faults.push("a picture was written of nothing".into());
    }
    tally += judge("silent port", &faults, &said);
    Ok(tally)
}

/// What a refusal lacks.
fn refusal(status: Option<i32>, expected: i32, said: &str, names: &[&str]) -> Vec<String> {
    let mut faults = Vec::new();
    if status != Some(expected) {
        faults.push(format!("exit status is {status:?}, not {expected}"));
    }
    for name in names {
        if !said.contains(name) {
            faults.push(format!("does not name {name:?}"));
        }
    }
    for word in ["panicked", "Traceback"] {
        if said.contains(word) {
            faults.push(format!("shows a {word:?}"));
        }
    }
    faults
}

fn judge(name: &str, faults: &[String], said: &str) -> Tally {
    if faults.is_empty() {
        return Tally::PASSED;
    }
    println!("{name}: {}\n  it said: {}", faults.join("; "), said.trim());
    Tally {
        passed: 0,
        failed: 1,
        skipped: 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_mistake_changes_its_scene() {
        for mistake in &MISTAKES {
            let good = text(mistake.material);
            assert_ne!(
                good,
                good.replacen(mistake.from, mistake.to, 1),
                "{}",
                mistake.name
            );
        }
    }

    #[test]
    fn a_refusal_needs_status_names_and_manners() {
        let said = "scene.toml:3: width = 0 must be 1 to 4096";
        assert!(refusal(Some(2), 2, said, &["width", "0", "1"]).is_empty());
        assert_eq!(refusal(Some(1), 2, said, &["width"]).len(), 1);
        assert_eq!(refusal(None, 2, said, &["width"]).len(), 1);
        assert_eq!(refusal(Some(2), 2, said, &["height"]).len(), 1);
        assert_eq!(
            refusal(Some(2), 2, "thread 'main' panicked at", &[]).len(),
            1
        );
    }
}
