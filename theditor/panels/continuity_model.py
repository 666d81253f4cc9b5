"""The joints of a curve as rows of a table: how smoothly segments meet there, and what was promised."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QObject, QPersistentModelIndex, Qt

from theditor.model.words import number
from theditor.spline import Continuity, JointReport

ModelIndex = QModelIndex | QPersistentModelIndex
NO_INDEX = QModelIndex()

_ORDERS = "⁰¹²"


def _order(kind: str, order: int) -> str:
    return f"{kind}{_ORDERS[order]}" if order >= 0 else "—"


def _jump(order: int) -> Callable[[JointReport], str]:
    return lambda joint: small(joint.relative_jumps[order])


def _verdict(joint: JointReport) -> str:
    return f"{_order('C', joint.order)} {_order('G', joint.geometric_order)}"


def _promise(joint: JointReport) -> str:
    promised = _order("C", joint.promised)
    if not joint.holds:
        return f"✗ {promised} fails"
    return f"✓ {promised}" + (", still" if joint.note else "")


def _curvature(joint: JointReport) -> str:
    # At a joint without velocity there is no curvature that could jump.
    return small(abs(joint.curvature_jump)) if joint.curvature_jump == joint.curvature_jump else "—"


COLUMNS: tuple[tuple[str, str, Callable[[JointReport], str]], ...] = (
    ("Joint", "Its number: that of its λ", lambda joint: str(joint.number)),
    ("Position", "Where it is", lambda joint: f"({', '.join(number(x) for x in joint.position)})"),
    ("Jump of C", "Jump of the position, relative to the size of what it is made of", _jump(0)),
    ("of C′", "Jump of the first derivative, relative to the size of what it is made of", _jump(1)),
    ("of C″", "Jump of the second derivative, relative to the size of what it is made of", _jump(2)),
    ("of κ", "Jump of the curvature, in 1 / unit", _curvature),
    ("Measured", "How smooth it is: by its derivatives (C) and as a shape (G)", _verdict),
    ("Promised", "What the theory promises, and whether that holds", _promise),
)
"""Title, explanation, and the text for a joint."""


class ContinuityModel(QAbstractTableModel):
    """One row per joint."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.report: Continuity | None = None

    def show_report(self, report: Continuity | None) -> None:
        """Show other measurements; rows stay what they are if they are as many as before."""
        if report is None or self.report is None or len(report) != len(self.report):
            self.beginResetModel()
            self.report = report
            self.endResetModel()
        else:
            self.report = report
            if len(report):
                self.dataChanged.emit(self.index(0, 0), self.index(len(report) - 1, len(COLUMNS) - 1))

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


def small(size: float) -> str:
    """Write a jump with two digits: 0, 3.1e−16, 0.25."""
    return f"{size:.2g}".replace("-", "−")
