"""From bytes on the wire to checked packets."""

from __future__ import annotations

import zlib
from collections.abc import Iterator

from . import cobs
from .packets import MAX_PACKET

DELIMITER = b"\0"
"""The byte that separates packets and occurs nowhere else on the wire."""

_CHECKSUM = 4
_SHORTEST = 1 + _CHECKSUM
# One code byte, and one more that some encoders add to 254 bytes without a 0.
_MAX_ENCODED = MAX_PACKET + 2


class DamageError(ValueError):
    """What stood between two delimiters is no packet."""


class Deframer:
    """Cuts a stream of bytes into packets.

    It holds one packet and no more, and after any damage is right again from
    the next delimiter on.
    """

    def __init__(self) -> None:
        self._pending = bytearray()

    def feed(self, data: bytes) -> Iterator[bytes | DamageError]:
        """Take in bytes; give the bodies of whole packets, and errors for the rest."""
        *ended, begun = data.split(DELIMITER)
        for part in ended:
            encoded = bytes(self._pending) + part
            self._pending.clear()
            if encoded:
                try:
                    yield _body(encoded)
                except DamageError as error:
                    yield error
        # One byte beyond the limit is enough to know that it is too long.
        room = _MAX_ENCODED + 1 - len(self._pending)
        self._pending += begun[:room]


def _body(encoded: bytes) -> bytes:
    if len(encoded) > _MAX_ENCODED:
        raise DamageError(f"longer than {MAX_PACKET} bytes")
    try:
        packet = cobs.decode(encoded)
    except cobs.CobsError as error:
        raise DamageError(f"not COBS: {error}") from None
    if len(packet) > MAX_PACKET:
        raise DamageError(f"longer than {MAX_PACKET} bytes")
    if len(packet) < _SHORTEST:
        raise DamageError(f"shorter than {_SHORTEST} bytes")
    body, checksum = packet[:-_CHECKSUM], packet[-_CHECKSUM:]
    if zlib.crc32(body) != int.from_bytes(checksum, "little"):
        raise DamageError("wrong checksum")
    return body
