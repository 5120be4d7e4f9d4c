"""What a table of timings has to answer."""

from __future__ import annotations

from typing import Protocol

from microbrdf_counter.instructions import Instruction


class UnknownInstruction(Exception):
    """A table does not hold this instruction."""

    def __init__(self, instruction: Instruction, core: str) -> None:
        """``instruction`` has no timing on ``core``."""
        super().__init__(f"no timing for `{instruction.text}` on {core}")
        self._given = instruction, core

    def __reduce__(self) -> tuple[type[UnknownInstruction], tuple[Instruction, str]]:
        """How it comes back from another process."""
        return type(self), self._given


class Timing(Protocol):
    """The timings of one core."""

    #: Name of the core.
    core: str
    #: Where the figures are from, and what is modelled beside them.
    clock_model: str
    #: Cycles of the call that enters a function.
    call: int

    def cycles(self, before: Instruction | None, this: Instruction, taken: bool) -> int:
        """Cycles of an instruction that is executed after another; ``taken`` for branches."""

    def skipped(self, this: Instruction) -> int:
        """Cycles of an instruction whose condition within an IT block fails."""

    def early(self, this: Instruction, operands: tuple[int, int]) -> int:
        """What operands change: added to ``cycles``, which holds the greatest number."""

    def has_early(self, this: Instruction) -> bool:
        """Whether the operands matter."""
