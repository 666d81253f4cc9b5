"""What is selected: the current curve, its selected points, its selected segments. Never undone."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from theditor.drawing import Drawing, Item
from theditor.model.document import Document
from theditor.spline import Curve


class Selection(QObject):
    """The current curve and what is selected on it; follows the document, so that it is always valid.

    Segments are counted from 0, as in `Curve`; the window shows them from `Curve.first_segment`.
    """

    changed = Signal()
    """The current curve, the selected points or the selected segments are others."""

    def __init__(self, document: Document, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._curve = _first_visible(document.drawing)
        self._points: frozenset[int] = frozenset()
        self._segments: frozenset[int] = frozenset()
        document.changed.connect(self._follow)
        document.started.connect(self._start_anew)

    @property
    def curve(self) -> int:
        """Index of the current curve in the drawing, −1 if the drawing is empty."""
        return self._curve

    @property
    def item(self) -> Item | None:
        """The current curve with its name and style."""
        return self._document.drawing[self._curve] if self._curve >= 0 else None

    @property
    def points(self) -> frozenset[int]:
        """Selected control points of the current curve."""
        return self._points

    @property
    def segments(self) -> frozenset[int]:
        """Selected segments of the current curve."""
        return self._segments

    def select(
        self,
        *,
        curve: int | None = None,
        points: Iterable[int] | None = None,
        segments: Iterable[int] | None = None,
    ) -> None:
        """Set what is named and keep the rest; another current curve starts with nothing selected.

        Indices that do not exist are dropped.
        """
        new_curve = self._curve if curve is None else curve
        if not 0 <= new_curve < len(self._document.drawing):
            new_curve = -1
        moved = new_curve != self._curve
        new_points = frozenset(points) if points is not None else frozenset() if moved else self._points
        new_segments = (
            frozenset(segments) if segments is not None else frozenset() if moved else self._segments
        )
        self._set(new_curve, new_points, new_segments)

    def lambda_indices(self) -> NDArray[np.intp]:
        """Control points whose λ the λ controls act on, ascending.

        The selected points; if none, the points whose λ shape the selected segments; if none, all.
        """
        item = self.item
        if item is None:
            return np.empty(0, dtype=np.intp)
        if self._points:
            return np.array(sorted(self._points), dtype=np.intp)
        if self._segments:
            return shaping_points(item.curve, self._segments)
        return np.arange(len(item.curve.control_points))

    def _follow(self, old: Drawing, new: Drawing) -> None:
        curve = min(self._curve, len(new) - 1)
        if curve < 0 <= len(new) - 1:
            curve = _first_visible(new)
        same = curve == self._curve
        points, segments = (self._points, self._segments) if same else (frozenset(), frozenset())
        self._set(curve, points, segments)

    def _start_anew(self) -> None:
        self._set(_first_visible(self._document.drawing), frozenset(), frozenset())

    def _set(self, curve: int, points: frozenset[int], segments: frozenset[int]) -> None:
        if curve >= 0:
            shape = self._document.drawing[curve].curve
            points = _below(points, len(shape.control_points))
            segments = _below(segments, shape.segment_count)
        else:
            points = segments = frozenset()
        new = (curve, points, segments)
        if new != (self._curve, self._points, self._segments):
            self._curve, self._points, self._segments = new
            self._document.break_run()
            self.changed.emit()


def shaping_points(curve: Curve, segments: Iterable[int]) -> NDArray[np.intp]:
    """Control points whose λ shape any of `segments`, ascending."""
    first = np.fromiter(segments, dtype=np.intp) + curve.first_segment
    points = np.unique(np.concatenate([first, first + 1]) % len(curve.control_points))
    active: NDArray[np.intp] = points[curve.active_lambdas[points]]
    return active


def _below(indices: frozenset[int], count: int) -> frozenset[int]:
    return frozenset(i for i in indices if 0 <= i < count) if indices else indices


def _first_visible(drawing: Drawing) -> int:
    return next(
        (i for i, item in enumerate(drawing) if item.visible), len(drawing) - 1 if len(drawing) else -1
    )
