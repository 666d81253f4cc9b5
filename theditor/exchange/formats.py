"""The table of foreign formats, and the two functions that go by it."""

from __future__ import annotations

from importlib import import_module
from typing import Any, Final, NamedTuple

from theditor.drawing import Drawing, DrawingError
from theditor.exchange.options import DEFAULTS, Imported, Options, Progress, Written


class Format(NamedTuple):
    """A foreign format; its reader and writer are ``module:function`` of this package, imported when called."""

    name: str
    writer: str | None  # (drawing, options, progress) → Written
    reader: str | None = None  # (data, options, progress) → Imported


FORMATS: Final[dict[str, Format]] = {
    ".svg": Format("SVG picture", "svg:write", "svg_in:read"),
    ".pdf": Format("PDF picture", "picture:write_pdf"),
    ".png": Format("PNG picture", "picture:write_png"),
    ".dxf": Format("DXF drawing", "dxf:write"),
    ".tex": Format("TikZ picture", "tikz:write"),
    ".csv": Format("Table of points (CSV)", "csv:write", "csv_in:read"),
}
"""Formats by the suffix of their files, in lower case with its dot, in the order to offer them."""


def writable() -> tuple[str, ...]:
    """Return the suffixes that drawings can be written to."""
    return tuple(suffix for suffix, form in FORMATS.items() if form.writer)


def readable() -> tuple[str, ...]:
    """Return the suffixes that drawings can be read from."""
    return tuple(suffix for suffix, form in FORMATS.items() if form.reader)


def write(
    drawing: Drawing, suffix: str, options: Options = DEFAULTS, progress: Progress | None = None
) -> Written:
    """Turn a drawing into the bytes of a file in a foreign format. Hidden curves are left out.

    Parameters
    ----------
    drawing : Drawing
        May be empty: the file is then a valid one that shows nothing.
    suffix : str
        One of `writable`, such as ``".svg"``, in either case.
    options : Options
    progress : callable, optional
        Told now and then which share of the work is done, 0 to 1; what it raises ends the work.

    Raises
    ------
    DrawingError
        If there is no such format, or it cannot hold the drawing; the message is one sentence.
    """
    form = FORMATS.get(suffix.lower())
    if form is None or form.writer is None:
        raise DrawingError(_no_format(suffix, "written", writable()))
    written: Written = _function(form.writer)(drawing, options, progress)
    return written


def read(data: bytes, suffix: str, options: Options = DEFAULTS, progress: Progress | None = None) -> Imported:
    """Turn the bytes of a file in a foreign format into a drawing.

    Parameters
    ----------
    data : bytes
    suffix : str
        One of `readable`, such as ``".svg"``, in either case.
    options : Options
    progress : callable, optional
        Told now and then which share of the work is done, 0 to 1; what it raises ends the work.

    Raises
    ------
    DrawingError
        If there is no such format, or the data is not of it; the message is one sentence.
    """
    form = FORMATS.get(suffix.lower())
    if form is None or form.reader is None:
        raise DrawingError(_no_format(suffix, "read", readable()))
    imported: Imported = _function(form.reader)(data, options, progress)
    return imported


def _function(place: str) -> Any:
    module, _, name = place.partition(":")
    return getattr(import_module(f"theditor.exchange.{module}"), name)


def _no_format(suffix: str, done: str, known: tuple[str, ...]) -> str:
    kind = f"Files ending in {suffix!a}" if suffix else "Files without a suffix"
    return f"{kind} cannot be {done}: choose one of {', '.join(known)}."
