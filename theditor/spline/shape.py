"""λ as the unknown: shape parameters, or control points, for a point that the curve is to pass through.

Everything is affine in λ: a point at u moves along one fixed vector for each unit of its segment's λ at the
start, and along another for the one at the end. To pull that point to a target is a linear problem with two
unknowns.
"""

from typing import Final, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline import joints
from theditor.spline.basis import Floats, basis, hyperbolic, trigonometric
from theditor.spline.checks import MAX_COORDINATE, MAX_LAMBDA, clean_indices, clean_values
from theditor.spline.curve import Curve

PULL_BOUNDS: Final = (-16.0, 10.0)
"""The range of λ that a hand may pull over: the convex-hull range, both λ*, and a little more."""

BEND_ROUNDING: Final = 2.0**-49
"""Error of a bend vector, relative to the largest coordinate of the control points."""

_PARALLEL: Final = 1e-16  # of the largest coordinate: columns that span no more are parallel but for rounding
_EQUAL: Final = 1e-13  # misses that differ by less, relative to the largest coordinate, count as equal


class Pulled(NamedTuple):
    """A curve whose point was pulled to a target, and how well that went."""

    curve: Curve
    residual: Floats  # (d,) from the point reached to the target
    at_bound: tuple[int, ...]  # the control points whose λ had a say and is at a bound


class Motion(NamedTuple):
    """Where a point of a curve is when both λ of its segment are 0, and how it moves for a unit of each."""

    origin: Floats  # (d,)
    columns: Floats  # (d, 2): start, end; exactly 0 where a λ has no say, or only by rounding


def pull(
    curve: Curve,
    u: float,
    target: ArrayLike,
    bounds: tuple[float, float] = PULL_BOUNDS,
    which: Literal["both", "nearer"] = "both",
) -> Pulled:
    """Return the curve with the λ of one segment set so that its point at `u` comes to the target.

    The control points stay. Where the two λ move the point in different directions and the solution lies
    within the bounds, the target is met to 1e-12 of the largest coordinate. Otherwise the point comes as
    close as the bounds let it; among λ that serve equally well, to 1e-13 of the largest coordinate, those
    that change least are taken, so that collinear control points make nothing jump. At a joint one λ of a
    cubic has a say, and none of a quadratic; a clamped cubic end has no λ to move.

    Parameters
    ----------
    curve : Curve
    u : float
        Parameter of the point, within the curve's domain.
    target : array_like, shape (d,)
        At most `MAX_COORDINATE` in size.
    bounds : (float, float)
        Lowest and highest λ, at most `MAX_LAMBDA` in size. A λ outside them may stay where it is and move
        towards them.
    which : {"both", "nearer"}
        Move both λ, or only that of the nearer joint (of the other one where a clamped end has none).

    Raises
    ------
    ValueError
        If `u` lies outside the domain, the target is not a point of the curve's dimension, or `bounds` or
        `which` makes no sense.
    """
    segment, t = locate(curve, u)
    point, goal = curve(u), clean_target(curve.dimension, target)
    low, high = clean_bounds(bounds)
    columns = motion(curve, segment, t).columns
    if which == "nearer":
        near = int(t > 0.5)
        columns[:, 1 - near if columns[:, near].any() else near] = 0
    elif which != "both":
        raise ValueError(f'which must be "both" or "nearer", not {which!r}')
    where = (np.arange(2) + segment + curve.first_segment) % len(curve.control_points)
    now = curve.lambdas[where]
    lowest, highest = np.minimum(now, low), np.maximum(now, high)
    size = max(_size(curve, segment), float(np.abs(goal).max())) or 1.0
    step = _least_squares(columns / size, (goal - point) / size, lowest - now, highest - now)
    held = [step <= lowest - now, step >= highest - now]
    effective = columns.any(axis=0)
    pulled = curve.with_lambdas(where[effective], np.select(held, [lowest, highest], now + step)[effective])
    at_bound = where[effective & (held[0] | held[1])]
    return Pulled(pulled, goal - pulled(u), tuple(at_bound.tolist()))


def pull_points(curve: Curve, u: float, target: ArrayLike) -> Curve:
    """Return the curve with the control points of one segment moved so that its point at `u` is the target.

    Of all ways to do so this one moves the control points least: the sum of their squared displacements is
    smallest. The λ stay. The target is met to 1e-15·max(1, |λ|) of the largest coordinate.

    Parameters
    ----------
    curve : Curve
    u : float
        Parameter of the point, within the curve's domain.
    target : array_like, shape (d,)
        At most `MAX_COORDINATE` in size.

    Raises
    ------
    ValueError
        If `u` lies outside the domain, the target is not a point of the curve's dimension, or a control
        point would have to go too far out.
    """
    segment, t = locate(curve, u)
    gap = clean_target(curve.dimension, target) - curve(u)
    indices, matrix = defining_points(curve, segment)
    where = (np.arange(2) + segment + curve.first_segment) % len(curve.control_points)
    # A clamped cubic end has the same points whatever its λ; 0 keeps rounding small.
    start, end = np.where(curve.active_lambdas[where], curve.lambdas[where], 0.0)
    weights = basis(t, start, end, curve.degree) @ matrix
    shift = np.outer(weights / (weights @ weights), gap)
    return curve.with_points(indices, curve.control_points[indices] + shift)


