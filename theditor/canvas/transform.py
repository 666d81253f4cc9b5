"""The box around several selected points: scaling by its handles, turning by those outside its corners."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from theditor.canvas.held import Held
from theditor.canvas.hit_test import BoxHit
from theditor.canvas.tools import Pointer
from theditor.canvas.viewport import Floats, Viewport
from theditor.model import Colours, Document, Gesture, Selection
from theditor.model.words import number, points_counted
from theditor.spline.extent import extent

MARGIN = 18.0
"""Distance in pixels of the box from the points, whose own handles it leaves free."""
OUTSIDE = 16.0
"""Distance in pixels of the handles for turning from the box's corners, in each direction."""
REACH = 7.0
STEP = np.pi / 12
"""The step in which Ctrl turns."""

_SIDES = [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1) if x or y]


class Box(NamedTuple):
    """The least rectangle around points, by its lowest and highest corner (2,)."""

    low: Floats
    high: Floats

    def place(self, sides: tuple[int, int], plane: Viewport, beyond: float) -> Floats:
        """The pixel of a corner or the middle of a side, `beyond` pixels outside."""
        direction = np.array(sides, dtype=np.float64)
        point = (self.low + self.high) / 2 + direction * (self.high - self.low) / 2
        return plane.to_pixels(point) + beyond * direction * (1, -1)


def box_around(places: Floats) -> Box | None:
    """The box around places (n, 2); None if they are not at least two different ones."""
    if len(places) < 2:
        return None
    low, high = extent(places)
    return Box(low, high) if (low < high).any() else None


def pick_box(box: Box, at: Floats, plane: Viewport) -> BoxHit | None:
    """The handle of a box at a pixel (2,)."""
    kinds: tuple[tuple[Literal["scale", "turn"], float], ...] = (
        ("scale", MARGIN),
        ("turn", MARGIN + OUTSIDE),
    )
    for kind, beyond in kinds:
        for sides in handles(box, kind):
            if np.hypot(*(box.place(sides, plane, beyond) - at)) <= REACH:
                return BoxHit(kind, *sides)
    return None


def handles(box: Box, kind: Literal["scale", "turn"]) -> list[tuple[int, int]]:
    """The sides at which there are handles: none that would stretch what has no extent."""
    size = box.high - box.low
    if kind == "turn":
        return [sides for sides in _SIDES if all(sides)]
    return [sides for sides in _SIDES if all(size[axis] > 0 for axis in (0, 1) if sides[axis])]


def grips(places: Floats, plane: Viewport) -> Floats:
    """The pixels (n, 2) of all handles of the box around places."""
    box = box_around(places)
    if box is None:
        return np.empty((0, 2))
    scale = [box.place(sides, plane, MARGIN) for sides in handles(box, "scale")]
    turn = [box.place(sides, plane, MARGIN + OUTSIDE) for sides in handles(box, "turn")]
    return np.array(scale + turn)


def paint_box(painter: QPainter, box: Box, plane: Viewport, colours: Colours) -> None:
    """Paint the box with its handles: squares to scale, rings to turn."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    low, high = box.place((-1, 1), plane, MARGIN), box.place((1, -1), plane, MARGIN)
    frame = QPen(QColor(colours.accent), 1)
    painter.setPen(frame)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawRect(QRectF(QPointF(*low.clip(-1e4, 1e4)), QPointF(*high.clip(-1e4, 1e4))))
    painter.setBrush(QColor(colours.canvas))
    for sides in handles(box, "scale"):
        x, y = box.place(sides, plane, MARGIN).clip(-1e4, 1e4).tolist()
        painter.drawRect(QRectF(x - 3.5, y - 3.5, 7, 7))
    for sides in handles(box, "turn"):
        painter.drawEllipse(QPointF(*box.place(sides, plane, MARGIN + OUTSIDE).clip(-1e4, 1e4)), 4, 4)
    painter.setBrush(Qt.BrushStyle.NoBrush)


class Transform:
    """Drag a handle of the box: the selected points are scaled about the opposite side, or turned about the middle.

    With Shift they are scaled about the middle, or turned about the opposite corner. Ctrl keeps proportions,
    or turns in steps of 15°.
    """

    def __init__(
        self, document: Document, selection: Selection, press: Floats, hit: BoxHit, box: Box
    ) -> None:
        self._document, self._selection = document, selection
        self._press, self._hit, self._box = press, hit, box
        self._chosen = selection.movable
        self.turns = hit.kind == "turn"
        self.told = ""
        """What is done so far: by what factors, or by what angle."""
        self._gesture: Gesture | None = None

    def move(self, pointer: Pointer) -> None:
        """Preview the points where the pointer takes them."""
        if self._gesture is None:
            verb = "Turn" if self.turns else "Scale"
            self._gesture = self._document.begin(f"{verb} {points_counted(self._chosen)}")
            self._held = Held(self._gesture.before, self._chosen)
        new = (self._turned if self.turns else self._scaled)(self._held.places, pointer)
        self._gesture.preview(self._held.at(new))

    def _corner(self, sign: int) -> Floats:
        """The corner or side that is held (1), or the opposite one (−1)."""
        direction = sign * np.array([self._hit.x, self._hit.y])
        corner: Floats = self._middle + direction * (self._box.high - self._box.low) / 2
        return corner

    @property
    def _middle(self) -> Floats:
        middle: Floats = (self._box.low + self._box.high) / 2
        return middle

    def _scaled(self, points: Floats, pointer: Pointer) -> Floats:
        anchor = self._middle if pointer.shift else self._corner(-1)
        arm = self._corner(1) - anchor
        reached = arm + pointer.point - self._press
        held = np.array([self._hit.x, self._hit.y]) != 0
        factors = np.ones(2)
        if pointer.ctrl:
            factors[:] = np.dot(reached[held], arm[held]) / np.dot(arm[held], arm[held])
        else:
            factors[held] = reached[held] / arm[held]
        across, up = (number(round(float(factor), 4)) for factor in factors)
        self.told = f"Scaled by {across}" if across == up else f"Scaled by {across} in x, {up} in y"
        return anchor + (points - anchor) * factors

    def _turned(self, points: Floats, pointer: Pointer) -> Floats:
        anchor = self._corner(-1) if pointer.shift else self._middle
        (x0, y0), (x1, y1) = self._press - anchor, pointer.point - anchor
        angle = np.arctan2(y1, x1) - np.arctan2(y0, x0)
        if pointer.ctrl:
            angle = np.round(angle / STEP) * STEP
        degrees = np.degrees(np.arctan2(np.sin(angle), np.cos(angle)))
        self.told = f"Turned by {number(round(float(degrees), 2))}°"
        turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
        turned: Floats = anchor + (points - anchor) @ turn
        return turned

    def release(self, pointer: Pointer) -> None:
        """Commit what was done."""
        if self._gesture is not None:
            self._gesture.commit()

    def cancel(self) -> None:
        """Put the points back."""
        if self._gesture is not None:
            self._gesture.cancel()
