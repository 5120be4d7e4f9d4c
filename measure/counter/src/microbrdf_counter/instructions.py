"""Thumb instructions, as far as their timing depends on them."""

from __future__ import annotations

from dataclasses import dataclass

import capstone
from capstone import arm

from microbrdf_counter.image import Image

_NAMES = {
    arm.ARM_CC_EQ: "eq",
    arm.ARM_CC_NE: "ne",
    arm.ARM_CC_HS: "hs",
    arm.ARM_CC_LO: "lo",
    arm.ARM_CC_MI: "mi",
    arm.ARM_CC_PL: "pl",
    arm.ARM_CC_VS: "vs",
    arm.ARM_CC_VC: "vc",
    arm.ARM_CC_HI: "hi",
    arm.ARM_CC_LS: "ls",
    arm.ARM_CC_GE: "ge",
    arm.ARM_CC_LT: "lt",
    arm.ARM_CC_GT: "gt",
    arm.ARM_CC_LE: "le",
}


@dataclass(frozen=True)
class Instruction:
    """One instruction.

    Attributes:
        address: Where it lies.
        size: 2 or 4 bytes.
        text: As one would write it.
        name: Its mnemonic without condition and width, such as ``ldr`` or ``vmul.f32``.
        condition: The condition of a branch or within an IT block; "" where there is none.
        count: Registers that a multiple transfer moves; a 64-bit one counts twice.
        writes_pc: Whether it changes the program counter by other means than going on.
        reads: Registers that it reads.
        writes: Registers that it writes.
        operands: Registers in the order in which they are written.
        base: Registers that form an address.
        register_offset: Whether the address is a sum of registers.
        stack: By how many bytes it moves the stack pointer; None where that is not constant.
    """

    address: int
    size: int
    text: str
    name: str
    condition: str
    count: int
    writes_pc: bool
    reads: frozenset[str]
    writes: frozenset[str]
    operands: tuple[str, ...]
    base: frozenset[str]
    register_offset: bool
    stack: int | None


def disassemble(image: Image) -> dict[int, Instruction]:
    """Every instruction of an image by its address."""
    found = {}
    for low, high in image.code:
        for start, data in image.segments:
            if start <= low < start + len(data):
                for instruction in decode(data[low - start : high - start], low):
                    found[instruction.address] = instruction
    return found


def decode(data: bytes, address: int) -> list[Instruction]:
    """The instructions of a piece of code."""
    reader = capstone.Cs(capstone.CS_ARCH_ARM, capstone.CS_MODE_THUMB | capstone.CS_MODE_MCLASS)
    reader.detail = True
    return [_instruction(raw) for raw in reader.disasm(data, address)]


def _instruction(raw: capstone.CsInsn) -> Instruction:
    condition = _NAMES.get(raw.cc, "")
    reads, writes = raw.regs_access()
    read = frozenset(raw.reg_name(register) for register in reads)
    written = frozenset(raw.reg_name(register) for register in writes)
    memory = [operand.mem for operand in raw.operands if operand.type == arm.ARM_OP_MEM]
    base = {raw.reg_name(part.base) for part in memory if part.base}
    index = {raw.reg_name(part.index) for part in memory if part.index}
    name = _name(raw, condition)
    return Instruction(
        address=raw.address,
        size=raw.size,
        text=f"{raw.mnemonic} {raw.op_str}",
        name=name,
        condition=condition,
        count=_count(raw, name),
        writes_pc="pc" in written or name in ("b", "bl", "bx", "blx", "cbz", "cbnz", "tbb", "tbh"),
        reads=read,
        writes=written,
        operands=tuple(
            raw.reg_name(operand.reg) for operand in raw.operands if operand.type == arm.ARM_OP_REG
        ),
        base=frozenset(base | index),
        register_offset=bool(index),
        stack=_stack(raw, name, written),
    )


def _name(raw: capstone.CsInsn, condition: str) -> str:
    """The mnemonic without width, condition and the S of those that set flags."""
    name: str = raw.mnemonic
    if name.endswith(".w"):
        name = name[:-2]
    head, dot, tail = name.partition(".")
    if head.startswith("it") and set(head[2:]) <= {"t", "e"}:
        return "it"
    if condition and head.endswith(condition):
        head = head[: -len(condition)]
    # `vmrs`, `mrs` and the like end in an s of their own.
    if raw.update_flags and head.endswith("s") and not head.startswith("v") and head != "mrs":
        head = head[:-1]
    return head + dot + tail


def _count(raw: capstone.CsInsn, name: str) -> int:
    registers = [
        raw.reg_name(operand.reg) for operand in raw.operands if operand.type == arm.ARM_OP_REG
    ]
    if name in ("push", "pop", "vpush", "vpop"):
        listed = registers
    elif name.startswith(("ldm", "stm", "vldm", "vstm")):
        listed = registers[1:]
    elif name in ("ldrd", "strd"):
        return 2
    else:
        listed = [register for register in registers[:1] if register[0] in "sd"]
    return sum(2 if register[0] == "d" else 1 for register in listed)


def _stack(raw: capstone.CsInsn, name: str, written: frozenset[str]) -> int | None:
    if "sp" not in written:
        return 0
    count = _count(raw, name)
    if name in ("push", "vpush"):
        return -4 * count
    if name in ("pop", "vpop"):
        return 4 * count
    if name in ("stmdb", "vstmdb"):
        return -4 * count
    if name in ("ldm", "ldmia", "vldmia"):
        return 4 * count
    last = raw.operands[-1]
    if name in ("add", "sub", "addw", "subw") and last.type == arm.ARM_OP_IMM:
        return int(last.imm if name.startswith("add") else -last.imm)
    memory = [operand for operand in raw.operands if operand.type == arm.ARM_OP_MEM]
    if name in ("str", "ldr", "strd", "ldrd") and memory:
        # With write-back: before the access, or after it by a separate operand.
        moved = last.imm if last.type == arm.ARM_OP_IMM else memory[0].mem.disp
        return int(-moved if last.type == arm.ARM_OP_IMM and last.subtracted else moved)
    return None
