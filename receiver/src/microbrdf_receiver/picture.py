"""From a frame's bytes to a picture that can be looked at."""

from __future__ import annotations

import struct
from itertools import chain

from PIL import Image

from .frame import Frame
from .packets import PixelFormat

_HATCH_COLOURS = (b"\xff\x00\xff", b"\x00\x00\x00")
_HATCH_WIDTH = 4

# The nearest 8-bit code to each 5-bit and 6-bit one.
_FROM_5_BITS = [(code * 255 * 2 + 31) // (31 * 2) for code in range(32)]
_FROM_6_BITS = [(code * 255 * 2 + 63) // (63 * 2) for code in range(64)]


def hatch(column: int, row: int) -> bytes:
    """Colour of a pixel that has not come: diagonal stripes of magenta and black."""
    return _HATCH_COLOURS[(column + row) // _HATCH_WIDTH % 2]


def expand_rgb565(packed: bytes) -> bytes:
    """Turn little-endian RGB565 into three bytes for each pixel.

    Each channel becomes the nearest 8-bit code, so 0 and full scale stay what
    they are; packing the result again gives the same 16 bits.
    """
    return bytes(
        chain.from_iterable(
            (_FROM_5_BITS[value >> 11], _FROM_6_BITS[value >> 5 & 63], _FROM_5_BITS[value & 31])
            for (value,) in struct.iter_unpack("<H", packed)
        )
    )


def to_image(frame: Frame) -> Image.Image:
    """Make an RGB image of a frame, with a hatch where pixels are missing."""
    width, height = frame.header.width, frame.header.height
    if frame.header.pixel_format is PixelFormat.RGB565:
        rgb = bytearray(expand_rgb565(bytes(frame.pixels)))
    else:
        rgb = bytearray(frame.pixels)
    position = frame.present.find(0)
    while position >= 0:
        row, column = divmod(position, width)
        rgb[position * 3 : position * 3 + 3] = hatch(column, row)
        position = frame.present.find(0, position + 1)
    return Image.frombytes("RGB", (width, height), bytes(rgb))
