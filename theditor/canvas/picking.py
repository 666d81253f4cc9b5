"""Picking: everything that lies under a position on the screen, topmost first."""

from __future__ import annotations

from theditor.canvas.curves import CurvesPainter
from theditor.canvas.held import Held
from theditor.canvas.hit_test import (
    REACH,
    BoxHit,
    Hit,
    JointHit,
    MiddleHit,
    PointHit,
    SegmentHit,
    near_places,
    near_points,
    sliding_place,
)
from theditor.canvas.viewport import Floats, Viewport
from theditor.drawing import Drawing

FAVOUR = 2.0
"""A curve drawn beneath must be nearer by this many pixels to be picked first."""

Key = tuple[str, int, int]


def pick(
    at: Floats,
    drawing: Drawing,
    current: int,
    handles: Held,
    curves: CurvesPainter,
    plane: Viewport,
) -> list[Hit]:
    """What can be grabbed at a pixel: handles of selected curves before curves, the current curve before others.

    Locked and hidden curves are not there. Of segments that merely meet only the nearest counts; where a
    curve crosses itself, both do.
    """
    curves.update(drawing)
    hits: list[Hit] = []
    for i, of in sorted(
        handles.near(at, REACH, plane).items(), key=lambda near: (near[0] != current, -near[0])
    ):
        points = curves.plane_curve(i).control_points[of]
        hits += [PointHit(i, int(of[k])) for k in near_points(points, at, plane)]
    found: list[tuple[float, SegmentHit]] = []
    near = curves.near(at, REACH, plane)
    for i in sorted(near, key=lambda i: (i != current, -i)):
        if not drawing[i].locked:
            places = near_places(near[i], at, curves.plane_curve(i).segment_count)
            found += [(away, SegmentHit(i, segment, min(t, 1.0))) for away, segment, t in places]
    for hit in _topmost_first(found):
        own = hit.curve == current
        sliding = sliding_place(curves.plane_curve(current), hit, at, plane) if own else None
        hits.append(sliding or hit)
    return hits


def locked_at(
    at: Floats, drawing: Drawing, current: int, curves: CurvesPainter, plane: Viewport
) -> int | None:
    """The topmost locked curve at a pixel; of the current one the handles count, too."""
    curves.update(drawing)
    near = [i for i in curves.near(at, REACH, plane) if drawing[i].locked]
    if current >= 0 and drawing[current].visible and drawing[current].locked:
        near += [current] * bool(near_points(curves.plane_curve(current).control_points, at, plane))
    return max(near, default=None)


def _topmost_first(found: list[tuple[float, SegmentHit]]) -> list[SegmentHit]:
    """Order places: each goes before those after it, unless one of these is nearer by more than the favour."""
    rest, ordered = list(found), []
    while rest:
        best = rest[0]
        for other in rest[1:]:
            if other[0] < best[0] - FAVOUR:
                best = other
        rest.remove(best)
        ordered.append(best[1])
    return ordered


def key_of(hit: Hit, current: int) -> Key | None:
    """What a hit would grab, whatever its exact place and whichever curve becomes current."""
    match hit:
        case PointHit(curve, index):
            return "point", curve, index
        case BoxHit(kind, x, y):
            return kind, x, y
        case JointHit(point):
            return "joint", current, point
        case MiddleHit(segment):
            return "segment", current, segment
        case SegmentHit(curve, segment, _):
            return "segment", curve, segment
        case _:
            return None
