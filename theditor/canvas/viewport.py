"""Where the plane is on the screen: a value that maps points to pixels and back."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]


def inside(points: Floats, low: Floats, high: Floats) -> NDArray[np.intp]:
    """Which points (n, 2) lie between two corners (2,), ascending."""
    x, y = points.T
    return np.flatnonzero((x >= low[0]) & (x <= high[0]) & (y >= low[1]) & (y <= high[1]))


@dataclass(frozen=True)
class Viewport:
    """The visible part of the plane, y upward, with the same scale on both axes.

    Attributes
    ----------
    x, y
        The point in the middle.
    scale
        Pixels per unit.
    width, height
        Size in pixels.
    """

    x: float
    y: float
    scale: float
    width: float
    height: float

    def to_pixels(self, points: ArrayLike) -> Floats:
        """Pixels (…, 2), y downward from the top left corner, of points (…, 2)."""
        pixels: Floats = (np.asarray(points, dtype=np.float64) - (self.x, self.y)) * (self.scale, -self.scale)
        pixels += (self.width / 2, self.height / 2)
        return pixels

    def lines_to_pixels(self, lines: Floats) -> Floats:
        """Pixels of the starts and ends of lines (n, 4)."""
        pixels: Floats = (lines - (self.x, self.y) * 2) * ((self.scale, -self.scale) * 2)
        pixels += (self.width / 2, self.height / 2) * 2
        return pixels

    def to_points(self, pixels: ArrayLike) -> Floats:
        """Inverse of `to_pixels`."""
        away = np.asarray(pixels, dtype=np.float64) - (self.width / 2, self.height / 2)
        return away / (self.scale, -self.scale) + (self.x, self.y)

    def window(self, margin: float = 0.0) -> tuple[Floats, Floats]:
        """Lowest and highest visible point, `margin` pixels beyond the edge included."""
        half = np.array([self.width / 2 + margin, self.height / 2 + margin]) / self.scale
        middle = np.array([self.x, self.y])
        return middle - half, middle + half
