"""The emulated core runs what it should, and remembers it."""

from __future__ import annotations

import pytest

from microbrdf_counter.count import classes, cycles
from microbrdf_counter.image import Image
from microbrdf_counter.machine import Machine, Stray, Trace
from microbrdf_counter.timings import CortexM0, CortexM3

_FLASH = 0x1000_0000


def machine(code: str, target: str = "thumbv7m-none-eabi") -> Machine:
    data = bytes.fromhex(code)
    image = Image(
        entry=_FLASH,
        segments=[(_FLASH, data)],
        code=[(_FLASH, _FLASH + len(data))],
        code_bytes=len(data),
        table_bytes=0,
        ram_bytes=0,
    )
    return Machine(image, target)


def run(code: str, *arguments: int, target: str = "thumbv7m-none-eabi") -> Trace:
    return machine(code, target).call(list(arguments), [], 0)


def test_registers_go_in_and_come_back() -> None:
    # adds r0, r1, r2; adds r0, r0, r3; bx lr
    trace = run("8818c0187047", 0, 1, 20, 300)
    assert trace.results[0] == 321
    assert [address - _FLASH for address in trace.addresses] == [0, 2, 4]
    assert trace.stack == 0


def test_the_fifth_argument_lies_on_the_stack() -> None:
    # ldr r0, [sp]; bx lr
    assert run("00987047", 1, 2, 3, 4, 5).results[0] == 5


def test_memory_goes_in_and_comes_back() -> None:
    # ldr r2, [r0]; adds r2, #1; str r2, [r1]; bx lr
    core = machine("026801320a607047", "thumbv6m-none-eabi")
    trace = core.call([0x2000_0000, 0x2000_0004], [41], 1)
    assert trace.results == [42]
    kinds = classes(core.code, trace)
    assert kinds == {"load": 1, "other": 1, "store": 1, "branch": 1}


def test_the_deepest_stack() -> None:
    # push {r4, lr}; sub sp, #16; push {r0}; pop {r1}; add sp, #16; pop {r4, pc}
    assert run("10b584b001b402bc04b010bd").stack == 28


def test_the_stack_moved_by_a_register() -> None:
    # movs r3, #64; negs r2, r3; add sp, r2; push {r0}; pop {r1}; add sp, r3; bx lr
    assert run("40235a42954401b402bc9d447047", target="thumbv6m-none-eabi").stack == 68


def test_a_loop_is_counted_each_time() -> None:
    # movs r1, #0; adds r1, #1; subs r0, #1; bne -6; mov r0, r1; bx lr
    code = "0021013101 38fcd108467047".replace(" ", "")
    core = machine(code, "thumbv6m-none-eabi")
    trace = core.call([5], [], 0)
    assert trace.results[0] == 5
    # The call; movs; five times adds, subs and bne, taken four times; mov; bx.
    assert cycles(core.code, trace, CortexM0(1)) == 4 + 1 + 5 * 2 + 4 * 3 + 1 + 1 + 3


@pytest.mark.parametrize(("value", "passed_over"), [(0, 6), (1, 4)])
def test_conditions_within_an_it_block(value: int, passed_over: int) -> None:
    # cmp r0, #0; ite eq; moveq r0, #7 (at 4); movne r0, #9 (at 6); bx lr
    core = machine("00280cbf072009207047")
    trace = core.call([value], [], 0)
    assert trace.results[0] == (9 if value else 7)
    executed = [address - _FLASH for address in trace.addresses]
    assert executed == [at for at in (0, 2, 4, 6, 8) if at != passed_over]
    # The call, `cmp`, `ite`, both moves, `bx`: the failed one takes one cycle, too.
    assert cycles(core.code, trace, CortexM3()) == 3 + 1 + 1 + 1 + 1 + 3


@pytest.mark.parametrize(("value", "passed_over"), [(0, 0), (1, 1)])
def test_a_return_within_an_it_block(value: int, passed_over: int) -> None:
    # push {r4, r5, lr}; cmp r0, #0; it eq; popeq {r4, r5, pc}; pop {r4, r5, pc}
    core = machine("30b5002808bf30bd30bd")
    trace = core.call([value], [], 0)
    assert len(trace.addresses) == 4
    assert trace.stack == 12
    # The call, the push, `cmp`, `it`; a pop that returns takes 1 + 3 and the refill.
    assert cycles(core.code, trace, CortexM3()) == 3 + 4 + 1 + 1 + passed_over + 6


def test_operands_of_a_division_are_kept() -> None:
    # udiv r0, r1, r2; bx lr
    core = machine("b1fbf2f07047")
    trace = core.call([0, 100, 7], [], 0)
    assert trace.results[0] == 14
    assert dict(trace.operands) == {(_FLASH, 100, 7): 1}
    # 100 has 7 bits, 7 has 3: a quotient of up to 5 bits.
    assert cycles(core.code, trace, CortexM3()) == 3 + (4 + 2) + 3


def test_operands_of_a_long_multiply_are_kept() -> None:
    # umull r0, r1, r2, r3; bx lr
    trace = run("a2fb03017047", 0, 0, 0x10000, 3)
    assert trace.results[0] == 0x30000
    assert dict(trace.operands) == {(_FLASH, 0x10000, 3): 1}


def test_what_runs_off_is_an_error() -> None:
    # bx r0, to nowhere
    with pytest.raises(Stray, match="0x40000000"):
        run("0047", 0x4000_0001)


def test_a_stack_that_is_not_put_back_is_an_error() -> None:
    # push {r4}; bx lr
    with pytest.raises(Stray, match="stack"):
        run("10b47047")
