"""Packets with a right checksum that make no sense."""

from __future__ import annotations

import math
import struct

import pytest

from microbrdf_receiver.packets import (
    Fault,
    Header,
    PacketError,
    PixelFormat,
    UnknownKindError,
    VersionError,
    parse,
)


def header(exposure: float | None) -> bytes:
    """A good header, its texts ``b``, ``c``, ``r``, ``a``, ``s``, to be spoilt."""
    body = bytes([1, 1, 0, 0, 2, 0, 1, 0, 1])
    body += b"\0" if exposure is None else b"\1" + struct.pack("<d", exposure)
    return body + b"".join(b"\1" + text for text in (b"b", b"c", b"r", b"a", b"s"))


@pytest.mark.parametrize("exposure", [None, -0.1])
def test_the_good_header_is_good(exposure: float | None) -> None:
    expected = Header(0, 2, 1, PixelFormat.SRGB8, exposure, "b", "c", "r", "a", "s")
    assert parse(header(exposure)) == expected


@pytest.mark.parametrize("exposure", [None, 1.0])
def test_headers_of_another_length(exposure: float | None) -> None:
    good = header(exposure)
    for length in range(1, len(good)):
        with pytest.raises(PacketError, match=f"payload of {length - 1} bytes"):
            parse(good[:length])
    with pytest.raises(PacketError, match="1 bytes too many"):
        parse(good + b"x")


@pytest.mark.parametrize(
    ("place", "byte", "words"),
    [
        (4, 0, "0 x 1 pixels"),
        (6, 0, "2 x 0 pixels"),
        (8, 3, "unknown pixel format 3"),
        (9, 3, "unknown flags 0x03"),
        (21, 0x1F, "core must be printable ASCII"),
        (21, 0x7F, "core must be printable ASCII"),
        (21, 0xFF, "core must be printable ASCII"),
    ],
)
def test_headers_with_a_field_out_of_range(place: int, byte: int, words: str) -> None:
    body = bytearray(header(1.0))
    body[place] = byte
    with pytest.raises(PacketError, match=words):
        parse(bytes(body))


@pytest.mark.parametrize("exposure", [math.inf, -math.inf, math.nan])
def test_exposures_that_are_no_number(exposure: float) -> None:
    with pytest.raises(PacketError, match="must be finite"):
        parse(header(exposure))


def test_headers_with_a_long_text() -> None:
    body = header(None)[:10] + bytes([33]) + b"x" * 33 + bytes(4)
    with pytest.raises(PacketError, match="board is 33 bytes long, must be at most 32"):
        parse(body)


def test_the_version_comes_before_all_else() -> None:
    with pytest.raises(VersionError, match="version 0"):
        parse(bytes([1, 0]))


def test_a_fault_that_is_no_utf8_is_shown_as_far_as_it_is() -> None:
    assert parse(b"\4\1\2\x09pc \xff 12") == Fault(0x201, 9, "pc \N{REPLACEMENT CHARACTER} 12")


@pytest.mark.parametrize("code", [0, 6, 255])
def test_unknown_kinds(code: int) -> None:
    with pytest.raises(UnknownKindError, match=f"kind {code}"):
        parse(bytes([code]))