def defining_points(curve: Curve, segment: int) -> tuple[NDArray[np.intp], Floats]:
    """Return the control points that define a segment and what it makes of them.

    Returns
    -------
    indices : ndarray of int, shape (k,)
        The control points, each once.
    matrix : ndarray, shape (degree + 1, k)
        Times these control points it gives the points that the basis functions weigh, with the reflected
        point at a clamped end.

    Raises
    ------
    ValueError
        If there is no such segment.
    """
    (index,) = clean_indices(segment, curve.segment_count, "segment").tolist()
    count = len(curve.control_points)
    mirrored: dict[int, dict[int, float]] = {}
    if curve.ends == "clamped" and not curve.closed:
        beyond = curve.degree - 2
        mirrored = {-beyond: {0: 2.0, 1: -1.0}, count - 1 + beyond: {count - 1: 2.0, count - 2: -1.0}}
    first = index + curve.first_segment - 1
    terms = [mirrored.get(i, {i % count: 1.0}) for i in range(first, first + curve.degree + 1)]
    indices = sorted(set().union(*terms))
    matrix = [[term.get(i, 0.0) for i in indices] for term in terms]
    return np.array(indices, dtype=np.intp), np.array(matrix)


def motion(curve: Curve, segment: int, t: float) -> Motion:
    """Return how the point at `t` of a segment depends on the two λ of the segment."""
    parts = joints.take_segments(curve, np.array([segment]))
    still = parts._replace(lambda_start=np.zeros(1), lambda_end=np.zeros(1))
    order = 2 - curve.degree
    both = np.array([1 - t, t])
    per_unit = hyperbolic(both, order) - trigonometric(both, order)
    if curve.degree == 2:
        per_unit[0] *= -1
    bends = np.concatenate((parts.bend_start, parts.bend_end), axis=1)
    bends[:, np.abs(bends).max(axis=0) <= BEND_ROUNDING * _size(curve, segment)] = 0
    origin = joints.evaluate(still, np.array([t]), curve.degree, 0)[:, 0]
    return Motion(origin, per_unit * bends)


def locate(curve: Curve, u: float) -> tuple[int, float]:
    """Return segment and t of one parameter; a joint begins the segment after it."""
    if np.ndim(u) != 0:
        raise ValueError(f"give one parameter u, not an array of shape {np.shape(u)}")
    count = curve.segment_count
    if not 0 <= u <= count:
        raise ValueError(f"u = {float(u)} lies outside the curve's domain, 0 to {count}")
    segment = min(int(u), count - 1)
    return segment, float(u) - segment


def clean_target(dimension: int, target: ArrayLike) -> Floats:
    """Return a target as an array, (d,), or refuse it."""
    goal = clean_values(target, "the target", (dimension,))
    if not (np.abs(goal) <= MAX_COORDINATE).all():
        raise ValueError(f"the target must be finite and at most {MAX_COORDINATE:g} in size, not {goal}")
    return goal


def clean_bounds(bounds: tuple[float, float]) -> tuple[float, float]:
    """Return lowest and highest λ, or refuse them."""
    low, high = bounds
    if not -MAX_LAMBDA <= low <= high <= MAX_LAMBDA:
        raise ValueError(f"bounds of λ run from low to high, at most {MAX_LAMBDA:g} in size, not {bounds!r}")
    return float(low), float(high)


def _size(curve: Curve, segment: int) -> float:
    """Return the largest coordinate of the control points that define a segment."""
    indices, matrix = defining_points(curve, segment)
    return float(np.abs(matrix @ curve.control_points[indices]).max())


def _least_squares(columns: Floats, gap: Floats, low: Floats, high: Floats) -> Floats:
    """Return the smallest step (2,) among those from `low` to `high` that least miss the gap.

    The gap is in units of the largest coordinate, and 0 is a step allowed.
    """
    left, singular, right = np.linalg.svd(columns, full_matrices=False)
    kept = singular > _PARALLEL
    step: Floats = right[kept].T @ ((left[:, kept].T @ gap) / singular[kept])
    if (low <= step).all() and (step <= high).all():
        return step
    # Then the best step lies on the border of the box: where one of its four edges comes closest.
    edges = np.empty((4, 2))
    for row, (fixed, end) in enumerate(((0, low), (0, high), (1, low), (1, high))):
        column = columns[:, 1 - fixed]
        rest, squared = gap - columns[:, fixed] * end[fixed], column @ column
        edges[row, fixed] = end[fixed]
        edges[row, 1 - fixed] = column @ rest / squared if squared else 0.0
    edges = np.clip(edges, low, high)
    misses = np.linalg.norm(gap - edges @ columns.T, axis=1)
    best = edges[misses <= misses.min() + _EQUAL]
    smallest: Floats = best[np.linalg.norm(best, axis=1).argmin()]
    return smallest
