"""Views of the drawing: what is selected, and where each file was looked at last."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
from PySide6.QtCore import QSettings

from theditor.canvas import Canvas
from theditor.canvas.held import Held
from theditor.canvas.projection import projected
from theditor.model import Selection
from theditor.spline.extent import extent

MOST = 100
"""How many files are remembered."""
SHARE = 0.7
"""Share of the canvas that a selection is to fill."""
_SAMPLES = 16
_TINY = 24.0  # pixels


def zoom_to_selection(canvas: Canvas, selection: Selection) -> None:
    """Show the selected control points and segments as large as they go; the selected curves if there are none.

    A single point comes to the middle, at the same scale.
    """
    if selection.item is None:
        return
    curve = projected(selection.item.curve)
    shown = [Held(selection.drawing, selection.across).places]
    if selection.segments:
        t = np.linspace(0.0, 1.0, _SAMPLES)
        shown.append(curve((np.array(sorted(selection.segments))[:, None] + t).ravel()))
    elif not selection.count:
        for curve in (projected(selection.drawing[i].curve) for i in selection.curves):
            shown += [curve.control_points, curve.sample(_SAMPLES)]
    points = np.concatenate(shown)
    low, high = extent(points)
    plane, size = canvas.plane, high - low
    room = SHARE * np.array([plane.width, plane.height])
    scales = room[size > 0] / size[size > 0]
    x, y = ((low + high) / 2).tolist()
    canvas.show_view(x, y, float(scales.min()) if scales.size else plane.scale)


def show_added(canvas: Canvas, selection: Selection) -> None:
    """Show the selected curves, which are new: the whole drawing if they are not in view, and closer if tiny."""

    def look() -> tuple[bool, float]:
        plane = canvas.plane
        points = [projected(selection.drawing[i].curve).control_points for i in selection.curves]
        low, high = extent(plane.to_pixels(np.concatenate(points)))
        inside = (low >= 0).all() and (high <= (plane.width, plane.height)).all()
        return bool(inside), float((high - low).max())

    if not look()[0]:
        canvas.fit()
    if look()[1] < _TINY:
        zoom_to_selection(canvas, selection)


def keep_view(path: Path | None, canvas: Canvas) -> None:
    """Keep for the next time how a file is looked at; a fitted view will be fitted again."""
    if path is None:
        return
    views, name, plane = _views(), str(path.absolute()), canvas.plane
    views.pop(name, None)
    if not canvas.fitted:
        views[name] = [plane.x, plane.y, plane.scale]
    QSettings().setValue("views", json.dumps(dict(list(views.items())[-MOST:])))


def show_kept_view(path: Path | None, canvas: Canvas) -> None:
    """Look at a file as it was looked at last, else at all of it."""
    match path and _views().get(str(path.absolute())):
        case [float(x), float(y), float(scale)] if scale > 0 and all(map(math.isfinite, (x, y, scale))):
            canvas.show_view(x, y, scale)
        case _:
            canvas.fit()


def _views() -> dict[str, object]:
    """Middle and scale of the view of each file, that of the latest last."""
    try:
        views = json.loads(str(QSettings().value("views", "{}")))
    except ValueError:
        return {}
    return views if isinstance(views, dict) else {}
