"""A hand on the mouse: real events sent to the canvas, with buttons and modifier keys."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent
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

    def wheel(self, point, notches):
        at = QPointF(*self.pixel(point))
        viewport = self.canvas.viewport()
        event = QWheelEvent(
            at,
            QPointF(viewport.mapToGlobal(at.toPoint())),
            QPoint(0, 0),
            QPoint(0, 120 * notches),
            Qt.MouseButton.NoButton,
            NONE,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(viewport, event)
