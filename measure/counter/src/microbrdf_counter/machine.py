"""An emulated core that runs one function and remembers which instructions it executed."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from itertools import accumulate

import unicorn
from unicorn import arm_const

from microbrdf_counter.image import Image
from microbrdf_counter.instructions import Instruction, disassemble

#: Where arguments in memory lie: the beginning of RAM.
BASE = 0x2000_0000
_RAM_BYTES = 0x4_0000
_STACK_TOP = BASE + 0x2_0000
#: Where the function returns to; nothing lies there.
_RETURN = 0x0800_0000
_PAGE = 0x1000

_MODELS = {
    "thumbv6m-none-eabi": arm_const.UC_CPU_ARM_CORTEX_M0,
    "thumbv7m-none-eabi": arm_const.UC_CPU_ARM_CORTEX_M3,
    "thumbv7em-none-eabihf": arm_const.UC_CPU_ARM_CORTEX_M4,
}
_REGISTERS = {f"r{i}": getattr(arm_const, f"UC_ARM_REG_R{i}") for i in range(13)} | {
    "sb": arm_const.UC_ARM_REG_R9,
    "sl": arm_const.UC_ARM_REG_R10,
    "fp": arm_const.UC_ARM_REG_R11,
    "ip": arm_const.UC_ARM_REG_R12,
    "lr": arm_const.UC_ARM_REG_LR,
}


class Stray(Exception):
    """The function did what it may not: it ran off, or into nothing."""


@dataclass
class Trace:
    """What a call executed.

    Attributes:
        addresses: Addresses of the instructions, in order; one whose condition fails within
            an IT block is not among them.
        operands: How often an instruction met a pair of operands, by address and operands.
        results: Registers or words of memory that the function gave back.
        stack: Bytes of stack that it took, its arguments on the stack left out.
    """

    addresses: list[int] = field(default_factory=list)
    operands: Counter[tuple[int, int, int]] = field(default_factory=Counter)
    results: list[int] = field(default_factory=list)
    stack: int = 0


class Machine:
    """A core with an image in its flash."""

    def __init__(self, image: Image, target: str, traced: bool = True) -> None:
        """Loads ``image``, compiled for ``target``; untraced, it is fast and only gives results."""
        self.code: dict[int, Instruction] = disassemble(image)
        self._entry = image.entry
        self._uc = unicorn.Uc(unicorn.UC_ARCH_ARM, unicorn.UC_MODE_THUMB | unicorn.UC_MODE_MCLASS)
        self._uc.ctl_set_cpu_model(_MODELS[target])
        self._uc.mem_map(BASE, _RAM_BYTES)
        self._uc.mem_map(_RETURN, _PAGE)
        mapped: set[int] = set()
        for address, data in image.segments:
            if BASE <= address < BASE + _RAM_BYTES:
                self._uc.mem_write(address, data)
                continue
            for page in range(address // _PAGE, (address + len(data) - 1) // _PAGE + 1):
                if page not in mapped:
                    self._uc.mem_map(page * _PAGE, _PAGE)
                    mapped.add(page)
            self._uc.mem_write(address, data)
        self._trace = Trace()
        self._watched, self._lowest = False, _STACK_TOP
        if not traced:
            return
        # What moves the stack pointer by a register's value is watched.
        self._watched = any(instruction.stack is None for instruction in self.code.values())
        executes = self._watches if self._watched else self._executes
        self._uc.hook_add(unicorn.UC_HOOK_CODE, executes)
        for instruction in self.code.values():
            at = instruction.address
            if instruction.name in ("udiv", "sdiv", "umull", "smull", "umlal", "smlal"):
                self._uc.hook_add(unicorn.UC_HOOK_CODE, self._operates, None, at, at)

    def _executes(self, _uc: object, address: int, _size: int, _data: object) -> None:
        self._trace.addresses.append(address)

    def _watches(self, uc: unicorn.Uc, address: int, _size: int, _data: object) -> None:
        self._trace.addresses.append(address)
        self._lowest = min(self._lowest, uc.reg_read(arm_const.UC_ARM_REG_SP))

    def _operates(self, _uc: object, address: int, _size: int, _data: object) -> None:
        names = self.code[address].operands[-2:]
        first, second = (self._uc.reg_read(_REGISTERS[name]) for name in names)
        self._trace.operands[address, first, second] += 1

    def call(self, arguments: list[int], memory: list[int], in_memory: int) -> Trace:
        """Calls the function.

        Args:
            arguments: Words of the arguments: four in registers, the rest on the stack.
            memory: Words from ``BASE`` on.
            in_memory: Words that come back behind ``memory``; 0 for the first two registers.
        """
        uc = self._uc
        self._trace = Trace()
        self._lowest = _STACK_TOP
        words = b"".join(word.to_bytes(4, "little") for word in memory)
        uc.mem_write(BASE, words + bytes(4 * in_memory))
        registers, on_stack = arguments[:4], arguments[4:]
        # The stack pointer is a multiple of 8 at a call.
        top = _STACK_TOP - 8 * ((len(on_stack) + 1) // 2)
        for i, word in enumerate(on_stack):
            uc.mem_write(top + 4 * i, word.to_bytes(4, "little"))
        for name, word in zip(("r0", "r1", "r2", "r3"), registers):
            uc.reg_write(_REGISTERS[name], word)
        uc.reg_write(arm_const.UC_ARM_REG_SP, top)
        uc.reg_write(arm_const.UC_ARM_REG_LR, _RETURN | 1)
        try:
            uc.emu_start(self._entry | 1, _RETURN)
        except unicorn.UcError as error:
            at = uc.reg_read(arm_const.UC_ARM_REG_PC)
            raise Stray(f"{error} at {at:#x}") from error
        trace = self._trace
        if uc.reg_read(arm_const.UC_ARM_REG_SP) != top:
            raise Stray("the stack pointer is not where it was")
        trace.stack = self._depth(trace, top)
        if in_memory:
            back = bytes(uc.mem_read(BASE + len(words), 4 * in_memory))
            trace.results = [
                int.from_bytes(back[i : i + 4], "little") for i in range(0, len(back), 4)
            ]
        else:
            trace.results = [uc.reg_read(_REGISTERS[name]) for name in ("r0", "r1")]
        return trace

    def _depth(self, trace: Trace, top: int) -> int:
        """The deepest that the stack pointer goes below where it was."""
        if self._watched:
            return top - self._lowest
        moves = {address: self.code[address].stack or 0 for address in set(trace.addresses)}
        return -min(accumulate(map(moves.__getitem__, trace.addresses)), default=0)
