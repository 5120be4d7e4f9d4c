"""The command ``microbrdf-count``."""

from __future__ import annotations

import argparse
import json
import os
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

from microbrdf_counter.bench import Fails
from microbrdf_counter.differs import Differs
from microbrdf_counter.ibex import build
from microbrdf_counter.ibex import kernel as ibex_kernel
from microbrdf_counter.ibex.simulator import CannotBuild
from microbrdf_counter.kernel import measure
from microbrdf_counter.machine import Stray
from microbrdf_counter.results import compare
from microbrdf_counter.rp2040 import compare as rp2040
from microbrdf_counter.rp2040.emulator import Missing, version
from microbrdf_counter.timings import TIMINGS
from microbrdf_counter.timings.timing import UnknownInstruction

_EXAMPLE = (
    "Example: microbrdf-count --target thumbv6m-none-eabi --images target/measure/images "
    "--calls target/measure/calls.json -o target/measure/thumbv6m.json"
)
_STATUSES = (
    "Exit status: 0 done; 1 a result differs from the host's; 2 a mistake in the call; "
    "3 verilator, Node.js or its package is missing."
)


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="microbrdf-count",
        description="Runs kernels on an emulated core and estimates their cycles, or counts them.",
        epilog=f"{_EXAMPLE} {_STATUSES}",
    )
    parser.add_argument("--target", required=True, choices=[*sorted(TIMINGS), ibex_kernel.TARGET])
    parser.add_argument("--images", required=True, type=Path, help="folder with NAME.elf")
    parser.add_argument("--calls", required=True, type=Path, help="what to call each with")
    parser.add_argument("-o", dest="output", type=Path, help="file to write")
    parser.add_argument(
        "--results", action="store_true", help="only compare results; nothing is counted"
    )
    parser.add_argument(
        "--second-source",
        type=Path,
        metavar="FOLDER",
        help="only compare cycles on Cortex-M0+ with rp2040js, whose package is in FOLDER",
    )
    return parser.parse_args()


def _one(job: tuple[Path, str, dict[str, Any]]) -> dict[str, Any]:
    return measure(*job)


def _one_on_ibex(job: tuple[Path, Path, dict[str, Any]]) -> dict[str, Any]:
    return ibex_kernel.measure(*job)


def _all(target: str, images: Path, calls: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """What every kernel costs; as many at a time as the machine has cores."""
    paths = [images / f"{kernel['kernel']}.elf" for kernel in calls]
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        if target != ibex_kernel.TARGET:
            return list(pool.map(_one, zip(paths, [target] * len(paths), calls)))
        program = build(images.parent / "ibex")
        return list(pool.map(_one_on_ibex, zip([program] * len(paths), paths, calls)))


def _compare(target: str, images: Path, calls: list[dict[str, Any]]) -> int:
    for kernel in calls:
        name = kernel["kernel"]
        compared = compare(images / f"{name}.elf", target, kernel)
        print(f"{name} for {target}: {compared} as on the host")
    return 0 if calls else 1


def _second_source(folder: Path, images: Path, calls: list[dict[str, Any]]) -> int:
    total = rp2040.Compared()
    count = os.cpu_count() or 1
    with ProcessPoolExecutor(count) as pool:
        for compared in pool.map(
            rp2040.kernels, ((folder, images, calls[first::count]) for first in range(count))
        ):
            total.add(compared)
    print(f"rp2040js {version()}, {len(calls)} kernels, {total.words()}")
    return 0 if total.calls else 1


def main() -> int:
    """Runs the command and returns its exit status."""
    arguments = _arguments()
    try:
        calls = json.loads(arguments.calls.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        print(f"error: {arguments.calls}: {error}", file=sys.stderr)
        return 2
    if arguments.second_source and arguments.target != rp2040.TARGET:
        print(f"error: --second-source is for {rp2040.TARGET}", file=sys.stderr)
        return 2
    only_compares = arguments.results or arguments.second_source
    if not only_compares and arguments.output is None:
        print("error: -o is missing: where to write what is counted", file=sys.stderr)
        return 2
    try:
        if arguments.results:
            return _compare(arguments.target, arguments.images, calls)
        if arguments.second_source:
            return _second_source(arguments.second_source, arguments.images, calls)
        found = _all(arguments.target, arguments.images, calls)
    except (CannotBuild, Missing) as error:
        print(f"error: {error}", file=sys.stderr)
        return 3
    except (Differs, Fails, Stray, UnknownInstruction) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    arguments.output.write_text(json.dumps(found), encoding="utf-8")
    return 0
