"""The joints of a curve as rows of a table: how smoothly segments meet there, and what was promised."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QAbstractTableModel, QObject, Qt

from theditor.model.item_index import NO_INDEX, ModelIndex
from theditor.spline import Continuity
from theditor.spline.certificate import COLUMNS


class ContinuityModel(QAbstractTableModel):
    """One row per joint."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.report: Continuity | None = None

    def show_report(self, report: Continuity | None, rows: NDArray[np.intp] | None = None) -> None:
        """Show other measurements; rows stay what they are if they are as many as before.

        Parameters
        ----------
        rows
            Those that may be others, ascending; by default all.
        """
        if report is None or self.report is None or len(report) != len(self.report):
            self.beginResetModel()
            self.report = report
            self.endResetModel()
        else:
            self.report = report
            changed = np.arange(len(report)) if rows is None else rows
            if changed.size:
                self.dataChanged.emit(
                    self.index(int(changed[0]), 0), self.index(int(changed[-1]), len(COLUMNS) - 1)
                )

    def rowCount(self, parent: ModelIndex = NO_INDEX) -> int:
        """Return the number of joints."""
        return 0 if parent.isValid() or self.report is None else len(self.report)

    def columnCount(self, parent: ModelIndex = NO_INDEX) -> int:
        """Return the number of columns."""
        return 0 if parent.isValid() else len(COLUMNS)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> object:
        """Return a column's title or, as its tooltip, what it means."""
        if orientation == Qt.Orientation.Horizontal:
            if role == Qt.ItemDataRole.DisplayRole:
                return COLUMNS[section][0]
            if role == Qt.ItemDataRole.ToolTipRole:
                return COLUMNS[section][1]
            if role == Qt.ItemDataRole.TextAlignmentRole:
                return Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        return None

    def data(self, index: ModelIndex, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        """Return what was measured, or as a tooltip the whole joint in words."""
        if self.report is None or not index.isValid():
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return COLUMNS[index.column()][2](self.report[index.row()])
        if role == Qt.ItemDataRole.ToolTipRole:
            return str(self.report[index.row()])
        return None
