"""Control points, and λ, by least squares: a curve brought as close as it can come to given points.

A point of the curve is linear in the control points and affine in λ. What makes the problem nonlinear is that
each given point may be met anywhere: the distance across the curve counts, that along it hardly does, and
after each step every parameter moves to the foot of its point (tangent distance minimisation).
"""

from collections.abc import Callable, Iterable
from typing import Final

import numpy as np
from numpy.typing import NDArray

from theditor.spline import joints
from theditor.spline.banded import solve
from theditor.spline.basis import Floats, basis, hyperbolic, trigonometric
from theditor.spline.curve import Curve
from theditor.spline.shape import PULL_BOUNDS

Indices = NDArray[np.intp]

_ALONG: Final = 0.1  # what a miss along the curve counts, where one across it counts 1
_HELD: Final = 1e4  # what a point to be met counts
_DRIFT: Final = (
    0.5  # how far a parameter may wander, lest a part of the curve be met by nothing and go astray
)
_STILL: Final = 1e-7  # a step along the curve after which the next would be none
_DAMPING: Final = 1e-10  # of a step, so that what nothing determines stays
_ENOUGH: Final = 1e-4


def design(curve: Curve, u: Floats) -> tuple[Indices, Floats]:
    """Return which control points some points of a curve depend on, and their weights there.

    Parameters
    ----------
    curve : Curve
    u : ndarray, shape (n,)
        Within the domain.

    Returns
    -------
    indices : ndarray of int, shape (n, degree + 1)
        Those of each point's segment in order; what a reflected point at a clamped end does is done by the two
        that it is made from.
    weights : ndarray, shape (n, degree + 1)
        Times these control points they give the points.
    """
    segment, t = _segments(curve, u)
    count, degree = len(curve.control_points), curve.degree
    joint = segment + curve.first_segment
    # A clamped cubic end has the same points whatever its λ.
    active = np.where(curve.active_lambdas, curve.lambdas, 0.0)
    weights = basis(t, active[joint % count], active[(joint + 1) % count], degree)
    indices = joint[:, None] + np.arange(-1, degree)
    if curve.closed:
        return indices % count, weights
    if curve.ends == "clamped":
        for rows, columns in (
            (segment == 0, slice(None)),
            (segment == curve.segment_count - 1, slice(None, None, -1)),
        ):
            weights[rows, columns] = _without_reflected(weights[rows, columns], degree)
    return np.clip(indices, 0, count - 1), weights


def _without_reflected(weights: Floats, degree: int) -> Floats:
    """Return the weights of a clamped segment's points, (n, degree + 1), without the reflected one, which comes first.

    It is twice the end less the point next to it. A quadratic's takes the place of the end.
    """
    result = weights.copy()
    end = degree - 2
    result[:, 0] = 0
    result[:, end] += 2 * weights[:, 0]
    result[:, end + 1] -= weights[:, 0]
    return result


def lambda_motion(curve: Curve, u: Floats) -> Floats:
    """Return how points of a curve move for a unit of λ at the start and at the end of their segments, (n, d, 2)."""
    segment, t = _segments(curve, u)
    parts = joints.take_segments(curve, segment)
    order, sign = 2 - curve.degree, -1.0 if curve.degree == 2 else 1.0
    start = sign * (hyperbolic(1 - t, order) - trigonometric(1 - t, order)) * parts.bend_start
    end = (hyperbolic(t, order) - trigonometric(t, order)) * parts.bend_end
    return np.stack((start.T, end.T), axis=2)


def feet(curve: Curve, points: Floats, u: Floats, steps: int = 3) -> Floats:
    """Return parameters at which the curve comes nearer to points than at the given ones, by Newton's method.

    On a closed curve parameters count round; on an open one they stay within the domain.
    """
    found, moving = u.copy(), np.arange(len(u))
    for _ in range(steps):
        u, goals = found[moving], points[moving].T
        miss, velocity, bend = _motion(curve, u, range(3))
        miss -= goals
        slope = np.einsum("dn,dn->n", miss, velocity)
        square = np.einsum("dn,dn->n", velocity, velocity)
        steep = square + np.einsum("dn,dn->n", miss, bend)
        steep = np.where(steep > 0.3 * square, steep, square)
        step = np.divide(slope, steep, out=np.zeros_like(u), where=steep > 0)
        new = u - np.clip(step, -0.5, 0.5)
        if not curve.closed:
            new = np.clip(new, 0, curve.segment_count)
        (after,) = _motion(curve, new, [0])
        after -= goals
        nearer = np.einsum("dn,dn->n", after, after) <= np.einsum("dn,dn->n", miss, miss)
        found[moving[nearer]] = new[nearer]
        moving = moving[nearer & (np.abs(new - u) > _STILL)]
        if not len(moving):
            break
    return found


