"""What a tree over segments holds at one height, and how what is measured of points along them is computed."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]
Flags = NDArray[np.bool_]


class Level(NamedTuple):
    """All nodes of one height, in the order of the curves and of their segments."""

    low: Floats  # (2, n) the box
    high: Floats  # (2, n)
    strays: Floats  # (n,) greatest distance from the chord
    code: NDArray[np.int8]  # (n,) mode as in `Curve.mode_codes`, or MIXED
    first: Ints  # (n,) the leaves of the run
    last: Ints  # (n,)
    left: Ints  # (n,) the children in the level below; the same one twice where there is one alone
    right: Ints  # (n,)

    def meet(self, nodes: Ints, low: Floats, high: Floats) -> Flags:
        """Which of some boxes meet a window."""
        return _between(self.low.take(nodes, axis=1), self.high.take(nodes, axis=1), low, high)

    def within(self, nodes: Ints, low: Floats, high: Floats) -> Flags:
        """Which of some boxes lie in a window altogether."""
        return _between(self.high.take(nodes, axis=1), self.low.take(nodes, axis=1), low, high)

    def below(self, nodes: Ints) -> Ints:
        """The children of some nodes, in their order."""
        left, right = self.left[nodes], self.right[nodes]
        children = np.stack((left, right), axis=1)
        two = np.ones(children.shape, dtype=np.bool_)
        np.not_equal(left, right, out=two[:, 1])
        return children[two]


def _between(one: Floats, other: Floats, low: Floats, high: Floats) -> Flags:
    """Where the first corner of a box, (2, n), is not above a window and the second not below it."""
    between: Flags = one[0] <= high[0]
    between &= other[0] >= low[0]
    between &= one[1] <= high[1]
    between &= other[1] >= low[1]
    return between


def stray(points: Floats, steps: int) -> Floats:
    """How far points along segments, (n + 1, 2, k), stray from chords over equal steps, of which there are so many."""
    stride = (len(points) - 1) // steps
    inner = points[:-1].reshape(steps, stride, 2, -1)[:, 1:]
    farthest: Floats = distances(inner, points[:-1:stride, None], points[stride::stride, None]).max(
        axis=(0, 1)
    )
    return farthest


def longest_step(points: Floats) -> Floats:
    """The longest step from point to point along segments, (n, 2, k)."""
    steps = points[1:] - points[:-1]
    steps *= steps
    longest: Floats = np.sqrt((steps[:, 0] + steps[:, 1]).max(axis=0))
    return longest


def distances(points: Floats, start: Floats, end: Floats) -> Floats:
    """The distance of each point, (…, 2, n), from its own straight line between two ends."""
    away, along = points - start, end - start
    x, y, dx, dy = away[..., 0, :], away[..., 1, :], along[..., 0, :], along[..., 1, :]
    squares = dx * dx + dy * dy
    t = x * dx + y * dy
    t *= np.divide(1.0, squares, out=np.zeros_like(squares), where=squares > 1e-300)
    np.clip(t, 0.0, 1.0, out=t)
    x -= t * dx
    y -= t * dy
    x *= x
    y *= y
    x += y
    return np.sqrt(x, out=x)
