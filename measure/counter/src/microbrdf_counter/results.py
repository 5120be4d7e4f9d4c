"""Runs functions for their results alone, on any of the targets, at full speed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import unicorn
from unicorn import riscv_const

from microbrdf_counter.differs import check
from microbrdf_counter.image import Image
from microbrdf_counter.machine import BASE, Machine, Stray

_RISCV = "riscv32imc-unknown-none-elf"
_RAM_BYTES = 0x4_0000
_STACK_TOP = BASE + 0x2_0000
_RETURN = 0x0800_0000
_FLASH, _FLASH_BYTES = 0x1000_0000, 0x10_0000
_ARGUMENTS = [getattr(riscv_const, f"UC_RISCV_REG_A{i}") for i in range(8)]


def compare(path: Path, target: str, calls: dict[str, Any]) -> int:
    """Runs every call of a function that gives one word, and returns how many there were.

    Raises:
        Differs: A result is not the one that the host computed.
    """
    image = Image.read(path)
    machine = None if target == _RISCV else Machine(image, target, traced=False)
    compared = 0
    for group in calls["groups"]:
        for call in group["calls"]:
            arguments = call["arguments"]
            if machine is None:
                found = [_riscv(image, arguments)]
            else:
                found = machine.call(arguments, [], 0).results
            check(f"{calls['kernel']} for {target}", call, found)
            compared += 1
    return compared


def _riscv(image: Image, arguments: list[int]) -> int:
    """What a function gives on a RISC-V core."""
    core = unicorn.Uc(unicorn.UC_ARCH_RISCV, unicorn.UC_MODE_RISCV32)
    core.mem_map(BASE, _RAM_BYTES)
    core.mem_map(_RETURN, 0x1000)
    core.mem_map(_FLASH, _FLASH_BYTES)
    for address, data in image.segments:
        core.mem_write(address, data)
    for register, word in zip(_ARGUMENTS, arguments):
        core.reg_write(register, word)
    core.reg_write(riscv_const.UC_RISCV_REG_SP, _STACK_TOP)
    core.reg_write(riscv_const.UC_RISCV_REG_RA, _RETURN)
    try:
        core.emu_start(image.entry, _RETURN)
    except unicorn.UcError as error:
        raise Stray(str(error)) from error
    return int(core.reg_read(riscv_const.UC_RISCV_REG_A0))
