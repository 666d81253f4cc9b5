"""Picking: what lies under a position on the screen. Everything here is in pixels; no Qt."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.trace import Stroke
from theditor.canvas.viewport import Viewport, inside
from theditor.spline import Curve

Floats = NDArray[np.float64]

REACH = 8.0
"""How near, in pixels, the pointer must be to pick something."""
JOINT_REACH = 6.0
"""The same for joints, which lie on a curve that can be picked itself."""


MOST_PASSAGES = 8
"""Of more passages of a curve within reach only the nearest are told apart."""


class PointHit(NamedTuple):
    """A control point of a selected curve."""

    curve: int
    point: int


class SegmentHit(NamedTuple):
    """A place on a curve of the drawing."""

    curve: int
    segment: int
    t: float


class JointHit(NamedTuple):
    """The joint of the current cubic that belongs to a control point."""

    point: int


class MiddleHit(NamedTuple):
    """The middle of a segment of the current quadratic, whose joints λ does not move."""

    segment: int


class BoxHit(NamedTuple):
    """A handle of the box around the selected points: to scale or to turn, at a corner or side (−1, 0 or 1)."""

    kind: Literal["scale", "turn"]
    x: int
    y: int


Hit = BoxHit | PointHit | JointHit | MiddleHit | SegmentHit | None


def near_handles(handles: Floats, at: Floats, reach: float = REACH) -> list[int]:
    """Indices of the handles (n, 2) within reach of `at` (2,), nearest first, the topmost (last) of equals first."""
    squares = ((handles - at) ** 2).sum(axis=1)
    near = np.flatnonzero(squares <= reach * reach)[::-1]
    chosen: list[int] = near[np.argsort(squares[near], kind="stable")].tolist()
    return chosen


def near_points(points: Floats, at: Floats, plane: Viewport, reach: float = REACH) -> list[int]:
    """As `near_handles`, of points of the plane, which need not be brought to the screen first."""
    centre = plane.to_points(at)
    close = inside(points, centre - reach / plane.scale, centre + reach / plane.scale)
    chosen: list[int] = close[near_handles(plane.to_pixels(points[close]), at, reach)].tolist()
    return chosen


def near_places(
    stroke: Stroke, at: Floats, count: int, reach: float = REACH
) -> list[tuple[float, int, float]]:
    """Distance in pixels, segment and t of the drawn places within reach of `at` (2,), nearest first.

    There is one for each passage of the curve, which has `count` segments: neighbouring segments are one.
    """
    best: dict[int, tuple[float, int, float]] = {}
    start, along = stroke.lines[:, :2], stroke.lines[:, 2:] - stroke.lines[:, :2]
    squared_length = (along**2).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        f = np.nan_to_num(((at - start) * along).sum(axis=1) / squared_length).clip(0.0, 1.0)
    distances = np.hypot(*(start + f[:, None] * along - at).T)
    for i in np.flatnonzero(distances <= reach).tolist():
        segment, away = int(stroke.segments[i]), float(distances[i])
        if segment not in best or away < best[segment][0]:
            t0, t1 = stroke.parameters[i].tolist()
            best[segment] = away, segment, float(t0 + f[i] * (t1 - t0))
    passages: list[tuple[float, int, float]] = []
    for place in sorted(best.values()):
        if all((place[1] - other[1]) % count not in (1, count - 1) for other in passages):
            passages.append(place)
        if len(passages) == MOST_PASSAGES:
            break
    return passages


def sliding_place(
    curve: Curve, place: SegmentHit, at: Floats, plane: Viewport
) -> JointHit | MiddleHit | None:
    """The joint (of a cubic) or the middle (of a quadratic's segment) at `at` (2,), if λ can slide it.

    `place` is the picked place of the same plane curve.
    """
    if curve.degree == 2:
        movable = any(i is not None for i in curve.lambda_indices(place.segment))
        near = _near(curve, place.segment + 0.5, at, plane)
        return MiddleHit(place.segment) if movable and near else None
    end = int(place.t > 0.5)
    point = curve.lambda_indices(place.segment)[end]
    near = point is not None and _near(curve, place.segment + end, at, plane)
    return JointHit(point) if point is not None and near else None


def _near(curve: Curve, u: float, at: Floats, plane: Viewport) -> bool:
    return bool(np.hypot(*(plane.to_pixels(curve(u)) - at)) <= JOINT_REACH)


def exists(hit: Hit, curve: Curve) -> bool:
    """Whether what was hit is still there on a curve that may have changed."""
    match hit:
        case PointHit(_, index):
            return index < len(curve.control_points)
        case JointHit(point):
            return (
                curve.degree == 3 and point < len(curve.control_points) and bool(curve.active_lambdas[point])
            )
        case MiddleHit(segment):
            return curve.degree == 2 and segment < curve.segment_count
        case BoxHit():
            return True
        case SegmentHit(_, segment, _):
            return segment < curve.segment_count
        case _:
            return False


def parameter_of(hit: Hit, current: int, curve: Curve) -> float | None:
    """The parameter of the current curve at what was hit; None where that is not a place on it."""
    match hit:
        case SegmentHit(owner, segment, t) if owner == current:
            return segment + t
        case JointHit(point):
            return float((point - curve.first_segment) % len(curve.control_points))
        case MiddleHit(segment):
            return segment + 0.5
        case _:
            return None
