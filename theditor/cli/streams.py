"""Files given by name, where ``-`` is standard input or output."""

from __future__ import annotations

import sys
from pathlib import Path

from theditor.drawing import Drawing, DrawingError, decode, read_bytes, save, shown, write_atomically
from theditor.drawing.schema import encode
from theditor.drawing.storage import MAX_BYTES

STANDARD = "-"


def label(name: str) -> str:
    """Return what to call an input in a sentence."""
    return "standard input" if name == STANDARD else shown(name)


def read(name: str) -> bytes:
    """Return the bytes of a file or of standard input; DrawingError if they cannot be read."""
    if name != STANDARD:
        return read_bytes(name)
    if sys.stdin is None:
        raise DrawingError("standard input is closed.")
    data = sys.stdin.buffer.read(MAX_BYTES + 1)
    if len(data) > MAX_BYTES:
        raise DrawingError(
            f"standard input holds more than {MAX_BYTES // 2**20} MiB, the most a file may take."
        )
    return data


def read_drawing(name: str) -> Drawing:
    """Return the drawing in a file or from standard input; DrawingError names where it came from."""
    data = read(name)
    try:
        return decode(data)
    except DrawingError as error:
        raise DrawingError(f"{label(name)}: {error}{_hint(name)}") from None


def _hint(name: str) -> str:
    """Return what to do with a file that is no drawing but can be made one."""
    from theditor.exchange import readable  # seldom needed

    return " (theditor import makes a drawing of it.)" if Path(name).suffix.lower() in readable() else ""


def write(name: str, data: bytes) -> None:
    """Write bytes to a file or to standard output."""
    if name != STANDARD:
        write_atomically(name, data)
        return
    if sys.stdout is None:
        raise DrawingError("standard output is closed.")
    sys.stdout.buffer.write(data)


def write_drawing(name: str, drawing: Drawing, overwrite: bool) -> None:
    """Write a drawing to a file, as `save` does, or to standard output."""
    if name == STANDARD:
        write(name, encode(drawing))
    else:
        save(drawing, name, overwrite)
