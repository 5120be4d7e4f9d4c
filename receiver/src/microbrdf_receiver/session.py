"""Receiving from a port until all frames have come or nothing more will."""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from tqdm import tqdm

from .assemble import Event, FrameBegins, FrameEnds, Reassembler, Refused, RowCame
from .errors import DONE, INCOMPLETE
from .frame import Frame, Stopped
from .output import numbered, write_whole
from .packets import Fault, Log
from .picture import to_image
from .port import Port, PortLostError
from .report import as_json, as_text

if TYPE_CHECKING:
    from .live import Window

# How long the window waits for the port before it looks after itself.
_BREATH = 0.05


@dataclass(frozen=True)
class Wishes:
    """What the user asked for.

    Attributes:
        output: where the picture goes.
        report: where the report goes, if anywhere.
        log: where the bytes of the device's log go, if anywhere.
        frames: number of frames to receive, at least 1.
        timeout: seconds without a packet after which the device counts as silent.
    """

    output: Path
    report: Path | None
    log: Path | None
    frames: int
    timeout: float


class Session:
    """Receives frames and writes each as soon as it is over."""

    def __init__(self, port: Port, wishes: Wishes, window: Window | None) -> None:
        self._port = port
        self._wishes = wishes
        self._window = window
        self._assembler = Reassembler()
        self._bar: tqdm[NoReturn] | None = None
        self._frames = 0
        self._bytes = 0
        self._all_whole = True
        self._over = False
        self._fault: Fault | None = None
        self._log = bytearray()

    def run(self) -> int:
        """Receive, and give the exit status.

        Raises:
            CommandError: if a file can't be written.
        """
        try:
            self._receive()
        except PortLostError as error:
            self._say(f"the port is lost: {error}")
            self._finish(Stopped.PORT_LOST)
        except KeyboardInterrupt:
            self._say("interrupted")
            self._finish(Stopped.INTERRUPTED)
        if self._frames == 0:
            self._write_report(None)
        if self._wishes.log is not None:
            write_whole(self._wishes.log, lambda file: file.write(self._log))
        if self._frames < self._wishes.frames:
            self._all_whole = False
            self._say(f"frames received: {self._frames} of {self._wishes.frames}")
        return DONE if self._all_whole else INCOMPLETE

    def _receive(self) -> None:
        last_packet = time.monotonic()
        while not self._over:
            left = last_packet + self._wishes.timeout - time.monotonic()
            if left <= 0:
                self._say(self._silence())
                self._finish(Stopped.SILENCE)
                return
            data = self._port.read(min(left, _BREATH))
            self._bytes += len(data)
            for event in self._assembler.feed(data):
                last_packet = time.monotonic()
                self._take(event)
                # A fault comes as two events, the end of its frame and itself;
                # the first has told all.
                if self._over:
                    return
            if self._window is not None:
                self._window.breathe()

    def _silence(self) -> str:
        seconds = f"{self._wishes.timeout:g} s"
        if self._bytes == 0:
            return f"not one byte came for {seconds}: is the device running, is it on this port?"
        if self._frames == 0 and self._bar is None:
            return (
                f"bytes came ({self._bytes}), but no header, and for {seconds} no packet: "
                "is --baud right, is it a device of this project?"
            )
        return f"the device fell silent: no packet for {seconds}"

    def _finish(self, stopped: Stopped) -> None:
        for event in self._assembler.finish(stopped):
            self._take(event)

    def _take(self, event: Event) -> None:
        if isinstance(event, FrameBegins):
            self._bar = tqdm(
                total=event.frame.header.height,
                desc=f"frame {event.frame.header.frame}",
                unit="row",
                file=sys.stderr,
                disable=None,
            )
        elif isinstance(event, RowCame):
            if event.whole and self._bar is not None:
                self._bar.update()
            if self._window is not None:
                self._window.show(event.frame)
        elif isinstance(event, FrameEnds):
            self._keep(event.frame)
        elif isinstance(event, Fault):
            self._note(event)
        elif isinstance(event, Log):
            self._log += event.data
        elif isinstance(event, Refused):
            self._over = True
            self._all_whole = False
            self._say(str(event.error))
            self._finish(Stopped.REFUSED)

    def _note(self, fault: Fault) -> None:
        self._fault = fault
        self._over = True
        self._say(f"the device reports a {fault.name}: {fault.text}")

    def _keep(self, frame: Frame) -> None:
        if self._bar is not None:
            self._bar.close()
            self._bar = None
        if frame.fault is not None:
            self._note(frame.fault)
        self._frames += 1
        path = numbered(self._wishes.output, self._frames, self._wishes.frames)
        image = to_image(frame)
        write_whole(path, lambda file: image.save(file, format="PNG"))
        self._write_report(frame)
        if self._window is not None:
            self._window.show(frame, at_once=True)
        if frame.is_whole:
            print(f"{as_text(frame)}; written to {path}", flush=True)
        else:
            self._all_whole = False
            self._say(f"{as_text(frame)}; kept, with a hatch for what is missing, in {path}")
        self._over = self._over or self._frames == self._wishes.frames

    def _write_report(self, frame: Frame | None) -> None:
        if self._wishes.report is not None:
            path = numbered(self._wishes.report, max(self._frames, 1), self._wishes.frames)
            text = as_json(frame, self._assembler.counts, self._fault)
            write_whole(path, lambda file: file.write(text.encode()))

    def _say(self, message: str) -> None:
        tqdm.write(f"microbrdf-receive: {message}", file=sys.stderr)
