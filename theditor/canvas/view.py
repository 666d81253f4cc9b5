"""A widget that shows part of the plane: where it is, how to show another part, and the wheel."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QEvent, QRectF, Qt
from PySide6.QtGui import QInputDevice, QNativeGestureEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from theditor.canvas.qt_mirror import names_on_demand
from theditor.canvas.viewport import Floats, Viewport
from theditor.model import unbreakable
from theditor.spline import MAX_COORDINATE

with names_on_demand():
    import pyqtgraph as pg

ZOOM_STEP = 1.25
NOTCH = 120
"""What a notch of a wheel counts."""
WIDEST = 1e13
"""The largest part of the plane that is shown, in units; coordinates end at 10¹²."""


@unbreakable
class PlaneView(pg.GraphicsView):
    """Part of the plane, the same scale on both axes. What is drawn there is up to the canvas."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent, useOpenGL=False)
        self.fitted = True
        """Whether what was fitted is to stay fitted when the widget is resized."""
        self.box = pg.ViewBox(lockAspect=True, enableMouse=False, enableMenu=False, defaultPadding=0)
        self.setCentralItem(self.box)
        self.setCacheMode(self.CacheModeFlag.CacheNone)
        self.setViewportUpdateMode(self.ViewportUpdateMode.FullViewportUpdate)

    @property
    def plane(self) -> Viewport:
        """Which part of the plane is visible."""
        area = self.box.viewRect()
        size = self.box.rect()
        width, height = max(size.width(), 1.0), max(size.height(), 1.0)
        centre = area.center()
        return Viewport(centre.x(), centre.y(), width / area.width(), width, height)

    def show_view(self, x: float, y: float, scale: float) -> None:
        """Show the plane around a point, at a scale in pixels per unit, within what floats can resolve."""
        plane = self.plane
        finest = max(1e-9, 1e-11 * max(abs(x), abs(y)))
        width = min(max(plane.width / scale, finest), WIDEST)
        x, y = (min(max(v, -MAX_COORDINATE), MAX_COORDINATE) for v in (x, y))
        height = width * plane.height / plane.width
        self.fitted = False
        self.box.setRange(QRectF(x - width / 2, y - height / 2, width, height), padding=0)

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

    def reveal(self, point: Floats) -> None:
        """Move the view so that a point (2,) of the plane is in the middle, unless it is in view."""
        plane = self.plane
        pixel = plane.to_pixels(point)
        if not ((pixel >= 0) & (pixel <= (plane.width, plane.height))).all():
            self.show_view(float(point[0]), float(point[1]), plane.scale)

    def pan(self, pixels: Floats) -> None:
        """Move the picture by pixels (2,), y downward."""
        plane = self.plane
        x, y = (pixels / plane.scale).tolist()
        self.show_view(plane.x - x, plane.y + y, plane.scale)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom at the pointer; two fingers on a touchpad pan, and zoom with Ctrl."""
        event.accept()
        fine, coarse, position = event.pixelDelta(), event.angleDelta(), event.position()
        touchpad = (
            event.phase() != Qt.ScrollPhase.NoScrollPhase
            or event.device().type() == QInputDevice.DeviceType.TouchPad
            or not fine.isNull()
        )
        if touchpad and not event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            moved = fine if not fine.isNull() else coarse / 2
            self.pan(np.array([moved.x(), moved.y()], dtype=np.float64))
        else:
            self.zoom(ZOOM_STEP ** (coarse.y() / NOTCH), np.array([position.x(), position.y()]))

    def viewportEvent(self, event: QEvent) -> bool:
        """Zoom where two fingers are spread or pinched on a touchpad."""
        if not isinstance(event, QNativeGestureEvent):
            return bool(super().viewportEvent(event))
        if event.gestureType() == Qt.NativeGestureType.ZoomNativeGesture:
            position = event.position()
            self.zoom(max(1.0 + event.value(), 0.1), np.array([position.x(), position.y()]))
        return True
