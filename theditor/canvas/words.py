"""What the status line says about the place under the pointer, and about what the mouse would do there."""

from __future__ import annotations

from theditor.canvas.hit_test import Hit, PointHit, SegmentHit
from theditor.canvas.tools import Drag, MovePoints
from theditor.drawing import Drawing
from theditor.model.words import indexed


def describe(hit: Hit, drawing: Drawing, current: int) -> str:
    """What is under the pointer, in the numbers of the paper."""
    if isinstance(hit, PointHit):
        return f"over control point {indexed('P', hit.index)}"
    if isinstance(hit, SegmentHit):
        item = drawing[hit.curve]
        of = "" if hit.curve == current else f" of {item.name}"
        return f"over segment {hit.segment + item.curve.first_segment}{of} at t = {hit.t:.2f}"
    return ""


def hint(hit: Hit, drag: Drag | None) -> str:
    """What the mouse would do now, or while `drag` is under way what else it can do."""
    if drag is not None:
        return "Esc: take it back · Ctrl: horizontal or vertical" if isinstance(drag, MovePoints) else ""
    if isinstance(hit, PointHit):
        return "Drag: move · Ctrl: horizontal or vertical · Shift+click: add to the selection"
    if isinstance(hit, SegmentHit):
        return "Click: select the segment · Shift+click: add to the selection"
    return "Drag: select · Wheel: zoom · Middle or Space drag: pan · F: fit"
