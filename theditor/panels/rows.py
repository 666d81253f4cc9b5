"""Lists whose rows are painted: as high as their rows, and what every row shows alike."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QModelIndex, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QResizeEvent
from PySide6.QtWidgets import QHeaderView, QTableView, QWidget

from theditor.model import Colours

ROW_HEIGHT = 28
SWATCH = 12


class RowList(QTableView):
    """A list as high as its rows, between a least and a greatest number of them; then it scrolls.

    It is a table of one column, since that asks the model only about rows that can be seen; a list view would ask
    about every row to lay them out.
    """

    def __init__(self, least: int, greatest: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._least, self._greatest = least, greatest
        self.setMouseTracking(True)
        self.setVerticalScrollMode(QTableView.ScrollMode.ScrollPerPixel)
        self.setSelectionBehavior(QTableView.SelectionBehavior.SelectRows)
        self.setFrameShape(QTableView.Shape.NoFrame)
        self.setShowGrid(False)
        self.setTabKeyNavigation(False)
        rows, columns = self.verticalHeader(), self.horizontalHeader()
        rows.hide()
        rows.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        rows.setDefaultSectionSize(ROW_HEIGHT)
        columns.hide()
        columns.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)

    def sizeHint(self) -> QSize:
        """As high as the rows it holds, within its limits."""
        model = self.model()
        rows = model.rowCount() if model is not None else 0
        return QSize(240, self._height(min(max(rows, self._least), self._greatest)))

    def minimumSizeHint(self) -> QSize:
        """High enough for the least number of rows."""
        return QSize(200, self._height(self._least))

    def moveCursor(self, action: QTableView.CursorAction, modifiers: Qt.KeyboardModifier) -> QModelIndex:
        """Home and End go to the first and the last row: there is but one column."""
        ends = {
            QTableView.CursorAction.MoveHome: 0,
            QTableView.CursorAction.MoveEnd: self.model().rowCount() - 1,
        }
        return (
            self.model().index(ends[action], 0) if action in ends else super().moveCursor(action, modifiers)
        )

    def changeEvent(self, event: QEvent) -> None:
        """Repaint in the new colours."""
        super().changeEvent(event)
        self.viewport().update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the current row in sight when the list shrinks."""
        super().resizeEvent(event)
        current = self.currentIndex()
        if current.isValid() and self.selectionModel().isSelected(current):
            self.scrollTo(current)

    def _height(self, rows: int) -> int:
        return rows * ROW_HEIGHT + 2 * self.frameWidth()


def swatch_outline(colours: Colours) -> QColor:
    """Return the colour that outlines swatches of people's own colours."""
    outline = QColor(colours.secondary)
    outline.setAlphaF(0.55)
    return outline


def paint_ground(painter: QPainter, rect: QRect, selected: bool, hovered: bool, colours: Colours) -> None:
    """Fill a row's ground: selected, under the pointer, or plain."""
    ground = QColor(colours.selection if selected or hovered else colours.panel)
    if hovered and not selected:
        painter.fillRect(rect, QColor(colours.panel))
        ground.setAlphaF(0.45)
    painter.fillRect(rect, ground)


def paint_swatch(
    painter: QPainter, left: int, rect: QRect, colour: str, outline: QColor | None = None
) -> None:
    """Draw a rounded square of a colour, in the middle of a row; outlined if it may resemble the ground."""
    painter.setPen(Qt.PenStyle.NoPen if outline is None else QPen(outline, 1.0))
    painter.setBrush(QColor(colour))
    top = rect.top() + (rect.height() - SWATCH) / 2
    inset = 0.0 if outline is None else 0.5
    square = QRectF(left, top, SWATCH, SWATCH).adjusted(inset, inset, -inset, -inset)
    painter.drawRoundedRect(square, 3, 3)
