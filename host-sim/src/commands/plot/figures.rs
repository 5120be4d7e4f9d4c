//! `microbrdf plot --figure`.

use std::fs;
use std::path::{Path, PathBuf};

use microbrdf_reference::figures::{self, Figure};
use rayon::prelude::*;

use crate::cli::Plot;
use crate::commands::print;
use crate::drawing::{self, Format, Sheet};
use crate::exit::{Failure, Outcome};
use crate::progress::Progress;

/// Draws one figure, or all of them.
pub fn run(arguments: &Plot, number: &str) -> Outcome<()> {
    if number == "all" {
        let Some(folder) = &arguments.out else {
            return Err(Failure::Usage(
                "--figure all: needs --out, a folder for the files".to_owned(),
            ));
        };
        return all(folder, &arguments.format);
    }
    let Some(output) = &arguments.output else {
        return Err(Failure::Usage(format!(
            "--figure {number}: needs -o, the file to write"
        )));
    };
    let format = Format::of(output, "-o")?;
    draw(&compute(number)?, &[(format, output.clone())])?;
    Ok(())
}

fn all(folder: &Path, formats: &[Format]) -> Outcome<()> {
    fs::create_dir_all(folder)
        .map_err(|error| Failure::Usage(format!("--out {}: {error}", folder.display())))?;
    let numbers: Vec<_> = figures::known().collect();
    let progress = Progress::new("figures", numbers.len());
    let computed: Vec<_> = numbers
        .par_iter()
        .map(|number| {
            let figure = compute(number);
            progress.step();
            figure
        })
        .collect::<Outcome<_>>()?;
    drop(progress);
    for figure in &computed {
        let files = formats.iter().map(|&format| {
            let name = format!("figure-{}.{}", figure.number, format.extension());
            (format, folder.join(name))
        });
        draw(figure, &files.collect::<Vec<_>>())?;
    }
    Ok(())
}

fn compute(number: &str) -> Outcome<Figure> {
    let figure = figures::figure(number).ok_or_else(|| {
        let known: Vec<_> = figures::known().collect();
        Failure::Usage(format!(
            "--figure {number}: must be one of {}, or all (the thesis' other figures are \
             sketches and renderings)",
            known.join(", ")
        ))
    })?;
    figure.map_err(|error| Failure::Incomplete(format!("--figure {number}: {error}")))
}

/// Writes the files, and prints what they show and what they leave out.
fn draw(figure: &Figure, files: &[(Format, PathBuf)]) -> Outcome<()> {
    let title = format!("Figure {}: {}", figure.number, figure.title);
    let sheet = Sheet {
        title: &title,
        notes: &figure.notes,
        panels: &figure.panels,
    };
    for (format, path) in files {
        drawing::write(&sheet, *format, path)?;
    }
    let paths = files.iter().map(|(_, path)| path.display().to_string());
    let lines: Vec<_> = figure.notes.iter().cloned().chain(paths).collect();
    print(&format!("{title}\n  {}\n", lines.join("\n  ")))
}
