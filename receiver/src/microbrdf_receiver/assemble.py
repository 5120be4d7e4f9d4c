"""The receiving side: bytes in, frames out."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Union

from .deframe import DELIMITER, DamageError, Deframer
from .frame import Counts, Frame, Stopped
from .packets import (
    EndOfFrame,
    Fault,
    Header,
    Log,
    PacketError,
    Pixels,
    UnknownKindError,
    VersionError,
    parse,
)


@dataclass(frozen=True)
class FrameBegins:
    """A header came; the frame fills up from now on."""

    frame: Frame


@dataclass(frozen=True)
class RowCame:
    """New pixels of a row came, and it is whole now or not."""

    frame: Frame
    row: int
    whole: bool


@dataclass(frozen=True)
class FrameEnds:
    """The frame is over; it does not change any more."""

    frame: Frame


@dataclass(frozen=True)
class Refused:
    """The device sends what this receiver cannot receive."""

    error: PacketError


@dataclass(frozen=True)
class Other:
    """A good packet that has no event of its own."""


Event = Union[FrameBegins, RowCame, FrameEnds, Fault, Log, Refused, Other]


class Reassembler:
    """Puts frames together from whatever comes over the line.

    The rules are those of ``docs/wire-format.md``. Every good packet gives one
    event or more, damaged ones give none and are counted.

    Attributes:
        counts: what came since the last frame ended; a frame that ends takes them along.
    """

    def __init__(self) -> None:
        self.counts = Counts()
        self._deframer = Deframer()
        self._frame: Frame | None = None
        self._header_bytes = b""
        self._greeted = False

    def feed(self, data: bytes) -> Iterator[Event]:
        """Take in bytes and tell of what comes out of them."""
        *ended, begun = data.split(DELIMITER)
        # One packet at a time, so that bytes count for the frame they belong to.
        for piece in (*(piece + DELIMITER for piece in ended), begun):
            self.counts.bytes_on_wire += len(piece)
            for body in self._deframer.feed(piece):
                yield from self._judge(body)

    def finish(self, stopped: Stopped) -> Iterator[Event]:
        """End the open frame, if there is one: nothing more will come."""
        if self._frame is not None:
            frame, self._frame = self._frame, None
            frame.stopped = stopped
            frame.counts, self.counts = self.counts, Counts()
            yield FrameEnds(frame)

    def _judge(self, body: bytes | DamageError) -> Iterator[Event]:
        if not isinstance(body, DamageError):
            self._greeted = True
            yield from self._take(body)
        elif self._greeted:
            self.counts.crc_errors += 1
        else:
            self.counts.noise += 1

    def _take(self, body: bytes) -> Iterator[Event]:
        try:
            packet = parse(body)
            if isinstance(packet, Header):
                yield from self._begin(packet, body)
            elif isinstance(packet, Pixels):
                yield self._place(packet)
            elif isinstance(packet, EndOfFrame):
                yield from self._end(packet)
            elif isinstance(packet, Fault):
                if self._frame is not None:
                    self._frame.fault = packet
                yield from self.finish(Stopped.FAULT)
                yield packet
            else:
                yield packet
        except UnknownKindError:
            yield Other()
        except VersionError as error:
            yield Refused(error)
        except PacketError:
            self.counts.senseless += 1
            yield Other()

    def _begin(self, header: Header, body: bytes) -> Iterator[Event]:
        if self._frame is not None and body == self._header_bytes:
            yield Other()
            return
        yield from self.finish(Stopped.NEXT_FRAME)
        try:
            self._frame = Frame.begin(header)
        except PacketError as error:
            yield Refused(error)
            return
        self._header_bytes = body
        yield FrameBegins(self._frame)

    def _place(self, pixels: Pixels) -> Event:
        if self._frame is None or self._frame.header.frame != pixels.frame:
            self.counts.strays += 1
            return Other()
        if not self._frame.place(pixels):
            self.counts.duplicates += 1
            return Other()
        return RowCame(self._frame, pixels.row, self._frame.has_row(pixels.row))

    def _end(self, end: EndOfFrame) -> Iterator[Event]:
        if self._frame is None or self._frame.header.frame != end.frame:
            self.counts.strays += 1
            yield Other()
            return
        self._frame.sent_checksum = end.checksum
        yield from self.finish(Stopped.END)
