"""Names for new curves, which no other curve has."""

from __future__ import annotations

import re
from collections.abc import Set
from itertools import chain, count

from theditor.drawing.drawing import NAME_LENGTH

_ROOM = 12  # letters for what is put after a name


def new_name(taken: Set[str]) -> str:
    """The name of a curve made from nothing: ``"Curve 1"``."""
    return next(name for k in count(1) if (name := f"Curve {k}") not in taken)


def copy_name(name: str, taken: Set[str]) -> str:
    """The name of a copy of a curve: ``"Leaf copy"``, ``"Leaf copy 2"``."""
    stem = re.sub(r" copy( \d+)?$", "", name[: NAME_LENGTH - _ROOM]) + " copy"
    return next(each for each in chain([stem], (f"{stem} {k}" for k in count(2))) if each not in taken)


def part_name(name: str, taken: Set[str]) -> str:
    """The name of a part that is split off a curve: ``"Leaf (2)"``."""
    stem = re.sub(r" \(\d+\)$", "", name[: NAME_LENGTH - _ROOM])
    return next(part for k in count(2) if (part := f"{stem} ({k})") not in taken)
