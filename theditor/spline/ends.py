"""Closed, open with free ends, open with clamped ends: from each to the others, the shape kept as well as it can be."""

from typing import Final

import numpy as np

from theditor.spline.checks import check_closed, check_ends
from theditor.spline.curve import Curve, Ends
from theditor.spline.deviation import deviation
from theditor.spline.pieces import clamped_form, closed, opened, with_free_ends
from theditor.spline.points import Edited, insert
from theditor.spline.refit import refitted

_AROUND: Final = 4  # control points that are refitted at either end
_REACH: Final = 3  # segments beyond them that they shape
_PER_SEGMENT: Final = 12  # samples of the old shape


def with_ends(curve: Curve, is_closed: bool, ends: Ends = "free") -> Edited:
    """Return the curve closed, or open with the ends asked for.

    A closed curve is opened where it begins, and one is closed as by `closed`. Opening is exact, so are free ends, and
    so is clamping a quadratic. A clamped cubic has no curvature at its ends, so that the control points near them are
    refitted; their number stays.

    Parameters
    ----------
    ends
        ``"free"`` or ``"clamped"``; a closed curve has none.

    Raises
    ------
    ValueError
        If `is_closed` is no truth value, or the ends are unknown.
    """
    check_closed(is_closed)
    check_ends(ends)
    if is_closed:
        return Edited(curve, 0.0) if curve.closed else closed(curve)
    if curve.closed:
        curve = opened(curve).curve.with_(ends="free")
    elif curve.ends == ends:
        return Edited(curve, 0.0)
    return _clamped(curve) if ends == "clamped" else Edited(with_free_ends(curve), 0.0)


def _clamped(curve: Curve) -> Edited:
    """Return a curve with free ends clamped."""
    count = curve.segment_count
    if curve.degree == 2:
        return Edited(clamped_form(curve), 0.0)
    # A control point more at each end makes room for the straight start, and makes up for the one that goes.
    fine = insert(insert(curve, 0.5).curve, count + 0.5).curve
    points = clamped_form(fine).control_points.copy()
    points[[0, -1]] = curve([0, count])
    start = clamped_form(fine).with_(control_points=points)
    u = np.linspace(0, count, _PER_SEGMENT * count + 1)
    old, new = (
        ([0, 0.5, 1], [0, 1, 3]) if count == 1 else ([0, 1, count - 1, count], [0, 2, count, count + 2])
    )
    last = len(points) - 1
    free = np.union1d(np.arange(1, min(1 + _AROUND, last)), np.arange(max(last - _AROUND, 1), last))
    v = np.interp(u, old, new)
    near = np.minimum(v, count + 2 - v) < _AROUND + _REACH  # the shape is the same elsewhere
    result, _ = refitted(start, curve(u[near]), v[near], free)
    return Edited(result, _off(curve, result))


def _off(curve: Curve, result: Curve) -> float:
    """Return how far a curve is from the one clamped, which has a segment more at each end."""
    count, end = curve.segment_count, _AROUND + _REACH
    if count <= 2 * end:
        return deviation(curve, result, (0, count), (0, count + 2))
    # Segment by segment in between, where hardly any differ.
    u, v = np.array([0, end, count - end, count]), np.array([0, end + 1, count - end + 1, count + 2])
    return max(deviation(curve, result, u[i : i + 2], v[i : i + 2]) for i in range(3))
