"""Where the plane is on the screen: a value that maps points to pixels and back."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]


Area = tuple[float, float, float, float]
"""A rectangle in pixels: left, top, width and height."""

WHOLE, ROUNDING = 1e-4, 1e-12
"""A shift this near to whole pixels, and scales whose ratio is this near to 1, differ by rounding only."""


def inside(points: Floats, low: Floats, high: Floats) -> NDArray[np.intp]:
    """Which points (n, 2) lie between two corners (2,), ascending."""
    x, y = points.T
    return np.flatnonzero((x >= low[0]) & (x <= high[0]) & (y >= low[1]) & (y <= high[1]))


class Viewport(NamedTuple):
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
        pixels: Floats = lines - (self.x, self.y) * 2
        pixels *= (self.scale, -self.scale) * 2
        pixels += (self.width / 2, self.height / 2) * 2
        return pixels

    def to_points(self, pixels: ArrayLike) -> Floats:
        """Inverse of `to_pixels`."""
        away = np.asarray(pixels, dtype=np.float64) - (self.width / 2, self.height / 2)
        return away / (self.scale, -self.scale) + (self.x, self.y)

    def shift_to(self, other: Viewport, ratio: float = 1.0) -> tuple[int, int] | None:
        """By how many whole device pixels, `ratio` in each pixel, the picture moves when another part is shown.

        None if it does more than that.
        """
        same_size = (self.width, self.height) == (other.width, other.height)
        if not same_size or abs(other.scale / self.scale - 1) > ROUNDING:
            return None
        exact = (other.to_pixels((self.x, self.y)) - self.to_pixels((self.x, self.y))) * ratio
        whole = np.round(exact)
        if np.abs(exact - whole).max() > WHOLE or np.abs(whole).max() > 1e6:
            return None
        return int(whole[0]), int(whole[1])

    def window(self, margin: float = 0.0, area: Area | None = None) -> tuple[Floats, Floats]:
        """Lowest and highest point visible, or visible in an area, `margin` pixels beyond the edge included."""
        left, top, width, height = area or (0.0, 0.0, self.width, self.height)
        x0, y1 = self.to_points((left - margin, top - margin)).tolist()
        x1, y0 = self.to_points((left + width + margin, top + height + margin)).tolist()
        return np.array([x0, y0]), np.array([x1, y1])
