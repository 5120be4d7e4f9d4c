"""Cortex-M0 and Cortex-M0+.

Cortex-M0 Technical Reference Manual (Arm DDI 0432C), table 3-1; Cortex-M0+ Technical Reference
Manual (Arm DDI 0484C), table 3-1.
"""

from __future__ import annotations

from microbrdf_counter.instructions import Instruction
from microbrdf_counter.timings.timing import UnknownInstruction

_SINGLE = frozenset(
    "adc add adr and asr bic cmn cmp eor lsl lsr mov mvn nop orr ror rsb sbc sub sxtb sxth tst "
    "uxtb uxth rev rev16 revsh cpsid cpsie".split()
)
_LOADS = frozenset("ldr ldrb ldrh ldrsb ldrsh str strb strh".split())


class CortexM0:
    """Three stages: a taken branch takes three cycles."""

    core = "cortex-m0"
    call = 4
    _taken = 3
    _indirect = 3
    _pop_pc = 4
    _system = 4
    _manual = "Arm DDI 0432C table 3-1"

    def __init__(self, multiply: int) -> None:
        """``multiply``: 1 or 32, as the core was configured."""
        self._multiply = multiply
        self.clock_model = f"{self._manual}, {multiply}-cycle multiplier, zero wait states"

    def cycles(self, before: Instruction | None, this: Instruction, taken: bool) -> int:
        """Cycles of an instruction; nothing depends on the one before."""
        name = this.name
        if name == "bl":
            return self.call
        if name in ("bx", "blx"):
            return self._indirect
        if name == "b":
            return self._taken if taken else 1
        if name == "pop" and this.writes_pc:
            return self._pop_pc + this.count - 1
        if name in ("push", "pop", "ldm", "stm", "ldmia", "stmia"):
            return 1 + this.count
        if name in _LOADS:
            return 2
        if name == "mul":
            return self._multiply
        if name in _SINGLE:
            return self._indirect if this.writes_pc else 1
        if name in ("mrs", "msr", "dmb", "dsb", "isb"):
            return self._system
        raise UnknownInstruction(this, self.core)

    def skipped(self, this: Instruction) -> int:
        """There are no IT blocks."""
        raise UnknownInstruction(this, self.core)

    def early(self, this: Instruction, operands: tuple[int, int]) -> int:
        """Nothing ends early."""
        del this, operands
        return 0

    def has_early(self, this: Instruction) -> bool:
        """Nothing ends early."""
        del this
        return False


class CortexM0Plus(CortexM0):
    """Two stages: a taken branch takes two cycles."""

    core = "cortex-m0plus"
    call = 3
    _taken = 2
    _indirect = 2
    _pop_pc = 3
    _system = 3
    _manual = "Arm DDI 0484C table 3-1"
