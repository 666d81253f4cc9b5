"""How the basis functions of a segment are drawn: over t, and their weights at one t as bars."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPen

from theditor.model import Colours
from theditor.model.words import indexed, listed
from theditor.panels.parts import small_font, tabular
from theditor.panels.plot import Plot, paint_axes, round_range
from theditor.spline import Curve, Mode, basis, negative_basis

Floats = NDArray[np.float64]

_T = np.linspace(0, 1, 129)
_HEADER, _LEFT, _RIGHT, _FOOT, _GAP = 34.0, 52.0, 16.0, 34.0, 28.0
_COLUMN, _BAR = 52.0, 18.0
_CENTRED = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignVCenter
_VERTICAL = Qt.AlignmentFlag.AlignVCenter


@dataclass(frozen=True)
class SegmentBasis:
    """The basis functions of one segment of a curve."""

    curve: Curve
    segment: int

    @property
    def mode(self) -> Mode:
        """The mode of the segment."""
        return self.curve.mode_at(self.segment)

    @property
    def names(self) -> list[str]:
        """What the functions are called: q₀ … q₂ or c₀ … c₃."""
        letter = "q" if self.curve.degree == 2 else "c"
        return [indexed(letter, k) for k in range(self.curve.degree + 1)]

    @property
    def lambdas(self) -> tuple[float, float]:
        """Both λ of the segment; 0 at a clamped cubic end, where it has no effect."""
        start, end = (
            0.0 if i is None else float(self.curve.lambdas[i])
            for i in self.curve.lambda_indices(self.segment)
        )
        return start, end

    def weights(self, t: float | Floats) -> Floats:
        """Values of the functions at `t`, (…, degree + 1)."""
        return basis(t, *self.lambdas, self.curve.degree)

    def negative(self) -> list[str]:
        """Names of the functions that are negative somewhere."""
        degree = self.curve.degree
        alike = Curve(np.zeros((degree + 1, 2)), (0.0, *self.lambdas, 0.0)[: degree + 1], degree)
        return [self.names[k] for k in negative_basis(alike).functions.tolist()]

    def title(self) -> str:
        """Name the segment and its mode, and what is negative."""
        number = self.segment + self.curve.first_segment
        negative = self.negative()
        title = f"Segment {number}, {self.mode.value}"
        if negative:
            title += f" · {listed(negative)} negative in part"
        return title


def plots(shown: SegmentBasis, width: float, height: float) -> tuple[Plot, Plot, Floats]:
    """The plot over t, beside it that of the bars, which shares its scale, and the ticks of that scale."""
    values = shown.weights(_T)
    room = max(height - _HEADER - _FOOT, 24.0)
    scale, ticks = round_range(min(float(values.min()), 0.0), float(values.max()), max(2, int(room / 22)))
    columns = _COLUMN * (shown.curve.degree + 1)
    left = QRectF(_LEFT, _HEADER, max(width - _LEFT - _GAP - columns - _RIGHT, 40.0), room)
    right = QRectF(left.right() + _GAP, _HEADER, columns, room)
    return Plot(left, (0.0, 1.0), scale), Plot(right, (0.0, shown.curve.degree + 1.0), scale), ticks


def paint_basis(
    painter: QPainter,
    shown: SegmentBasis,
    t: float,
    width: float,
    height: float,
    font: QFont,
    colours: Colours,
) -> None:
    """Paint the functions over t, thin behind them those of T and H, and their weights at `t`."""
    functions, bars, ticks = plots(shown, width, height)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    small = small_font(font)
    paint_axes(painter, functions, np.linspace(0, 1, 5).tolist(), ticks.tolist(), small, colours)
    for mode, lam in ((Mode.TRIGONOMETRIC, 0.0), (Mode.HYPERBOLIC, 1.0)):
        thin = QPen(QColor(colours.of_mode(mode)), 1.0)
        thin.setDashPattern([4, 3])
        painter.setPen(thin)
        for values in basis(_T, lam, lam, shown.curve.degree).T:
            painter.drawPolyline(functions.polygon(_T, values))
    colour = QColor(colours.of_mode(shown.mode))
    for values in shown.weights(_T).T:
        _fill_negative(painter, functions, values, colour)
        painter.setPen(QPen(colour, 2.0))
        painter.drawPolyline(functions.polygon(_T, values))
    _paint_names(painter, shown, functions, font, colours)
    _paint_marker(painter, shown, functions, t, colours)
    _paint_bars(painter, shown, bars, t, font, colours)
    painter.setPen(QColor(colours.secondary))
    painter.setFont(tabular(font))
    header = QRectF(_LEFT, 4, functions.area.width(), _HEADER - 8)
    title = painter.fontMetrics().elidedText(
        shown.title(), Qt.TextElideMode.ElideRight, int(functions.area.width())
    )
    painter.drawText(header, _VERTICAL, title)
    at_t = QRectF(bars.area.left(), 4, bars.area.width(), _HEADER - 8)
    painter.drawText(at_t, _CENTRED, f"weights at t = {t:.3f}")


def _fill_negative(painter: QPainter, plot: Plot, values: Floats, colour: QColor) -> None:
    if values.min() < 0:
        faint = QColor(colour)
        faint.setAlpha(90)
        outline = plot.polygon(np.r_[0, _T, 1], np.r_[0, np.minimum(values, 0), 0])
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(faint)
        painter.drawPolygon(outline)
        painter.setBrush(Qt.BrushStyle.NoBrush)


def _paint_names(painter: QPainter, shown: SegmentBasis, plot: Plot, font: QFont, colours: Colours) -> None:
    """Write each function's name where it is well apart from the others."""
    painter.setFont(font)
    painter.setPen(QColor(colours.text))
    metrics = QFontMetricsF(font)
    ground = QColor(colours.panel)
    ground.setAlpha(180)
    places = np.array([0.04, 0.5, 0.96] if shown.curve.degree == 2 else [0.04, 0.2, 0.8, 0.96])
    for k, (name, t) in enumerate(zip(shown.names, places.tolist(), strict=True)):
        x, y = float(plot.pixel_x(t)), float(plot.pixel_y(shown.weights(t)[k]))
        above = y - metrics.descent() - 3
        if above - metrics.ascent() < plot.area.top():
            above = y + metrics.ascent() + 3
        width = metrics.horizontalAdvance(name)
        room = QRectF(x - width / 2 - 1, above - metrics.ascent() + 2, width + 2, metrics.height() - 3)
        painter.fillRect(room, ground)
        painter.drawText(QPointF(x - width / 2, above), name)


