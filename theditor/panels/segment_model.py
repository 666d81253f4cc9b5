"""The segments of the current curve as rows for a list."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from PySide6.QtCore import QAbstractListModel, QObject, Qt

from theditor.model import words
from theditor.model.item_index import NO_INDEX, ModelIndex
from theditor.panels.guarded import NegativeBasis
from theditor.spline import Curve, Kind, Mode, changed_segments, recognise_segments

_BLOCK = 16
"""Rows that are named together: about as many as are visible."""
_GENERAL = (Kind.TRIGONOMETRIC, Kind.HYPERBOLIC)


class SegmentModel(QAbstractListModel):
    """One row per segment, named by what it is; tells its views only about rows whose segment changed.

    Names are found when a view asks for them, and kept until their segments change.
    """

    ModeRole = Qt.ItemDataRole.UserRole + 1
    NumberRole = Qt.ItemDataRole.UserRole + 2
    WarningRole = Qt.ItemDataRole.UserRole + 3

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.curve: Curve | None = None
        self.locked_reason = ""
        self._formerly: dict[int, Mode] = {}
        self._names: dict[int, str] = {}
        self._negative = NegativeBasis()

    def rowCount(self, parent: ModelIndex = NO_INDEX) -> int:
        """Return the number of segments."""
        return 0 if parent.isValid() or self.curve is None else self.curve.segment_count

    def data(self, index: ModelIndex, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        """Return name, mode, number, why the row is marked, or what a screen reader and the tooltip say."""
        curve, row = self.curve, index.row()
        if curve is None or not index.isValid():
            return None
        number = row + curve.first_segment
        if role == self.NumberRole:
            return number
        if role == self.ModeRole:
            return self.mode(row)
        if role == self.WarningRole:
            return self.warning(row)
        if role == Qt.ItemDataRole.DisplayRole:
            return self.text(row)
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return ". ".join(filter(None, [f"Segment {number}, {self.text(row)}", self.warning(row)]))
        if role == Qt.ItemDataRole.ToolTipRole:
            mode = self.mode(row).value
            kind = "" if self._name(row) == mode else f" ({mode})"
            what = f"Segment {number}: {self.text(row)}{kind}, shaped by {self._lambdas(row)}"
            return "\n".join(filter(None, [self.locked_reason or what, self.warning(row)]))
        return None

    def mode(self, row: int) -> Mode:
        """Return the mode of a segment."""
        assert self.curve is not None
        return self.curve.mode_at(row)

    def warning(self, row: int) -> str:
        """Say why the convex hull does not bound a segment; nothing where it does."""
        assert self.curve is not None
        reason = self._negative.reason(self.curve, row)
        return reason[:1].upper() + reason[1:]

    def text(self, row: int) -> str:
        """Name a segment, and what mode it had if the last toggle of a neighbour made it a blend."""
        name = self._name(row)
        former = self._formerly.get(row)
        return name if former is None else f"{name} · was {former.value}"

    def _name(self, row: int) -> str:
        """Return the segment's own name, or its mode if it has none."""
        if row not in self._names:
            assert self.curve is not None
            start = row - row % _BLOCK
            end = min(start + _BLOCK, self.curve.segment_count)
            rows = [r for r in range(start, end) if r not in self._names]
            for each, found in zip(rows, recognise_segments(self.curve, rows), strict=True):
                named = found if found and found.kind not in _GENERAL else None
                self._names[each] = named.name if named else self.mode(each).value
        return self._names[row]

    def show_curve(self, curve: Curve | None) -> None:
        """Show another curve, or the same one changed."""
        old = self.curve
        self._set_formerly({})
        if old is None or curve is None or _numbering(old) != _numbering(curve):
            self.beginResetModel()
            self.curve, self._names = curve, {}
            self.endResetModel()
            return
        changed = changed_segments(old, curve)
        rows = np.arange(curve.segment_count) if changed is None else changed
        self.curve = curve
        if rows.size:
            known = np.array(list(self._names), dtype=np.intp)
            for row in known[np.isin(known, rows)].tolist():
                del self._names[row]
            # One signal for all: a view repaints only what is visible of the range.
            self.dataChanged.emit(self.index(int(rows[0])), self.index(int(rows[-1])))

    def show_formerly(self, formerly: dict[int, Mode]) -> None:
        """Say of these segments what they were, until the curve changes again."""
        self._set_formerly(formerly)

    def _set_formerly(self, formerly: dict[int, Mode]) -> None:
        touched = sorted({*self._formerly, *formerly})
        self._formerly = formerly
        self._tell(touched)

    def _tell(self, rows: list[int]) -> None:
        for first, last in runs(rows):
            self.dataChanged.emit(self.index(first), self.index(last))

    def _lambdas(self, row: int) -> str:
        assert self.curve is not None
        indices = [i for i in self.curve.lambda_indices(row) if i is not None]
        return words.listed([words.indexed("λ", i) for i in indices]) if indices else "no λ"


def runs(rows: ArrayLike) -> list[tuple[int, int]]:
    """First and last of every run of consecutive numbers among ascending `rows`."""
    array = np.asarray(rows, dtype=np.intp)
    if not array.size:
        return []
    breaks = np.flatnonzero(np.diff(array) != 1)
    firsts = array[np.r_[0, breaks + 1]]
    lasts = array[np.r_[breaks, array.size - 1]]
    return list(zip(firsts.tolist(), lasts.tolist(), strict=True))


def _numbering(curve: Curve) -> tuple[int, int]:
    return curve.segment_count, curve.first_segment
