"""Builds the simulator, and talks to it."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import pythondata_cpu_ibex

from microbrdf_counter.bench import Bench
from microbrdf_counter.image import Image

#: The core's name in reports.
CORE = "rv32imc"
#: The package that holds the core's source.
_PACKAGE = "pythondata-cpu-ibex"
CLOCK_MODEL = (
    f"Ibex RTL ({_PACKAGE} {version(_PACKAGE)}) in Verilator: RV32IMC, single-cycle multiplier, "
    "branch-target ALU, write-back stage, memory that answers in the next cycle"
)
_HERE = Path(__file__).parent
_PRIMITIVES = "vendor/lowrisc_ip/ip/prim/rtl"
_SEARCHED = (
    "rtl",
    "dv/uvm/core_ibex/common/prim",
    "vendor/lowrisc_ip/ip/prim_generic/rtl",
    _PRIMITIVES,
)
#: Packages come before what uses them.
_PACKAGES = (
    "dv/uvm/core_ibex/common/prim/prim_pkg.sv",
    *(
        f"{_PRIMITIVES}/prim_{name}_pkg.sv"
        for name in ("util", "count", "ram_1p", "secded", "mubi", "cipher")
    ),
    "rtl/ibex_pkg.sv",
)


class CannotBuild(Exception):
    """The simulator could not be built."""


def build(folder: Path) -> Path:
    """Builds the simulator in ``folder``, unless it is there and current; returns its path."""
    program = folder / "Vbench"
    stamp = folder / "built-from"
    sources = [_HERE / "bench.sv", _HERE / "bench.cpp"]
    wanted = "\n".join([CLOCK_MODEL, *(source.read_text(encoding="utf-8") for source in sources)])
    if program.exists() and stamp.exists() and stamp.read_text(encoding="utf-8") == wanted:
        return program
    top = Path(pythondata_cpu_ibex.data_location)
    command = ["verilator", "--cc", "--exe", "--build", "-j", "0", "-O3", "-CFLAGS", "-O2"]
    command += ["-Wno-fatal", "-Wno-lint", "-Wno-style", "--top-module", "bench"]
    command += ["-Mdir", str(folder.resolve())]
    for searched in _SEARCHED:
        command += ["-y", str(top / searched)]
    command += [f"-I{top / _PRIMITIVES}", f"-I{top / 'vendor/lowrisc_ip/dv/sv/dv_utils'}"]
    command += [str(top / package) for package in _PACKAGES]
    command += [str(source.resolve()) for source in sources]
    folder.mkdir(parents=True, exist_ok=True)
    stamp.unlink(missing_ok=True)
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)  # noqa: S603
    except OSError as error:
        raise CannotBuild(f"verilator cannot be started: {error}") from error
    if done.returncode:
        raise CannotBuild(f"verilator failed:\n{done.stdout}{done.stderr}")
    stamp.write_text(wanted, encoding="utf-8")
    return program


@dataclass(frozen=True)
class Call:
    """What a call took and gave.

    Attributes:
        cycles: From the call to the return, both included.
        instructions: The function's own.
        stack: Bytes of stack that were written.
        results: The first two registers, or the words in memory.
    """

    cycles: int
    instructions: int
    stack: int
    results: list[int]


class Ibex(Bench):
    """A core with an image in its flash."""

    def __init__(self, program: Path, image: Image) -> None:
        """Starts ``program`` and loads ``image``."""
        super().__init__([str(program)])
        self._entry = image.entry
        self.load(image)

    def __enter__(self) -> Ibex:
        return self

    def call(self, arguments: list[int], memory: list[int], in_memory: int) -> Call:
        """Calls the function: up to eight words in registers, as a compiler passes them."""
        answer = self.ask(self._entry, arguments, memory, in_memory)
        cycles, instructions, first, second, stack, *words = map(int, answer.split())
        return Call(cycles, instructions, stack, words if in_memory else [first, second])
