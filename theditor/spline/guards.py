"""Where theorems stop holding: negative basis functions, reversed joints, and the hull that should bound."""

from functools import lru_cache
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.spline.basis import CONVEX_HULL_RANGE, JOINT_SLOPE_ZERO, Floats, basis
from theditor.spline.curve import Curve
from theditor.spline.joints import take_segments
from theditor.spline.numerals import indexed, number
from theditor.spline.shape import BEND_ROUNDING, defining_points

_NEGATIVE: Final = 1e-12  # of max(1, |λ|): a basis function less than this below zero is not negative
_NODES: Final = np.linspace(0, 1, 65)
_STEPS: Final = 16  # of Newton's method with bisection between nodes
_BLOCK: Final = 4096  # pairs of λ at a time, to bound the memory


class Guards(NamedTuple):
    """The negative basis functions of a curve, by segment and then by function."""

    degree: int
    segments: NDArray[np.intp]  # (n,) in which segment
    functions: NDArray[np.intp]  # (n,) which of its degree + 1 basis functions
    t: Floats  # (n,) where it is lowest
    values: Floats  # (n,) how low

    def reason(self, segment: int) -> str:
        """Say what is negative in a segment and what follows; nothing where no basis function is."""
        own = slice(*np.searchsorted(self.segments, (segment, segment + 1)))
        names = [indexed("qc"[self.degree - 2], k) for k in self.functions[own].tolist()]
        places = [f"near t = {t:.2g}" for t in self.t[own].tolist()]
        if not names:
            return ""
        if len(names) == 1:
            which = f"basis function {names[0]} is negative {places[0]}"
        else:
            each = [f"{name} ({place})" for name, place in zip(names, places, strict=True)]
            which = f"basis functions {', '.join(each[:-1])} and {each[-1]} are negative"
        return f"{which}; the convex hull no longer bounds this segment"


class ReversedJoint(NamedTuple):
    """A joint whose λ is not above the λ of slope zero."""

    point: int  # the control point whose λ it is; its number is the joint's in words
    joint: int  # its u
    reason: str  # what happens there


def negative_basis(curve: Curve, segments: NDArray[np.intp] | None = None) -> Guards:
    """Return every basis function that is negative somewhere in its segment, and where it is lowest.

    Of all segments, or of the given ones, ascending.

    Computed segment by segment, since the convex-hull range is sufficient only: inside it there is nothing
    to compute, and outside a quadratic's may still be positive. A function counts as negative when it falls
    below −1e-12·max(1, |λ|); the lowest value is found to the same accuracy. The λ at a clamped cubic end,
    which has no effect, counts as 0.
    """
    low, high = CONVEX_HULL_RANGE[curve.degree]
    effective = np.where(curve.active_lambdas, curve.lambdas, 0.0)
    asked = np.arange(curve.segment_count) if segments is None else segments
    first = asked + curve.first_segment
    start, end = (effective[(first + step) % len(effective)] for step in (0, 1))
    suspect = np.flatnonzero((np.minimum(start, end) < low) | (np.maximum(start, end) > high))
    pairs, which = np.unique(start[suspect] + 1j * end[suspect], return_inverse=True)
    t, values = np.empty((2, len(pairs), curve.degree + 1))
    for begin in range(0, len(pairs), _BLOCK):
        block = slice(begin, begin + _BLOCK)
        t[block], values[block] = _lowest(pairs[block].tobytes(), curve.degree)
    negative = values < -_NEGATIVE * _largest(pairs.real, pairs.imag)[:, None]
    row, function = np.nonzero(negative[which])
    pair = which[row]
    return Guards(curve.degree, asked[suspect[row]], function, t[pair, function], values[pair, function])


def reversed_joints(curve: Curve) -> tuple[ReversedJoint, ...]:
    """Return the joints whose λ is at or below `JOINT_SLOPE_ZERO`, in order, and what happens there.

    Below it a quadratic's velocity is reversed, and a cubic's second derivative; at it they vanish. Joints
    where they vanish for every λ, because control points coincide or are evenly spaced, are left out.
    """
    last = curve.segment_count
    joints = np.arange(last + (not curve.closed))
    points = (joints + curve.first_segment) % len(curve.control_points)
    suspect = np.flatnonzero(curve.active_lambdas[points] & (curve.lambdas[points] <= JOINT_SLOPE_ZERO))
    beside = take_segments(curve, np.minimum(suspect, last - 1))
    bends = np.where(suspect < last, beside.bend_start, beside.bend_end)
    bent = np.abs(bends).max(axis=0) > BEND_ROUNDING * np.abs(curve.control_points).max()
    found = suspect[bent]
    ends = () if curve.closed else (0, last)
    return tuple(
        ReversedJoint(point, joint, _what_happens(curve.degree, point, lam, joint in ends))
        for point, joint, lam in zip(
            points[found].tolist(), found.tolist(), curve.lambdas[points[found]].tolist(), strict=True
        )
    )


