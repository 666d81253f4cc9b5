"""The canvas: shows the drawing and hands the mouse to the tools."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from PySide6.QtCore import QEvent, QRect, QRectF, Qt, Signal
from PySide6.QtGui import QFocusEvent, QHelpEvent, QKeyEvent, QMouseEvent, QPainter, QResizeEvent
from PySide6.QtWidgets import QToolTip, QWidget

from theditor.canvas.cursors import cursor_over
from theditor.canvas.curves import CurvesPainter
from theditor.canvas.events import keys_of, pointer_of
from theditor.canvas.fit import fitted
from theditor.canvas.hit_test import Hit, JointHit, MiddleHit, PointHit, SegmentHit, exists, parameter_of
from theditor.canvas.layers import Layers
from theditor.canvas.legend import Legend
from theditor.canvas.picking import key_of
from theditor.canvas.picture import Frame, Shown
from theditor.canvas.select import SelectTool
from theditor.canvas.shaping import PullCurve, shaped_by
from theditor.canvas.snapping import Snapper
from theditor.canvas.tool import Bench, Tool
from theditor.canvas.tools import SLACK, Drag, Marquee, MovePoints, Pan, Pointer
from theditor.canvas.view import PlaneView
from theditor.canvas.viewport import Floats
from theditor.canvas.words import Pointed, describe, hint, reasons, selected, warning
from theditor.drawing import Drawing
from theditor.model import Document, Selection, colours_for, unbreakable
from theditor.spline import CONVEX_HULL_RANGE, PULL_BOUNDS


@unbreakable
class Canvas(PlaneView):
    """The drawing, live. Edits go through the document; what is selected is the selection's."""

    pointed = Signal(object)
    announce = Signal(str)
    tool_changed = Signal(str)

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._selection = document, selection
        self._curves = CurvesPainter()
        self._layers = Layers(self._curves)
        self._shown = Shown()
        self._drag: Drag | None = None
        self._press: Pointer | None = None
        self._drag_moved = False
        self._pointer: Pointer | None = None
        self._hit: Hit = None
        self._space = False
        self._reach: tuple[int, ...] = ()
        self._keep_hull = False
        self._place: float | None = None
        self.snapper = Snapper(self._curves)
        self._bench = Bench(
            document, selection, self, self._curves, self.snapper, self._bounds, self.announce.emit
        )
        self._select = SelectTool(self._bench)
        self._tools: dict[str, Tool] = {"select": self._select}
        self._tool: Tool = self._select

        self.box.sigTransformChanged.connect(self._view_changed)
        self._legend = Legend(self)

        self.setObjectName("canvas")
        self.setAccessibleName("Canvas: the curves and their control points")
        self.setAccessibleDescription(
            "A picture to be edited with the mouse. Tab steps through the control points, the arrow keys move them, "
            "F6 leaves."
        )
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setMinimumSize(240, 160)
        document.changed.connect(self._drawing_changed)
        document.leaving.connect(self._curves.forget)
        selection.changed.connect(self._selection_changed)

    # Tools

    def use(self, name: str) -> None:
        """Take up a tool: ``"select"``, ``"pen"`` or ``"freehand"``."""
        if name not in self._tools:
            self._tools[name] = drawing_tool(name, self._bench, lambda: self.use("select"))
        tool = self._tools[name]
        if tool is self._tool:
            return
        self.cancel_drag()
        self._tool.leave()
        self._tool = tool
        self.tool_changed.emit(name)
        self._hover()
        self.viewport().update()

    def set_snapping(self, on: bool) -> None:
        """Draw points that are moved or placed to what lies near."""
        self.snapper.on = on

    def event(self, event: QEvent) -> bool:
        """Keep the keys that mean something to the tool from the commands."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride:
            taken = event.key() in self._tool.keys
            event.setAccepted(taken)
            return taken or bool(super().event(event))
        return bool(super().event(event))

    @property
    def dragging(self) -> bool:
        """Whether the mouse has something in its hand."""
        return self._drag is not None and self._drag_moved

    # What is shown

    def fit(self) -> None:
        """Show all visible curves with their control points, and go on doing so while the canvas is resized."""
        size = self.box.rect()
        self.show_view(*fitted(self._document.drawing, size.width(), size.height()))
        self.fitted = True

    def set_shown(self, **what: Any) -> None:
        """Show or hide parts, by the names in `Shown`."""
        self._shown = self._shown._replace(**what)
        self._show_legend()
        self.viewport().update()

    @property
    def shown(self) -> Shown:
        """What is shown beside the curves."""
        return self._shown

    # Painting

    def drawBackground(self, painter: QPainter, rect: QRectF) -> None:
        """Leave the ground to the picture, which covers it."""

    def drawForeground(self, painter: QPainter, rect: QRectF) -> None:
        """Paint the picture."""
        self._layers.paint(painter, self._frame())

    def _frame(self) -> Frame:
        selection = self._selection
        return Frame(
            self._document.drawing,
            selection.curve,
            selection.chosen,
            selection.segments,
            self._select.box,
            self._valid_hit(),
            self.plane,
            self._shown,
            colours_for(self.palette()),
            self.font(),
            self._bounds(selection.curve),
            self._document.before,
            self._place,
            self._reach_points(),
            self._drag.corners if isinstance(self._drag, Marquee) else None,
            self._drag.miss if isinstance(self._drag, PullCurve) else None,
            self._tool.sketch,
            self._drag.snapped if isinstance(self._drag, MovePoints) else self._tool.snapped,
        )

    def _valid_hit(self) -> Hit:
        """What is hovered, unless the drawing has changed under the pointer so that it is gone."""
        hit, drawing = self._hit, self._document.drawing
        index = hit.curve if isinstance(hit, SegmentHit | PointHit) else self._selection.curve
        if not 0 <= index < len(drawing) or not drawing[index].visible:
            return None
        return hit if exists(hit, drawing[index].curve) else None

    def show_place(self, u: float | None) -> None:
        """Point out the place at parameter `u` of the current curve; None for none."""
        self._place = u
        self.viewport().update()

    def _reach_points(self) -> tuple[int, ...]:
        hit, item = self._valid_hit(), self._selection.item
        if isinstance(hit, JointHit | MiddleHit) and item is not None:
            return tuple(shaped_by(item.curve, hit))
        return self._reach

    def show_reach(self, points: Iterable[int]) -> None:
        """Shade what the λ of these control points can reach; nothing for none."""
        self._reach = tuple(points)
        self.viewport().update()

    def keep_hull(self, on: bool) -> None:
        """Let the hand move λ only where the convex hull bounds the curve."""
        self._keep_hull = on
        self.viewport().update()

    def _bounds(self, index: int) -> tuple[float, float]:
        """How far a hand may move the λ of a curve of the drawing."""
        drawing = self._document.drawing
        keep = self._keep_hull and 0 <= index < len(drawing)
        return CONVEX_HULL_RANGE[drawing[index].curve.degree] if keep else PULL_BOUNDS

    # Following the model

    def _view_changed(self, *_: Any) -> None:
        self._hover()
        self.viewport().update()

    def _drawing_changed(self, old: Drawing, new: Drawing) -> None:
        if self._drag is None and self._document.before is None:
            self._hover()
        self.viewport().update()

    def _selection_changed(self) -> None:
        self._tell()
        self.viewport().update()

    def changeEvent(self, event: QEvent) -> None:
        """Repaint in the colours of another theme."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "_legend"):
            self.viewport().update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep what was fitted fitted, and the legend top centre."""
        super().resizeEvent(event)
        if self.closed or not hasattr(self, "_legend"):
            return
        if self.fitted:
            self.fit()
        self._legend.resize(self._legend.sizeHint())
        self._legend.move((self.width() - self._legend.width()) // 2, 12)
        self._show_legend()

    @property
    def legend_area(self) -> QRect:
        """Where the legend of the modes lies on the canvas; empty without it."""
        return self._legend.geometry() if self._legend.isVisible() else QRect()

    def _show_legend(self) -> None:
        """Show the legend if it is wanted and fits."""
        shown = self._shown
        self._legend.setVisible(shown.legend and shown.modes and self._legend.width() <= self.width())

    # The mouse and the keys

    def hit(self, at: Floats) -> Hit:
        """What a press at a pixel would take hold of, were it the first there."""
        return next(iter(self._select.hits(at)), None)

    def _hover(self) -> None:
        """Find what is under the pointer and tell: halo, cursor, status line."""
        before = self._hit
        self._hit = (
            self._tool.hover(self._pointer) if self._pointer is not None and self._drag is None else None
        )
        if self._drag is None:
            self._set_cursor()
        current = self._selection.curve
        if key_of(before, current) != key_of(self._hit, current) or self._tool is not self._select:
            self.viewport().update()
        self._tell()

    def _set_cursor(self) -> None:
        shape = self._tool.cursor or cursor_over(self._hit)
        self.viewport().setCursor(Qt.CursorShape.OpenHandCursor if self._space else shape)

    def _tell(self) -> None:
        plane = self.plane
        position = None
        if self._pointer is not None:
            x, y = plane.to_points(self._pointer.at).tolist()
            position = (x, y)
        drawing, current = self._document.drawing, self._selection.curve
        hit = self._valid_hit()
        over = describe(hit, drawing, current) or selected(self._selection)
        u = parameter_of(hit, current, drawing[current].curve) if current >= 0 else None
        told = self._tool.hint or (self._drag is None and warning(self._selection)) or hint(hit, self._drag)
        self.pointed.emit(Pointed(position, over, told, plane.scale, u))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin a drag; a press of another button while one is under way takes it back."""
        self._begin(event, double=False)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Begin a drag, or do what a double click does there."""
        self._begin(event, double=True)

    def _begin(self, event: QMouseEvent, *, double: bool) -> None:
        event.accept()
        self._pointer = pointer = pointer_of(event, self.plane)
        if self._drag is not None:
            self.cancel_drag()
            return
        button = event.button()
        if button == Qt.MouseButton.MiddleButton or (button == Qt.MouseButton.LeftButton and self._space):
            self._drag = Pan(self.plane, pointer, self.show_view)
            self.viewport().setCursor(Qt.CursorShape.ClosedHandCursor)
        elif button == Qt.MouseButton.LeftButton:
            self._drag = self._tool.press(pointer, double=double)
        self._press, self._drag_moved = pointer, False

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Follow the drag, or show what would be grabbed."""
        event.accept()
        self._pointer = pointer = pointer_of(event, self.plane)
        if self._drag is None or self._press is None:
            self._hover()
            return
        if not self._drag_moved and np.hypot(*(pointer.at - self._press.at)) < SLACK:
            return
        self._drag_moved = True
        self._drag.move(pointer)
        self._tell()
        self.viewport().update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End the drag."""
        event.accept()
        self._pointer = pointer = pointer_of(event, self.plane)
        drag, self._drag = self._drag, None
        if drag is not None and (self._drag_moved or isinstance(drag, Pan)):
            drag.release(pointer)
        elif drag is not None:
            self._tool.click(drag, pointer)
        self._hover()
        self.viewport().update()

    def cancel_drag(self) -> bool:
        """Take back the drag under way, if there is one."""
        drag, self._drag = self._drag, None
        if drag is None:
            return False
        drag.cancel()
        self._hover()
        self.viewport().update()
        return True

    def viewportEvent(self, event: QEvent) -> bool:
        """Say in a tooltip which promise a marked segment no longer keeps."""
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            current = self._selection.item
            reason = (
                "" if current is None else reasons(self._valid_hit(), self._selection.curve, current.curve)
            )
            QToolTip.showText(event.globalPos(), reason, self)
            return True
        return bool(super().viewportEvent(event))

    def leaveEvent(self, event: QEvent) -> None:
        """Nothing is hovered outside."""
        self._pointer = None
        self._hover()
        super().leaveEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Escape takes a drag back, Space pans while it is held, F6 leaves; the rest is the tool's."""
        event.accept()
        if event.key() == Qt.Key.Key_Escape and self.cancel_drag():
            return
        if event.key() == Qt.Key.Key_Space:
            self._space = True
            self._set_cursor()
        elif event.key() == Qt.Key.Key_F6:
            super().focusNextPrevChild(not event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        elif self._drag is None and self._tool.key(keys_of(event)):
            self._hover()
            self.viewport().update()
        else:
            event.ignore()

    def focusNextPrevChild(self, forward: bool) -> bool:
        """Leave Tab to the tool, as long as there are control points to step through."""
        item = self._selection.item
        return (item is None or item.locked or not item.visible) and bool(super().focusNextPrevChild(forward))

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """Space let go: the mouse edits again."""
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self._space = False
            self._set_cursor()
            event.accept()
        else:
            event.ignore()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """A Space held while the focus left counts as let go."""
        self._space = False
        super().focusOutEvent(event)


def drawing_tool(name: str, bench: Bench, done: Callable[[], None]) -> Tool:
    """Return a tool to draw with, ``"pen"`` or ``"freehand"``. Each is loaded when it is first taken up."""
    if name == "pen":
        from theditor.canvas.pen import PenTool

        return PenTool(bench, done)
    from theditor.canvas.freehand import FreehandTool

    return FreehandTool(bench, done)
