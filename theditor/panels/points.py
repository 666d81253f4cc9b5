"""The points panel: every control point of the current curve in figures, to read, type, copy and paste."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import (
    QEvent,
    QItemSelection,
    QItemSelectionModel,
    QItemSelectionRange,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import (
    QColor,
    QGuiApplication,
    QIcon,
    QKeyEvent,
    QKeySequence,
    QPainter,
    QPalette,
    QPixmap,
    QShowEvent,
)
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QHeaderView,
    QLineEdit,
    QStyledItemDelegate,
    QStyleOptionHeader,
    QStyleOptionViewItem,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from theditor.model import Document, Selection, colours_for, unbreakable
from theditor.model.item_index import ModelIndex
from theditor.model.point_table import PointTable
from theditor.panels.parts import describe, tabular
from theditor.panels.rows import SWATCH
from theditor.panels.segment_model import runs
from theditor.spline.distinct import distinct

_ROW_HEIGHT = 24
_WIDTH = 116
_TIP = (
    "Control points and λ of the current curve. Type over a number, or F2 to edit it: arithmetic as in 2/3 and "
    "changes such as +1.5 or *2 are worked out; cells are copied to and pasted from spreadsheets."
)
_STANDARD = QKeySequence.StandardKey
_CUT, _COPY, _PASTE = _STANDARD.Cut, _STANDARD.Copy, _STANDARD.Paste


@unbreakable
class PointsView(QTableView):
    """A table whose cells can be copied and pasted as blocks."""

    def __init__(self, model: PointTable, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._table = model
        self.setModel(model)
        self.setItemDelegate(_CellDelegate(self))
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFont(tabular(self.font()))
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setCornerButtonEnabled(False)
        self.setTabKeyNavigation(False)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        triggers = QAbstractItemView.EditTrigger
        self.setEditTriggers(triggers.DoubleClicked | triggers.EditKeyPressed | triggers.AnyKeyPressed)
        self.setHorizontalHeader(_Titles(Qt.Orientation.Horizontal, self))
        rows, columns = self.verticalHeader(), self.horizontalHeader()
        rows.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        rows.setDefaultSectionSize(_ROW_HEIGHT)
        rows.setDefaultAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        columns.setDefaultSectionSize(_WIDTH)
        columns.setStretchLastSection(True)
        columns.setSectionsClickable(True)
        describe(self, "Control points", _TIP)

    def event(self, event: QEvent) -> bool:
        """Keep the keys of the clipboard from the commands of the window, which are for whole curves."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride and _is_ours(event):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Copy and paste blocks of cells."""
        if event.matches(_COPY):
            self.copy()
        elif event.matches(_CUT):
            self.cut()
        elif event.matches(_PASTE):
            self.paste()
        else:
            super().keyPressEvent(event)

    def copy(self) -> None:
        """Copy the selected cells as text."""
        text = self._table.copy(self._cells())
        if text:
            QGuiApplication.clipboard().setText(text)

    def cut(self) -> None:
        """Say that cells are copied, not cut: a curve has no empty cells."""
        self._table.announce.emit("Cells cannot be cut: copy them, or delete points on the canvas.")

    def paste(self) -> None:
        """Paste text into the selected cells, from their first one on."""
        cells = self._cells()
        if cells:
            columns = [column for column, _ in cells]
            rows = np.concatenate([rows for _, rows in cells])
            block = (int(rows.min()), int(rows.max())), (min(columns), max(columns))
            self._table.paste(*block, QGuiApplication.clipboard().text())

    def selected_rows(self) -> NDArray[np.intp]:
        """Rows with a selected cell, ascending."""
        return _rows_of(self.selectionModel().selection().toList())

    def _cells(self) -> list[tuple[int, NDArray[np.intp]]]:
        """Return the selected cells as columns with their rows, ascending."""
        rows: dict[int, list[NDArray[np.intp]]] = {}
        for part in self.selectionModel().selection().toList():
            for column in range(part.left(), part.right() + 1):
                rows.setdefault(column, []).append(np.arange(part.top(), part.bottom() + 1))
        return [(column, distinct(np.concatenate(rows[column]))) for column in sorted(rows)]


