"""Picking: what lies under a position on the screen. Everything here is in pixels; no Qt."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.trace import Stroke

Floats = NDArray[np.float64]

REACH = 8.0
"""How near, in pixels, the pointer must be to pick something."""


@dataclass(frozen=True)
class PointHit:
    """A control point of the current curve."""

    index: int


@dataclass(frozen=True)
class SegmentHit:
    """A place on a curve of the drawing."""

    curve: int
    segment: int
    t: float


Hit = PointHit | SegmentHit | None


def nearest_handle(handles: Floats, at: Floats, reach: float = REACH) -> int | None:
    """Index of the handle (n, 2) nearest to `at` (2,), the topmost (last) of equals; None beyond `reach`."""
    if not len(handles):
        return None
    squares = ((handles - at) ** 2).sum(axis=1)
    index = len(squares) - 1 - int(np.argmin(squares[::-1]))
    return index if squares[index] <= reach * reach else None


def nearest_place(
    strokes: Iterable[Stroke], at: Floats, reach: float = REACH
) -> tuple[float, int, float] | None:
    """Distance in pixels, segment and t of the drawn place nearest to `at` (2,); None beyond `reach`."""
    best: tuple[float, int, float] | None = None
    for stroke in strokes:
        start, along = stroke.lines[:, :2], stroke.lines[:, 2:] - stroke.lines[:, :2]
        squared_length = (along**2).sum(axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            f = np.nan_to_num(((at - start) * along).sum(axis=1) / squared_length).clip(0.0, 1.0)
        distances = np.hypot(*(start + f[:, None] * along - at).T)
        i = int(np.argmin(distances))
        if distances[i] <= reach and (best is None or distances[i] < best[0]):
            t0, t1 = stroke.parameters[i]
            best = float(distances[i]), int(stroke.segments[i]), float(t0 + f[i] * (t1 - t0))
    return best
