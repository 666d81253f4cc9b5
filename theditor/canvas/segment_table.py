"""The segments of several plane curves, one after the other: what they are, and what was measured of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property, partial
from itertools import cycle, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.levels import Flags, Floats, Ints, Level, Places, places_of
from theditor.canvas.raster import Along, Raster
from theditor.canvas.versions import changed_share, same_segments, whole_offset
from theditor.spline import Curve, changed_segments, joints
from theditor.spline.distinct import distinct
from theditor.spline.flatness import flatness
from theditor.spline.sampling import middles

BLOCK = 8192
"""So many segments are looked at together, as their numbers stay in the processor's cache."""
ASKED = 4
"""Of about so many curves it is seen in how much they have changed, to judge whether to follow."""
MOST_SHIFTS = 1000
"""So many times segments are moved with their curves, each time rounded, before they are measured anew."""
SLIGHT = 1e-11
"""Rounding that is no larger than this share of a curve's size is not seen, unless one zooms in very far."""


class SegmentTable:
    """The segments of plane curves; rows are their numbers where all are counted through."""

    def __init__(self, curves: Sequence[Curve], like: SegmentTable | None = None) -> None:
        """Measure the curves, but for what they share with those of another table."""
        self._curves = list(curves)
        counts = np.array([curve.segment_count for curve in curves], dtype=np.intp)
        self.begins: Ints = np.concatenate(([0], np.cumsum(counts)))
        """(curves + 1,): the row of the first segment of each curve, and how many there are in all."""
        self.owner: Ints = np.repeat(np.arange(len(curves)), counts)
        """(n,): the place of each segment's curve."""
        self.cubic = np.repeat(np.array([curve.degree == 3 for curve in curves], dtype=np.bool_), counts)
        total = len(self.owner)
        self._forms = np.empty((total, 10))  # what belongs to one segment lies together
        self.turning, self._speeds = np.empty((2, total))
        self.ends = np.empty((4, total))
        """(4, n): x and y of the start, x and y of the end."""
        self.level = Level.blank(total)
        """The segments as the leaves of a tree."""
        self._shifts = 0
        fresh = np.arange(total)
        if like is not None and like._shifts < MOST_SHIFTS:
            fresh = self._take_over(like)
        self._fill(distinct(self.owner[fresh]))
        self._measure(fresh)

    def _take_over(self, like: SegmentTable) -> Ints:
        """Copy what another table knows of segments that are the same; returns the others."""
        sources = same_segments(like._curves, like.begins, self._curves, self.begins)
        own = np.flatnonzero(sources >= 0)
        where, chosen = places_of(own), sources[own]
        self._forms[where] = like._forms.take(chosen, axis=0)
        for own_row, row in zip(self._measures(), like._measures(), strict=True):
            own_row[where] = row.take(chosen)
        self._shifts = like._shifts
        return np.flatnonzero(sources < 0)

    def _measures(self) -> list[NDArray[Any]]:
        level = self.level
        return [self.turning, self._speeds, *self.ends, *level.low, *level.high, level.strays, level.codes]

    def _fill(self, places: Ints) -> None:
        """Put some whole curves into joint form, and tell their modes."""
        if not len(places):
            return
        chosen = np.zeros(len(self._curves), dtype=np.bool_)
        chosen[places] = True
        where = places_of(np.flatnonzero(chosen[self.owner]))
        curves = [self._curves[place] for place in places.tolist()]
        forms = zip(*(curve.joint_form for curve in curves), strict=True)
        _put(self._forms.T, where, _rows(_joined(part) for part in forms))
        self.level.codes[where] = joints.codes_of_all(curves, self._forms[where, 8:].T)

    @property
    def size(self) -> int:
        """How many segments there are."""
        return len(self.owner)

    @cached_property
    def sizes(self) -> Floats:
        """Width and height of the box around each curve, (2, curves)."""
        if not self._curves:
            return np.empty((2, 0))
        sizes: Floats = np.maximum.reduceat(self.level.high, self.begins[:-1], axis=1)
        sizes -= np.minimum.reduceat(self.level.low, self.begins[:-1], axis=1)
        return sizes

    def follow(self, curves: Sequence[Curve]) -> Ints | None:
        """Become the table of other curves by changing what differs; returns which rows, ascending.

        None if too much differs; then nothing is changed.
        """
        if len(curves) != len(self._curves):
            return None
        pairs = enumerate(zip(self._curves, curves, strict=True))
        changes = [(place, old, new) for place, (old, new) in pairs if old is not new]
        if 8 * self._rough_count(changes) > self.size:
            return None
        rows, patches, count = [], [], 0
        offsets, sizes = np.zeros((2, len(curves))), self.sizes.max(axis=0)
        for place, old, new in changes:
            offset = whole_offset(old, new, SLIGHT * sizes[place])
            if offset is not None:
                offsets[:, place] = offset
                continue
            segments = changed_segments(old, new)
            if segments is None:
                return None
            count += len(segments)
            if 8 * count > self.size:
                return None
            if len(segments):
                rows.append(segments + self.begins[place])
                patches.append((new, segments))
        moved: Flags = np.any(offsets, axis=0)
        if moved.any() and self._shifts == MOST_SHIFTS:
            return None
        self._shifts += int(moved.any())
        self._curves = list(curves)
        del self.sizes
        changed = np.concatenate([np.empty(0, dtype=np.intp), *rows])
        for where, (curve, segments) in zip(rows, patches, strict=True):
            _put(self._forms.T, where, _rows(joints.take_segments(curve, segments)))
            self.level.codes[where] = curve.codes_of(segments)
        self._measure(changed)
        shifted = np.flatnonzero(moved[self.owner])
        self._shift(places_of(shifted), offsets)
        return np.sort(np.concatenate((changed, shifted))) if len(changed) else shifted

    def _rough_count(self, changes: Sequence[tuple[int, Curve, Curve]]) -> float:
        """About how many segments are to be measured anew, judged by a few of the curves that have changed."""
        some = changes[:: len(changes) // ASKED + 1]
        slight = SLIGHT * self.sizes.max(axis=0)
        share = sum(
            changed_share(old, new)
            for place, old, new in some
            if whole_offset(old, new, slight[place]) is None
        )
        counts = np.diff(self.begins)[[place for place, *_ in changes]]
        return share / max(len(some), 1) * float(counts.sum())

    def _shift(self, where: Places, offsets: Floats) -> None:
        """Move some segments by the offsets of their curves, (2, curves)."""
        own = offsets.take(self.owner[where], axis=1)
        for row, offset in zip(
            (*self.level.low, *self.level.high, *self.ends, *self._forms.T[:4]), cycle(own)
        ):
            row[where] += offset

    def _measure(self, rows: Ints) -> None:
        """Compute boxes, ends and bounds of some segments, ascending."""
        for degree in (2, 3):
            own = rows[self.cubic.take(rows) == (degree == 3)]
            for begin in range(0, len(own), BLOCK):
                self._measure_block(own[begin : begin + BLOCK], degree)

    def _measure_block(self, own: Ints, degree: int) -> None:
        """Compute boxes, ends and bounds of some segments of one degree, ascending."""
        level, where = self.level, places_of(own)
        parts = _joint_form(self._forms[where])
        start, end, stray, self.turning[where], self._speeds[where] = flatness(parts, degree)
        level.strays[where] = stray
        _put(self.ends, where, (*start, *end))
        _put(level.low, where, np.minimum(start, end) - stray)
        _put(level.high, where, np.maximum(start, end) + stray)

    def parts_of(self, rows: Ints) -> joints.Segments:
        """Some segments in joint form."""
        return _joint_form(self._forms.take(rows, axis=0))

    def points(self, rows: Ints, spacing: float, most: float) -> Along | None:
        """Points along some segments, no farther apart than a spacing; None if they are to be more than `most`."""
        steps = self._speeds.take(rows) / spacing
        few = steps.sum() + len(rows) <= most and steps.max(initial=0.0) < 2**14
        return partial(self._points, rows, steps) if few else None

    def _points(self, rows: Ints, steps: Floats, raster: Raster) -> Iterator[NDArray[np.float32]]:
        """Points along some segments, in that many equal steps of t or more, and in few different numbers."""
        numbers = np.ceil(steps).astype(np.uint16)
        numbers |= numbers == 0
        numbers += numbers & (numbers > 6)
        numbers += -numbers % 16 * (numbers > 16)
        keys = numbers * 2 + self.cubic[rows]
        order = np.argsort(keys, kind="stable")
        rows, keys = rows[order], keys[order]
        begins = [0, *(np.flatnonzero(keys[1:] != keys[:-1]) + 1).tolist(), len(rows)]
        for begin, end in pairwise(begins):
            for first in range(begin, end, BLOCK):
                parts = self.parts_of(rows[first : min(first + BLOCK, end)])
                number, cubic = divmod(int(keys[first]), 2)
                yield middles(raster.segments(parts), 2 + cubic, number)


def _joint_form(rows: Floats) -> joints.Segments:
    """Segments that lie one after the other, (k, 10), coordinate by coordinate."""
    forms = rows.T.copy()
    return joints.Segments(forms[0:2], forms[2:4], forms[4:6], forms[6:8], forms[8], forms[9])


def _joined(parts: Sequence[Floats]) -> Floats:
    return parts[0] if len(parts) == 1 else np.concatenate(parts, axis=-1)


def _rows(parts: Iterable[Floats]) -> Iterator[Floats]:
    """The coordinates of all parts of segments, one after the other, (k,) each."""
    for part in parts:
        yield from np.atleast_2d(part)


def _put(rows: Floats, places: Places, values: Iterable[Floats]) -> None:
    """Write values into some places of each row; NumPy takes longer over all rows at once."""
    for row, new in zip(rows, values, strict=True):
        row[places] = new
