"""From a frame's bytes to a picture."""

from __future__ import annotations

import struct

import sender

from microbrdf_receiver.assemble import FrameBegins, FrameEnds, Reassembler
from microbrdf_receiver.frame import Frame, Stopped
from microbrdf_receiver.picture import expand_rgb565, to_image

MAGENTA, BLACK = (255, 0, 255), (0, 0, 0)


def received(wire: bytes) -> Frame:
    assembler = Reassembler()
    events = [*assembler.feed(wire), *assembler.finish(Stopped.SILENCE)]
    (frame,) = (event.frame for event in events if isinstance(event, FrameEnds))
    return frame


def test_srgb8_is_left_as_it_is() -> None:
    sent = sender.Sent(7, 3)
    image = to_image(received(sent.wire()))
    assert image.mode == "RGB"
    assert image.size == (7, 3)
    assert image.tobytes() == sent.data


def test_rgb565_channels_and_byte_order() -> None:
    packed = struct.pack("<5H", 0xFFFF, 31 << 11, 63 << 5, 31, 0)
    expected = bytes.fromhex("ffffff ff0000 00ff00 0000ff 000000")
    assert expand_rgb565(packed) == expected
    sent = sender.Sent(5, 1, pixel_format=2)
    assert to_image(received(sent.wire(packed))).tobytes() == expected


def test_rgb565_becomes_the_nearest_code_and_packs_back() -> None:
    for value in range(64):
        packed = struct.pack("<H", (value & 31) << 11 | value << 5 | value & 31)
        red, green, blue = expand_rgb565(packed)
        assert abs(red - (value & 31) * 255 / 31) <= 0.5
        assert abs(green - value * 255 / 63) <= 0.5
        assert blue == red
        assert round(red * 31 / 255) == value & 31
        assert round(green * 63 / 255) == value


def test_missing_pixels_are_hatched_and_no_others() -> None:
    sent = sender.Sent(100, 20)
    packets = sent.packets()
    # The second half of row 1 and all of row 3, of two packets each.
    del packets[7:9]
    del packets[4]
    frame = received(b"".join(packets))
    assert frame.missing_rows == [1, 3]
    image = to_image(frame)
    for row in range(20):
        for column in range(100):
            pixel = image.getpixel((column, row))
            if row == 3 or (row == 1 and column >= 80):
                striped = (column + row) // 4 % 2 == 0
                assert pixel == (MAGENTA if striped else BLACK)
            else:
                start = (row * 100 + column) * 3
                assert pixel == tuple(sent.data[start : start + 3])


def test_a_frame_of_which_nothing_came_is_all_hatch() -> None:
    assembler = Reassembler()
    (event,) = assembler.feed(sender.Sent(16, 16, pixel_format=2).header())
    assert isinstance(event, FrameBegins)
    colours = to_image(event.frame).getcolors()
    assert colours is not None
    assert sorted(colour for _, colour in colours) == [BLACK, MAGENTA]
