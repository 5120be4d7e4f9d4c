"""Talks to rp2040js."""

from __future__ import annotations

import json
import shutil
from dataclasses import dataclass
from pathlib import Path

from microbrdf_counter.bench import Bench
from microbrdf_counter.image import Image

_HERE = Path(__file__).parent
#: Where single instructions are put.
ADDRESS = 0x1000_0100


class Missing(Exception):
    """Node.js or the package is not there."""


@dataclass(frozen=True)
class Call:
    """What a call executed, and gave.

    Attributes:
        addresses: Addresses of the instructions, in order.
        cycles: What each took.
        results: The first register, or the words in memory.
    """

    addresses: list[int]
    cycles: list[int]
    results: list[int]


def version() -> str:
    """The version of rp2040js that the lock file holds."""
    lock = json.loads((_HERE / "package-lock.json").read_text(encoding="utf-8"))
    return str(lock["packages"]["node_modules/rp2040js"]["version"])


class Rp2040(Bench):
    """An emulated RP2040."""

    def __init__(self, folder: Path) -> None:
        """Starts it; ``folder`` has the package in its ``node_modules``.

        Raises:
            Missing: It can't be started.
        """
        node = shutil.which("node")
        if node is None:
            raise Missing("Node.js is missing")
        found = folder / "node_modules" / "rp2040js" / "package.json"
        try:
            there = json.loads(found.read_text(encoding="utf-8"))["version"]
        except (OSError, ValueError) as error:
            raise Missing(f"{found}: {error}") from error
        if there != version():
            raise Missing(f"rp2040js {there} is in {folder}, not {version()}")
        super().__init__([node, str(_HERE / "bench.mjs"), str(folder)])

    def __enter__(self) -> Rp2040:
        return self

    def call(self, image: Image, arguments: list[int], memory: list[int], in_memory: int) -> Call:
        """Calls the function of the image that was loaded last."""
        answer = json.loads(self.ask(image.entry, arguments, memory, in_memory))
        return Call(answer["addresses"], answer["cycles"], answer["results"])

    def step(self, register: int, code: bytes) -> tuple[int, int]:
        """Executes one instruction at ``ADDRESS`` with this in r0 to r7 and no flag set.

        Returns:
            Its cycles, and the address after it.
        """
        halves = " ".join(f"{code[i] | code[i + 1] << 8:x}" for i in range(0, len(code), 2))
        self.say(f"step {ADDRESS:x} {register:x} {halves}")
        cycles, after = map(int, self.hear().split())
        return cycles, after
