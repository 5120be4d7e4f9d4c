"""Files that are there whole or not at all, and what reports say."""

from __future__ import annotations

import json
from pathlib import Path
from typing import BinaryIO

import pytest
import sender
from test_picture import received

from microbrdf_receiver.errors import CommandError
from microbrdf_receiver.frame import Counts
from microbrdf_receiver.output import check_writable, numbered, write_whole
from microbrdf_receiver.packets import Fault
from microbrdf_receiver.report import as_json, as_text, ranges


def test_a_write_that_fails_leaves_the_old_file(tmp_path: Path) -> None:
    target = tmp_path / "a.png"
    target.write_bytes(b"old")

    def fail(file: BinaryIO) -> None:
        file.write(b"half")
        raise OSError(28, "No space left on device")

    with pytest.raises(CommandError, match=r"a\.png: No space left on device") as caught:
        write_whole(target, fail)
    assert caught.value.status == 3
    assert target.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [target]


def test_a_write_replaces_the_old_file(tmp_path: Path) -> None:
    target = tmp_path / "a.png"
    target.write_bytes(b"old")
    write_whole(target, lambda file: file.write(b"new"))
    assert target.read_bytes() == b"new"
    assert list(tmp_path.iterdir()) == [target]


def test_folders_are_checked(tmp_path: Path) -> None:
    check_writable("-o", tmp_path / "a.png")
    for path in (tmp_path, tmp_path / "no" / "a.png"):
        with pytest.raises(CommandError, match=r"^-o ") as caught:
            check_writable("-o", path)
        assert caught.value.status == 2


def test_numbers() -> None:
    assert numbered(Path("x/a.png"), 1, 1) == Path("x/a.png")
    assert numbered(Path("x/a.png"), 7, 8) == Path("x/a-0007.png")


@pytest.mark.parametrize(
    ("numbers", "text"),
    [([], ""), ([4], "4"), ([1, 2, 3, 7], "1-3, 7"), ([0, 2, 3], "0, 2-3")],
)
def test_ranges(numbers: list[int], text: str) -> None:
    assert ranges(numbers) == text


def test_report_of_a_whole_frame() -> None:
    sent = sender.Sent(exposure=1.25, frame=3)
    frame = received(sent.wire())
    assert json.loads(as_json(frame, Counts(), None)) == {
        "schema": 1,
        "board": "bench",
        "core": "host",
        "compiler": "rustc",
        "arithmetic": "q31",
        "scene": "stripes",
        "exposure": 1.25,
        "frame": 3,
        "width": 100,
        "height": 5,
        "pixel_format": "srgb8",
        "rows_received": 5,
        "rows_missing": 0,
        "missing_row_numbers": [],
        "frame_crc_ok": True,
        "stopped_by": "end of frame",
        "bytes_on_wire": len(sent.wire()),
        "noise": 0,
        "crc_errors": 0,
        "duplicates": 0,
        "strays": 0,
        "senseless": 0,
        "fault": None,
    }
    assert as_text(frame) == (
        "frame 3, 100 x 5 srgb8 (stripes, q31, bench, host): whole, checksum right"
    )


def test_report_of_an_incomplete_frame() -> None:
    packets = sender.Sent().packets()
    hurt = bytearray(packets[5])
    hurt[20] ^= 1
    packets[5:6] = [bytes(hurt), sender.fault(0, 1, "oh")]
    frame = received(b"".join(packets))
    report = json.loads(as_json(frame, Counts(), frame.fault))
    assert report["rows_received"] == 2
    assert report["rows_missing"] == 3
    assert report["missing_row_numbers"] == [2, 3, 4]
    assert report["crc_errors"] == 1
    assert report["frame_crc_ok"] is None
    assert report["stopped_by"] == "fault"
    assert report["fault"] == {"code": 1, "name": "panic", "text": "oh"}
    text = as_text(frame)
    assert "3 of 5 rows are missing or in part: 2-4" in text
    assert "its end did not come" in text
    assert "damaged packets: 1" in text


def test_report_of_no_frame() -> None:
    report = json.loads(as_json(None, Counts(bytes_on_wire=9), Fault(0, 1, "early")))
    assert report["width"] is None
    assert report["rows_missing"] is None
    assert report["rows_received"] == 0
    assert report["bytes_on_wire"] == 9
    assert report["fault"]["text"] == "early"
