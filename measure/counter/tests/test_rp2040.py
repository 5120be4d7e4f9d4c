"""Cortex-M0+ against a second source, instruction by instruction.

`microbrdf-count --second-source` does the same over whole kernels.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest

from microbrdf_counter.bench import Fails
from microbrdf_counter.differs import Differs
from microbrdf_counter.image import Image
from microbrdf_counter.instructions import Instruction, decode
from microbrdf_counter.rp2040.compare import compare, known_difference
from microbrdf_counter.rp2040.emulator import ADDRESS, Missing, Rp2040
from microbrdf_counter.timings import CortexM0Plus
from microbrdf_counter.timings.timing import UnknownInstruction

_FLASH = 0x1000_0000
#: Where `cargo xtask setup` puts the package.
_FOLDER = Path(__file__).parents[3] / "target" / "node"
#: In RAM; and half of it, where an address is the sum of two registers.
_RAM = 0x2001_0000

M0PLUS = CortexM0Plus(multiply=1)
#: What the table leaves out: instructions that wait, trap or hint, and those of 16 bits that
#: later architectures have.
NOT_TIMED = set(
    "bkpt cbnz cbz hint hlt it setend setpan sev sevl svc trap udf wfe wfi yield".split()
)
#: What it holds.
TIMED = set(
    "adc add adr and asr b bic blx bx cmn cmp cpsid cpsie eor ldm ldr ldrb ldrh ldrsb ldrsh lsl "
    "lsr mov mul mvn nop orr pop push rev rev16 revsh ror rsb sbc stm str strb strh sub sxtb sxth "
    "tst uxtb uxth".split()
)
WIDE = [
    ("00f07ef8", "bl"),
    ("eff30080", "mrs r0, apsr"),
    ("80f30088", "msr apsr"),
    ("bff35f8f", "dmb sy"),
    ("bff34f8f", "dsb sy"),
    ("bff36f8f", "isb sy"),
]


@pytest.fixture(scope="module")
def rp2040() -> Iterator[Rp2040]:
    with Rp2040(_FOLDER) as emulator:
        yield emulator


def halves() -> Iterator[bytes]:
    """Every instruction of 16 bits."""
    for half in range(0xE800):
        # BX, BLX and CPS with bits that must be 0, or flags that are not there.
        reserved = (half >> 8 == 0x47 and half & 7) or (half >> 5 == 0x5B3 and half & 15 != 2)
        # A branch to where the program would go on anyway: taken or not can't be seen.
        unseen = half == 0xE7FF or half & 0xF0FF == 0xD0FF
        if not (reserved or unseen):
            yield half.to_bytes(2, "little")


#: An instruction, its cycles there, and the address after it.
Executed = tuple[Instruction, int, int]


def execute(rp2040: Rp2040, codes: Iterator[bytes]) -> Iterator[Executed]:
    """Executes what can be decoded."""
    for code in codes:
        for this in decode(code, ADDRESS)[:1]:
            register = _RAM // 2 if this.register_offset else _RAM
            done = (0, 0) if this.name in NOT_TIMED else rp2040.step(register, code)
            yield (this, *done)


@pytest.fixture(scope="module")
def executed(rp2040: Rp2040) -> list[Executed]:
    return list(execute(rp2040, halves()))


def differences(timing: CortexM0Plus, executed: Iterable[Executed]) -> dict[str, str]:
    """Instructions that take other cycles, by their text."""
    found = {}
    for this, there, after in executed:
        if this.name not in NOT_TIMED:
            here = timing.cycles(None, this, after != ADDRESS + this.size)
            if here - there != known_difference(this):
                found[this.text] = f"{here} here, {there} there"
    return found


def test_every_instruction_of_16_bits(executed: list[Executed]) -> None:
    assert differences(M0PLUS, executed) == {}


def test_each_kind_is_among_them(executed: list[Executed]) -> None:
    assert {this.name for this, _, _ in executed} - NOT_TIMED == TIMED


def test_what_is_not_timed_is_an_error(executed: list[Executed]) -> None:
    for this, _, _ in executed:
        if this.name in NOT_TIMED:
            with pytest.raises(UnknownInstruction):
                M0PLUS.cycles(None, this, False)


@pytest.mark.parametrize(("code", "text"), WIDE, ids=[row[1] for row in WIDE])
def test_an_instruction_of_32_bits(rp2040: Rp2040, code: str, text: str) -> None:
    data = bytes.fromhex(code)
    assert decode(data, ADDRESS)[0].text.startswith(text)
    assert differences(M0PLUS, execute(rp2040, iter([data]))) == {}


class _Loads(CortexM0Plus):
    """A load takes as long as an addition."""

    def cycles(self, before: Instruction | None, this: Instruction, taken: bool) -> int:
        return super().cycles(before, this, taken) - (this.name == "ldrsh")


class _Pops(CortexM0Plus):
    _pop_pc = 4


class _Branches(CortexM0Plus):
    _taken = 3


class _Returns(CortexM0Plus):
    _indirect = 3


@pytest.mark.parametrize(
    ("timing", "name"),
    [
        (CortexM0Plus(multiply=2), "muls"),
        (_Loads(1), "ldrsh"),
        (_Pops(1), "pop"),
        (_Branches(1), "b"),
        (_Returns(1), "bx"),
    ],
    ids=["muls", "ldrsh", "pop", "b", "bx"],
)
def test_a_wrong_timing_is_found(executed: list[Executed], timing: CortexM0Plus, name: str) -> None:
    assert any(text.startswith(name) for text in differences(timing, executed))


def image(code: str) -> Image:
    data = bytes.fromhex(code)
    segments, ranges = [(_FLASH, data)], [(_FLASH, _FLASH + len(data))]
    return Image(_FLASH, segments, ranges, len(data), 0, 0)


#: push {r4, lr}; movs r4, r0; bl +2; pop {r4, pc}; adds r0, r0, r4; bx lr
CALLS = "10b5040000f001f810bd00197047"


def test_a_function_that_calls(rp2040: Rp2040) -> None:
    calls = [
        {"arguments": [n], "memory": [], "in_memory": False, "results": [2 * n]} for n in (1, 7)
    ]
    compared = compare(image(CALLS), calls, rp2040)
    assert (compared.calls, compared.executed.total()) == (2, 12)
    # Push, move, call, add, return, pop: LR is what rp2040js does not count.
    assert compared.here == 2 * (3 + 1 + 3 + 1 + 2 + 4)
    assert compared.there == compared.here - 2
    assert dict(compared.explained) == {"push": 2}


def test_a_function_is_compared_by_its_results_and_its_cycles(rp2040: Rp2040) -> None:
    call = {"arguments": [1], "memory": [], "in_memory": False, "results": [2]}
    with pytest.raises(Differs, match="gives"):
        compare(image(CALLS), [{**call, "results": [3]}], rp2040)
    with pytest.raises(Differs, match=r"bl #.* takes"):
        compare(image(CALLS), [call], rp2040, _Calls(1))


class _Calls(CortexM0Plus):
    call = 4


def test_what_is_missing_is_said(tmp_path: Path) -> None:
    with pytest.raises(Missing, match="rp2040js"):
        Rp2040(tmp_path)


def test_what_is_not_implemented_is_said(rp2040: Rp2040) -> None:
    # An instruction of later architectures: clz.
    clz = bytes.fromhex("b1fa81f0")
    assert rp2040.step(0, clz) == (0, 0)
    with pytest.raises(UnknownInstruction, match="clz"):
        differences(M0PLUS, execute(rp2040, iter([clz])))
    with Rp2040(_FOLDER) as emulator:
        emulator.load(image("b1fa81f0"))
        with pytest.raises(Fails):
            emulator.call(image("b1fa81f0"), [], [], 0)
