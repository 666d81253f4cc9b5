"""Corners: a control point repeated as often as the degree says, which makes the curve stand still there."""

from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline.basis import CONVEX_HULL_RANGE, JOINT_SLOPE_ZERO
from theditor.spline.checks import check_count, clean_indices
from theditor.spline.curve import Curve
from theditor.spline.distinct import distinct, moves_on

Indices = NDArray[np.intp]

_LEGS: Final = {2: (JOINT_SLOPE_ZERO, CONVEX_HULL_RANGE[2][1]), 3: CONVEX_HULL_RANGE[3]}
"""The λ with which the curve goes straight to the corner; others send it past the corner and back."""


def corner(curve: Curve, indices: ArrayLike) -> Curve:
    """Return the curve with a corner at some control points, which it meets along the edges of the polygon.

    Each point is repeated, `degree` times in all. λ there come into the range in which the curve does not
    overshoot; all others stay.

    Parameters
    ----------
    curve : Curve
    indices : int or array_like of int

    Raises
    ------
    ValueError
        If there is no such control point, or it is the end of an open curve.
    """
    where = clean_indices(indices, len(curve.control_points), "control point")
    starts, lengths = _runs(curve, where)
    count, degree = len(curve.control_points), curve.degree
    if not curve.closed:
        ends = (starts == 0) | (starts + lengths == count)
        if ends.any():
            raise ValueError(
                f"control point {where[ends][0]} is an end of the curve: choose one between the ends"
            )
    starts, first = np.unique(starts, return_index=True)
    lengths = lengths[first]
    more = np.maximum(degree - lengths, 0)
    at = np.repeat(starts + 1, more)
    points = np.insert(
        curve.control_points, at, np.repeat(curve.control_points[starts], more, axis=0), axis=0
    )
    lambdas = np.insert(curve.lambdas, at, np.repeat(curve.lambdas[starts], more))
    # A quadratic's λ at the legs belong to the edges before and after the point, a cubic's to the point.
    begins = starts + np.cumsum(more) - more
    lasts = begins + lengths + more - 1
    legs = np.concatenate((begins, lasts + 1)) if degree == 2 else _spread(begins, lasts)
    legs %= len(points)
    lambdas[legs] = np.clip(lambdas[legs], *_LEGS[degree])
    return curve.with_(control_points=points, lambdas=lambdas)


def smooth(curve: Curve, indices: ArrayLike) -> Curve:
    """Return the curve with repeated control points there only once, so that the corners go.

    Parameters
    ----------
    curve : Curve
    indices : int or array_like of int

    Raises
    ------
    ValueError
        If there is no such control point, or fewer would stay than the curve needs.
    """
    count = len(curve.control_points)
    starts, lengths = _runs(curve, clean_indices(indices, count, "control point"))
    repeats = distinct(_spread(starts + 1, starts + lengths - 1) % count)
    check_count(count - len(repeats), curve.degree, curve.closed, curve.ends)
    return curve.with_(
        control_points=np.delete(curve.control_points, repeats, axis=0),
        lambdas=np.delete(curve.lambdas, repeats),
    )


def kept_places(old: Curve, new: Curve, indices: ArrayLike) -> Indices:
    """Return the control points that lie, after `corner` or `smooth`, where some lay before; all repeats, ascending.

    Parameters
    ----------
    old, new : Curve
        Before and after.
    indices : int or array_like of int
        Control points of the old curve.
    """
    before, after = (np.cumsum(moves_on(curve.control_points)) - 1 for curve in (old, new))
    fewer = before[-1] - after[-1]  # over the seam the first run goes
    runs = (before[clean_indices(indices, len(before), "control point")] - fewer) % (after[-1] + 1)
    starts, lengths = _runs(new, np.searchsorted(after, runs))
    return distinct(_spread(starts, starts + lengths - 1) % len(after))


def _runs(curve: Curve, indices: Indices) -> tuple[Indices, Indices]:
    """Return where the equal control points around each of some begin, and how many there are."""
    count = len(curve.control_points)
    begins = np.flatnonzero(moves_on(curve.control_points))
    lengths = np.diff(np.append(begins, count))
    run = np.searchsorted(begins, indices, side="right") - 1
    starts, sizes = begins[run], lengths[run]
    if curve.closed and len(begins) > 1 and (curve.control_points[0] == curve.control_points[-1]).all():
        # The first run and the last are one, over the seam.
        over = (run == 0) | (run == len(begins) - 1)
        starts, sizes = np.where(over, begins[-1], starts), np.where(over, lengths[0] + lengths[-1], sizes)
    return starts, sizes


def _spread(first: Indices, last: Indices) -> Indices:
    """Return all indices from each first one to its last one."""
    counts = last - first + 1
    return np.repeat(first - (np.cumsum(counts) - counts), counts) + np.arange(counts.sum())
