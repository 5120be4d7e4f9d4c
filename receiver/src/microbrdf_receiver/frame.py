"""A frame as far as it has come."""

from __future__ import annotations

import enum
import zlib
from dataclasses import dataclass, field

from .packets import Fault, Header, PacketError, Pixels

MAX_PIXELS = 1 << 24
"""Greatest number of pixels of a frame that is received."""


class Stopped(enum.Enum):
    """What ended a frame."""

    END = "end of frame"
    NEXT_FRAME = "next frame"
    FAULT = "fault"
    SILENCE = "silence"
    PORT_LOST = "port lost"
    INTERRUPTED = "interrupted"
    REFUSED = "refused"


@dataclass
class Counts:
    """What came over the line while a frame was awaited and received.

    Attributes:
        bytes_on_wire: all bytes.
        noise: damaged packets before the first good one.
        crc_errors: damaged packets after it.
        duplicates: packets of pixels that brought nothing new.
        strays: pixels and ends of another frame.
        senseless: packets with a right checksum that make no sense.
    """

    bytes_on_wire: int = 0
    noise: int = 0
    crc_errors: int = 0
    duplicates: int = 0
    strays: int = 0
    senseless: int = 0


@dataclass
class Frame:
    """The pixels of a frame, and which of them have come.

    Attributes:
        header: what the device said of it.
        pixels: all pixel bytes in raster order, 0 where nothing has come.
        present: one byte for each pixel, 1 if it has come.
        sent_checksum: the device's CRC-32 of all pixel bytes, once its end has come.
        fault: the failure that ended it.
        stopped: what ended it, None while it is being received.
    """

    header: Header
    pixels: bytearray = field(repr=False)
    present: bytearray = field(repr=False)
    counts: Counts = field(default_factory=Counts)
    sent_checksum: int | None = None
    fault: Fault | None = None
    stopped: Stopped | None = None

    @classmethod
    def begin(cls, header: Header) -> Frame:
        """Begin a frame of which nothing has come yet.

        Raises:
            PacketError: if it is larger than `MAX_PIXELS`.
        """
        size = header.width * header.height
        if size > MAX_PIXELS:
            raise PacketError(
                f"a frame of {header.width} x {header.height} pixels is larger than "
                f"this receiver takes, {MAX_PIXELS} pixels"
            )
        return cls(header, bytearray(size * header.pixel_format.bytes_per_pixel), bytearray(size))

    def place(self, pixels: Pixels) -> bool:
        """Put pixels where they belong; later ones overwrite earlier ones.

        Returns:
            whether any of them is new.

        Raises:
            PacketError: if they do not lie in the frame or are no whole number.
        """
        size = self.header.pixel_format.bytes_per_pixel
        count, rest = divmod(len(pixels.data), size)
        if rest or pixels.row >= self.header.height or pixels.column + count > self.header.width:
            raise PacketError(
                f"{len(pixels.data)} bytes from column {pixels.column} of row {pixels.row} on "
                "do not fit into the frame"
            )
        first = pixels.row * self.header.width + pixels.column
        self.pixels[first * size : (first + count) * size] = pixels.data
        new = 0 in self.present[first : first + count]
        self.present[first : first + count] = b"\1" * count
        return new

    def has_row(self, row: int) -> bool:
        """Whether all pixels of a row have come."""
        start = row * self.header.width
        return 0 not in self.present[start : start + self.header.width]

    @property
    def missing_rows(self) -> list[int]:
        """Numbers of the rows that are not whole."""
        return [row for row in range(self.header.height) if not self.has_row(row)]

    @property
    def checksum_ok(self) -> bool | None:
        """Whether the frame's checksum agrees; None if it can't be known."""
        if self.sent_checksum is None or 0 in self.present:
            return None
        return zlib.crc32(self.pixels) == self.sent_checksum

    @property
    def is_whole(self) -> bool:
        """Whether every pixel came and the device's checksum confirms them."""
        return self.checksum_ok is True
