"""The λ strip: one column per control point, edited by dragging up and down or painting across."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPointF, QSize, Qt, Signal
from PySide6.QtGui import QHelpEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QAbstractScrollArea, QApplication, QFrame, QToolTip, QWidget

from theditor.drawing import Item
from theditor.model import Document, Selection, colours_for, unbreakable, words
from theditor.panels import lambda_scale as scale
from theditor.panels.guarded import NegativeBasis, reversal, same_lambdas
from theditor.panels.lambda_column import Column, caption_height, paint_column
from theditor.panels.lambda_edit import LambdaGesture, Targets, editable, set_lambdas, step_lambdas
from theditor.spline import mode_of

_WIDTH_RANGE = (44, 66)
_TRACK_RANGE = (48, 220)


@unbreakable
class LambdaStrip(QAbstractScrollArea):
    """Shows every λ of the current curve side by side; only the visible columns are painted.

    Dragging a column brings its λ to the pointer, together with the other selected ones if it is among them;
    dragging across columns paints, also from one that shapes nothing. T, H and λ* attract, unless Shift is held;
    Ctrl drags ten times finer from where λ is. A click selects the column's control point, with Shift adds it.
    """

    track_top = 8
    """Where the upright scale ends above, in pixels."""

    announce = Signal(str)
    """A sentence for the status line."""
    hovered = Signal(object)
    """The control point, if any, whose λ is under the pointer: a tuple of its index, or none."""

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._selection = document, selection
        self._item: Item | None = None
        self._points: frozenset[int] = frozenset()
        self._press: QPointF | None = None
        self._column = 0
        self._together = False
        self._drag: scale.ScaleDrag | None = None
        self._gesture: LambdaGesture | None = None
        self._painted: dict[int, float] = {}
        self._hovered = -1
        self._negative = NegativeBasis()
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.viewport().setMouseTracking(True)
        # What lies behind need not be painted.
        self.viewport().setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAccessibleName("λ strip: shape parameter of every control point")
        document.changed.connect(self._follow)
        selection.changed.connect(self._follow)

    def sizeHint(self) -> QSize:
        """Room for a dozen columns."""
        return QSize(12 * _WIDTH_RANGE[1], self.track_top + 80 + caption_height(self.font()) + 16)

    def minimumSizeHint(self) -> QSize:
        """Room for a few low columns."""
        return QSize(3 * _WIDTH_RANGE[0], self.track_top + _TRACK_RANGE[0] + caption_height(self.font()) + 8)

    # Where things are

    def _count(self) -> int:
        return len(self._item.curve.lambdas) if self._item is not None else 0

    def _width(self) -> int:
        least, most = _WIDTH_RANGE
        return max(least, min(most, self.viewport().width() // max(self._count(), 1)))

    @property
    def track_height(self) -> float:
        """Length of the upright scale in pixels."""
        free = self.viewport().height() - self.track_top - caption_height(self.font()) - 8
        return float(max(_TRACK_RANGE[0], min(_TRACK_RANGE[1], free)))

    def _column_at(self, x: float) -> int:
        return int((x + self.horizontalScrollBar().value()) // self._width())

    def _nearest_column(self, x: float) -> int:
        return min(max(self._column_at(x), 0), self._count() - 1)

    def _place_at(self, y: float) -> float:
        return 1 - (y - self.track_top) / self.track_height

    def column_left(self, index: int) -> int:
        """Left edge of a column in the viewport, in pixels."""
        return index * self._width() - self.horizontalScrollBar().value()

    # What the hand does

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of a column; whether to select or to drag shows later."""
        column = self._column_at(event.position().x())
        if event.button() == Qt.MouseButton.LeftButton and 0 <= column < self._count():
            self._press, self._column = event.position(), column
            self._together = column in self._selection.points and len(self._selection.points) > 1

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag the λ under the hand; without a press, show what would be dragged."""
        position = event.position()
        if self._press is None:
            self._hover(self._column_at(position.x()))
            return
        if self._gesture is None and not self._start_drag(event):
            return
        if self._gesture is not None and not self._gesture.is_open:
            self._gesture = self._press = None
            return
        assert self._gesture is not None
        assert self._drag is not None
        fine, free = _modifiers(event)
        value = self._drag.move(self._press.y() - position.y(), fine=fine, free=free)
        self._press = position
        if self._together:
            targets = editable(self._selection)
            self._painted = dict.fromkeys(targets.tolist(), value)
        else:
            self._paint_to(self._nearest_column(position.x()), value)
        painted = Targets({self._selection.curve: list(self._painted)})
        self._gesture.preview(painted, list(self._painted.values()))

    def _start_drag(self, event: QMouseEvent) -> bool:
        """Begin the gesture once the pointer is far enough from where it was pressed, and over a λ that may change."""
        assert self._press is not None
        assert self._item is not None
        if not self._is_far(event.position()):
            return False
        reason = self._reason(self._column)
        if reason and not self._leave_inert(self._nearest_column(event.position().x())):
            self.announce.emit(reason)
            return False
        fine, _ = _modifiers(event)
        value = self._item.curve.lambdas[self._column]
        place = float(scale.position(value)) if fine else self._place_at(self._press.y())
        self._drag = scale.ScaleDrag(self._item.curve.degree, self.track_height, place)
        self._gesture = LambdaGesture(self._document)
        self._painted = {}
        return True

    def _is_far(self, position: QPointF) -> bool:
        """Whether the pointer is so far from where it was pressed that it drags."""
        assert self._press is not None
        return (position - self._press).manhattanLength() >= QApplication.startDragDistance() / 2

    def _leave_inert(self, column: int) -> bool:
        """Go on from a column that shapes nothing to the first that does on the way to another one, if any."""
        assert self._item is not None
        step = 1 if column >= self._column else -1
        way, active = range(self._column, column + step, step), self._item.curve.active_lambdas
        first = next((i for i in way if active[i]), None)
        if first is None or self._item.locked:
            return False
        self._column, self._together = first, False
        return True

    def _paint_to(self, column: int, value: float) -> None:
        """Set every active λ between the last column and this one: a quick hand leaves no gaps."""
        assert self._item is not None
        active = self._item.curve.active_lambdas
        step = 1 if column >= self._column else -1
        for i in range(self._column, column + step, step):
            if active[i] and (i == column or i != self._column or i not in self._painted):
                self._painted[i] = value
        self._column = column

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End the drag, or select the column clicked on."""
        if event.button() != Qt.MouseButton.LeftButton or self._press is None:
            return
        clicked = not self._is_far(event.position())
        self._press = None
        if self._gesture is not None:
            self._gesture.commit()
            self._gesture = None
        elif not clicked:
            return
        elif event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self._selection.toggle(self._selection.curve, self._column)
        else:
            self._selection.select(points=[self._column], segments=())

    def leaveEvent(self, event: QEvent) -> None:
        """Nothing is under the pointer any more."""
        super().leaveEvent(event)
        self._hover(-1)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Left and right select a column, up and down change λ, Page keys go to the next landmark."""
        key, keys = event.key(), Qt.Key
        chosen = min(self._selection.points, default=-1)
        last = self._count() - 1
        columns = {keys.Key_Left: max(chosen - 1, 0), keys.Key_Right: min(chosen + 1, last)}
        columns |= {keys.Key_Home: 0, keys.Key_End: last}
        if key == keys.Key_Escape and self._gesture is not None:
            self._gesture.cancel()
            self._gesture = self._press = None
        elif self._press is not None or last < 0:
            event.ignore()
        elif key in columns:
            self._selection.select(points=[columns[keys(key)]], segments=())
        elif key in (keys.Key_Up, keys.Key_Down):
            self._step(1 if key == keys.Key_Up else -1, fine=_modifiers(event)[0])
        elif key in (keys.Key_PageUp, keys.Key_PageDown):
            self._jump(1 if key == keys.Key_PageUp else -1)
        else:
            event.ignore()

    def viewportEvent(self, event: QEvent) -> bool:
        """Answer a request for a tooltip with the λ under the pointer."""
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            QToolTip.showText(event.globalPos(), self.tip(self._column_at(event.pos().x())), self)
            return True
        return super().viewportEvent(event)

    def event(self, event: QEvent) -> bool:
        """Keep Escape for the drag while there is one."""
        if (
            isinstance(event, QKeyEvent)
            and event.type() == QEvent.Type.ShortcutOverride
            and self._gesture is not None
            and event.key() == Qt.Key.Key_Escape
        ):
            event.accept()
            return True
        return super().event(event)

    def tip(self, column: int) -> str:
        """Say of a column its λ in full, its mode or why it cannot be changed, and what it gives up."""
        if self._item is None or not 0 <= column < self._count():
            return ""
        curve = self._item.curve
        value = float(curve.lambdas[column])
        mode = mode_of(value, value, curve.degree).value
        text = words.exact(value).replace("-", "−")
        first = f"{words.indexed('λ', column)} = {text} · {self._reason(column) or mode}"
        lines = [first, *self._negative.caused_by(curve, column), reversal(curve, column)]
        return "\n".join(filter(None, lines))

    def _reason(self, column: int) -> str:
        assert self._item is not None
        if self._item.locked:
            return words.locked_reason(self._item.name)
        if not self._item.curve.active_lambdas[column]:
            return words.inactive_reason(self._item.curve, [column])
        return ""

    def _step(self, count: int, fine: bool) -> None:
        targets = self._targets()
        if self._selection.points and targets.size:
            step_lambdas(self._document, targets, count, fine=fine)
        else:
            self._explain()

    def _jump(self, direction: int) -> None:
        targets = self._targets()
        if self._item is not None and self._selection.points and targets.size:
            curve, drawing = self._item.curve, self._document.drawing
            value = scale.next_landmark(float(targets.values(drawing)[0]), direction, curve.degree)
            set_lambdas(self._document, targets, value, run=True)
        else:
            self._explain()

    def _targets(self) -> Targets:
        return Targets({self._selection.curve: editable(self._selection)})

    def _explain(self) -> None:
        chosen = min(self._selection.points, default=None)
        self.announce.emit("Select a column first." if chosen is None else self._reason(chosen))

    def _hover(self, column: int) -> None:
        if column != self._hovered:
            self._hovered = column
            item = self._selection.item
            moves = item is not None and 0 <= column < self._count() and item.curve.active_lambdas[column]
            self.hovered.emit((column,) if moves else ())
            self.viewport().update()

    # Following

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with what changed while nobody saw it."""
        super().showEvent(event)
        self._follow()

    def _follow(self) -> None:
        if not self.isVisible():
            return
        item, points = self._selection.item, self._selection.points
        moved = points != self._points
        if item is self._item and not moved:
            return
        old, self._item, self._points = self._item, item, points
        self._fit_scroll_bar()
        if moved and points:
            self._reveal(min(points))
            self.setAccessibleDescription(self.tip(min(points)))
        if moved or item is None or old is None or not _looks_same(old, item):
            self.viewport().update()

    def _fit_scroll_bar(self) -> None:
        bar, page = self.horizontalScrollBar(), self.viewport().width()
        bar.setRange(0, max(0, self._count() * self._width() - page))
        bar.setPageStep(page)
        bar.setSingleStep(self._width())

    def _reveal(self, column: int) -> None:
        bar, width = self.horizontalScrollBar(), self._width()
        left, page = column * width, self.viewport().width()
        bar.setValue(max(min(bar.value(), left), left + width - page))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the columns to the new width."""
        super().resizeEvent(event)
        self._fit_scroll_bar()

    def changeEvent(self, event: QEvent) -> None:
        """Repaint in the new colours or font."""
        super().changeEvent(event)
        self.viewport().update()

    def scrollContentsBy(self, dx: int, dy: int) -> None:
        """Repaint rather than move pixels: only the visible columns are drawn anyway."""
        self.viewport().update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the visible columns."""
        painter = QPainter(self.viewport())
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        colours = colours_for(self.palette())
        # At the edge a fine screen's pixels may be covered in part: nothing else paints these.
        painter.fillRect(event.rect().adjusted(-1, -1, 1, 1), colours.panel)
        if self._item is not None:
            curve, width, height = self._item.curve, self._width(), self.track_height
            first = max(0, self._column_at(event.rect().left()))
            last = min(self._count() - 1, self._column_at(event.rect().right()))
            for i in range(first, last + 1):
                column = Column(
                    point=i,
                    value=float(curve.lambdas[i]),
                    degree=curve.degree,
                    active=bool(curve.active_lambdas[i]) and not self._item.locked,
                    selected=i in self._points,
                    hovered=i == self._hovered,
                    marked=bool(self._negative.caused_by(curve, i)),
                )
                painter.save()
                painter.translate(self.column_left(i), 0)
                paint_column(painter, column, width, self.track_top, height, self.font(), colours)
                painter.restore()
        painter.end()


def _looks_same(old: Item, new: Item) -> bool:
    return old.locked == new.locked and same_lambdas(old.curve, new.curve)


def _modifiers(event: QMouseEvent | QKeyEvent) -> tuple[bool, bool]:
    """Whether to go ten times finer, and whether to go free of magnetism."""
    held, keys = event.modifiers(), Qt.KeyboardModifier
    return bool(held & keys.ControlModifier), bool(held & keys.ShiftModifier)
