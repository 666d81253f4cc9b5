"""Segments as straight pieces for a window, however small a part of one it shows."""

from collections.abc import Iterator
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.spline.basis import Floats
from theditor.spline.distinct import distinct
from theditor.spline.joints import Segments, evaluate
from theditor.spline.sampling import MOST_INTERVALS, intervals_within, sample_parts

Ints = NDArray[np.intp]

CUT: Final = 8
"""Into so many equal parts a piece is cut that strays too far."""
SHORTEST: Final = 2.0**-40
"""No step of t is shorter: beyond, rounding says where points are."""


class Pieces(NamedTuple):
    """Straight pieces of segments."""

    lines: Floats  # (n, 2·d) start and end of each
    segments: Ints  # (n,) which segment it belongs to
    t: Floats  # (n, 2) parameters of its start and end


def pieces_in_view(
    parts: Segments, of: Ints, degree: int, turning: Floats, tolerance: float, low: Floats, high: Floats
) -> Iterator[Pieces]:
    """Return straight pieces, within a tolerance, of all that a window shows of k segments in joint form.

    What it does not show may be left out. Those of one segment are in order, the segments are not.

    Parameters
    ----------
    parts, degree
        The segments.
    of : (k,)
        Their numbers, by which the pieces are told apart.
    turning : (k,)
        Bounds of |C''| along them.
    tolerance
        Largest distance of a piece from the curve.
    low, high : (d,)
        Corners of the window.
    """
    steps = intervals_within(turning, tolerance)
    steps[turning > 8 * tolerance * MOST_INTERVALS**2] = 0  # they would stray too far
    for count in distinct(steps).tolist():
        own = np.flatnonzero(steps == count)
        some = parts.take(own) if len(own) < len(steps) else parts
        if not count:
            yield _magnified(some, of[own], degree, turning[own], tolerance, low, high)
            continue
        points = sample_parts(some, degree, steps[own]).points.T.reshape(-1, len(own), count + 1)
        lines = np.stack((*points[:, :, :-1], *points[:, :, 1:]), axis=2)
        t = np.arange(count) / count
        t = np.tile(np.stack((t, t + 1 / count), axis=1), (len(own), 1))
        yield Pieces(lines.reshape(len(t), -1), np.repeat(of[own], count), t)


def _magnified(
    parts: Segments, of: Ints, degree: int, turning: Floats, tolerance: float, low: Floats, high: Floats
) -> Pieces:
    """Cut segments again and again, but only what a window may show of them."""
    run, begin, step = np.arange(len(of)), np.zeros(len(of)), 1.0
    found = []
    while len(run):
        form = parts.take(run)
        start, end = (evaluate(form, t, degree, 0) for t in (begin, begin + step))
        stray = turning[run] * (step * step / 8)
        seen = (np.minimum(start, end) - stray <= high[:, None]).all(axis=0)
        seen &= (np.maximum(start, end) + stray >= low[:, None]).all(axis=0)
        fine = seen & ((stray <= tolerance) | (step <= SHORTEST))
        found.append(
            (np.concatenate((start, end))[:, fine].T, of[run[fine]], begin[fine, None] + (0.0, step))
        )
        coarse = seen & ~fine
        step /= CUT
        run, begin = np.repeat(run[coarse], CUT), (begin[coarse, None] + step * np.arange(CUT)).ravel()
    lines, segments, t = (np.concatenate(rows) for rows in zip(*found, strict=True))
    order = np.lexsort((t[:, 0], segments))
    return Pieces(lines[order], segments[order], t[order])
