"""One frame of the canvas: everything that it shows, as a value, and the order in which it is painted."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPen

from theditor.canvas import comb, handles, overlays
from theditor.canvas.curves import paint_halo
from theditor.canvas.grid import paint_grid
from theditor.canvas.handles import Detail, points_inside
from theditor.canvas.hit_test import Hit, JointHit, MiddleHit, PointHit, SegmentHit, parameter_of
from theditor.canvas.labels import MOST, paint_labels
from theditor.canvas.part import NOTHING, Part
from theditor.canvas.shaping import track_of
from theditor.canvas.sketch import Sketch, paint_sketch
from theditor.canvas.snapping import Snapped
from theditor.canvas.trace import strokes
from theditor.canvas.transform import Box, paint_box
from theditor.canvas.viewport import Floats, Viewport
from theditor.drawing import Drawing
from theditor.model import Colours
from theditor.spline import Curve, Track, hull, joint_track, middle_track

Ints = NDArray[np.intp]

MOST_HULLS = 50
"""Of more selected segments only the first show their convex hulls."""
EMPTY = "This drawing is empty.\nPen (B) and freehand (P) draw a curve; File › Open gallery shows examples."


class Shown(NamedTuple):
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


class Frame(NamedTuple):
    """What one frame shows."""

    drawing: Drawing
    current: int
    chosen: Mapping[int, Ints]
    """Selected control points by the curve, of all selected curves: their handles show."""
    segments: frozenset[int]
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

    @property
    def held(self) -> tuple[int, ...]:
        """The visible curves that show what they are held by, the current one last."""
        shown = [i for i in self.chosen if self.drawing[i].visible]
        return tuple(sorted(shown, key=lambda i: i == self.current))

    @property
    def has_current(self) -> bool:
        """Whether there is a current curve to be seen."""
        return self.current >= 0 and self.drawing[self.current].visible


Seen = Callable[[int], Curve]
"""Gives a curve of the drawing as it is seen."""


class Piece(NamedTuple):
    """A part of a curve to be painted, and how."""

    curve: Curve
    reference: Curve
    """The curve as it was before the gesture under way, if there is one: it sets the scale of the comb."""
    part: Part
    detail: Detail
    current: bool


def paint_ground(painter: QPainter, frame: Frame) -> None:
    """Paint what lies behind the drawing."""
    painter.fillRect(QRectF(0, 0, frame.plane.width, frame.plane.height), QColor(frame.colours.canvas))
    if frame.shown.grid:
        paint_grid(painter, frame.plane, frame.colours, frame.font)


def paint_below(painter: QPainter, frame: Frame, piece: Piece) -> None:
    """Paint what a part of a held curve has below the curves."""
    plane, colours, shown = frame.plane, frame.colours, frame.shown
    curve, part, detail = piece.curve, piece.part, piece.detail
    chosen = _common(frame.segments, part.segments) if piece.current else NOTHING
    if shown.hull:
        for segment in chosen[:MOST_HULLS].tolist():
            overlays.paint_hull(painter, hull(curve, segment), plane, colours)
    if piece.current and shown.uniform and detail.handles:
        overlays.paint_uniform(painter, curve, part.segments, plane, colours)
    if shown.polygon and detail.handles:
        handles.paint_polygon(painter, curve, part.edges, plane, colours, dashed=detail.dashed)
    if piece.current and shown.comb:
        comb.paint_comb(
            painter,
            curve,
            part.segments,
            piece.reference,
            shown.comb_length,
            comb.density_for(shown.comb_density, detail.segments, detail.spacing),
            plane,
            colours,
        )
    paint_halo(painter, curve, chosen, plane, colours)


def paint_above(painter: QPainter, frame: Frame, piece: Piece) -> None:
    """Paint what a part of a held curve has above the curves."""
    plane, colours, shown = frame.plane, frame.colours, frame.shown
    curve, part, detail = piece.curve, piece.part, piece.detail
    if piece.current and shown.joints and detail.joints:
        handles.paint_joints(painter, curve, part.joints, plane, colours)
    if piece.current and shown.guards and detail.handles:
        overlays.paint_guards(painter, curve, part.segments, plane, colours)
    if piece.current and shown.marks:
        still = curve is piece.reference
        marks = comb.marks_of(curve).within(part) if still else comb.marks_near(curve, part)
        comb.paint_marks(painter, curve, marks, plane, colours)
    if detail.handles:
        handles.paint_handles(painter, curve, part.points, plane, colours)


def paint_behind(painter: QPainter, frame: Frame, seen: Seen) -> None:
    """Paint, below the curves, what is under the pointer and what λ can do there."""
    plane, colours = frame.plane, frame.colours
    if isinstance(frame.hit, SegmentHit):
        hovered = np.array([frame.hit.segment])
        paint_halo(painter, seen(frame.hit.curve), hovered, plane, colours, width=7.0)
    if not frame.has_current:
        return
    curve = seen(frame.current)
    for point in frame.reach:
        if point < len(curve.control_points) and curve.active_lambdas[point]:
            overlays.paint_reach(painter, curve, point, frame.bounds, plane, colours)
    here = parameter_of(frame.hit, frame.current, curve)
    u = frame.place if here is None else here
    if frame.shown.circle and u is not None and u <= curve.segment_count:
        comb.paint_circle(painter, curve, u, plane, colours)


def paint_hand(painter: QPainter, frame: Frame, seen: Seen) -> None:
    """Paint, above all, what is selected, what is under the pointer, and what the hand is about to do."""
    plane, colours = frame.plane, frame.colours
    if frame.has_current:
        _paint_held(painter, frame, seen)
    if not frame.drawing and frame.sketch is None:
        _paint_empty(painter, frame)
    if frame.sketch is not None:
        paint_sketch(painter, frame.sketch, plane, colours)
    if frame.snapped is not None:
        place = plane.to_pixels(frame.snapped.point)
        overlays.paint_snapped(painter, place, frame.snapped.to, colours, frame.font)
    if frame.marquee is not None:
        _paint_marquee(painter, plane.to_pixels(frame.marquee), colours)


def _paint_held(painter: QPainter, frame: Frame, seen: Seen) -> None:
    plane, colours, curve = frame.plane, frame.colours, seen(frame.current)
    if frame.place is not None and frame.place <= curve.segment_count:
        overlays.paint_place(painter, plane.to_pixels(curve(frame.place)), colours)
    if frame.miss is not None:
        overlays.paint_miss(painter, plane.to_pixels(frame.miss), colours)
    if frame.box is not None and frame.marquee is None:
        paint_box(painter, frame.box, plane, colours)
    if isinstance(frame.hit, PointHit):
        handles.paint_hovered(painter, seen(frame.hit.curve), frame.hit.point, plane, colours)
    selected = [seen(i).control_points[points] for i in frame.held if len(points := frame.chosen[i])]
    if selected:
        handles.paint_selected(painter, np.concatenate(selected), plane, colours)
    for track in _tracks(frame, curve):
        overlays.paint_track(painter, curve, track, plane, colours, frame.font)


def _tracks(frame: Frame, curve: Curve) -> list[Track]:
    """The tracks to show: of what is under the pointer, else of the one selected point or segment."""
    if isinstance(frame.hit, JointHit | MiddleHit):
        return [track_of(curve, frame.hit)]
    points = frame.chosen.get(frame.current, NOTHING)
    if curve.degree == 3 and len(points) == 1:
        point = int(points[0])
        return [joint_track(curve, point)] if curve.active_lambdas[point] else []
    if curve.degree == 2 and len(frame.segments) == 1 and not len(points):
        (segment,) = frame.segments
        return [middle_track(curve, segment)]
    return []


def paint_names(painter: QPainter, frame: Frame, curve: Curve, segments: Ints) -> None:
    """Paint the labels of the current curve's control points, off those of its segments that are in view."""
    points = points_inside(curve.control_points, frame.plane, 0.0)
    if len(points) <= MOST:
        drawn = [stroke.lines[:, :2] for stroke in strokes(curve, frame.plane, segments)]
        paint_labels(
            painter,
            points.tolist(),
            frame.plane.to_pixels(curve.control_points[points]),
            np.vstack([np.empty((0, 2)), *drawn]),
            frozenset(frame.chosen.get(frame.current, NOTHING).tolist()),
            frame.colours,
            frame.font,
        )


