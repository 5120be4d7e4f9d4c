//! Evaluates one model many times: what `count_cost` runs under callgrind.
//!
//! `cost MODEL ROUNDS`, for example `cost ward 100`.

use microbrdf_reference::cost::evaluate;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [name, rounds] = arguments.as_slice() else {
        eprintln!("usage: cost MODEL ROUNDS, for example: cost ward 100");
        return ExitCode::from(2);
    };
    let Ok(rounds) = rounds.parse() else {
        eprintln!("ROUNDS = {rounds}: must be a number from 0 to 4294967295");
        return ExitCode::from(2);
    };
    match evaluate(name, rounds) {
        Some(sum) => println!("{sum}"),
        None => {
            eprintln!("MODEL = {name}: no such model (their names are the files of src/models)");
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}
