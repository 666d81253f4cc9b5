"""A part of a curve: some of its segments and what goes with them, to be painted or left out."""

from __future__ import annotations

from functools import cached_property
from operator import attrgetter

import numpy as np
from numpy.typing import NDArray

from theditor.drawing import Drawing, Item
from theditor.spline import Curve, changed_segments
from theditor.spline.changed import differing_rows

Ints = NDArray[np.intp]


class Part:
    """Some segments and control points of a curve, with the edges and joints that go with them.

    Parameters
    ----------
    curve
        Any curve with as many control points, of the same degree and ends.
    segments, points
        Their indices, ascending.
    other
        A part, if any, to which all edges and joints belong that this one has not.
    """

    def __init__(self, curve: Curve, segments: Ints, points: Ints, other: Part | None = None) -> None:
        self.segments, self.points = segments, points
        self._corners, self._closed = len(curve.control_points), curve.closed
        self._count, self._other = curve.segment_count, other

    @cached_property
    def edges(self) -> Ints:
        """Edges of the polygon, by the control point where they begin, ascending."""
        every = self._corners - (not self._closed)
        if self._other is not None:
            return _without(np.arange(every), self._other.edges)
        return _spread(self.points - 1, 2, every, closed=self._closed)

    @cached_property
    def joints(self) -> Ints:
        """Joints by the parameter u, ascending; those of a closed curve are below its number of segments."""
        every = self._count + (not self._closed)
        joints = _spread(self.segments, 2, every, closed=self._closed)
        return joints if self._other is None else _without(joints, self._other.joints)

    def rest(self, curve: Curve, segments: Ints) -> Part:
        """What does not belong to it of some segments, of all points and of all edges."""
        points = np.arange(self._corners)
        return Part(curve, _without(segments, self.segments), _without(points, self.points), self)

    def united(self, curve: Curve, other: Part) -> Part:
        """The least part that holds it and another one."""
        segments = np.union1d(self.segments, other.segments)
        return Part(curve, segments, np.union1d(self.points, other.points))

    def holds(self, other: Part) -> bool:
        """Whether all of another part belongs to it."""
        pairs = (other.segments, self.segments), (other.points, self.points)
        return all(
            np.array_equal(theirs, ours) or bool(np.isin(theirs, ours, assume_unique=True).all())
            for theirs, ours in pairs
        )


NOTHING: Ints = np.empty(0, dtype=np.intp)


def no_part(curve: Curve) -> Part:
    """The part with nothing in it."""
    return Part(curve, NOTHING, NOTHING)


def changed_parts(old: Drawing, new: Drawing, most: int) -> dict[int, Part] | None:
    """What differs between two drawings, by the curve, with the control points beside it.

    None if they do not correspond point by point, or differ in more than so many segments.
    """
    if len(old) != len(new):
        return None
    parts, count = {}, 0
    for index, (before, now) in enumerate(zip(old, new, strict=True)):
        if before is now:
            continue
        segments = changed_segments(before.curve, now.curve)
        if segments is None or not _same_style(before, now):
            return None
        count += len(segments)
        if count > most:
            return None
        points = _corners(now.curve, segments)
        if before.curve.control_points is not now.curve.control_points:
            moved = differing_rows(before.curve.control_points, now.curve.control_points)
            points = np.union1d(points, moved)
        parts[index] = Part(now.curve, segments, points)
    return parts


def _same_style(one: Item, other: Item) -> bool:
    looks = attrgetter("color", "width", "visible", "locked")
    return bool(looks(one) == looks(other))


def _corners(curve: Curve, segments: Ints) -> Ints:
    """The control points of some segments."""
    begins = segments + curve.first_segment - 1
    return _spread(begins, curve.degree + 1, len(curve.control_points), closed=curve.closed)


def _spread(begins: Ints, wide: int, count: int, *, closed: bool) -> Ints:
    """Ascending indices below `count`: all that lie less than `wide` after one of some; those before 0 come last."""
    marked = np.zeros(count, dtype=np.bool_)
    for step in range(wide):
        near = begins + step
        marked[near % count if closed else near[(near >= 0) & (near < count)]] = True
    return np.flatnonzero(marked)


def _without(indices: Ints, gone: Ints) -> Ints:
    """Those of some ascending indices that are not gone."""
    if not len(gone) or not len(indices):
        return indices
    kept = np.ones(max(int(indices[-1]), int(gone[-1])) + 1, dtype=np.bool_)
    kept[gone] = False
    return indices[kept[indices]]
