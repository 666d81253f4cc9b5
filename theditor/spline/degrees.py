"""From quadratic to cubic and back, with the shape kept as well as it can be."""

from collections.abc import Callable
from typing import Final

import numpy as np

from theditor.spline.basis import Floats, check_degree
from theditor.spline.checks import fewest_points
from theditor.spline.curve import Curve
from theditor.spline.deviation import deviation
from theditor.spline.points import Edited
from theditor.spline.refit import refitted

_FREE: Final = 500  # control points refitted at a time: the cost stays proportional to their number
_SHARED: Final = 24  # of them, that are refitted with the next ones once more
# Steps of the least squares, and the gain of one below which the next is not worth its time.
_CARE: Final = 12, 1e-4
_HASTE: Final = 5, 0.02  # the same for a long curve, which takes a while
_END: Final = 6  # segments in which the curves come to correspond from their ends on
_MARGIN: Final = 8  # control points on either side that have a say in what these shape
_WORTH: Final = 1.25  # times the deviation may be what it is, if the curve ends in its old direction
_SHARE: Final = 0.6  # of the work that is refitting; the rest is measuring how well it went
_PER_SEGMENT: Final = 10  # samples of the old shape


def with_degree(curve: Curve, degree: int, progress: Callable[[float], None] | None = None) -> Edited:
    """Return the curve in another degree, all its control points refitted to change the shape least.

    Their number stays, unless the degree needs more; so do the ends and, but for interpolating values, which
    become those of the new degree, λ.

    Parameters
    ----------
    curve : Curve
    degree : {2, 3}
    progress : callable, optional
        Told now and then which share of the work is done, 0 to 1; what it raises ends the work.

    Raises
    ------
    ValueError
        If `degree` is not 2 or 3.
    """
    check_degree(degree)
    if degree == curve.degree:
        return Edited(curve, 0.0)
    start = _start(curve, degree)
    old, new = curve.segment_count, start.segment_count
    # A quadratic's segment lies around the point that a cubic's begins at, but for open ends.
    if curve.closed:
        shift = 0.5 if degree == 2 else -0.5
        met, meets = [0.0, old], [shift, new + shift]
    else:
        end, shift = min(_END, old / 2), (new - old) / 2
        met, meets = [0.0, end, old - end, old], [0.0, end + shift, old - end + shift, new]
    u = np.arange(_PER_SEGMENT * old + (not curve.closed)) / _PER_SEGMENT
    v = np.interp(u, met, meets)

    def attempt(ends: int) -> Edited:
        fitted = _fitted(start, curve(u), v, ends, progress)
        return Edited(fitted, deviation(curve, fitted, met, meets))

    edited = attempt(1)
    if not curve.closed and _is_short(start):
        # With only the ends held, the curve may come to them from the wrong side.
        directed = attempt(2)
        if directed.deviation <= _WORTH * edited.deviation:
            return directed
    return edited


def _fitted(
    curve: Curve, targets: Floats, u: Floats, ends: int, progress: Callable[[float], None] | None
) -> Curve:
    """Return a curve brought near to targets, (n, d), about at ascending u, (n,), part after part.

    Of an open curve so many targets at either end are met just where they are to be.
    """
    count, n = len(curve.control_points), len(u)
    kept = int(not curve.closed and curve.ends == "clamped")
    low, end = kept, count - kept
    whole = curve.closed and _is_short(curve)
    if curve.closed and not whole:
        end += _SHARED  # over the seam
    held = np.zeros(n, dtype=np.bool_)
    if not curve.closed:
        held[:ends] = held[-ends:] = True
    points, where = curve.control_points.copy(), u.copy()
    steps, enough = _CARE if _is_short(curve) else _HASTE
    while low < end:
        if progress is not None:
            progress(_SHARE * low / end)
        high = end if whole else min(low + _FREE, end)
        around = np.arange(count) if whole else np.arange(low - _MARGIN, high + _MARGIN)
        # The targets on segments that the free points shape, and on one more on either side.
        reach = np.array([low - curve.degree, high + 2]) - curve.first_segment
        turns, rest = np.divmod(reach - u[0], curve.segment_count)
        met = np.arange(*np.searchsorted(u - u[0], rest) + turns.astype(np.intp) * n)
        if whole:
            met = np.arange(n)
        elif not curve.closed:
            around, met = around[(around >= 0) & (around < count)], met[(met >= 0) & (met < n)]
        turn, met = np.divmod(met, n)
        part = curve.with_(
            control_points=points[around % count], lambdas=curve.lambdas[around % count], closed=whole
        )
        origin = around[0] + part.first_segment - curve.first_segment - turn * curve.segment_count
        free = np.arange(low, high)
        part, found = refitted(
            part,
            targets[met],
            where[met] - origin,
            free - around[0],
            held=held[met],
            steps=steps,
            enough=enough,
        )
        points[free % count], where[met] = part.control_points[free - around[0]], found + origin
        low = end if high == end else high - _SHARED
    return curve.with_(control_points=points)


def _is_short(curve: Curve) -> bool:
    """Whether all its control points are refitted at once."""
    return len(curve.control_points) < _FREE + 2 * _MARGIN


def _start(curve: Curve, degree: int) -> Curve:
    """Return the curve with the new degree, its control points those of the old one or spread over its polygon."""
    count = len(curve.control_points)
    least = fewest_points(degree, curve.closed, curve.ends) + (degree == 3 and curve.ends == "clamped")
    if count >= least:
        return curve.with_(degree=degree)
    places, old = np.linspace(0, count - 1, least), np.arange(count)
    points = np.stack([np.interp(places, old, x) for x in curve.control_points.T], axis=1)
    lambdas = np.interp(places, old, curve.lambdas)
    return Curve(points, lambdas, degree, curve.closed, curve.ends)
