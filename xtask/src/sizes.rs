//! How much flash and RAM a linked image takes, and what its symbols are.

use std::fs;
use std::path::Path;

use object::Endianness;
use object::elf::{FileHeader32, PT_LOAD, SHT_SYMTAB};
use object::read::elf::{FileHeader, ProgramHeader, Sym};

use crate::failure::{During, Failure, Outcome};

/// Where RAM begins on every Cortex-M.
const RAM: u32 = 0x2000_0000;

/// Bytes of an image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Sizes {
    /// What is written to flash: code, constants, and the initial values of variables.
    pub flash: u64,
    /// Variables with a fixed place in RAM; the stack is not in it.
    pub ram: u64,
}

/// Reads the sizes of an ELF file for a 32-bit microcontroller.
pub fn of(path: &Path) -> Outcome<Sizes> {
    let data = fs::read(path).during(|| format!("reading {}", path.display()))?;
    read(&data).map_err(|e| Failure::incomplete(format!("{}: {e}", path.display())))
}

fn read(data: &[u8]) -> object::read::Result<Sizes> {
    let header = FileHeader32::<Endianness>::parse(data)?;
    let endian = header.endian()?;
    let mut sizes = Sizes::default();
    for segment in header.program_headers(endian, data)? {
        if segment.p_type(endian) != PT_LOAD {
            continue;
        }
        sizes.flash += u64::from(segment.p_filesz(endian));
        if segment.p_vaddr(endian) >= RAM {
            sizes.ram += u64::from(segment.p_memsz(endian));
        }
    }
    Ok(sizes)
}

/// Names of an image's symbols, with their values.
pub fn symbols(path: &Path) -> Outcome<Vec<(String, u32)>> {
    let data = fs::read(path).during(|| format!("reading {}", path.display()))?;
    read_symbols(&data).map_err(|e| Failure::incomplete(format!("{}: {e}", path.display())))
}

fn read_symbols(data: &[u8]) -> object::read::Result<Vec<(String, u32)>> {
    let header = FileHeader32::<Endianness>::parse(data)?;
    let endian = header.endian()?;
    let table = header
        .sections(endian, data)?
        .symbols(endian, data, SHT_SYMTAB)?;
    let named = |symbol: &object::elf::Sym32<Endianness>| {
        let name = table.symbol_name(endian, symbol)?;
        let name = String::from_utf8_lossy(name).into_owned();
        Ok((name, symbol.st_value(endian)))
    };
    table.iter().map(named).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An ELF header with three loaded segments: code, variables with initial values, variables without.
    fn image() -> Vec<u8> {
        let mut data = vec![0x7f, b'E', b'L', b'F', 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0];
        let half = |data: &mut Vec<u8>, value: u16| data.extend(value.to_le_bytes());
        let word = |data: &mut Vec<u8>, value: u32| data.extend(value.to_le_bytes());
        half(&mut data, 2); // executable
        half(&mut data, 40); // Arm
        for value in [1, 0, 52, 0, 0] {
            word(&mut data, value); // version, entry, program headers, sections, flags
        }
        for value in [52, 32, 3, 40, 0, 0] {
            half(&mut data, value); // header sizes and counts
        }
        for (address, file, memory) in [
            (0, 1000, 1000),
            (0x2000_0000, 24, 24),
            (0x2000_0018, 0, 512),
        ] {
            for value in [1, 0, address, address, file, memory, 5, 4] {
                word(&mut data, value);
            }
        }
        data
    }

    #[test]
    fn flash_holds_initial_values_and_ram_what_varies() {
        assert_eq!(
            read(&image()).unwrap(),
            Sizes {
                flash: 1024,
                ram: 536
            }
        );
    }

    #[test]
    fn nonsense_is_an_error() {
        assert!(read(b"not an image").is_err());
    }
}
