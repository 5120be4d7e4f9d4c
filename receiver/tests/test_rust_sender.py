"""What the Rust sender puts on the wire is understood here."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from microbrdf_receiver.assemble import FrameEnds, Reassembler
from microbrdf_receiver.frame import Frame, Stopped
from microbrdf_receiver.picture import to_image

PROJECT = Path(__file__).parents[2]
WIDTH, HEIGHT = 256, 128

pytestmark = pytest.mark.skipif(
    shutil.which("cargo") is None or not (PROJECT / "link" / "Cargo.toml").is_file(),
    reason="needs cargo and the Rust sources",
)


def rust_sender(*arguments: str) -> tuple[bytes, dict[str, int]]:
    """What the sender wrote, and what its line did to that."""
    done = subprocess.run(
        [
            *("cargo", "run", "--quiet", "--package", "microbrdf-link"),
            *("--example", "synthetic_frame", "--", *arguments),
        ],
        cwd=PROJECT,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr.decode()
    damage = re.findall(rb"(\w+): (\d+)", done.stderr.splitlines()[-1])
    return done.stdout, {name.decode(): int(count) for name, count in damage}


def receive(wire: bytes) -> list[Frame]:
    assembler = Reassembler()
    events = [*assembler.feed(wire), *assembler.finish(Stopped.SILENCE)]
    return [event.frame for event in events if isinstance(event, FrameEnds)]


def expected(column: int, row: int) -> tuple[int, int, int]:
    return column, row, (column + row) % 256


def test_whole_frame() -> None:
    (frame,) = receive(rust_sender("srgb8")[0])
    assert frame.is_whole
    header = frame.header
    assert (header.width, header.height, header.frame) == (WIDTH, HEIGHT, 0)
    assert (header.board, header.core, header.compiler) == ("none", "host", "rustc")
    assert (header.arithmetic, header.scene, header.exposure) == ("none", "synthetic", 0.75)
    image = to_image(frame)
    for row in range(HEIGHT):
        for column in range(WIDTH):
            assert image.getpixel((column, row)) == expected(column, row)


def test_whole_frame_in_rgb565() -> None:
    (frame,) = receive(rust_sender("rgb565")[0])
    assert frame.is_whole
    image = to_image(frame)
    for row in range(HEIGHT):
        for column in range(WIDTH):
            pixel = image.getpixel((column, row))
            assert isinstance(pixel, tuple)
            full = expected(column, row)
            kept = (full[0] & 0xF8, full[1] & 0xFC, full[2] & 0xF8)
            packed = tuple(round(code * top / 255) for code, top in zip(pixel, (31, 63, 31)))
            assert packed == (kept[0] >> 3, kept[1] >> 2, kept[2] >> 3)


@pytest.mark.parametrize("seed", range(8))
def test_bad_line(seed: int) -> None:
    wire, damage = rust_sender("srgb8", str(seed))
    hurt = damage["dropped"] + damage["flipped"] + damage["bytes_lost"]
    assert hurt > 0
    frames = receive(wire)
    assert frames, "the repeated header makes the frame known"
    for frame in frames:
        assert not frame.is_whole
        for number, came in enumerate(frame.present):
            if came:
                row, column = divmod(number, WIDTH)
                pixel = tuple(frame.pixels[number * 3 : number * 3 + 3])
                assert pixel == expected(column, row)
    assert sum(frame.counts.crc_errors + frame.counts.noise for frame in frames) > 0
