"""``theditor gallery``: list the gallery, or take a drawing from it."""

from __future__ import annotations

import argparse
from difflib import get_close_matches

from theditor.cli import UsageError, streams
from theditor.cli.formats import drawing_name
from theditor.drawing import load, shown
from theditor.resources import gallery


def declare(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments."""
    parser.description = "List the drawings of the gallery, or write one of them."
    parser.add_argument(
        "name", metavar="NAME", nargs="?", help="the drawing to take; without it all are listed"
    )
    parser.add_argument(
        "-o",
        dest="out",
        metavar="OUT.json",
        type=drawing_name,
        default=streams.STANDARD,
        help="where to write it",
    )
    parser.add_argument(
        "--overwrite",
        action="store_true",
        help="replace OUT.json even if it holds something other than a drawing",
    )


def run(options: argparse.Namespace) -> int:
    """List the gallery or write a drawing."""
    pictures = {picture.name: picture for picture in gallery()}
    if options.name is None:
        if options.out != streams.STANDARD:
            raise UsageError("name the drawing to write")
        width = max(map(len, pictures))
        for picture in pictures.values():
            print(f"{picture.name:<{width}}  {picture.title}")
        return 0
    if options.name not in pictures:
        near = get_close_matches(options.name, pictures, 1)
        hint = f"did you mean {near[0]}?" if near else "theditor gallery lists what there is"
        raise UsageError(f"the gallery has no drawing {shown(options.name)!a}: {hint}")
    streams.write_drawing(options.out, load(pictures[options.name].path), options.overwrite)
    return 0
