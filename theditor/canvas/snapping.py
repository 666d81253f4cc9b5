"""Snapping: which point near the pointer it is drawn to, and what is there."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.curves import CurvesPainter
from theditor.canvas.grid import steps
from theditor.canvas.hit_test import REACH, near_places, near_points
from theditor.canvas.trace import Stroke
from theditor.canvas.viewport import Floats, Viewport
from theditor.drawing import Drawing
from theditor.model.words import indexed
from theditor.spline import Curve, changed_segments
from theditor.spline.distinct import distinct

Ints = NDArray[np.intp]
NOTHING: Ints = np.empty(0, dtype=np.intp)


class Snapped(NamedTuple):
    """A point of the plane (2,) that the pointer is drawn to, and what is there."""

    point: Floats
    to: str


class Moving(NamedTuple):
    """What moves with the hand and can be no goal: control points of curves, and the segments they shape."""

    points: Mapping[int, Ints]
    segments: Mapping[int, Ints]


STILL = Moving({}, {})


def moving(drawing: Drawing, points: Mapping[int, Ints]) -> Moving:
    """What moves when control points of some curves do."""
    return Moving(points, {i: _shaped(drawing[i].curve, of) for i, of in points.items()})


def _shaped(curve: Curve, points: Ints) -> Ints:
    here = curve.control_points[points]
    segments = changed_segments(curve, curve.with_points(points, np.where(here > 0, here - 1, here + 1)))
    return NOTHING if segments is None else segments


class Snapper:
    """Finds what a point is drawn to: control points first, then joints, then curves, then the grid's lines."""

    def __init__(self, curves: CurvesPainter) -> None:
        self._curves = curves
        self.on = False

    def __call__(
        self, point: Floats, drawing: Drawing, plane: Viewport, moves: Moving = STILL
    ) -> Snapped | None:
        """What a point (2,) is drawn to within reach on the screen, apart from what moves; None if off."""
        if not self.on:
            return None
        self._curves.update(drawing)
        at = plane.to_pixels(point)
        near = self._curves.near(at, REACH, plane, without=moves.segments)
        return (
            self._control_point(at, plane, moves)
            or self._joint(at, near, plane)
            or self._curve(at, near)
            or _grid(point, plane)
        )

    def _control_point(self, at: Floats, plane: Viewport, moves: Moving) -> Snapped | None:
        found = []
        for i, near in self._curves.handles.near(at, REACH, plane).items():
            near = np.setdiff1d(near, moves.points.get(i, NOTHING), assume_unique=True)
            places = self._curves.plane_curve(i).control_points[near]
            found += [(places[k], indexed("P", near[k])) for k in near_points(places, at, plane)[:1]]
        return _nearest(found, at, plane)

    def _joint(self, at: Floats, near: Mapping[int, Stroke], plane: Viewport) -> Snapped | None:
        found = []
        for i, stroke in near.items():
            joints = distinct(np.concatenate([stroke.segments, stroke.segments + 1]))
            places = self._curves.plane_curve(i)(joints)
            found += [(places[j], "joint") for j in near_points(places, at, plane)[:1]]
        return _nearest(found, at, plane)

    def _curve(self, at: Floats, near: Mapping[int, Stroke]) -> Snapped | None:
        best: tuple[float, int, float] | None = None
        for i, stroke in near.items():
            for away, segment, t in near_places(stroke, at, self._curves.plane_curve(i).segment_count)[:1]:
                if best is None or away < best[0]:
                    best = away, i, segment + min(max(t, 0.0), 1.0)
        return None if best is None else Snapped(self._curves.plane_curve(best[1])(best[2]), "curve")


def _nearest(found: list[tuple[Floats, str]], at: Floats, plane: Viewport) -> Snapped | None:
    if not found:
        return None
    return Snapped(*min(found, key=lambda goal: float(np.hypot(*(plane.to_pixels(goal[0]) - at)))))


def _grid(point: Floats, plane: Viewport) -> Snapped | None:
    """The nearest minor lines, upright and level, each on its own."""
    _, minor = steps(plane.scale)
    lines = np.round(point / minor) * minor
    near = np.abs(lines - point) * plane.scale <= REACH
    return Snapped(np.where(near, lines, point), "grid") if near.any() else None
