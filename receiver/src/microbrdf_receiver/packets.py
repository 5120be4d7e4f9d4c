"""The kinds of packet and their checked meaning."""

from __future__ import annotations

import enum
import math
import struct
from dataclasses import dataclass
from typing import Union

PROTOCOL_VERSION = 1
"""The one version of the protocol that is understood here."""

MAX_PACKET = 254
"""Greatest length of a packet in bytes, checksum included."""

MAX_CHUNK = 240
"""Greatest number of pixel bytes in one packet."""

_HAS_EXPOSURE = 1
_TEXTS = {"board": 32, "core": 32, "compiler": 96, "arithmetic": 32, "scene": 32}


class PacketError(ValueError):
    """A packet with a right checksum that makes no sense."""


class UnknownKindError(PacketError):
    """A kind that this version of the protocol does not know."""

    def __init__(self, code: int) -> None:
        super().__init__(f"unknown kind {code}")
        self.code = code


class VersionError(PacketError):
    """A header of another version of the protocol."""

    def __init__(self, version: int) -> None:
        super().__init__(
            f"the device speaks version {version} of the protocol, "
            f"this receiver version {PROTOCOL_VERSION}: "
            "use the firmware and the receiver of one release"
        )
        self.version = version


class Kind(enum.IntEnum):
    """First byte of a packet."""

    HEADER = 1
    PIXELS = 2
    END = 3
    FAULT = 4
    LOG = 5


class PixelFormat(enum.Enum):
    """How a pixel is laid out; the value is its code in the header."""

    SRGB8 = 1
    RGB565 = 2

    @property
    def bytes_per_pixel(self) -> int:
        """3 or 2."""
        return 3 if self is PixelFormat.SRGB8 else 2

    @property
    def label(self) -> str:
        """The name that reports use."""
        return self.name.lower()


@dataclass(frozen=True)
class Header:
    """Who sends, and what the picture is. Texts may be empty."""

    frame: int
    width: int
    height: int
    pixel_format: PixelFormat
    exposure: float | None
    board: str
    core: str
    compiler: str
    arithmetic: str
    scene: str


@dataclass(frozen=True)
class Pixels:
    """Consecutive pixels of one row."""

    frame: int
    row: int
    column: int
    data: bytes


@dataclass(frozen=True)
class EndOfFrame:
    """The frame is over: rows that were sent, CRC-32 of all pixel bytes."""

    frame: int
    rows: int
    checksum: int


@dataclass(frozen=True)
class Fault:
    """The device failed."""

    frame: int
    code: int
    text: str

    @property
    def name(self) -> str:
        """What the code means."""
        return {1: "panic", 2: "hard fault"}.get(self.code, f"fault {self.code}")


@dataclass(frozen=True)
class Log:
    """Bytes of the device's log."""

    data: bytes


Packet = Union[Header, Pixels, EndOfFrame, Fault, Log]


def parse(body: bytes) -> Packet:
    """Give the meaning of a packet, from its kind up to its checksum.

    Raises:
        VersionError: for a header of another version.
        UnknownKindError: for a kind that is to be passed over.
        PacketError: for anything else that makes no sense.
    """
    code, payload = body[0], body[1:]
    try:
        kind = Kind(code)
    except ValueError:
        raise UnknownKindError(code) from None
    try:
        if kind is Kind.HEADER:
            return _parse_header(payload)
        if kind is Kind.PIXELS:
            return _parse_pixels(payload)
        if kind is Kind.END:
            return EndOfFrame(*struct.unpack("<HHI", payload))
        if kind is Kind.FAULT:
            frame, fault_code = struct.unpack_from("<HB", payload)
            return Fault(frame, fault_code, payload[3:].decode("utf-8", errors="replace"))
        return Log(payload)
    except struct.error:
        raise PacketError(
            f"a {kind.name.lower()} packet cannot have a payload of {len(payload)} bytes"
        ) from None


def _parse_pixels(payload: bytes) -> Pixels:
    frame, row, column = struct.unpack_from("<HHH", payload)
    data = payload[6:]
    if not 1 <= len(data) <= MAX_CHUNK:
        raise PacketError(f"{len(data)} bytes of pixels, must be 1 to {MAX_CHUNK}")
    return Pixels(frame, row, column, data)


def _parse_header(payload: bytes) -> Header:
    (version,) = struct.unpack_from("<B", payload)
    if version != PROTOCOL_VERSION:
        raise VersionError(version)
    frame, width, height, format_code, flags = struct.unpack_from("<HHHBB", payload, 1)
    position = 9
    if width == 0 or height == 0:
        raise PacketError(f"a frame of {width} x {height} pixels")
    try:
        pixel_format = PixelFormat(format_code)
    except ValueError:
        raise PacketError(f"unknown pixel format {format_code}") from None
    if flags & ~_HAS_EXPOSURE:
        raise PacketError(f"unknown flags {flags:#04x}")
    exposure: float | None = None
    if flags & _HAS_EXPOSURE:
        (exposure,) = struct.unpack_from("<d", payload, position)
        position += 8
        if exposure is None or not math.isfinite(exposure):
            raise PacketError(f"exposure is {exposure}, must be finite")
    texts = []
    for name, greatest in _TEXTS.items():
        (length,) = struct.unpack_from("<B", payload, position)
        (text,) = struct.unpack_from(f"{length}s", payload, position + 1)
        position += 1 + length
        if length > greatest:
            raise PacketError(f"{name} is {length} bytes long, must be at most {greatest}")
        if any(not 0x20 <= byte <= 0x7E for byte in text):
            raise PacketError(f"{name} must be printable ASCII")
        texts.append(text.decode("ascii"))
    if position != len(payload):
        raise PacketError(f"{len(payload) - position} bytes too many in a header")
    return Header(frame, width, height, pixel_format, exposure, *texts)
