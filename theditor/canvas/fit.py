"""Which view shows a whole drawing."""

from __future__ import annotations

import numpy as np

from theditor.canvas.projection import projected
from theditor.canvas.viewport import Floats
from theditor.drawing import Drawing
from theditor.spline.extent import extent as extent_of

MARGIN = 1 / 12
"""Share of the canvas that stays free on each side."""
LEAST = (32.0, 64.0, 32.0, 48.0)
"""Pixels that stay free at least: left, top (legend, labels), right, bottom (labels, the grid's numbers)."""


def extent(drawing: Drawing, *, polygons: bool = True) -> tuple[Floats, Floats]:
    """Lowest and highest point of the visible curves and their control points; a square if there are none."""
    parts = []
    for item in drawing:
        if item.visible:
            curve = projected(item.curve)
            parts += [curve.sample(4), curve.control_points] if polygons else [curve.sample(4)]
    if not parts:
        return np.array([-1.0, -1.0]), np.array([1.0, 1.0])
    lows, highs = zip(*map(extent_of, parts), strict=True)
    return np.min(lows, axis=0), np.max(highs, axis=0)


def fitted(drawing: Drawing, width: float, height: float) -> tuple[float, float, float]:
    """The middle and the scale (pixels per unit) at which a canvas of `width` by `height` pixels shows it all."""
    low, high = extent(drawing)
    left, top, right, bottom = np.maximum(LEAST, MARGIN * np.array([width, height, width, height]))
    room = np.maximum([width - left - right, height - top - bottom], 16.0)
    size = np.maximum(high - low, 1e-9 * np.maximum(1.0, np.abs(high)))
    scale = float(np.min(room / size))
    x, y = ((low + high) / 2 + np.array([right - left, top - bottom]) / 2 / scale).tolist()
    return x, y, scale
