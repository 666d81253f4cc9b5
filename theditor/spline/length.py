"""Arc length, and its inverse."""

from functools import reduce

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline.basis import Floats
from theditor.spline.curve import Curve
from theditor.spline.parameters import check_accuracy, clean_interval, clean_parameters
from theditor.spline.quadrature import Derivatives, integrals, pieces

_STEPS = 60  # of the bracketed Newton method


def arc_length(
    curve: Curve, u0: float | None = None, u1: float | None = None, accuracy: float = 1e-9
) -> float:
    """Return the length of the curve between two parameters, whatever cusps lie there.

    Parameters
    ----------
    curve : Curve
    u0, u1 : float, optional
        From where to where, u0 ≤ u1; the whole domain by default.
    accuracy : float
        Largest error, relative to the length itself; rounding keeps it above 1e-14 or so.

    Raises
    ------
    ValueError
        If a parameter lies outside the domain, u1 is less than u0, or `accuracy` is not a positive number.
    """
    check_accuracy(accuracy)
    return float(_lengths(curve, *pieces(*clean_interval(curve, u0, u1)), accuracy).sum())


def arc_lengths(curve: Curve, u: ArrayLike | None = None, accuracy: float = 1e-9) -> Floats:
    """Return the lengths from the curve's start to many parameters at once.

    Parameters
    ----------
    curve : Curve
    u : array_like, optional
        Parameters in any order; the ends of all segments, 0 … segment_count, by default.
    accuracy : float
        Largest error, relative to each length; rounding keeps it above 1e-14 or so.

    Returns
    -------
    ndarray
        Of the shape of `u`.

    Raises
    ------
    ValueError
        If a parameter lies outside the domain, or `accuracy` is not a positive number.
    """
    check_accuracy(accuracy)
    count = curve.segment_count
    whole = np.concatenate(([0.0], np.cumsum(_lengths(curve, np.arange(count), 0.0, 1.0, accuracy))))
    if u is None:
        return whole
    places = clean_parameters(curve, u)
    segments = np.minimum(places.ravel().astype(np.intp), count - 1)
    part = _lengths(curve, segments, 0.0, places.ravel() - segments, accuracy)
    return (whole[segments] + part).reshape(places.shape)


def parameter_at(curve: Curve, length: ArrayLike, accuracy: float = 1e-9) -> Floats:
    """Return the parameters at which the curve has run through the given lengths.

    Parameters
    ----------
    curve : Curve
    length : array_like
        Lengths along the curve from its start, 0 to its whole length.
    accuracy : float
        How far, along the curve, the points may be off, relative to the whole length.

    Returns
    -------
    ndarray
        Of the shape of `length`. Where the curve stands still there is more than one such parameter; any of
        them is given.

    Raises
    ------
    ValueError
        If a length is negative or greater than the curve's, or `accuracy` is not a positive number.
    """
    check_accuracy(accuracy)
    own = accuracy / 4  # of each integral, so that their errors and the search's together keep within
    whole = arc_lengths(curve, accuracy=own)
    lengths = np.asarray(length, dtype=np.float64)
    # A whole length measured elsewhere, as exactly as this, must not be too long.
    outside = ~((lengths >= 0) & (lengths <= whole[-1] * (1 + 4 * accuracy)))
    if outside.any():
        wrong = float(lengths[outside].flat[0])
        raise ValueError(f"length {wrong} lies outside the curve, which is {float(whole[-1])} long")
    flat = np.minimum(lengths.ravel(), whole[-1])
    segments = np.clip(np.searchsorted(whole, flat, side="right") - 1, 0, curve.segment_count - 1)
    goal, extent = flat - whole[segments], np.diff(whole)[segments]
    t = np.divide(goal, extent, out=np.zeros_like(goal), where=extent > 0)
    low, high = np.zeros_like(t), np.ones_like(t)
    active: NDArray[np.intp] = np.flatnonzero((t > 0) & (t < 1))
    for _ in range(_STEPS):
        here, at = t[active], segments[active]
        miss = _lengths(curve, at, 0.0, here, own) - goal[active]
        open_ = np.abs(miss) > whole[-1] * own
        active, here, miss, at = active[open_], here[open_], miss[open_], at[open_]
        if not len(active):
            break
        late = miss > 0
        high[active[late]], low[active[~late]] = here[late], here[~late]
        speed = np.linalg.norm(curve(at + here, 1), axis=-1)
        with np.errstate(divide="ignore", invalid="ignore"):
            new = here - miss / speed
        wild = ~((new > low[active]) & (new < high[active]))
        new[wild] = ((low + high) / 2)[active][wild]
        t[active] = new
    return np.asarray(segments + t).reshape(lengths.shape)


def _lengths(
    curve: Curve, segments: NDArray[np.intp], start: ArrayLike, end: ArrayLike, accuracy: float
) -> Floats:
    return integrals(curve, segments, start, end, _speed, accuracy, bounded=True)


def _speed(derivatives: Derivatives) -> Floats:
    return np.asarray(reduce(np.hypot, derivatives(1)))  # no square under- or overflows