def hull(curve: Curve, segment: int) -> Floats:
    """Return the convex hull of the control points that define a segment of a plane curve.

    At a clamped end the reflected control point counts. Points inside the hull or along its edges are left
    out, so a straight polygon gives two points and coincident control points give one.

    Returns
    -------
    ndarray, shape (k, 2)
        Its corners counterclockwise, each once.

    Raises
    ------
    ValueError
        If the curve is not plane or there is no such segment.
    """
    if curve.dimension != 2:
        raise ValueError("the hull is drawn in the plane: project the curve's control points first")
    indices, matrix = defining_points(curve, segment)
    points = np.unique(matrix @ curve.control_points[indices], axis=0)
    if len(points) < 3:
        return points
    unit = 2.0 ** int(np.frexp(np.abs(points).max())[1])  # exact, and areas of tiny points do not vanish
    points = points / unit
    return np.array(_chain(points)[:-1] + _chain(points[::-1])[:-1]) * unit


@lru_cache(maxsize=8)
def _lowest(pairs: bytes, degree: int) -> tuple[Floats, Floats]:
    """Return where each basis function is lowest, and its value, (k, degree + 1) each; 0 if not below 0.

    Of segments with these λ at start and end, complex numbers as bytes; kept, since several views of a curve ask.

    Near each node lower than its neighbours lies one minimum. It can be deeper than the node by no more than
    h²/8 times the greatest second derivative, which is below 8 + 8|λ| for every basis function.
    """
    start, end = np.frombuffer(pairs).reshape(-1, 2).T
    largest = _largest(start, end)
    samples = basis(_NODES, start[:, None], end[:, None], degree)
    padded = np.pad(samples, ((0, 0), (1, 1), (0, 0)), constant_values=np.inf)
    valley = (samples <= padded[:, :-2]) & (samples <= padded[:, 2:])
    valley &= samples < (_NODES[1] ** 2 * (1 + largest))[:, None, None]
    # The outer functions are 0 at their far ends; they fall below it if and only if λ exceeds the range.
    high = CONVEX_HULL_RANGE[degree][1]
    valley[start <= high, :, 0] = False
    valley[end <= high, :, -1] = False
    row, node, function = np.nonzero(valley)
    one, other, each = start[row], end[row], np.arange(len(row))

    def of(t: Floats, nu: int) -> Floats:
        chosen: Floats = basis(t, one, other, degree, nu)[each, function]
        return chosen

    below, above = _NODES[np.maximum(node - 1, 0)], _NODES[np.minimum(node + 1, len(_NODES) - 1)]
    t = (below + above) / 2
    for _ in range(_STEPS):
        slope, bend = of(t, 1), of(t, 2)
        rising = slope > 0
        below, above = np.where(rising, below, t), np.where(rising, t, above)
        newton = t - slope / np.where(bend > 0, bend, np.inf)
        t = np.where((bend > 0) & (below <= newton) & (newton <= above), newton, (below + above) / 2)
    found, at_node = of(t, 0), samples[row, node, function]
    t, found = np.where(at_node <= found, _NODES[node], t), np.minimum(at_node, found)
    where, values = np.zeros((2, len(start), degree + 1))
    np.minimum.at(values, (row, function), found)
    lowest = found == values[row, function]
    where[row[lowest], function[lowest]] = t[lowest]
    return where, values


def _largest(start: Floats, end: Floats) -> Floats:
    return np.maximum(1.0, np.maximum(np.abs(start), np.abs(end)))


def _what_happens(degree: int, joint: int, lam: float, at_end: bool) -> str:
    # Joints are called by the number of their λ everywhere.
    if lam == JOINT_SLOPE_ZERO:
        name = f"{indexed('λ', joint)} = −2.648…"
        if degree == 2:
            return f"{name}: the curve stands still at joint {joint}, where it is C¹ but not G¹"
        return f"{name}: the second derivative vanishes at joint {joint}, where the curve has no curvature"
    name = f"{indexed('λ', joint)} = {number(lam)} is below −2.648…"
    if degree == 3:
        return f"{name}: the second derivative at joint {joint} is reversed, which adds inflections"
    if at_end:
        return f"{name}: the velocity at joint {joint}, an end of the curve, is reversed"
    return f"{name}: the velocity reverses at joint {joint}, which makes a cusp or a loop"


def _chain(points: Floats) -> list[Floats]:
    """Return the corners on the right-hand side on the way along sorted points, both ends included."""
    corners: list[Floats] = []
    for point in points:
        while len(corners) > 1 and _turn(corners[-2], corners[-1], point) <= 0:
            corners.pop()
        corners.append(point)
    return corners


def _turn(a: Floats, b: Floats, c: Floats) -> float:
    """Return twice the area of a triangle, positive when it runs counterclockwise."""
    return float((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]))
