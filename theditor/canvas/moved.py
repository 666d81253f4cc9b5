"""A picture of the plane shown where another part of the plane is wanted: shifted, or enlarged and reduced."""

from __future__ import annotations

import math

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QPixmap

from theditor.canvas.viewport import Area, Viewport


def shift(picture: QPixmap, x: int, y: int) -> list[Area]:
    """Shift a picture by some device pixels; returns the areas that come into view, empty."""
    picture.scroll(x, y, picture.rect())
    return _clear_around(picture, x, y, picture.width() + x, picture.height() + y)


def scaled(picture: QPixmap, shown: Viewport, wanted: Viewport) -> tuple[QPixmap, list[Area]]:
    """Return a picture as it looks in another view, and the areas, empty, of which it shows nothing."""
    ratio, growth = picture.devicePixelRatio(), wanted.scale / shown.scale
    left, top = wanted.to_pixels(shown.to_points((0.0, 0.0))).tolist()
    wide, high = picture.width() / ratio * growth, picture.height() / ratio * growth
    result = QPixmap(picture.size())
    result.setDevicePixelRatio(ratio)
    result.fill(Qt.GlobalColor.transparent)
    painter = QPainter(result)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.drawPixmap(QRectF(left, top, wide, high), picture, QRectF(picture.rect()))
    painter.end()
    begin = math.ceil(left * ratio), math.ceil(top * ratio)
    end = math.floor((left + wide) * ratio), math.floor((top + high) * ratio)
    return result, _clear_around(result, *begin, *end)


def _clear_around(picture: QPixmap, left: int, top: int, right: int, bottom: int) -> list[Area]:
    """Empty a picture but for a rectangle in device pixels; returns the emptied areas, in pixels."""
    width, height, ratio = picture.width(), picture.height(), picture.devicePixelRatio()
    left, right = max(left, 0), min(right, width)
    top, bottom = max(top, 0), min(bottom, height)
    if left >= right or top >= bottom:
        left = right = width
        top = bottom = 0
    sides = (0, 0, left, height), (right, 0, width - right, height)
    levels = (left, 0, right - left, top), (left, bottom, right - left, height - bottom)
    areas: list[Area] = [
        (x / ratio, y / ratio, wide / ratio, high / ratio)
        for x, y, wide, high in (*sides, *levels)
        if wide and high
    ]
    painter = QPainter(picture)
    painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_Source)
    for area in areas:
        painter.fillRect(QRectF(*area), Qt.GlobalColor.transparent)
    painter.end()
    return areas
