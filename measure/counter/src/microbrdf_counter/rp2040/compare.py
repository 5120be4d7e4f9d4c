"""Compares the estimates for Cortex-M0+ with rp2040js, instruction by instruction."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from microbrdf_counter.count import steps
from microbrdf_counter.differs import Differs, check
from microbrdf_counter.image import Image
from microbrdf_counter.instructions import Instruction
from microbrdf_counter.machine import Machine
from microbrdf_counter.rp2040.emulator import Rp2040
from microbrdf_counter.timings import TIMINGS, Timing

TARGET = "thumbv6m-none-eabi"
CORE = "cortex-m0plus"


def known_difference(this: Instruction) -> int:
    """By how many cycles rp2040js is known to count less than Arm's table.

    PUSH takes 1 + N cycles for N registers, LR among them; rp2040js leaves LR out of N.
    """
    return int(this.name == "push" and "lr" in this.operands)


@dataclass
class Compared:
    """What was compared.

    Attributes:
        calls: Calls of functions.
        executed: How often each instruction was executed, by its name.
        here: Cycles by Arm's table.
        there: Cycles by rp2040js.
        explained: How often an instruction differed as it is known to, by its name.
    """

    calls: int = 0
    executed: Counter[str] = field(default_factory=Counter)
    here: int = 0
    there: int = 0
    explained: Counter[str] = field(default_factory=Counter)

    def add(self, other: Compared) -> None:
        """Takes in another one."""
        self.calls += other.calls
        self.executed += other.executed
        self.here += other.here
        self.there += other.there
        self.explained += other.explained

    def words(self) -> str:
        """In words."""
        explained = ", ".join(f"{times} {name}" for name, times in self.explained.items())
        return (
            f"{self.calls} calls, {self.executed.total()} instructions of "
            f"{len(self.executed)} kinds: {self.here} cycles by Arm's table, {self.there} by "
            f"rp2040js; the difference is that of {explained or 'nothing'} with LR"
        )


def compare(
    image: Image,
    calls: Iterable[dict[str, Any]],
    rp2040: Rp2040,
    timing: Timing = TIMINGS[TARGET][CORE],
) -> Compared:
    """Runs calls of a function in both emulators.

    Raises:
        Differs: They execute other instructions, give other results, or count an instruction
            differently, and not as it is known.
    """
    machine = Machine(image, TARGET)
    rp2040.load(image)
    compared = Compared()
    for call in calls:
        count = len(call["results"]) if call["in_memory"] else 0
        trace = machine.call(call["arguments"], call["memory"], count)
        other = rp2040.call(image, call["arguments"], call["memory"], count)
        check("rp2040js", call, other.results)
        if other.addresses != trace.addresses:
            raise Differs("rp2040js takes another way")
        compared.calls += 1
        here = steps(machine.code, trace, timing)
        for address, mine, yours in zip(trace.addresses, here, other.cycles):
            this = machine.code[address]
            known = known_difference(this)
            if mine - yours != known:
                raise Differs(
                    f"`{this.text}` takes {mine} cycles here and {yours} in rp2040js, "
                    f"where {known} more are expected"
                )
            compared.executed[this.name] += 1
            if known:
                compared.explained[this.name] += 1
        compared.here += sum(here)
        compared.there += sum(other.cycles)
    return compared


def kernels(job: tuple[Path, Path, list[dict[str, Any]]]) -> Compared:
    """Compares one call of each kind of some kernels: folders of the package and of images."""
    folder, images, chosen = job
    total = Compared()
    with Rp2040(folder) as rp2040:
        for kernel in chosen:
            image = Image.read(images / f"{kernel['kernel']}.elf")
            calls = [call for group in kernel["groups"] for call in group["calls"][:1]]
            try:
                total.add(compare(image, calls, rp2040))
            except Differs as error:
                raise Differs(f"{kernel['kernel']}: {error}") from error
    return total
