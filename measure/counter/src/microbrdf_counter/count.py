"""Weighs what was executed with a core's timings."""

from __future__ import annotations

from collections import Counter

from microbrdf_counter.instructions import Instruction
from microbrdf_counter.machine import Trace
from microbrdf_counter.timings import Timing


def cycles(code: dict[int, Instruction], trace: Trace, timing: Timing) -> int:
    """Cycles of a call, the call itself included."""
    addresses = trace.addresses
    total = timing.call
    # Each instruction with the one before it and the address after it.
    triples = Counter(zip([0, *addresses], addresses, [*addresses[1:], 0]))
    for (before, address, after), times in triples.items():
        this = code[address]
        following = address + this.size
        cost = timing.cycles(code.get(before), this, after != following)
        if not this.writes_pc:
            # What lies between was passed over by its condition.
            while following != after and following in code and code[following].condition:
                cost += timing.skipped(code[following])
                following += code[following].size
        total += cost * times
    for (address, first, second), times in trace.operands.items():
        this = code[address]
        if timing.has_early(this):
            total += timing.early(this, (first, second)) * times
    return total


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
