"""What is selected: the current curve, other curves beside it, control points and segments. Never undone."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from theditor.drawing import Drawing, Item
from theditor.drawing.change import common_ends
from theditor.model.document import Document
from theditor.spline import Curve
from theditor.spline.changed import common_rows
from theditor.spline.distinct import distinct

Ints = NDArray[np.intp]


class Selection(QObject):
    """The current curve, and what is selected on it and on others; follows the document, so that it is always valid.

    Each selected curve has its selected control points, possibly none: then it was chosen as a whole. The current
    curve, which the panels show, is always one of them. Segments are selected on the current curve alone; they
    are counted from 0, as in `Curve`, and the window shows them from `Curve.first_segment`.
    """

    changed = Signal()
    """The current curve, or what is selected, is another."""

    def __init__(self, document: Document, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._curve = -1
        self._chosen: dict[int, Ints] = {}
        self._segments: frozenset[int] = frozenset()
        self._points: frozenset[int] | None = None
        self._movable: tuple[Drawing, dict[int, Ints], dict[int, Ints]] | None = None
        self._start_anew()
        document.changed.connect(self._follow)
        document.started.connect(self._start_anew)

    @property
    def curve(self) -> int:
        """Index of the current curve in the drawing, −1 if the drawing is empty."""
        return self._curve

    @property
    def drawing(self) -> Drawing:
        """The drawing in which things are selected."""
        return self._document.drawing

    @property
    def item(self) -> Item | None:
        """The current curve with its name and style."""
        return self._document.drawing[self._curve] if self._curve >= 0 else None

    @property
    def points(self) -> frozenset[int]:
        """Selected control points of the current curve."""
        if self._points is None:
            self._points = frozenset(self._chosen[self._curve].tolist()) if self._curve >= 0 else frozenset()
        return self._points

    @property
    def segments(self) -> frozenset[int]:
        """Selected segments of the current curve."""
        return self._segments

    @property
    def curves(self) -> tuple[int, ...]:
        """Selected curves, ascending; the current one is among them."""
        return tuple(self._chosen)

    @property
    def chosen(self) -> Mapping[int, Ints]:
        """Selected control points of every selected curve, both ascending; none where it is chosen as a whole."""
        return self._chosen

    @property
    def across(self) -> dict[int, Ints]:
        """Selected control points by their curve, both ascending; only curves that have some."""
        return {curve: points for curve, points in self._chosen.items() if points.size}

    @property
    def movable(self) -> dict[int, Ints]:
        """As `across`, of the curves that may be edited on the canvas: visible and not locked."""
        drawing = self._document.drawing
        if self._movable is None or self._movable[0] is not drawing or self._movable[1] is not self._chosen:
            # Every command that needs points asks for them, after each change.
            movable = {i: points for i, points in self.across.items() if _is_open(drawing[i])}
            self._movable = drawing, self._chosen, movable
        return dict(self._movable[2])

    @property
    def in_hand(self) -> dict[int, Ints]:
        """What arranging acts on: as `movable`; if no point is selected, all points of the selected curves."""
        drawing = self._document.drawing
        return self.movable or {
            i: np.arange(len(drawing[i].curve.control_points)) for i in self.curves if _is_open(drawing[i])
        }

    @property
    def count(self) -> int:
        """How many control points are selected, on all curves."""
        return sum(points.size for points in self._chosen.values())

    def select(
        self,
        *,
        curve: int | None = None,
        points: Iterable[int] | None = None,
        segments: Iterable[int] | None = None,
    ) -> None:
        """Select on one curve alone: set what is named and keep the rest; another curve starts with nothing selected.

        Indices that do not exist are dropped.
        """
        new = self._curve if curve is None else curve
        moved = new != self._curve
        kept = _NOTHING if moved else self._chosen.get(new, _NOTHING)
        chosen = kept if points is None else _ascending(points)
        if segments is None:
            segments = () if moved else self._segments
        self._set(new, {new: chosen}, frozenset(segments))

    def select_across(
        self,
        points: Mapping[int, Iterable[int]],
        curve: int | None = None,
        segments: Iterable[int] | None = None,
    ) -> None:
        """Select control points on several curves, none for a curve that is chosen as a whole.

        Parameters
        ----------
        points
            Control points by their curve, in any order.
        curve
            The current curve to be; by default it stays. It gives way to the topmost curve that has points selected
            if there is nothing selected on it.
        segments
            Segments of the current curve; by default they stay as long as it does.
        """
        new = self._curve if curve is None else curve
        count = len(self._document.drawing)
        chosen = {i: _ascending(of) for i, of in points.items() if 0 <= i < count}
        if segments is None:
            segments = self._segments if new == self._curve else ()
        if not (segments or chosen.get(new, _NOTHING).size):
            new = max((i for i, of in chosen.items() if of.size), default=new)
        self._set(new, chosen, frozenset(segments))

    def toggle(self, curve: int, point: int) -> None:
        """Add a control point to what is selected, or take it away; its curve becomes current."""
        points = np.setxor1d(self._chosen.get(curve, _NOTHING), [point])
        self.select_across({**self._chosen, curve: points}, curve)

    def remember(self) -> Callable[[], None]:
        """Return what selects once more just what is selected now."""
        return partial(self._set, self._curve, self._chosen, self._segments)

    def lambda_indices(self) -> Ints:
        """Control points of the current curve whose λ the λ controls act on, ascending.

        The selected points; if none, the points whose λ shape the selected segments; if none, all.
        """
        return self.lambdas_across().get(self._curve, _NOTHING)

    def lambdas_across(self) -> dict[int, Ints]:
        """Control points whose λ the λ controls act on, by their curve: as `lambda_indices`, of all selected curves.

        Curves other than the current one take part only while they are visible and not locked.
        """
        drawing = self._document.drawing
        everything = not self._segments and not self.across
        result: dict[int, Ints] = {}
        for i, points in self._chosen.items():
            curve = drawing[i].curve
            if i != self._curve and not _is_open(drawing[i]):
                continue
            if points.size:
                result[i] = points
            elif everything:
                result[i] = np.arange(len(curve.control_points))
            elif i == self._curve and self._segments:
                result[i] = shaping_points(curve, self._segments)
        return result

    def _follow(self, old: Drawing, new: Drawing) -> None:
        place = _places(old, new, self._chosen)
        curve = place.get(self._curve, min(self._curve, len(new) - 1))
        if curve < 0 <= len(new) - 1:
            curve = _first_visible(new)
        chosen = {
            now: _points_after(self._chosen[i], old[i].curve, new[now].curve) for i, now in place.items()
        }
        segments: frozenset[int] = frozenset()
        if self._curve in place:
            segments = _segments_after(self._segments, old[self._curve].curve, new[curve].curve)
        self._set(curve, chosen, segments)

    def _start_anew(self) -> None:
        first = _first_visible(self._document.drawing)
        self._set(first, {}, frozenset())

    def _set(self, curve: int, chosen: dict[int, Ints], segments: frozenset[int]) -> None:
        drawing = self._document.drawing
        if not 0 <= curve < len(drawing):
            curve, chosen, segments = -1, {}, frozenset()
        else:
            chosen = {curve: _NOTHING, **{i: of for i, of in chosen.items() if 0 <= i < len(drawing)}}
            chosen = {i: self._valid(i, chosen[i], current=i == curve) for i in sorted(chosen)}
            segments = _below(segments, drawing[curve].curve.segment_count)
        if (curve, segments) != (self._curve, self._segments) or not _same(chosen, self._chosen):
            self._curve, self._chosen, self._segments = curve, chosen, segments
            self._points = None
            self._document.break_run()
            self.changed.emit()

    def _valid(self, curve: int, points: Ints, *, current: bool) -> Ints:
        """Those of some points that exist, and can be seen and edited unless the curve is the current one."""
        item = self._document.drawing[curve]
        if not current and not _is_open(item):
            return _NOTHING
        count = len(item.curve.control_points)
        if points.size and (points[0] < 0 or points[-1] >= count):
            return points[(points >= 0) & (points < count)]
        return points


def shaping_points(curve: Curve, segments: Iterable[int]) -> Ints:
    """Control points whose λ shape any of `segments`, ascending."""
    first = np.fromiter(segments, dtype=np.intp) + curve.first_segment
    points = distinct(np.concatenate([first, first + 1]) % len(curve.control_points))
    active: Ints = points[curve.active_lambdas[points]]
    return active


_NOTHING: Ints = np.empty(0, dtype=np.intp)


def _is_open(item: Item) -> bool:
    return item.visible and not item.locked


def _ascending(points: Iterable[int]) -> Ints:
    """Indices in ascending order, each once."""
    array: Ints = points if isinstance(points, np.ndarray) else np.fromiter(points, dtype=np.intp)
    return array if (array[1:] > array[:-1]).all() else distinct(array)


def _same(a: dict[int, Ints], b: dict[int, Ints]) -> bool:
    return a.keys() == b.keys() and all(a[i] is b[i] or np.array_equal(a[i], b[i]) for i in a)


def _places(old: Drawing, new: Drawing, curves: Iterable[int]) -> dict[int, int]:
    """Where some curves of a drawing are in another that came of it; those that are gone have no place.

    An item that is there unchanged is found wherever it is. The rest were edited: they are those that are new there,
    in the same order, unless these are fewer.
    """
    start, same_end = common_ends(old, new)
    before, after = range(start, len(old) - same_end), range(start, len(new) - same_end)
    moved = {id(new[i]): i for i in after}
    known = {id(old[i]) for i in before}
    edited = [i for i in before if id(old[i]) not in moved]
    fresh = [i for i in after if id(new[i]) not in known]
    places = dict(zip(edited, fresh, strict=False)) if len(edited) <= len(fresh) else {}
    places.update((i, moved[id(old[i])]) for i in before if id(old[i]) in moved)
    longer = len(new) - len(old)
    result: dict[int, int] = {}
    for i in curves:
        if i < start:
            result[i] = i
        elif i >= before.stop:
            result[i] = i + longer
        elif i in places:
            result[i] = places[i]
    return result


def _points_after(points: Ints, old: Curve, new: Curve) -> Ints:
    """Which control points of an edited curve are some of the old one, where others came or went in between."""
    head, tail = _common_points(old, new) if points.size else (0, 0)
    if not head and not tail:
        return points
    late = points[points >= tail] + len(new.control_points) - len(old.control_points)
    return np.concatenate((points[points < head], late))


def _segments_after(segments: frozenset[int], old: Curve, new: Curve) -> frozenset[int]:
    """The same of segments: those are kept of which all control points are."""
    head, tail = _common_points(old, new) if segments else (0, 0)
    if not head and not tail:
        return segments
    longer = len(new.control_points) - len(old.control_points)
    first = old.first_segment - 1
    early = {s for s in segments if s + first + old.degree < head}
    return frozenset(early | {s + longer for s in segments if s + first >= tail})


def _common_points(old: Curve, new: Curve) -> tuple[int, int]:
    """Up to which control point, and again from which one, an edited curve has those of the old one.

    (0, 0) if it has as many of them, or none in common.
    """
    before, after = old.control_points, new.control_points
    if len(before) == len(after) or old.dimension != new.dimension:
        return 0, 0
    head = common_rows(before, after)
    tail = min(common_rows(before[::-1], after[::-1]), min(len(before), len(after)) - head)
    return (head, len(before) - tail) if head or tail else (0, 0)


def _below(indices: frozenset[int], count: int) -> frozenset[int]:
    return frozenset(i for i in indices if 0 <= i < count) if indices else indices


def _first_visible(drawing: Drawing) -> int:
    return next(
        (i for i, item in enumerate(drawing) if item.visible), len(drawing) - 1 if len(drawing) else -1
    )
