"""The curve to come: what a drawing tool shows before there is a curve in the drawing."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from theditor.canvas.lines import clipped, draw_lines
from theditor.canvas.trace import strokes
from theditor.canvas.viewport import Floats, Viewport
from theditor.model import Colours
from theditor.spline import Curve


class Sketch(NamedTuple):
    """Control points or strokes of the hand (n, 2), and the curve that they give, if they already give one."""

    points: Floats
    curve: Curve | None = None
    handles: bool = True
    """Whether the points are control points; if not, rows of NaN part one stroke from the next."""


def paint_sketch(painter: QPainter, sketch: Sketch, plane: Viewport, colours: Colours) -> None:
    """Paint the curve over its dashed polygon and its control points, or else the stroke."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    pixels = plane.to_pixels(sketch.points)
    polygon = QPen(QColor(colours.polygon if sketch.handles else colours.accent), 1 if sketch.handles else 2)
    if sketch.handles:
        polygon.setDashPattern([4, 3])
    painter.setPen(polygon)
    edges = np.hstack([pixels[:-1], pixels[1:]])
    lines, _ = clipped(edges[np.isfinite(edges).all(axis=1)], plane.width, plane.height)
    draw_lines(painter, lines)
    if sketch.curve is not None:
        painter.setPen(QPen(QColor(colours.accent), 2))
        for stroke in strokes(sketch.curve, plane):
            draw_lines(painter, stroke.lines)
    if sketch.handles:
        painter.setPen(QPen(QColor(colours.secondary), 1.5))
        painter.setBrush(QColor(colours.canvas))
        for pixel in pixels[((pixels > -12) & (pixels < (plane.width + 12, plane.height + 12))).all(axis=1)]:
            painter.drawEllipse(QPointF(*pixel), 4.2, 4.2)
        painter.setBrush(Qt.BrushStyle.NoBrush)
