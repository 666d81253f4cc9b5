"""What people take hold of: the control polygon, the handles of the control points, and the joints."""

from __future__ import annotations

from enum import IntEnum
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPixmap
from shiboken6 import Shiboken

from theditor.canvas.lines import clipped, draw_lines
from theditor.canvas.viewport import Viewport, inside
from theditor.model.colours import Colours
from theditor.spline import Curve
from theditor.spline.distinct import distinct

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]

TICK = 5.5
"""Half the length in pixels of the tick across the curve at a joint."""
HIDDEN = 6.0
"""A joint this near to its control point's handle, in pixels, lies under it."""
LEAST_JOINT_SPACING = 12.0
"""Joints nearer to each other than this many pixels are not marked."""
SQUARE = 16.0
MOST_IN_SQUARE = 1.5
"""More handles than this in each occupied square of `SQUARE` pixels hide the curve: only selected ones are shown."""
PROBES = 2000
"""So many distances tell how near points lie to each other."""
FEW = 30
"""So many handles show however near they are."""
MOST_DASHED = 2000
"""With more edges in view the polygon is drawn without dashes."""
CELL = 4.0
"""Of the handles within a square of this many pixels only the topmost is drawn."""


class Look(IntEnum):
    """How a handle looks."""

    INACTIVE = 0
    PLAIN = 1
    SELECTED = 2


class Detail(NamedTuple):
    """How much of what holds a curve can be told apart in a view."""

    points: int
    """How many control points are in view,"""
    segments: int
    """and how many segments,"""
    spacing: float
    """which are usually so many pixels long."""
    handles: bool
    """Whether control points lie far enough apart to show their handles and their polygon."""
    dashed: bool
    """Whether so few edges are in view that they may be dashed."""
    joints: bool
    """Whether joints lie far enough apart to be marked."""


def detail(curve: Curve, viewport: Viewport, visible: Ints) -> Detail:
    """What can be told apart in a view that shows some segments of a plane curve."""
    points = points_inside(curve.control_points, viewport)
    corners = curve.control_points[points]
    sizes = len(points), len(visible), _spacing(corners, viewport) if len(points) > 1 else viewport.width
    if len(points) > FEW and _crowd(corners, viewport) > MOST_IN_SQUARE:
        return Detail(*sizes, handles=False, dashed=False, joints=False)
    meetings = curve(distinct(np.concatenate([visible, visible + 1])))
    meetings = meetings[points_inside(meetings, viewport)]
    crowded = len(meetings) > 1 and _spacing(meetings, viewport) < LEAST_JOINT_SPACING
    return Detail(*sizes, handles=True, dashed=len(visible) <= MOST_DASHED, joints=not crowded)


def _crowd(points: Floats, viewport: Viewport) -> float:
    """How many of some points in view share a square on average, of those squares that have any."""
    low, _ = viewport.window(12.0)
    x, y = points.T
    columns = ((x - low[0]) * (viewport.scale / SQUARE)).astype(np.intp)
    rows = ((y - low[1]) * (viewport.scale / SQUARE)).astype(np.intp)
    return len(points) / np.count_nonzero(np.bincount(rows * (int(viewport.width / SQUARE) + 4) + columns))


