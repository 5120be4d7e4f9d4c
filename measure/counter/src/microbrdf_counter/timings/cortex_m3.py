"""Cortex-M3.

Cortex-M3 Technical Reference Manual (Arm DDI 0337I, r2p1), table 3-1 and section 3.3.2 on load
and store timings. A refill of the pipeline takes 1 to 3 cycles there; here it is 2.
"""

from __future__ import annotations

from typing import ClassVar

from microbrdf_counter.instructions import Instruction
from microbrdf_counter.timings.timing import UnknownInstruction

#: Cycles to refill the pipeline.
REFILL = 2

_SINGLE = frozenset(
    "adc add addw adr and asr bfc bfi bic clz cmn cmp eor it lsl lsr mov movw movt mvn nop orn "
    "orr rbit rev rev16 revsh ror rrx rsb sbc sbfx sub subw sxtb sxth teq tst ubfx uxtb uxth cps "
    "ssat usat".split()
)
_LOADS = frozenset("ldr ldrb ldrh ldrsb ldrsh".split())
_STORES = frozenset("str strb strh".split())
_MULTIPLES = "push pop ldm ldmia ldmdb stm stmia stmdb ldrd strd".split()


class CortexM3:
    """Long multiplies and divisions end early, single loads in a row overlap."""

    core = "cortex-m3"
    call = 1 + REFILL
    clock_model = (
        "Arm DDI 0337I table 3-1, refill 2, zero wait states; loads in a row overlap; "
        "long multiplies 3 to 5 and divisions 2 to 12 cycles by the size of their operands"
    )
    #: Greatest cycles of what multiplies.
    _multiplies: ClassVar[dict[str, int]] = {
        "mul": 1,
        "mla": 2,
        "mls": 2,
        "umull": 5,
        "smull": 5,
        "umlal": 7,
        "smlal": 7,
    }

    def cycles(self, before: Instruction | None, this: Instruction, taken: bool) -> int:
        """Cycles of an instruction after another, at their greatest for any operands."""
        name = this.name
        if name in self._multiplies:
            return self._multiplies[name]
        if name in ("udiv", "sdiv"):
            return 12
        if name in ("b", "cbz", "cbnz"):
            return 1 + REFILL if taken else 1
        if name in ("bl", "bx", "blx"):
            return 1 + REFILL
        if name in ("tbb", "tbh"):
            return 2 + REFILL
        if name in _MULTIPLES:
            return 1 + this.count + (REFILL if this.writes_pc else 0)
        if name in _LOADS or name in _STORES:
            return self._access(before, this)
        if name in _SINGLE:
            return 1 + (REFILL if this.writes_pc else 0)
        if name in ("mrs", "msr", "dmb", "dsb", "isb"):
            return 4
        raise UnknownInstruction(this, self.core)

    def _access(self, before: Instruction | None, this: Instruction) -> int:
        """A single load or store.

        A store to a base and a constant takes one cycle. A load takes two, of which the first
        overlaps with a single load before it that does not give the address.
        """
        if this.name in _STORES and not this.register_offset:
            return 1
        overlaps = (
            before is not None
            and before.name in _LOADS
            and not before.writes_pc
            and not before.writes & this.base
        )
        return (1 if overlaps else 2) + (REFILL if this.writes_pc else 0)

    def skipped(self, this: Instruction) -> int:
        """One cycle, whatever it would have taken."""
        del this
        return 1

    def has_early(self, this: Instruction) -> bool:
        """Divisions and long multiplies."""
        return this.name in ("udiv", "sdiv") or self._multiplies.get(this.name, 0) >= 5

    def early(self, this: Instruction, operands: tuple[int, int]) -> int:
        """What operands save.

        The manual gives the ranges and that they depend on the operands' leading bits. Taken
        here: a long multiply takes a cycle more for each operand that does not fit into 16
        bits, one that accumulates a cycle more again if both don't; a division takes 2 cycles
        for a quotient of 0, else 4 and one for each four bits by which the quotient can be
        long.
        """
        first, second = operands
        if this.name.startswith("s"):
            first, second = _magnitude(first), _magnitude(second)
        if this.name in ("udiv", "sdiv"):
            return division(first, second) - 12
        wide = sum(operand >= 1 << 16 for operand in (first, second))
        if this.name in ("umlal", "smlal"):
            return (0, 1, 3)[wide] - 3
        return wide - 2


def division(dividend: int, divisor: int) -> int:
    """Cycles of a division: 2 to 12."""
    if divisor == 0 or dividend < divisor:
        return 2
    bits = dividend.bit_length() - divisor.bit_length() + 1
    return 4 + -(-bits // 4)


def _magnitude(word: int) -> int:
    return word if word < 1 << 31 else (1 << 32) - word
