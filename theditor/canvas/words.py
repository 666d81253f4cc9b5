"""What the status line says about the place under the pointer, and about what the mouse would do there."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from theditor.canvas.hit_test import BoxHit, Hit, JointHit, MiddleHit, PointHit, SegmentHit, parameter_of
from theditor.canvas.overlays import guards_of
from theditor.canvas.points import doomed
from theditor.canvas.shaping import PullCurve, SlideJoint
from theditor.canvas.tools import Drag, MovePoints
from theditor.canvas.transform import Transform
from theditor.drawing import Drawing
from theditor.model import Selection
from theditor.model.words import indexed, listed, number, points_counted, segments_named
from theditor.spline import Curve, curvature, reversed_joints


class Pointed(NamedTuple):
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
        item = drawing[hit.curve]
        of = "" if hit.curve == current else f" of {item.name}"
        height = "".join(f" at z = {z:.4g}" for z in item.curve.control_points[hit.point, 2:])
        return f"over control point {indexed('P', hit.point)}{of}{height}"
    if isinstance(hit, JointHit):
        curve = drawing[current].curve
        bend = _bend(curve, parameter_of(hit, current, curve) or 0.0)
        return (
            f"over the joint at {indexed('P', hit.point)}, which slides with {indexed('λ', hit.point)}{bend}"
        )
    if isinstance(hit, MiddleHit):
        curve = drawing[current].curve
        bend = _bend(curve, hit.segment + 0.5)
        return f"over the middle of segment {hit.segment + curve.first_segment}, which slides with both its λ{bend}"
    if isinstance(hit, SegmentHit):
        item = drawing[hit.curve]
        of = "" if hit.curve == current else f" of {item.name}"
        bend = _bend(item.curve, hit.segment + hit.t)
        return f"over segment {hit.segment + item.curve.first_segment}{of} at t = {hit.t:.2f}{bend}"
    return ""


def _bend(curve: Curve, u: float) -> str:
    """The curvature and its radius at a place, if it bends there."""
    bend = float(curvature(curve, u))
    return f" · κ {number(bend)}, radius {1 / abs(bend):.4g}" if 1e-12 < abs(bend) < np.inf else ""


def reasons(hit: Hit, current: int, curve: Curve) -> str:
    """Which promises are not kept at what is under the pointer, and why: for the tooltip."""
    segments: list[int] = []
    points: list[int] = []
    match hit:
        case SegmentHit(owner, segment, _) if owner == current:
            segments = [segment]
        case MiddleHit(segment):
            segments = [segment]
        case JointHit(point):
            joint = round(parameter_of(hit, current, curve) or 0)
            segments = [s for s in (joint - 1, joint) if 0 <= s < curve.segment_count]
            points = [point]
        case PointHit(owner, index) if owner == current:
            points = [index]
        case _:
            return ""
    told = [guards_of(curve).reason(segment) for segment in segments]
    told += [joint.reason for joint in reversed_joints(curve) if joint.point in points]
    return "\n".join(dict.fromkeys(reason for reason in told if reason))


def hint(hit: Hit, drag: Drag | None) -> str:
    """What the mouse would do now, or while `drag` is under way what else it can do."""
    if isinstance(drag, PullCurve):
        return drag.note or "Esc: take it back · Ctrl: the nearer λ alone · Shift: move control points"
    if isinstance(drag, SlideJoint):
        return drag.note or "Esc: take it back · Shift: let go of T, H and λ*"
    if isinstance(drag, MovePoints):
        return "Esc: take it back · Ctrl: horizontal or vertical · Shift: no snapping"
    if isinstance(drag, Transform):
        turns = "Ctrl: in steps of 15° · Shift: about the opposite corner"
        told = f"{drag.told} · " if drag.told else ""
        more = turns if drag.turns else "Ctrl: in proportion · Shift: about the middle"
        return f"{told}Esc: take it back · {more}"
    if drag is not None:
        return ""
    if isinstance(hit, BoxHit):
        return "Drag: turn the selected points" if hit.kind == "turn" else "Drag: scale the selected points"
    if isinstance(hit, PointHit):
        return "Drag: move · Ctrl: horizontal or vertical · Shift+click: add to the selection"
    if isinstance(hit, JointHit | MiddleHit):
        return "Drag: slide along the track · Click: select"
    if isinstance(hit, SegmentHit):
        return "Drag: pull the curve by its λ · Click: select the segment · Double-click: insert a point"
    return "Drag: select · Wheel: zoom · Middle or Space drag: pan · F: fit"


def warning(selection: Selection) -> str:
    """What Delete would do to the selected points if that is more than it seems."""
    gone = doomed(selection)
    if not gone:
        return ""
    curves = "the whole curve" if len(gone) == 1 else f"{len(gone)} whole curves"
    return f"Delete: {curves}, for too few control points would stay"


def selected(selection: Selection) -> str:
    """What is selected, counted."""
    told = [points_counted(selection.across, "selected")] if selection.count else []
    if selection.item is not None and selection.segments:
        told.append(f"{segments_named(selection.item.curve, selection.segments)} selected")
    if not told and len(selection.curves) > 1:
        told.append(f"{len(selection.curves)} curves selected")
    return listed(told) if told else ""
