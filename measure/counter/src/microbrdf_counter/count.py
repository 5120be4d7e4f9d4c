"""Weighs what was executed with a core's timings."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from microbrdf_counter.instructions import Instruction
from microbrdf_counter.machine import Trace
from microbrdf_counter.timings import Timing


def cycles(code: dict[int, Instruction], trace: Trace, timing: Timing) -> int:
    """Cycles of a call, the call itself included."""
    return timing.call + costs(code, trace, timing).total()


def costs(code: dict[int, Instruction], trace: Trace, timing: Timing) -> Counter[int]:
    """Cycles of each instruction of a call, by address."""
    found: Counter[int] = Counter()
    for triple, times in Counter(_triples(trace.addresses)).items():
        found[triple[1]] += _step(code, timing, triple) * times
    for (address, first, second), times in trace.operands.items():
        this = code[address]
        if timing.has_early(this):
            found[address] += timing.early(this, (first, second)) * times
    return found


def steps(code: dict[int, Instruction], trace: Trace, timing: Timing) -> list[int]:
    """Cycles of each instruction that was executed, on a core where none ends early."""
    return [_step(code, timing, triple) for triple in _triples(trace.addresses)]


def _triples(addresses: list[int]) -> Iterator[tuple[int, int, int]]:
    """Each instruction with the one before it and the address after it."""
    return zip([0, *addresses], addresses, [*addresses[1:], 0])


def _step(code: dict[int, Instruction], timing: Timing, triple: tuple[int, int, int]) -> int:
    before, address, after = triple
    this = code[address]
    following = address + this.size
    cost = timing.cycles(code.get(before), this, after != following)
    if not this.writes_pc:
        # What lies between was passed over by its condition.
        while following != after and following in code and code[following].condition:
            cost += timing.skipped(code[following])
            following += code[following].size
    return cost


def classes(code: dict[int, Instruction], trace: Trace) -> Counter[str]:
    """How many instructions of each kind were executed."""
    found: Counter[str] = Counter()
    for address, times in Counter(trace.addresses).items():
        found[kind(code[address])] += times
    return found


#: What instructions are, by the beginnings of their names.
_KINDS = {
    "float": ("v",),
    "load": ("ldr", "ldm", "pop"),
    "store": ("str", "stm", "push"),
    "multiply": ("mul", "mla", "mls", "umul", "umla", "umaa", "smul", "smla", "smmu"),
    "divide": ("udiv", "sdiv"),
}


def kind(this: Instruction) -> str:
    """What an instruction is, in a word."""
    if this.writes_pc:
        return "branch"
    kinds = (kind for kind, heads in _KINDS.items() if this.name.startswith(heads))
    return next(kinds, "other")
