"""A bound on the stack, from pieces of machine code."""

from __future__ import annotations

from pathlib import Path

import pytest

from microbrdf_counter.image import Image
from microbrdf_counter.stack import Function, Unbounded, deepest, of_image, riscv, thumb

_FLASH = 0x1000_0000


def arm(code: str, *behind: int) -> Function:
    data = bytes.fromhex(code)
    constants = b"".join(word.to_bytes(4, "little") for word in behind)
    image = Image(_FLASH, [(_FLASH, data + constants)], [], 0, 0, 0)
    return thumb([(_FLASH, data)], image)


THUMB = [
    ("7047", "bx lr", 0),
    ("10b510bd", "push {r4, lr}; pop {r4, pc}", 8),
    ("84b004b07047", "sub sp, #16; add sp, #16; bx lr", 16),
    ("2ded048bbdec048b7047", "vpush {d8, d9}; vpop {d8, d9}; bx lr", 16),
    ("adf5807d0df5807d7047", "sub.w sp, sp, #256; add.w sp, sp, #256; bx lr", 256),
    ("4df8047d7047", "str r7, [sp, #-4]!; bx lr", 4),
]


@pytest.mark.parametrize(("code", "text", "frame"), THUMB, ids=[row[1] for row in THUMB])
def test_thumb_frames(code: str, text: str, frame: int) -> None:
    del text
    assert arm(code) == Function(frame, set())


def test_a_frame_from_a_constant() -> None:
    # ldr r6, [pc, #0]; add sp, r6; behind it -2000
    assert arm("004eb544", (1 << 32) - 2000).frame == 2000
    # add sp, r6
    with pytest.raises(Unbounded, match="not constant"):
        arm("b544")


def test_thumb_calls() -> None:
    # bl +0x100; b +0x200, out of the function; bne back to its start
    assert arm("00f07ef8fee0fbd1").calls == {_FLASH + 0x100, _FLASH + 4 + 0x200}
    # bl to its own start
    assert arm("fff7feff").calls == {_FLASH}
    # bx r3
    with pytest.raises(Unbounded, match="anywhere"):
        arm("1847")


def test_a_loop_that_pushes_has_no_bound() -> None:
    # push {r4}; bne -4
    with pytest.raises(Unbounded, match="loop"):
        arm("10b4fdd1")


def five(code: str) -> Function:
    return riscv([(_FLASH, bytes.fromhex(code))])


def test_risc_v_frames_and_calls() -> None:
    # c.addi16sp sp, -32; auipc ra, 1; jalr ra, 0x10(ra); c.addi16sp sp, 32; ret
    assert five("0111" + "97100000" + "e7800001" + "0561" + "8280") == Function(
        32, {_FLASH + 2 + 0x1010}
    )
    # lui a0, 1; sub sp, sp, a0; ret
    assert five("37150000" + "3301a140" + "8280").frame == 4096
    # c.j -2: a loop, with a frame in it
    with pytest.raises(Unbounded, match="loop"):
        five("0111" + "fdbf")
    # c.jr a0
    with pytest.raises(Unbounded, match="anywhere"):
        five("0285")


def test_the_deepest_way() -> None:
    functions = {0: Function(8, {1, 2}), 1: Function(100), 2: Function(4, {3}), 3: Function(97)}
    assert deepest(functions, 0) == 109
    functions[3] = Function(1, {2})
    with pytest.raises(Unbounded, match="itself"):
        deepest(functions, 0)
    with pytest.raises(Unbounded, match="no function"):
        deepest(functions, 9)


def test_what_is_no_image(tmp_path: Path) -> None:
    with pytest.raises(OSError, match="none"):
        of_image(tmp_path / "none")
