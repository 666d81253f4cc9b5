"""The grid behind the drawing, with quiet numbers along the edges."""

from __future__ import annotations

import math

import numpy as np
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPen

from theditor.canvas.lines import draw_lines
from theditor.canvas.viewport import Floats, Viewport
from theditor.model.colours import Colours

MAJOR_SPACING = 80
"""Major lines are at least this many pixels apart."""


def steps(scale: float) -> tuple[float, float]:
    """Distances of major and minor lines, in units, for a scale in pixels per unit: 1, 2 or 5 times a power of ten."""
    least = MAJOR_SPACING / scale
    power = 10.0 ** math.floor(math.log10(least))
    factor = next(f for f in (1, 2, 5, 10) if f * power >= least * (1 - 1e-9))
    return factor * power, factor * power / (4 if factor == 2 else 5)


def paint_grid(painter: QPainter, viewport: Viewport, colours: Colours, font: QFont) -> None:
    """Paint minor and major lines, the two axes, and the numbers of the major lines."""
    major, minor = steps(viewport.scale)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    for step, colour in ((minor, colours.grid_minor), (major, colours.grid_major)):
        painter.setPen(QPen(QColor(colour), 1))
        draw_lines(painter, _grid_lines(viewport, *(_multiples(viewport, axis, step) for axis in (0, 1))))
    painter.setPen(QPen(QColor(colours.border), 1))
    draw_lines(painter, _grid_lines(viewport, *(_zero(viewport, axis) for axis in (0, 1))))
    _paint_numbers(painter, viewport, major, colours, font)


def _multiples(viewport: Viewport, axis: int, step: float) -> Floats:
    low, high = viewport.window()
    return np.arange(math.ceil(low[axis] / step), math.floor(high[axis] / step) + 1) * step


def _zero(viewport: Viewport, axis: int) -> Floats:
    low, high = viewport.window()
    return np.zeros(1 if low[axis] <= 0 <= high[axis] else 0)


def _grid_lines(viewport: Viewport, xs: Floats, ys: Floats) -> Floats:
    """Upright lines at `xs` and level ones at `ys`, as (n, 4) whole pixels."""
    lines = np.zeros((len(xs) + len(ys), 4))
    upright, level = lines[: len(xs)], lines[len(xs) :]
    upright[:, 0] = upright[:, 2] = _pixels(viewport, xs, 0)
    upright[:, 3] = viewport.height
    level[:, 1] = level[:, 3] = _pixels(viewport, ys, 1)
    level[:, 2] = viewport.width
    return lines


def _pixels(viewport: Viewport, values: Floats, axis: int) -> Floats:
    points = np.full((len(values), 2), (viewport.x, viewport.y))
    points[:, axis] = values
    return np.floor(viewport.to_pixels(points)[:, axis])


def _paint_numbers(painter: QPainter, viewport: Viewport, step: float, colours: Colours, font: QFont) -> None:
    small = QFont(font)
    small.setPixelSize(10)
    painter.setFont(small)
    painter.setPen(QColor(colours.secondary))
    xs, ys = (_multiples(viewport, axis, step) for axis in (0, 1))
    bottom = viewport.height - 16
    for x, at in zip(xs.tolist(), _pixels(viewport, xs, 0).tolist(), strict=True):
        if 40 < at < viewport.width - 20:
            box = QRectF(at - 38, bottom, 76, 14)
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, number(x, step))
    for y, at in zip(ys.tolist(), _pixels(viewport, ys, 1).tolist(), strict=True):
        if 12 < at < viewport.height - 28:
            box = QRectF(6, at - 15, 90, 14)
            painter.drawText(box, Qt.AlignmentFlag.AlignLeft, number(y, step))


def number(value: float, step: float) -> str:
    """A grid line's number, with as many digits as tell it from the next line's."""
    decimals = max(0, -math.floor(math.log10(step) + 1e-9))
    size = max(abs(value), step)
    if size >= 1e6 or decimals > 6:
        digits = max(1, math.ceil(math.log10(size / step) + 1e-9) + 1)
        text = f"{value:.{digits}g}"
    else:
        text = f"{value:.{decimals}f}"
    return text.replace("-", "−")
