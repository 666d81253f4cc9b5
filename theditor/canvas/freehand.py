"""The freehand tool: a stroke of the hand becomes a curve with as few control points as follow it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from PySide6.QtCore import QSettings, Qt

from theditor.canvas.hit_test import REACH, Hit
from theditor.canvas.pen import preferred_degree
from theditor.canvas.sketch import Sketch
from theditor.canvas.tool import Bench, Keys
from theditor.canvas.tools import Drag, Pointer
from theditor.canvas.viewport import Floats
from theditor.model.words import counted, number
from theditor.model.worker import Report
from theditor.spline import MAX_COORDINATE
from theditor.spline.fit import Fitted, fit

TOLERANCE = 2.0
"""How far a curve may be from its stroke, in pixels, unless the user prefers otherwise."""
AT_ONCE = 300
"""Strokes of more points than this are fitted as long work."""
LOOP = 8
"""A stroke that comes back to its start is closed if its box is this many times as large as the reach."""
_GAP = np.full((1, 2), np.nan)


@dataclass(eq=False)
class _Waiting:
    """A stroke that is being fitted."""

    stroke: Floats
    call_off: Callable[[], None] | None = None


class FreehandTool:
    """Press, draw and let go: the stroke is fitted by a curve. One that ends where it began is closed."""

    keys = frozenset({Qt.Key.Key_Escape})
    cursor = Qt.CursorShape.CrossCursor
    snapped = None
    hint = "Drag: draw a stroke, which becomes a curve · Back at its start: closed · Esc: leave"

    def __init__(self, bench: Bench, done: Callable[[], None]) -> None:
        self._bench, self._done = bench, done
        self._stroke: list[Floats] = []
        self._waiting: list[_Waiting] = []

    @property
    def sketch(self) -> Sketch | None:
        """The stroke so far, and those that are still to become curves."""
        strokes = [*(waiting.stroke for waiting in self._waiting), np.array(self._stroke)]
        lines = [part for stroke in strokes if len(stroke) > 1 for part in (stroke, _GAP)]
        return Sketch(np.concatenate(lines[:-1]), handles=False) if lines else None

    def hover(self, pointer: Pointer) -> Hit:
        """Nothing of the drawing would be grabbed."""
        return None

    def press(self, pointer: Pointer, *, double: bool) -> Drag:
        """Begin a stroke."""
        self._stroke = [_within(pointer.point)]
        return _Stroke(self)

    def click(self, drag: Drag, pointer: Pointer) -> None:
        """Draw nothing: a place is no stroke."""
        drag.cancel()

    def extend(self, pointer: Pointer) -> None:
        """Lead the stroke on to the pointer."""
        self._stroke.append(_within(pointer.point))

    def give_up(self) -> None:
        """Forget the stroke."""
        self._stroke = []

    def finish(self, pointer: Pointer) -> None:
        """Turn the stroke into a curve, long ones beside the window."""
        stroke, scale = np.array(self._stroke), pointer.plane.scale
        self._stroke = []
        size = float(np.ptp(stroke, axis=0).max())
        gap = float(np.hypot(*(stroke[-1] - stroke[0])))
        loop = gap * scale <= REACH and size * scale >= LOOP * REACH
        degree, tolerance = preferred_degree(), preferred_tolerance() / scale

        def fitted(report: Report) -> Fitted | None:
            try:
                return fit(stroke, degree, tolerance, closed=loop, progress=partial(report, 0.0))
            except ValueError:
                return None

        if len(stroke) <= AT_ONCE:
            self._draw(fitted(lambda share: None), scale)
            return
        chosen = self._bench.selection.chosen

        def arrive(result: Fitted | None) -> None:
            give_up()
            # What was selected meanwhile stays so.
            self._draw(result, scale, current=self._bench.selection.chosen is chosen)

        def give_up() -> None:
            self._waiting.remove(waiting)
            self._bench.view.viewport().update()

        waiting = _Waiting(stroke)
        self._waiting.append(waiting)
        start = self._bench.document.worker.start
        waiting.call_off = start("Fitting the stroke", fitted, arrive, give_up, bound=True, precious=True)

    def _draw(self, result: Fitted | None, scale: float, *, current: bool = True) -> None:
        """Add the curve, if there is one, and tell how near it is."""
        if result is None:
            self._bench.say("The stroke stayed in one place: draw a longer one.")
            return
        self._bench.draw(result.curve, current=current)
        points = counted(len(result.curve.control_points), "control point")
        away = number(round(result.deviation * scale, 1))
        self._bench.say(f"Drew a curve of {points}, at most {away} px from the stroke")

    def key(self, keys: Keys) -> bool:
        """Escape calls off the strokes that are being fitted; if there are none, it leaves."""
        if keys.key != Qt.Key.Key_Escape:
            return False
        if not self._waiting:
            self._done()
        for waiting in [*self._waiting]:
            if waiting.call_off is not None:
                waiting.call_off()
        return True

    def leave(self) -> None:
        """A stroke under way is given up with its drag."""


class _Stroke:
    """A press and the stroke that follows it."""

    def __init__(self, tool: FreehandTool) -> None:
        self._tool = tool

    def move(self, pointer: Pointer) -> None:
        """Lead the stroke on."""
        self._tool.extend(pointer)

    def release(self, pointer: Pointer) -> None:
        """Make a curve of it."""
        self._tool.finish(pointer)

    def cancel(self) -> None:
        """Forget it."""
        self._tool.give_up()


def preferred_tolerance() -> float:
    """The tolerance that the user prefers, in pixels."""
    try:
        tolerance = float(str(QSettings().value("freehand_tolerance", TOLERANCE)))
    except ValueError:
        return TOLERANCE
    return tolerance if 0.1 <= tolerance <= 100.0 else TOLERANCE


def _within(point: Floats) -> Floats:
    return point.clip(-MAX_COORDINATE, MAX_COORDINATE)
