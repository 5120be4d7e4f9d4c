"""A sender for the tests, written from docs/wire-format.md alone."""

from __future__ import annotations

import struct
import zlib
from dataclasses import dataclass, replace
from functools import cached_property

CHUNK = 240


def cobs_encode(data: bytes) -> bytes:
    encoded = bytearray()
    for run in data.split(b"\0"):
        rest = run
        while len(rest) >= 254:
            encoded += b"\xff" + rest[:254]
            rest = rest[254:]
        encoded += bytes([len(rest) + 1]) + rest
    return bytes(encoded)


def packet(body: bytes, fresh: bool = False) -> bytes:
    """A packet on the wire: checksum, COBS, delimiters."""
    framed = cobs_encode(body + struct.pack("<I", zlib.crc32(body))) + b"\0"
    return b"\0" + framed if fresh else framed


@dataclass(frozen=True)
class Sent:
    """A frame to be sent."""

    width: int = 100
    height: int = 5
    pixel_format: int = 1
    frame: int = 0
    exposure: float | None = None
    board: str = "bench"
    core: str = "host"
    compiler: str = "rustc"
    arithmetic: str = "q31"
    scene: str = "stripes"
    version: int = 1

    @property
    def row_bytes(self) -> int:
        return self.width * (3 if self.pixel_format == 1 else 2)

    @cached_property
    def data(self) -> bytes:
        """Pixel bytes in which no two neighbours are alike and zeros occur."""
        count = self.row_bytes * self.height
        return bytes((i * 7 + i // 256 * 13 + self.frame) % 256 for i in range(count))

    def header(self) -> bytes:
        body = struct.pack(
            "<BBHHHB", 1, self.version, self.frame, self.width, self.height, self.pixel_format
        )
        if self.exposure is None:
            body += b"\0"
        else:
            body += b"\1" + struct.pack("<d", self.exposure)
        for text in (self.board, self.core, self.compiler, self.arithmetic, self.scene):
            body += bytes([len(text)]) + text.encode("ascii")
        return packet(body, fresh=True)

    def packets(self, data: bytes | None = None) -> list[bytes]:
        """Header, pixels, end; the header again before every 32nd row."""
        data = self.data if data is None else data
        size = self.row_bytes // self.width
        found = [self.header()]
        for row in range(self.height):
            if row % 32 == 0 and row > 0:
                found.append(self.header())
            line = data[row * self.row_bytes : (row + 1) * self.row_bytes]
            for start in range(0, len(line), CHUNK):
                found.append(pixels(self.frame, row, start // size, line[start : start + CHUNK]))
        found.append(end(self.frame, self.height, zlib.crc32(data)))
        return found

    def wire(self, data: bytes | None = None) -> bytes:
        return b"".join(self.packets(data))

    def numbered(self, frame: int) -> Sent:
        return replace(self, frame=frame)


def pixels(frame: int, row: int, column: int, data: bytes) -> bytes:
    return packet(struct.pack("<BHHH", 2, frame, row, column) + data)


def end(frame: int, rows: int, checksum: int) -> bytes:
    return packet(struct.pack("<BHHI", 3, frame, rows, checksum))


def fault(frame: int, code: int, text: str) -> bytes:
    return packet(struct.pack("<BHB", 4, frame, code) + text.encode(), fresh=True)


def log(data: bytes) -> bytes:
    return packet(b"\5" + data, fresh=True)
