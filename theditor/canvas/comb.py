"""Curvature on the canvas: the comb, marks at inflections and extremes, and the osculating circle."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from theditor.canvas.lines import clipped, draw_lines
from theditor.canvas.part import Part
from theditor.canvas.viewport import Viewport
from theditor.model import Colours
from theditor.spline import Curve
from theditor.spline.curvature import curvature, curvature_along, osculating_circle
from theditor.spline.pieces import stretch
from theditor.spline.vertices import curvature_extremes, inflections

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]
Flags = NDArray[np.bool_]

MOST_TEETH = 2500
"""More teeth than this in view cannot be told apart,"""
LEAST_GAP = 2.5
"""nor can such as are nearer to each other than this many pixels."""
LONGEST = 2000.0
"""A tooth ends at this many pixels: at a cusp the curvature is infinite."""
MOST_MARKED = 5000
"""Longer curves, in segments, get no marks."""
FINER = 4
"""The crest of the comb is drawn with this many times as many points as there are teeth."""
TYPICAL = 0.03
"""Length of a typical tooth at slider value 1, as a share of the curve's size."""


def density_for(density: int, visible: int, spacing: float) -> int:
    """How many teeth can be made out on each segment; 0 for no comb.

    So many segments are in view, and so many pixels is one usually long.
    """
    most = max(1, min(MOST_TEETH // max(1, visible), int(spacing / LEAST_GAP)))
    return min(density, most) if visible <= MOST_TEETH else 0


def paint_comb(
    painter: QPainter,
    curve: Curve,
    segments: Ints,
    reference: Curve,
    length: float,
    density: int,
    plane: Viewport,
    colours: Colours,
) -> None:
    """Paint the curvature comb on some segments, each by itself, so that jumps at joints show.

    The teeth stand on the outer side of the bend, as long as the curvature; `reference` sets the scale (the
    curve before a drag, so that the comb does not breathe while the curve moves).
    """
    if not density or not len(segments):
        return
    feet, along, bend = curvature_along(curve, segments, np.arange(FINER * density + 1) / (FINER * density))
    outward = np.stack([along[1], -along[0]])
    longest = LONGEST / plane.scale
    tips = feet + outward * np.clip(bend * (length * _unit(reference)), -longest, longest)
    from_px, to_px = (plane.to_pixels(np.moveaxis(places, 0, -1)) for places in (feet, tips))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for sign, colour in ((1, colours.comb), (-1, colours.comb_negative)):
        turns = (sign * bend > 0) & np.isfinite(tips).all(axis=0)
        chosen = turns[:, ::FINER]
        teeth = np.hstack([from_px[:, ::FINER][chosen], to_px[:, ::FINER][chosen]])
        beside = turns[:, :-1] & turns[:, 1:]
        crest = np.hstack([to_px[:, :-1][beside], to_px[:, 1:][beside]])
        for lines, opacity, width in ((teeth, 100, 1.0), (crest, 200, 1.1)):
            faint = QColor(colour)
            faint.setAlpha(opacity)
            painter.setPen(QPen(faint, width))
            draw_lines(painter, clipped(lines, plane.width, plane.height)[0])


@lru_cache(maxsize=4)
def _unit(curve: Curve) -> float:
    """Units of length for a unit of curvature at slider value 1: a typical bend gets a tooth of a typical length."""
    size = float(np.linalg.norm(np.ptp(curve.control_points, axis=0)))
    u = np.linspace(0, curve.segment_count, min(4 * curve.segment_count, 4000) + 1)
    bends = np.abs(curvature(curve, u))
    bends = bends[np.isfinite(bends) & (bends > 0)]
    return TYPICAL * size / float(np.median(bends)) if len(bends) else 0.0


class Marks(NamedTuple):
    """Parameters of what is marked on a curve, ascending."""

    inflections: Floats
    extremes: Floats
    maximum: Flags
    """Which extremes of |κ| are maxima."""

    def within(self, part: Part) -> Marks:
        """Those in the segments of a part of the curve and at their joints."""
        turns, peaks = (_inside_part(u, part) for u in (self.inflections, self.extremes))
        return Marks(self.inflections[turns], self.extremes[peaks], self.maximum[peaks])


NO_MARKS = Marks(np.empty(0), np.empty(0), np.empty(0, dtype=np.bool_))


def _inside_part(u: Floats, part: Part) -> Flags:
    if not len(u):
        return np.empty(0, dtype=np.bool_)
    return np.where(u == np.floor(u), np.isin(u, part.joints), np.isin(np.floor(u), part.segments))


@lru_cache(maxsize=2)
def marks_of(curve: Curve) -> Marks:
    """All inflections and extremes; none on a longer curve than `MOST_MARKED`."""
    if curve.segment_count > MOST_MARKED:
        return NO_MARKS
    extremes = curvature_extremes(curve)
    return Marks(inflections(curve).u, extremes.u, extremes.maximum)


def marks_near(curve: Curve, part: Part) -> Marks:
    """Those in and around a part of the curve, found by looking at it alone if it is one run of segments."""
    if not len(part.segments) or curve.segment_count > MOST_MARKED:
        return NO_MARKS
    first, last = part.segments[[0, -1]].tolist()
    if curve.closed or last - first >= len(part.segments):
        return marks_of(curve).within(part)
    first, last = max(first - 1, 0), min(last + 1, curve.segment_count - 1)
    near = marks_of(stretch(curve, first, last))
    return near._replace(inflections=near.inflections + first, extremes=near.extremes + first).within(part)


def paint_marks(painter: QPainter, curve: Curve, marks: Marks, plane: Viewport, colours: Colours) -> None:
    """Mark inflections by small rings and extremes of |κ| by triangles that point outward (least: hollow)."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor(colours.comb), 1.5))
    painter.setBrush(QColor(colours.canvas))
    for place in plane.to_pixels(curve(marks.inflections)):
        if _inside(place, plane):
            painter.drawEllipse(QPointF(*place), 3.2, 3.2)
    for place, maximum in zip(plane.to_pixels(curve(marks.extremes)), marks.maximum.tolist(), strict=True):
        if _inside(place, plane):
            painter.setBrush(QColor(colours.comb if maximum else colours.canvas))
            triangle = place + np.array([[0.0, -4.5], [4.0, 3.0], [-4.0, 3.0]])
            painter.drawPolygon(QPolygonF([QPointF(*corner) for corner in triangle]))
    painter.setBrush(Qt.BrushStyle.NoBrush)


def paint_circle(painter: QPainter, curve: Curve, u: float, plane: Viewport, colours: Colours) -> None:
    """Paint the osculating circle at `u` with its centre, unless the curve is straight or stands still there."""
    centre, radius = osculating_circle(curve, u)
    size = float(radius) * plane.scale
    if not np.isfinite(size) or size > 1e5:
        return
    middle = plane.to_pixels(centre)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    pen = QPen(QColor(colours.comb), 1.2)
    painter.setPen(pen)
    painter.drawEllipse(QPointF(*middle), size, size)
    painter.drawLine(QPointF(*middle), QPointF(*plane.to_pixels(curve(u))))
    painter.setBrush(QColor(colours.comb))
    painter.drawEllipse(QPointF(*middle), 2.0, 2.0)
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _inside(place: Floats, plane: Viewport) -> bool:
    return bool((place > -5).all() and place[0] < plane.width + 5 and place[1] < plane.height + 5)
