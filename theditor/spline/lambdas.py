"""Many λ at once: a gradient, smoothing, a common shift."""

from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline.checks import clean_indices
from theditor.spline.curve import Curve
from theditor.spline.distinct import distinct

_STEPS: Final = 4


def gradient(curve: Curve, indices: ArrayLike, first: float, last: float) -> Curve:
    """Return the curve with λ running evenly from one value to another over some control points.

    Evenly in the control point's index, which is to say in the curve's own parameter u. The first of them
    gets `first`, the last of them `last`; a single one gets `last`. Inactive λ stay.

    Parameters
    ----------
    curve : Curve
    indices : int or array_like of int
        Which control points, in any order.
    first, last : float
        λ at the lowest and at the highest of the indices whose λ is active.

    Raises
    ------
    ValueError
        If there is no such control point, or a λ is not acceptable.
    """
    where = _active(curve, indices)
    if not len(where):
        return curve
    return curve.with_lambdas(where, np.interp(where, where[[0, -1]], (first, last)))


def smoothed(curve: Curve, indices: ArrayLike, strength: float = 1.0) -> Curve:
    """Return the curve with some λ drawn towards their neighbours', a few steps of Laplacian smoothing.

    Each step moves a λ by strength/4 of the second difference there, so that full strength wipes out a zigzag
    and no λ leaves the range of those around it. Neighbours count round a closed curve; the first and the
    last active λ of an open one stay, and so does every λ not among the indices.

    Parameters
    ----------
    curve : Curve
    indices : int or array_like of int
        Which control points, in any order.
    strength : float
        From 0, no change, to 1.

    Raises
    ------
    ValueError
        If there is no such control point, or `strength` is not from 0 to 1.
    """
    if not 0 <= strength <= 1:
        raise ValueError(f"strength must be from 0 to 1, not {strength!r}")
    where = _active(curve, indices)
    count = len(curve.control_points)
    if not curve.closed:
        inner = curve.active_lambdas[where - 1] & curve.active_lambdas[(where + 1) % count]
        where = where[inner & (where > 0) & (where < count - 1)]
    lambdas = curve.lambdas.copy()
    for _ in range(_STEPS):
        before, after = lambdas[where - 1], lambdas[(where + 1) % count]
        lambdas[where] += strength / 4 * (before - 2 * lambdas[where] + after)
    return curve.with_lambdas(where, lambdas[where])


def shifted(curve: Curve, indices: ArrayLike, delta: float) -> Curve:
    """Return the curve with the same number added to some λ, so that their differences stay.

    Raises
    ------
    ValueError
        If there is no such control point, or a λ would become too large.
    """
    where = clean_indices(indices, len(curve.control_points), "control point")
    return curve.with_lambdas(where, curve.lambdas[where] + delta)


def _active(curve: Curve, indices: ArrayLike) -> NDArray[np.intp]:
    """Return those of the indices whose λ is active, each once, ascending."""
    where = distinct(clean_indices(indices, len(curve.control_points), "control point"))
    return where[curve.active_lambdas[where]]
