"""The curves of a drawing as chords, long where they may be and short where they must: level of detail.

Over the segments of all curves stands one binary tree. A leaf is a segment; a node above holds the run of
segments of its two children, the box around them, and how far they stray from the one chord over the whole
run, if it is all of one curve. Descending from the root, what lies outside the window is left out unseen, and
a run that its chord represents within the tolerance is drawn as that chord; only segments larger than the
tolerance are sampled.
So a picture costs as many lines as the eye can tell apart, not as many as the drawing has segments.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import cycle, pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.levels import (
    Flags,
    Floats,
    Ints,
    Level,
    Places,
    distances,
    nodes_below,
    pairs_below,
    parents_of,
    places_of,
)
from theditor.canvas.versions import FEW, changed_share, same_segments, whole_offset
from theditor.spline import Curve, changed_segments, joints
from theditor.spline.distinct import distinct
from theditor.spline.flatness import flatness
from theditor.spline.sampling import intervals_within, middles, sample_parts

BLOCK = 8192
"""So many segments or nodes are looked at together, as their numbers stay in the processor's cache."""
MOST_SHIFTS = 1000
"""So many times a tree is moved with its curves, each time rounded, before it is made anew."""
SLIGHT = 1e-8
"""Rounding that is no larger than this share of a curve's size is not seen."""
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
        self._curves = list(curves)
        counts = np.array([curve.segment_count for curve in curves], dtype=np.intp)
        self._begins = np.concatenate(([0], np.cumsum(counts)))
        self._cubic = np.repeat(np.array([curve.degree == 3 for curve in curves], dtype=np.bool_), counts)
        self._owner = np.repeat(np.arange(len(curves)), counts)
        total = len(self._owner)
        self._forms = np.empty((total, 10))  # what belongs to one segment lies together
        self._turning, self._speeds = np.empty((2, total))
        self._ends = np.empty((4, total))
        self._levels = [Level.blank(total)]
        while total > 1:
            total = (total + 1) // 2
            self._levels.append(Level.blank(total))
        self._shifts = 0
        every = np.arange(self.size)
        fresh = self._take_over(like) if like is not None else every
        self._fill(distinct(self._owner[fresh]))
        self._measure(fresh)
        self._rise(every)

    def _take_over(self, like: ChordTree) -> Ints:
        """Copy what another tree knows of segments that are the same; returns the others."""
        sources = same_segments(like._curves, like._begins, self._curves, self._begins)
        own = np.flatnonzero(sources >= 0)
        where, chosen = places_of(own), sources[own]
        self._forms[where] = like._forms.take(chosen, axis=0)
        for mine, other in zip(self._known_of_leaves(), like._known_of_leaves(), strict=True):
            mine[where] = other.take(chosen)
        self._shifts = like._shifts
        return np.flatnonzero(sources < 0)

    def _known_of_leaves(self) -> list[NDArray[Any]]:
        leaves = self._levels[0]
        return [
            self._turning,
            self._speeds,
            *self._ends,
            *leaves.low,
            *leaves.high,
            leaves.strays,
            leaves.codes,
        ]

    def _fill(self, places: Ints) -> None:
        """Put some whole curves into joint form, and tell their modes."""
        if not len(places):
            return
        chosen = np.zeros(len(self._curves), dtype=np.bool_)
        chosen[places] = True
        where = places_of(np.flatnonzero(chosen[self._owner]))
        curves = [self._curves[place] for place in places.tolist()]
        forms = zip(*(curve.joint_form for curve in curves), strict=True)
        _put(self._forms.T, where, _rows(np.concatenate(part, axis=-1) for part in forms))
        self._levels[0].codes[where] = joints.codes_of_all(curves, self._forms[where, 8:].T)

    @property
    def size(self) -> int:
        """How many segments there are."""
        return len(self._owner)

    @cached_property
    def sizes(self) -> Floats:
        """Width and height of the box around each curve, (2, curves)."""
        if not self._curves:
            return np.empty((2, 0))
        leaves, begins = self._levels[0], self._begins[:-1]
        sizes: Floats = np.maximum.reduceat(leaves.high, begins, axis=1)
        sizes -= np.minimum.reduceat(leaves.low, begins, axis=1)
        return sizes

    def follow(self, curves: Sequence[Curve]) -> bool:
        """Become the tree over other curves by changing what differs; returns False where too much does."""
        if len(curves) != len(self._curves):
            return False
        pairs = enumerate(zip(self._curves, curves, strict=True))
        changes = [(place, old, new) for place, (old, new) in pairs if old is not new]
        if 8 * self._rough_count(changes) > self.size:
            return False
        rows, patches, count = [], [], 0
        offsets, sizes = np.zeros((2, len(curves))), self.sizes.max(axis=0)
        for place, old, new in changes:
            offset = whole_offset(old, new, SLIGHT * sizes[place])
            if offset is not None:
                offsets[:, place] = offset
                continue
            segments = changed_segments(old, new)
            if segments is None:
                return False
            count += len(segments)
            if 8 * count > self.size:
                return False
            if len(segments):
                rows.append(segments + self._begins[place])
                patches.append((new, segments))
        moved: Flags = np.any(offsets, axis=0)
        self._shifts += int(moved.any())
        if self._shifts > MOST_SHIFTS:
            return False
        del self.sizes
        changed = np.concatenate([np.empty(0, dtype=np.intp), *rows])
        for where, (curve, segments) in zip(rows, patches, strict=True):
            _put(self._forms.T, where, _rows(joints.take_segments(curve, segments)))
            self._levels[0].codes[where] = curve.codes_of(segments)
        self._curves = list(curves)
        self._measure(changed)
        self._rise(changed)
        if moved.any():
            shifted = np.flatnonzero(moved[self._owner])
            self._shift(shifted, offsets.take(self._owner[shifted], axis=1))
            self._rise(shifted)
        return True

    def _rough_count(self, changes: Sequence[tuple[int, Curve, Curve]]) -> float:
        """About how many segments are to be measured anew, judged by a few of the curves that have changed."""
        some = changes[:: len(changes) // FEW + 1]
        slight = SLIGHT * self.sizes.max(axis=0)
        share = sum(
            changed_share(old, new)
            for place, old, new in some
            if whole_offset(old, new, slight[place]) is None
        )
        counts = np.diff(self._begins)[[place for place, *_ in changes]]
        return share / max(len(some), 1) * float(counts.sum())

    def _shift(self, rows: Ints, offsets: Floats) -> None:
        """Move some leaves by an offset each, (2, n)."""
        corners = (*self._levels[0].low, *self._levels[0].high, *self._ends)
        for row, offset in zip(corners, cycle(offsets)):
            row[rows] += offset
        self._forms[rows, :4] += np.concatenate((offsets, offsets)).T

    def _measure(self, rows: Ints) -> None:
        """Compute boxes, ends and bounds of some leaves."""
        for degree in (2, 3):
            own = rows[self._cubic.take(rows) == (degree == 3)]
            for begin in range(0, len(own), BLOCK):
                self._measure_block(own[begin : begin + BLOCK], degree)

    def _measure_block(self, own: Ints, degree: int) -> None:
        """Compute boxes, ends and bounds of some leaves of one degree."""
        leaves, where = self._levels[0], places_of(own)
        start, end, stray, self._turning[where], self._speeds[where] = flatness(self._parts_of(own), degree)
        leaves.strays[where] = stray
        _put(self._ends, where, (*start, *end))
        _put(leaves.low, where, np.minimum(start, end) - stray)
        _put(leaves.high, where, np.maximum(start, end) + stray)

    def _parts_of(self, leaves: Ints) -> joints.Segments:
        """Some leaves in joint form."""
        rows = self._forms.take(leaves, axis=0).T.copy()
        return joints.Segments(rows[0:2], rows[2:4], rows[4:6], rows[6:8], rows[8], rows[9])

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
        starts, ends = self._ends[:2], self._ends[2:]
        apart = distances(ends.take(middle, axis=1), starts.take(first, axis=1), ends.take(last, axis=1))
        apart[self._owner[first] != self._owner[last]] = np.inf
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
                    fits &= (level.codes[nodes] != MIXED) | (self._owner[nodes << height] != by_mode)
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
        steps = self._steps(nodes, tolerance)
        if count + int(steps.sum()) > most:
            return None
        return self._lines(np.concatenate(first), np.concatenate(last), np.concatenate(codes), nodes, steps)

    def seen(self, place: int, low: Floats, high: Floats) -> Ints:
        """The segments of one curve whose boxes meet a window, ascending."""
        begin, end = self._begins[place : place + 2].tolist()
        return self._met(low, high, begin, end)

    def leaves(self, low: Floats, high: Floats, without: Mapping[int, Ints] | None = None) -> Leaves:
        """The segments of all curves whose boxes meet a window, but for some, by the curve."""
        rows = self._met(low, high, 0, self.size)
        if barred := self._barred(without or {}):
            rows = rows[~barred[0][rows]]
        return Leaves(rows, self._owner[rows], self._levels[0].codes[rows])

    def points(self, rows: Ints, spacing: float, most: float) -> Iterator[Floats] | None:
        """Points, (2, n) at a time, along some leaves, no farther apart than a spacing.

        None if they are to be more than `most`.
        """
        steps = self._speeds[rows]
        steps /= spacing
        return (
            self._points(rows, steps)
            if steps.sum() + len(rows) <= most and steps.max(initial=0.0) < 2**14
            else None
        )

    def _points(self, rows: Ints, steps: Floats) -> Iterator[Floats]:
        """Points along some leaves, in that many equal steps of t or more, and in few different numbers."""
        numbers = np.ceil(steps).astype(np.uint16)
        numbers |= numbers == 0
        numbers += numbers & (numbers > 6)
        numbers += -numbers % 16 * (numbers > 16)
        keys = numbers * 2 + self._cubic[rows]
        order = np.argsort(keys, kind="stable")
        rows, keys = rows[order], keys[order]
        begins = [0, *(np.flatnonzero(keys[1:] != keys[:-1]) + 1).tolist(), len(rows)]
        for begin, end in pairwise(begins):
            for first in range(begin, end, BLOCK):
                parts = self._parts_of(rows[first : min(first + BLOCK, end)])
                number, cubic = divmod(int(keys[first]), 2)
                yield middles(parts, 2 + cubic, number)

    def _met(self, low: Floats, high: Floats, begin: int, end: int) -> Ints:
        """Which of the leaves from `begin` to `end` meet a window, counted from `begin`."""
        steps = np.zeros(end - begin + 1, dtype=np.intp)
        nodes = np.arange(len(self._levels[-1].codes))
        for height in range(len(self._levels) - 1, -1, -1):
            level = self._levels[height]
            nodes = nodes[(nodes >= begin >> height) & (nodes << height < end)]
            nodes = nodes[level.meet(nodes, low, high)]
            found = level.within(nodes, low, high) if height else np.ones(len(nodes), dtype=np.bool_)
            first, last = self._run(height, nodes[found])
            np.add.at(steps, np.maximum(first, begin) - begin, 1)
            np.add.at(steps, np.minimum(last + 1, end) - begin, -1)
            if height:
                nodes = nodes_below(nodes[~found], len(self._levels[height - 1].codes))
        return np.flatnonzero(np.cumsum(steps[:-1]))

    def _barred(self, without: Mapping[int, Ints]) -> list[Flags]:
        """Which nodes of each level hold segments to be left out; nothing if there are none."""
        nodes = np.concatenate(
            [np.empty(0, dtype=np.intp), *(rows + self._begins[place] for place, rows in without.items())]
        )
        if not len(nodes):
            return []
        flags = []
        for level in self._levels:
            flags.append(np.zeros(len(level.codes), dtype=np.bool_))
            flags[-1][nodes] = True
            nodes = parents_of(nodes)
        return flags

    def _lines(self, first: Ints, last: Ints, codes: NDArray[np.int8], leaves: Ints, counts: Ints) -> Chords:
        """Put together the chords over runs of leaves, and so many of single ones, in order."""
        lines = [np.concatenate((self._ends[:2].take(first, axis=1), self._ends[2:].take(last, axis=1))).T]
        rows, steps = [first], [np.tile((0.0, 1.0), (len(first), 1))]
        for degree in (2, 3):
            for count in distinct(counts).tolist():
                own = leaves[(counts == count) & (self._cubic[leaves] == (degree == 3))]
                if len(own):
                    samples = sample_parts(self._parts_of(own), degree, np.full(len(own), count))
                    x, y = samples.points.T.reshape(2, len(own), count + 1)
                    pieces = np.stack((x[:, :-1], y[:, :-1], x[:, 1:], y[:, 1:]), axis=2)
                    lines.append(pieces.reshape(-1, 4))
                    rows.append(np.repeat(own, count))
                    t = np.arange(count) / count
                    steps.append(np.tile(np.stack((t, t + 1 / count), axis=1), (len(own), 1)))
        at = np.concatenate(rows)
        order = np.argsort(at, kind="stable")
        at = at[order]
        finer = self._levels[0].codes[np.concatenate(rows[1:])] if len(rows) > 1 else codes[:0]
        return Chords(
            np.concatenate(lines).take(order, axis=0),
            self._owner[at],
            np.concatenate([codes, finer])[order],
            at - self._begins[self._owner[at]],
            np.concatenate(steps).take(order, axis=0),
        )

    def _steps(self, leaves: Ints, tolerance: float) -> Ints:
        """Into how many steps of t to cut some leaves: one if that was measured to do, else as the bound says."""
        steps = intervals_within(self._turning[leaves], tolerance)
        steps[self._levels[0].strays[leaves] <= tolerance] = 1
        return steps


def _rows(parts: Iterable[Floats]) -> Iterator[Floats]:
    """The coordinates of all parts of segments, one after the other, (k,) each."""
    for part in parts:
        yield from np.atleast_2d(part)


def _put(rows: Floats, places: Places, values: Iterable[Floats]) -> None:
    """Write values into some places of each row; NumPy takes longer over all rows at once."""
    for row, new in zip(rows, values, strict=True):
        row[places] = new
