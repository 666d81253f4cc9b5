"""The curves of a drawing as chords, long where they may be and short where they must: level of detail.

Over the segments of all curves stands one binary tree. A leaf is a segment; a node above holds the run of
segments of its two children, the box around them, and how far they stray from the one chord over the whole
run, if it is all of one curve. Descending from the root, what lies outside the window is left out unseen, and
a run that its chord represents within the tolerance is drawn as that chord; only segments larger than the
tolerance are sampled.
So a picture costs as many lines as the eye can tell apart, not as many as the drawing has segments.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.levels import (
    Flags,
    Floats,
    Ints,
    Level,
    distances,
    nodes_below,
    pairs_below,
    parents_of,
    places_of,
)
from theditor.canvas.raster import Along
from theditor.canvas.segment_table import BLOCK, SegmentTable
from theditor.spline import Curve
from theditor.spline.distinct import distinct
from theditor.spline.magnified import Pieces, pieces_in_view
from theditor.spline.sampling import intervals_within

MIXED = -1
"""The mode of a run of segments that have different ones."""


class Chords(NamedTuple):
    """Straight lines in place of runs of segments, in the order of the curves and along them."""

    lines: Floats
    """(n, 4): x and y of the start, x and y of the end."""
    curves: Ints
    """(n,): the curve's place among those of the tree."""
    codes: NDArray[np.int8]
    """(n,): the mode as in `Curve.mode_codes`; `MIXED` where a line runs over several."""
    segments: Ints
    """(n,): the segment of the curve, of a longer run the first one."""
    parameters: Floats
    """(n, 2): t at the start and the end of each line, of a line within one segment."""


class Leaves(NamedTuple):
    """Segments in the order of the curves and along them."""

    rows: Ints
    """(n,): their numbers among those of all curves."""
    curves: Ints
    """(n,): the curve's place among those of the tree."""
    codes: NDArray[np.int8]
    """(n,): the mode as in `Curve.mode_codes`."""


