"""Control points spread anew where many come in or go, all of them refitted together."""

from collections.abc import Callable
from typing import Final

import numpy as np
from numpy.typing import NDArray

from theditor.spline.basis import Floats
from theditor.spline.curve import Curve
from theditor.spline.deviation import deviation
from theditor.spline.refit import refitted

AROUND: Final = 3
"""Control points that are refitted on either side of a place."""
PER_SEGMENT: Final = 16
"""Samples of the old shape."""
WORTH: Final = 0.5
"""λ of their own must bring the change of shape down to this part of it."""
_STILL: Final = 1e-9


def respread(
    curve: Curve,
    places: Floats,
    lambdas: Floats,
    fresh: NDArray[np.bool_],
    progress: Callable[[float], None] | None = None,
) -> tuple[Curve, float]:
    """Return a curve with other control points whose shape is as near as can be, and the deviation.

    Parameters
    ----------
    curve : Curve
    places : ndarray, shape (n,)
        Where along the old polygon the new control points lie, by the index of the old ones: whole numbers for
        those that stay. Ascending.
    lambdas : ndarray, shape (n,)
    fresh : ndarray of bool, shape (n,)
        Which of them are new; their λ may change, if that at least halves the change of shape.
    progress : callable, optional
        Told now and then about which share of the work is done, 0 to 1; what it raises ends the work.
    """
    count, n, first = len(curve.control_points), len(places), curve.first_segment
    even = _evened(places, count, curve.closed)
    # Where the step from one to the next is no longer 1, those around move.
    steps = np.diff(places, append=places[0] + count if curve.closed else places[-1] + 1)
    gaps = np.flatnonzero(np.abs(steps - 1) > _STILL)[:, None] + np.arange(1 - AROUND, AROUND + 1)
    moves = np.zeros(n, dtype=np.bool_)
    moves[gaps % n if curve.closed else gaps.clip(0, n - 1)] = True
    if not curve.closed and curve.ends == "clamped":
        moves[[0, -1]] = False
    free = np.flatnonzero(moves)
    around = np.arange(-AROUND - 1, count + AROUND + 2)
    polygon = curve.control_points[around % count]
    points = np.stack([np.interp(np.where(moves, even, places), around, x) for x in polygon.T], axis=1)
    start = curve.with_(control_points=points, lambdas=lambdas)

    # A quadratic's segment has its control point in its middle.
    old, new, shift = curve.segment_count, start.segment_count, first - (curve.degree == 2) / 2
    met = np.arange(old + 1.0)
    index = np.arange(n)
    if curve.closed:
        even, index = (
            np.concatenate((even - count, even, even + count)),
            np.concatenate((index - n, index, index + n)),
        )
    meets = np.interp(met + shift, even, index) - shift
    if not curve.closed:
        meets[[0, -1]] = 0, new
        meets = np.clip(meets, 0, new)
    shaped = np.zeros(new, dtype=np.bool_)
    for step in range(1 - curve.degree, 2):
        segments = free - first + step
        shaped[segments % new if curve.closed else segments[(segments >= 0) & (segments < new)]] = True
    u = np.arange(PER_SEGMENT * old + 1) / PER_SEGMENT
    v = np.interp(u, met, meets)
    near = shaped[np.minimum(np.floor(v % new if curve.closed else v).astype(np.intp), new - 1)]
    u, v = u[near], v[near]
    held = np.zeros(len(u), dtype=np.bool_) if curve.closed else (u == 0) | (u == old)
    targets = curve(u % old if curve.closed else u)

    def half(begin: float) -> Callable[[float], None]:
        return lambda share: progress(begin + share / 2) if progress is not None else None

    fitted, v = refitted(start, targets, v, free, held=held, progress=half(0.0))
    best = fitted, deviation(curve, fitted, met, meets)
    bent = np.flatnonzero(fresh & start.active_lambdas)
    if len(bent):
        fitted, _ = refitted(fitted, targets, v, free, bent, held, progress=half(0.5))
        apart = deviation(curve, fitted, met, meets)
        if apart <= WORTH * best[1]:
            best = fitted, apart
    return best


def _evened(places: Floats, count: int, closed: bool) -> Floats:
    """Return places with the steps between them evened out: each the mean of those around it."""
    if closed:
        before, after = places[-AROUND:] - count, places[:AROUND] + count
    else:
        before = 2 * places[0] - places[AROUND:0:-1]
        after = 2 * places[-1] - places[-2 : -2 - AROUND : -1]
    width = 2 * AROUND + 1
    even: Floats = np.convolve(
        np.concatenate((before, places, after)), np.full(width, 1 / width), mode="valid"
    )
    return even
