"""From quadratic to cubic and back, with the shape kept as well as it can be."""

from typing import Final

import numpy as np

from theditor.spline.basis import check_degree
from theditor.spline.checks import fewest_points
from theditor.spline.curve import Curve
from theditor.spline.deviation import deviation
from theditor.spline.points import Edited
from theditor.spline.refit import refitted

_FREE: Final = 500  # control points refitted at a time: the cost stays proportional to their number
_SHARED: Final = 24  # of them, that are refitted with the next ones once more
_PER_SEGMENT: Final = 10  # samples of the old shape


def with_degree(curve: Curve, degree: int) -> Edited:
    """Return the curve in another degree, all its control points refitted to change the shape least.

    Their number stays, unless the degree needs more; so do the ends and, but for interpolating values, which
    become those of the new degree, λ.

    Raises
    ------
    ValueError
        If `degree` is not 2 or 3.
    """
    check_degree(degree)
    if degree == curve.degree:
        return Edited(curve, 0.0)
    start = _start(curve, degree)
    count, old, new = len(start.control_points), curve.segment_count, start.segment_count
    # On a closed curve a quadratic's segment lies around the point that a cubic's begins at.
    shift = (0.5 if degree == 2 else -0.5) if curve.closed else 0.0
    u = np.linspace(0, old, _PER_SEGMENT * old + 1)
    v = u * new / old + shift
    held = np.zeros(len(u), dtype=np.bool_)
    if not curve.closed:
        held[[0, -1]] = True
    targets, result = curve(u), start
    kept = int(not curve.closed and curve.ends == "clamped")
    stride = _FREE - _SHARED
    for low in range(kept, max(count - kept - _SHARED, kept + 1), stride):
        free = np.arange(low, min(low + _FREE, count - kept))
        begin, end = low - start.first_segment - degree, free[-1] - start.first_segment + 3
        near = (v >= begin) & (v <= end)
        if curve.closed:
            near |= (v >= begin + new) | (v <= end - new)
        if len(free):
            result, v[near] = refitted(result, targets[near], v[near], free, held=held[near])
    return Edited(result, deviation(curve, result, (0, old), (shift, new + shift)))


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
