"""One frame of the canvas: everything that it shows, as a value, and the order in which it is painted."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPen

from theditor.canvas import comb, handles, overlays
from theditor.canvas.curves import CurvesPainter
from theditor.canvas.grid import paint_grid
from theditor.canvas.hit_test import Hit, JointHit, MiddleHit, PointHit, SegmentHit, parameter_of
from theditor.canvas.labels import MOST, paint_labels
from theditor.canvas.projection import projected
from theditor.canvas.shaping import track_of
from theditor.canvas.sketch import Sketch, paint_sketch
from theditor.canvas.snapping import Snapped
from theditor.canvas.transform import Box, paint_box
from theditor.canvas.viewport import Floats, Viewport
from theditor.drawing import Drawing
from theditor.model import Colours
from theditor.spline import Curve, Track, hull, joint_track, middle_track

Ints = NDArray[np.intp]

MOST_HULLS = 50
"""Of more selected segments only the first show their convex hulls."""
EMPTY = "This drawing is empty.\nCurve › Add curve puts one here; File › Open gallery shows examples."


@dataclass(frozen=True)
class Shown:
    """What the canvas shows beside the curves."""

    polygon: bool = True
    labels: bool = True
    joints: bool = True
    modes: bool = True
    grid: bool = True
    legend: bool = True
    ghost: bool = True
    uniform: bool = False
    hull: bool = False
    guards: bool = True
    comb: bool = False
    comb_length: float = 1.0
    comb_density: int = 16
    marks: bool = False
    circle: bool = False


@dataclass(frozen=True)
class Frame:
    """What one frame shows."""

    drawing: Drawing
    current: int
    points: frozenset[int]
    segments: frozenset[int]
    others: Mapping[int, Ints]
    """Selected control points of other selected curves, by the curve; their handles show, too."""
    box: Box | None
    """The box around all selected control points."""
    hit: Hit
    plane: Viewport
    shown: Shown
    colours: Colours
    font: QFont
    bounds: tuple[float, float]
    before: Drawing | None = None
    """The drawing before the gesture under way."""
    place: float | None = None
    """A parameter of the current curve to point out."""
    reach: tuple[int, ...] = ()
    """Control points whose λ shows what it can reach."""
    marquee: Floats | None = None
    """Two opposite corners in the plane, (2, 2)."""
    miss: Floats | None = None
    """What a pull reached and where the pointer is, in the plane, (2, 2)."""
    sketch: Sketch | None = None
    """The curve to come."""
    snapped: Snapped | None = None
    """What the point at hand is drawn to."""


def paint_ground(painter: QPainter, frame: Frame) -> None:
    """Paint what lies behind the drawing."""
    painter.fillRect(QRectF(0, 0, frame.plane.width, frame.plane.height), QColor(frame.colours.canvas))
    if frame.shown.grid:
        paint_grid(painter, frame.plane, frame.colours, frame.font)


def paint_picture(painter: QPainter, frame: Frame, curves: CurvesPainter) -> None:
    """Paint the curves, then what the current one is held by, then what the hand is about to do."""
    _paint_curves(painter, frame, curves)
    plane, colours = frame.plane, frame.colours
    if frame.sketch is not None:
        paint_sketch(painter, frame.sketch, plane, colours)
    if frame.snapped is not None:
        place = plane.to_pixels(frame.snapped.point)
        overlays.paint_snapped(painter, place, frame.snapped.to, colours, frame.font)
    if frame.marquee is not None:
        _paint_marquee(painter, plane.to_pixels(frame.marquee), colours)


def _paint_curves(painter: QPainter, frame: Frame, curves: CurvesPainter) -> None:
    drawing, current, plane, colours = frame.drawing, frame.current, frame.plane, frame.colours
    curves.update(drawing, plane)
    if not len(drawing) and frame.sketch is None:
        _paint_empty(painter, frame)
    if isinstance(frame.hit, SegmentHit):
        curves.paint_halo(painter, frame.hit.curve, [frame.hit.segment], plane, colours, width=7.0)
    if current < 0 or not drawing[current].visible:
        curves.paint(painter, drawing, -1, colours, by_mode=False)
        return
    curve = curves.plane_curve(current)
    for point in frame.reach:
        if point < len(curve.control_points) and curve.active_lambdas[point]:
            overlays.paint_reach(painter, curve, point, frame.bounds, plane, colours)
    if frame.shown.hull:
        for segment in sorted(frame.segments)[:MOST_HULLS]:
            overlays.paint_hull(painter, hull(curve, segment), plane, colours)
    if frame.shown.ghost and frame.before is not None:
        curves.paint_ghost(painter, frame.before, drawing, plane, colours)
    if frame.shown.uniform:
        overlays.paint_uniform(painter, curve, plane, colours)
    others = [(i, curves.plane_curve(i), points) for i, points in frame.others.items() if drawing[i].visible]
    if frame.shown.polygon:
        for _, other, _ in others:
            handles.paint_polygon(painter, other, plane, colours)
        handles.paint_polygon(painter, curve, plane, colours)
    _paint_curvature(painter, frame, curve)
    curves.paint_halo(painter, current, frame.segments, plane, colours)
    curves.paint(painter, drawing, current, colours, by_mode=frame.shown.modes)
    if frame.shown.joints:
        handles.paint_joints(painter, curve, plane, colours)
    if frame.shown.guards:
        overlays.paint_guards(painter, curve, plane, colours)
    if frame.shown.marks:
        comb.paint_marks(painter, curve, plane, colours)
    if frame.place is not None and frame.place <= curve.segment_count:
        overlays.paint_place(painter, plane.to_pixels(curve(frame.place)), colours)
    if frame.miss is not None:
        overlays.paint_miss(painter, plane.to_pixels(frame.miss), colours)
    if frame.box is not None and frame.marquee is None:
        paint_box(painter, frame.box, plane, colours)
    for i, other, points in others:
        handles.paint_handles(painter, other, plane, points, _hovered(frame, i), colours)
    handles.paint_handles(painter, curve, plane, frame.points, _hovered(frame, current), colours)
    for track in _tracks(frame, curve):
        overlays.paint_track(painter, curve, track, plane, colours, frame.font)
    if frame.shown.labels:
        _paint_labels(painter, frame, curve, curves)


def _hovered(frame: Frame, index: int) -> int | None:
    """The control point of a curve that is under the pointer."""
    hit = frame.hit
    return hit.index if isinstance(hit, PointHit) and hit.curve == index else None


def _paint_curvature(painter: QPainter, frame: Frame, curve: Curve) -> None:
    shown, plane, colours = frame.shown, frame.plane, frame.colours
    if shown.comb:
        steady = frame.before or frame.drawing
        reference = projected(steady[frame.current].curve) if frame.current < len(steady) else curve
        comb.paint_comb(painter, curve, reference, shown.comb_length, shown.comb_density, plane, colours)
    if shown.circle:
        here = parameter_of(frame.hit, frame.current, curve)
        u = frame.place if here is None else here
        if u is not None:
            comb.paint_circle(painter, curve, u, plane, colours)


def _tracks(frame: Frame, curve: Curve) -> list[Track]:
    """The tracks to show: of what is under the pointer, else of the one selected point or segment."""
    if isinstance(frame.hit, JointHit | MiddleHit):
        return [track_of(curve, frame.hit)]
    if curve.degree == 3 and len(frame.points) == 1:
        (point,) = frame.points
        return [joint_track(curve, point)] if curve.active_lambdas[point] else []
    if curve.degree == 2 and len(frame.segments) == 1 and not frame.points:
        (segment,) = frame.segments
        return [middle_track(curve, segment)]
    return []


def _paint_labels(painter: QPainter, frame: Frame, curve: Curve, curves: CurvesPainter) -> None:
    pixels = frame.plane.to_pixels(curve.control_points)
    inside = ((pixels >= 0) & (pixels <= (frame.plane.width, frame.plane.height))).all(axis=1)
    visible = np.flatnonzero(inside)
    if len(visible) <= MOST:
        on_curve = [stroke.lines[:, :2] for stroke in curves.trace(frame.current).strokes()]
        obstacles = np.vstack([np.empty((0, 2)), *on_curve])
        names = visible.tolist()
        paint_labels(painter, names, pixels[visible], obstacles, frame.points, frame.colours, frame.font)


def _paint_empty(painter: QPainter, frame: Frame) -> None:
    painter.setPen(QColor(frame.colours.secondary))
    painter.setFont(frame.font)
    room = QRectF(0, 0, frame.plane.width, frame.plane.height)
    painter.drawText(room, Qt.AlignmentFlag.AlignCenter, EMPTY)


def _paint_marquee(painter: QPainter, corners: Floats, colours: Colours) -> None:
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    fill = QColor(colours.accent)
    fill.setAlpha(28)
    painter.setBrush(fill)
    painter.setPen(QPen(QColor(colours.accent), 1))
    painter.drawRect(QRectF(QPointF(*corners.min(axis=0)), QPointF(*corners.max(axis=0))))
    painter.setBrush(Qt.BrushStyle.NoBrush)
