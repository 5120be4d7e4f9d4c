"""Cutting a stream of bytes into packets."""

from __future__ import annotations

import random

import pytest
import sender

from microbrdf_receiver import cobs
from microbrdf_receiver.deframe import DamageError, Deframer


@pytest.mark.parametrize(
    ("decoded", "encoded"),
    [
        # The examples of Cheshire and Baker's paper and their neighbours.
        (b"", "01"),
        (b"\0", "01 01"),
        (b"\0\0", "01 01 01"),
        (b"\x11\x22\0\x33", "03 11 22 02 33"),
        (b"\x11\0\0\0", "02 11 01 01 01"),
        (bytes(range(1, 255)), "ff" + bytes(range(1, 255)).hex()),
        (bytes(range(1, 255)), "ff" + bytes(range(1, 255)).hex() + "01"),
        (bytes(range(255)), "01 ff" + bytes(range(1, 255)).hex()),
        (bytes(range(1, 256)), "ff" + bytes(range(1, 255)).hex() + "02 ff"),
        (bytes(range(2, 256)) + b"\0", "ff" + bytes(range(2, 256)).hex() + "01 01"),
    ],
)
def test_cobs(decoded: bytes, encoded: str) -> None:
    assert cobs.decode(bytes.fromhex(encoded)) == decoded


def test_cobs_round_trip() -> None:
    dice = random.Random(1)
    for length in [*range(20), *range(250, 260), 600]:
        data = bytes(dice.choice([0, 0, 1, 255]) for _ in range(length))
        encoded = sender.cobs_encode(data)
        assert 0 not in encoded
        assert cobs.decode(encoded) == data


@pytest.mark.parametrize("encoded", ["02", "05 11 22", "01 03 11", "ff 01"])
def test_cobs_cut_short(encoded: str) -> None:
    with pytest.raises(cobs.CobsError):
        cobs.decode(bytes.fromhex(encoded))


def outcomes(stream: bytes, step: int) -> list[str]:
    deframer = Deframer()
    found = []
    for start in range(0, len(stream), step):
        for body in deframer.feed(stream[start : start + step]):
            found.append(str(body) if isinstance(body, DamageError) else body.hex())
    return found


@pytest.mark.parametrize("step", [1, 2, 7, 1000])
def test_any_portions_give_the_same_packets(step: int) -> None:
    bodies = [b"\x63" + bytes([length] * length) for length in range(250)]
    stream = b"\0\0" + b"\0".join(sender.packet(body) for body in bodies)
    assert outcomes(stream, step) == [body.hex() for body in bodies]


@pytest.mark.parametrize("step", [1, 100, 100000])
def test_damage_has_a_reason_and_ends_at_the_next_delimiter(step: int) -> None:
    good = sender.packet(b"\x63good")
    stream = b"".join(
        [
            b"\x01\x01\x01\x01\0" + good,
            b"\x7fcut\0" + good,
            sender.packet(b"\x63" * 250).replace(b"\x63", b"\x64", 1) + good,
            sender.packet(b"\x63" * 251) + good,
            # With a 0 in it, this one is as long encoded as 254 bytes may be.
            sender.packet(b"\x63" * 100 + b"\0" + b"\x63" * 150) + good,
            b"\xff" * 70000 + b"\0" + good,
        ]
    )
    reasons = [outcome for outcome in outcomes(stream, step) if outcome != b"\x63good".hex()]
    assert [reason.split(":")[0] for reason in reasons] == [
        "shorter than 5 bytes",
        "not COBS",
        "wrong checksum",
        "longer than 254 bytes",
        "longer than 254 bytes",
        "longer than 254 bytes",
    ]
    assert outcomes(stream, step).count(b"\x63good".hex()) == 6


def test_memory_is_bounded() -> None:
    deframer = Deframer()
    for _ in range(100):
        assert list(deframer.feed(b"\xaa" * 65536)) == []
    assert len(deframer._pending) < 300
