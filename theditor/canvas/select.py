"""The tool to select and move with: what is under the pointer decides what a press takes hold of."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt

from theditor.canvas import points
from theditor.canvas.held import Held, every_point
from theditor.canvas.hit_test import (
    REACH,
    BoxHit,
    Hit,
    JointHit,
    MiddleHit,
    PointHit,
    SegmentHit,
    parameter_of,
)
from theditor.canvas.nudge import ARROWS, nudge
from theditor.canvas.picking import Key, key_of, locked_at, pick
from theditor.canvas.projection import projected
from theditor.canvas.shaping import PullCurve, SlideJoint
from theditor.canvas.snapping import Snapped
from theditor.canvas.tool import Bench, Keys
from theditor.canvas.tools import SLACK, Drag, Marquee, MovePoints, Pointer, Still
from theditor.canvas.transform import Box, Transform, box_around, pick_box
from theditor.canvas.viewport import Floats, Viewport
from theditor.drawing import Drawing
from theditor.model.words import indexed, locked_reason, number

Ints = NDArray[np.intp]


class SelectTool:
    """Selects, moves and shapes. A second click at the same place reaches what lies beneath."""

    sketch = None
    snapped: Snapped | None = None
    hint = ""
    cursor = None

    def __init__(self, bench: Bench) -> None:
        self._bench = bench
        self._clicked: tuple[Floats, Viewport] | None = None
        self._reached: list[Key | None] = []
        self._pressed: Key | None = None
        self._beneath = False
        self._made_current = False
        self._grips: _Grips | None = None

    def hits(self, at: Floats) -> list[Hit]:
        """What can be grabbed at a pixel, topmost first."""
        bench = self._bench
        plane = bench.view.plane
        selection = bench.selection
        hits = pick(at, bench.document.drawing, selection.curve, self._held.handles, bench.curves, plane)
        box = self.box
        grip = pick_box(box, at, plane) if box is not None else None
        if grip is not None:
            hits.insert(sum(isinstance(hit, PointHit) for hit in hits), grip)
        return hits

    @property
    def box(self) -> Box | None:
        """The box around the selected points that can be moved."""
        return self._held.box

    @property
    def _held(self) -> _Grips:
        """What selected curves are held by, found anew only when they or the selection are others."""
        drawing, chosen = self._bench.document.drawing, self._bench.selection.chosen
        grips = self._grips
        if grips is None or grips.drawing is not drawing or grips.chosen is not chosen:
            grips = self._grips = _Grips(drawing, chosen, self._bench.selection.movable)
        return grips

    def hover(self, pointer: Pointer) -> Hit:
        """What would be grabbed."""
        return next(iter(self.hits(pointer.at)), None)

    def press(self, pointer: Pointer, *, double: bool) -> Drag:
        """Take hold of what the last click here chose, else of the topmost; a double click acts at once."""
        if double:
            self._clicked = None
            return self._act(pointer)
        if not self._again(pointer):
            self._reached = []
        bench, hits = self._bench, self.hits(pointer.at)
        last = self._reached[-1] if self._reached else None
        held = next((hit for hit in hits if key_of(hit, bench.selection.curve) == last), None)
        self._beneath = held is not None and not (pointer.shift or pointer.ctrl)
        current, chosen = bench.selection.curve, held or next(iter(hits), None)
        self._pressed = key_of(chosen, current)
        if chosen is None:
            self._explain_lock(pointer)
        drag = self._drag_for(chosen, pointer)
        self._made_current = bench.selection.curve != current
        return drag

    def _explain_lock(self, pointer: Pointer) -> None:
        """Say why nothing is taken hold of, if what is pressed is locked."""
        bench = self._bench
        drawing, current = bench.document.drawing, bench.selection.curve
        locked = locked_at(pointer.at, drawing, current, bench.curves, pointer.plane)
        if locked is not None:
            bench.say(locked_reason(drawing[locked].name))

    def _again(self, pointer: Pointer) -> bool:
        """Whether the last click was here, in the same view."""
        if self._clicked is None:
            return False
        at, plane = self._clicked
        return plane == self._bench.view.plane and bool(np.hypot(*(pointer.at - at)) < SLACK)

    def _act(self, pointer: Pointer) -> Drag:
        selection = self._bench.selection
        if self._made_current and selection.item is not None:
            selection.select(points=range(len(selection.item.curve.control_points)), segments=())
            return Still()
        if self._inserts(pointer):
            return Still()
        return self.press(pointer, double=False)

    def _inserts(self, pointer: Pointer) -> bool:
        """Insert a control point on the current curve or, with Ctrl, on an edge of its polygon."""
        bench, current = self._bench, self._bench.selection.curve
        hit = self.hover(pointer)
        item = bench.selection.item
        if item is None or item.locked or not item.visible or isinstance(hit, PointHit):
            return False
        if pointer.ctrl:
            edge = points.near_edge(pointer.plane.to_pixels(projected(item.curve).polygon), pointer.at, REACH)
            if edge is None:
                return False
            bench.say(points.insert_on_edge(bench.document, bench.selection, *edge))
            return True
        u = parameter_of(hit, current, item.curve)
        if u is None:
            return False
        points.insert_at(bench.document, bench.selection, u, bench.say)
        return True

    def click(self, drag: Drag, pointer: Pointer) -> None:
        """Choose what was pressed or, if the last click here chose just that, what lies beneath."""
        if isinstance(drag, Still):
            return
        if self._beneath:
            drag.cancel()
            drag = self._drag_for(self._next(pointer.at), pointer)
        else:
            self._reached = [self._pressed]
        self._clicked = pointer.at, self._bench.view.plane
        drag.release(pointer)

    def _next(self, at: Floats) -> Hit:
        """The first hit that clicks here have not reached yet; once all are reached, they are gone through anew."""
        current, hits = self._bench.selection.curve, self.hits(at)
        if all(key_of(hit, current) in self._reached for hit in hits):
            self._reached = self._reached[-1:]
        hit = next((hit for hit in hits if key_of(hit, current) not in self._reached), hits[0])
        self._reached.append(key_of(hit, current))
        return hit

    def _drag_for(self, hit: Hit, pointer: Pointer) -> Drag:
        bench = self._bench
        document, selection = bench.document, bench.selection
        if isinstance(hit, PointHit):
            return MovePoints(document, selection, pointer, hit, bench.snapper)
        if isinstance(hit, SegmentHit):
            return PullCurve(document, selection, pointer, hit, bench.bounds(hit.curve))
        box = self.box
        if isinstance(hit, BoxHit) and box is not None:
            return Transform(document, selection, pointer.point, hit, box)
        if isinstance(hit, JointHit | MiddleHit):
            return SlideJoint(document, selection, pointer, hit, bench.bounds(selection.curve))
        return Marquee(document, selection, pointer)

    def key(self, keys: Keys) -> bool:
        """Tab steps through the control points, arrows nudge them, Escape selects nothing.

        Delete comes here only while there is nothing that the command could delete.
        """
        if keys.key == Qt.Key.Key_Escape:
            self._bench.selection.select(points=(), segments=())
            return True
        if keys.key in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab):
            return self._step(backward=keys.key == Qt.Key.Key_Backtab or keys.shift)
        if keys.key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self._bench.say("No control point is selected; whole curves are deleted in the list of curves.")
            return True
        nudged = nudge(self._bench, keys)
        if nudged and len(self._bench.selection.points) == self._bench.selection.count == 1:
            self._tell_place()
        return nudged

    def _step(self, *, backward: bool) -> bool:
        """Select the next control point alone, show it and tell where it is; round the curve."""
        selection = self._bench.selection
        item = selection.item
        if item is None or item.locked or not item.visible:
            return False
        count, chosen = len(item.curve.control_points), selection.points
        last = min(chosen, default=0) if backward else max(chosen, default=-1)
        index = (last + (-1 if backward else 1)) % count
        selection.select(points={index}, segments=())
        self._bench.view.reveal(item.curve.control_points[index][:2])
        self._tell_place()
        return True

    def _tell_place(self) -> None:
        """Tell where the one selected control point is, and its λ."""
        item = self._bench.selection.item
        assert item is not None, "the point is on the current curve"
        (index,) = self._bench.selection.points
        where = ", ".join(number(x) for x in item.curve.control_points[index].tolist())
        lam = number(float(item.curve.lambdas[index]))
        self._bench.say(f"{indexed('P', index)} at ({where}), {indexed('λ', index)} = {lam}")

    @property
    def keys(self) -> frozenset[int]:
        """The arrows, while there are points to nudge."""
        return frozenset(ARROWS) if self._bench.selection.movable else frozenset()

    def leave(self) -> None:
        """Let go of what is selected: other tools do nothing with it."""
        self._bench.selection.select(points=(), segments=())


class _Grips:
    """What the selected curves of a drawing are held by: the handles of their control points, and the box."""

    def __init__(self, drawing: Drawing, chosen: Mapping[int, Ints], movable: Mapping[int, Ints]) -> None:
        self.drawing, self.chosen, self._movable = drawing, chosen, movable

    @cached_property
    def handles(self) -> Held:
        """The control points of the selected curves that can be edited."""
        return Held(self.drawing, every_point(self.drawing, self.chosen))

    @cached_property
    def box(self) -> Box | None:
        """The box around the selected points."""
        return box_around(Held(self.drawing, self._movable).places)
