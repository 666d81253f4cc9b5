"""The pen: places control points one by one, and shows the curve to come."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from PySide6.QtCore import QSettings, Qt

from theditor.canvas.hit_test import REACH, Hit
from theditor.canvas.sketch import Sketch
from theditor.canvas.snapping import Snapped
from theditor.canvas.tool import Bench, Keys
from theditor.canvas.tools import SLACK, Drag, Pointer, Still
from theditor.canvas.viewport import Floats
from theditor.spline import MAX_COORDINATE, Curve, fewest_points

DEGREE_KEYS: dict[int, int] = {Qt.Key.Key_2: 2, Qt.Key.Key_3: 3}
KINDS = {2: "quadratic", 3: "cubic"}
CLOSES = "close the curve"


class PenTool:
    """Each press places a control point of a clamped curve; one on the first point closes it.

    Enter or a double click ends the curve, Backspace takes the last point back, Escape gives the curve up
    and, when there is none, leaves. The degree is kept for the next curve.
    """

    keys = frozenset(
        {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Backspace, Qt.Key.Key_Escape, *DEGREE_KEYS}
    )
    cursor = Qt.CursorShape.CrossCursor

    def __init__(self, bench: Bench, done: Callable[[], None]) -> None:
        self._bench, self._done = bench, done
        self._points: list[Floats] = []
        self._at: Floats | None = None
        self._closing = False
        self.snapped: Snapped | None = None

    @property
    def degree(self) -> int:
        """The degree of the curve to come: that of the last one drawn."""
        return preferred_degree()

    @property
    def hint(self) -> str:
        """What the mouse and the keys would do."""
        if not self._points:
            other = 5 - self.degree
            return (
                f"Click: first control point of a {KINDS[self.degree]} · {other}: {KINDS[other]} · Esc: leave"
            )
        return "Click: next control point · Enter: end · Backspace: take one back · Esc: give up"

    @property
    def sketch(self) -> Sketch | None:
        """The control points, the one at the pointer included, and their curve."""
        points = list(self._points)
        if not points:
            return None
        if self._at is not None and not self._closing:
            apart = np.hypot(*(self._at - points[-1])) * self._bench.view.plane.scale
            points += [self._at] if apart > SLACK else []
        shape = np.array(points + points[:1] if self._closing else points)
        return Sketch(shape, self._curve(points, closed=self._closing))

    def _curve(self, points: list[Floats], *, closed: bool) -> Curve | None:
        if len(points) < fewest_points(self.degree, closed, "clamped"):
            return None
        return Curve(points, degree=self.degree, closed=closed, ends="clamped")

    def hover(self, pointer: Pointer) -> Hit:
        """Move the point to come; nothing of the drawing would be grabbed."""
        self._at = self._placed(pointer)
        return None

    def _placed(self, pointer: Pointer) -> Floats:
        """Where a control point would go: at the pointer or at what it is drawn to."""
        self._closing, self.snapped = False, None
        point = pointer.point.clip(-MAX_COORDINATE, MAX_COORDINATE)
        if len(self._points) >= fewest_points(self.degree, True, "clamped"):
            first = self._points[0]
            if np.hypot(*(pointer.plane.to_pixels(first) - pointer.at)) <= REACH:
                self._closing, self.snapped = True, Snapped(first, CLOSES)
                return first
        if pointer.ctrl and self._points:
            offset = point - self._points[-1]
            offset[int(np.argmin(np.abs(offset)))] = 0.0
            return self._points[-1] + offset
        if not pointer.shift:
            self.snapped = self._bench.snapper(point, self._bench.document.drawing, pointer.plane)
        return point if self.snapped is None else self.snapped.point

    def press(self, pointer: Pointer, *, double: bool) -> Drag:
        """Place a control point, to be moved while the button is down, or end the curve."""
        point = self._placed(pointer)
        if double or self._closing:
            if self._points:
                self._end(closed=self._closing)
            return Still()
        self._at = None
        self._points.append(point)
        return _Placing(self)

    def click(self, drag: Drag, pointer: Pointer) -> None:
        """The press placed the point."""
        drag.release(pointer)

    def replace(self, pointer: Pointer) -> None:
        """Move the last control point."""
        self._points.pop()
        self._points.append(self._placed(pointer))

    def take_back(self) -> None:
        """Take the last control point back."""
        if self._points:
            self._points.pop()
        self._closing = False

    def key(self, keys: Keys) -> bool:
        """End, take back, give up or leave, or change the degree."""
        match keys.key:
            case Qt.Key.Key_Return | Qt.Key.Key_Enter if self._points:
                self._end(closed=False)
            case Qt.Key.Key_Backspace:
                self.take_back()
            case Qt.Key.Key_Escape if self._points:
                self._points.clear()
            case Qt.Key.Key_Escape:
                self._done()
            case Qt.Key.Key_2 | Qt.Key.Key_3:
                QSettings().setValue("pen_degree", DEGREE_KEYS[keys.key])
            case _:
                return False
        return True

    def _end(self, *, closed: bool) -> None:
        curve = self._curve(self._points, closed=closed)
        if curve is None:
            least = fewest_points(self.degree, closed, "clamped")
            self._bench.say(
                f"A {KINDS[self.degree]} curve needs at least {least} control points: click on, or give it up."
            )
            return
        self._points.clear()
        self._closing, self.snapped = False, None
        self._bench.draw(curve)

    def leave(self) -> None:
        """Keep the curve as it is, if it is one already."""
        if self._curve(self._points, closed=False) is not None:
            self._end(closed=False)
        self._points.clear()
        self.snapped = None


def preferred_degree() -> int:
    """The degree of the curve last drawn, 3 at first."""
    return 2 if str(QSettings().value("pen_degree", 3)) == "2" else 3


class _Placing:
    """A press that placed a control point, which follows the pointer until the button is let go."""

    def __init__(self, pen: PenTool) -> None:
        self._pen = pen

    def move(self, pointer: Pointer) -> None:
        """Move the point."""
        self._pen.replace(pointer)

    def release(self, pointer: Pointer) -> None:
        """The point stays."""

    def cancel(self) -> None:
        """Take the point back."""
        self._pen.take_back()
