"""The command ``microbrdf-receive``."""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Sequence
from pathlib import Path

from . import __version__
from .errors import ENVIRONMENT, USER_MISTAKE, CommandError
from .output import check_writable

_DESCRIPTION = """\
Receive the pictures that a microcontroller shades and sends over its serial
line, and write them as PNG. Rows that did not arrive are filled with a hatch
of magenta and black, and named.
"""

_EPILOGUE = """\
examples:
  microbrdf-receive /dev/ttyACM0 -o demo.png
  microbrdf-receive socket://localhost:5331 --frames 10 -o demo.png
      writes demo-0001.png to demo-0010.png

exit status:
  0  all frames arrived whole
  1  something is missing: the device fell silent, failed, or speaks another
     version of the protocol; what arrived is kept and marked
  2  a mistake in the options, or no such port
  3  this machine lacks something: a package, a display, a permission
"""

_MAX_FRAMES = 9999


def _frames(text: str) -> int:
    try:
        value = int(text)
    except ValueError:
        value = 0
    if not 1 <= value <= _MAX_FRAMES:
        raise argparse.ArgumentTypeError(
            f"{text!r} is no number of frames, must be 1 to {_MAX_FRAMES}"
        )
    return value


def _baud(text: str) -> int:
    try:
        value = int(text)
    except ValueError:
        value = 0
    if not 1 <= value <= 20_000_000:
        raise argparse.ArgumentTypeError(f"{text!r} is no baud rate, must be 1 to 20000000")
    return value


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 < value <= 86400:
        raise argparse.ArgumentTypeError(
            f"{text!r} is no time in seconds, must be above 0 and at most 86400"
        )
    return value


def _png(text: str) -> Path:
    path = Path(text)
    if path.suffix.lower() != ".png" or not path.stem:
        raise argparse.ArgumentTypeError(f"{text!r} is no name of a picture, must end in .png")
    return path


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="microbrdf-receive",
        description=_DESCRIPTION,
        epilog=_EPILOGUE,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument(
        "port",
        metavar="PORT",
        help="serial port, or any URL that pyserial opens, such as socket://HOST:PORT",
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE.png",
        type=_png,
        default=Path("frame.png"),
        help="where the picture goes (default: %(default)s); "
        "with --frames above 1: FILE-0001.png and so on",
    )
    parser.add_argument(
        "--frames",
        metavar="N",
        type=_frames,
        default=1,
        help=f"number of frames to receive, 1 to {_MAX_FRAMES} (default: %(default)s)",
    )
    parser.add_argument(
        "--live",
        action="store_true",
        help="show the picture in a window while it grows, until the window is closed",
    )
    parser.add_argument(
        "--timeout",
        metavar="S",
        type=_seconds,
        default=10.0,
        help="give up after so many seconds without a packet (default: %(default)g)",
    )
    parser.add_argument(
        "--baud",
        metavar="B",
        type=_baud,
        default=115200,
        help="baud rate (default: %(default)s); ptys and sockets ignore it",
    )
    parser.add_argument(
        "--report",
        metavar="FILE.json",
        type=Path,
        help="write what arrived and what did not; numbered like the pictures",
    )
    parser.add_argument(
        "--log",
        metavar="FILE",
        type=Path,
        help="write the bytes of the device's log (defmt) as they came",
    )
    parser.add_argument("--version", action="version", version=f"%(prog)s {__version__}")
    return parser


def _check_files(files: dict[str, Path | None]) -> None:
    taken: dict[Path, str] = {}
    for option, path in files.items():
        if path is None:
            continue
        check_writable(option, path)
        other = taken.setdefault(path.resolve(), option)
        if other != option:
            raise CommandError(USER_MISTAKE, f"{option} {path}: {other} writes that file already")


def _run(arguments: argparse.Namespace) -> int:
    _check_files(
        {"--output": arguments.output, "--report": arguments.report, "--log": arguments.log}
    )
    try:
        from .live import Window  # noqa: PLC0415
        from .port import Port  # noqa: PLC0415
        from .session import Session, Wishes  # noqa: PLC0415
    except ImportError as error:
        raise CommandError(
            ENVIRONMENT,
            f"the Python package {error.name} is missing; "
            "pip install of microbrdf-receiver brings it along",
        ) from error

    wishes = Wishes(
        output=arguments.output,
        report=arguments.report,
        log=arguments.log,
        frames=arguments.frames,
        timeout=arguments.timeout,
    )
    window = Window() if arguments.live else None
    with Port(arguments.port, arguments.baud) as port:
        status = Session(port, wishes, window).run()
    if window is not None:
        window.hold()
    return status


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command and give its exit status; never raises for bad input."""
    arguments = _parser().parse_args(argv)
    try:
        return _run(arguments)
    except CommandError as error:
        print(f"microbrdf-receive: {error}", file=sys.stderr)
        return error.status
    except KeyboardInterrupt:
        print("microbrdf-receive: interrupted", file=sys.stderr)
        return 1
