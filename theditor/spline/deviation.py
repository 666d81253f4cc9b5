"""How far two curves lie apart as shapes, whatever their parameters."""

from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline.basis import Floats
from theditor.spline.curve import Curve
from theditor.spline.geometry import nearest
from theditor.spline.joints import take_segments
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
    changed = _changed(a, b, u, v)
    along = _even(u) if changed is None else _in_segments(u[0] + changed)
    found = farthest(a(_round(a, along)), b, np.interp(along, u, v))
    if both:
        along = _even(v) if changed is None else _in_segments(v[0] + changed)
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
    # No point is farther than from where it is expected: those that can be farthest come first.
    most = np.linalg.norm(curve(_round(curve, u)) - points, axis=1)
    order = np.argsort(-most)
    nothing = _ROUNDING * float(np.abs(curve.control_points).max())
    found = 0.0
    for i in range(0, len(order), _BLOCK):
        block = order[i : i + _BLOCK]
        if most[block[0]] <= max(found, nothing):
            return max(found, float(most[block[0]])) if most[block[0]] <= nothing else found
        distances = np.minimum(_near(points[block], curve, u[block]), most[block])
        # These feet are local: only where the largest is confirmed by the global minimum is it the answer.
        while distances[worst := int(np.argmax(distances))] > max(found, nothing):
            true = float(nearest(curve, points[block[worst]])[1])
            if true >= distances[worst] * (1 - 1e-9):
                found = true
                break
            distances[worst] = true
        else:
            found = max(found, float(distances[worst]))
    return found


def _changed(a: Curve, b: Curve, u: Floats, v: Floats) -> NDArray[np.intp] | None:
    """Return which segments of a, from u on, differ from those of b, from v on; None if they do not correspond."""
    first, last = np.array([u[0], v[0]]), np.array([u[-1], v[-1]])
    even = len(u) == len(v) == 2 and (first == np.floor(first)).all() and np.ptp(last - first) == 0
    if not even or a.degree != b.degree or u[1] - u[0] != np.floor(u[1] - u[0]):
        return None
    steps = np.arange(int(u[1] - u[0]))
    same = np.ones(len(steps), dtype=np.bool_)
    parts = (
        take_segments(curve, (int(start) + steps) % curve.segment_count)
        for curve, start in ((a, u[0]), (b, v[0]))
    )
    for one, other in zip(*parts, strict=True):
        same &= (one == other).all(axis=0) if one.ndim == 2 else one == other
    return np.flatnonzero(~same)


def _in_segments(starts: Floats) -> Floats:
    """Return parameters at even steps in segments, both their ends included."""
    return np.asarray((starts[:, None] + np.linspace(0, 1, _PER_SEGMENT + 1)).ravel())


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
