"""The points of a curve nearest to given ones, and its exact bounds."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline import bernstein, joints
from theditor.spline.basis import Floats
from theditor.spline.curve import Curve
from theditor.spline.extent import extent
from theditor.spline.parameters import check_accuracy
from theditor.spline.roots import sign_changes
from theditor.spline.turns import grain, speed_scale

_STEPS = 50  # of Newton's method
_CLOSE = 4e-16  # steps of t that are none
_BLOCK = 256  # segments at a time: the best found in one rules out most of the next


def nearest(
    curve: Curve, points: ArrayLike, accuracy: float = 1e-12, near: ArrayLike | None = None
) -> tuple[Floats, Floats]:
    """Return the point of the curve nearest to each given one: the global minimum, on any curve.

    Segments whose box is farther than a point already found are left out; on the others every local minimum
    is isolated.

    Parameters
    ----------
    curve : Curve
    points : array_like, shape (d,) or (..., d)
        One point or many.
    accuracy : float
        By how much the distance may exceed the least one, relative to the largest |coordinate| of the curve
        and the point.
    near : array_like, shape (...), optional
        Parameters of points on the curve near the given ones, which save time and change no result.

    Returns
    -------
    u : ndarray, shape (...); for one point a number
        The parameter; of several equally near, any one. On a closed curve less than segment_count.
    distance : ndarray, likewise

    Raises
    ------
    ValueError
        If a point has not one finite number for each coordinate, or `accuracy` is not a positive number.
    """
    check_accuracy(accuracy)
    targets = np.asarray(points, dtype=np.float64)
    if targets.shape[-1:] != (curve.dimension,) or not np.isfinite(targets).all():
        raise ValueError(f"each point needs {curve.dimension} finite coordinates")
    starts = [None] * (targets.size // curve.dimension) if near is None else np.ravel(near).tolist()
    found = [
        _nearest(curve, target, accuracy, start)
        for target, start in zip(targets.reshape(-1, curve.dimension), starts, strict=True)
    ]
    u, distance = np.array(found, dtype=np.float64).reshape(-1, 2).T.reshape(2, *targets.shape[:-1])
    return u, distance


def bounds(curve: Curve, accuracy: float = 1e-12) -> tuple[Floats, Floats]:
    """Return the least and the greatest value of each coordinate along the curve.

    Parameters
    ----------
    curve : Curve
    accuracy : float
        How far within the true box the result may stay, relative to its largest side. It is never outside,
        but for rounding.

    Returns
    -------
    low, high : ndarray, shape (d,)

    Raises
    ------
    ValueError
        If `accuracy` is not a positive number.
    """
    check_accuracy(accuracy)
    meetings = curve(np.arange(curve.segment_count + 1))
    low, high = extent(meetings)
    box_low, box_high = curve.boxes
    for axis in range(curve.dimension):
        slack = accuracy * float((high - low).max())
        beyond = (box_low[axis] < low[axis] - slack) | (box_high[axis] > high[axis] + slack)
        segments = joints.take_segments(curve, np.flatnonzero(beyond))
        slopes = bernstein.polynomials(segments, curve.degree, 1)[axis]
        found = sign_changes(slopes, grain(segments), accuracy)
        extremes = joints.evaluate(segments.take(found.row), found.t, curve.degree, 0)[axis]
        low[axis] = extremes.min(initial=low[axis])
        high[axis] = extremes.max(initial=high[axis])
    return low, high


def _nearest(curve: Curve, target: Floats, accuracy: float, start: float | None) -> tuple[float, float]:
    """Return the parameter of the point nearest to one target, and its distance."""
    size = max(float(np.abs(curve.control_points).max()), float(np.abs(target).max()))
    low, high = curve.boxes
    gap = np.maximum(np.maximum(low - target[:, None], target[:, None] - high), 0)
    least = np.sqrt(np.einsum("dk,dk->k", gap, gap))
    # A point that is near, or one of the segment that looks nearest, leaves a few candidates, to be sorted.
    u = int(np.argmin(least)) + 0.5 if start is None else start
    best = float(np.linalg.norm(curve(u) - target))
    candidates = np.flatnonzero(least <= best)
    candidates = candidates[np.argsort(least[candidates], kind="stable")]
    for first in range(0, len(candidates), _BLOCK):
        block = candidates[first : first + _BLOCK]
        block = block[least[block] < best - accuracy * size]
        if not len(block):
            break
        t, distances, rows = _local_minima(curve, block, target, best)
        if len(rows) and distances.min() < best:
            nearer = int(np.argmin(distances))
            best, u = float(distances[nearer]), float(block[rows[nearer]] + t[nearer])
    return (0.0 if curve.closed and u == curve.segment_count else u), best


def _local_minima(
    curve: Curve, block: NDArray[np.intp], target: Floats, best: float
) -> tuple[Floats, Floats, NDArray[np.intp]]:
    """Return t, distance and row of all points of some segments that may be nearest, and nearer than `best`."""
    segments = joints.take_segments(curve, block)
    rounding = grain(segments)
    segments = segments._replace(start=segments.start - target[:, None], end=segments.end - target[:, None])
    offset = bernstein.polynomials(segments, curve.degree)
    square = np.sum([bernstein.product(x, x) for x in offset], axis=0)
    rows = np.flatnonzero(square.min(axis=1) <= best**2)
    segments, offset = segments.take(rows), offset[:, rows]
    velocity = bernstein.polynomials(segments, curve.degree, 1)
    slope = np.sum([bernstein.product(x, v) for x, v in zip(offset, velocity, strict=True)], axis=0)
    noise = 4e-15 * np.abs(offset).max(axis=(0, 2)) * speed_scale(segments)
    found = sign_changes(slope, noise, 1e-12)
    inner = found.row[found.rising]
    every = np.arange(len(rows))
    at = np.concatenate((inner, every, every))
    t = np.concatenate((found.t[found.rising], np.zeros(len(rows)), np.ones(len(rows))))
    t = _approached(segments.take(at), t, curve.degree, rounding[rows[at]])
    apart = joints.evaluate(segments.take(at), t, curve.degree, 0)
    return t, np.linalg.norm(apart, axis=0), rows[at]


def _approached(segments: joints.Segments, t: Floats, degree: int, noise: Floats) -> Floats:
    """Return parameters at which the segments come as near to the origin as they do around t.

    Near a cusp the polynomials know a minimum to some 1e-5 only; Newton's method, with factors computed
    apart, gets there in a few dozen steps.
    """
    for _ in range(_STEPS):
        offset, velocity, bend = (joints.evaluate(segments, t, degree, nu) for nu in range(3))
        slope = np.einsum("dk,dk->k", offset, velocity)
        steep = np.einsum("dk,dk->k", velocity, velocity) + np.einsum("dk,dk->k", offset, bend)
        new = np.clip(t - np.divide(slope, steep, out=np.zeros_like(t), where=steep > 0), 0, 1)
        moved = joints.evaluate(segments, new, degree, 0)
        # At a minimum distances tell little of t, so they may grow by their rounding.
        new = np.where(np.linalg.norm(moved, axis=0) <= np.linalg.norm(offset, axis=0) + noise, new, t)
        if np.all(np.abs(new - t) <= _CLOSE):
            return new
        t = new
    return t
