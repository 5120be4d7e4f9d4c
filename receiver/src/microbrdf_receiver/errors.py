"""Exit statuses, and the errors that carry them."""

from __future__ import annotations

DONE = 0
"""Everything that was asked for was done."""

INCOMPLETE = 1
"""It ran, but the result is incomplete; what arrived is kept and marked."""

USER_MISTAKE = 2
"""An option or a port that makes no sense."""

ENVIRONMENT = 3
"""The machine lacks something; the message says what."""


class CommandError(Exception):
    """Ends the command with a message and an exit status."""

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status
