"""A plot's rectangle on the screen with a scale on each axis, and how its quiet axes are painted."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPen, QPolygonF

from theditor.model import Colours
from theditor.model.words import number

Floats = NDArray[np.float64]
Range = tuple[float, float]


@dataclass(frozen=True)
class Plot:
    """Where values appear: `area` in pixels shows the range `x` from left to right, `y` from bottom to top."""

    area: QRectF
    x: Range
    y: Range

    def pixel_x(self, values: ArrayLike) -> Floats:
        """Pixels of abscissae."""
        low, high = self.x
        share = (np.asarray(values, dtype=np.float64) - low) / (high - low)
        return np.asarray(self.area.left() + self.area.width() * share)

    def pixel_y(self, values: ArrayLike) -> Floats:
        """Pixels of ordinates, downward; far outside the area they stay where a painter can draw them."""
        low, high = self.y
        share = (np.asarray(values, dtype=np.float64) - low) / (high - low)
        return np.asarray(self.area.bottom() - self.area.height() * share.clip(-10, 11))

    def value_x(self, pixel: float) -> float:
        """The abscissa at a pixel, kept within the plot."""
        low, high = self.x
        share = (pixel - self.area.left()) / max(self.area.width(), 1.0)
        return low + (high - low) * min(max(share, 0.0), 1.0)

    def polygon(self, x: ArrayLike, y: ArrayLike) -> QPolygonF:
        """The polyline through values, in pixels."""
        pixels = zip(self.pixel_x(x).tolist(), self.pixel_y(y).tolist(), strict=True)
        return QPolygonF([QPointF(*pixel) for pixel in pixels])


def round_step(extent: float, most: int) -> float:
    """The least of 1, 2, 2.5 and 5 times a power of ten that divides `extent` into at most `most` steps."""
    least = extent / most
    power = 10.0 ** np.floor(np.log10(least))
    return float(next(power * m for m in (1, 2, 2.5, 5, 10, 20) if power * m >= least * (1 - 1e-9)))


def round_range(low: float, high: float, most: int) -> tuple[Range, Floats]:
    """A range that contains `low` … `high`, which differ, and the round numbers in it, at most about `most`.

    Its ends are fifths of the step between these numbers, so that it does not tremble while values change.
    """
    step = round_step(high - low, most)
    fine = step / 5
    ends = float(np.floor(low / fine + 1e-9) * fine), float(np.ceil(high / fine - 1e-9) * fine)
    first, last = np.ceil(ends[0] / step - 1e-9), np.floor(ends[1] / step + 1e-9)
    return ends, np.arange(first, last + 1) * step + 0.0  # no −0


def paint_axes(
    painter: QPainter,
    plot: Plot,
    ticks_x: Iterable[float],
    ticks_y: Iterable[float],
    font: QFont,
    colours: Colours,
) -> None:
    """Paint the grid of a plot with its numbers, outside the area to the left and below."""
    area = plot.area
    metrics_height = 14.0
    painter.setFont(font)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    for value, y in zip(ticks := list(ticks_y), plot.pixel_y(ticks).tolist(), strict=True):
        painter.setPen(QPen(QColor(colours.secondary if value == 0 else colours.grid_major), 1.0))
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y))
        painter.setPen(QColor(colours.secondary))
        room = QRectF(0, y - metrics_height / 2, area.left() - 6, metrics_height)
        painter.drawText(room, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, number(value))
    for value, x in zip(ticks := list(ticks_x), plot.pixel_x(ticks).tolist(), strict=True):
        painter.setPen(QPen(QColor(colours.grid_major), 1.0))
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()))
        painter.setPen(QColor(colours.secondary))
        room = QRectF(x - 40, area.bottom() + 3, 80, metrics_height)
        painter.drawText(room, Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop, number(value))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