def _rows_of(parts: Iterable[QItemSelectionRange]) -> NDArray[np.intp]:
    """Return the rows of some ranges of cells, ascending, each once."""
    rows = [np.arange(part.top(), part.bottom() + 1) for part in parts]
    return distinct(np.concatenate(rows)) if rows else np.empty(0, dtype=np.intp)


def _is_ours(event: QKeyEvent) -> bool:
    return any(event.matches(key) for key in (_CUT, _COPY, _PASTE))


class _Titles(QHeaderView):
    """Titles of columns that look alike whatever is selected.

    To find out whether a whole column is selected Qt would ask the model about every row, at each painting.
    """

    def initStyleOptionForIndex(self, option: QStyleOptionHeader, section: int) -> None:
        option.section = section
        option.text = str(self.model().headerData(section, self.orientation()))
        role = Qt.ItemDataRole.TextAlignmentRole
        option.textAlignment = self.model().headerData(section, self.orientation(), role)


class PointsPanel(QWidget):
    """Shows the control points of the current curve, in step with the selected ones."""

    announce = Signal(str)
    """A sentence for the status line."""

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._selection = selection
        self._following = False
        self.model = PointTable(document, selection, self)
        self.table = PointsView(self.model)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 4, 0, 0)
        layout.addWidget(self.table)

        self.model.announce.connect(self.announce)
        self.table.selectionModel().selectionChanged.connect(self._select)
        document.changed.connect(self._follow)
        selection.changed.connect(self._follow)

    def sizeHint(self) -> QSize:
        """Room for a few rows."""
        return QSize(640, 160)

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with what changed while nobody saw it."""
        super().showEvent(event)
        self._follow()

    def _follow(self, *_: object) -> None:
        if self.isVisible():
            self._following = (
                True  # a reset of the model takes its selection away: that is no wish of the person's
            )
            self.model.follow()
            self._following = False
            self._show_selection()

    def _select(self) -> None:
        """Select on the curve the points whose cells are selected in the table."""
        if not self._following:
            self._selection.select(points=self.table.selected_rows(), segments=())

    def _show_selection(self) -> None:
        """Select in the table the rows of the points selected on the curve."""
        points = self._selection.chosen.get(self._selection.curve, np.empty(0, dtype=np.intp))
        if np.array_equal(self.table.selected_rows(), points):
            return
        model, last = self.table.selectionModel(), self.model.columnCount() - 1
        rows = QItemSelection()
        for start, end in runs(points):
            rows.select(self.model.index(start, 0), self.model.index(end, last))
        flags = QItemSelectionModel.SelectionFlag
        self._following = True
        model.select(rows, flags.ClearAndSelect)
        if points.size:
            first = self.model.index(int(points[0]), max(self.table.currentIndex().column(), 0))
            model.setCurrentIndex(first, flags.NoUpdate)
            self.table.scrollTo(first)
        self._following = False


class _CellDelegate(QStyledItemDelegate):
    """Shows a segment's mode with its colour and an idle λ faintly, and edits every cell as text."""

    def __init__(self, view: PointsView) -> None:
        super().__init__(view)
        self._view = view

    def initStyleOption(self, option: QStyleOptionViewItem, index: ModelIndex) -> None:
        super().initStyleOption(option, index)
        colours = colours_for(self._view.palette())
        mode = index.data(PointTable.ModeRole)
        if mode is not None:
            option.features |= QStyleOptionViewItem.ViewItemFeature.HasDecoration
            option.decorationSize = QSize(SWATCH, SWATCH)
            option.icon = QIcon(_swatch(colours.of_mode(mode), self._view.devicePixelRatio()))
        if index.data(PointTable.InactiveRole):
            for role in (QPalette.ColorRole.Text, QPalette.ColorRole.HighlightedText):
                option.palette.setColor(role, QColor(colours.secondary))

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: ModelIndex) -> QWidget:
        editor = QLineEdit(parent)
        editor.setFont(self._view.font())
        editor.setAccessibleName(index.data(PointTable.NameRole))
        return editor


def _swatch(colour: str, ratio: float) -> QPixmap:
    """Return a rounded square of a colour."""
    pixmap = QPixmap(QSize(SWATCH, SWATCH) * ratio)
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(colour))
    painter.drawRoundedRect(0, 0, SWATCH, SWATCH, 3, 3)
    painter.end()
    return pixmap
