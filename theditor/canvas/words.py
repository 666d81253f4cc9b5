"""What the status line says about the place under the pointer, and about what the mouse would do there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from theditor.canvas.hit_test import Hit, JointHit, MiddleHit, PointHit, SegmentHit
from theditor.canvas.points import takes_the_curve
from theditor.canvas.projection import projected
from theditor.canvas.shaping import PullCurve, SlideJoint
from theditor.canvas.tools import Drag, MovePoints
from theditor.drawing import Drawing
from theditor.model import Selection
from theditor.model.words import indexed
from theditor.spline.curvature import curvature


@dataclass(frozen=True)
class Pointed:
    """What the pointer is over, for the status line; `position` is None when it is outside."""

    position: tuple[float, float] | None
    over: str
    hint: str
    scale: float
    u: float | None = None
    """The parameter of the current curve at the pointer, if it is over it."""


def describe(hit: Hit, drawing: Drawing, current: int) -> str:
    """What is under the pointer, in the numbers of the paper."""
    if isinstance(hit, PointHit):
        height = drawing[current].curve.control_points[hit.index, 2:]
        return f"over control point {indexed('P', hit.index)}" + "".join(f" at z = {z:.4g}" for z in height)
    if isinstance(hit, JointHit):
        return f"over the joint at {indexed('P', hit.point)}: it slides with {indexed('λ', hit.point)}"
    if isinstance(hit, MiddleHit):
        number = hit.segment + drawing[current].curve.first_segment
        return f"over the middle of segment {number}: it slides with both its λ"
    if isinstance(hit, SegmentHit):
        item = drawing[hit.curve]
        of = "" if hit.curve == current else f" of {item.name}"
        bend = abs(float(curvature(projected(item.curve), hit.segment + hit.t)))
        radius = f" · radius {1 / bend:.4g}" if 1e-12 < bend < np.inf else ""
        return f"over segment {hit.segment + item.curve.first_segment}{of} at t = {hit.t:.2f}{radius}"
    return ""


def hint(hit: Hit, drag: Drag | None) -> str:
    """What the mouse would do now, or while `drag` is under way what else it can do."""
    if isinstance(drag, PullCurve):
        return drag.note or "Esc: take it back · Ctrl: the nearer λ alone · Shift: move control points"
    if isinstance(drag, SlideJoint):
        return "Esc: take it back · Shift: let go of T, H and λ*"
    if isinstance(drag, MovePoints):
        return "Esc: take it back · Ctrl: horizontal or vertical · Shift: no snapping"
    if drag is not None:
        return ""
    if isinstance(hit, PointHit):
        return "Drag: move · Ctrl: horizontal or vertical · Shift+click: add to the selection"
    if isinstance(hit, JointHit | MiddleHit):
        return "Drag: slide along the track · Click: select"
    if isinstance(hit, SegmentHit):
        return "Drag: pull the curve by its λ · Click: select the segment · Double-click: insert a point"
    return "Drag: select · Wheel: zoom · Middle or Space drag: pan · F: fit"


def warning(selection: Selection) -> str:
    """What Delete would do to the selected points if that is more than it seems."""
    item, count = selection.item, len(selection.points)
    if item is None or not count or item.locked or not takes_the_curve(item.curve, count):
        return ""
    return "Delete: the whole curve, for too few control points would stay"
