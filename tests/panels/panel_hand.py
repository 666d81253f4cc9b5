"""A hand on the mouse over a panel, and curves to work on."""

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from theditor.spline import INTERPOLATING, Curve

LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
CTRL = Qt.KeyboardModifier.ControlModifier
FIGURE_10 = [0, 0, 0, INTERPOLATING[3], INTERPOLATING[3], 1, 1, 1, 1, 0.5, 0, 0, 0]


def some_curve(lambdas=FIGURE_10, **kind):
    angles = np.linspace(0, 5, len(lambdas))
    return Curve(np.c_[np.cos(angles), np.sin(2 * angles)], lambdas, **kind)


class Hand:
    """A mouse with modifier keys, on one widget; places are in the widget's pixels."""

    def __init__(self, widget):
        self.widget = widget
        self.at = QPointF()

    def _send(self, kind, button, held, modifiers):
        place = QPointF(self.widget.mapToGlobal(self.at))
        event = QMouseEvent(kind, self.at, place, button, held, modifiers)
        QApplication.sendEvent(self.widget, event)

    def press(self, x, y, modifiers=NONE):
        self.at = QPointF(x, y)
        self._send(QEvent.Type.MouseButtonPress, LEFT, LEFT, modifiers)

    def move(self, x, y, modifiers=NONE, held=LEFT):
        self.at = QPointF(x, y)
        self._send(QEvent.Type.MouseMove, Qt.MouseButton.NoButton, held, modifiers)

    def release(self, modifiers=NONE):
        self._send(QEvent.Type.MouseButtonRelease, LEFT, Qt.MouseButton.NoButton, modifiers)

    def click(self, x, y, modifiers=NONE):
        self.press(x, y, modifiers)
        self.release(modifiers)

    def click_at(self, place: QPoint, modifiers=NONE):
        self.click(place.x(), place.y(), modifiers)
