"""The receiver's rules, one by one."""

from __future__ import annotations

import random
import zlib

import pytest
import sender

from microbrdf_receiver.assemble import Event, FrameEnds, Reassembler, Refused, RowCame
from microbrdf_receiver.frame import Counts, Frame, Stopped
from microbrdf_receiver.packets import Fault, Log


def receive(wire: bytes) -> tuple[list[Frame], list[Event], Reassembler]:
    """Receive bytes, then silence."""
    assembler = Reassembler()
    events = [*assembler.feed(wire), *assembler.finish(Stopped.SILENCE)]
    return [event.frame for event in events if isinstance(event, FrameEnds)], events, assembler


def assert_true_to(sent: sender.Sent, frame: Frame) -> None:
    """Check that every pixel said to have come is the one that was sent."""
    size = sent.row_bytes // sent.width
    for number, came in enumerate(frame.present):
        place = slice(number * size, (number + 1) * size)
        assert frame.pixels[place] == (sent.data[place] if came else bytes(size))


@pytest.mark.parametrize("pixel_format", [1, 2])
@pytest.mark.parametrize(
    ("width", "height"), [(1, 1), (1, 300), (80, 2), (81, 3), (121, 2), (256, 33)]
)
def test_every_size_and_format_comes_back(width: int, height: int, pixel_format: int) -> None:
    sent = sender.Sent(width, height, pixel_format, exposure=0.1)
    wire = sent.wire()
    (frame,), events, _ = receive(wire)
    assert frame.is_whole
    assert frame.stopped is Stopped.END
    assert frame.pixels == sent.data
    assert frame.missing_rows == []
    assert frame.header.exposure == 0.1
    assert frame.counts == Counts(bytes_on_wire=len(wire))
    whole = [event.row for event in events if isinstance(event, RowCame) and event.whole]
    assert whole == list(range(height))


def test_garbage_before_the_header_is_no_error() -> None:
    garbage = bytes([0x55, 0xAA, 0, 3, 1, 0, 0, 0xFF, 0xFF, 9, 0, 7, 7])
    sent = sender.Sent()
    (frame,), _, _ = receive(garbage + sent.wire())
    assert frame.is_whole
    assert frame.counts.crc_errors == 0
    assert frame.counts.noise == 4


def test_each_lost_packet_costs_its_own_pixels_and_no_others() -> None:
    sent = sender.Sent()
    packets = sent.packets()
    assert len(packets) == 12
    for lost in range(1, 11):
        (frame,), _, _ = receive(b"".join(packets[:lost] + packets[lost + 1 :]))
        row, second = divmod(lost - 1, 2)
        expected = {row * 100 + column for column in (range(80, 100) if second else range(80))}
        assert {n for n, came in enumerate(frame.present) if not came} == expected
        assert frame.missing_rows == [row]
        assert frame.checksum_ok is None
        assert not frame.is_whole
        assert_true_to(sent, frame)


