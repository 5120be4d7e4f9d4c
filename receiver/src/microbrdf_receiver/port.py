"""The line that the device is on."""

from __future__ import annotations

import contextlib
import errno
import time
from types import TracebackType

import serial
from serial.tools import list_ports

from .errors import ENVIRONMENT, USER_MISTAKE, CommandError

_FAILURES: tuple[type[Exception], ...] = (serial.SerialException, OSError, ValueError)
with contextlib.suppress(ImportError):  # Windows has none
    import termios

    # pyserial lets these through.
    _FAILURES = (*_FAILURES, termios.error)

# After a disconnection pyserial may stumble over its own closed descriptor.
_READ_FAILURES: tuple[type[Exception], ...] = (*_FAILURES, TypeError)

_PAUSE = 0.002
_GULP = 65536


class PortLostError(Exception):
    """The line is gone: unplugged, or closed at the other end."""


class Port:
    """An open line, for reading."""

    def __init__(self, url: str, baud: int) -> None:
        """Open anything that ``serial_for_url`` opens.

        Raises:
            CommandError: if it can't be opened.
        """
        try:
            # Without a timeout a read takes what is there in one call: pyserial
            # loses what it has read if the line is lost while it waits for more.
            self._serial = serial.serial_for_url(url, baudrate=baud, timeout=0, do_not_open=True)
            _keep_input_while_opening(self._serial)
            self._serial.open()
        except _FAILURES as error:
            raise _explained(url, error) from error

    def read(self, seconds: float) -> bytes:
        """Wait for bytes, at most so long, and give what has come.

        Raises:
            PortLostError: if nothing more can come.
        """
        deadline = time.monotonic() + seconds
        while True:
            try:
                data = self._serial.read(_GULP)
            except _READ_FAILURES as error:
                raise PortLostError(str(error)) from error
            if data or time.monotonic() >= deadline:
                return bytes(data)
            time.sleep(_PAUSE)

    def __enter__(self) -> Port:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        with contextlib.suppress(*_FAILURES):
            self._serial.close()


def _keep_input_while_opening(port: serial.SerialBase) -> None:
    """Keep pyserial from dropping what the device sent before the port was opened.

    It empties the input as it opens: of a socket or a pty, whose other end may
    have begun already, that is the beginning of the frame. The first name is
    what its URL handlers call, the second one what its POSIX class calls.
    """
    for name in ("reset_input_buffer", "_reset_input_buffer"):
        if hasattr(port, name):
            setattr(port, name, lambda: None)


def _explained(url: str, error: BaseException) -> CommandError:
    number = getattr(error, "errno", None)
    if number in (errno.EACCES, errno.EPERM):
        return CommandError(
            ENVIRONMENT,
            f"PORT {url}: no permission to open it; "
            "on Linux a member of the group that owns it (often dialout) has it",
        )
    if number == errno.EBUSY:
        return CommandError(ENVIRONMENT, f"PORT {url}: another program has it open")
    if "://" in url:
        form = "; the form is socket://HOST:PORT" if url.startswith("socket:") else ""
        return CommandError(USER_MISTAKE, f"PORT {url}: cannot be opened: {error}{form}")
    if number == errno.ENOENT:
        reason = "there is no such port"
    else:
        reason = f"cannot be opened as a serial port: {error}"
    known = ", ".join(port.device for port in list_ports.comports()) or "none"
    return CommandError(USER_MISTAKE, f"PORT {url}: {reason} (ports on this machine: {known})")
