"""What the mouse does: each drag is a small object that turns moves into an edit, a selection or a new view.

A drag works with points of the plane, so that a view that changes under the hand does not disturb it.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.held import Held, every_point
from theditor.canvas.hit_test import PointHit
from theditor.canvas.projection import projected
from theditor.canvas.snapping import STILL, Snapped, Snapper, moving
from theditor.canvas.viewport import Viewport
from theditor.model import Document, Gesture, Selection
from theditor.model.words import points_counted

Floats = NDArray[np.float64]

SLACK = 3.0
"""A press that moves less than this many pixels is a click."""


class Pointer(NamedTuple):
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
    """Drag the selected control points, of all curves; Ctrl keeps to the horizontal or the vertical.

    The point that was pressed is drawn to what lies near, if snapping is on, but not with Shift or Ctrl held.
    """

    def __init__(
        self, document: Document, selection: Selection, press: Pointer, hit: PointHit, snapper: Snapper
    ) -> None:
        self._document, self._selection, self._snapper = document, selection, snapper
        self._press, self._hit = press, hit
        self._restore = selection.remember()
        self._was_selected = hit.point in selection.chosen.get(hit.curve, ())
        self._gesture: Gesture | None = None
        self._moving = STILL
        self.snapped: Snapped | None = None
        """What the pressed point is drawn to."""
        if press.shift:
            selection.toggle(hit.curve, hit.point)
        elif self._was_selected:
            selection.select_across(selection.chosen, hit.curve)
        else:
            selection.select(curve=hit.curve, points={hit.point})

    def move(self, pointer: Pointer) -> None:
        """Preview the points at their start plus the whole offset."""
        hit = self._hit
        if self._gesture is None:
            if hit.point not in self._selection.chosen[hit.curve]:
                self._selection.toggle(hit.curve, hit.point)
            chosen = self._selection.movable
            self._gesture = self._document.begin(f"Move {points_counted(chosen)}")
            self._held = Held(self._gesture.before, chosen)
            drawing = self._gesture.before
            self._grabbed = projected(drawing[hit.curve].curve).control_points[hit.point]
            self._moving = moving(drawing, chosen) if self._snapper.on else STILL
        offset = pointer.point - self._press.point
        self.snapped = None
        if pointer.ctrl:
            offset[int(np.argmin(np.abs(offset)))] = 0.0
        elif not pointer.shift:
            still = self._gesture.before
            self.snapped = self._snapper(self._grabbed + offset, still, pointer.plane, self._moving)
            if self.snapped is not None:
                offset = self.snapped.point - self._grabbed
        self._gesture.preview(self._held.at(self._held.places + offset))

    def release(self, pointer: Pointer) -> None:
        """Commit the move; a click on one of several selected points selects it alone."""
        if self._gesture is not None:
            self._gesture.commit()
        elif self._was_selected and not self._press.shift:
            self._selection.select(curve=self._hit.curve, points={self._hit.point})

    def cancel(self) -> None:
        """Put the points back; the selection is as before the press."""
        if self._gesture is not None:
            self._gesture.cancel()
        self._restore()


class PickSegment:
    """A press on a curve: makes it current and selects the segment.

    Shift adds the segment to what is selected, or takes it away; so it does with another curve as a whole.
    """

    def __init__(self, selection: Selection, press: Pointer, curve: int, segment: int) -> None:
        self._restore = selection.remember()
        if not press.shift:
            selection.select(curve=curve, points=(), segments={segment})
        elif curve == selection.curve:
            selection.select_across(selection.chosen, curve, selection.segments ^ {segment})
        elif curve in selection.chosen:
            selection.select_across({i: of for i, of in selection.chosen.items() if i != curve})
        else:
            selection.select_across({**selection.chosen, curve: ()})

    def move(self, pointer: Pointer) -> None:
        """The press did all there is to do."""

    def release(self, pointer: Pointer) -> None:
        """The press did all there is to do."""

    def cancel(self) -> None:
        """Select what was selected before the press."""
        self._restore()


class Marquee:
    """A rectangle that selects the control points inside, of all curves that are visible and not locked.

    Shift adds them to what was selected, Ctrl+Shift removes them. A click selects nothing.
    """

    def __init__(self, document: Document, selection: Selection, press: Pointer) -> None:
        self._document, self._selection, self._press = document, selection, press
        self._curve, self._before, self._segments = selection.curve, selection.chosen, selection.segments
        self._restore = selection.remember()
        self.corners: Floats | None = None
        """Two opposite corners in the plane, (2, 2), once it is open."""

    def move(self, pointer: Pointer) -> None:
        """Select what the rectangle holds now."""
        if self.corners is None:
            drawing = self._document.drawing
            self._held = Held(drawing, every_point(drawing))
            self._chosen = self._held.numbers(self._before)
        self.corners = np.stack([self._press.point, pointer.point])
        low, high = self.corners.min(axis=0), self.corners.max(axis=0)
        places = self._held.places
        inside = np.flatnonzero(((places >= low) & (places <= high)).all(axis=1))
        if not self._press.shift:
            self._selection.select_across(self._held.by_curve(inside), self._curve, ())
            return
        combine = np.setdiff1d if self._press.ctrl else np.union1d
        points = self._held.by_curve(combine(self._chosen, inside))
        whole = {i: of for i, of in self._before.items() if not of.size}
        self._selection.select_across({**whole, **points}, self._curve, self._segments)

    def release(self, pointer: Pointer) -> None:
        """Keep the selection."""
        if self.corners is None and not self._press.shift:
            self._selection.select(points=(), segments=())

    def cancel(self) -> None:
        """Select what was selected before the press."""
        self._restore()


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