class ChordTree:
    """The tree over plane curves, one after the other."""

    def __init__(self, curves: Sequence[Curve], like: ChordTree | None = None) -> None:
        """Measure the curves, but for what they share with those of another tree."""
        self._table: SegmentTable = SegmentTable(curves, like._table if like is not None else None)
        self._levels, total = [self._table.level], self.size
        while total > 1:
            total = (total + 1) // 2
            self._levels.append(Level.blank(total))
        self._rise(np.arange(self.size))

    @property
    def size(self) -> int:
        """How many segments there are."""
        return self._table.size

    @property
    def sizes(self) -> Floats:
        """Width and height of the box around each curve, (2, curves)."""
        return self._table.sizes

    def follow(self, curves: Sequence[Curve]) -> bool:
        """Become the tree over other curves by changing what differs; returns False where too much does."""
        changed = self._table.follow(curves)
        if changed is None:
            return False
        self._rise(changed)
        return True

    def _rise(self, nodes: Ints) -> None:
        """Compute all that is above some leaves, ascending, from the bottom up."""
        for height in range(1, len(self._levels)):
            nodes = parents_of(nodes)
            for begin in range(0, len(nodes), BLOCK):
                self._combine(height, nodes[begin : begin + BLOCK])

    def _combine(self, height: int, nodes: Ints) -> None:
        """Compute some nodes of a level from their children in the level below.

        A child's chord is nowhere farther from the chord over both than where the two children meet, so what
        they stray from their own adds up with that.
        """
        level, children = self._levels[height], self._levels[height - 1]
        where, (left, right) = places_of(nodes), pairs_below(nodes, len(children.codes))
        first, last = self._run(height, nodes)
        middle = np.minimum(first + (1 << (height - 1)), self.size) - 1
        starts, ends = self._table.ends[:2], self._table.ends[2:]
        apart = distances(ends.take(middle, axis=1), starts.take(first, axis=1), ends.take(last, axis=1))
        apart[self._table.owner[first] != self._table.owner[last]] = np.inf
        level.strays[where] = np.maximum(children.strays[left], children.strays[right]) + apart
        one, other = children.codes[left], children.codes[right]
        level.codes[where] = np.where(one == other, one, MIXED)
        for axis in (0, 1):
            low, high = children.low[axis], children.high[axis]
            level.low[axis, where] = np.minimum(low[left], low[right])
            level.high[axis, where] = np.maximum(high[left], high[right])

    def _run(self, height: int, nodes: Ints) -> tuple[Ints, Ints]:
        """The first and the last leaf of some nodes of a height."""
        first = nodes << height
        return first, np.minimum(first + (1 << height), self.size) - 1

    def chords(
        self,
        low: Floats,
        high: Floats,
        tolerance: float,
        *,
        by_mode: int = -1,
        without: Mapping[int, Ints] | None = None,
        whole: bool = False,
        most: float = np.inf,
    ) -> Chords | None:
        """The lines to draw for what a window shows.

        Parameters
        ----------
        low, high : (2,)
            Corners of the window.
        tolerance
            Largest distance of a line from the curve.
        by_mode
            The curve, if any, no line of which may run over several modes.
        without
            Segments to leave out, by the curve.
        whole
            Whether no line may run over several segments.
        most
            Give up, and return None, when there are to be more lines than about this.
        """
        barred = self._barred(without or {})
        first, last, codes, count = [], [], [], 0
        nodes = np.arange(len(self._levels[-1].codes))
        for height in range(len(self._levels) - 1, -1, -1):
            level = self._levels[height]
            nodes = nodes[level.meet(nodes, low, high)]
            if barred and not height:
                nodes = nodes[~barred[0][nodes]]
            if not (whole and height):
                fits = level.strays[nodes] <= tolerance
                if by_mode >= 0 and height:
                    fits &= (level.codes[nodes] != MIXED) | (self._table.owner[nodes << height] != by_mode)
                if barred and height:
                    fits &= ~barred[height][nodes]
                found = nodes[fits]
                begin, end = self._run(height, found)
                first.append(begin)
                last.append(end)
                codes.append(level.codes[found])
                nodes = nodes[~fits]
                count += len(found)
            if count + len(nodes) * (2 if height else 1) > most:  # few of two children lie outside
                return None
            if height:
                nodes = nodes_below(nodes, len(self._levels[height - 1].codes))
        turning = self._table.turning[nodes]
        if count + int(intervals_within(turning, tolerance).sum()) > most:
            return None
        finer: list[Pieces] = []
        for degree in (2, 3):
            chosen = self._table.cubic[nodes] == (degree == 3)
            own = nodes[chosen]
            if len(own):
                parts = self._table.parts_of(own)
                finer += pieces_in_view(parts, own, degree, turning[chosen], tolerance, low, high)
        return self._in_order(np.concatenate(first), np.concatenate(last), np.concatenate(codes), finer)

    def seen(self, place: int, low: Floats, high: Floats) -> Ints:
        """The segments of one curve whose boxes meet a window, ascending."""
        begin, end = self._table.begins[place : place + 2].tolist()
        return self._met(low, high, begin, end)

    def leaves(self, low: Floats, high: Floats, without: Mapping[int, Ints] | None = None) -> Leaves:
        """The segments of all curves whose boxes meet a window, but for some, by the curve."""
        rows = self._met(low, high, 0, self.size)
        if barred := self._barred(without or {}):
            rows = rows[~barred[0][rows]]
        return Leaves(rows, self._table.owner[rows], self._levels[0].codes[rows])

    def points(self, rows: Ints, spacing: float, most: float) -> Along | None:
        """Points along some leaves, no farther apart than a spacing; None if they are to be more than `most`."""
        return self._table.points(rows, spacing, most)

    def _met(self, low: Floats, high: Floats, begin: int, end: int) -> Ints:
        """Which of the leaves from `begin` to `end` meet a window, counted from `begin`."""
        edges = np.zeros(end - begin + 1, dtype=np.intp)
        nodes = np.arange(len(self._levels[-1].codes))
        for height in range(len(self._levels) - 1, -1, -1):
            level = self._levels[height]
            nodes = nodes[(nodes >= begin >> height) & (nodes << height < end)]
            nodes = nodes[level.meet(nodes, low, high)]
            found = level.within(nodes, low, high) if height else np.ones(len(nodes), dtype=np.bool_)
            first, last = self._run(height, nodes[found])
            edges[np.maximum(first, begin) - begin] += 1
            edges[np.minimum(last + 1, end) - begin] -= 1
            if height:
                nodes = nodes_below(nodes[~found], len(self._levels[height - 1].codes))
        return np.flatnonzero(np.cumsum(edges[:-1]))

    def _barred(self, without: Mapping[int, Ints]) -> list[Flags]:
        """Which nodes of each level hold segments to be left out; nothing if there are none."""
        if not any(map(len, without.values())):
            return []
        nodes = distinct(
            np.concatenate([rows + self._table.begins[place] for place, rows in without.items()])
        )
        flags = []
        for level in self._levels:
            flags.append(np.zeros(len(level.codes), dtype=np.bool_))
            flags[-1][nodes] = True
            nodes = parents_of(nodes)
        return flags

    def _in_order(self, first: Ints, last: Ints, codes: NDArray[np.int8], finer: list[Pieces]) -> Chords:
        """Put together the chords over runs of leaves, and pieces of single ones."""
        ends = self._table.ends
        runs = Pieces(
            np.concatenate((ends[:2].take(first, axis=1), ends[2:].take(last, axis=1))).T,
            first,
            np.tile((0.0, 1.0), (len(first), 1)),
        )
        lines, rows, steps = zip(runs, *finer, strict=True)
        at = np.concatenate(rows)
        order = np.argsort(at, kind="stable")
        codes = np.concatenate([codes, self._levels[0].codes[at[len(first) :]]])[order]
        at = at[order]
        owners = self._table.owner[at]
        return Chords(
            np.concatenate(lines).take(order, axis=0),
            owners,
            codes,
            at - self._table.begins[owners],
            np.concatenate(steps).take(order, axis=0),
        )
