"""A hand on the mouse: real events sent to the canvas, with buttons and modifier keys."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QNativeGestureEvent, QPointingDevice, QWheelEvent
from PySide6.QtWidgets import QApplication

NONE = Qt.KeyboardModifier.NoModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
CTRL = Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton
MIDDLE = Qt.MouseButton.MiddleButton


class Hand:
    """Moves over the viewport of a canvas and presses its buttons, in points of the plane."""

    def __init__(self, canvas):
        self.canvas = canvas
        self.button = Qt.MouseButton.NoButton

    def pixel(self, point):
        return self.canvas.plane.to_pixels(np.asarray(point, dtype=float))

    def _send(self, kind, pixel, button, held, keys):
        at = QPointF(*pixel)
        viewport = self.canvas.viewport()
        event = QMouseEvent(kind, at, QPointF(viewport.mapToGlobal(at.toPoint())), button, held, keys)
        QApplication.sendEvent(viewport, event)

    def move(self, point, keys=NONE):
        self._send(QEvent.Type.MouseMove, self.pixel(point), Qt.MouseButton.NoButton, self.button, keys)

    def press(self, point, button=LEFT, keys=NONE):
        self.move(point, keys)
        self.button = button
        self._send(QEvent.Type.MouseButtonPress, self.pixel(point), button, button, keys)

    def release(self, point, keys=NONE):
        button, self.button = self.button, Qt.MouseButton.NoButton
        self._send(QEvent.Type.MouseButtonRelease, self.pixel(point), button, self.button, keys)

    def click(self, point, keys=NONE):
        self.press(point, keys=keys)
        self.release(point, keys)

    def double_click(self, point, keys=NONE):
        self.click(point, keys)
        self.button = LEFT
        self._send(QEvent.Type.MouseButtonDblClick, self.pixel(point), LEFT, LEFT, keys)
        self.release(point, keys)

    def drag(self, start, end, keys=NONE, button=LEFT, steps=4):
        start, end = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
        plane = self.canvas.plane
        pixels = [plane.to_pixels(start + (end - start) * k / steps) for k in range(1, steps + 1)]
        self.press(start, button, keys)
        for pixel in pixels:
            self._send(QEvent.Type.MouseMove, pixel, Qt.MouseButton.NoButton, button, keys)
        self.button = Qt.MouseButton.NoButton
        self._send(QEvent.Type.MouseButtonRelease, pixels[-1], button, self.button, keys)

    def wheel(self, point, notches=0, pixels=(0, 0), keys=NONE):
        """Turn the wheel by notches, or move two fingers on a touchpad by pixels."""
        touchpad = any(pixels)
        phase = Qt.ScrollPhase.ScrollUpdate if touchpad else Qt.ScrollPhase.NoScrollPhase
        turned = (8 * pixels[0], 8 * pixels[1]) if touchpad else (0, 120 * notches)
        at = QPointF(*self.pixel(point))
        viewport = self.canvas.viewport()
        event = QWheelEvent(
            at,
            QPointF(viewport.mapToGlobal(at.toPoint())),
            QPoint(*pixels),
            QPoint(*turned),
            Qt.MouseButton.NoButton,
            keys,
            phase,
            False,
        )
        QApplication.sendEvent(viewport, event)

    def pinch(self, point, growth):
        """Spread two fingers on a touchpad, or bring them together."""
        at, viewport = QPointF(*self.pixel(point)), self.canvas.viewport()
        place = QPointF(viewport.mapToGlobal(at.toPoint()))
        device = QPointingDevice.primaryPointingDevice()
        kind = Qt.NativeGestureType.ZoomNativeGesture
        event = QNativeGestureEvent(kind, device, 2, at, at, place, growth, QPointF())
        QApplication.sendEvent(viewport, event)
