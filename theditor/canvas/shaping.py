"""Shaping the curve by taking hold of the curve itself: λ follow, the control points stay."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.hit_test import JointHit, MiddleHit, SegmentHit
from theditor.canvas.projection import moved, projected
from theditor.canvas.tools import PickSegment, Pointer
from theditor.model import Document, Gesture, Selection
from theditor.model.words import indexed, listed, number
from theditor.spline import (
    INTERPOLATING,
    MAX_COORDINATE,
    Curve,
    Track,
    joint_track,
    middle_track,
    pull,
    pull_points,
)

Floats = NDArray[np.float64]
Bounds = tuple[float, float]

MAGNET = 6.0
"""A joint this near to where a mode would put it is put there exactly, in pixels."""


class PullCurve:
    """Drag a place on the curve: both λ of its segment are solved so that it follows the pointer.

    Ctrl pulls with the nearer λ alone; Shift moves the control points instead, by the least change. A press
    without a drag selects the segment.
    """

    def __init__(
        self,
        document: Document,
        selection: Selection,
        press: Pointer,
        hit: SegmentHit,
        bounds: Bounds,
    ) -> None:
        self._pick = PickSegment(selection, press, hit.curve, hit.segment)
        self._document, self._bounds = document, bounds
        self._index, self._press = hit.curve, press
        self._u = hit.segment + min(max(hit.t, 0.0), 1.0)
        self._gesture: Gesture | None = None
        self.miss: Floats | None = None
        """What was reached and what was asked for, (2, 2)."""
        self.note = ""

    def move(self, pointer: Pointer) -> None:
        """Preview the curve through the pointer, or as near to it as λ can bring it."""
        if self._gesture is None:
            if self._press.shift:
                self._pick.cancel()  # a Shift that drags is no Shift+click
            self._gesture = self._document.begin("Pull the curve")
        before = self._gesture.before[self._index].curve
        plane = projected(before)
        grip = plane(self._u) - self._press.point
        target = (pointer.point + grip).clip(-MAX_COORDINATE, MAX_COORDINATE)
        if pointer.shift:
            curve, reached = self._move_points(before, plane, target)
        else:
            curve, reached = self._pull(before, plane, target, nearer=pointer.ctrl)
        self.miss = np.stack([reached, target])
        self._gesture.preview(self._gesture.before.with_curve(self._index, curve))

    def _pull(self, before: Curve, plane: Curve, target: Floats, *, nearer: bool) -> tuple[Curve, Floats]:
        pulled = pull(plane, self._u, target, self._bounds, "nearer" if nearer else "both")
        self.note = self._bound_note(plane, pulled.curve, pulled.at_bound)
        curve = pulled.curve if plane is before else before.with_(lambdas=pulled.curve.lambdas)
        return curve, target - pulled.residual

    def _bound_note(self, plane: Curve, pulled: Curve, held: tuple[int, ...]) -> str:
        """What keeps the curve from the pointer, if λ does."""
        if plane.degree == 2 and self._u == round(self._u):
            return "λ does not move a quadratic's joint: drag beside it"
        low, high = self._bounds
        outside = [i for i in held if not low <= pulled.lambdas[i] <= high]
        if outside:
            return f"{values_of(pulled, outside)}: already beyond {number(low)} … {number(high)}"
        return f"{values_of(pulled, held)}: as far as the pull goes" if held else ""

    def _move_points(self, before: Curve, plane: Curve, target: Floats) -> tuple[Curve, Floats]:
        self.note = ""
        try:
            new = pull_points(plane, self._u, target)
        except ValueError:  # a point would leave the range of coordinates: stay
            return before, plane(self._u)
        if plane is not before:
            shift = new.control_points - plane.control_points
            new = before.with_(control_points=moved(before.control_points, shift))
        return new, target

    def release(self, pointer: Pointer) -> None:
        """Commit the pull."""
        if self._gesture is not None:
            self._gesture.commit()

    def cancel(self) -> None:
        """Put the curve back; the selection is as before the press."""
        if self._gesture is not None:
            self._gesture.cancel()
        self._pick.cancel()


class SlideJoint:
    """Drag a cubic's joint along its track, or the middle of a quadratic's segment along its own.

    Two λ that differ keep their difference. It is drawn to where T, H and λ* would put it, unless Shift is held.
    """

    def __init__(
        self,
        document: Document,
        selection: Selection,
        press: Pointer,
        hit: JointHit | MiddleHit,
        bounds: Bounds,
    ) -> None:
        self._document = document
        self._curve = selection.curve
        self._press, self._bounds = press, bounds
        self._restore = selection.remember()
        item = selection.item
        assert item is not None, "what is hit is on the current curve"
        plane = projected(item.curve)
        self._degree = plane.degree
        self._indices = shaped_by(plane, hit)
        self._lambdas = plane.lambdas[self._indices]
        self._direction = track_of(plane, hit).direction
        self.note = ""
        self._gesture: Gesture | None = None
        if isinstance(hit, JointHit):
            if press.shift:
                selection.toggle(selection.curve, hit.point)
            else:
                selection.select(points={hit.point}, segments=())
        else:
            selection.select(points=(), segments={hit.segment})

    def move(self, pointer: Pointer) -> None:
        """Preview the λ that brings the joint nearest to the pointer."""
        if self._gesture is None:
            self._gesture = self._document.begin(
                "Slide the joint" if self._degree == 3 else "Slide the curve"
            )
        reach = float(self._direction @ self._direction)
        asked = float((pointer.point - self._press.point) @ self._direction) / reach if reach > 0 else 0.0
        low, high = self._bounds
        least = min(0.0, float((low - self._lambdas).max()))
        most = max(0.0, float((high - self._lambdas).min()))
        shift = min(max(asked, least), most)
        lambdas = self._lambdas + shift
        if not pointer.shift and (lambdas == lambdas[0]).all():
            lambdas = np.full(len(lambdas), self._drawn_to(float(lambdas[0]), pointer))
        before, index = self._gesture.before, self._curve
        curve = before[index].curve.with_lambdas(self._indices, lambdas)
        self.note = f"{values_of(curve, self._indices)}: as far as the slide goes" if shift != asked else ""
        self._gesture.preview(before.with_curve(index, curve))

    def _drawn_to(self, lam: float, pointer: Pointer) -> float:
        """The λ of a mode where its place is near and far enough from the others' places to tell apart."""
        marks = np.array([0.0, 1.0, INTERPOLATING[self._degree]])
        scale = float(np.hypot(*self._direction)) * pointer.plane.scale
        nearest = int(np.argmin(np.abs(marks - lam)))
        away = abs(float(marks[nearest]) - lam) * scale
        apart = float(np.abs(np.delete(marks, nearest) - marks[nearest]).min()) * scale
        return float(marks[nearest]) if away < min(MAGNET, apart / 3) else lam

    def release(self, pointer: Pointer) -> None:
        """Commit the slide."""
        if self._gesture is not None:
            self._gesture.commit()

    def cancel(self) -> None:
        """Put λ back; the selection is as before the press."""
        if self._gesture is not None:
            self._gesture.cancel()
        self._restore()


def track_of(plane: Curve, hit: JointHit | MiddleHit) -> Track:
    """The line on which λ moves what is hit."""
    if isinstance(hit, JointHit):
        return joint_track(plane, hit.point)
    return middle_track(plane, hit.segment)


def shaped_by(plane: Curve, hit: JointHit | MiddleHit) -> list[int]:
    """The control points whose λ move what is hit."""
    if isinstance(hit, JointHit):
        return [hit.point]
    return [i for i in plane.lambda_indices(hit.segment) if i is not None]


def values_of(curve: Curve, indices: Sequence[int]) -> str:
    """λ of some control points with their values, in words."""
    return listed([f"{indexed('λ', i)} = {number(float(curve.lambdas[i]))}" for i in indices])
