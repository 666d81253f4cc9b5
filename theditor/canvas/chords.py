"""The curves of a drawing as chords, long where they may be and short where they must: level of detail.

Over the segments of each curve stands a binary tree. A leaf is a segment; a node above holds the run of
segments of its two children, the box around them, and how far they stray from the one chord over the whole
run. Descending from the roots, what lies outside the window is left out unseen, and a run that its chord
represents within the tolerance is drawn as that chord; only segments larger than the tolerance are sampled.
So a picture costs as many lines as the eye can tell apart, not as many as the drawing has segments.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.levels import Flags, Floats, Ints, Level, distances, longest_step, stray
from theditor.canvas.moved import whole_offset
from theditor.spline import Curve, changed_segments, enclosures, joints
from theditor.spline.distinct import distinct
from theditor.spline.sampling import intervals_within, middles, sample_parts

STEPS = 8
"""Into so many steps each segment is cut to measure how far it strays from its chords."""
CUTS = (1, 2)
"""Numbers of chords in place of one segment for which that is measured."""
BLOCK = 8192
"""So many segments are measured at a time, as their numbers stay in the processor's cache."""
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
    """The trees over several plane curves, side by side."""

    def __init__(self, curves: Sequence[Curve]) -> None:
        self._curves = list(curves)
        counts = np.array([curve.segment_count for curve in curves], dtype=np.intp)
        self._begins = np.concatenate(([0], np.cumsum(counts)))
        self._cubic = np.repeat(np.array([curve.degree == 3 for curve in curves], dtype=np.bool_), counts)
        self._owner = np.repeat(np.arange(len(curves)), counts)
        total = int(self._begins[-1])
        self._forms = np.empty((total, 10))  # what belongs to one segment lies together
        if curves:
            forms = zip(*(curve.joint_form for curve in curves), strict=True)
            _put(self._forms.T, slice(None), _rows(np.concatenate(part, axis=-1) for part in forms))
        self._turning, self._speeds = np.empty((2, total))
        self._strays = np.empty((len(CUTS), total))
        self._ends = np.empty((4, total))
        every = np.arange(total)
        codes = np.concatenate([np.empty(0, dtype=np.int8), *(curve.mode_codes for curve in curves)])
        blank = np.empty((2, total))
        self._levels = [Level(blank, blank.copy(), np.empty(total), codes, every, every, every, every)]
        self._parents: list[Ints] = []
        self._shifts = 0
        self._measure(every)
        while len(self._levels[-1].first) > len(curves):
            counts = (counts + 1) // 2
            self._grow(counts)

    @property
    def size(self) -> int:
        """How many segments there are."""
        return len(self._owner)

    @property
    def sizes(self) -> Floats:
        """Width and height of the box around each curve, (2, curves)."""
        return self._levels[-1].high - self._levels[-1].low

    def follow(self, curves: Sequence[Curve]) -> bool:
        """Become the tree over other curves by changing what differs; returns False where too much does."""
        if len(curves) != len(self._curves):
            return False
        rows, patches, count = [], [], 0
        offsets, sizes = np.zeros((2, len(curves))), self.sizes.max(axis=0)
        for place, (old, new) in enumerate(zip(self._curves, curves, strict=True)):
            if old is not new:
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
                rows.append(segments + self._begins[place])
                patches.append((new, segments))
        if offsets.any() and not self._shift(offsets):
            return False
        changed = np.concatenate([np.empty(0, dtype=np.intp), *rows])
        for where, (curve, segments) in zip(rows, patches, strict=True):
            _put(self._forms.T, where, _rows(joints.take_segments(curve, segments)))
            self._levels[0].code[where] = curve.codes_of(segments)
        self._curves = list(curves)
        self._measure(changed)
        nodes = changed
        for below, parents in enumerate(self._parents):
            nodes = distinct(parents[nodes])
            self._combine(below, nodes)
        return True

    def _shift(self, offsets: Floats) -> bool:
        """Move the curves by some offsets, (2, curves); returns False where rounding might add up to something."""
        self._shifts += 1
        if self._shifts > MOST_SHIFTS:
            return False
        for level in self._levels:
            own = offsets.take(self._owner[level.first], axis=1)
            for corner in (level.low, level.high):
                corner += own
        own = offsets.take(self._owner, axis=1)
        self._ends += np.concatenate((own, own))
        self._forms[:, :4] += np.concatenate((own, own)).T
        return True

    def _measure(self, rows: Ints) -> None:
        """Compute boxes, ends and bounds of some leaves."""
        for degree in (2, 3):
            own = rows[self._cubic.take(rows) == (degree == 3)]
            for begin in range(0, len(own), BLOCK):
                self._measure_block(own[begin : begin + BLOCK], degree)

    def _measure_block(self, own: Ints, degree: int) -> None:
        """Compute boxes, ends and bounds of some leaves of one degree."""
        leaves, parts = self._levels[0], self._parts_of(own)
        samples = sample_parts(parts, degree, np.full(len(own), STEPS))
        points = samples.points.T.reshape(2, len(own), STEPS + 1)
        points = np.ascontiguousarray(points.transpose(2, 0, 1))
        turning = enclosures.turning(parts, degree)
        unseen = turning / (8 * STEPS**2)  # how far it may be from the chords between the points
        strays = [stray(points, steps) + unseen for steps in CUTS]
        self._turning[own], leaves.strays[own] = turning, strays[0]
        self._speeds[own] = STEPS / 2 * longest_step(points[::2]) + turning / STEPS
        _put(self._strays, own, strays)
        _put(self._ends, own, (*points[0], *points[-1]))
        _put(leaves.low, own, points.min(axis=0) - unseen)
        _put(leaves.high, own, points.max(axis=0) + unseen)

    def _parts_of(self, leaves: Ints) -> joints.Segments:
        """Some leaves in joint form."""
        rows = self._forms.take(leaves, axis=0).T
        return joints.Segments(rows[0:2], rows[2:4], rows[4:6], rows[6:8], rows[8], rows[9])

    def _grow(self, counts: Ints) -> None:
        """Add the level over the last one, in which the curves have that many nodes each."""
        below = self._levels[-1]
        owners = self._owner[below.first]
        begins_below = np.searchsorted(owners, np.arange(len(counts)))
        own = np.repeat(np.arange(len(counts)), counts)
        place = np.arange(len(own)) - (np.cumsum(counts) - counts)[own]
        left = begins_below[own] + 2 * place
        end = np.append(begins_below[1:], len(owners))[own]
        right = np.minimum(left + 1, end - 1)
        parents = np.empty(len(owners), dtype=np.intp)
        parents[left] = parents[right] = np.arange(len(own))
        self._parents.append(parents)
        blank = np.empty((2, len(own)))
        self._levels.append(
            Level(
                blank,
                blank.copy(),
                np.empty(len(own)),
                np.empty(len(own), dtype=np.int8),
                below.first[left],
                below.last[right],
                left,
                right,
            )
        )
        self._combine(len(self._levels) - 2, np.arange(len(own)))

    def _combine(self, below: int, nodes: Ints) -> None:
        """Compute some nodes of a level from their children in the level below.

        A child's chord is nowhere farther from the chord over both than where the two children meet, so what
        they stray from their own adds up with that.
        """
        for begin in range(0, len(nodes), BLOCK):
            self._combine_block(self._levels[below], self._levels[below + 1], nodes[begin : begin + BLOCK])

    def _combine_block(self, children: Level, level: Level, nodes: Ints) -> None:
        left, right = level.left[nodes], level.right[nodes]
        low = np.minimum(children.low.take(left, axis=1), children.low.take(right, axis=1))
        high = np.maximum(children.high.take(left, axis=1), children.high.take(right, axis=1))
        starts, ends = self._ends[:2], self._ends[2:]
        start, middle = starts.take(level.first[nodes], axis=1), ends.take(children.last[left], axis=1)
        apart = distances(middle, start, ends.take(level.last[nodes], axis=1))
        apart[left == right] = 0.0
        level.strays[nodes] = np.maximum(children.strays[left], children.strays[right]) + apart
        one, other = children.code[left], children.code[right]
        level.code[nodes] = np.where(one == other, one, MIXED)
        _put(level.low, nodes, low)
        _put(level.high, nodes, high)

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
        nodes = np.arange(len(self._levels[-1].first))
        for height in range(len(self._levels) - 1, -1, -1):
            level = self._levels[height]
            nodes = nodes[level.meet(nodes, low, high)]
            if barred and not height:
                nodes = nodes[~barred[0][nodes]]
            if not (whole and height):
                fits = level.strays[nodes] <= tolerance
                if by_mode >= 0 and height:
                    fits &= (level.code[nodes] != MIXED) | (self._owner[level.first[nodes]] != by_mode)
                if barred and height:
                    fits &= ~barred[height][nodes]
                found = nodes[fits]
                first.append(level.first[found])
                last.append(level.last[found])
                codes.append(level.code[found])
                nodes = nodes[~fits]
                count += len(found)
            if count + len(nodes) * (2 if height else 1) > most:  # few of two children lie outside
                return None
            nodes = level.below(nodes) if height else nodes
        steps = self._steps(nodes, tolerance)
        if count + int(steps.sum()) > most:
            return None
        return self._lines(np.concatenate(first), np.concatenate(last), np.concatenate(codes), nodes, steps)

    def seen(self, place: int, low: Floats, high: Floats) -> Ints:
        """The segments of one curve whose boxes meet a window, ascending."""
        begin, end = self._begins[place : place + 2].tolist()
        return self._met(np.array([place]), low, high, begin, end)

    def leaves(self, low: Floats, high: Floats, without: Mapping[int, Ints] | None = None) -> Leaves:
        """The segments of all curves whose boxes meet a window, but for some, by the curve."""
        rows = self._met(np.arange(len(self._levels[-1].first)), low, high, 0, self.size)
        if barred := self._barred(without or {}):
            rows = rows[~barred[0][rows]]
        return Leaves(rows, self._owner[rows], self._levels[0].code[rows])

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

    def _met(self, nodes: Ints, low: Floats, high: Floats, begin: int, end: int) -> Ints:
        """Which of the leaves from `begin` to `end`, below some roots, meet a window; counted from `begin`."""
        steps = np.zeros(end - begin + 1, dtype=np.intp)
        for height in range(len(self._levels) - 1, -1, -1):
            level = self._levels[height]
            nodes = nodes[level.meet(nodes, low, high)]
            found = level.within(nodes, low, high) if height else np.ones(len(nodes), dtype=np.bool_)
            steps[level.first[nodes[found]] - begin] += 1
            steps[level.last[nodes[found]] - begin + 1] -= 1
            nodes = level.below(nodes[~found])
        return np.flatnonzero(np.cumsum(steps[:-1]))

    def _barred(self, without: Mapping[int, Ints]) -> list[Flags]:
        """Which nodes of each level hold segments to be left out; nothing if there are none."""
        nodes = np.concatenate(
            [np.empty(0, dtype=np.intp), *(rows + self._begins[place] for place, rows in without.items())]
        )
        if not len(nodes):
            return []
        flags = []
        for level, parents in zip(self._levels, [*self._parents, None], strict=True):
            flags.append(np.zeros(len(level.first), dtype=np.bool_))
            flags[-1][nodes] = True
            nodes = nodes if parents is None else distinct(parents[nodes])
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
        finer = self._levels[0].code[np.concatenate(rows[1:])] if len(rows) > 1 else codes[:0]
        return Chords(
            np.concatenate(lines).take(order, axis=0),
            self._owner[at],
            np.concatenate([codes, finer])[order],
            at - self._begins[self._owner[at]],
            np.concatenate(steps).take(order, axis=0),
        )

    def _steps(self, leaves: Ints, tolerance: float) -> Ints:
        """Into how many steps of t to cut some leaves: as few as were measured to do, else as the bound says."""
        steps = intervals_within(self._turning[leaves], tolerance)
        for column, few in reversed(tuple(enumerate(CUTS))):
            steps[self._strays[column, leaves] <= tolerance] = few
        return steps


def _rows(parts: Iterable[Floats]) -> list[Floats]:
    """The coordinates of all parts of segments, one after the other, (k,) each."""
    return [row for part in parts for row in np.atleast_2d(part)]


def _put(rows: Floats, places: Ints | slice, values: Iterable[Floats]) -> None:
    """Write values into some places of each row; NumPy takes longer over all rows at once."""
    for row, new in zip(rows, values, strict=True):
        row[places] = new
