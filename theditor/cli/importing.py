"""``theditor import``: make a drawing of a file in a foreign format."""

from __future__ import annotations

import argparse
import sys

from tqdm import tqdm

from theditor.cli import streams
from theditor.cli.formats import checked_options, chosen_suffix, drawing_name, names
from theditor.drawing import DrawingError
from theditor.exchange import read, readable, told
from theditor.exchange.options import DEFAULTS


def declare(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments."""
    parser.description = (
        f"Make a drawing of a file of another kind ({names(readable())}): exact curves where there are any, "
        "else fitted ones."
    )
    parser.add_argument("file", metavar="FILE", help="the file to read, or - for standard input")
    parser.add_argument(
        "-o",
        dest="out",
        metavar="OUT.json",
        type=drawing_name,
        required=True,
        help="the drawing to write, or -",
    )
    parser.add_argument("--format", help="the format of FILE, if its name does not tell")
    parser.add_argument(
        "--tolerance",
        type=float,
        default=DEFAULTS.tolerance,
        help="largest deviation of a fit, as a share of the size (%(default)g)",
    )
    parser.add_argument(
        "--degree",
        type=int,
        choices=(2, 3),
        default=DEFAULTS.degree,
        help="degree of fitted curves (%(default)s)",
    )
    parser.add_argument(
        "--control-points",
        action="store_true",
        help="take the rows of a table as control points, not as points to pass through",
    )
    parser.add_argument(
        "--overwrite",
        action="store_true",
        help="replace OUT.json even if it holds something other than a drawing",
    )


def run(options: argparse.Namespace) -> int:
    """Read, fit and write."""
    suffix = chosen_suffix(options.format, options.file, readable())
    chosen = checked_options(
        tolerance=options.tolerance, degree=options.degree, control_points=options.control_points
    )
    data = streams.read(options.file)
    # A bar is drawn on a terminal alone.
    with tqdm(total=1.0, disable=None, leave=False, bar_format="{percentage:3.0f}% |{bar}|") as bar:
        try:
            made = read(data, suffix, chosen, lambda share: bar.update(share - bar.n))
        except DrawingError as error:
            raise DrawingError(f"{streams.label(options.file)}: {error}") from None
    streams.write_drawing(options.out, made.drawing, options.overwrite)
    stream = sys.stderr if options.out == streams.STANDARD else sys.stdout
    print(f"{streams.label(options.file)}: {told(made.deviation, made.notes)}", file=stream)
    return 0
