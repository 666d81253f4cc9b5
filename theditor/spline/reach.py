"""Where λ can take a curve: the straight tracks of its points, and the band that two segments sweep."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline.basis import INTERPOLATING, Floats
from theditor.spline.checks import clean_indices
from theditor.spline.curve import Curve
from theditor.spline.sampling import evaluate_segments
from theditor.spline.shape import PULL_BOUNDS, clean_bounds, clean_target, locate, motion


class Track(NamedTuple):
    """The straight line on which a point of the curve slides as λ varies."""

    origin: Floats  # (d,) where it is at λ = 0
    direction: Floats  # (d,) how far it moves for a unit of λ; 0 where λ does not move it
    current: float  # λ as it is

    def position(self, lam: ArrayLike) -> Floats:
        """Return where the point is at these λ: (...) gives (..., d)."""
        return self.origin + np.multiply.outer(np.asarray(lam, dtype=np.float64), self.direction)

    def parameter_nearest(self, target: ArrayLike, bounds: tuple[float, float] = PULL_BOUNDS) -> float:
        """Return the λ within the bounds that brings the point closest to a target, (d,).

        The current λ where it does not move the point at all. As for `pull`, a current λ outside the bounds
        may stay where it is.

        Raises
        ------
        ValueError
            If the target is not a point of the curve's dimension, or `bounds` makes no sense.
        """
        goal = clean_target(len(self.origin), target)
        low, high = clean_bounds(bounds)
        length = float(np.linalg.norm(self.direction))
        if length == 0:
            return self.current
        nearest = float((goal - self.origin) @ (self.direction / length)) / length
        return min(max(nearest, min(low, self.current)), max(high, self.current))


def joint_track(curve: Curve, point: int) -> Track:
    """Return the track of a cubic's joint: through control point i, along the second difference there.

    Raises
    ------
    ValueError
        If the curve is quadratic, or there is no control point `point` with an active λ.
    """
    if curve.degree == 2:
        raise ValueError("a quadratic's joints do not move with λ: take the track of a segment's middle")
    index = _active(curve, point)
    u = (index - curve.first_segment) % len(curve.control_points)
    return _track(curve, *locate(curve, u), float(curve.lambdas[index]))


def middle_track(curve: Curve, segment: int) -> Track:
    """Return the track of a segment's middle, t = ½, as its λ at both ends take the same value.

    The current λ is the mean of the two. If they differ, the middle itself may lie beside the track.

    Raises
    ------
    ValueError
        If there is no such segment.
    """
    lambdas = [curve.lambdas[i] for i in curve.lambda_indices(segment) if i is not None]
    return _track(curve, segment, 0.5, float(np.mean(lambdas)) if lambdas else 0.0)


class Reach(NamedTuple):
    """All that the segments shaped by one λ cover as it runs over a range; the other λ stay.

    Each array of points, (k, intervals + 1, d), has the segments at equal steps of t. A point slides straight
    from `low` to `high`, so the quadrangles between them cover the band, but for the curve's sagitta
    between two samples.
    """

    segments: NDArray[np.intp]  # (k,) one at the end of an open curve, else two in order
    low: Floats  # with λ at the lower bound
    high: Floats
    trigonometric: Floats  # with λ = 0
    hyperbolic: Floats  # with λ = 1
    interpolating: Floats  # with λ = λ*

    @property
    def quads(self) -> Floats:
        """The quadrangles that cover the band, (k, intervals, 4, d).

        They are convex or flat, and in the plane none runs clockwise: one path of them all, filled by the
        winding rule, shows their union even where the band folds over itself.
        """
        low, high = self.low, self.high
        quads = np.stack((low[:, :-1], low[:, 1:], high[:, 1:], high[:, :-1]), axis=2)
        if quads.shape[-1] == 2:
            one, other = quads[..., 2, :] - quads[..., 0, :], quads[..., 3, :] - quads[..., 1, :]
            clockwise = one[..., 0] * other[..., 1] < one[..., 1] * other[..., 0]
            quads[clockwise] = quads[clockwise][:, ::-1]
        return quads


def reach(curve: Curve, point: int, bounds: tuple[float, float] = PULL_BOUNDS, intervals: int = 32) -> Reach:
    """Return what the one or two segments shaped by the λ of a control point can cover.

    Parameters
    ----------
    curve : Curve
    point : int
        A control point with an active λ.
    bounds : (float, float)
        The range of λ, at most `MAX_LAMBDA` in size.
    intervals : int
        Steps of t in each segment, at least 1.

    Raises
    ------
    ValueError
        If there is no control point `point` with an active λ, or `bounds` or `intervals` makes no sense.
    """
    index = _active(curve, point)
    low, high = clean_bounds(bounds)
    segments = index - curve.first_segment + np.array([-1, 0])
    if curve.closed:
        segments %= curve.segment_count
    segments = segments[(segments >= 0) & (segments < curve.segment_count)]
    at_0, at_1 = (evaluate_segments(curve.with_lambdas(index, lam), segments, intervals) for lam in (0, 1))

    def at(lam: float) -> Floats:
        return at_0 + lam * (at_1 - at_0)

    return Reach(segments, at(low), at(high), at_0, at_1, at(INTERPOLATING[curve.degree]))


def _track(curve: Curve, segment: int, t: float, current: float) -> Track:
    origin, columns = motion(curve, segment, t)
    return Track(origin, columns.sum(axis=1), current)


def _active(curve: Curve, point: int) -> int:
    """Return the index of a control point whose λ is active, or refuse it."""
    (index,) = clean_indices(point, len(curve.control_points), "control point").tolist()
    if not curve.active_lambdas[index]:
        active = np.flatnonzero(curve.active_lambdas)
        cure = f"choose one from {active[0]} to {active[-1]}" if len(active) else "a straight line has none"
        raise ValueError(f"the λ of control point {index} does not shape the curve: {cure}")
    return int(index)
