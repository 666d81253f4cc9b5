"""``theditor export``: write drawings in foreign formats."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from tqdm import tqdm

from theditor.cli import UsageError, fail, streams
from theditor.cli.formats import checked_options, chosen_suffix, names
from theditor.cli.window import missing_library
from theditor.drawing import DrawingError, shown
from theditor.exchange import PARTS, Options, told, writable, write
from theditor.exchange.options import DEFAULTS

_BINARY = {".pdf", ".png"}


def declare(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments."""
    parser.description = f"Write drawings as {names(writable())}: exact where the format can be."
    add = parser.add_argument
    add("files", metavar="FILE", nargs="+", help="drawings to read, or - for standard input")
    add("-o", dest="out", metavar="OUT", required=True, help="the file to write, a folder for several, or -")
    add("--format", help="the format, if the name of OUT does not tell; for a folder it must be said")
    add(
        "--tolerance",
        type=float,
        default=DEFAULTS.tolerance,
        help="largest deviation where the format cannot be exact, as a share of the drawing's size (%(default)g)",
    )
    picture = parser.add_argument_group("pictures")
    add = picture.add_argument
    add("--size", type=float, help="longer side, in pixels for PNG and in millimetres for the others")
    add("--scale", type=float, help="millimetres for each unit of the drawing, instead of a size")
    add("--dpi", type=float, default=DEFAULTS.dpi, help="pixels per inch of a PNG (%(default)g)")
    add("--transparent", action="store_true", help="no white ground in a PNG")
    add(
        "--show", metavar="PARTS", default="", help=f"besides the curves: {','.join(PARTS)}, or some of these"
    )
    add("--print-style", action="store_true", help="as in a paper: black, labelled, each mode in its dashes")
    table = parser.add_argument_group("tables (CSV)")
    add = table.add_argument
    add(
        "--sampling",
        choices=("parameter", "length", "tolerance"),
        default=DEFAULTS.sampling,
        help="where points are taken (%(default)s)",
    )
    add(
        "--samples",
        type=int,
        default=DEFAULTS.samples,
        help="steps for each segment, or for each curve if by length (%(default)s)",
    )
    add("--tangent", action="store_true", help="with columns for the unit tangent")
    add("--curvature", action="store_true", help="with a column for the curvature")


def run(options: argparse.Namespace) -> int:
    """Write every drawing that can be, say what cannot, and return 1 if there was such a one."""
    chosen = checked_options(
        tolerance=options.tolerance,
        size=options.size,
        scale=options.scale,
        dpi=options.dpi,
        transparent=options.transparent,
        show=frozenset(filter(None, options.show.split(","))),
        print_style=options.print_style,
        sampling=options.sampling,
        samples=options.samples,
        tangent=options.tangent,
        curvature=options.curvature,
    )
    suffix, targets = _planned(options.files, options.out, options.format)
    several = len(targets) > 1
    code = 0
    # A bar is drawn on a terminal alone, and only of several drawings.
    for source, target in tqdm(
        list(zip(options.files, targets, strict=True)),
        disable=None if several else True,
        leave=False,
        unit="file",
    ):
        try:
            _export(source, target, suffix, chosen)
        except DrawingError as error:
            with tqdm.external_write_mode():
                code = fail(error)
        except ImportError as error:  # of Qt, for PDF and PNG
            return fail(missing_library(error))
    return code


def _planned(files: Sequence[str], out: str, wanted: str | None) -> tuple[str, list[str]]:
    """Return the suffix of the format, and where each drawing is written to; the folder for several is made."""
    if out == streams.STANDARD or not (len(files) > 1 or out.endswith("/") or Path(out).is_dir()):
        if len(files) > 1:
            raise UsageError("several drawings need a folder to be written to")
        suffix, targets = chosen_suffix(wanted, out, writable()), [out]
    else:
        if wanted is None:
            raise UsageError(f"{shown(out)} is to be a folder: say --format, one of {names(writable())}")
        suffix = chosen_suffix(wanted, out, writable())
        targets = _in_folder(files, Path(out), suffix)
    _refuse_confusion(files, targets)
    if out == streams.STANDARD and suffix in _BINARY and sys.stdout is not None and sys.stdout.isatty():
        raise UsageError(f"{suffix.removeprefix('.').upper()} is not for a terminal: name a file or a pipe")
    return suffix, targets


def _in_folder(files: Sequence[str], folder: Path, suffix: str) -> list[str]:
    """Return a file in the folder for each drawing, called like it."""
    if streams.STANDARD in files:
        raise UsageError("standard input has no name for a file in a folder: name OUT with a suffix")
    names = [Path(file).stem + suffix for file in files]
    for name in names:
        if names.count(name) > 1:
            place = shown(folder / name)
            raise UsageError(f"several drawings would be written to {place}: export each to another folder")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise DrawingError(f"{shown(folder)} cannot be made a folder: {error.strerror}.") from error
    return [str(folder / name) for name in names]


def _refuse_confusion(files: Sequence[str], targets: Sequence[str]) -> None:
    """Refuse that a drawing would be replaced by its own picture."""
    inputs = {os.path.realpath(file) for file in files if file != streams.STANDARD}
    for target in targets:
        if target != streams.STANDARD and os.path.realpath(target) in inputs:
            raise UsageError(f"{shown(target)} is the drawing itself: name another OUT")


def _export(source: str, target: str, suffix: str, options: Options) -> None:
    written = write(streams.read_drawing(source), suffix, options)
    streams.write(target, written.data)
    # What was written is told beside it where it is the output itself.
    name, stream = (
        (shown(target), sys.stdout) if target != streams.STANDARD else ("standard output", sys.stderr)
    )
    with tqdm.external_write_mode():
        print(f"{name}: {told(written.deviation, written.notes)}", file=stream)
