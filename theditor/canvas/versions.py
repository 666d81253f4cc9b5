"""How an earlier and a later version of curves differ, seen quickly, and what they have in common."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from theditor.spline import Curve
from theditor.spline.changed import common_rows

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]
Array = NDArray[Any]

_EPSILON = float(np.finfo(np.float64).eps)
SAMPLE = 64
"""About so many of the control points are compared to see in how many they differ."""
FEW = 16
"""If no more than so many curves have changed, what is the same at their beginnings and ends is looked for."""


def whole_offset(old: Curve, new: Curve, slight: float) -> Floats | None:
    """By how much a whole curve has been moved, (2,); None if anything else may have happened to it.

    None, too, if rounding moves its points by more than is `slight`.
    """
    one, other = old.control_points, new.control_points
    if old.lambdas is not new.lambdas or one.shape != other.shape or one is other:
        return None
    if (old.degree, old.closed, old.ends) != (new.degree, new.closed, new.ends):
        return None
    offset: Floats = other[0] - one[0]
    length = max(map(abs, offset.tolist()))
    rounding = 4 * _EPSILON * (_size(one) + length)
    if not rounding < min(length / 2, slight):  # shorter ways could be of some points alone
        return None
    if _size(other[-1] - one[-1] - offset) > rounding:
        return None
    away = other - one
    away -= offset
    return offset if _size(away) <= rounding else None


def _size(values: Floats) -> float:
    """The largest absolute value; of a short array most of the time goes into calling NumPy."""
    return float(np.maximum.reduce(np.abs(values), axis=None))


def changed_share(old: Curve, new: Curve) -> float:
    """In about which share of the control points, or of their λ, two versions of a curve differ, from 0 to 1."""
    pairs = (old.control_points, new.control_points), (old.lambdas, new.lambdas)
    return max(_share(one, other) for one, other in pairs)


def _share(one: Array, other: Array) -> float:
    if one is other:
        return 0.0
    if one.shape != other.shape:
        return 1.0
    some = slice(None, None, len(one) // SAMPLE + 1)
    differ = one[some] != other[some]
    return float(np.mean(differ.any(axis=1) if differ.ndim == 2 else differ))


def same_segments(old: Sequence[Curve], old_begins: Ints, new: Sequence[Curve], begins: Ints) -> Ints:
    """Which segment of old curves each one of new curves is, −1 if it may be none of them, (k,).

    Looked for are whole curves and, of a few that have changed, what comes before the change and after it.

    Parameters
    ----------
    old, new
        The curves.
    old_begins, begins : (n + 1,)
        The numbers of their first segments, where all are counted through, and how many there are in all.
    """
    places = {id(curve): place for place, curve in enumerate(old)}
    sources = np.array([places.get(id(curve), -1) for curve in new], dtype=np.intp)
    counts, known = np.diff(begins), sources >= 0
    result: Ints = np.arange(begins[-1])
    result += np.repeat(old_begins[sources] - begins[:-1], counts)
    result[np.repeat(~known, counts)] = -1
    gone = np.ones(len(old), dtype=np.bool_)
    gone[sources[known]] = False
    changed = np.flatnonzero(~known).tolist()
    if len(changed) <= FEW:
        for place, source in zip(changed, np.flatnonzero(gone).tolist(), strict=False):
            before, after = _common_segments(old[source], new[place])
            (first, end), (old_first, old_end) = begins[place : place + 2], old_begins[source : source + 2]
            result[first : first + before] = np.arange(old_first, old_first + before)
            result[end - after : end] = np.arange(old_end - after, old_end)
    return result


def _common_segments(old: Curve, new: Curve) -> tuple[int, int]:
    """How many segments are the same at the beginnings and at the ends of two versions of a curve."""
    if (
        (old.degree, old.ends, old.dimension) != (new.degree, new.ends, new.dimension)
        or old.closed
        or new.closed
    ):
        return 0, 0
    most = min(old.segment_count, new.segment_count) - 1  # the first and the last one may be clamped
    begin, end = (_common_points(old, new, step) for step in (1, -1))
    before = min(max(begin - new.degree - new.first_segment + 1, 0), most)
    after = end + new.first_segment - 1 + new.segment_count - len(new.control_points)
    return before, min(max(after, 0), most - before)


def _common_points(old: Curve, new: Curve, step: int) -> int:
    """How many control points, with their λ, are the same from the beginning (step 1) or from the end (−1)."""
    return min(
        common_rows(old.control_points[::step], new.control_points[::step]),
        common_rows(old.lambdas[::step], new.lambdas[::step]),
    )
