"""Strokes as given: cleaned polylines, their corners, and how far a curve is from one."""

from itertools import pairwise
from math import dist
from typing import Final

import numpy as np
from numpy.typing import NDArray

from theditor.spline.basis import Floats
from theditor.spline.curve import Curve
from theditor.spline.deviation import farthest
from theditor.spline.distinct import moves_on
from theditor.spline.polylines import nearest_on_line
from theditor.spline.sampling import evaluate_segments

_TURN: Final = np.cos(
    np.radians(60)
)  # a sharper turn, from some tolerances before to some after, is a corner
_ARM: Final = 4.0  # tolerances
_SCALE: Final = 3.0  # tolerances
_FINEST: Final = 400
_PER_SEGMENT: Final = 16  # points of the curve to compare with the stroke
_FINE: Final = 128  # the same where a segment may be the one that gets farthest off
_SUSPECT: Final = 0.7  # of the farthest seen: a segment that gets so far off is looked at more closely
_BLOCK: Final = 2048  # of these points at a time


def cleaned(points: Floats, closed: bool) -> Floats:
    """Return a stroke without points that repeat the one before."""
    points = points[moves_on(points)]
    if closed and len(points) > 1 and (points[0] == points[-1]).all():
        points = points[:-1]
    least = 3 if closed else 2
    if len(np.unique(points, axis=0)) < least:
        raise ValueError(
            f"{'a closed' if closed else 'an open'} stroke needs at least {least} different points"
        )
    return points


def lengths(points: Floats) -> Floats:
    """Return the length along a polyline up to each of its points, (n,)."""
    return np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))


def along(points: Floats, s: Floats) -> Floats:
    """Return the points of a polyline at some lengths along it, (len(s), d)."""
    at = lengths(points)
    return np.stack([np.interp(s, at, x) for x in points.T], axis=1)


def effort(line: Floats, tolerance: float) -> tuple[Floats, Floats]:
    """Return lengths along a polyline and what part of its control points each calls for, 0 to 1.

    Half of them are spread by length, half by how much the stroke turns, seen at the scale of the tolerance.
    """
    length = float(lengths(line)[-1])
    count = int(np.clip(length / (_SCALE * tolerance), 8, _FINEST))
    s = np.linspace(0, length, count + 1)
    chords = np.diff(along(line, s), axis=0)
    size = np.maximum(np.linalg.norm(chords, axis=1), 1e-300)
    cosines = np.sum(chords[1:] * chords[:-1], axis=1) / (size[1:] * size[:-1])
    turns = np.arccos(np.clip(cosines, -1, 1))
    # Each turn belongs half to the chord before and half to the one after.
    turning = (np.append(turns, 0) + np.append(0, turns)) / 2 + 1e-9
    each = 0.5 / count + 0.5 * turning / turning.sum()
    each /= each.sum()
    return s, np.append(0.0, np.cumsum(each))


def corners(points: Floats, tolerance: float, closed: bool) -> list[int]:
    """Return which points of a stroke are corners, ascending; the ends of an open one are none.

    At a corner the stroke turns by more than 60° between four tolerances before it and four after, and more
    than at any other point so near. Points closer together than a quarter of the tolerance tell no direction.
    """
    kept = _thinned(points, tolerance / 4)
    return sorted({_tip(points, kept, i) for i in _sharp(points[kept], tolerance, closed)})


def _thinned(points: Floats, least: float) -> list[int]:
    """Return which points of a stroke to keep for none to be closer to the one before than that."""
    rows = points.tolist()
    kept = [0]
    for index, row in enumerate(rows):
        if dist(row, rows[kept[-1]]) >= least:
            kept.append(index)
    return kept


def _tip(points: Floats, kept: list[int], index: int) -> int:
    """Return the point of a stroke around a kept one that lies farthest from the kept ones on either side."""
    count = len(points)
    start, end = kept[index - 1], kept[(index + 1) % len(kept)]
    around = np.arange(start, end if end > start else end + count) % count
    reach = np.linalg.norm(points[around] - points[start], axis=1)
    return int(around[np.argmax(reach + np.linalg.norm(points[around] - points[end], axis=1))])


def _sharp(points: Floats, tolerance: float, closed: bool) -> list[int]:
    """Return which points of a stroke are corners, in no order."""
    arm = _ARM * tolerance
    # A closed stroke goes round three times, of which the second counts.
    line = np.concatenate((points, points, points, points[:1])) if closed else points
    s = lengths(line)
    own = np.arange(len(points)) + (len(points) if closed else 0)
    inner = own[(s[own] > arm) & (s[own] < s[-1] - arm)]
    before = line[inner] - along(line, s[inner] - arm)
    after = along(line, s[inner] + arm) - line[inner]
    size = np.linalg.norm(before, axis=1) * np.linalg.norm(after, axis=1)
    straight = np.divide(np.sum(before * after, axis=1), size, out=np.ones(len(inner)), where=size > 0)
    found: list[int] = []
    for candidate in np.argsort(straight, kind="stable"):
        if straight[candidate] >= _TURN:
            break
        index = int(inner[candidate])
        gaps = [abs(s[index] - s[other]) for other in found]
        if closed:
            gaps = [min(gap, s[len(points)] - gap) for gap in gaps]
        if all(gap > 2 * arm for gap in gaps):
            found.append(index)
    return [index % len(points) for index in found]


def distance(points: Floats, curve: Curve, u: Floats) -> float:
    """Return how far a stroke's points are from a curve, or the curve from the polyline, whichever is more.

    Parameters
    ----------
    points : ndarray, shape (n, d)
    curve : Curve
    u : ndarray, shape (n,)
        About where on the curve the points belong.
    """
    line = np.concatenate((points, points[:1])) if curve.closed else points
    every = np.arange(curve.segment_count)
    coarse = _off_line(curve, every, _PER_SEGMENT, line)
    suspects = every[coarse >= _SUSPECT * coarse.max()]
    return max(farthest(points, curve, u), float(_off_line(curve, suspects, _FINE, line).max()))


def _off_line(curve: Curve, segments: NDArray[np.intp], intervals: int, line: Floats) -> Floats:
    """Return how far each of some segments gets from a polyline, seen at equal steps of t."""
    size = max(1, _BLOCK // (intervals + 1))
    farthest_of = []
    for i in range(0, len(segments), size):
        block = evaluate_segments(curve, segments[i : i + size], intervals)
        _, away = nearest_on_line(block.reshape(-1, curve.dimension), line)
        farthest_of.append(away.reshape(len(block), -1).max(axis=1))
    return np.concatenate(farthest_of)


def parts(points: Floats, at: list[int], closed: bool) -> list[Floats]:
    """Return a stroke cut at its corners; a closed one begins and ends at the first of them."""
    if closed:
        points = np.roll(points, -at[0], axis=0)
        points = np.concatenate((points, points[:1]))
        at = [index - at[0] for index in at[1:]]
    return [points[start : end + 1] for start, end in pairwise([0, *at, len(points) - 1])]
