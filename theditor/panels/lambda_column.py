"""How one column of the λ strip is drawn: the scale upright, a bar from T to λ, and the numbers below."""

from __future__ import annotations

from typing import NamedTuple

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPainterPath, QPen

from theditor.model import Colours
from theditor.model.words import indexed
from theditor.panels import lambda_scale as scale
from theditor.panels.parts import small_font
from theditor.spline import CONVEX_HULL_RANGE, mode_of

_TRACK_WIDTH = 18.0
_BAR_WIDTH = 8.0
_KNOB = (24.0, 4.0)
_MARKED_HEIGHT = 8.0
_GAP = 8
_CENTRED = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop


class Column(NamedTuple):
    """What one column shows."""

    point: int
    value: float
    degree: int
    active: bool
    selected: bool
    hovered: bool
    marked: bool
    """Whether this λ makes a basis function negative."""


def caption_height(font: QFont) -> int:
    """Height below the track: the symbol, the value, and room around them."""
    return round(2 * QFontMetricsF(small_font(font)).height() + _GAP + 4)


def value_text(value: float) -> str:
    """Two decimals, or fewer digits for large values, with a true minus sign."""
    text = f"{value:.2f}" if abs(value) < 1000 else f"{value:.3g}"
    return text.replace("-", "−")


def paint_column(
    painter: QPainter, column: Column, width: float, top: float, height: float, font: QFont, colours: Colours
) -> None:
    """Draw a column `width` pixels wide, whose track starts at `top` and is `height` pixels high."""
    bottom = top + height
    painter.setPen(Qt.PenStyle.NoPen)
    if column.selected or column.hovered:
        ground = QColor(colours.selection)
        ground.setAlphaF(1.0 if column.selected else 0.45)
        painter.setBrush(ground)
        painter.drawRoundedRect(QRectF(2, top - 6, width - 4, height + caption_height(font) + 8), 6, 6)
    painter.setOpacity(1.0 if column.active else 0.35)

    middle = width / 2

    def block(start: float, end: float, across: float, colour: str, radius: float) -> None:
        """Fill the part of the track between two places on the scale."""
        painter.setBrush(QColor(colour))
        high, low = bottom - max(start, end) * height, bottom - min(start, end) * height
        painter.drawRoundedRect(QRectF(middle - across / 2, high, across, low - high), radius, radius)

    place, trigonometric = (float(scale.position(value)) for value in (column.value, 0.0))
    hull_start, hull_end = (float(end) for end in scale.position(CONVEX_HULL_RANGE[column.degree]))
    block(0.0, 1.0, _TRACK_WIDTH, colours.grid_major, 3)
    block(hull_start, hull_end, _TRACK_WIDTH, colours.hull, 3)
    if column.value != 0:
        mode = mode_of(column.value, column.value, column.degree)
        block(trigonometric, place, _BAR_WIDTH, colours.of_mode(mode), 2)
    knob_width, knob_height = _KNOB
    if column.marked:
        knob_height = _MARKED_HEIGHT
    painter.setBrush(QColor(colours.text))
    knob = QRectF(middle - knob_width / 2, bottom - place * height - knob_height / 2, knob_width, knob_height)
    painter.drawRoundedRect(knob, 2, 2)
    if column.marked:
        _hatch(painter, knob.adjusted(1, 1, -1, -1), QColor(colours.panel))

    small = small_font(font)
    line = QFontMetricsF(small).height()
    painter.setFont(small)
    painter.setPen(QColor(colours.text))
    painter.drawText(QRectF(0, bottom + _GAP, width, line), _CENTRED, indexed("λ", column.point))
    painter.setPen(QColor(colours.text if column.selected else colours.secondary))
    painter.drawText(QRectF(0, bottom + _GAP + line, width, line), _CENTRED, value_text(column.value))


def _hatch(painter: QPainter, frame: QRectF, colour: QColor) -> None:
    """Draw slanting lines inside a frame."""
    shape = QPainterPath()
    shape.addRoundedRect(frame, 1, 1)
    painter.save()
    painter.setClipPath(shape)
    painter.setPen(QPen(colour, 1.6))
    x = frame.left() - frame.height()
    while x < frame.right():
        painter.drawLine(QPointF(x, frame.bottom()), QPointF(x + frame.height(), frame.top()))
        x += 4.0
    painter.restore()
