"""Lists whose rows are painted: as high as their rows, and what every row shows alike."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QResizeEvent
from PySide6.QtWidgets import QListView, QWidget

from theditor.model import Colours

ROW_HEIGHT = 28
SWATCH = 12


class RowList(QListView):
    """A list as high as its rows, between a least and a greatest number of them; then it scrolls."""

    def __init__(self, least: int, greatest: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._least, self._greatest = least, greatest
        self.setUniformItemSizes(True)
        self.setMouseTracking(True)
        self.setVerticalScrollMode(QListView.ScrollMode.ScrollPerPixel)
        self.setFrameShape(QListView.Shape.NoFrame)

    def sizeHint(self) -> QSize:
        """As high as the rows it holds, within its limits."""
        model = self.model()
        rows = model.rowCount() if model is not None else 0
        return QSize(240, self._height(min(max(rows, self._least), self._greatest)))

    def minimumSizeHint(self) -> QSize:
        """High enough for the least number of rows."""
        return QSize(200, self._height(self._least))

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
