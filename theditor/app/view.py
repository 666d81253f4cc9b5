"""Views of the drawing: what is selected, and where each file was looked at last."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QSettings

from theditor.canvas import Canvas
from theditor.canvas.held import Held
from theditor.canvas.projection import projected
from theditor.drawing import Item
from theditor.model import Selection
from theditor.spline.extent import extent

Floats = NDArray[np.float64]

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


def drawn_box(items: Iterable[Item]) -> tuple[Floats, Floats]:
    """Return the lowest and the highest corner, (2,) each, of some curves as drawn, without their control points."""
    return extent(np.concatenate([projected(item.curve).sample(_SAMPLES) for item in items]))


def all_in_view(canvas: Canvas, selection: Selection) -> bool:
    """Whether the selected curves, as drawn, lie in the canvas from end to end."""
    plane = canvas.plane
    low, high = extent(_drawn_pixels(canvas, selection))
    return bool((low >= 0).all() and (high <= (plane.width, plane.height)).all())


def show_added(canvas: Canvas, selection: Selection) -> None:
    """Show the selected curves, which are new: the whole drawing if they are not in view, and closer if tiny."""
    if not all_in_view(canvas, selection):
        canvas.fit()
    if float(np.ptp(_drawn_pixels(canvas, selection), axis=0).max()) < _TINY:
        zoom_to_selection(canvas, selection)


def _drawn_pixels(canvas: Canvas, selection: Selection) -> Floats:
    """Return the corners, (2, 2), of the selected curves as drawn."""
    box = drawn_box(selection.drawing[i] for i in selection.curves)
    return canvas.plane.to_pixels(np.stack(box))


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
