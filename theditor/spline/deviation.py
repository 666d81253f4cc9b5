"""How far two curves lie apart as shapes, whatever their parameters."""

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from theditor.spline.basis import Floats
from theditor.spline.curve import Curve
from theditor.spline.geometry import nearest
from theditor.spline.refit import feet

_PER_SEGMENT: Final = 32
_REACH: Final = 3.0  # segments on either side of where a foot is expected
_BLOCK: Final = 4096  # points at a time
_ROUNDING: Final = 1e-14


def deviation(a: Curve, b: Curve, u: ArrayLike, v: ArrayLike, both: bool = True) -> float:
    """Return the largest distance between corresponding parts of two curves.

    Each of 32 points a segment, and both ends, is measured to the nearest point of the whole other curve, so
    the result is the Hausdorff distance between them but for what lies between these points.

    Parameters
    ----------
    a, b : Curve
    u, v : array_like, shape (k,)
        Ascending parameters of a, and those of b that correspond to them more or less: from the first to the
        last is the part that counts. Those of a closed curve may run over its seam.
    both : bool
        Whether the points of b count as well as those of a.
    """
    u, v = np.asarray(u, dtype=np.float64), np.asarray(v, dtype=np.float64)
    along = _even(u)
    found = farthest(a(_round(a, along)), b, np.interp(along, u, v))
    if both:
        along = _even(v)
        found = max(found, farthest(b(_round(b, along)), a, np.interp(along, v, u)))
    return found


def farthest(points: Floats, curve: Curve, u: Floats) -> float:
    """Return the largest of the distances of points to a curve.

    Parameters
    ----------
    points : ndarray, shape (n, d)
    curve : Curve
    u : ndarray, shape (n,)
        About where on the curve their feet are to be expected, which saves time and changes no result.
    """
    distances = np.concatenate(
        [
            _near(points[i : i + _BLOCK], curve, u[i : i + _BLOCK])
            for i in range(0, max(len(points), 1), _BLOCK)
        ]
    )
    # These feet are local: only where the largest is confirmed by the global minimum is it the answer.
    while True:
        worst = int(np.argmax(distances))
        if distances[worst] <= _ROUNDING * float(np.abs(curve.control_points).max()):
            return float(distances[worst])
        true = float(nearest(curve, points[worst])[1])
        if true >= distances[worst] * (1 - 1e-9):
            return true
        distances[worst] = true


def _near(points: Floats, curve: Curve, u: Floats) -> Floats:
    """Return the distances of points to local feet on a curve."""
    around = u[:, None] + np.arange(-_REACH, _REACH + 0.1, 0.125)
    places = _round(curve, around)
    gaps = curve(places) - points[:, None]
    squares = np.einsum("nkd,nkd->nk", gaps, gaps)
    best = np.take_along_axis(places, squares.argmin(axis=1)[:, None], axis=1)[:, 0]
    foot = feet(curve, points, best, 6)
    distances: Floats = np.linalg.norm(curve(_round(curve, foot)) - points, axis=1)
    return distances


def _even(u: Floats) -> Floats:
    return np.linspace(u[0], u[-1], int(np.ceil(_PER_SEGMENT * (u[-1] - u[0]))) + 1)


def _round(curve: Curve, u: Floats) -> Floats:
    """Return parameters within the domain: counted round, or the nearest end."""
    return np.mod(u, curve.segment_count) if curve.closed else np.clip(u, 0, curve.segment_count)
