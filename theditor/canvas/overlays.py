"""What is laid over the drawing to show what λ does: ghosts, tracks, reach, hulls, misses."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPainterPath, QPen, QPolygonF

from theditor.canvas.handles import points_inside
from theditor.canvas.lines import clipped, draw_lines
from theditor.canvas.viewport import Viewport
from theditor.model import Colours
from theditor.spline import (
    INTERPOLATING,
    PULL_BOUNDS,
    Curve,
    Guards,
    Mode,
    Track,
    negative_basis,
    reach,
    uniform_segments,
)
from theditor.spline.distinct import distinct

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]

TICK = 4.0
MERGE = 6.0
"""Marks on a track nearer to each other than this many pixels become one."""
LEAST_MISS = 1.0
"""A pull that stays nearer than this to the pointer, in pixels, counts as there."""
MOST_SIGNS = 300
"""More signs than this in view would hide the drawing."""
MOST_SEGMENTS = 2000
"""With more segments in view the ordinary B-spline is not drawn: it could not be told apart."""


def paint_uniform(painter: QPainter, curve: Curve, segments: Ints, plane: Viewport, colours: Colours) -> None:
    """Paint the ordinary uniform B-spline of the same degree on the same polygon, thin and dotted, in some segments."""
    if len(segments) <= MOST_SEGMENTS:
        pen = _pen(colours.secondary, 1.2)
        pen.setDashPattern([1.5, 3])
        samples = plane.to_pixels(uniform_segments(curve, segments, 16))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(pen)
        lines = np.concatenate([samples[:, :-1], samples[:, 1:]], axis=2).reshape(-1, 4)
        draw_lines(painter, clipped(lines, plane.width, plane.height)[0])


def paint_track(
    painter: QPainter, curve: Curve, track: Track, plane: Viewport, colours: Colours, font: QFont
) -> None:
    """Paint the line on which a joint slides, with ticks where T, H and λ* put it, and a handle where it is."""
    ends = plane.to_pixels(track.position(np.array(PULL_BOUNDS)))
    _polyline(painter, ends, plane, _pen(colours.accent, 1.2))
    along = ends[1] - ends[0]
    length = float(np.hypot(*along))
    place = plane.to_pixels(track.position(track.current))
    if length > 1.0:
        across = np.array([-along[1], along[0]]) / length
        painter.setFont(_small(font))
        for at, label in marks(curve.degree, track, plane):
            _polyline(
                painter, np.stack([at - TICK * across, at + TICK * across]), plane, _pen(colours.accent, 1.5)
            )
            painter.setPen(QColor(colours.accent_text))
            wide = painter.fontMetrics().horizontalAdvance(label)
            clear = at + 12 * across
            painter.drawText(QPointF(clear[0] - (wide if across[0] < -0.1 else 0), clear[1] + 4), label)
    painter.setPen(_pen(colours.canvas, 1.0))
    painter.setBrush(QColor(colours.accent))
    diamond = place + np.array([[0, -5], [5, 0], [0, 5], [-5, 0]])
    painter.drawPolygon(QPolygonF([QPointF(*corner) for corner in diamond]))
    painter.setBrush(Qt.BrushStyle.NoBrush)


def marks(degree: int, track: Track, plane: Viewport) -> list[tuple[Floats, str]]:
    """Where T, H and λ* put the point on a track, in pixels, with their letters; near ones merged."""
    values = {"T": 0.0, "H": 1.0, "λ*": INTERPOLATING[degree]}
    merged: list[tuple[Floats, str]] = []
    for letter, lam in values.items():
        at = plane.to_pixels(track.position(lam))
        if merged and np.hypot(*(at - merged[-1][0])) < MERGE:
            merged[-1] = merged[-1][0], f"{merged[-1][1]} {letter}"
        else:
            merged.append((at, letter))
    return merged


def paint_reach(
    painter: QPainter,
    curve: Curve,
    point: int,
    bounds: tuple[float, float],
    plane: Viewport,
    colours: Colours,
) -> None:
    """Shade all that one λ can reach over its bounds, with the T, H and interpolating curves thin in it."""
    band = reach(curve, point, bounds)
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.WindingFill)
    for quad in plane.to_pixels(band.quads.reshape(-1, 4, 2)).clip(-1e5, 1e5):
        path.addPolygon(QPolygonF([QPointF(*corner) for corner in (*quad, quad[0])]))
    fill = QColor(colours.accent)
    fill.setAlpha(38)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.fillPath(path, fill)
    thin = {
        Mode.TRIGONOMETRIC: band.trigonometric,
        Mode.HYPERBOLIC: band.hyperbolic,
        Mode.INTERPOLATING: band.interpolating,
    }
    for mode, segments in thin.items():
        for segment in segments:
            _polyline(painter, plane.to_pixels(segment), plane, _pen(colours.of_mode(mode), 1.0))


def paint_hull(painter: QPainter, corners: Floats, plane: Viewport, colours: Colours) -> None:
    """Paint a convex hull (k, 2)."""
    pixels = plane.to_pixels(corners).clip(-1e5, 1e5)
    fill = QColor(colours.hull)
    fill.setAlpha(140)
    painter.setBrush(fill)
    painter.setPen(_pen(colours.interpolating, 1.0))
    painter.drawPolygon(QPolygonF([QPointF(*corner) for corner in pixels]))
    painter.setBrush(Qt.BrushStyle.NoBrush)


def paint_guards(painter: QPainter, curve: Curve, segments: Ints, plane: Viewport, colours: Colours) -> None:
    """Paint a warning sign at the middle of each of some segments that has a negative basis function."""
    places = curve(distinct(negative_basis(curve, segments).segments) + 0.5)
    places = plane.to_pixels(places[points_inside(places, plane, 10.0)])
    if len(places) > MOST_SIGNS:
        return
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for place in places:
        painter.setPen(_pen(colours.canvas, 1.0))
        painter.setBrush(QColor(colours.warning))
        corners = place + np.array([[0.0, -6.0], [6.0, 4.5], [-6.0, 4.5]])
        painter.drawPolygon(QPolygonF([QPointF(*corner) for corner in corners]))
        painter.setPen(_pen(colours.canvas, 1.6))
        painter.drawLine(QPointF(place[0], place[1] - 2.0), QPointF(place[0], place[1] + 1.0))
        painter.drawPoint(QPointF(place[0], place[1] + 2.9))
    painter.setBrush(Qt.BrushStyle.NoBrush)


@lru_cache(maxsize=4)
def guards_of(curve: Curve) -> Guards:
    """The negative basis functions of a curve, computed once."""
    return negative_basis(curve)


def paint_place(painter: QPainter, place: Floats, colours: Colours) -> None:
    """Point out a place on the curve, in pixels."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(_pen(colours.canvas, 1.5))
    painter.setBrush(QColor(colours.comb))
    painter.drawEllipse(QPointF(*place), 5.0, 5.0)
    painter.setBrush(Qt.BrushStyle.NoBrush)


