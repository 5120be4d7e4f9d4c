"""Every timing, instruction by instruction, from pieces of machine code."""

from __future__ import annotations

import pickle

import pytest

from microbrdf_counter.count import cycles
from microbrdf_counter.instructions import decode
from microbrdf_counter.machine import Trace
from microbrdf_counter.timings import CortexM0, CortexM0Plus, CortexM3, CortexM4F, Timing
from microbrdf_counter.timings.timing import UnknownInstruction

M0 = CortexM0(multiply=1)
M0_SLOW = CortexM0(multiply=32)
M0PLUS = CortexM0Plus(multiply=1)
M3 = CortexM3()
M4F = CortexM4F()


def cost(code: str, timing: Timing, goes_to: int | None = None) -> int:
    """Cycles of a piece of code, executed from its first to its last instruction."""
    instructions = decode(bytes.fromhex(code), 0x100)
    assert sum(i.size for i in instructions) == len(bytes.fromhex(code))
    addresses = [i.address for i in instructions]
    last = instructions[-1]
    after = last.address + last.size if goes_to is None else goes_to
    # The address after the last one decides whether it was taken: a NOP lies there.
    nop = decode(bytes.fromhex("00bf"), after)[0]
    known = {i.address: i for i in [*instructions, nop]}
    with_nop = cycles(known, Trace(addresses=[*addresses, after]), timing)
    return with_nop - cycles(known, Trace(addresses=[after]), timing)


# Code, what it is, and cycles on M0, M0+, M3, M4.
SINGLE = [
    ("0820", "movs r0, #8", (1, 1, 1, 1)),
    ("8818", "adds r0, r1, r2", (1, 1, 1, 1)),
    ("4800", "lsls r0, r1, #1", (1, 1, 1, 1)),
    ("c8b2", "uxtb r0, r1", (1, 1, 1, 1)),
    ("08ba", "rev r0, r1", (1, 1, 1, 1)),
    ("8842", "cmp r0, r1", (1, 1, 1, 1)),
    ("4843", "muls r0, r1, r0", (1, 1, 1, 1)),
    ("0868", "ldr r0, [r1]", (2, 2, 2, 2)),
    ("8858", "ldr r0, [r1, r2]", (2, 2, 2, 2)),
    ("0898", "ldr r0, [sp, #32]", (2, 2, 2, 2)),
    ("0888", "ldrh r0, [r1]", (2, 2, 2, 2)),
    ("8856", "ldrsb r0, [r1, r2]", (2, 2, 2, 2)),
    ("0860", "str r0, [r1]", (2, 2, 1, 1)),
    ("8850", "str r0, [r1, r2]", (2, 2, 2, 2)),
    ("f0b5", "push {r4, r5, r6, r7, lr}", (6, 6, 6, 6)),
    ("f0bc", "pop {r4, r5, r6, r7}", (5, 5, 5, 5)),
    ("0ec9", "ldm r1!, {r1, r2, r3}", (4, 4, 4, 4)),
    ("0cc0", "stm r0!, {r2, r3}", (3, 3, 3, 3)),
]


@pytest.mark.parametrize(("code", "text", "expected"), SINGLE, ids=[row[1] for row in SINGLE])
def test_one_instruction(code: str, text: str, expected: tuple[int, int, int, int]) -> None:
    del text
    assert tuple(cost(code, timing) for timing in (M0, M0PLUS, M3, M4F)) == expected


BRANCHES = [
    ("00d0", "beq, taken", 0x200, (3, 2, 3, 3)),
    ("00d0", "beq, not taken", None, (1, 1, 1, 1)),
    ("7ee0", "b", 0x200, (3, 2, 3, 3)),
    ("00f07ef8", "bl", 0x200, (4, 3, 3, 3)),
    ("7047", "bx lr", 0x200, (3, 2, 3, 3)),
    ("8047", "blx r0", 0x200, (3, 2, 3, 3)),
    ("10bd", "pop {r4, pc}", 0x200, (5, 4, 5, 5)),
    ("f0bd", "pop {r4-r7, pc}", 0x200, (8, 7, 8, 8)),
]


@pytest.mark.parametrize(
    ("code", "text", "goes_to", "expected"), BRANCHES, ids=[row[1] for row in BRANCHES]
)
def test_a_branch(
    code: str, text: str, goes_to: int | None, expected: tuple[int, int, int, int]
) -> None:
    del text
    assert tuple(cost(code, timing, goes_to) for timing in (M0, M0PLUS, M3, M4F)) == expected


def test_the_slow_multiplier() -> None:
    assert cost("4843", M0_SLOW) == 32
    assert cost("48434843", M0_SLOW) == 64


THUMB2 = [
    ("00fb01f0", "mul r0, r0, r1", (1, 1)),
    ("01fb0230", "mla r0, r1, r2, r3", (2, 1)),
    ("01fb1230", "mls r0, r1, r2, r3", (2, 1)),
    ("40f20100", "movw r0, #1", (1, 1)),
    ("c1f30700", "ubfx r0, r1, #0, #8", (1, 1)),
    ("b1fa81f0", "clz r0, r1", (1, 1)),
    ("d1e90001", "ldrd r0, r1, [r1]", (3, 3)),
    ("2de9f047", "push.w {r4-r10, lr}", (9, 9)),
    ("08bf", "it eq", (1, 1)),
]


@pytest.mark.parametrize(("code", "text", "expected"), THUMB2, ids=[row[1] for row in THUMB2])
def test_an_instruction_of_32_bits(code: str, text: str, expected: tuple[int, int]) -> None:
    del text
    assert (cost(code, M3), cost(code, M4F)) == expected


