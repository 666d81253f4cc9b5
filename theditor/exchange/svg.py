"""Writing SVG: exact lines and ellipse arcs, cubic Béziers, y turned upward, and the drawing itself inside."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from html import escape
from typing import Final

import numpy as np
from numpy.typing import NDArray

from theditor.drawing import Drawing
from theditor.exchange.embedded import metadata
from theditor.exchange.options import DEFAULTS, PARTS, Options, Progress, Written
from theditor.exchange.scene import BLACK, COMB, LABEL, POINT, POLYGON, THIN, Scene, Stroke, scene
from theditor.spline import path_data

Floats = NDArray[np.float64]

_UPWARD: Final = (1.0, -1.0)
_UNFIT: Final = str.maketrans({"\ufffe": "\ufffd", "\uffff": "\ufffd"})  # letters that XML cannot hold


def write(drawing: Drawing, options: Options = DEFAULTS, progress: Progress | None = None) -> Written:
    """Draw the visible curves as SVG, each as one path, or in print style one for each run of a mode.

    Coordinates are those of the drawing, y negated, to the last digit; width and height are in millimetres.
    Whatever else is shown lies in groups with ids as in `PARTS`. The whole drawing rides along as metadata.
    """
    shown = scene(drawing, options, size=options.size, arcs=True, progress=progress)
    colour = BLACK if options.print_style else POLYGON
    picture = "".join(
        (*_comb(shown), *_polygons(shown, colour), *_curves(shown), *_points(shown, colour), *_labels(shown))
    )
    width, height = (shown.high - shown.low).tolist()
    across, down = shown.size
    text = (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{across!r}mm" height="{down!r}mm" '
        f'viewBox="{float(shown.low[0])!r} {-float(shown.high[1])!r} {width!r} {height!r}">\n'
        f"<desc>1 unit is {shown.unit!r} mm. In the drawing y runs upward.</desc>\n"
        f"{metadata(drawing, picture)}{picture}</svg>\n"
    )
    return Written(text.encode(), shown.deviation, shown.notes)


def _curves(shown: Scene) -> Iterator[str]:
    taken = {"curves", *PARTS}
    yield '<g id="curves" fill="none" stroke-linecap="round" stroke-linejoin="round">\n'
    for figure in shown.figures:
        name = _identity(figure.item.name, taken)
        title = f"<title>{escape(figure.item.name.translate(_UNFIT), quote=False)}</title>"
        width = shown.length(figure.width)
        look = f'stroke="{figure.color}" stroke-width="{width!r}"'
        if len(figure.strokes) == 1:
            yield f'<path id="{name}" {look}{_path(figure.strokes[0], shown)}>{title}</path>\n'
        else:
            paths = "".join(f"<path{_path(stroke, shown)}/>\n" for stroke in figure.strokes)
            yield f'<g id="{name}" {look}>{title}\n{paths}</g>\n'
    yield "</g>\n"


def _path(stroke: Stroke, shown: Scene) -> str:
    """Return the attributes of a stroke's path that are its own."""
    dashes = ",".join(repr(shown.length(dash)) for dash in stroke.dashes)
    dashed = f' stroke-dasharray="{dashes}" stroke-linecap="butt"' if dashes else ""
    return f'{dashed} d="{path_data(stroke.outline.scaled(_UPWARD))}"'


def _polygons(shown: Scene, colour: str) -> Iterator[str]:
    lines = [figure.polygon for figure in shown.figures if len(figure.polygon)]
    if lines:
        yield f'<g id="polygon" fill="none" stroke="{colour}" stroke-width="{shown.length(THIN)!r}">\n'
        yield from (f'<polyline points="{_pairs(line)}"/>\n' for line in lines)
        yield "</g>\n"


def _points(shown: Scene, colour: str) -> Iterator[str]:
    if any(len(figure.points) for figure in shown.figures):
        width, radius = shown.length(THIN), shown.length(POINT)
        yield f'<g id="points" fill="#ffffff" stroke="{colour}" stroke-width="{width!r}">\n'
        for figure in shown.figures:
            for x, y in (figure.points * _UPWARD).tolist():
                yield f'<circle cx="{x!r}" cy="{y!r}" r="{radius!r}"/>\n'
        yield "</g>\n"


def _labels(shown: Scene) -> Iterator[str]:
    if any(figure.labels for figure in shown.figures):
        # Letters smaller than a unit are drawn badly by some programs, so they are scaled down.
        scale = shown.length(LABEL) / 10
        yield f'<g id="labels" font-family="serif" font-size="10" text-anchor="middle" fill="{BLACK}">\n'
        for figure in shown.figures:
            for index, (x, y) in figure.labels.items():
                yield (
                    f'<text transform="translate({x!r} {-y!r}) scale({scale!r})" y="3">'
                    '<tspan font-style="italic">P</tspan>'
                    f'<tspan font-size="7" dy="2">{index}</tspan></text>\n'
                )
        yield "</g>\n"


def _comb(shown: Scene) -> Iterator[str]:
    if any(len(figure.teeth) for figure in shown.figures):
        width = shown.length(THIN / 2)
        yield f'<g id="comb" fill="none" stroke="{COMB}" stroke-width="{width!r}" stroke-opacity="0.6">\n'
        for figure in shown.figures:
            yield from (f'<polyline points="{_pairs(line)}"/>\n' for line in (*figure.teeth, *figure.crests))
        yield "</g>\n"


def _pairs(points: Floats) -> str:
    return " ".join(f"{x!r},{y!r}" for x, y in (points * _UPWARD).tolist())


def _identity(name: str, taken: set[str]) -> str:
    """Return an XML id like a curve's name that none has yet, and take it."""
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    stem = re.sub(r"[^A-Za-z0-9_.]+", "-", plain).strip("-.")
    if not re.match("[A-Za-z_]", stem):
        stem = f"curve-{stem}".rstrip("-")
    count, new = 1, stem
    while new in taken:
        count += 1
        new = f"{stem}-{count}"
    taken.add(new)
    return new
