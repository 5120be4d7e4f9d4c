"""The command ``microbrdf-stack``: a bound on the stack of a program, from its image.

A function's frame is taken as the sum of all that it moves the stack pointer down by, which is
a bound as long as no loop does so; a tail call counts as a call. The bound is that of the way
through the calls with the largest sum. What can't be bounded, a recursion, a call through a
pointer, a move by a number that is not constant, is an error.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import capstone
from elftools.elf.elffile import ELFFile
from elftools.elf.sections import SymbolTableSection

from microbrdf_counter.image import Image

_EXAMPLE = "Example: microbrdf-stack target/cross/thumbv6m-none-eabi/firmware/q31"
_STATUSES = "Exit status: 0 all are bounded; 1 one is not; 2 a file can't be read."
#: Registers that take part in an address or a return, by what capstone calls them.
_RISCV_RETURN = ("c.jr ra", "ret", "jr ra", "jalr zero, ra", "jalr zero, 0(ra)")


#: A number among operands.
_INTEGER = re.compile(r"#-?(0x[0-9a-f]+|[0-9]+)")


class Unbounded(Exception):
    """There is no bound, or none that can be seen."""


@dataclass
class Function:
    """A function.

    Attributes:
        frame: Bytes that it moves the stack pointer down by, at most.
        calls: Addresses of what it calls.
    """

    frame: int = 0
    calls: set[int] = field(default_factory=set)


def deepest(functions: dict[int, Function], entry: int) -> int:
    """Bytes of stack below the stack pointer at the call of ``entry``.

    Raises:
        Unbounded: It calls itself, by whatever way, or what is no function.
    """
    found: dict[int, int] = {}
    open_calls: set[int] = set()

    def of(address: int) -> int:
        if address in open_calls:
            raise Unbounded(f"the function at {address:#x} calls itself")
        if address not in functions:
            raise Unbounded(f"what is called at {address:#x} is no function")
        if address not in found:
            open_calls.add(address)
            function = functions[address]
            found[address] = function.frame + max(map(of, function.calls), default=0)
            open_calls.remove(address)
        return found[address]

    return of(entry)


def thumb(pieces: list[tuple[int, bytes]], image: Image) -> Function:
    """A function of Thumb code, in the pieces that the constants within it leave."""
    literals: dict[str, int] = {}
    scan = _Scan(pieces)
    reader = capstone.Cs(capstone.CS_ARCH_ARM, capstone.CS_MODE_THUMB | capstone.CS_MODE_MCLASS)
    for raw in _disassembled(reader, pieces):
        name = raw.mnemonic.split(".")[0]
        operands = [part.strip() for part in raw.op_str.strip("{}").split(",")]
        first = operands[0]
        numbers = [int(part[1:], 0) for part in operands if _INTEGER.fullmatch(part)]
        if name == "push":
            scan.down(raw, 4 * len(operands))
        elif name == "vpush":
            scan.down(raw, sum(8 if part.startswith("d") else 4 for part in operands))
        elif name in ("sub", "subw") and first == "sp":
            scan.down(raw, numbers[-1] if numbers else None)
        elif name in ("add", "addw") and first == "sp" and not numbers:
            moved = literals.get(operands[-1])
            scan.down(raw, None if moved is None else max(0, -moved))
        elif name.startswith(("stmdb", "vstmdb", "str", "strd")) and raw.op_str.endswith("!"):
            if "[sp" in raw.op_str or first == "sp!":
                moved = raw.op_str.rstrip("]!").partition("#")[2]
                scan.down(raw, -int(moved, 0) if moved else 4 * len(operands))
        elif name == "ldr" and "[pc" in raw.op_str and first != "pc":
            at = ((raw.address + 4) & ~3) + int(raw.op_str.split("#")[-1].rstrip("]"), 0)
            literals[first] = _word(image, at)
        elif name == "bl" or (name[0] == "b" and first.startswith("#")):
            scan.goes(raw, numbers[0], name == "bl")
        elif name in ("cbz", "cbnz"):
            scan.goes(raw, numbers[-1], False)
        elif name in ("bx", "blx") and first != "lr":
            raise Unbounded(f"`{raw.mnemonic} {raw.op_str}` at {raw.address:#x} goes anywhere")
    return scan.done()


def riscv(pieces: list[tuple[int, bytes]]) -> Function:
    """A function of RISC-V code."""
    scan = _Scan(pieces)
    constants: dict[str, int] = {}
    reader = capstone.Cs(capstone.CS_ARCH_RISCV, capstone.CS_MODE_RISCV32 | capstone.CS_MODE_RISCVC)
    for raw in _disassembled(reader, pieces):
        name = raw.mnemonic.removeprefix("c.")
        operands = [part.strip() for part in raw.op_str.replace("(", ", ").rstrip(")").split(",")]
        numbers = [int(part, 0) for part in operands if part.lstrip("-")[:1].isdigit()]
        first = operands[0]
        if name in ("addi", "addi16sp") and first == "sp":
            scan.down(raw, max(0, -numbers[-1]))
        elif name == "sub" and first == "sp":
            scan.down(raw, constants.get(operands[-1]))
        elif name == "auipc":
            constants[first] = raw.address + (numbers[-1] << 12)
        elif name in ("lui", "li"):
            constants[first] = numbers[-1] << 12 if name == "lui" else numbers[-1]
        elif name == "addi" and operands[-2] in constants:
            constants[first] = constants[operands[-2]] + numbers[-1]
        elif name in ("jal", "j"):
            scan.goes(raw, raw.address + numbers[-1], name == "jal")
        elif name in ("jalr", "jr"):
            if f"{raw.mnemonic} {raw.op_str}" in _RISCV_RETURN or operands[-1] == "ra" == first:
                if name == "jalr" and first == "ra":
                    scan.goes(raw, _jump(raw, constants, operands, numbers), True)
                continue
            scan.goes(raw, _jump(raw, constants, operands, numbers), first == "ra")
        elif name.startswith("b") and numbers:
            scan.goes(raw, raw.address + numbers[-1], False)
    return scan.done()


def _jump(
    raw: capstone.CsInsn, constants: dict[str, int], operands: list[str], numbers: list[int]
) -> int:
    base = next((part for part in reversed(operands) if part in constants), None)
    if base is None:
        raise Unbounded(f"`{raw.mnemonic} {raw.op_str}` at {raw.address:#x} goes anywhere")
    return (constants[base] + (numbers[-1] if numbers else 0)) & 0xFFFF_FFFF


class _Scan:
    """What is seen of a function, instruction by instruction."""

    def __init__(self, pieces: list[tuple[int, bytes]]) -> None:
        self._start = pieces[0][0]
        self._end = pieces[-1][0] + len(pieces[-1][1])
        self._function = Function()
        self._downs: list[int] = []
        self._loops: list[tuple[int, int]] = []

    def down(self, raw: capstone.CsInsn, moved: int | None) -> None:
        """The stack pointer moves down by so many bytes."""
        if moved is None:
            raise Unbounded(f"`{raw.mnemonic} {raw.op_str}` at {raw.address:#x} is not constant")
        if moved > 0:
            self._function.frame += moved
            self._downs.append(raw.address)

    def goes(self, raw: capstone.CsInsn, target: int, calls: bool) -> None:
        """The program goes on elsewhere: in a callee, or within the function."""
        # A far jump on the smallest cores is a call by its looks.
        inside = self._start <= target < self._end
        if not inside or (calls and target == self._start):
            self._function.calls.add(target)
        elif target <= raw.address:
            self._loops.append((target, raw.address))

    def done(self) -> Function:
        """The function."""
        for low, high in self._loops:
            if any(low <= address <= high for address in self._downs):
                raise Unbounded(f"a loop at {low:#x} moves the stack pointer down")
        return self._function


def _disassembled(
    reader: capstone.Cs, pieces: list[tuple[int, bytes]]
) -> Iterator[capstone.CsInsn]:
    for address, code in pieces:
        size = 0
        for raw in reader.disasm(code, address):
            size += raw.size
            yield raw
        if size != len(code):
            raise Unbounded(f"at {address + size:#x} lies no instruction")


def _bytes(image: Image, low: int, high: int) -> bytes:
    for start, data in image.segments:
        if start <= low and high <= start + len(data):
            return data[low - start : high - start]
    raise Unbounded(f"nothing lies at {low:#x}")


def _word(image: Image, address: int) -> int:
    return int.from_bytes(_bytes(image, address, address + 4), "little", signed=True)


def of_image(path: Path) -> int:
    """The deepest stack of an image's entry.

    Raises:
        Unbounded: There is no bound.
    """
    image = Image.read(path)
    functions = {}
    with path.open("rb") as file:
        elf = ELFFile(file)
        arm = elf["e_machine"] == "EM_ARM"
        tables = [part for part in elf.iter_sections() if isinstance(part, SymbolTableSection)]
        for symbol in (symbol for table in tables for symbol in table.iter_symbols()):
            if symbol["st_info"]["type"] != "STT_FUNC" or symbol["st_shndx"] == "SHN_UNDEF":
                continue
            low = symbol["st_value"] & ~1
            high = low + symbol["st_size"]
            ranges = image.code if arm else [(low, high)]
            pieces = [
                (max(low, start), _bytes(image, max(low, start), min(high, end)))
                for start, end in sorted(ranges)
                if start < high and end > low
            ]
            functions[low] = thumb(pieces, image) if arm else riscv(pieces)
    return deepest(functions, image.entry)


def main() -> int:
    """Runs the command and returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="microbrdf-stack",
        description="Prints a bound on the stack of programs.",
        epilog=f"{_EXAMPLE} {_STATUSES}",
    )
    parser.add_argument("images", nargs="+", type=Path, metavar="IMAGE", help="an ELF file")
    status = 0
    for path in parser.parse_args().images:
        try:
            print(f"{path.name}: at most {of_image(path)} bytes of stack")
        except Unbounded as error:
            print(f"error: {path}: {error}", file=sys.stderr)
            status = 1
        except (OSError, ValueError) as error:
            print(f"error: {path}: {error}", file=sys.stderr)
            return 2
    return status
