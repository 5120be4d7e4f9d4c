"""Ibex, simulated: a few instructions whose cycles its manual states."""

from __future__ import annotations

from pathlib import Path

import pytest

from microbrdf_counter.ibex import Ibex, build
from microbrdf_counter.ibex.simulator import Call
from microbrdf_counter.image import Image

_FLASH = 0x1000_0000
#: Shared with `cargo xtask measure`, which builds it anyway.
_FOLDER = Path(__file__).parents[3] / "target" / "measure" / "ibex"


@pytest.fixture(scope="module")
def program() -> Path:
    return build(_FOLDER)


def run(program: Path, code: str, *arguments: int, memory: tuple[int, ...] = ()) -> Call:
    data = bytes.fromhex(code)
    image = Image(_FLASH, [(_FLASH, data)], [], len(data), 0, 0)
    with Ibex(program, image) as core:
        first = core.call(list(arguments), list(memory), 0)
        # The same call takes the same cycles.
        assert core.call(list(arguments), list(memory), 0) == first
    return first


#: Cycles of the call and of `ret`: two each.
CALL = 4
RET = "8280"

INSTRUCTIONS = [
    ("", "nothing", 0, 5),
    ("0505", "addi a0, a0, 1", 1, 6),
    ("3305b502", "mul a0, a0, a1", 1, 35),
    ("3315b502", "mulh a0, a0, a1", 2, 0),
    ("3345b502", "div a0, a0, a1", 37, 0),
]


@pytest.mark.parametrize(
    ("code", "text", "cycles", "result"), INSTRUCTIONS, ids=[row[1] for row in INSTRUCTIONS]
)
def test_one_instruction(program: Path, code: str, text: str, cycles: int, result: int) -> None:
    del text
    done = run(program, code + RET, 5, 7)
    assert done.results[0] == result
    assert done.cycles == CALL + cycles
    assert done.instructions == (2 if code else 1)
    assert done.stack == 0


@pytest.mark.parametrize(("value", "cycles"), [(0, 2), (1, 2)])
def test_a_branch(program: Path, value: int, cycles: int) -> None:
    # c.beqz a0, +4; c.nop; ret: two cycles taken, else one and one of the NOP
    done = run(program, "11c10100" + RET, value)
    assert done.cycles == CALL + cycles
    assert done.instructions == 2 + value


def test_memory_and_stack(program: Path) -> None:
    # addi sp, sp, -16; sw a1, 12(sp); lw a0, 0(a0); addi sp, sp, 16; ret
    done = run(program, "41112ec608414101" + RET, 0x2000_0000, 7, memory=(42,))
    assert done.results[0] == 42
    assert done.stack == 4
    assert done.instructions == 5


def test_words_come_back_in_memory(program: Path) -> None:
    # sw a0, 0(a1); ret
    data = bytes.fromhex("88c1" + RET)
    image = Image(_FLASH, [(_FLASH, data)], [], len(data), 0, 0)
    with Ibex(program, image) as core:
        assert core.call([7, 0x2000_0004], [1], 1).results == [7]


def test_segments_that_share_a_word(program: Path) -> None:
    # lbu a0, 1(a0); ret; and behind it, in the same word, a byte that it reads.
    code, byte = bytes.fromhex("03451500") + bytes.fromhex("8280"), b"\x2a"
    behind = _FLASH + len(code)
    image = Image(_FLASH, [(_FLASH, code), (behind, byte)], [], len(code), 1, 0)
    with Ibex(program, image) as core:
        assert core.call([behind - 1], [], 0).results[0] == 42
