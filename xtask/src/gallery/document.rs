//! `docs/gallery.md`.

use std::fmt::Write as _;

use serde_json::Value;

use super::Shown;

const HEAD: &str = "# Gallery

Made by `cargo xtask gallery`; `cargo xtask test --only gallery` makes every picture and figure anew and fails when one differs (flash and cycles by more than 1 %, for an image holds the paths of its crates; stack by more than 10 %, for an interrupt may strike where it is deepest, or not). Cycles are estimates, counted over one of 32 rows on an emulated core; beside them stands what `microbrdf budget` forecasts for the same rows from parts of other scenes ([budget.md](budget.md)), which may be off by 5 % in flash and RAM and by 15 % in cycles and stack.

Each scene, in `scenes/gallery` or `scenes`, is built into firmware, run on emulated boards and received. Side by side: as the device sent it, byte for byte what the host renders (a run in which it is not fails); in double precision; and the errors, black where the 8-bit code is that of the reference, blue one off, yellow two, red more, magenta on the other side of a jump. Errors are of 8-bit sRGB codes, `by more` and flips as [conventions.md](conventions.md) has them.

Pictures of the thesis that need light from other surfaces, its figures 3.9 to 3.11, can't be made: there is no interreflection here, and no such thing is shown.

## The test card

What no scene shows: `microbrdf chart --arithmetic q15`, whose pixels are pairs of directions. On a sphere of 50 pixels the lobe of n = 1e5 lights none; here each lobe is as wide as its band. Columns are τ from -12 to 12, in the plane of incidence and sideways; rows are the larger cosine from 1 down to 1e-8; value and error side by side. q15's directions are coarse, so its bands at grazing are what [accuracy.md](accuracy.md) says.

![The test card of q15](gallery/chart.png)
";

/// The whole document.
pub fn markdown(shown: &[Shown], compiler: &str) -> String {
    let mut text = format!("{HEAD}\nCompiler: {compiler}.\n");
    for shown in shown {
        let _ = write!(text, "\n{}", section(shown));
    }
    text
}

/// An exhibit's heading, words, picture and figures.
pub fn section(shown: &Shown) -> String {
    let exhibit = shown.exhibit;
    let mut text = format!(
        "## {}\n\n{}\n\n![{}](gallery/{}.png)\n\n\
         | board | arithmetic | greatest error in LSB | off by one | by more | flips | ΔE00, 95th percentile | greatest | flash | RAM | stack | cycles a pixel | forecast: flash | RAM | stack | cycles |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        exhibit.title, exhibit.words, exhibit.title, exhibit.name
    );
    for report in &shown.reports {
        let _ = writeln!(text, "{}", row(report));
    }
    text
}

fn row(report: &Value) -> String {
    let number = |field: &str| report[field].as_f64().unwrap_or(f64::NAN);
    let percent = |field: &str| format!("{:.2} %", 100.0 * number(field));
    let cells = [
        report["board"].as_str().unwrap_or_default().to_owned(),
        format!("`{}`", report["arithmetic"].as_str().unwrap_or_default()),
        format!("{:.2}", number("lsb_error_max")),
        percent("code_error_share"),
        percent("code_error_over_one_share"),
        report["class_flips"].to_string(),
        format!("{:.2}", number("delta_e_p95")),
        format!("{:.2}", number("delta_e_max")),
        report["flash_bytes"].to_string(),
        report["ram_bytes"].to_string(),
        report["stack_bytes"].to_string(),
        format!("{:.0}", number("cycles_per_pixel")),
        report["forecast"]["flash_bytes"].to_string(),
        report["forecast"]["ram_bytes"].to_string(),
        report["forecast"]["stack_bytes"].to_string(),
        format!(
            "{:.0}",
            report["forecast"]["cycles_per_pixel"]
                .as_f64()
                .unwrap_or(f64::NAN)
        ),
    ];
    format!("| {} |", cells.join(" | "))
}

/// Columns that may be off by a share, counted from the left edge. Flash: images hold the paths of crates, which each machine has elsewhere. Stack: the line's interrupt may strike where it is deepest, or not. Cycles: code may lie otherwise in such images.
const LOOSE: [(usize, f64); 3] = [(9, 0.01), (11, 0.1), (12, 0.01)];

/// Whether a document has a section, but for a little flash and stack.
pub fn has(text: &str, section: &str) -> bool {
    let wanted: Vec<&str> = section.lines().collect();
    let lines: Vec<&str> = text.lines().collect();
    lines
        .windows(wanted.len().max(1))
        .any(|window| window.iter().zip(&wanted).all(|(a, b)| same_line(a, b)))
}

fn same_line(kept: &str, made: &str) -> bool {
    let (kept, made): (Vec<&str>, Vec<&str>) =
        (kept.split('|').collect(), made.split('|').collect());
    let same_cell = |(column, (a, b)): (usize, (&&str, &&str))| {
        let bytes = |cell: &str| cell.trim().parse::<f64>();
        match (bytes(a), bytes(b)) {
            (Ok(a), Ok(b)) => {
                let loose = LOOSE.iter().find(|(loose, _)| *loose == column);
                (a - b).abs() <= loose.map_or(0.0, |(_, share)| share * a)
            }
            _ => a == b,
        }
    };
    kept.len() == made.len() && kept.iter().zip(&made).enumerate().all(same_cell)
}

#[cfg(test)]
mod tests {
    use super::has;

    const SECTION: &str = "## A\n\n| b | q31 | 0.5 | 1 % | 0 % | 0 | 0.1 | 1.0 | 50000 | 2848 | 1500 | 700 | 51000 | 2848 | 1490 | 710 |\n";

    #[test]
    fn flash_stack_and_cycles_may_differ_a_little_and_nothing_else() {
        let text = format!("# Gallery\n{SECTION}\n## B\n");
        assert!(has(&text, SECTION));
        assert!(has(&text, &SECTION.replace("50000", "50400")));
        assert!(!has(&text, &SECTION.replace("50000", "51000")));
        assert!(has(&text, &SECTION.replace("1500", "1640")));
        assert!(!has(&text, &SECTION.replace("1500", "1700")));
        assert!(!has(&text, &SECTION.replace("2848", "2852")));
        assert!(has(&text, &SECTION.replace("700", "706")));
        assert!(!has(&text, &SECTION.replace("700", "720")));
        assert!(!has(&text, &SECTION.replace("710", "711")));
        assert!(!has(&text, &SECTION.replace("0.5", "0.6")));
        assert!(!has(&text, &SECTION.replace("## A", "## C")));
    }
}
