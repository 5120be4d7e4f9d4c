"""Files that are there whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO

from .errors import ENVIRONMENT, USER_MISTAKE, CommandError


def check_writable(option: str, path: Path) -> None:
    """Find out before anything is received whether a file can be written.

    Raises:
        CommandError: names the option and what is wrong.
    """
    folder = path.parent
    if path.is_dir():
        raise CommandError(USER_MISTAKE, f"{option} {path}: is a folder, must be a file")
    if not folder.is_dir():
        raise CommandError(USER_MISTAKE, f"{option} {path}: there is no folder {folder}")
    if not os.access(folder, os.W_OK):
        raise CommandError(ENVIRONMENT, f"{option} {path}: no permission to write into {folder}")


def write_whole(path: Path, write: Callable[[BinaryIO], object]) -> None:
    """Write a file beside its place and move it there once it is whole.

    Raises:
        CommandError: if it can't be written; nothing is left behind then.
    """
    beside = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        try:
            with beside.open("xb") as file:
                write(file)
            beside.replace(path)
        finally:
            beside.unlink(missing_ok=True)
    except OSError as error:
        raise CommandError(ENVIRONMENT, f"cannot write {path}: {error.strerror}") from error


def numbered(path: Path, number: int, of: int) -> Path:
    """Name for one of several frames: FILE-0001.png and so on, FILE.png if there is one only."""
    return path if of == 1 else path.with_name(f"{path.stem}-{number:04}{path.suffix}")
