//! The boards that firmware is built for, each with the emulated machine that stands in for it.

use crate::failure::{Failure, Outcome};

/// One board.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Board {
    /// Name for `--board`; also QEMU's name of the machine.
    pub name: &'static str,
    /// Core, as `report.json` names it.
    pub core: &'static str,
    /// Compiler target made for that core.
    pub target: &'static str,
    /// Whether it has a display of its own, which the emulator can photograph.
    pub panel: bool,
    /// Bytes of flash, as its linker script has them.
    pub flash: u64,
    /// Bytes of RAM.
    pub ram: u64,
    /// Cycles a second, as its firmware sets the clock.
    pub hz: u64,
    /// Bits a second on its serial line.
    pub baud: u64,
}

/// All boards' lines.
const BAUD: u64 = 115_200;

/// Every board, the default one first.
pub const BOARDS: [Board; 3] = [
    Board {
        name: "lm3s6965evb",
        core: "cortex-m3",
        target: "thumbv7m-none-eabi",
        panel: true,
        flash: 256 << 10,
        ram: 64 << 10,
        hz: 8_000_000,
        baud: BAUD,
    },
    Board {
        name: "microbit",
        core: "cortex-m0",
        target: "thumbv6m-none-eabi",
        panel: false,
        flash: 256 << 10,
        ram: 16 << 10,
        hz: 16_000_000,
        baud: BAUD,
    },
    Board {
        name: "netduinoplus2",
        core: "cortex-m4f",
        target: "thumbv7em-none-eabihf",
        panel: false,
        flash: 1024 << 10,
        ram: 128 << 10,
        hz: 16_000_000,
        baud: BAUD,
    },
];

/// Arithmetics that firmware can be built with.
pub const ARITHMETICS: [&str; 4] = ["f32", "micromath", "q31", "q15"];

impl Board {
    /// The board of that name.
    pub fn named(name: &str) -> Outcome<Self> {
        BOARDS
            .into_iter()
            .find(|board| board.name == name)
            .ok_or_else(|| {
                let names = BOARDS.map(|board| board.name).join(", ");
                Failure::mistake(format!("--board {name}: no such board; known are {names}"))
            })
    }

    /// The firmware's cargo feature for this board.
    pub fn feature(&self) -> String {
        format!("board-{}", self.name)
    }

    /// Compiler targets of all boards, each once.
    pub fn targets() -> Vec<&'static str> {
        let mut targets = Vec::new();
        for board in BOARDS {
            if !targets.contains(&board.target) {
                targets.push(board.target);
            }
        }
        targets
    }
}

#[cfg(test)]
mod tests {
    use super::BOARDS;

    /// The size of a region in a linker script.
    fn length(script: &str, region: &str) -> Option<u64> {
        let line = script
            .lines()
            .find(|line| line.split_whitespace().next() == Some(region))?;
        let text = line.split("LENGTH = ").nth(1)?.trim();
        let number: u64 = text[..text.len() - 1].parse().ok()?;
        Some(number << if text.ends_with('M') { 20 } else { 10 })
    }

    /// The number in a source's line that contains `what`.
    fn number(board: &str, file: &str, what: &str) -> Option<u64> {
        let path = format!(
            "{}/../firmware/src/boards/{board}/{file}",
            env!("CARGO_MANIFEST_DIR")
        );
        let source = std::fs::read_to_string(path).ok()?;
        let line = source.lines().find(|line| line.contains(what))?;
        let digits = line.split(what).nth(1)?.replace('_', "");
        let end = digits.find(|c: char| !c.is_ascii_digit());
        digits[..end.unwrap_or(digits.len())].parse().ok()
    }

    #[test]
    fn clocks_and_lines_are_those_of_the_boards() {
        let sources = [
            [("clock.rs", "HZ: u32 = "), ("uart.rs", "BAUD: u32 = ")],
            // The crystal's, as the manual of the nRF51 has it.
            [
                ("mod.rs", "the crystal of "),
                ("uart.rs", "baudrate().baud"),
            ],
            [("mod.rs", "HZ: u32 = "), ("uart.rs", "BAUD: u32 = ")],
        ];
        for (board, [clock, line]) in BOARDS.into_iter().zip(sources) {
            let of = |(file, what)| number(board.name, file, what).unwrap_or(0);
            let mhz = [of(clock), 1_000_000 * of(clock)];
            assert!(mhz.contains(&board.hz), "{}: {mhz:?}", board.name);
            assert_eq!(of(line), board.baud, "{}", board.name);
        }
    }

    #[test]
    fn sizes_are_those_of_the_linker_scripts() {
        let root = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
        let default = std::fs::read_to_string(format!("{root}/memory.x")).unwrap();
        for board in BOARDS {
            let path = format!("{root}/firmware/src/boards/{}/board.x", board.name);
            let own = std::fs::read_to_string(path).unwrap();
            let of = |region, other| length(&own, region).or_else(|| length(&default, other));
            assert_eq!(
                of("FLASH", "LM3S6965_FLASH"),
                Some(board.flash),
                "{}",
                board.name
            );
            assert_eq!(
                of("RAM", "LM3S6965_SRAM"),
                Some(board.ram),
                "{}",
                board.name
            );
        }
    }
}
