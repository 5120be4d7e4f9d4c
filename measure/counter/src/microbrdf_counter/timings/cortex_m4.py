"""Cortex-M4 with its FPU.

Cortex-M4 Technical Reference Manual (Arm DDI 0439D, r0p1), tables 3-1 and 7-1 and section 3.3.2
on load and store timings.
"""

from __future__ import annotations

from typing import ClassVar

from microbrdf_counter.instructions import Instruction
from microbrdf_counter.timings.cortex_m3 import REFILL, CortexM3, division

_LONG = "umull smull umlal smlal umaal".split()
_SHORT = (
    "mul mla mls smulbb smulbt smultb smultt smlabb smlabt smlatb smlatt smulwb smulwt smlawb "
    "smlawt smmul smmla smmls smmulr smmlar smmlsr smuad smusd smlad smlsd smlald smlsld "
    "smlalbb smlalbt smlaltb smlaltt qadd qsub qdadd qdsub sel pkhbt "
    "pkhtb sxtab sxtah uxtab uxtah sxtb16 uxtb16 ssat16 usat16 usada8 usad8"
).split()
#: Sums of halves or bytes side by side.
_PARALLEL = [
    prefix + operation
    for prefix in "s q sh u uq uh".split()
    for operation in "add8 add16 sub8 sub16 asx sax".split()
]
_FLOAT_SINGLE = "vadd vsub vmul vnmul vabs vneg vcmp vcmpe vcvt vcvtr".split()
_FLOAT_MULTIPLY_ADD = "vmla vmls vnmla vnmls vfma vfms vfnma vfnms".split()
#: Whose result costs a cycle more where the next instruction needs it.
_FLOAT_ARITHMETIC = (*_FLOAT_MULTIPLY_ADD, "vadd", "vsub", "vmul", "vnmul", "vdiv", "vsqrt")


class CortexM4F(CortexM3):
    """Every multiply takes one cycle; floats are added and multiplied in one."""

    core = "cortex-m4f"
    clock_model = (
        "Arm DDI 0439D tables 3-1 and 7-1, refill 2, zero wait states; loads in a row overlap; "
        "divisions 2 to 12 cycles by the size of their operands; a float that the next "
        "instruction needs costs one more"
    )
    _multiplies: ClassVar[dict[str, int]] = dict.fromkeys((*_LONG, *_SHORT, *_PARALLEL), 1)

    def cycles(self, before: Instruction | None, this: Instruction, taken: bool) -> int:
        """Cycles of an instruction after another, at their greatest for any operands."""
        if this.name.startswith("v"):
            return self._float(this) + _waits(before, this)
        return super().cycles(before, this, taken)

    def _float(self, this: Instruction) -> int:
        head = this.name.partition(".")[0]
        if head in _FLOAT_SINGLE:
            return 1
        if head in _FLOAT_MULTIPLY_ADD:
            return 3
        if head in ("vdiv", "vsqrt"):
            return 14
        if head in ("vmov", "vmrs", "vmsr"):
            core_registers = [r for r in this.reads | this.writes if r.startswith("r")]
            return 2 if len(core_registers) == 2 else 1
        if head in ("vldr", "vstr", "vpush", "vpop") or head.startswith(("vldm", "vstm")):
            return 1 + this.count
        # `super` names it.
        return super().cycles(None, this, False)

    def has_early(self, this: Instruction) -> bool:
        """Divisions."""
        return this.name in ("udiv", "sdiv")

    def early(self, this: Instruction, operands: tuple[int, int]) -> int:
        """What a division saves by its operands, as on Cortex-M3."""
        first, second = operands
        if this.name == "sdiv":
            first, second = abs(_signed(first)), abs(_signed(second))
        return division(first, second) - 12


def _waits(before: Instruction | None, this: Instruction) -> int:
    """A cycle more where the float before is needed now."""
    if before is None or before.name.partition(".")[0] not in _FLOAT_ARITHMETIC:
        return 0
    return 1 if before.writes & this.reads else 0


def _signed(word: int) -> int:
    return word if word < 1 << 31 else word - (1 << 32)


__all__ = ["REFILL", "CortexM4F"]
