"""The numbers beside the selection on the canvas: where it is, to be typed anew."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QObject, QRectF, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel

from theditor.canvas.held import Held
from theditor.canvas.nudge import step
from theditor.canvas.projection import projected
from theditor.canvas.transform import MARGIN, OUTSIDE, grips
from theditor.model.words import points_counted
from theditor.panels.number_field import NumberField
from theditor.panels.parts import describe
from theditor.spline import MAX_COORDINATE
from theditor.spline.extent import extent

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

Floats = NDArray[np.float64]

NEAR, FAR = 28.0, MARGIN + OUTSIDE + 10.0
"""Distance in pixels from one control point, and from several, whose box has handles outside."""
EDGE = 8.0
"""Pixels that stay free at the edge of the canvas."""
GRID = 9
"""Rows and columns of places that are tried where none beside the selection is free."""
MOST = 2000
"""Of more selected points than this some are kept free, of a curve with more points only the selected ones."""
_SAMPLES = 8
"""Places on each segment that are kept free where they can be."""


class Coordinates(QFrame):
    """Two fields that lie over the canvas: x and y of the selected control point, or of the middle of several.

    Several are moved together. A number can be typed, arithmetic (``2/3``), or a change (``+1.5``, ``*2``). Enter
    and Escape go back to the canvas, Tab to the other field.
    """

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window.canvas)
        self._window = window
        self._on = True
        self._held = Held(window.document.drawing, {})
        self.setProperty("role", "card")
        layout = QHBoxLayout(self)
        layout.setContentsMargins(8, 3, 3, 3)
        layout.setSpacing(4)
        self.fields = tuple(self._field(axis, name, layout) for axis, name in enumerate("xy"))
        self.hide()
        window.document.changed.connect(self.follow)
        window.selection.changed.connect(self.follow)
        window.canvas.box.sigTransformChanged.connect(self._follow_view)
        window.canvas.pointed.connect(self._follow_hand)

    def _field(self, axis: int, name: str, layout: QHBoxLayout) -> NumberField:
        field = NumberField(-MAX_COORDINATE, MAX_COORDINATE)
        describe(field, f"{name} of the selection", f"{name} of the selection: a number, 2/3, +1.5 or *2")
        field.installEventFilter(self)
        field.entered.connect(lambda value: self._move(axis, value))
        field.stepped.connect(lambda count: self._step(axis, count))
        field.refused.connect(self._window.announce)
        label = QLabel(name)
        label.setBuddy(field)
        layout.addWidget(label)
        layout.addWidget(field)
        return field

    def set_on(self, on: bool) -> None:
        """Show the fields whenever something is selected, or never."""
        self._on = on
        self.follow()

    def edit(self) -> None:
        """Let the first number be typed, even if the fields do not show otherwise."""
        self.follow(asked=True)
        if self.isVisible():
            self.fields[0].setFocus(Qt.FocusReason.ShortcutFocusReason)

    # What the hand does

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Enter and Escape go back to the canvas, Tab to the other field."""
        if not isinstance(event, QKeyEvent) or event.type() != QEvent.Type.KeyPress:
            return False
        keys = Qt.Key
        if event.key() in (keys.Key_Tab, keys.Key_Backtab):
            self.fields[watched is self.fields[0]].setFocus(Qt.FocusReason.TabFocusReason)
            return True
        if event.key() == keys.Key_Escape:
            self.fields[watched is not self.fields[0]].take_back()
        if event.key() in (keys.Key_Escape, keys.Key_Return, keys.Key_Enter):
            self._window.canvas.setFocus(Qt.FocusReason.OtherFocusReason)  # which takes what was typed
            self.follow()
            return True
        return False

    def _move(self, axis: int, value: float, *, run: bool = False) -> None:
        """Move the selection along an axis, so that its middle has that coordinate."""
        places = self._held.places.copy()
        along = places[:, axis]
        places[:, axis] = value if (along == along[0]).all() else along + (value - self._middle[axis])
        chosen = self._window.selection.movable
        same = tuple((i, of.tobytes()) for i, of in chosen.items()) if run else None
        self._window.document.apply(f"Move {points_counted(chosen)}", self._held.at(places), merge=same)

    def _step(self, axis: int, count: int) -> None:
        self._move(axis, self._middle[axis] + count * step(self._window.canvas.plane.scale), run=True)

    # Following

    @property
    def _middle(self) -> list[float]:
        places = self._held.places
        low, high = extent(places)
        middle: list[float] = np.where(low == high, low, (low + high) / 2).tolist()
        return middle

    def _follow_view(self) -> None:
        if self.isVisible():
            self._place()

    def _follow_hand(self) -> None:
        if self.isVisible() is self._window.canvas.dragging:
            self.follow()

    def follow(self, *_: object, asked: bool = False) -> None:
        """Show where the selection is now; nothing while a hand is on the canvas."""
        window = self._window
        chosen = window.selection.movable
        shown = (self._on or asked or self._has_focus()) and bool(chosen) and not window.canvas.dragging
        if not shown:
            if self._has_focus():
                window.canvas.setFocus()
            self.hide()
            return
        self._held = Held(window.document.drawing, chosen)
        for field, value in zip(self.fields, self._middle, strict=True):
            field.show_value(value)
            field.setFixedWidth(field.width_at_rest())
        self._place()
        self.show()

    def _has_focus(self) -> bool:
        return any(field.hasFocus() for field in self.fields)

    def _place(self) -> None:
        """Lie beside the selection, where it covers few points, handles of their box, and little of the curve."""
        plane = self._window.canvas.plane
        pixels = plane.to_pixels(self._held.places)
        if not len(pixels):
            return
        self.resize(self.sizeHint())
        size = np.array([self.width(), self.height()], dtype=float)
        low, high = extent(pixels)
        pixels = np.vstack([pixels[:: len(pixels) // MOST + 1], grips(self._held.places, plane)])
        around, along = self._near()
        spots = _spots(low, high, NEAR if (low == high).all() else FAR, size)
        room = np.array([plane.width, plane.height]) - size - EDGE
        inside = [np.clip(spot, EDGE, np.maximum(room, EDGE)) for spot in spots]
        corners = [np.array(corner) for corner in ((room[0], room[1]), (EDGE, room[1]), (room[0], EDGE))]

        legend = self._window.canvas.legend_area

        def covered(spot: Floats) -> tuple[int, int]:
            end = spot + size
            hides_legend = legend.intersects(QRectF(*spot, *size).toAlignedRect())
            inner, outer, line = (
                int(((p > spot - 8) & (p < end + 8)).all(axis=1).sum()) for p in (pixels, around, along)
            )
            return inner + hides_legend, _SAMPLES * outer + line

        best = min(inside + corners, key=covered)
        if covered(best)[0]:
            shares = np.linspace(0, 1, GRID)
            elsewhere = [EDGE + (room - EDGE) * np.array([x, y]) for y in shares for x in shares]
            best = min([best, *elsewhere], key=covered)
        self.move(int(best[0]), int(best[1]))

    def _near(self) -> tuple[Floats, Floats]:
        """Control points and places of the current curve in pixels; none of a large one."""
        plane, item = self._window.canvas.plane, self._window.selection.item
        if item is None or len(item.curve.control_points) > MOST:
            return np.empty((0, 2)), np.empty((0, 2))
        curve = projected(item.curve)
        return plane.to_pixels(curve.control_points), plane.to_pixels(curve.sample(_SAMPLES))


def _spots(low: Floats, high: Floats, away: float, size: Floats) -> list[Floats]:
    """Top left corners for a card of some size around a rectangle of pixels, the favourite first."""
    left, right, top, bottom = (
        low[0] - away - size[0],
        high[0] + away,
        low[1] - away - size[1],
        high[1] + away,
    )
    middle = (low + high - size) / 2
    places = [(right, bottom), (right, top), (left, bottom), (left, top)]
    places += [(middle[0], bottom), (middle[0], top), (right, middle[1]), (left, middle[1])]
    return [np.array(place) for place in places]
