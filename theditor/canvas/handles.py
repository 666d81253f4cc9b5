"""What people take hold of: the control polygon, the handles of the control points, and the joints."""

from __future__ import annotations

from collections.abc import Collection
from enum import IntEnum
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPixmap
from shiboken6 import Shiboken

from theditor.canvas.lines import clipped, draw_lines
from theditor.canvas.viewport import Viewport
from theditor.model.colours import Colours
from theditor.spline import Curve

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]

TICK = 5.5
"""Half the length in pixels of the tick across the curve at a joint."""
HIDDEN = 6.0
"""A joint this near to its control point's handle, in pixels, lies under it."""
LEAST_JOINT_SPACING = 12.0
"""Joints nearer to each other than this many pixels are not marked."""
CELL = 4.0
"""Of the handles within a square of this many pixels only the topmost is drawn."""


class Look(IntEnum):
    """How a handle looks, in the order in which they are painted."""

    INACTIVE = 0
    PLAIN = 1
    SELECTED = 2


def paint_polygon(painter: QPainter, curve: Curve, viewport: Viewport, colours: Colours) -> None:
    """Paint the control polygon, dashed."""
    pixels = viewport.to_pixels(curve.polygon)
    lines, _ = clipped(np.hstack([pixels[:-1], pixels[1:]]), viewport.width, viewport.height)
    pen = QPen(QColor(colours.polygon), 1)
    if len(lines) <= 2000:
        pen.setDashPattern([4, 3])
    painter.setPen(pen)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    draw_lines(painter, lines)


def paint_joints(painter: QPainter, curve: Curve, viewport: Viewport, colours: Colours) -> None:
    """Paint a short tick across the curve at each joint, unless they are too crowded to tell apart."""
    pixels = viewport.to_pixels(curve.joints)
    visible = np.flatnonzero(_inside(pixels, viewport))
    if not len(visible):
        return
    spacing = np.hypot(*np.diff(pixels[visible], axis=0).T)
    if len(spacing) and np.median(spacing) < LEAST_JOINT_SPACING:
        return
    own = (visible + curve.first_segment) % len(curve.control_points)
    handles = viewport.to_pixels(curve.control_points[own])
    visible = visible[np.hypot(*(pixels[visible] - handles).T) > HIDDEN]
    across = _normals(curve, visible) * TICK
    painter.setPen(QPen(QColor(colours.text), 1.5))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    draw_lines(painter, np.hstack([pixels[visible] - across, pixels[visible] + across]))


def _normals(curve: Curve, joints: Ints) -> Floats:
    """Unit vectors in pixels (y downward) across the curve at some joints; up where it has no direction."""
    direction = curve(joints.astype(np.float64), nu=1)
    length = np.hypot(*direction.T)[:, None]
    still = length[:, 0] <= 1e-12 * max(1.0, float(np.abs(curve.control_points).max()))
    unit = direction / np.where(length > 0, length, 1.0)
    unit[still] = (1.0, 0.0)
    return np.stack([unit[:, 1], unit[:, 0]], axis=1)


def paint_handles(
    painter: QPainter,
    curve: Curve,
    viewport: Viewport,
    selected: Collection[int] | Ints,
    hovered: int | None,
    colours: Colours,
) -> None:
    """Paint the handles of the control points in view: selected ones filled, those with an inactive λ dashed."""
    pixels = viewport.to_pixels(curve.control_points)
    visible = np.flatnonzero(_inside(pixels, viewport))
    looks = np.where(curve.active_lambdas, Look.PLAIN, Look.INACTIVE)
    looks[np.fromiter(selected, dtype=np.intp, count=len(selected))] = Look.SELECTED
    ratio = painter.device().devicePixelRatioF()
    if hovered is not None and hovered < len(pixels):
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        halo = QColor(colours.accent)
        halo.setAlpha(60)
        painter.setBrush(halo)
        painter.drawEllipse(QPointF(*pixels[hovered]), 10, 10)
        painter.setBrush(Qt.BrushStyle.NoBrush)
    for look in Look:
        chosen = thinned(pixels[visible[looks[visible] == look]])
        _draw_pixmaps(painter, chosen, _pixmap(look, colours, ratio), ratio)


def _inside(pixels: Floats, viewport: Viewport) -> NDArray[np.bool_]:
    far = np.array([viewport.width + 12, viewport.height + 12])
    inside: NDArray[np.bool_] = np.all((pixels >= -12) & (pixels <= far), axis=1)
    return inside


def thinned(pixels: Floats) -> Floats:
    """The last of the positions (n, 2) in each cell: those that others cover are left out."""
    if len(pixels) < 1000:
        return pixels
    cells = np.floor(pixels / CELL).astype(np.int64)
    keys = (cells[:, 0] << 32) + cells[:, 1]
    _, last = np.unique(keys[::-1], return_index=True)
    kept: Floats = pixels[np.sort(len(pixels) - 1 - last)]
    return kept


@lru_cache(maxsize=32)
def _pixmap(look: Look, colours: Colours, ratio: float) -> QPixmap:
    """A handle's picture, an odd number of device pixels wide, so that its middle is a pixel's middle."""
    size = 2 * round(8 * ratio) + 1
    pixmap = QPixmap(size, size)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.scale(ratio, ratio)
    middle = QPointF(size / 2 / ratio, size / 2 / ratio)
    if look is Look.SELECTED:
        painter.setPen(QPen(QColor(colours.canvas), 1.5))
        painter.setBrush(QColor(colours.accent))
        painter.drawEllipse(middle, 6.0, 6.0)
    else:
        pen = QPen(QColor(colours.secondary), 1.5)
        if look is Look.INACTIVE:
            pen.setDashPattern([1.6, 1.4])
            pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        painter.setPen(pen)
        painter.setBrush(QColor(colours.canvas))
        painter.drawEllipse(middle, 4.2, 4.2)
    painter.end()
    return pixmap


def _draw_pixmaps(painter: QPainter, pixels: Floats, pixmap: QPixmap, ratio: float) -> None:
    if not len(pixels):
        return
    fragments = np.zeros((len(pixels), 10))
    fragments[:, :2] = (np.floor(pixels * ratio) + 0.5) / ratio
    fragments[:, 4:6] = pixmap.width()
    fragments[:, 6:8] = 1 / ratio
    fragments[:, 9] = 1
    first: Any = Shiboken.wrapInstance(fragments.ctypes.data, QPainter.PixmapFragment)
    painter.drawPixmapFragments(first, len(fragments), pixmap)
