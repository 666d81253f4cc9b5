"""The control points of the current curve as a table to read and to edit: the accessible way to change everything."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QAbstractTableModel, QObject, Qt, Signal

from theditor.model import point_cells, words
from theditor.model.document import Document
from theditor.model.item_index import NO_INDEX, ModelIndex
from theditor.model.selection import Selection
from theditor.spline import Curve

_MOST_SIGNALS = 32
_TIPS = {
    "x": "Type a number, arithmetic as in 2/3, or a change: +1.5, *2",
    "y": "Type a number, arithmetic as in 2/3, or a change: +1.5, *2",
    "z": "Type a number, arithmetic as in 2/3, or a change: +1.5, *2",
    point_cells.LAMBDA: "Shape parameter: 0 is trigonometric, 1 hyperbolic, λ* interpolating",
    point_cells.MODE: "Mode of the segment that begins at the joint of this λ: type T, H or λ*",
}


class PointTable(QAbstractTableModel):
    """One row per control point; tells its views only about rows that changed.

    Every edit and every paste is one undo step of the document; one that is refused changes nothing.
    """

    ModeRole = Qt.ItemDataRole.UserRole + 1
    """Mode of the segment in a cell of the last column, None elsewhere."""

    InactiveRole = Qt.ItemDataRole.UserRole + 2
    """Whether the cell holds a λ that shapes nothing."""

    NameRole = Qt.ItemDataRole.UserRole + 3
    """What to call the cell: ``x of P₅``."""

    announce = Signal(str)
    """A sentence: why something typed or pasted was refused, or what was pasted."""

    def __init__(self, document: Document, selection: Selection, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document, self._selection = document, selection
        item = selection.item
        self.curve: Curve | None = item.curve if item is not None else None

    def rowCount(self, parent: ModelIndex = NO_INDEX) -> int:
        """Return the number of control points."""
        return 0 if parent.isValid() or self.curve is None else len(self.curve.control_points)

    def columnCount(self, parent: ModelIndex = NO_INDEX) -> int:
        """Return the number of columns: coordinates, λ, mode."""
        return 0 if parent.isValid() or self.curve is None else len(point_cells.columns(self.curve))

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> object:
        """Return a column's title and what may be typed there, or a row's control point."""
        if self.curve is None:
            return None
        if orientation == Qt.Orientation.Vertical:
            return words.indexed("P", section) if role == Qt.ItemDataRole.DisplayRole else None
        title = point_cells.columns(self.curve)[section]
        if role == Qt.ItemDataRole.DisplayRole:
            return title
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _alignment(title == point_cells.MODE)
        return _TIPS[title] if role == Qt.ItemDataRole.ToolTipRole else None

    def data(self, index: ModelIndex, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        """Return a cell in six digits or, to edit, in full; its mode; or what a screen reader says."""
        curve = self.curve
        if curve is None or not index.isValid():
            return None
        row, column = index.row(), index.column()
        is_mode = column > curve.dimension
        if role == Qt.ItemDataRole.DisplayRole:
            return self._shown(curve, row, column)
        if role == Qt.ItemDataRole.EditRole:
            return point_cells.text(curve, row, column)
        if role == self.ModeRole:
            return point_cells.mode_at(curve, row) if is_mode else None
        if role == self.NameRole:
            return point_cells.cell_name(curve, row, column)
        if role == self.InactiveRole:
            return column == curve.dimension and not curve.active_lambdas[row]
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return f"{point_cells.cell_name(curve, row, column)}: {self._shown(curve, row, column) or 'none'}"
        if role == Qt.ItemDataRole.ToolTipRole:
            return self._tip(curve, row, column)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _alignment(is_mode)
        return None

    def flags(self, index: ModelIndex) -> Qt.ItemFlag:
        """Every cell can be edited, unless the curve is locked or no segment begins there."""
        flags, curve, item = super().flags(index), self.curve, self._selection.item
        if curve is None or item is None or item.locked or not index.isValid():
            return flags
        if index.column() > curve.dimension and point_cells.segment_at(curve, index.row()) is None:
            return flags
        return flags | Qt.ItemFlag.ItemIsEditable

    def setData(self, index: ModelIndex, value: object, role: int = Qt.ItemDataRole.EditRole) -> bool:
        """Take what was typed into a cell, as one undo step; say why if it cannot stand there."""
        if role != Qt.ItemDataRole.EditRole or not self.flags(index) & Qt.ItemFlag.ItemIsEditable:
            return False
        curve, row, column = self._editable(), index.row(), index.column()
        if curve is None:
            return False
        try:
            new = point_cells.edited(curve, row, column, str(value))
        except ValueError as error:
            self.announce.emit(str(error))
            return False
        if new is curve:
            return False
        name = point_cells.cell_name(curve, row, column)
        self._document.apply_curve(f"Change {_in_sentence(name)}", self._selection.curve, new)
        return True

    def copy(self, indices: Iterable[tuple[int, NDArray[np.intp]]]) -> str:
        """Return cells as text for a spreadsheet: columns with their rows."""
        return "" if self.curve is None else point_cells.copied(self.curve, indices)

    def paste(self, rows: tuple[int, int], columns: tuple[int, int], text: str) -> None:
        """Paste cells of a spreadsheet where the selected block begins, as one undo step, or say why not.

        A single value fills the whole block.

        Parameters
        ----------
        rows, columns
            First and last of the selected block.
        """
        curve = self._editable()
        if curve is None:
            return
        cells = point_cells.cells_of(text)
        if len(cells) == 1 == len(cells[0]):
            cells = [cells[0] * (columns[1] - columns[0] + 1)] * (rows[1] - rows[0] + 1)
        try:
            new = point_cells.pasted(curve, rows[0], columns[0], cells)
        except ValueError as error:
            self.announce.emit(str(error))
            return
        what = words.counted(len(cells) * len(cells[0]), "cell")
        self._document.apply_curve(f"Paste {what}", self._selection.curve, new)
        self.announce.emit(f"Pasted {what} at {point_cells.cell_name(curve, rows[0], columns[0])}.")

    def _editable(self) -> Curve | None:
        """Return the curve as it is once what the hand does is finished; if it is locked, say so."""
        self._document.settle()
        item = self._selection.item
        if item is not None and item.locked:
            self.announce.emit(words.locked_reason(item.name))
            return None
        return item.curve if item is not None else None

    def follow(self) -> None:
        """Show the current curve as it is now; the owner asks for it whenever the table can be seen."""
        item = self._selection.item
        old, new = self.curve, item.curve if item is not None else None
        if new is old:
            return
        rows = point_cells.differing_rows(old, new) if old is not None and new is not None else None
        if rows is None:
            self.beginResetModel()
            self.curve = new
            self.endResetModel()
            return
        self.curve = new
        last = self.columnCount() - 1
        for start, end in _few_runs(rows):
            self.dataChanged.emit(self.index(start, 0), self.index(end, last))

    @staticmethod
    def _shown(curve: Curve, row: int, column: int) -> str:
        if column > curve.dimension:
            return point_cells.text(curve, row, column)
        return words.number(point_cells.value(curve, row, column))

    def _tip(self, curve: Curve, row: int, column: int) -> str:
        item = self._selection.item
        parts = [
            f"{point_cells.cell_name(curve, row, column)}: {point_cells.text(curve, row, column) or 'none'}"
        ]
        if column == curve.dimension and not curve.active_lambdas[row]:
            parts.append(words.inactive_reason(curve, [row]))
        if item is not None and item.locked:
            parts.append(words.locked_reason(item.name))
        return "\n".join(parts)


def _alignment(is_word: bool) -> Qt.AlignmentFlag:
    side = Qt.AlignmentFlag.AlignLeft if is_word else Qt.AlignmentFlag.AlignRight
    return side | Qt.AlignmentFlag.AlignVCenter


def _few_runs(rows: NDArray[np.intp]) -> list[tuple[int, int]]:
    """First and last of every run of consecutive rows; of all of them as one run if they are very many."""
    if not rows.size:
        return []
    breaks = np.flatnonzero(np.diff(rows) != 1)
    if breaks.size >= _MOST_SIGNALS:
        return [(int(rows[0]), int(rows[-1]))]
    return list(
        zip(rows[np.r_[0, breaks + 1]].tolist(), rows[np.r_[breaks, rows.size - 1]].tolist(), strict=True)
    )


def _in_sentence(name: str) -> str:
    return name[0].lower() + name[1:]
