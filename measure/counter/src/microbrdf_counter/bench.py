"""A simulator in a process of its own, that is told what to do line by line."""

from __future__ import annotations

import subprocess
from types import TracebackType

from microbrdf_counter.image import Image


class Fails(Exception):
    """The simulator ended early."""


class Bench:
    """A simulated core."""

    def __init__(self, command: list[str]) -> None:
        """Starts ``command``."""
        self._process = subprocess.Popen(  # noqa: S603
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def __enter__(self) -> Bench:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Ends the simulator."""
        self._process.communicate()

    def load(self, image: Image) -> None:
        """Puts an image into its flash."""
        # Segments can share a word: the bytes of one must not be lost to the other's padding.
        words: dict[int, bytearray] = {}
        for address, data in image.segments:
            for place, byte in enumerate(data, address):
                words.setdefault(place & ~3, bytearray(4))[place & 3] = byte
        for address, word in sorted(words.items()):
            self.say(f"load {address:x} {int.from_bytes(word, 'little'):x}")

    def say(self, line: str) -> None:
        """Tells it something."""
        if self._process.stdin is None:
            raise Fails("no way to talk to the simulator")
        try:
            self._process.stdin.write(line + "\n")
            self._process.stdin.flush()
        except BrokenPipeError as error:
            raise Fails("the simulator ended") from error

    def hear(self) -> str:
        """Its next answer."""
        answer = self._process.stdout.readline() if self._process.stdout else ""
        if not answer:
            raise Fails("the simulator ended")
        return answer

    def ask(self, entry: int, arguments: list[int], memory: list[int], in_memory: int) -> str:
        """What it says to a call."""
        self.say(f"call {entry:x} {hexadecimal(arguments)} / {hexadecimal(memory)} / {in_memory:x}")
        return self.hear()


def hexadecimal(words: list[int]) -> str:
    """Words as a simulator reads them."""
    return " ".join(f"{word:x}" for word in words)
