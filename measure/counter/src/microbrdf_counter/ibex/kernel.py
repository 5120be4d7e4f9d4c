"""Measures one kernel over its calls, as :mod:`microbrdf_counter.kernel` does, on Ibex."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from microbrdf_counter.differs import check
from microbrdf_counter.ibex.simulator import CLOCK_MODEL, CORE, Ibex
from microbrdf_counter.image import Image

TARGET = "riscv32imc-unknown-none-elf"


def measure(program: Path, path: Path, calls: dict[str, Any]) -> dict[str, Any]:
    """Runs a kernel's calls and sums up what they cost.

    Raises:
        Differs: A result is not the one that the host computed.
    """
    image = Image.read(path)
    cycles: dict[str, list[int]] = {}
    instructions: dict[str, list[int]] = {}
    stack = 0
    with Ibex(program, image) as core:
        for group in calls["groups"]:
            name = group["kind"]
            cycles[name], instructions[name] = [], []
            for call in group["calls"]:
                count = len(call["results"]) if call["in_memory"] else 0
                done = core.call(call["arguments"], call["memory"], count)
                check(f"{calls['kernel']} on Ibex", call, done.results)
                cycles[name].append(done.cycles)
                instructions[name].append(done.instructions)
                stack = max(stack, done.stack)
    return {
        "kernel": calls["kernel"],
        "target": TARGET,
        "code_bytes": image.code_bytes,
        "table_bytes": image.table_bytes,
        "ram_bytes": image.ram_bytes,
        "stack_bytes": stack,
        "instructions": instructions,
        "clock_models": {CORE: CLOCK_MODEL},
        "cycles": {CORE: cycles},
    }
