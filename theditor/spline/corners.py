"""Corners: a control point repeated as often as the degree says, which makes the curve stand still there."""

from typing import Final

import numpy as np

from theditor.spline.basis import CONVEX_HULL_RANGE, JOINT_SLOPE_ZERO
from theditor.spline.checks import check_count, clean_indices
from theditor.spline.curve import Curve

_LEGS: Final = {2: (JOINT_SLOPE_ZERO, CONVEX_HULL_RANGE[2][1]), 3: CONVEX_HULL_RANGE[3]}
"""The λ with which the curve goes straight to the corner; others send it past the corner and back."""


def corner(curve: Curve, index: int) -> Curve:
    """Return the curve with a corner at a control point, which it meets along the edges of the polygon.

    The point is repeated, `degree` times in all. λ there come into the range in which the curve does not
    overshoot; all others stay.

    Raises
    ------
    ValueError
        If there is no such control point, or it is the end of an open curve.
    """
    start, length = _run(curve, index)
    count, degree = len(curve.control_points), curve.degree
    if not curve.closed and (start == 0 or start + length == count):
        raise ValueError(f"control point {index} is an end of the curve: choose one between the ends")
    more = max(degree - length, 0)
    at, last = start + 1, start + max(length, degree) - 1
    points = np.insert(curve.control_points, [at] * more, curve.control_points[start], axis=0)
    lambdas = np.insert(curve.lambdas, [at] * more, curve.lambdas[start])
    # A quadratic's λ at the legs belong to the edges before and after the point, a cubic's to the point.
    legs = np.array([start, last + 1] if degree == 2 else range(start, last + 1)) % len(points)
    lambdas[legs] = np.clip(lambdas[legs], *_LEGS[degree])
    return curve.with_(control_points=points, lambdas=lambdas)


def smooth(curve: Curve, index: int) -> Curve:
    """Return the curve with a repeated control point there only once, so that the corner goes.

    Raises
    ------
    ValueError
        If there is no such control point, or fewer would stay than the curve needs.
    """
    start, length = _run(curve, index)
    count = len(curve.control_points)
    check_count(count - length + 1, curve.degree, curve.closed, curve.ends)
    repeats = np.arange(start + 1, start + length) % count
    return curve.with_(
        control_points=np.delete(curve.control_points, repeats, axis=0),
        lambdas=np.delete(curve.lambdas, repeats),
    )


def _run(curve: Curve, index: int) -> tuple[int, int]:
    """Return where the equal control points around one begin, and how many there are."""
    count = len(curve.control_points)
    (start,) = clean_indices(index, count, "control point").tolist()
    same = (curve.control_points == curve.control_points[start]).all(axis=1)
    if same.all():
        return 0, count
    end = start
    while (start > 0 or curve.closed) and same[(start - 1) % count]:
        start -= 1
    while (end < count - 1 or curve.closed) and same[(end + 1) % count]:
        end += 1
    return start % count, end - start + 1
