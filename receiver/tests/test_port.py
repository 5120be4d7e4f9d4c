"""Opening ports: what can't be had from a real one in a test."""

from __future__ import annotations

import errno

import pytest
import serial

from microbrdf_receiver.errors import CommandError
from microbrdf_receiver.port import Port


@pytest.mark.parametrize(
    ("number", "status", "words"),
    [
        (errno.EACCES, 3, "no permission"),
        (errno.EBUSY, 3, "another program has it open"),
        (errno.ENOENT, 2, "there is no such port"),
    ],
)
def test_reasons(number: int, status: int, words: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise serial.SerialException(number, "could not open port")

    monkeypatch.setattr(serial, "serial_for_url", refuse)
    with pytest.raises(CommandError, match=words) as caught:
        Port("/dev/ttyX", 9600)
    assert caught.value.status == status
    assert "PORT /dev/ttyX" in str(caught.value)
