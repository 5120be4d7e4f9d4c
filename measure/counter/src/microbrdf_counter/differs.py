"""What a function gives back, held against what the host gave."""

from __future__ import annotations

from typing import Any


class Differs(Exception):
    """A result is not the one that the host gives."""


def check(name: str, call: dict[str, Any], found: list[int]) -> None:
    """Compares as many words as the host gives: a register behind a result holds anything.

    Raises:
        Differs: They are not the same; ``name`` says whose they are.
    """
    wanted = call["results"]
    if found[: len(wanted)] != wanted:
        raise Differs(
            f"{name} gives {found} for {call['arguments']} {call['memory']}, the host {wanted}"
        )
