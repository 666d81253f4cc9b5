"""Writing DXF: ellipse arcs and a quadratic's hyperbola arcs exactly, the rest as cubic splines; in space, too."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import groupby
from typing import Any, Final

import numpy as np
from ezdxf._options import options as settings
from ezdxf.document import Drawing as Document
from ezdxf.filemanagement import new
from ezdxf.layouts.layout import Modelspace
from ezdxf.lldxf import const
from numpy.typing import NDArray

from theditor.drawing import Drawing, Item
from theditor.exchange.options import DEFAULTS, Options, Progress, Written, watched
from theditor.exchange.scene import COLLECTED, MEASURED, MM_PER_PIXEL, box, remarks, visible
from theditor.spline import Outline, Piece, outline

Floats = NDArray[np.float64]

_VERSION: Final = "R2010"  # the oldest in UTF-8 with colours as they are
_MILLIMETRES: Final = 4
_FORBIDDEN: Final = re.compile(r"""[<>/\\":;?*|=`,]""")
_LEAST_AXIS: Final = 2e-12  # shorter ones are none to the library
_EXACT: Final = 1e-9  # of the drawing's size, which counts as exact
_SAME: Final = 1e-12  # relative difference of ellipses that are one


def write(drawing: Drawing, options: Options = DEFAULTS, progress: Progress | None = None) -> Written:
    """Write the visible curves, each on a layer of its name and colour, one unit as one millimetre.

    Straight segments become lines and polylines, elliptical arcs ellipses, a quadratic's hyperbola arcs
    rational quadratic splines, all exact; runs of anything else, a cubic's hyperbola arcs among them, cubic
    splines with clamped knots. z is kept. The same drawing gives the same bytes.
    """
    with _unmarked():
        document = new(_VERSION, units=_MILLIMETRES)
        deviation = _add_curves(document, visible(drawing), options.tolerance, progress)
        stream = io.StringIO(newline="")
        document.write(stream)
    return Written(stream.getvalue().encode(), deviation, ("1 unit is 1 mm.", *remarks(drawing, plane=False)))


def _add_curves(
    document: Document, curves: Sequence[Item], tolerance: float, progress: Progress | None
) -> float:
    """Add curves, each with its layer, and return the largest deviation."""
    *_, size = box([item.curve for item in curves], progress)
    deviation = 0.0
    taken = {"", "0", "defpoints"}
    for item in watched(curves, progress, MEASURED, COLLECTED):
        layer = document.layers.add(_layer_name(item.name, taken))
        layer.rgb = tuple(bytes.fromhex(item.color[1:]))  # type: ignore[assignment]
        hundredths = 100 * MM_PER_PIXEL * item.width
        layer.dxf.lineweight = min(const.VALID_DXF_LINEWEIGHTS, key=lambda each: abs(each - hundredths))
        arcs = size * _EXACT >= _LEAST_AXIS
        pieces = outline(item.curve, tolerance * size, arcs=arcs, conics=True)
        deviation = max(deviation, pieces.deviation)
        _draw(pieces, document.modelspace(), {"layer": layer.dxf.name})
    return deviation


def _draw(pieces: Outline, space: Modelspace, look: dict[str, Any]) -> None:
    """Add an outline's runs of one kind to the drawing."""
    position = 0
    ends = np.pad(pieces.ends, ((0, 0), (0, 3 - pieces.ends.shape[1])))
    inner = np.pad(pieces.inner, ((0, 0), (0, 0), (0, 3 - pieces.ends.shape[1])))
    for kind, run in groupby(pieces.kinds.tolist()):
        here = slice(position, position + sum(1 for _ in run))
        position = here.stop
        corners = ends[here.start : here.stop + 1]
        if kind == Piece.LINE:
            _add_lines(space, corners, look)
        elif kind == Piece.ARC:
            for centre, start, end, quarters in _ellipses(corners, inner[here, 0]):
                _add_ellipse(space, centre, start, end, quarters, look)
        else:
            between = inner[here] if kind == Piece.CUBIC else inner[here, :1]
            weights = None if kind == Piece.CUBIC else pieces.weights[here]
            _add_spline(space, corners, between, weights, look)


