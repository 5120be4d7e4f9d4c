"""The example bytes of docs/wire-format.md, both ways."""

from __future__ import annotations

from pathlib import Path

import pytest
import sender

from microbrdf_receiver import packets
from microbrdf_receiver.assemble import FrameEnds, Reassembler
from microbrdf_receiver.deframe import DamageError, Deframer

DOCUMENT = Path(__file__).parents[2] / "docs" / "wire-format.md"


class Example:
    """An ``example`` block: its keys, and its bytes."""

    def __init__(self, block: str) -> None:
        self.keys: dict[str, str] = {}
        self.wire = b""
        for line in block.splitlines():
            key, value = (part.strip() for part in line.split("=", 1))
            if key == "wire":
                self.wire += bytes.fromhex(value)
            else:
                assert key not in self.keys
                self.keys[key] = value

    def __getitem__(self, key: str) -> str:
        return self.keys[key]

    def numbers(self, *keys: str) -> list[int]:
        return [int(self[key], 0) for key in keys]

    @property
    def data(self) -> bytes:
        return bytes.fromhex(self["data"])

    @property
    def sent(self) -> sender.Sent:
        width, height, frame, version = self.numbers("width", "height", "frame", "version")
        return sender.Sent(
            width=width,
            height=height,
            pixel_format={"srgb8": 1, "rgb565": 2}[self["pixel_format"]],
            frame=frame,
            exposure=float(self["exposure"]) if self["exposure"] else None,
            board=self["board"],
            core=self["core"],
            compiler=self["compiler"],
            arithmetic=self["arithmetic"],
            scene=self["scene"],
            version=version,
        )

    def body(self) -> bytes:
        """The one packet of the example, decoded."""
        (body,) = Deframer().feed(self.wire)
        if isinstance(body, DamageError):
            raise body
        return body


def examples() -> list[Example]:
    blocks = DOCUMENT.read_text(encoding="utf-8").split("```example\n")[1:]
    return [Example(block.split("```")[0]) for block in blocks]


def of_kind(*kinds: str) -> pytest.MarkDecorator:
    chosen = [example for example in examples() if example["kind"] in kinds]
    assert {example["kind"] for example in chosen} == set(kinds)
    return pytest.mark.parametrize("example", chosen, ids=[example["name"] for example in chosen])


def test_every_example_is_tested() -> None:
    known = {"header", "pixels", "end", "fault", "log", "frame", "refused"}
    assert {example["kind"] for example in examples()} == known


@of_kind("header")
def test_header(example: Example) -> None:
    sent = example.sent
    assert sent.header() == example.wire
    assert packets.parse(example.body()) == packets.Header(
        sent.frame,
        sent.width,
        sent.height,
        packets.PixelFormat(sent.pixel_format),
        sent.exposure,
        sent.board,
        sent.core,
        sent.compiler,
        sent.arithmetic,
        sent.scene,
    )


@of_kind("pixels")
def test_pixels(example: Example) -> None:
    frame, row, column = example.numbers("frame", "row", "column")
    assert sender.pixels(frame, row, column, example.data) == example.wire
    assert packets.parse(example.body()) == packets.Pixels(frame, row, column, example.data)


@of_kind("end")
def test_end(example: Example) -> None:
    frame, rows, checksum = example.numbers("frame", "rows", "checksum")
    assert sender.end(frame, rows, checksum) == example.wire
    assert packets.parse(example.body()) == packets.EndOfFrame(frame, rows, checksum)


@of_kind("fault")
def test_fault(example: Example) -> None:
    frame, code = example.numbers("frame", "code")
    assert sender.fault(frame, code, example["text"]) == example.wire
    assert packets.parse(example.body()) == packets.Fault(frame, code, example["text"])


@of_kind("log")
def test_log(example: Example) -> None:
    assert sender.log(example.data) == example.wire
    assert packets.parse(example.body()) == packets.Log(example.data)


@of_kind("frame")
def test_frame(example: Example) -> None:
    assert example.sent.wire(example.data) == example.wire
    (frame,) = (
        event.frame for event in Reassembler().feed(example.wire) if isinstance(event, FrameEnds)
    )
    assert frame.pixels == example.data
    assert frame.sent_checksum == int(example["checksum"], 0)
    assert frame.is_whole


@of_kind("refused")
def test_refused(example: Example) -> None:
    try:
        reason = str(packets.parse(example.body()))
    except DamageError as error:
        reason = {"wrong checksum": "checksum"}.get(str(error), str(error).split(":")[0].lower())
        reason = reason.replace("not cobs", "cobs")
    except packets.VersionError as error:
        reason = f"version {error.version}"
    except packets.UnknownKindError as error:
        reason = f"unknown kind {error.code}"
    assert reason == example["reason"]


def test_payload_lengths() -> None:
    """The table of kinds gives the lengths that a payload may have."""
    rows = {}
    for line in DOCUMENT.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if (
            len(cells) == 3
            and cells[0].isdigit()
            and cells[1] in ("pixels", "end of frame", "fault", "log", "header")
        ):
            bounds = [int(bound) for bound in cells[2].split(" to ")]
            rows[int(cells[0])] = (bounds[0], bounds[-1])
    assert set(rows) == set(packets.Kind)
    for kind, (least, greatest) in rows.items():
        if kind == packets.Kind.HEADER:
            continue
        for length in range(250):
            try:
                packets.parse(bytes([kind]) + bytes(length))
                allowed = True
            except packets.PacketError:
                allowed = False
            assert allowed == (least <= length <= greatest), f"{length} bytes of kind {kind}"

    name, compiler = "n" * 32, "c" * 96
    smallest = sender.Sent(1, 1, 1, 0, None, "", "", "", "", "")
    largest = sender.Sent(1, 1, 1, 0, 1.0, name, name, compiler, name, name)
    # Two delimiters, the COBS code, the kind and the checksum go away.
    lengths = tuple(len(sent.header()) - 8 for sent in (smallest, largest))
    assert lengths == rows[packets.Kind.HEADER]
    for sent in (smallest, largest):
        (body,) = Deframer().feed(sent.header())
        assert isinstance(body, bytes)
        packets.parse(body)
