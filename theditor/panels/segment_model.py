"""The segments of the current curve as rows for a list."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from PySide6.QtCore import QAbstractListModel, QModelIndex, QObject, QPersistentModelIndex, Qt

from theditor.model import words
from theditor.spline import Curve, Mode

ModelIndex = QModelIndex | QPersistentModelIndex
NO_INDEX = QModelIndex()


class SegmentModel(QAbstractListModel):
    """One row per segment; tells its views only about the rows whose mode changed."""

    ModeRole = Qt.ItemDataRole.UserRole + 1
    NumberRole = Qt.ItemDataRole.UserRole + 2

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.curve: Curve | None = None
        self.locked_reason = ""
        self._formerly: dict[int, Mode] = {}

    def rowCount(self, parent: ModelIndex = NO_INDEX) -> int:
        """Return the number of segments."""
        return 0 if parent.isValid() or self.curve is None else self.curve.segment_count

    def data(self, index: ModelIndex, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        """Return mode in words, mode, number, or what a screen reader and the tooltip say."""
        curve, row = self.curve, index.row()
        if curve is None or not index.isValid():
            return None
        number = row + curve.first_segment
        if role == self.NumberRole:
            return number
        if role == self.ModeRole:
            return self.mode(row)
        if role == Qt.ItemDataRole.DisplayRole:
            return self.text(row)
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return f"Segment {number}, {self.text(row)}"
        if role == Qt.ItemDataRole.ToolTipRole:
            return self.locked_reason or f"Segment {number}: {self.text(row)}, shaped by {self._lambdas(row)}"
        return None

    def mode(self, row: int) -> Mode:
        """Return the mode of a segment."""
        assert self.curve is not None
        return self.curve.modes[row]

    def text(self, row: int) -> str:
        """Name a segment's mode, and what it was if the last toggle of a neighbour made it a blend."""
        name = self.mode(row).value
        former = self._formerly.get(row)
        return name if former is None else f"{name} · was {former.value}"

    def show_curve(self, curve: Curve | None) -> None:
        """Show another curve, or the same one changed."""
        old = self.curve
        self._set_formerly({})
        if old is None or curve is None or _numbering(old) != _numbering(curve):
            self.beginResetModel()
            self.curve = curve
            self.endResetModel()
            return
        self.curve = curve
        if curve.lambdas is not old.lambdas or curve.degree != old.degree:
            self._tell(np.flatnonzero(curve.mode_codes != old.mode_codes).tolist())

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


def runs(rows: Iterable[int]) -> list[tuple[int, int]]:
    """First and last of every run of consecutive numbers among ascending `rows`."""
    array = np.fromiter(rows, dtype=np.intp)
    if not array.size:
        return []
    breaks = np.flatnonzero(np.diff(array) != 1)
    firsts = array[np.r_[0, breaks + 1]]
    lasts = array[np.r_[breaks, array.size - 1]]
    return list(zip(firsts.tolist(), lasts.tolist(), strict=True))


def _numbering(curve: Curve) -> tuple[int, int]:
    return curve.segment_count, curve.first_segment