def _add_lines(space: Modelspace, corners: Floats, look: dict[str, Any]) -> None:
    if len(corners) == 2:
        if (corners[0] != corners[1]).any():
            space.add_line(corners[0], corners[1], look)
        else:
            space.add_point(corners[0], look)
        return
    closed = len(corners) > 3 and bool((corners[0] == corners[-1]).all())
    corners = corners[:-1] if closed else corners
    if (corners[:, 2] == corners[0, 2]).all():
        line = space.add_lwpolyline(corners[:, :2].tolist(), close=closed, dxfattribs=look)
        line.dxf.elevation = float(corners[0, 2])
    else:
        space.add_polyline3d(corners.tolist(), close=closed, dxfattribs=look)


def _ellipses(ends: Floats, centres: Floats) -> Iterator[tuple[Floats, Floats, Floats, int]]:
    """Yield centre, first and second conjugate radius, and number of quarters of each ellipse in a row of arcs."""
    first, second = ends[:-1] - centres, ends[1:] - centres
    size = np.abs(first).max(axis=1) + np.abs(second).max(axis=1)
    slack = _SAME * size + 8 * np.finfo(float).eps * np.abs(centres).max(axis=1)
    moved = np.abs(centres[1:] - centres[:-1]).max(axis=1) + np.abs(second[1:] + first[:-1]).max(axis=1)
    onward = np.append(False, moved <= slack[1:]).tolist()
    start, count = 0, len(onward)
    while start < count:
        stop = start + 1
        while stop < min(count, start + 4) and onward[stop]:
            stop += 1
        yield centres[start], first[start], second[start], stop - start
        start = stop


def _add_ellipse(
    space: Modelspace, centre: Floats, first: Floats, second: Floats, quarters: int, look: dict[str, Any]
) -> None:
    turn = [first, second, -first, -second]
    last, before_last = turn[quarters % 4], turn[(quarters - 1) % 4]
    normal = np.cross(first, second)
    if tuple(normal[::-1]) < (0, 0, 0):
        # Run through backwards it turns to the left as seen from above, which more programs draw well.
        first, second, last = last, before_last, first
        normal = -normal
    square = float(first @ first), float(second @ second)
    angle = np.arctan2(2 * float(first @ second), square[0] - square[1]) / 2
    major = first * np.cos(angle) + second * np.sin(angle)
    minor = second * np.cos(angle) - first * np.sin(angle)
    if float(np.abs(major).max()) < _LEAST_AXIS:
        _add_lines(space, centre + np.stack((first, last)), look)
        return
    ratio = min(1.0, float(np.linalg.norm(minor) / np.linalg.norm(major)))
    start = float(-angle % (2 * np.pi)) if quarters < 4 else 0.0
    end = start + quarters * np.pi / 2 if quarters < 4 else 2 * np.pi
    ellipse = space.add_ellipse(centre, major, ratio, start, end, look)
    if normal[:2].any():
        ellipse.dxf.extrusion = normal / np.linalg.norm(normal)


def _add_spline(
    space: Modelspace, ends: Floats, inner: Floats, weights: Floats | None, look: dict[str, Any]
) -> None:
    """Add Béziers in a row as one spline, its knots as often as its degree."""
    count, handles, _ = inner.shape
    degree = handles + 1
    spline = space.add_spline(degree=degree, dxfattribs=look)
    controls = np.concatenate((ends[:-1, None], inner), axis=1).reshape(-1, 3)
    spline.control_points = np.vstack((controls, ends[-1:])).tolist()
    spline.knots = [0.0, *np.repeat(np.arange(count + 1.0), degree).tolist(), float(count)]
    if weights is not None:
        spline.set_flag_state(spline.RATIONAL)
        spline.weights = [*np.stack((np.ones(count), weights), axis=1).ravel().tolist(), 1.0]


def _layer_name(name: str, taken: set[str]) -> str:
    """Return a layer name like a curve's name that none has yet, and take it; letter case does not count."""
    stem = _FORBIDDEN.sub("-", name).strip() or "Curve"
    count, new = 1, stem
    while new.lower() in taken:
        count += 1
        new = f"{stem} {count}"
    taken.add(new.lower())
    return new


@contextmanager
def _unmarked() -> Iterator[None]:
    """Keep the time and random numbers out of the file, with which it would be marked."""
    before = settings.write_fixed_meta_data_for_testing
    settings.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        settings.write_fixed_meta_data_for_testing = before
