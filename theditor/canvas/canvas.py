"""The canvas: shows the drawing and hands the mouse to the tools."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, QRectF, Qt, Signal
from PySide6.QtGui import (
    QFocusEvent,
    QHelpEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QToolTip, QWidget

from theditor.canvas.curves import CurvesPainter
from theditor.canvas.fit import fitted
from theditor.canvas.hit_test import (
    Hit,
    JointHit,
    MiddleHit,
    PointHit,
    SegmentHit,
    exists,
    nearest_handle,
    nearest_place,
    parameter_of,
    sliding_place,
)
from theditor.canvas.legend import Legend
from theditor.canvas.overlays import guards_of
from theditor.canvas.picture import Frame, Shown, paint_ground, paint_picture
from theditor.canvas.shaping import PullCurve, SlideJoint
from theditor.canvas.tools import SLACK, Drag, Marquee, MovePoints, Pan, Pointer
from theditor.canvas.viewport import Floats, Viewport
from theditor.canvas.words import describe, hint
from theditor.drawing import Drawing
from theditor.model import Document, Selection, colours_for, unbreakable
from theditor.spline import CONVEX_HULL_RANGE, MAX_COORDINATE, PULL_BOUNDS

ZOOM_STEP = 1.25
WIDEST = 1e13
"""The largest part of the plane that is shown, in units; coordinates end at 10¹²."""


@dataclass(frozen=True)
class Pointed:
    """What the pointer is over, for the status line; `position` is None when it is outside."""

    position: tuple[float, float] | None
    over: str
    hint: str
    scale: float
    u: float | None = None
    """The parameter of the current curve at the pointer, if it is over it."""


@unbreakable
class Canvas(pg.GraphicsView):
    """The drawing, live. Edits go through the document; what is selected is the selection's."""

    pointed = Signal(object)

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent, useOpenGL=False)
        self._document, self._selection = document, selection
        self._curves = CurvesPainter()
        self._shown = Shown()
        self._drag: Drag | None = None
        self._press: Pointer | None = None
        self._drag_moved = False
        self._pointer: Pointer | None = None
        self._hit: Hit = None
        self._space = False
        self._fitted = True
        self._reach: tuple[int, ...] = ()
        self._keep_hull = False
        self._place: float | None = None

        self._box = pg.ViewBox(lockAspect=True, enableMouse=False, enableMenu=False, defaultPadding=0)
        self.setCentralItem(self._box)
        self._box.sigTransformChanged.connect(self._view_changed)
        self._legend = Legend(self)

        self.setObjectName("canvas")
        self.setAccessibleName("Canvas: the curves and their control points")
        self.setAccessibleDescription(
            "A picture to be edited with the mouse; the λ strip and the segment list offer the same by keyboard."
        )
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setCacheMode(self.CacheModeFlag.CacheNone)
        self.setViewportUpdateMode(self.ViewportUpdateMode.FullViewportUpdate)
        self.setMinimumSize(240, 160)
        document.changed.connect(self._drawing_changed)
        selection.changed.connect(self._selection_changed)

    # The view

    @property
    def plane(self) -> Viewport:
        """Which part of the plane is visible."""
        area = self._box.viewRect()
        size = self._box.rect()
        width, height = max(size.width(), 1.0), max(size.height(), 1.0)
        centre = area.center()
        return Viewport(centre.x(), centre.y(), width / area.width(), width, height)

    def show_view(self, x: float, y: float, scale: float) -> None:
        """Show the plane around a point, at a scale in pixels per unit, within what floats can resolve."""
        size = self._box.rect()
        finest = max(1e-9, 1e-11 * max(abs(x), abs(y)))
        width = min(max(size.width() / scale, finest), WIDEST)
        x, y = (min(max(v, -MAX_COORDINATE), MAX_COORDINATE) for v in (x, y))
        height = width * size.height() / size.width()
        self._fitted = False
        self._box.setRange(QRectF(x - width / 2, y - height / 2, width, height), padding=0)

    def fit(self) -> None:
        """Show all visible curves with their control points, and go on doing so while the canvas is resized."""
        size = self._box.rect()
        self.show_view(*fitted(self._document.drawing, size.width(), size.height()))
        self._fitted = True

    def zoom(self, factor: float, at: Floats | None = None) -> None:
        """Enlarge by `factor`, keeping the point at pixel `at` (default the middle) where it is."""
        plane = self.plane
        if at is None:
            at = np.array([plane.width / 2, plane.height / 2])
        fixed = plane.to_points(at)
        self.show_view(plane.x, plane.y, plane.scale * factor)
        now = self.plane
        away = fixed - now.to_points(at)
        self.show_view(now.x + float(away[0]), now.y + float(away[1]), now.scale)

    def set_shown(self, **what: Any) -> None:
        """Show or hide parts, by the names in `Shown`."""
        self._shown = replace(self._shown, **what)
        self._legend.setVisible(self._shown.legend and self._shown.modes)
        self.viewport().update()

    @property
    def shown(self) -> Shown:
        """What is shown beside the curves."""
        return self._shown

    # Painting

    def drawBackground(self, painter: QPainter, rect: QRectF) -> None:
        """Paint the ground and the grid."""
        paint_ground(painter, self._frame())

    def drawForeground(self, painter: QPainter, rect: QRectF) -> None:
        """Paint the curves, and what the current one is held by."""
        paint_picture(painter, self._frame(), self._curves)

    def _frame(self) -> Frame:
        selection = self._selection
        return Frame(
            self._document.drawing,
            selection.curve,
            selection.points,
            selection.segments,
            self._valid_hit(),
            self.plane,
            self._shown,
            colours_for(self.palette()),
            self.font(),
            self._bounds,
            self._document.before,
            self._place,
            self._reach_points(),
            self._drag.corners if isinstance(self._drag, Marquee) else None,
            self._drag.miss if isinstance(self._drag, PullCurve) else None,
        )

    def _valid_hit(self) -> Hit:
        """What is hovered, unless the drawing has changed under the pointer so that it is gone."""
        hit, drawing = self._hit, self._document.drawing
        index = hit.curve if isinstance(hit, SegmentHit) else self._selection.curve
        return hit if 0 <= index < len(drawing) and exists(hit, drawing[index].curve) else None

    def show_place(self, u: float | None) -> None:
        """Point out the place at parameter `u` of the current curve; None for none."""
        self._place = u
        self.viewport().update()

    def _reach_points(self) -> tuple[int, ...]:
        hit = self._valid_hit()
        return (hit.point,) if isinstance(hit, JointHit) else self._reach

    def show_reach(self, points: Iterable[int]) -> None:
        """Shade what the λ of these control points can reach; nothing for none."""
        self._reach = tuple(points)
        self.viewport().update()

    def keep_hull(self, on: bool) -> None:
        """Let the hand move λ only where the convex hull bounds the curve."""
        self._keep_hull = on
        self.viewport().update()

    @property
    def _bounds(self) -> tuple[float, float]:
        item = self._selection.item
        return CONVEX_HULL_RANGE[item.curve.degree] if self._keep_hull and item is not None else PULL_BOUNDS

    # Following the model

    def _view_changed(self, *_: Any) -> None:
        self._hover()
        self.viewport().update()

    def _drawing_changed(self, old: Drawing, new: Drawing) -> None:
        if self._drag is None:
            self._hover()
        self.viewport().update()

    def _selection_changed(self) -> None:
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
        if self._fitted:
            self.fit()
        self._legend.resize(self._legend.sizeHint())
        self._legend.move((self.width() - self._legend.width()) // 2, 12)

    # The mouse and the keys

    def hit(self, at: Floats) -> Hit:
        """What would be grabbed at a pixel: handles before curves, the current curve before others."""
        drawing, plane = self._document.drawing, self.plane
        self._curves.update(drawing, plane)
        current, item = self._selection.curve, self._selection.item
        if item is not None and item.visible and not item.locked:
            pixels = plane.to_pixels(self._curves.plane_curve(current).control_points)
            index = nearest_handle(pixels, at)
            if index is not None:
                return PointHit(index)
        best: tuple[float, int, float] | None = None
        owner = -1
        for i in sorted(range(len(drawing)), key=lambda i: (i != current, -i)):
            if not drawing[i].visible or drawing[i].locked:
                continue
            place = nearest_place(self._curves.trace(i).strokes(), at)
            if place is not None and (best is None or place[0] < best[0] - 2.0):
                best, owner = place, i
        if best is None:
            return None
        hit = SegmentHit(owner, best[1], min(best[2], 1.0))
        sliding = sliding_place(self._curves.plane_curve(owner), hit, at, plane) if owner == current else None
        return sliding or hit

    def _hover(self) -> None:
        """Find what is under the pointer and tell: halo, cursor, status line."""
        before = self._hit
        self._hit = self.hit(self._pointer.at) if self._pointer is not None and self._drag is None else None
        if self._drag is None:
            self._set_cursor()
        if _grabbed(before) != _grabbed(self._hit):
            self.viewport().update()
        self._tell()

    def _set_cursor(self) -> None:
        shape = Qt.CursorShape.ArrowCursor
        if self._space:
            shape = Qt.CursorShape.OpenHandCursor
        elif isinstance(self._hit, PointHit):
            shape = Qt.CursorShape.SizeAllCursor
        elif isinstance(self._hit, JointHit | MiddleHit):
            shape = Qt.CursorShape.CrossCursor
        elif isinstance(self._hit, SegmentHit):
            shape = Qt.CursorShape.PointingHandCursor
        self.viewport().setCursor(shape)

    def _tell(self) -> None:
        plane = self.plane
        position = None
        if self._pointer is not None:
            x, y = plane.to_points(self._pointer.at).tolist()
            position = (x, y)
        drawing, current = self._document.drawing, self._selection.curve
        hit = self._valid_hit()
        over = describe(hit, drawing, current)
        u = parameter_of(hit, current, drawing[current].curve) if current >= 0 else None
        self.pointed.emit(Pointed(position, over, hint(hit, self._drag), plane.scale, u))

    def _pointer_of(self, event: QMouseEvent) -> Pointer:
        position, held = event.position(), event.modifiers()
        at = np.array([position.x(), position.y()])
        return Pointer(
            at,
            self.plane.to_points(at),
            self.plane.scale,
            shift=bool(held & Qt.KeyboardModifier.ShiftModifier),
            ctrl=bool(held & Qt.KeyboardModifier.ControlModifier),
        )

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin a drag; a press of another button while one is under way takes it back."""
        event.accept()
        self._pointer = pointer = self._pointer_of(event)
        if self._drag is not None:
            self.cancel_drag()
            return
        button = event.button()
        if button == Qt.MouseButton.MiddleButton or (button == Qt.MouseButton.LeftButton and self._space):
            self._drag = Pan(self.plane, pointer, self.show_view)
            self.viewport().setCursor(Qt.CursorShape.ClosedHandCursor)
        elif button == Qt.MouseButton.LeftButton:
            self._drag = self._drag_for(self.hit(pointer.at), pointer)
        self._press, self._drag_moved = pointer, False

    def _drag_for(self, hit: Hit, pointer: Pointer) -> Drag:
        if isinstance(hit, PointHit):
            return MovePoints(self._document, self._selection, pointer, hit.index)
        if isinstance(hit, SegmentHit):
            bounds = self._bounds if hit.curve == self._selection.curve else PULL_BOUNDS
            return PullCurve(self._document, self._selection, pointer, hit, bounds)
        if isinstance(hit, JointHit | MiddleHit):
            return SlideJoint(self._document, self._selection, pointer, hit, self._bounds)
        return Marquee(self._selection, pointer)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Follow the drag, or show what would be grabbed."""
        event.accept()
        self._pointer = pointer = self._pointer_of(event)
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
        self._pointer = pointer = self._pointer_of(event)
        drag, self._drag = self._drag, None
        if drag is not None:
            drag.release(pointer)
        self._hover()
        self.viewport().update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """A second press in quick succession is a press like any other."""
        self.mousePressEvent(event)

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
            hit = self._valid_hit()
            item = self._selection.item
            reason = ""
            if isinstance(hit, SegmentHit) and hit.curve == self._selection.curve and item is not None:
                reason = guards_of(item.curve).reason(hit.segment)
            QToolTip.showText(event.globalPos(), reason, self)
            return True
        return bool(super().viewportEvent(event))

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom at the pointer."""
        event.accept()
        position = event.position()
        at = np.array([position.x(), position.y()])
        self.zoom(ZOOM_STEP ** (event.angleDelta().y() / 120), at)

    def leaveEvent(self, event: QEvent) -> None:
        """Nothing is hovered outside."""
        self._pointer = None
        self._hover()
        super().leaveEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Escape takes a drag back, else selects nothing; Space pans while it is held."""
        if event.key() == Qt.Key.Key_Escape:
            if not self.cancel_drag():
                self._selection.select(points=(), segments=())
            event.accept()
        elif event.key() == Qt.Key.Key_Space:
            self._space = True
            self._set_cursor()
            event.accept()
        else:
            event.ignore()

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


def _grabbed(hit: Hit) -> Hit | tuple[int, int]:
    """What a hit would grab, whatever its exact place."""
    return (hit.curve, hit.segment) if isinstance(hit, SegmentHit) else hit