def test_tests_of_zero() -> None:
    assert [cost("10b1", timing, 0x200) for timing in (M3, M4F)] == [3, 3]
    assert [cost("10b1", timing) for timing in (M3, M4F)] == [1, 1]


def test_loads_in_a_row_overlap_on_m3_and_m4() -> None:
    # ldr r0, [r2]; ldr r1, [r2, #4]; ldr r3, [r2, #8]
    assert [cost("106851689368", timing) for timing in (M0, M3, M4F)] == [6, 4, 4]
    # The second address is what the first loads: ldr r2, [r2]; ldr r1, [r2, #4]
    assert [cost("12685168", timing) for timing in (M3, M4F)] == [4, 4]
    # Something in between: ldr r0, [r2]; nop; ldr r1, [r2, #4]
    assert cost("106800bf5168", M3) == 5


def operands(code: str, timing: Timing, first: int, second: int) -> int:
    """Cycles of an instruction with these operands."""
    instructions = decode(bytes.fromhex(code), 0x100)
    known = {i.address: i for i in instructions}
    trace = Trace(addresses=[0x100])
    trace.operands[0x100, first, second] = 1
    return cycles(known, trace, timing) - timing.call


UMULL, SMULL, UMLAL, UDIV, SDIV = "a2fb0301", "82fb0301", "e2fb0301", "b1fbf2f0", "91fbf2f0"


def test_long_multiplies_end_early_on_m3_alone() -> None:
    small, large, minus = 0xFFFF, 0x1_0000, 0xFFFF_FFFF
    assert [
        operands(UMULL, M3, *pair) for pair in [(small, small), (small, large), (large, large)]
    ] == [3, 4, 5]
    assert [
        operands(UMLAL, M3, *pair) for pair in [(small, small), (small, large), (large, large)]
    ] == [4, 5, 7]
    assert operands(SMULL, M3, minus, minus) == 3
    assert operands(UMULL, M3, minus, minus) == 5
    assert [operands(code, M4F, large, large) for code in (UMULL, SMULL, UMLAL)] == [1, 1, 1]


@pytest.mark.parametrize("timing", [M3, M4F])
def test_divisions_end_early(timing: Timing) -> None:
    assert operands(UDIV, timing, 1, 2) == 2
    assert operands(UDIV, timing, 1, 0) == 2
    assert operands(UDIV, timing, 2, 2) == 5
    assert operands(UDIV, timing, 0xFFFF_FFFF, 1) == 12
    assert operands(SDIV, timing, 0xFFFF_FFFF, 1) == 5
    assert 2 <= operands(UDIV, timing, 100_000, 7) <= 12


def test_a_failed_condition_takes_one_cycle() -> None:
    # it eq; ldreq r0, [r1]; then a NOP
    instructions = decode(bytes.fromhex("08bf086800bf"), 0x100)
    known = {i.address: i for i in instructions}
    assert instructions[1].condition == "eq"
    executed = cycles(known, Trace(addresses=[0x100, 0x102, 0x104]), M3)
    passed_over = cycles(known, Trace(addresses=[0x100, 0x104]), M3)
    # `it`, 2 or 1 for the load, the NOP.
    assert [executed - M3.call, passed_over - M3.call] == [4, 3]


def test_sums_side_by_side_take_one_cycle_on_m4_and_are_none_of_m3s() -> None:
    code = "92fa58f2"
    assert decode(bytes.fromhex(code), 0)[0].text == "uqadd16 r2, r2, r8"
    assert cost(code, M4F) == 1
    with pytest.raises(UnknownInstruction, match="uqadd16") as unknown:
        cost(code, M3)
    # Counters run in processes of their own, from which it has to come back.
    back = pickle.loads(pickle.dumps(unknown.value))  # noqa: S301
    assert str(back) == str(unknown.value)


FLOATS = [
    ("30ee000a", "vadd.f32 s0, s0, s0", 1),
    ("20ee000a", "vmul.f32 s0, s0, s0", 1),
    ("00ee000a", "vmla.f32 s0, s0, s0", 3),
    ("a0ee000a", "vfma.f32 s0, s0, s0", 3),
    ("80ee000a", "vdiv.f32 s0, s0, s0", 14),
    ("b1eec00a", "vsqrt.f32 s0, s0", 14),
    ("b4ee400a", "vcmp.f32 s0, s0", 1),
    ("bceec00a", "vcvt.u32.f32 s0, s0", 1),
    ("f1ee10fa", "vmrs apsr_nzcv, fpscr", 1),
    ("00ee101a", "vmov s0, r1", 1),
    ("90ed000a", "vldr s0, [r0]", 2),
    ("80ed000a", "vstr s0, [r0]", 2),
    ("2ded048b", "vpush {d8, d9}", 5),
    ("bdec048b", "vpop {d8, d9}", 5),
]


@pytest.mark.parametrize(("code", "text", "expected"), FLOATS, ids=[row[1] for row in FLOATS])
def test_a_float(code: str, text: str, expected: int) -> None:
    assert decode(bytes.fromhex(code), 0)[0].text == text
    assert cost(code, M4F) == expected


def test_a_float_that_is_needed_at_once_costs_one_more() -> None:
    # vadd.f32 s0, s1, s2; vmul.f32 s3, s0, s0
    assert cost("30ee810a60ee001a", M4F) == 3
    # vadd.f32 s0, s1, s2; vmul.f32 s3, s4, s4
    assert cost("30ee810a62ee021a", M4F) == 2


def test_what_a_core_does_not_have_is_an_error() -> None:
    with pytest.raises(UnknownInstruction, match=r"vadd\.f32"):
        cost("30ee000a", M3)
    with pytest.raises(UnknownInstruction, match="udiv"):
        cost(UDIV, M0)
