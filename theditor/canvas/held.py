"""Control points of one or several curves as one set: where they are, and the drawing with them elsewhere."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.projection import projected
from theditor.canvas.viewport import Viewport, inside
from theditor.drawing import Drawing
from theditor.spline import MAX_COORDINATE, Curve

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]


class Held:
    """Control points of some curves of a drawing, by the curve's index; as one set they are numbered in that order."""

    def __init__(self, drawing: Drawing, points: Mapping[int, Ints]) -> None:
        self._drawing, self._points = drawing, points
        self._starts = np.cumsum([0, *(len(of) for of in points.values())])

    @cached_property
    def places(self) -> Floats:
        """Where they are in the plane of the canvas, (n, 2)."""
        parts = [projected(self._drawing[i].curve).control_points[of] for i, of in self._points.items()]
        return np.concatenate(parts) if parts else np.empty((0, 2))

    def at(self, places: Floats) -> Drawing:
        """The drawing with them at other places (n, 2), within what coordinates may be."""
        places = places.clip(-MAX_COORDINATE, MAX_COORDINATE)
        curves: dict[int, Curve] = {}
        for (i, of), start in zip(self._points.items(), self._starts.tolist(), strict=False):
            curve = self._drawing[i].curve
            points = curve.control_points[of]
            points[:, :2] = places[start : start + len(of)]
            curves[i] = curve.with_points(of, points)
        return self._drawing.with_curves(curves)

    def near(self, at: Floats, reach: float, plane: Viewport) -> dict[int, Ints]:
        """Those within a square around a pixel (2,), by their curve."""
        middle, away = plane.to_points(at), reach / plane.scale
        return self.by_curve(inside(self.places, middle - away, middle + away))

    def numbers(self, points: Mapping[int, Ints]) -> Ints:
        """The numbers of those of some control points that are in the set, which then holds all of their curves."""
        starts = dict(zip(self._points, self._starts.tolist(), strict=False))
        parts = [of + starts[i] for i, of in points.items() if i in starts]
        return np.concatenate(parts) if parts else np.empty(0, dtype=np.intp)

    def by_curve(self, numbers: Ints) -> dict[int, Ints]:
        """The control points with some numbers, ascending, by their curve."""
        curves = list(self._points)
        owners = np.searchsorted(self._starts, numbers, side="right") - 1
        if not len(numbers):
            return {}
        cuts = np.flatnonzero(np.diff(owners)) + 1
        heads = owners[np.append(0, cuts)].tolist()
        return {
            curves[k]: part - self._starts[k] for k, part in zip(heads, np.split(numbers, cuts), strict=True)
        }


def every_point(drawing: Drawing, curves: Iterable[int] | None = None) -> dict[int, Ints]:
    """All control points of some curves (default all), but for hidden and locked ones, which nobody may move."""
    chosen = range(len(drawing)) if curves is None else curves
    return {
        i: np.arange(len(drawing[i].curve.control_points))
        for i in chosen
        if drawing[i].visible and not drawing[i].locked
    }
