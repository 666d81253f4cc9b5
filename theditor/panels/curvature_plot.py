"""How curvature against arc length is drawn: line and ground by sign, joints, marks, and the place at hand."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPen, QPolygonF

from theditor.model import Colours
from theditor.panels.curvature_profile import Floats, Profile
from theditor.panels.parts import small_font
from theditor.panels.plot import Plot, paint_axes, round_range, round_step
from theditor.spline import Curve
from theditor.spline.vertices import curvature_extremes, inflections

MOST_MARKED = 1000
"""Longer curves, in segments, get no marks."""
_HEADER, _LEFT, _RIGHT, _FOOT = 24.0, 56.0, 12.0, 20.0
_NARROW = 14.0
"""Joints nearer to each other than this, in pixels, on the average, are not drawn."""


@dataclass(frozen=True, eq=False)
class Marks:
    """Where the curvature of a curve changes sign, and where its size is extreme."""

    turns: Floats  # (k,) parameters
    peaks: Floats  # (n,) parameters
    heights: Floats  # (n,) |κ| there
    maximum: NDArray[np.bool_]  # (n,)


NO_MARKS = Marks(np.empty(0), np.empty(0), np.empty(0), np.empty(0, dtype=np.bool_))


def marks(curve: Curve) -> Marks:
    """Find what is to be marked on a curve."""
    turns = inflections(curve).u if curve.dimension == 2 else np.empty(0)
    extremes = curvature_extremes(curve)
    return Marks(turns, extremes.u, extremes.curvature, extremes.maximum)


def plot_of(shown: Profile, width: float, height: float) -> tuple[Plot, list[float], list[float]]:
    """The plot of a curve in a widget of this size, with the round numbers on both axes."""
    area = QRectF(_LEFT, _HEADER, max(width - _LEFT - _RIGHT, 40.0), max(height - _HEADER - _FOOT, 24.0))
    low, high = shown.range
    room = 0.06 * (high - low)
    y, ticks_y = round_range(low - room if low < 0 else 0.0, high + room, max(2, int(area.height() / 24)))
    step = round_step(shown.total, max(2, int(area.width() / 64)))
    ticks_x = np.arange(int(shown.total / step + 1e-9) + 1) * step
    return Plot(area, (0.0, shown.total), y), ticks_x.tolist(), ticks_y.tolist()


def paint_curvature(
    painter: QPainter,
    shown: Profile,
    marked: Marks,
    segments: Iterable[int],
    width: float,
    height: float,
    font: QFont,
    colours: Colours,
) -> None:
    """Paint the plot, `segments` on a ground of their own."""
    plot, ticks_x, ticks_y = plot_of(shown, width, height)
    _paint_segments(painter, shown, plot, segments, colours)
    paint_axes(painter, plot, ticks_x, ticks_y, small_font(font), colours)
    _paint_joints(painter, shown, plot, font, colours)
    zero = float(plot.pixel_y(0.0))
    area = plot.area
    above = QRectF(area.left(), area.top(), area.width(), zero - area.top())
    below = QRectF(area.left(), zero, area.width(), area.bottom() - zero)
    for half, name in ((above, colours.comb), (below, colours.comb_negative)):
        painter.save()
        painter.setClipRect(half.adjusted(-2, -2 if half is above else 0, 2, 2 if half is below else 0))
        if shown.length.size > 8 * area.width():
            _paint_envelope(painter, shown, plot, QColor(name))
        else:
            _paint_lines(painter, shown, plot, QColor(name))
        painter.restore()
    _paint_marks(painter, shown, marked, plot, colours)


def _paint_segments(
    painter: QPainter, shown: Profile, plot: Plot, segments: Iterable[int], colours: Colours
) -> None:
    chosen = np.fromiter(segments, dtype=np.intp)
    ends = np.stack([plot.pixel_x(shown.joints[chosen]), plot.pixel_x(shown.joints[chosen + 1])], axis=1)
    for a, b in np.unique(ends.round(), axis=0).tolist():
        band = QRectF(a, plot.area.top(), max(b - a, 1), plot.area.height())
        painter.fillRect(band, QColor(colours.selection))


def _paint_joints(painter: QPainter, shown: Profile, plot: Plot, font: QFont, colours: Colours) -> None:
    """Paint verticals where segments meet, and the numbers of the segments between them."""
    count = shown.curve.segment_count
    if count * _NARROW > plot.area.width():
        return
    places = plot.pixel_x(shown.joints).tolist()
    painter.setFont(small_font(font))
    for segment, (a, b) in enumerate(pairwise(places)):
        number = str(segment + shown.curve.first_segment)
        if painter.fontMetrics().horizontalAdvance(number) + 4 <= b - a:
            painter.setPen(QColor(colours.secondary))
            room = QRectF(a, plot.area.top() - 17, b - a, 14)
            painter.drawText(room, Qt.AlignmentFlag.AlignCenter, number)
    pen = QPen(QColor(colours.polygon), 1.0)
    pen.setDashPattern([2, 3])
    painter.setPen(pen)
    for x in places:
        painter.drawLine(QPointF(x, plot.area.top()), QPointF(x, plot.area.bottom()))


def _paint_lines(painter: QPainter, shown: Profile, plot: Plot, colour: QColor) -> None:
    """Paint each segment by itself, so that a jump at a joint is one."""
    faint = QColor(colour)
    faint.setAlpha(46)
    for lengths, values in zip(shown.length, shown.curvature, strict=True):
        known = np.isfinite(values)
        if not known.any():
            continue
        x, y = lengths[known], values[known]
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(faint)
        painter.drawPolygon(plot.polygon(np.r_[x[0], x, x[-1]], np.r_[0, y, 0]))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(colour, 1.8))
        painter.drawPolyline(plot.polygon(x, y))


def _paint_envelope(painter: QPainter, shown: Profile, plot: Plot, colour: QColor) -> None:
    """Paint, for each column of pixels, from the least to the greatest curvature in it."""
    known = np.isfinite(shown.curvature).ravel()
    columns = plot.pixel_x(shown.length.ravel()[known]).astype(np.intp)
    values = shown.curvature.ravel()[known]
    if not len(values):
        return
    starts = np.flatnonzero(np.r_[True, np.diff(columns) != 0])
    low = plot.pixel_y(np.minimum.reduceat(values, starts))
    high = plot.pixel_y(np.maximum.reduceat(values, starts))
    painter.setPen(QPen(colour, 1.0))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    middles = columns[starts] + 0.5
    painter.drawLines(
        [
            QLineF(x, a, x, b + 1)
            for x, a, b in zip(middles.tolist(), high.tolist(), low.tolist(), strict=True)
        ]
    )
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)


def _paint_marks(painter: QPainter, shown: Profile, marked: Marks, plot: Plot, colours: Colours) -> None:
    """Paint rings at inflections and triangles at extremes, hollow where |κ| is least."""
    painter.setPen(QPen(QColor(colours.comb), 1.5))
    painter.setBrush(QColor(colours.panel))
    for u in marked.turns.tolist():
        place = QPointF(float(plot.pixel_x(shown.length_at(u))), float(plot.pixel_y(0.0)))
        painter.drawEllipse(place, 3.2, 3.2)
    for u, height, maximum in zip(
        marked.peaks.tolist(), marked.heights.tolist(), marked.maximum.tolist(), strict=True
    ):
        value = _signed(shown, u, height)
        x = float(plot.pixel_x(shown.length_at(u)))
        y = min(max(float(plot.pixel_y(value)), plot.area.top()), plot.area.bottom())
        colour = QColor(colours.comb if value >= 0 else colours.comb_negative)
        painter.setPen(QPen(colour, 1.5))
        painter.setBrush(colour if maximum else QColor(colours.panel))
        painter.drawPolygon(QPolygonF([QPointF(x, y - 4.5), QPointF(x + 4, y + 3), QPointF(x - 4, y + 3)]))
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _signed(shown: Profile, u: float, height: float) -> float:
    """Give |κ| = `height` at `u` the sign that κ has on the side where that is its size."""
    if shown.curve.dimension == 3:
        return height
    segment = min(int(u), shown.curve.segment_count - 1)
    if u == segment and segment:
        left, right = shown.curvature[segment - 1, -1], shown.curvature[segment, 0]
        here = left if abs(abs(left) - height) < abs(abs(right) - height) else right
    else:
        here = np.interp(u - segment, shown.t, shown.curvature[segment])
    return float(np.copysign(height, here))


def paint_place(
    painter: QPainter, shown: Profile, u: float, width: float, height: float, colours: Colours
) -> None:
    """Paint the place at parameter `u` on a plot of this size."""
    plot, _, _ = plot_of(shown, width, height)
    length = shown.length_at(u)
    x = float(plot.pixel_x(length))
    painter.setPen(QPen(QColor(colours.accent), 1.0))
    painter.drawLine(QPointF(x, plot.area.top()), QPointF(x, plot.area.bottom()))
    segment = min(int(u), shown.curve.segment_count - 1)
    value = float(np.interp(length, shown.length[segment], shown.curvature[segment]))
    if np.isfinite(value):
        y = min(max(float(plot.pixel_y(value)), plot.area.top()), plot.area.bottom())
        painter.setPen(QPen(QColor(colours.panel), 1.5))
        painter.setBrush(QColor(colours.accent))
        painter.drawEllipse(QPointF(x, y), 4.5, 4.5)
        painter.setBrush(Qt.BrushStyle.NoBrush)