def _common(chosen: frozenset[int], segments: Ints) -> Ints:
    """Which of some segments are chosen."""
    if not chosen:
        return NOTHING
    wanted = np.fromiter(chosen, dtype=np.intp, count=len(chosen))
    common: Ints = segments[np.isin(segments, wanted)]
    return common


def _paint_empty(painter: QPainter, frame: Frame) -> None:
    painter.setPen(QColor(frame.colours.secondary))
    painter.setFont(frame.font)
    room = QRectF(0, 0, frame.plane.width, frame.plane.height)
    place = painter.boundingRect(room, Qt.AlignmentFlag.AlignCenter, EMPTY)
    painter.fillRect(place, QColor(frame.colours.canvas))  # an axis goes through the middle
    painter.drawText(room, Qt.AlignmentFlag.AlignCenter, EMPTY)


def _paint_marquee(painter: QPainter, corners: Floats, colours: Colours) -> None:
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    fill = QColor(colours.accent)
    fill.setAlpha(28)
    painter.setBrush(fill)
    painter.setPen(QPen(QColor(colours.accent), 1))
    painter.drawRect(QRectF(QPointF(*corners.min(axis=0)), QPointF(*corners.max(axis=0))))
    painter.setBrush(Qt.BrushStyle.NoBrush)
