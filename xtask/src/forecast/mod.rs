//! `cargo xtask forecast`: builds and runs small scenes on every board, and
//! finds what single things cost, which `microbrdf budget` adds up.

pub mod held;
mod program;
mod rows;

use std::fs;
use std::path::PathBuf;

use serde_json::{Value, json};

use crate::board::{ARITHMETICS, BOARDS, Board};
use crate::demo;
use crate::failure::{During, Failure, Outcome};
use crate::firmware::{self, Order};
use crate::host_sim::HostSim;
use crate::layout::Layout;
use crate::report;
use crate::toolchain::Cross;
pub use program::Program;
pub use rows::Rows;

/// One of so many rows of a small scene is counted.
const EVERY: usize = 3;

/// What to measure.
#[derive(Debug, Clone, Default)]
pub struct Chosen {
    /// Only this board.
    pub board: Option<String>,
    /// Only this arithmetic.
    pub arithmetic: Option<String>,
}

impl Chosen {
    fn boards(&self) -> Vec<Board> {
        let chosen = |board: &Board| self.board.as_ref().is_none_or(|name| name == board.name);
        BOARDS.into_iter().filter(chosen).collect()
    }

    /// Those asked for, or those that forecasts are for.
    fn arithmetics(&self, board: Board) -> Vec<&'static str> {
        let chosen = |name: &&str| match &self.arithmetic {
            Some(only) => only == name,
            None => held::is_forecast(board, name),
        };
        ARITHMETICS.into_iter().filter(chosen).collect()
    }
}

/// Where everything that is measured lies.
fn folder(layout: &Layout) -> PathBuf {
    layout.target().join("forecast")
}

/// `cargo xtask forecast`.
pub fn command(layout: &Layout, cross: &Cross, chosen: &Chosen) -> Outcome<()> {
    println!("{}", cross.chosen(layout));
    let host = HostSim::build(layout, false)?;
    let program = Program::build(layout, false)?;
    let folder = folder(layout);
    let scenes = program.scenes(&folder.join("scenes"))?;
    let mut boards = Vec::new();
    for board in chosen.boards() {
        let packing = rows::packing(layout, cross, &host, &program, board)?;
        let mut found = Vec::new();
        for arithmetic in chosen.arithmetics(board) {
            for scene in &scenes {
                found.push(of_scene(
                    layout, cross, &host, &program, board, arithmetic, scene,
                )?);
            }
        }
        boards.push(json!({
            "name": board.name,
            "core": board.core,
            "flash": board.flash,
            "ram": board.ram,
            "hz": board.hz,
            "baud": board.baud,
            "packing": packing,
            "scenes": found,
        }));
    }
    let found = json!({ "compiler": cross.version(), "every": EVERY, "boards": boards });
    let path = folder.join("found.json");
    fs::write(&path, format!("{found:#}\n")).during(|| format!("writing {}", path.display()))?;
    program.fit(&path, &layout.at("host-sim/data/forecast.json"))?;
    println!("wrote host-sim/data/forecast.json");
    Ok(())
}

/// Bytes, stack and counted rows of a small scene.
fn of_scene(
    layout: &Layout,
    cross: &Cross,
    host: &HostSim<'_>,
    program: &Program<'_>,
    board: Board,
    arithmetic: &str,
    small: &Value,
) -> Outcome<Value> {
    let text = |field: &str| small[field].as_str().unwrap_or_default();
    let order = Order {
        board,
        scene: PathBuf::from(text("scene")),
        arithmetic: arithmetic.to_owned(),
        features: Vec::new(),
    };
    let (sizes, stack) = if small["stack"] == true {
        let out = folder(layout).join("run");
        let report = demo::run(layout, cross, host, &order, &out, true)?;
        let faults = report::faults(&report);
        if !faults.is_empty() {
            return Err(Failure::incomplete(format!(
                "{}: {}",
                text("name"),
                faults.join("; ")
            )));
        }
        let bytes = |field: &str| report[field].clone();
        (
            [bytes("flash_bytes"), bytes("ram_bytes")],
            bytes("stack_bytes"),
        )
    } else {
        let image = firmware::build(layout, cross, host, &order, true)?;
        println!("{}", firmware::describe(layout, &order, &image));
        (
            [image.sizes.flash.into(), image.sizes.ram.into()],
            Value::Null,
        )
    };
    let counted = Rows {
        scene: order.scene.clone(),
        arithmetic: arithmetic.to_owned(),
        target: board.target,
        every: EVERY,
        picture: None,
    };
    let [flash, ram] = sizes;
    Ok(json!({
        "scene": order.scene,
        "arithmetic": arithmetic,
        "flash": flash,
        "ram": ram,
        "stack": stack,
        "rows": counted.count(layout, cross, program)?,
    }))
}
