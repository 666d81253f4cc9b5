"""Where points of the plane fall in a raster: a value that maps them, and whole segments, into its cells."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.spline.joints import Segments

Floats = NDArray[np.float64]


class Raster(NamedTuple):
    """Columns and rows of cells over the plane; each array is (2, 1)."""

    corner: Floats
    """A point of the plane."""
    growth: Floats
    """Columns and rows per unit of x and of y."""
    place: Floats
    """Column and row where the corner falls."""

    def places(self, points: Floats) -> Floats:
        """Columns and rows of points, (2, n)."""
        return (points - self.corner) * self.growth + self.place

    def segments(self, segments: Segments) -> Segments:
        """Segments of which all points are where those of others fall."""
        return segments._replace(
            start=self.places(segments.start),
            end=self.places(segments.end),
            bend_start=segments.bend_start * self.growth,
            bend_end=segments.bend_end * self.growth,
        )


Along = Callable[[Raster], Iterable[NDArray[np.float32]]]
"""Tells where points along something fall in a raster, (2, n) at a time."""
