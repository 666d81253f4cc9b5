"""What the mouse does: each drag is a small object that turns moves into an edit, a selection or a new view.

A drag works with points of the plane, so that a view that changes under the hand does not disturb it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.projection import moved, projected
from theditor.canvas.snapping import STILL, Snapped, Snapper, moving
from theditor.canvas.viewport import Viewport
from theditor.model import Document, Gesture, Selection
from theditor.spline import MAX_COORDINATE

Floats = NDArray[np.float64]

SLACK = 3.0
"""A press that moves less than this many pixels is a click."""


@dataclass(frozen=True)
class Pointer:
    """Where the mouse is, in pixels (2,) and as a point of the plane (2,), and which keys are held."""

    at: Floats
    point: Floats
    plane: Viewport
    """What is in view."""
    shift: bool = False
    ctrl: bool = False


class Drag(Protocol):
    """A press, what follows it, and its end: `release` or `cancel`."""

    def move(self, pointer: Pointer) -> None:
        """Follow the pointer, which has left the place of the press."""

    def release(self, pointer: Pointer) -> None:
        """Finish. Without a `move` before it this was a click."""

    def cancel(self) -> None:
        """Take back everything since the press."""


class Still:
    """A press that has already done all there is to do."""

    def move(self, pointer: Pointer) -> None:
        """Nothing moves."""

    def release(self, pointer: Pointer) -> None:
        """Nothing is left to do."""

    def cancel(self) -> None:
        """What was done is an undo step of its own, or a selection."""


class MovePoints:
    """Drag the selected control points; Ctrl keeps to the horizontal or the vertical.

    The point that was pressed is drawn to what lies near, if snapping is on, but not with Shift or Ctrl held.
    """

    def __init__(
        self, document: Document, selection: Selection, press: Pointer, index: int, snapper: Snapper
    ) -> None:
        self._document, self._selection, self._snapper = document, selection, snapper
        self._press, self._index = press, index
        self._curve = selection.curve
        self._was_selected = index in selection.points
        self._points_before = selection.points
        self._gesture: Gesture | None = None
        self._moving = STILL
        self.snapped: Snapped | None = None
        """What the pressed point is drawn to."""
        if press.shift:
            selection.select(points=selection.points ^ {index})
        elif not self._was_selected:
            selection.select(points={index})

    def move(self, pointer: Pointer) -> None:
        """Preview the points at their start plus the whole offset."""
        item = self._selection.item
        if item is None or item.locked:
            return
        if self._gesture is None:
            if self._index not in self._selection.points:
                self._selection.select(points=self._selection.points | {self._index})
            chosen = sorted(self._selection.points)
            self._chosen = np.array(chosen, dtype=np.intp)
            text = "Move control point" if len(chosen) == 1 else f"Move {len(chosen)} control points"
            self._gesture = self._document.begin(text)
            self._moving = moving(self._curve, projected(item.curve), self._chosen)
        before = self._gesture.before
        curve = before[self._curve].curve
        offset = pointer.point - self._press.point
        self.snapped = None
        if pointer.ctrl:
            offset[int(np.argmin(np.abs(offset)))] = 0.0
        elif not pointer.shift:
            grabbed = projected(curve).control_points[self._index]
            self.snapped = self._snapper(
                grabbed + offset, self._document.drawing, pointer.plane, self._moving
            )
            if self.snapped is not None:
                offset = self.snapped.point - grabbed
        points = moved(curve.control_points[self._chosen], offset).clip(-MAX_COORDINATE, MAX_COORDINATE)
        self._gesture.preview(before.with_curve(self._curve, curve.with_points(self._chosen, points)))

    def release(self, pointer: Pointer) -> None:
        """Commit the move; a click on one of several selected points selects it alone."""
        if self._gesture is not None:
            self._gesture.commit()
        elif self._was_selected and not self._press.shift:
            self._selection.select(points={self._index})

    def cancel(self) -> None:
        """Put the points back; the selection is as before the press."""
        if self._gesture is not None:
            self._gesture.cancel()
        self._selection.select(points=self._points_before)


class PickSegment:
    """A press on a curve: makes it current and selects the segment; Shift adds to or removes from the selection."""

    def __init__(self, selection: Selection, press: Pointer, curve: int, segment: int) -> None:
        self._selection = selection
        self._before = selection.curve, selection.points, selection.segments
        if press.shift and curve == selection.curve:
            selection.select(segments=selection.segments ^ {segment})
        else:
            selection.select(curve=curve, points=(), segments={segment})

    def move(self, pointer: Pointer) -> None:
        """The press did all there is to do."""

    def release(self, pointer: Pointer) -> None:
        """The press did all there is to do."""

    def cancel(self) -> None:
        """Select what was selected before the press."""
        curve, points, segments = self._before
        self._selection.select(curve=curve, points=points, segments=segments)


class Marquee:
    """A rectangle that selects the control points inside; Shift adds, Ctrl+Shift removes. A click selects nothing."""

    def __init__(self, selection: Selection, press: Pointer) -> None:
        self._selection, self._press = selection, press
        self._before = selection.points, selection.segments
        self.corners: Floats | None = None
        """Two opposite corners in the plane, (2, 2), once it is open."""

    def move(self, pointer: Pointer) -> None:
        """Select what the rectangle holds now."""
        self.corners = np.stack([self._press.point, pointer.point])
        item = self._selection.item
        if item is None or item.locked or not item.visible:
            return
        held = projected(item.curve).control_points
        low, high = self.corners.min(axis=0), self.corners.max(axis=0)
        inside = frozenset(np.flatnonzero(((held >= low) & (held <= high)).all(axis=1)).tolist())
        points, segments = self._before
        if self._press.shift and self._press.ctrl:
            inside = points - inside
        elif self._press.shift:
            inside = points | inside
        self._selection.select(points=inside, segments=segments if self._press.shift else ())

    def release(self, pointer: Pointer) -> None:
        """Keep the selection."""
        if self.corners is None and not self._press.shift:
            self._selection.select(points=(), segments=())

    def cancel(self) -> None:
        """Select what was selected before the press."""
        points, segments = self._before
        self._selection.select(points=points, segments=segments)


class Pan:
    """Moves the view with the hand."""

    def __init__(self, viewport: Viewport, press: Pointer, show: ShowView) -> None:
        self._viewport, self._press, self._show = viewport, press, show

    def move(self, pointer: Pointer) -> None:
        """Keep the point that was pressed under the pointer."""
        before = self._viewport
        offset = before.to_points(self._press.at) - before.to_points(pointer.at)
        self._show(before.x + float(offset[0]), before.y + float(offset[1]), before.scale)

    def release(self, pointer: Pointer) -> None:
        """The view stays where it is."""

    def cancel(self) -> None:
        """Go back to the view before the press."""
        self._show(self._viewport.x, self._viewport.y, self._viewport.scale)


class ShowView(Protocol):
    """Shows the plane around a point at a scale in pixels per unit."""

    def __call__(self, x: float, y: float, scale: float) -> None:
        """Show it."""
