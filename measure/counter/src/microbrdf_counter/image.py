"""A linked image: what is loaded where, which part of it is code, and how big it is."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from elftools.elf.elffile import ELFFile
from elftools.elf.sections import SymbolTableSection

_ALLOCATED = 0x2
_WRITABLE = 0x1
_EXECUTABLE = 0x4


@dataclass(frozen=True)
class Image:
    """An ELF image for a 32-bit microcontroller.

    Attributes:
        entry: Address of the function that it was linked for, without the Thumb bit.
        segments: Address and contents of everything that is loaded.
        code: Ranges that hold instructions, constants between functions left out.
        code_bytes: Size of the executable sections, constants between functions included.
        table_bytes: Size of constant data.
        ram_bytes: Size of what varies and has a fixed place.
    """

    entry: int
    segments: list[tuple[int, bytes]]
    code: list[tuple[int, int]]
    code_bytes: int
    table_bytes: int
    ram_bytes: int

    @classmethod
    def read(cls, path: Path) -> Image:
        """Reads an ELF file."""
        with path.open("rb") as file:
            elf = ELFFile(file)
            segments: list[tuple[int, bytes]] = []
            executable: list[tuple[int, int]] = []
            sizes = {"code": 0, "table": 0, "ram": 0}
            for section in elf.iter_sections():
                flags = section["sh_flags"]
                size = section["sh_size"]
                if not flags & _ALLOCATED or size == 0:
                    continue
                address = section["sh_addr"]
                if section["sh_type"] != "SHT_NOBITS":
                    segments.append((address, section.data()))
                if flags & _EXECUTABLE:
                    sizes["code"] += size
                    executable.append((address, address + size))
                elif flags & _WRITABLE:
                    sizes["ram"] += size
                else:
                    sizes["table"] += size
            return cls(
                # On Arm the lowest bit only says that Thumb code is there.
                entry=elf["e_entry"] & ~1,
                segments=segments,
                code=_code(elf, executable),
                code_bytes=sizes["code"],
                table_bytes=sizes["table"],
                ram_bytes=sizes["ram"],
            )


def _code(elf: ELFFile, executable: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """The parts of executable sections that mapping symbols call Thumb code."""
    marks: dict[int, str] = {}
    for table in elf.iter_sections():
        if not isinstance(table, SymbolTableSection):
            continue
        for symbol in table.iter_symbols():
            kind = symbol.name.split(".")[0]
            if kind in ("$t", "$d", "$a"):
                marks[symbol["st_value"]] = kind
    ranges = []
    for low, high in executable:
        inside = sorted(address for address in marks if low <= address < high)
        for address, following in zip(inside, [*inside[1:], high]):
            if marks[address] == "$t":
                ranges.append((address, following))
    return ranges
