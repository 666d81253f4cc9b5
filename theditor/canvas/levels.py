"""The levels of a tree over segments: at height h, node k holds those from number k·2ʰ until the next node's first.

Nodes are told by their numbers, ascending.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.spline.distinct import distinct

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]
Flags = NDArray[np.bool_]
Places = Ints | slice


class Level(NamedTuple):
    """All nodes of one height, in the order of their segments."""

    low: Floats  # (2, n) the box
    high: Floats  # (2, n)
    strays: Floats  # (n,) greatest distance from the chord; infinite where there is none, over several curves
    codes: NDArray[np.int8]  # (n,) mode as in `Curve.mode_codes`, or MIXED

    @classmethod
    def blank(cls, count: int) -> Level:
        """A level of so many nodes, of which nothing is known yet."""
        return cls(
            np.empty((2, count)), np.empty((2, count)), np.empty(count), np.empty(count, dtype=np.int8)
        )

    def meet(self, nodes: Ints, low: Floats, high: Floats) -> Flags:
        """Which of some boxes meet a window."""
        return _between(self.low.take(nodes, axis=1), self.high.take(nodes, axis=1), low, high)

    def within(self, nodes: Ints, low: Floats, high: Floats) -> Flags:
        """Which of some boxes lie in a window altogether."""
        return _between(self.high.take(nodes, axis=1), self.low.take(nodes, axis=1), low, high)


def nodes_below(nodes: Ints, most: int) -> Ints:
    """The nodes of a level, `most` in all, that are below some of the next one."""
    below = np.repeat(2 * nodes, 2)
    below[1::2] += 1
    return below[:-1] if len(nodes) and below[-1] == most else below


def pairs_below(nodes: Ints, most: int) -> tuple[Places, Places]:
    """The two nodes of a level, `most` in all, below each of some; the same one twice where there is one alone."""
    where = places_of(nodes)
    if isinstance(where, slice) and 2 * where.stop <= most:
        return slice(2 * where.start, 2 * where.stop, 2), slice(2 * where.start + 1, 2 * where.stop, 2)
    left = 2 * nodes
    return left, np.minimum(left + 1, most - 1)


def parents_of(nodes: Ints) -> Ints:
    """The nodes above some."""
    where = places_of(nodes)
    if isinstance(where, slice):
        return np.arange(where.start >> 1, (where.stop + 1) >> 1)
    return distinct(nodes >> 1)


def places_of(nodes: Ints) -> Places:
    """Where in an array to find what belongs to some nodes, ascending and distinct; in one piece if they adjoin."""
    if not len(nodes):
        return slice(0, 0)
    return slice(int(nodes[0]), int(nodes[-1]) + 1) if nodes[-1] - nodes[0] < len(nodes) else nodes


def _between(one: Floats, other: Floats, low: Floats, high: Floats) -> Flags:
    """Where the first corner of a box, (2, n), is not above a window and the second not below it."""
    between: Flags = one[0] <= high[0]
    between &= other[0] >= low[0]
    between &= one[1] <= high[1]
    between &= other[1] >= low[1]
    return between


def distances(points: Floats, start: Floats, end: Floats) -> Floats:
    """The distance of each point, (2, n), from its own straight line between two ends."""
    (x, y), (dx, dy) = points - start, end - start
    squares = dx * dx + dy * dy
    t = x * dx + y * dy
    t *= np.divide(1.0, squares, out=np.zeros_like(squares), where=squares > 1e-300)
    np.clip(t, 0.0, 1.0, out=t)
    x -= t * dx
    y -= t * dy
    x *= x
    y *= y
    x += y
    away: Floats = np.sqrt(x, out=x)
    return away