def _spacing(points: Floats, viewport: Viewport) -> float:
    """The usual distance in pixels from one point to the next, as some of them tell."""
    step = 1 + len(points) // PROBES
    lengths = np.sort(np.hypot(*(points[1::step] - points[:-1:step]).T))
    return float(lengths[len(lengths) // 2]) * viewport.scale  # np.median loads numpy.ma


def points_inside(points: Floats, viewport: Viewport, margin: float = 12.0) -> Ints:
    """Which points (n, 2) of the plane are in view or, by at most `margin` pixels, beside it."""
    return inside(points, *viewport.window(margin))


def paint_polygon(
    painter: QPainter, curve: Curve, edges: Ints, viewport: Viewport, colours: Colours, *, dashed: bool
) -> None:
    """Paint some edges of the control polygon, each from the control point of its number."""
    points = curve.control_points
    ends = np.hstack([points[edges], points[(edges + 1) % len(points)]])
    lines, _ = clipped(viewport.lines_to_pixels(ends), viewport.width, viewport.height)
    pen = QPen(QColor(colours.polygon), 1)
    if dashed:
        pen.setDashPattern([4, 3])
    painter.setPen(pen)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    draw_lines(painter, lines)


def paint_joints(painter: QPainter, curve: Curve, joints: Ints, viewport: Viewport, colours: Colours) -> None:
    """Paint a short tick across the curve at some joints."""
    places = curve(joints)
    inside = points_inside(places, viewport)
    joints, pixels = joints[inside], viewport.to_pixels(places[inside])
    own = (joints + curve.first_segment) % len(curve.control_points)
    handles = viewport.to_pixels(curve.control_points[own])
    bare = np.hypot(*(pixels - handles).T) > HIDDEN
    joints, pixels = joints[bare], pixels[bare]
    if len(joints):
        across = _normals(curve, joints) * TICK
        painter.setPen(QPen(QColor(colours.text), 1.5))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        draw_lines(painter, np.hstack([pixels - across, pixels + across]))


def _normals(curve: Curve, joints: Ints) -> Floats:
    """Unit vectors in pixels (y downward) across the curve at some joints; up where it has no direction."""
    direction = curve(joints.astype(np.float64), nu=1)
    length = np.hypot(*direction.T)[:, None]
    still = length[:, 0] <= 1e-12 * max(1.0, float(np.abs(curve.control_points).max()))
    unit = direction / np.where(length > 0, length, 1.0)
    unit[still] = (1.0, 0.0)
    return np.stack([unit[:, 1], unit[:, 0]], axis=1)


def paint_handles(
    painter: QPainter, curve: Curve, points: Ints, viewport: Viewport, colours: Colours
) -> None:
    """Paint the handles of some control points, those with an inactive λ dashed."""
    active = curve.active_lambdas[points]
    for look, chosen in ((Look.INACTIVE, points[~active]), (Look.PLAIN, points[active])):
        _paint_look(painter, curve.control_points[chosen], look, viewport, colours)


def paint_selected(painter: QPainter, places: Floats, viewport: Viewport, colours: Colours) -> None:
    """Paint the filled handles of selected control points (n, 2), which cover the other ones."""
    _paint_look(painter, places, Look.SELECTED, viewport, colours)


def paint_hovered(painter: QPainter, curve: Curve, point: int, viewport: Viewport, colours: Colours) -> None:
    """Paint the handle of the control point under the pointer, with a halo."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    halo = QColor(colours.accent)
    halo.setAlpha(60)
    painter.setBrush(halo)
    painter.drawEllipse(QPointF(*viewport.to_pixels(curve.control_points[point])), 10, 10)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    paint_handles(painter, curve, np.array([point]), viewport, colours)


def _paint_look(painter: QPainter, places: Floats, look: Look, viewport: Viewport, colours: Colours) -> None:
    places = places[points_inside(places, viewport)]
    pixels = thinned(viewport.to_pixels(places), viewport.to_pixels((0.0, 0.0)))
    ratio = painter.device().devicePixelRatioF()
    _draw_pixmaps(painter, pixels, _pixmap(look, colours, ratio), ratio)


def thinned(pixels: Floats, origin: Floats | float = 0.0) -> Floats:
    """The last of the positions (n, 2) in each cell: those that others cover are left out.

    One of the cells begins at the origin, so that the choice does not depend on what is in view.
    """
    if len(pixels) < 1000:
        return pixels
    columns, rows = np.floor((pixels - np.mod(origin, CELL)) / CELL).astype(np.intp).T
    columns, rows = columns - columns.min(), rows - rows.min()
    cells = rows * (columns.max() + 1) + columns
    topmost = np.full(cells.max() + 1, -1)
    topmost[cells] = np.arange(len(pixels))  # the last one stays
    kept: Floats = pixels[np.sort(topmost[topmost >= 0])]
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
    # A little more than the place itself, lest rounding should decide for one of two device pixels.
    fragments[:, :2] = (np.floor(pixels * ratio + 1e-4) + 0.5) / ratio
    fragments[:, 4:6] = pixmap.width()
    fragments[:, 6:8] = 1 / ratio
    fragments[:, 9] = 1
    first: Any = Shiboken.wrapInstance(fragments.ctypes.data, QPainter.PixmapFragment)
    painter.drawPixmapFragments(first, len(fragments), pixmap)
