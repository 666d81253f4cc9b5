"""The list of segments: each row says what it is and carries buttons for the three modes that can be set."""

from __future__ import annotations

from PySide6.QtCore import (
    QEvent,
    QPoint,
    QPointF,
    QRect,
    QRectF,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPainterPath, QPen, QPolygonF
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from theditor.model import Colours, colours_for, unbreakable
from theditor.model.item_index import ModelIndex
from theditor.model.words import MODE_LETTERS
from theditor.panels.parts import MARGIN, small_font, tabular
from theditor.panels.rows import SWATCH, RowList, paint_ground, paint_swatch
from theditor.panels.segment_model import SegmentModel
from theditor.spline import Mode

MODES = tuple(MODE_LETTERS)
KEYS = {
    Qt.Key.Key_T: Mode.TRIGONOMETRIC,
    Qt.Key.Key_H: Mode.HYPERBOLIC,
    Qt.Key.Key_I: Mode.INTERPOLATING,
}
_CELL = QSize(27, 22)
_NUMBER_WIDTH = 20
_WARNING = QSize(14, 12)


def cell_rects(row: QRect) -> dict[Mode, QRect]:
    """Where the mode buttons of a row are."""
    left = row.right() + 1 - MARGIN - len(MODES) * _CELL.width()
    top = row.top() + (row.height() - _CELL.height()) // 2
    return {mode: QRect(QPoint(left + i * _CELL.width(), top), _CELL) for i, mode in enumerate(MODES)}


@unbreakable
class SegmentList(RowList):
    """Rows of segments; `mode_clicked` when one of a row's mode buttons is clicked."""

    mode_clicked = Signal(int, object)
    """Row and mode of the button."""

    mode_key = Signal(object)
    """T, H or I was pressed: the mode to give to the selection."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(least=4, greatest=12, parent=parent)
        self.setSelectionMode(RowList.SelectionMode.ExtendedSelection)
        self.setItemDelegate(_SegmentDelegate(self))
        self.editable = True
        self.hot: tuple[int, Mode] | None = None
        self.pressed_cell: tuple[int, Mode] | None = None

    def cell_at(self, position: QPoint) -> tuple[int, Mode] | None:
        """Row and mode of the button at a place in the viewport."""
        index = self.indexAt(position)
        if not index.isValid() or not self.editable:
            return None
        cells = cell_rects(self.visualRect(index))
        return next(((index.row(), mode) for mode, cell in cells.items() if cell.contains(position)), None)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Press a button without touching the selection; elsewhere select."""
        self.pressed_cell = self.cell_at(event.position().toPoint())
        if self.pressed_cell is None or event.button() != Qt.MouseButton.LeftButton:
            self.pressed_cell = None
            super().mousePressEvent(event)
        self.viewport().update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Take the second press of a quick double press like the first."""
        if self.cell_at(event.position().toPoint()) is not None:
            self.mousePressEvent(event)
        else:
            super().mouseDoubleClickEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Show which button is under the pointer."""
        self._set_hot(self.cell_at(event.position().toPoint()))
        if self.pressed_cell is None:
            super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Click the button if it is released where it was pressed."""
        pressed, self.pressed_cell = self.pressed_cell, None
        self.viewport().update()
        if pressed is None:
            super().mouseReleaseEvent(event)
        elif pressed == self.cell_at(event.position().toPoint()):
            self.mode_clicked.emit(*pressed)

    def leaveEvent(self, event: QEvent) -> None:
        """Nothing is under the pointer any more."""
        super().leaveEvent(event)
        self._set_hot(None)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """T, H and I set the mode of the selected segments."""
        mode = KEYS.get(Qt.Key(event.key()))
        plain = event.modifiers() in (Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier)
        if mode is not None and plain:
            self.mode_key.emit(mode)
        else:
            super().keyPressEvent(event)

    def _set_hot(self, cell: tuple[int, Mode] | None) -> None:
        if cell != self.hot:
            self.hot = cell
            self.viewport().update()


@unbreakable
class _SegmentDelegate(QStyledItemDelegate):
    """Paints number, swatch, name, a warning where there is one, and the buttons."""

    def __init__(self, view: SegmentList) -> None:
        super().__init__(view)
        self._view = view

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: ModelIndex) -> None:
        colours = colours_for(self._view.palette())
        rect: QRect = option.rect
        state = option.state
        mode: Mode = index.data(SegmentModel.ModeRole)
        selected = bool(state & QStyle.StateFlag.State_Selected)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        paint_ground(painter, rect, selected, bool(state & QStyle.StateFlag.State_MouseOver), colours)

        painter.setFont(tabular(self._view.font()))
        painter.setPen(QColor(colours.text if selected else colours.secondary))
        left = rect.left() + MARGIN
        number = str(index.data(SegmentModel.NumberRole))
        width = max(_NUMBER_WIDTH, painter.fontMetrics().horizontalAdvance(number))
        vertical = Qt.AlignmentFlag.AlignVCenter
        number_rect = QRect(left, rect.top(), width, rect.height())
        painter.drawText(number_rect, vertical | Qt.AlignmentFlag.AlignRight, number)
        left += width + 8
        paint_swatch(painter, left, rect, colours.of_mode(mode))
        left += SWATCH + 10
        cells = cell_rects(rect)
        painter.setPen(QColor(colours.text))
        room = QRect(left, rect.top(), cells[MODES[0]].left() - left - 8, rect.height())
        if index.data(SegmentModel.WarningRole):
            room.setRight(room.right() - _WARNING.width() - 6)
            place = QPoint(room.right() + 6, rect.center().y() - _WARNING.height() // 2)
            _paint_warning(painter, QRectF(QRect(place, _WARNING)), colours)
            painter.setPen(QColor(colours.text))
        text = painter.fontMetrics().elidedText(index.data(), Qt.TextElideMode.ElideRight, room.width())
        painter.drawText(room, vertical, text)
        self._paint_cells(painter, index.row(), mode, cells, colours)
        painter.restore()

    def _paint_cells(
        self, painter: QPainter, row: int, mode: Mode, cells: dict[Mode, QRect], colours: Colours
    ) -> None:
        frame = QRectF(cells[MODES[0]].united(cells[MODES[-1]])).adjusted(0.5, 0.5, -0.5, -0.5)
        shape = QPainterPath()
        shape.addRoundedRect(frame, 5, 5)
        view = self._view
        if not view.editable:
            painter.setOpacity(0.45)
        painter.fillPath(shape, QColor(colours.canvas))
        for candidate, cell in cells.items():
            ground = _cell_ground(candidate == mode, (row, candidate), view, colours)
            if ground is not None:
                painter.setClipRect(cell)
                painter.fillPath(shape, ground)
                painter.setClipping(False)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(QColor(colours.border), 1.0))
        for cell in list(cells.values())[1:]:
            painter.drawLine(cell.left(), cell.top() + 1, cell.left(), cell.bottom())
        painter.drawPath(shape)
        painter.setFont(small_font(view.font()))
        for candidate, cell in cells.items():
            painter.setPen(QColor(colours.canvas if candidate == mode else colours.secondary))
            painter.drawText(cell, Qt.AlignmentFlag.AlignCenter, MODE_LETTERS[candidate])


def _paint_warning(painter: QPainter, frame: QRectF, colours: Colours) -> None:
    """Draw a triangle with an exclamation mark."""
    middle = frame.center().x()
    painter.setBrush(QColor(colours.warning))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.drawPolygon(QPolygonF([QPointF(middle, frame.top()), frame.bottomRight(), frame.bottomLeft()]))
    painter.setPen(QPen(QColor(colours.panel), 1.6))
    painter.drawLine(QPointF(middle, frame.top() + 4.5), QPointF(middle, frame.top() + 7.5))
    painter.drawPoint(QPointF(middle, frame.top() + 9.5))


def _cell_ground(chosen: bool, cell: tuple[int, Mode], view: SegmentList, colours: Colours) -> QColor | None:
    if chosen:
        return QColor(colours.accent)
    if cell == view.pressed_cell and cell == view.hot:
        return QColor(colours.border)
    return QColor(colours.selection) if cell == view.hot else None