def paint_miss(painter: QPainter, miss: Floats, colours: Colours) -> None:
    """Paint a thin line from what a pull reached to where the pointer is, (2, 2) in pixels, if they are apart."""
    reached, target = miss
    if np.hypot(*(target - reached)) <= LEAST_MISS:
        return
    painter.setPen(_pen(colours.hyperbolic, 1.2))
    painter.drawLine(QPointF(*reached), QPointF(*target))
    painter.drawEllipse(QPointF(*target), 3.0, 3.0)


def paint_snapped(painter: QPainter, place: Floats, to: str, colours: Colours, font: QFont) -> None:
    """Mark the place in pixels that the hand is drawn to, and name what is there."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(_pen(colours.accent, 1.5))
    painter.drawEllipse(QPointF(*place), 9.0, 9.0)
    painter.setFont(_small(font))
    metrics = QFontMetricsF(painter.font())
    beside = QPointF(*place) + QPointF(14, 20)
    box = metrics.boundingRect(to).translated(beside).adjusted(-4, -2, 4, 2)
    painter.setBrush(QColor(colours.selection))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.drawRoundedRect(box, 3, 3)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QColor(colours.accent_text))
    painter.drawText(beside, to)


def _polyline(painter: QPainter, pixels: Floats, plane: Viewport, pen: QPen) -> None:
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(pen)
    lines, _ = clipped(np.hstack([pixels[:-1], pixels[1:]]), plane.width, plane.height)
    draw_lines(painter, lines)


def _pen(colour: str, width: float) -> QPen:
    pen = QPen(QColor(colour), width)
    pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    return pen


def _small(font: QFont) -> QFont:
    small = QFont(font)
    small.setPixelSize(10)
    return small
