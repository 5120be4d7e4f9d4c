"""What became of a frame, for machines and for people."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import Any

from .frame import Counts, Frame
from .packets import Fault

SCHEMA = 1
"""Version of the report's layout; it grows when a field changes its meaning."""


def as_json(frame: Frame | None, counts: Counts, fault: Fault | None) -> str:
    """Give the report of a frame, or of no frame: then its fields are null."""
    report: dict[str, Any] = {"schema": SCHEMA}
    header = None if frame is None else frame.header
    for text in ("board", "core", "compiler", "arithmetic", "scene"):
        report[text] = getattr(header, text, "") or None
    for number in ("exposure", "frame", "width", "height"):
        report[number] = getattr(header, number, None)
    report["pixel_format"] = None if header is None else header.pixel_format.label
    missing = [] if frame is None else frame.missing_rows
    report["rows_received"] = 0 if header is None else header.height - len(missing)
    report["rows_missing"] = None if header is None else len(missing)
    report["missing_row_numbers"] = missing
    report["frame_crc_ok"] = None if frame is None else frame.checksum_ok
    report["stopped_by"] = None if frame is None or frame.stopped is None else frame.stopped.value
    report.update(asdict(counts if frame is None else frame.counts))
    report["fault"] = (
        None if fault is None else {"code": fault.code, "name": fault.name, "text": fault.text}
    )
    return json.dumps(report, indent=2) + "\n"


def ranges(numbers: list[int]) -> str:
    """Write ascending numbers briefly: 1, 2, 3, 7 as ``1-3, 7``."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][-1] + 1:
            runs[-1][1:] = [number]
        else:
            runs.append([number])
    return ", ".join("-".join(map(str, run)) for run in runs)


def as_text(frame: Frame) -> str:
    """Say in a line or two what a frame is and what it lacks."""
    header = frame.header
    origin = ", ".join(
        text for text in (header.scene, header.arithmetic, header.board, header.core) if text
    )
    start = f"frame {header.frame}, {header.width} x {header.height} {header.pixel_format.label}"
    if origin:
        start += f" ({origin})"
    missing = frame.missing_rows
    lacks = []
    if missing:
        lacks.append(
            f"{len(missing)} of {header.height} rows are missing or in part: {ranges(missing)}"
        )
    if frame.sent_checksum is None:
        lacks.append("its end did not come")
    elif frame.checksum_ok is False:
        lacks.append("the checksum of the whole frame is wrong")
    if frame.counts.crc_errors:
        lacks.append(f"damaged packets: {frame.counts.crc_errors}")
    return f"{start}: {'; '.join(lacks) if lacks else 'whole, checksum right'}"
