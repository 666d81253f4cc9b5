"""What events of the mouse and the keyboard say to a tool."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QInputEvent, QKeyEvent, QMouseEvent

from theditor.canvas.tool import Keys
from theditor.canvas.tools import Pointer
from theditor.canvas.viewport import Viewport


def pointer_of(event: QMouseEvent, plane: Viewport) -> Pointer:
    """Where the mouse is, and what is held."""
    position = event.position()
    at = np.array([position.x(), position.y()])
    shift, ctrl = _held(event)
    return Pointer(at, plane.to_points(at), plane, shift=shift, ctrl=ctrl)


def keys_of(event: QKeyEvent) -> Keys:
    """Which key is pressed, and what is held."""
    shift, ctrl = _held(event)
    return Keys(event.key(), shift=shift, ctrl=ctrl)


def _held(event: QInputEvent) -> tuple[bool, bool]:
    """Whether Shift and Ctrl are held."""
    held = event.modifiers()
    return (
        bool(held & Qt.KeyboardModifier.ShiftModifier),
        bool(held & Qt.KeyboardModifier.ControlModifier),
    )