def _paint_marker(painter: QPainter, shown: SegmentBasis, plot: Plot, t: float, colours: Colours) -> None:
    x = float(plot.pixel_x(t))
    painter.setPen(QPen(QColor(colours.accent), 1.0))
    painter.drawLine(QPointF(x, plot.area.top()), QPointF(x, plot.area.bottom()))
    painter.setPen(QPen(QColor(colours.panel), 1.5))
    painter.setBrush(QColor(colours.accent))
    for y in plot.pixel_y(shown.weights(t)).tolist():
        painter.drawEllipse(QPointF(x, y), 4.0, 4.0)
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _paint_bars(
    painter: QPainter, shown: SegmentBasis, plot: Plot, t: float, font: QFont, colours: Colours
) -> None:
    paint_axes(painter, plot, (), (0.0,), QFont(font), colours)
    colour = QColor(colours.of_mode(shown.mode))
    faint = QColor(colour)
    faint.setAlpha(90)
    base = float(plot.pixel_y(0.0))
    weights = shown.weights(t)
    points = _names_of_points(shown)
    for k, weight in enumerate(weights.tolist()):
        middle = float(plot.pixel_x(k + 0.5))
        tip = float(plot.pixel_y(weight))
        painter.setPen(QPen(colour, 1.0) if weight < 0 else Qt.PenStyle.NoPen)
        painter.setBrush(faint if weight < 0 else colour)
        painter.drawRect(QRectF(QPointF(middle - _BAR / 2, base), QPointF(middle + _BAR / 2, tip)))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        under = QRectF(middle - _COLUMN / 2, plot.area.bottom() + 2, _COLUMN, 15)
        painter.setFont(small_font(font))
        painter.setPen(QColor(colours.text))
        painter.drawText(under, _CENTRED, f"{shown.names[k]} {points[k]}")
        painter.setPen(QColor(colours.secondary))
        painter.drawText(under.translated(0, 14), _CENTRED, f"{weight:.3f}".replace("-", "−"))


def _names_of_points(shown: SegmentBasis) -> Sequence[str]:
    """Names of the control points that the functions weight; empty where a clamped end has put another."""
    curve = shown.curve
    first = shown.segment + curve.first_segment - 1
    indices = range(first, first + curve.degree + 1)
    count = len(curve.control_points)
    if curve.closed:
        return [indexed("P", i % count) for i in indices]
    own = range(1, count - 1) if curve.ends == "clamped" and curve.degree == 2 else range(count)
    return [indexed("P", i) if i in own else "" for i in indices]
