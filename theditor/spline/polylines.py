"""The places of a polyline nearest to points."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from theditor.spline.basis import Floats

_RUN: Final = 32  # edges
_ROOM: Final = 500_000  # points × runs at a time


def nearest_on_line(points: Floats, line: Floats) -> tuple[Floats, Floats]:
    """Return where on a polyline it is nearest to each of some points, and how far away.

    Its edges are taken a run at a time: of each point the run that may be nearest, then those that its box
    does not rule out.

    Parameters
    ----------
    points : ndarray, shape (n, d)
    line : ndarray, shape (k, d)

    Returns
    -------
    places : ndarray, shape (n,)
        Edges, counted from 0, and how far along them.
    distances : ndarray, shape (n,)
    """
    starts = np.arange(0, len(line) - 1, _RUN)
    corners = np.minimum(starts[:, None] + np.arange(_RUN + 1), len(line) - 1)
    runs = line[corners]  # the last one ends in edges without length
    low, high = runs.min(axis=1), runs.max(axis=1)
    places, squares = np.empty(len(points)), np.empty(len(points))
    size = max(1, _ROOM // len(runs))
    for i in range(0, len(points), size):
        block = points[i : i + size]
        gaps = np.maximum(np.maximum(low - block[:, None], block[:, None] - high), 0)
        least = np.einsum("nkd,nkd->nk", gaps, gaps)
        run = least.argmin(axis=1)
        every = np.arange(len(block))
        least[every, run] = np.inf
        best, place = _on_runs(block, runs[run])
        place += run * _RUN
        point, run = np.nonzero(least < best[:, None])
        other, at = _on_runs(block[point], runs[run])
        # The nearest of each point comes last, and stays.
        order = np.argsort(-other, kind="stable")
        order = order[other[order] < best[point[order]]]
        best[point[order]], place[point[order]] = other[order], at[order] + run[order] * _RUN
        places[i : i + size], squares[i : i + size] = place, best
    return places, np.sqrt(squares)


def _on_runs(points: Floats, runs: Floats) -> tuple[Floats, Floats]:
    """Return the squared distance of each point from a polyline of its own, and where that is nearest."""
    start, edge = runs[:, :-1], np.diff(runs, axis=1)
    away = points[:, None] - start
    square = np.einsum("nkd,nkd->nk", edge, edge)
    foot = np.einsum("nkd,nkd->nk", away, edge)
    t = np.clip(np.divide(foot, square, out=np.zeros_like(foot), where=square > 0), 0, 1)
    away -= t[:, :, None] * edge
    squares = np.einsum("nkd,nkd->nk", away, away)
    nearest: NDArray[np.intp] = squares.argmin(axis=1)
    every = np.arange(len(points))
    return squares[every, nearest], nearest + t[every, nearest]
