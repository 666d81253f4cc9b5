"""The continuity panel: how smoothly segments meet at every joint, beside what the theory promises."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QEvent, QItemSelectionModel, QModelIndex, QObject, QSize, Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QAbstractItemView, QFrame, QHeaderView, QTableView, QVBoxLayout, QWidget

from theditor.model import Document, Selection, unbreakable
from theditor.model.words import sentence
from theditor.panels.continuity_model import ContinuityModel
from theditor.panels.parts import MARGIN, describe, heading, tabular
from theditor.spline import Curve, changed_segments, continuity
from theditor.spline.certificate import summary
from theditor.spline.continuity import measured_again

EMPTY = "There is no curve yet."
MOST_LIVE = 5000
"""If more segments change while a hand is on the drawing, they are measured when it lets go."""
_ROW_HEIGHT = 24
_WIDTHS = (46, 116, 76, 62, 62, 62, 74, 116)
_POSITION = 1  # takes the room that is left, for its text has no fixed length
_TIP = "Every joint, measured from both sides. Select one to select what shapes it and see it on the canvas."


@unbreakable
class ContinuityPanel(QWidget):
    """Lists the joints of the current curve; measures them only while it can be seen."""

    hovered = Signal(object)
    """The joint pointed at, as a parameter u of the current curve; None when there is none."""

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._document, self._selection = document, selection
        self._curve: Curve | None = None
        self._following = False
        self.model = ContinuityModel(self)
        self.heading = heading(EMPTY, capitals=False)
        self.heading.setWordWrap(True)
        self.heading.setContentsMargins(MARGIN, 0, MARGIN, 0)
        self.table = _table(self.model)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 8, 0, 0)
        layout.setSpacing(6)
        layout.addWidget(self.heading)
        rows = QVBoxLayout()
        rows.setContentsMargins(8, 0, 0, 0)
        rows.addWidget(self.table)
        layout.addLayout(rows)

        for watched in (self.table, self.table.viewport()):
            watched.installEventFilter(self)
        self.table.entered.connect(self._hover)
        self.table.selectionModel().currentRowChanged.connect(self._select)
        document.changed.connect(self._follow)
        document.stepped.connect(self._follow)
        selection.changed.connect(self._follow)

    def sizeHint(self) -> QSize:
        """Room for a few rows."""
        return QSize(640, 160)

    def showEvent(self, event: QShowEvent) -> None:
        """Measure what could wait while nobody saw it."""
        super().showEvent(event)
        self._follow()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Notice when neither the pointer nor the keys are on the rows any more."""
        if event.type() in (QEvent.Type.Leave, QEvent.Type.FocusOut, QEvent.Type.Hide):
            self.hovered.emit(None)
        return super().eventFilter(watched, event)

    # Following the curve

    def _follow(self, *_: object) -> None:
        if not self.isVisible():
            return
        item = self._selection.item
        curve = item.curve if item is not None else None
        if curve is not self._curve and not (self._document.before is not None and self._takes_long(curve)):
            old, self._curve = self._curve, curve
            report, rows = self.model.report, None
            if curve is None:
                report = None
            elif old is None or report is None:
                report = continuity(curve)
            else:
                report, rows = measured_again(report, old, curve)
            self._following = True
            self.model.show_report(report, rows)
            self._following = False
            self.heading.setText(EMPTY if report is None else sentence(summary(report)))
        self._mark_row()

    def _takes_long(self, curve: Curve | None) -> bool:
        """Whether very many joints are to be measured."""
        if curve is None or curve.segment_count <= MOST_LIVE:
            return False
        changed = changed_segments(self._curve, curve) if self._curve is not None else None
        return changed is None or len(changed) > MOST_LIVE

    def _mark_row(self) -> None:
        """Select the row of the joint that belongs to the selected control point, if there is just one."""
        curve, report, points = self._curve, self.model.report, self._selection.points
        row = -1
        if curve is not None and report is not None and curve.degree == 3 and len(points) == 1:
            row = next(iter(np.flatnonzero(report.number == min(points)).tolist()), -1)
        elif curve is not None and report is not None and curve.degree == 2:
            row = self._row_between(self._selection.segments)
        model = self.table.selectionModel()
        if row == (model.currentIndex().row() if model.hasSelection() else -1):
            return
        self._following = True
        if row < 0:
            model.clear()
        else:
            flags = QItemSelectionModel.SelectionFlag
            model.setCurrentIndex(self.model.index(row, 0), flags.ClearAndSelect | flags.Rows)
        self._following = False

    def _row_between(self, segments: frozenset[int]) -> int:
        """The row of the joint where just these two segments meet, −1 if they are no neighbours."""
        if len(segments) != 2 or self._curve is None or self.model.report is None:
            return -1
        count, (low, high) = self._curve.segment_count, sorted(segments)
        joint = high if high - low == 1 else 0 if (low, high) == (0, count - 1) else -1
        return next(iter(np.flatnonzero(self.model.report.joint == joint).tolist()), -1)

    # What the hand does

    def _hover(self, index: QModelIndex) -> None:
        report = self.model.report
        if report is not None and index.isValid():
            self.hovered.emit(float(report.joint[index.row()]))

    def _select(self, current: QModelIndex) -> None:
        """Select what shapes the joint of the current row: its control point, or its two segments."""
        curve, report = self._curve, self.model.report
        if self._following or curve is None or report is None or not current.isValid():
            return
        joint = int(report.joint[current.row()])
        if curve.degree == 3:
            self._selection.select(points=[int(report.number[current.row()])], segments=())
        else:
            self._selection.select(points=(), segments=[(joint - 1) % curve.segment_count, joint])
        self.hovered.emit(float(joint))


def _table(model: ContinuityModel) -> QTableView:
    table = QTableView()
    table.setModel(model)
    table.setFrameShape(QFrame.Shape.NoFrame)
    table.setFont(tabular(table.font()))
    table.setShowGrid(False)
    table.setWordWrap(False)
    table.setMouseTracking(True)
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setTabKeyNavigation(False)
    rows, columns = table.verticalHeader(), table.horizontalHeader()
    rows.hide()
    rows.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
    rows.setDefaultSectionSize(_ROW_HEIGHT)
    columns.setHighlightSections(False)
    for column, width in enumerate(_WIDTHS):
        table.setColumnWidth(column, width)
    columns.setSectionResizeMode(_POSITION, QHeaderView.ResizeMode.Stretch)
    columns.setMinimumSectionSize(min(_WIDTHS))
    describe(table, "Joints", _TIP)
    return table
