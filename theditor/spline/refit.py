"""Control points, and λ, by least squares: a curve brought as close as it can come to given points.

A point of the curve is linear in the control points and affine in λ. What makes the problem nonlinear is that
each given point may be met anywhere: the distance across the curve counts, that along it hardly does, and
after each step every parameter moves to the foot of its point (tangent distance minimisation).
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from theditor.spline import joints
from theditor.spline.basis import Floats, basis, hyperbolic, trigonometric
from theditor.spline.curve import Curve
from theditor.spline.shape import PULL_BOUNDS

Indices = NDArray[np.intp]

_ALONG: Final = 0.1  # what a miss along the curve counts, where one across it counts 1
_HELD: Final = 1e4  # what a point to be met counts
_DRIFT: Final = (
    0.5  # how far a parameter may wander, lest a part of the curve be met by nothing and go astray
)
_DAMPING: Final = 1e-10  # of a step, so that what nothing determines stays
_ENOUGH: Final = 1e-4  # gain of a step, relative, below which the next is not worth its time


def design(curve: Curve, u: Floats) -> tuple[Indices, Floats]:
    """Return which control points some points of a curve depend on, and their weights there.

    Parameters
    ----------
    curve : Curve
    u : ndarray, shape (n,)
        Within the domain.

    Returns
    -------
    indices : ndarray of int, shape (k,)
        Ascending.
    weights : ndarray, shape (n, k)
        Times these control points they give the points.
    """
    segment, t = _segments(curve, u)
    count, degree = len(curve.control_points), curve.degree
    joint = segment + curve.first_segment
    # A clamped cubic end has the same points whatever its λ.
    active = np.where(curve.active_lambdas, curve.lambdas, 0.0)
    weights = basis(t, active[joint % count], active[(joint + 1) % count], degree)
    places = joint[:, None] + np.arange(-1, degree)
    if curve.closed:
        places %= count
    elif curve.ends == "clamped":
        # The reflected point is twice the end less the point next to it.
        beyond = degree - 2
        first, last = places == -beyond, places == count - 1 + beyond
        reflected = np.where(first | last, weights, 0.0)
        places = np.where(first, 0, np.where(last, count - 1, places))
        next_to = np.where(first, 1, np.where(last, count - 2, places))
        weights = np.concatenate((weights + reflected, -reflected), axis=1)
        places = np.concatenate((places, next_to), axis=1)
    indices, column = np.unique(places, return_inverse=True)
    matrix = np.zeros((len(t), len(indices)))
    np.add.at(matrix, (np.arange(len(t))[:, None], column.reshape(places.shape)), weights)
    return indices, matrix


def lambda_motion(curve: Curve, u: Floats, indices: Indices) -> Floats:
    """Return how points of a curve move for a unit of each of some active λ, (n, d, len(indices))."""
    segment, t = _segments(curve, u)
    parts = joints.take_segments(curve, segment)
    order, sign = 2 - curve.degree, -1.0 if curve.degree == 2 else 1.0
    start = sign * (hyperbolic(1 - t, order) - trigonometric(1 - t, order)) * parts.bend_start
    end = (hyperbolic(t, order) - trigonometric(t, order)) * parts.bend_end
    count = len(curve.control_points)
    joint = segment + curve.first_segment
    moves = np.zeros((len(t), curve.dimension, len(indices)))
    for column, index in enumerate(indices):
        moves[:, :, column] += np.where(joint % count == index, start, 0).T
        moves[:, :, column] += np.where((joint + 1) % count == index, end, 0).T
    return moves


def feet(curve: Curve, points: Floats, u: Floats, steps: int = 3) -> Floats:
    """Return parameters at which the curve comes nearer to points than at the given ones, by Newton's method.

    On a closed curve parameters count round; on an open one they stay within the domain.
    """
    for _ in range(steps):
        at = _within(curve, u)
        miss, velocity, bend = curve(at) - points, curve(at, 1), curve(at, 2)
        slope = np.einsum("nd,nd->n", miss, velocity)
        square = np.einsum("nd,nd->n", velocity, velocity)
        steep = square + np.einsum("nd,nd->n", miss, bend)
        steep = np.where(steep > 0.3 * square, steep, square)
        step = np.divide(slope, steep, out=np.zeros_like(u), where=steep > 0)
        new = u - np.clip(step, -0.5, 0.5)
        if not curve.closed:
            new = np.clip(new, 0, curve.segment_count)
        after = curve(_within(curve, new)) - points
        nearer = np.einsum("nd,nd->n", after, after) <= np.einsum("nd,nd->n", miss, miss)
        u = np.where(nearer, new, u)
    return u


def refitted(
    curve: Curve,
    targets: Floats,
    u: Floats,
    free: Indices,
    bent: Indices | None = None,
    held: NDArray[np.bool_] | None = None,
    steps: int = 12,
    bounds: tuple[float, float] = PULL_BOUNDS,
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

    def settled(other: Curve, start: Floats) -> tuple[Floats, float]:
        where = np.clip(feet(other, targets, start), first - _DRIFT, first + _DRIFT)
        where = np.where(held, start, where)
        miss = (other(_within(other, where)) - targets) * importance[:, None]
        return where, float(np.sum(miss * miss))

    first = u
    u, misses = settled(curve, u)
    for _ in range(steps):
        move, turn = _step(curve, targets, u, free, bent, importance)
        length, before = 1.0, misses
        while length > 0.1:
            lambdas = np.clip(curve.lambdas[bent] + length * turn, *bounds)
            points = curve.control_points[free] + length * move
            new = curve.with_points(free, points).with_lambdas(bent, lambdas)
            where, after = settled(new, u)
            if after < misses:
                curve, u, misses = new, where, after
                break
            length /= 2
        if misses >= before * (1 - _ENOUGH):
            break
    return curve, u


def _step(
    curve: Curve, targets: Floats, u: Floats, free: Indices, bent: Indices, importance: Floats
) -> tuple[Floats, Floats]:
    """Return by how much to move control points, (k, d), and to change λ, (l,)."""
    at, dimension = _within(curve, u), curve.dimension
    miss, velocity = targets - curve(at), curve(at, 1)
    speed = np.linalg.norm(velocity, axis=1)
    direction = np.divide(velocity, speed[:, None], out=np.zeros_like(velocity), where=speed[:, None] > 0)
    along = np.where(importance > 1, 0.0, 1 - _ALONG)
    across = np.eye(dimension) - (along[:, None] * direction)[:, :, None] * direction[:, None, :]
    across *= importance[:, None, None]
    indices, weights = design(curve, at)
    columns = np.zeros((len(u), len(free)))
    place = np.searchsorted(indices, free).clip(max=len(indices) - 1)
    met = indices[place] == free
    columns[:, met] = weights[:, place[met]]
    point_part = (across[:, :, None, :] * columns[:, None, :, None]).reshape(len(u) * dimension, -1)
    lambda_part = (across @ lambda_motion(curve, at, bent)).reshape(len(u) * dimension, -1)
    matrix = np.concatenate((point_part, lambda_part), axis=1)
    goal = (across @ miss[:, :, None]).ravel()
    # Each unknown in its own measure, so that neither units nor λ matter to the damping.
    size = np.linalg.norm(matrix, axis=0)
    size = np.where(size > 0, size, 1.0)
    matrix /= size
    normal = matrix.T @ matrix
    normal[np.diag_indices_from(normal)] += _DAMPING
    solution = np.linalg.solve(normal, matrix.T @ goal) / size
    split = len(free) * dimension
    return solution[:split].reshape(len(free), dimension), solution[split:]


def _segments(curve: Curve, u: Floats) -> tuple[Indices, Floats]:
    segment = np.minimum(np.floor(u).astype(np.intp), curve.segment_count - 1)
    return segment, u - segment


def _within(curve: Curve, u: Floats) -> Floats:
    """Return parameters within the domain: a closed curve's count round."""
    return np.mod(u, curve.segment_count) if curve.closed else u
