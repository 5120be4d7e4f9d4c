//! How much of its stack an emulated board uses.
//!
//! Before the image starts, all RAM that the linker leaves to the stack is filled with a pattern; what no longer holds it has been used. The image itself is not changed for it.

use std::fs;
use std::path::{Path, PathBuf};

use crate::failure::{During, Failure, Outcome};
use crate::sizes;

/// What untouched bytes hold.
const PATTERN: u8 = 0xC5;

/// The RAM of an image's stack.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stack {
    /// Its lowest address.
    pub end: u32,
    /// Its size in bytes.
    pub size: u32,
    /// Where the image begins to run.
    entry: u32,
}

impl Stack {
    /// That of an image, by the symbols of cortex-m-rt's linker script.
    pub fn of(elf: &Path) -> Outcome<Self> {
        let symbols = sizes::symbols(elf)?;
        let value = |wanted: &str| {
            let symbol = symbols.iter().find(|(name, _)| name == wanted);
            symbol.map(|(_, value)| *value).ok_or_else(|| {
                Failure::incomplete(format!("{}: no symbol {wanted}", elf.display()))
            })
        };
        let (start, end) = (value("_stack_start")?, value("_stack_end")?);
        Ok(Self {
            end,
            size: start.saturating_sub(end),
            entry: value("Reset")?,
        })
    }

    /// Writes a file that fills it, and returns QEMU's devices that load the file.
    pub fn filled(&self, elf: &Path) -> Outcome<[String; 2]> {
        let path: PathBuf = elf.with_extension("stack");
        fs::write(&path, vec![PATTERN; self.size as usize])
            .during(|| format!("writing {}", path.display()))?;
        // Only as the processor sees it is RAM at this address on every board; but then what is
        // loaded is also where the processor begins, which the second loader puts right.
        Ok([
            format!(
                "loader,file={},addr={:#x},force-raw=on,cpu-num=0",
                path.display(),
                self.end
            ),
            format!("loader,addr={:#x},cpu-num=0", self.entry),
        ])
    }

    /// Bytes that were used, from what its RAM holds afterwards.
    pub fn used(memory: &[u8]) -> usize {
        let untouched = memory.iter().take_while(|byte| **byte == PATTERN);
        memory.len() - untouched.count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn used_is_what_lies_above_the_lowest_change() {
        let mut memory = [PATTERN; 64];
        assert_eq!(Stack::used(&memory), 0);
        memory[60] = 1;
        assert_eq!(Stack::used(&memory), 4);
        memory[10] = 0;
        assert_eq!(Stack::used(&memory), 54);
        assert_eq!(Stack::used(&[]), 0);
    }
}
