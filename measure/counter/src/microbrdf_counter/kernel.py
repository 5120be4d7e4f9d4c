"""Measures one kernel over its calls."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

from microbrdf_counter.count import classes, costs, cycles
from microbrdf_counter.differs import check
from microbrdf_counter.image import Image
from microbrdf_counter.machine import Machine
from microbrdf_counter.timings import TIMINGS


def measure(path: Path, target: str, calls: dict[str, Any]) -> dict[str, Any]:
    """Runs a kernel's calls and sums up what they cost, core by core.

    Raises:
        Differs: A result is not the one that the host computed.
    """
    image = Image.read(path)
    machine = Machine(image, target)
    timings = TIMINGS[target]
    of_calls: dict[str, dict[str, list[int]]] = {core: {} for core in timings}
    instructions: dict[str, list[int]] = {}
    kinds: Counter[str] = Counter()
    executed: Counter[int] = Counter()
    spent: dict[str, Counter[int]] = {core: Counter() for core in timings}
    stack = 0
    for group in calls["groups"]:
        name = group["kind"]
        instructions[name] = []
        for of_core in of_calls.values():
            of_core[name] = []
        for call in group["calls"]:
            count = len(call["results"]) if call["in_memory"] else 0
            trace = machine.call(call["arguments"], call["memory"], count)
            check(f"{calls['kernel']} for {target}", call, trace.results)
            stack = max(stack, trace.stack)
            instructions[name].append(len(trace.addresses))
            if name == "lobe":
                kinds += classes(machine.code, trace)
                executed.update(trace.addresses)
                for core, timing in timings.items():
                    spent[core].update(costs(machine.code, trace, timing))
            for core, timing in timings.items():
                of_calls[core][name].append(cycles(machine.code, trace, timing))
    total = max(1, len(instructions.get("lobe", [])))
    return {
        "kernel": calls["kernel"],
        "target": target,
        "code_bytes": image.code_bytes,
        "table_bytes": image.table_bytes,
        "ram_bytes": image.ram_bytes,
        "stack_bytes": stack,
        "instructions": instructions,
        "kinds": {kind: times / total for kind, times in sorted(kinds.items())},
        "clock_models": {core: timing.clock_model for core, timing in timings.items()},
        "cycles": of_calls,
        "listing": [
            {
                "text": machine.code[address].text,
                "executed": executed[address] / total,
                "cycles": {core: found[address] / total for core, found in spent.items()},
            }
            for address in sorted(machine.code)
        ],
    }
