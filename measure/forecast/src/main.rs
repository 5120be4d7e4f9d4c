//! The command that `cargo xtask forecast` calls.

mod calls;
mod fitting;
mod scenes;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::{Parser, Subcommand};
use serde::Serialize;
use serde_json::json;

/// Small scenes, the rows to count of a scene, and costs from what was found.
#[derive(Parser)]
#[command(
    version,
    after_help = "Example: microbrdf-forecast calls scenes/demo.toml --arithmetic q15 -o calls.json"
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Write the small scenes into a folder, and print a list of them
    Scenes {
        /// Folder
        #[arg(short)]
        output: PathBuf,
    },
    /// Write the rows of a scene that an emulated core is to shade
    Calls {
        /// Scene file
        scene: PathBuf,
        /// How it is computed
        #[arg(long)]
        arithmetic: String,
        /// One of so many rows
        #[arg(long, default_value_t = 4)]
        every: usize,
        /// The scene's picture, if there is one already
        #[arg(long)]
        picture: Option<PathBuf>,
        /// File to write
        #[arg(short)]
        output: PathBuf,
    },
    /// Write the calls that tell what packing takes
    Packing {
        /// File to write
        #[arg(short)]
        output: PathBuf,
    },
    /// Compute what single things cost
    Fit {
        /// What `cargo xtask forecast` found
        found: PathBuf,
        /// Print how far off each small scene is
        #[arg(long)]
        each: bool,
        /// File to write
        #[arg(short)]
        output: PathBuf,
    },
}

fn main() -> ExitCode {
    match run(Arguments::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(1)
        }
    }
}

fn run(command: Command) -> Result<()> {
    match command {
        Command::Scenes { output } => {
            fs::create_dir_all(&output)?;
            fs::write(output.join("mesh.obj"), scenes::MESH)?;
            let mut list = Vec::new();
            for small in scenes::all() {
                // No other scene's files may be taken for this one's.
                let path = output.join(format!("small-{}.toml", small.name));
                fs::write(&path, small.text)?;
                list.push(json!({ "name": small.name, "scene": path, "stack": small.stack }));
            }
            println!("{}", serde_json::Value::Array(list));
            Ok(())
        }
        Command::Calls {
            scene,
            arithmetic,
            every,
            picture,
            output,
        } => {
            let picture = match picture {
                Some(path) => calls::picture_in(&path)?,
                None => calls::picture_of(&scene, &arithmetic)?,
            };
            write(&output, &calls::of_picture(&picture, every))
        }
        Command::Packing { output } => write(&output, &calls::of_packing()),
        Command::Fit {
            found,
            each,
            output,
        } => {
            let text = fs::read(&found).with_context(|| found.display().to_string())?;
            let fresh = fitting::fitted(&serde_json::from_slice(&text)?, each)?;
            // Of what was not measured now the file keeps what it has.
            let kept = fs::read(&output).ok();
            let kept = kept.and_then(|text| serde_json::from_slice(&text).ok());
            write(&output, &fitting::merged(kept.unwrap_or_default(), fresh))
        }
    }
}

fn write(path: &Path, value: &impl Serialize) -> Result<()> {
    let text = serde_json::to_string_pretty(value)?;
    fs::write(path, text + "\n").with_context(|| path.display().to_string())
}
