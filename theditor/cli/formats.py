"""What the commands that deal with foreign formats have in common."""

from __future__ import annotations

from argparse import ArgumentTypeError
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from theditor.cli import UsageError
from theditor.cli.streams import STANDARD
from theditor.drawing import DrawingError, shown
from theditor.exchange import FORMATS, Options


def names(suffixes: Sequence[str]) -> str:
    """Return what formats are called on the command line: ``svg, csv``."""
    return ", ".join(suffix.removeprefix(".") for suffix in suffixes)


def chosen_suffix(wanted: str | None, name: str, known: Sequence[str]) -> str:
    """Return the suffix of the format that is asked for, else that of a file; UsageError if it is not known."""
    if wanted is not None:
        suffix = f".{wanted.lower().removeprefix('.')}"
        problem = f"--format must be one of {names(known)}, not {wanted!a}"
    elif name == STANDARD:
        suffix, problem = "", f"- has no suffix: say --format, one of {names(known)}"
    else:
        suffix = Path(name).suffix.lower()
        problem = (
            f"{shown(name)} does not end in one of {names(known)}: say --format if it is one all the same"
        )
    if suffix not in known:
        raise UsageError(problem)
    return suffix


def drawing_name(name: str) -> str:
    """Return the name of a file to write a drawing to; an error of the argument if it is that of another kind."""
    if Path(name).suffix.lower() in FORMATS:
        raise ArgumentTypeError(f"{shown(name)} would hold a drawing: let its name end in .json")
    return name


def checked_options(**values: Any) -> Options:
    """Return the options; UsageError if a value is none."""
    try:
        return Options(**values)
    except DrawingError as error:
        raise UsageError(str(error).removesuffix(".")) from None