def test_every_flipped_bit_is_noticed_and_never_changes_a_pixel() -> None:
    sent = sender.Sent(30, 2)
    wire = sent.wire()
    for bit in range(8, len(wire) * 8):
        hurt = bytearray(wire)
        hurt[bit // 8] ^= 1 << bit % 8
        frames, _, _ = receive(bytes(hurt))
        for frame in frames:
            assert not frame.is_whole, f"bit {bit}"
            assert_true_to(sent, frame)


def test_a_line_cut_anywhere_leaves_what_came_before() -> None:
    sent = sender.Sent(30, 3)
    wire = sent.wire()
    for length in range(len(wire)):
        frames, _, _ = receive(wire[:length])
        assert len(frames) <= 1
        for frame in frames:
            assert frame.stopped is Stopped.SILENCE
            assert not frame.is_whole
            assert_true_to(sent, frame)
            assert 1 not in bytes(frame.present).lstrip(b"\1"), "the gap is at the end"


def test_doubled_packets_are_harmless() -> None:
    (frame,), _, assembler = receive(b"".join(p + p for p in sender.Sent().packets()))
    assert frame.is_whole
    assert frame.counts.duplicates == 10
    assert assembler.counts.strays == 1, "the second end of frame"


def test_shuffled_packets_are_harmless() -> None:
    sent = sender.Sent()
    header, *rows, end = sent.packets()
    (frame,), _, _ = receive(b"".join([header, *reversed(rows), end]))
    assert frame.is_whole
    assert frame.pixels == sent.data


def test_another_version_is_refused_with_both_numbers() -> None:
    frames, (event,), _ = receive(sender.Sent(version=3).header())
    assert frames == []
    assert isinstance(event, Refused)
    assert "version 3" in str(event.error)
    assert "version 1" in str(event.error)


def test_a_frame_that_is_too_large_is_refused() -> None:
    _, (event,), _ = receive(sender.Sent(65535, 65535).header())
    assert isinstance(event, Refused)
    assert "65535 x 65535" in str(event.error)


def test_another_frame_ends_the_one_whose_end_was_lost() -> None:
    sent = sender.Sent()
    first, second = receive(b"".join(sent.packets()[:-1]) + sent.numbered(1).wire())[0]
    assert first.stopped is Stopped.NEXT_FRAME
    assert first.missing_rows == []
    assert first.checksum_ok is None
    assert second.is_whole


def test_pixels_of_another_frame_stay_out() -> None:
    sent = sender.Sent()
    packets, others = sent.packets(), sent.numbered(1).packets()
    (frame,), _, _ = receive(b"".join(packets[:6] + others[1:] + packets[6:]))
    assert frame.is_whole
    assert frame.pixels == sent.data
    assert frame.counts.strays == 11


def test_a_device_that_starts_again_in_mid_frame_wins() -> None:
    sent = sender.Sent()
    begun = sent.packets(b"\xff" * len(sent.data))[:6]
    (frame,), _, _ = receive(b"".join(begun) + sent.wire())
    assert frame.is_whole
    assert frame.pixels == sent.data


def test_a_wrong_frame_checksum_is_told() -> None:
    sent = sender.Sent()
    wrong = sender.end(0, 5, zlib.crc32(sent.data) ^ 1)
    (frame,), _, _ = receive(b"".join([*sent.packets()[:-1], wrong]))
    assert frame.missing_rows == []
    assert frame.checksum_ok is False
    assert not frame.is_whole


def test_pixels_outside_the_frame_are_passed_over() -> None:
    sent = sender.Sent()
    *packets, end = sent.packets()
    bad = [
        sender.pixels(0, 5, 0, bytes(3)),
        sender.pixels(0, 65535, 65535, bytes(240)),
        sender.pixels(0, 0, 100, bytes(3)),
        sender.pixels(0, 0, 99, bytes(6)),
        sender.pixels(0, 0, 0, bytes(4)),
        sender.packet(b"\2\0\0\0\0\0\0"),
    ]
    (frame,), _, _ = receive(b"".join([*packets, *bad, end]))
    assert frame.is_whole
    assert frame.pixels == sent.data
    assert frame.counts.senseless == 6


def test_a_fault_ends_the_frame() -> None:
    sent = sender.Sent()
    # The fault cuts a packet off.
    wire = b"".join(sent.packets()[:5])[:-20] + sender.fault(0, 2, "pc=0x1234 \u00b5")
    (frame,), events, assembler = receive(wire + sent.packets()[6])
    assert frame.stopped is Stopped.FAULT
    assert frame.fault == Fault(0, 2, "pc=0x1234 \u00b5")
    assert frame.fault in events
    assert frame.counts.crc_errors == 1
    assert assembler.counts.strays == 1


def test_a_fault_before_any_frame_is_told() -> None:
    frames, events, _ = receive(sender.fault(9, 77, "out of coffee"))
    assert frames == []
    assert events == [Fault(9, 77, "out of coffee")]
    assert Fault(9, 77, "").name == "fault 77"
    assert Fault(9, 1, "").name == "panic"


def test_logs_and_unknown_kinds_pass_in_mid_frame() -> None:
    packets = sender.Sent().packets()
    more = [sender.log(b"one"), sender.packet(b"\x63what"), sender.log(b"two")]
    (frame,), events, _ = receive(b"".join(packets[:4] + more + packets[4:]))
    assert frame.is_whole
    assert frame.counts.senseless == 0
    assert [event.data for event in events if isinstance(event, Log)] == [b"one", b"two"]


def test_nothing_that_comes_over_the_line_can_stop_the_receiver() -> None:
    dice = random.Random(7)
    wire = sender.Sent(20, 70).wire()
    for _ in range(300):
        hurt = bytearray(wire)
        for _ in range(dice.randrange(40)):
            place = dice.randrange(len(hurt))
            if dice.random() < 0.3:
                del hurt[place : place + dice.randrange(300)]
            else:
                hurt[place : place + 1] = dice.randbytes(dice.randrange(3))
            hurt += b"\0"
        frames, _, _ = receive(bytes(hurt))
        for frame in frames:
            assert_true_to(sender.Sent(20, 70), frame)


def test_no_body_can_stop_the_receiver() -> None:
    dice = random.Random(8)
    for _ in range(5000):
        body = bytes([dice.randrange(7), dice.choice([1, 1, 2])])
        body += dice.randbytes(dice.randrange(60))
        receive(sender.Sent().packets()[0] + sender.packet(body))
