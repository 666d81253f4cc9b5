"""Straight pieces in pixels: clipping them to the window and handing them to the painter without copying."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, Qt
from PySide6.QtGui import QPainter
from shiboken6 import Shiboken

Floats = NDArray[np.float64]

LONG = 4096.0
"""A line longer than this many pixels is cut off at the window."""
SPECK = 1e-3
"""So short a line, in pixels, is a point."""


def clipped(
    lines: Floats, width: float, height: float, margin: float = 8.0
) -> tuple[Floats, NDArray[np.intp]]:
    """The parts of lines (n, 4) inside the window, and the indices of the lines they are parts of.

    Qt walks along a dashed line however long it is, so a line that leaves the window far behind would stop the
    program; and its rasteriser has limits beyond some 10⁶ pixels.
    """
    x0, y0, x1, y1 = lines.T
    seen = (np.minimum(x0, x1) <= width + margin) & (np.maximum(x0, x1) >= -margin)
    seen &= (np.minimum(y0, y1) <= height + margin) & (np.maximum(y0, y1) >= -margin)
    kept = np.flatnonzero(seen)
    if len(kept) < len(lines):
        lines = lines[kept]
    x0, y0, x1, y1 = lines.T
    far = np.array([width + margin, height + margin])
    long = np.flatnonzero((np.abs(x1 - x0) > LONG) | (np.abs(y1 - y0) > LONG))
    if len(long):
        # Liang–Barsky on the long ones only.
        lines = lines.copy()
        start, along = lines[long, :2], lines[long, 2:] - lines[long, :2]
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            enter, leave = (-margin - start) / along, (far - start) / along
        enter, leave = np.fmin(enter, leave), np.fmax(enter, leave)
        t0 = np.fmax(np.fmax(enter[:, 0], enter[:, 1]), 0.0)[:, None]
        t1 = np.fmin(np.fmin(leave[:, 0], leave[:, 1]), 1.0)[:, None]
        lines[long] = np.hstack([start + t0 * along, start + t1 * along])
        inside = np.ones(len(lines), dtype=bool)
        inside[long] = (t0 <= t1)[:, 0]
        lines, kept = lines[inside], kept[inside]
    return np.ascontiguousarray(lines), kept


def draw_lines(painter: QPainter, lines: Floats) -> None:
    """Draw C-contiguous lines (n, 4): x and y of the start, x and y of the end.

    Of round caps without any length between them Qt leaves nothing; there they get a little.
    """
    if len(lines):
        if painter.pen().capStyle() == Qt.PenCapStyle.RoundCap:
            still = np.flatnonzero((np.abs(lines[:, 2:] - lines[:, :2]) < SPECK).all(axis=1))
            if len(still):
                lines = lines.copy()
                lines[still, 2] += SPECK
        first: Any = Shiboken.wrapInstance(lines.ctypes.data, QLineF)
        painter.drawLines(first, len(lines))
