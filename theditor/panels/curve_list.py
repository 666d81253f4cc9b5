"""The list of curves: eye, colour, name and lock in every row."""

from __future__ import annotations

from PySide6.QtCore import (
    QAbstractListModel,
    QModelIndex,
    QObject,
    QPoint,
    QPointF,
    QRect,
    QRectF,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPainterPath, QPaintEvent, QPen
from PySide6.QtWidgets import (
    QApplication,
    QLineEdit,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from theditor.drawing import Drawing, Item
from theditor.drawing.change import common_ends
from theditor.drawing.drawing import NAME_LENGTH
from theditor.model import colours_for
from theditor.model.item_index import NO_INDEX, ModelIndex
from theditor.panels.parts import MARGIN
from theditor.panels.rows import ROW_HEIGHT, SWATCH, RowList, paint_ground, paint_swatch, swatch_outline

_ICON = 20
_LEAST_ROWS = 3
_STRIPE = 3
"""Width of the stripe that marks the current curve, one of several selected ones."""


class CurveModel(QAbstractListModel):
    """One row per curve of a drawing; tells its views only about the rows that changed."""

    ItemRole = Qt.ItemDataRole.UserRole + 1

    renamed = Signal(int, str)
    """A name was typed for a row."""

    def __init__(self, drawing: Drawing, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.drawing = drawing

    def rowCount(self, parent: ModelIndex = NO_INDEX) -> int:
        """Return the number of curves."""
        return 0 if parent.isValid() else len(self.drawing)

    def data(self, index: ModelIndex, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        """Return name, item, or what a screen reader and the tooltip say."""
        if not index.isValid():
            return None
        item = self.drawing[index.row()]
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.EditRole):
            return item.name
        if role == self.ItemRole:
            return item
        if role in (Qt.ItemDataRole.AccessibleTextRole, Qt.ItemDataRole.ToolTipRole):
            return _described(item)
        return None

    def setData(self, index: ModelIndex, value: object, role: int = Qt.ItemDataRole.EditRole) -> bool:
        """Ask for a new name; the drawing answers, or not."""
        if role != Qt.ItemDataRole.EditRole or value == self.drawing[index.row()].name:
            return False
        self.renamed.emit(index.row(), str(value))
        return True

    def flags(self, index: ModelIndex) -> Qt.ItemFlag:
        """Names can be edited unless the curve is locked."""
        flags = super().flags(index)
        locked = index.isValid() and self.drawing[index.row()].locked
        return flags if locked else flags | Qt.ItemFlag.ItemIsEditable

    def show_drawing(self, drawing: Drawing) -> None:
        """Show another drawing, or the same one changed."""
        old = self.drawing
        if len(old) == len(drawing):
            self.drawing = drawing
            for row, (before, after) in enumerate(zip(old, drawing, strict=True)):
                if before is not after and _look(before) != _look(after):
                    self.dataChanged.emit(self.index(row), self.index(row))
            return
        start, stop = common_ends(old, drawing)
        kept = drawing[:start] + old[len(old) - stop :]
        if len(kept) < len(old):
            self.beginRemoveRows(QModelIndex(), start, len(old) - stop - 1)
            self.drawing = Drawing(kept)
            self.endRemoveRows()
        if len(kept) < len(drawing):
            self.beginInsertRows(QModelIndex(), start, len(drawing) - stop - 1)
            self.drawing = drawing
            self.endInsertRows()
        self.drawing = drawing


def _look(item: Item) -> tuple[object, ...]:
    return item.name, item.color, item.visible, item.locked


def _described(item: Item) -> str:
    states = [state for state, holds in (("hidden", not item.visible), ("locked", item.locked)) if holds]
    return ", ".join([item.name, *states])


def eye_rect(row: QRect) -> QRect:
    """Where the eye of a row is."""
    return QRect(row.left() + MARGIN - 4, row.top() + (row.height() - _ICON) // 2, _ICON, _ICON)


def lock_rect(row: QRect) -> QRect:
    """Where the lock of a row is."""
    return QRect(row.right() + 1 - MARGIN - _ICON + 4, row.top() + (row.height() - _ICON) // 2, _ICON, _ICON)


class CurveList(RowList):
    """Rows of curves, with an eye and a lock to click."""

    eye_clicked = Signal(int)
    """The eye of this row was clicked."""

    lock_clicked = Signal(int)
    """The lock of this row was clicked."""

    swatch_clicked = Signal(int)
    """The colour of this row was clicked twice."""

    dragged = Signal(int, int)
    """A row was dragged to another place, counted without it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(least=1, greatest=5, parent=parent)
        self.setSelectionMode(RowList.SelectionMode.ExtendedSelection)
        triggers = RowList.EditTrigger
        self.setEditTriggers(triggers.DoubleClicked | triggers.EditKeyPressed)
        self.setItemDelegate(_CurveDelegate(self))
        self._dragged = self._gap = -1
        self._pressed_at = 0

    def minimumSizeHint(self) -> QSize:
        """High enough for some rows, if there are so many: several can be selected."""
        model = self.model()
        rows = min(max(model.rowCount() if model is not None else 0, 1), _LEAST_ROWS)
        return QSize(super().minimumSizeHint().width(), rows * ROW_HEIGHT + 2 * self.frameWidth())

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Click eye or lock without changing the current curve; elsewhere select."""
        position = event.position().toPoint()
        index = self.indexAt(position)
        if event.button() == Qt.MouseButton.LeftButton and index.isValid():
            row = self.visualRect(index)
            for rect, clicked in ((eye_rect(row), self.eye_clicked), (lock_rect(row), self.lock_clicked)):
                if rect.contains(position):
                    clicked.emit(index.row())
                    return
            self._dragged = index.row()
            self._pressed_at = position.y()
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Show where the row that is dragged would go."""
        y = event.position().toPoint().y()
        if self._dragged < 0:
            super().mouseMoveEvent(event)
        elif self._gap >= 0 or abs(y - self._pressed_at) >= QApplication.startDragDistance():
            rows = self.model().rowCount()
            row = round((y + self.verticalOffset()) / ROW_HEIGHT)
            self._show_gap(min(max(row, 0), rows))
            self.scrollTo(self.model().index(min(max(row - (y < self._pressed_at), 0), rows - 1), 0))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let the row that is dragged go where the line is."""
        row, gap = self._dragged, self._gap
        self._dragged = -1
        self._show_gap(-1)
        super().mouseReleaseEvent(event)
        if gap >= 0:
            self.dragged.emit(row, gap - (gap > row))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Escape leaves the row that is dragged where it is."""
        if event.key() == Qt.Key.Key_Escape and self._gap >= 0:
            self._dragged = -1
            self._show_gap(-1)
        else:
            super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the rows, and a line where the row that is dragged would go."""
        super().paintEvent(event)
        if self._gap >= 0:
            painter = QPainter(self.viewport())
            y = self._gap * ROW_HEIGHT - self.verticalOffset()
            y = min(max(y - 1, 0), self.viewport().height() - 2)
            painter.fillRect(0, y, self.viewport().width(), 2, QColor(colours_for(self.palette()).accent))
            painter.end()

    def _show_gap(self, gap: int) -> None:
        self._gap = gap
        self.viewport().update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Rename; on the colour recolour, and on eye and lock a second click is a click."""
        position = event.position().toPoint()
        index = self.indexAt(position)
        if self._on_icon(position):
            self.mousePressEvent(event)
        elif index.isValid() and position.x() < _name_rect(self.visualRect(index)).left() - 4:
            self._dragged = -1
            self.swatch_clicked.emit(index.row())
        else:
            super().mouseDoubleClickEvent(event)

    def _on_icon(self, position: QPoint) -> bool:
        row = self.visualRect(self.indexAt(position))
        return eye_rect(row).contains(position) or lock_rect(row).contains(position)


class _CurveDelegate(QStyledItemDelegate):
    """Paints eye, swatch, name and lock, and edits the name in its place."""

    def __init__(self, view: CurveList) -> None:
        super().__init__(view)
        self._view = view

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: ModelIndex) -> QWidget:
        editor = QLineEdit(parent)
        editor.setMaxLength(NAME_LENGTH)
        editor.setAccessibleName("Name of the curve")
        return editor

    def updateEditorGeometry(self, editor: QWidget, option: QStyleOptionViewItem, index: ModelIndex) -> None:
        row: QRect = option.rect
        editor.setGeometry(_name_rect(row).adjusted(-10, 1, 0, -1))

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: ModelIndex) -> None:
        colours = colours_for(self._view.palette())
        item: Item = index.data(CurveModel.ItemRole)
        row: QRect = option.rect
        state = option.state
        selected = bool(state & QStyle.StateFlag.State_Selected)
        hovered = bool(state & QStyle.StateFlag.State_MouseOver)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        paint_ground(painter, row, selected, hovered, colours)
        if index.row() == self._view.currentIndex().row():
            painter.fillRect(QRect(row.left(), row.top(), _STRIPE, row.height()), QColor(colours.accent))
        _paint_eye(painter, QRectF(eye_rect(row)), item.visible, QColor(colours.secondary))
        if item.locked or hovered:
            shade = QColor(colours.secondary)
            shade.setAlphaF(1.0 if item.locked else 0.45)
            _paint_lock(painter, QRectF(lock_rect(row)), item.locked, shade)
        painter.setOpacity(1.0 if item.visible else 0.5)
        name = _name_rect(row)
        paint_swatch(painter, name.left() - SWATCH - 10, row, item.color, swatch_outline(colours))
        painter.setFont(self._view.font())
        painter.setPen(QColor(colours.text))
        text = painter.fontMetrics().elidedText(item.name, Qt.TextElideMode.ElideRight, name.width())
        painter.drawText(name, Qt.AlignmentFlag.AlignVCenter, text)
        painter.restore()


def _name_rect(row: QRect) -> QRect:
    left = eye_rect(row).right() + 9 + SWATCH + 10
    return QRect(left, row.top(), lock_rect(row).left() - 4 - left, row.height())


def _paint_eye(painter: QPainter, rect: QRectF, is_open: bool, colour: QColor) -> None:
    centre = rect.center()
    left, right = centre - QPointF(7, 0), centre + QPointF(7, 0)
    lids = QPainterPath(left)
    lids.quadTo(centre - QPointF(0, 8.5), right)
    lids.quadTo(centre + QPointF(0, 8.5), left)
    if not is_open:
        colour.setAlphaF(0.6)
    painter.setPen(QPen(colour, 1.3))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawPath(lids)
    if is_open:
        painter.setBrush(colour)
        painter.drawEllipse(centre, 1.6, 1.6)
    else:
        painter.drawLine(centre + QPointF(-6, 5), centre + QPointF(6, -5))


def _paint_lock(painter: QPainter, rect: QRectF, is_closed: bool, colour: QColor) -> None:
    centre = rect.center()
    painter.setPen(QPen(colour, 1.3))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    shackle = QPainterPath(centre + QPointF(-3, 0))
    shackle.lineTo(centre + QPointF(-3, -2.5))
    shackle.arcTo(QRectF(centre.x() - 3, centre.y() - 5.5, 6, 6), 180, -180)
    if is_closed:
        shackle.lineTo(centre + QPointF(3, 0))
    painter.drawPath(shackle)
    painter.setBrush(colour)
    painter.drawRoundedRect(QRectF(centre.x() - 4.5, centre.y() - 0.5, 9, 6.5), 1.5, 1.5)
