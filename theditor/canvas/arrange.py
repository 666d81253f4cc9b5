"""Flip, align and distribute control points: points in, points out."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from theditor.canvas.held import Held
from theditor.canvas.viewport import Floats
from theditor.model import Document, Selection
from theditor.model.words import points_counted

Arrange = Callable[[Floats], Floats]


def flipped(axis: int) -> Arrange:
    """Mirror points (n, 2) along an axis, in the middle of their box."""

    def flip(points: Floats) -> Floats:
        result = points.copy()
        x = points[:, axis]
        result[:, axis] = x.min() + (x.max() - x)
        return result

    return flip


def aligned(axis: int, share: float) -> Arrange:
    """Give points (n, 2) one coordinate: the least of theirs (share 0), the greatest (1), or between."""

    def align(points: Floats) -> Floats:
        result = points.copy()
        x = points[:, axis]
        result[:, axis] = (1 - share) * x.min() + share * x.max()
        return result

    return align


def distributed(axis: int) -> Arrange:
    """Space points (n, 2) evenly along an axis, between the outermost, in the order in which they lie."""

    def distribute(points: Floats) -> Floats:
        result = points.copy()
        x = points[:, axis]
        result[np.argsort(x, kind="stable"), axis] = np.linspace(x.min(), x.max(), len(x))
        return result

    return distribute


def arrange(document: Document, selection: Selection, text: str, how: Arrange) -> None:
    """Apply `how` to the selected control points, or to all of the selected curves if there is none.

    They are arranged as one set, whichever curves they are on, in one step that is called `text` and counts them.
    """
    document.settle()
    held = Held(document.drawing, selection.in_hand)
    chosen = selection.movable
    document.apply(f"{text}: {points_counted(chosen)}" if chosen else text, held.at(how(held.places)))