def refitted(
    curve: Curve,
    targets: Floats,
    u: Floats,
    free: Indices,
    bent: Indices | None = None,
    held: NDArray[np.bool_] | None = None,
    steps: int = 12,
    bounds: tuple[float, float] = PULL_BOUNDS,
    enough: float = _ENOUGH,
    progress: Callable[[float], None] | None = None,
) -> tuple[Curve, Floats]:
    """Return the curve with some control points moved, and some λ changed, to come near to targets.

    Parameters
    ----------
    curve : Curve
    targets : ndarray, shape (n, d)
    u : ndarray, shape (n,)
        About where the curve is to meet each of them.
    free : ndarray of int
        The control points that may move.
    bent : ndarray of int, optional
        The points whose λ may change; none by default.
    held : ndarray of bool, shape (n,), optional
        Targets to be met at just their u.
    steps : int
        The most there may be.
    bounds : (float, float)
        Of the λ that may change.
    enough : float
        Gain of a step, relative, below which the next is not worth its time.
    progress : callable, optional
        Told the share of the steps that are done, before each; what it raises ends the work.

    Returns
    -------
    Curve
        Nowhere worse than before in the sum of squared distances.
    u : ndarray, shape (n,)
        Where it comes nearest to the targets, as far as small steps find it.
    """
    bent = np.empty(0, dtype=np.intp) if bent is None else bent[curve.active_lambdas[bent]]
    held = np.zeros(len(u), dtype=np.bool_) if held is None else held
    importance = np.where(held, _HELD, 1.0)

    def settled(other: Curve, start: Floats) -> tuple[Floats, Floats, float]:
        where = np.clip(feet(other, targets, start), first - _DRIFT, first + _DRIFT)
        where = np.where(held, start, where)
        miss = targets.T - _motion(other, where, [0])[0]
        return where, miss, float(np.einsum("dn,dn,n", miss, miss, importance**2))

    first = u
    u, miss, misses = settled(curve, u)
    for step in range(steps):
        if progress is not None:
            progress(step / steps)
        move, turn = _step(curve, miss, u, free, bent, importance)
        length, before = 1.0, misses
        while length > 0.1:
            lambdas = np.clip(curve.lambdas[bent] + length * turn, *bounds)
            points = curve.control_points[free] + length * move
            new = curve.with_points(free, points).with_lambdas(bent, lambdas)
            where, gap, after = settled(new, u)
            if after < misses:
                curve, u, miss, misses = new, where, gap, after
                break
            length /= 2
        if misses >= before * (1 - enough):
            break
    return curve, u


def _step(
    curve: Curve, miss: Floats, u: Floats, free: Indices, bent: Indices, importance: Floats
) -> tuple[Floats, Floats]:
    """Return by how much to move control points, (k, d), and to change λ, (l,), to make up for misses, (d, n)."""
    order = np.argsort(_within(curve, u), kind="stable")  # the points of a segment together
    at, miss, importance = _within(curve, u)[order], miss[:, order], importance[order]
    (velocity,) = _motion(curve, at, [1])
    speed = np.sqrt(np.einsum("dn,dn->n", velocity, velocity))
    direction = np.divide(velocity, speed, out=np.zeros_like(velocity), where=speed > 0)
    along = np.where(importance > 1, 0.0, 1 - _ALONG)
    dimension = curve.dimension
    across = np.eye(dimension)[:, :, None] - along * direction[:, None] * direction
    across = np.ascontiguousarray((across * importance).transpose(2, 0, 1))
    indices, weights = design(curve, at)
    each = dimension + (len(bent) > 0)  # unknowns of a control point
    columns = np.zeros((len(at), dimension, curve.degree + 1, each))
    columns[..., :dimension] = across[:, :, None, :] * weights[:, None, :, None]
    if len(bent):
        # Those of λ at a segment's ends are those of its middle control points, or of the last two.
        columns[:, :, 1:3, dimension] = across @ lambda_motion(curve, at)
    rows = columns.reshape(len(at), dimension, -1)
    goal = across @ miss.T[:, :, None]

    starts = np.flatnonzero(np.diff(_segments(curve, at)[0], prepend=-1))
    turned = rows.transpose(0, 2, 1)
    matrices = np.add.reduceat(turned @ rows, starts)
    goals = np.add.reduceat((turned @ goal)[:, :, 0], starts)
    unknown = np.full((len(curve.control_points), each), -1)
    unknown[free, :dimension] = 0
    unknown[bent, dimension:] = 0
    sought = unknown == 0
    count = int(np.count_nonzero(sought))
    unknown[sought] = np.arange(count)
    solution = np.zeros(unknown.shape)
    solution[sought] = solve(
        matrices,
        goals,
        unknown[indices[starts]].reshape(len(starts), -1),
        count,
        (curve.degree + 1) * each,
        _DAMPING,
    )
    return solution[free, :dimension], solution[bent, -1]


def _segments(curve: Curve, u: Floats) -> tuple[Indices, Floats]:
    segment = np.minimum(np.floor(u).astype(np.intp), curve.segment_count - 1)
    return segment, u - segment


def _motion(curve: Curve, u: Floats, orders: Iterable[int]) -> list[Floats]:
    """Return derivatives of some orders, (d, n) each."""
    segment, t = _segments(curve, _within(curve, u))
    parts = joints.take_segments(curve, segment)
    return [joints.evaluate(parts, t, curve.degree, nu) for nu in orders]


def _within(curve: Curve, u: Floats) -> Floats:
    """Return parameters within the domain: a closed curve's count round."""
    return np.mod(u, curve.segment_count) if curve.closed else u
