"""Writing TikZ: a picture for papers that compiles by itself, or is input into one with package `standalone`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np
from numpy.typing import NDArray

from theditor.drawing import Drawing, DrawingError
from theditor.exchange.options import DEFAULTS, PAGE, Options, Progress, Written
from theditor.exchange.scene import BLACK, COMB, POINT, POLYGON, THIN, Figure, Scene, Stroke, scene
from theditor.spline import Outline, Piece

Floats = NDArray[np.float64]

_LARGEST: Final = 5000.0  # TeX has no lengths of more than some 5.7 m
_ROUNDING: Final = 0.75e-6  # mm, of numbers with 6 decimals; TeX keeps fewer


def write(drawing: Drawing, options: Options = DEFAULTS, progress: Progress | None = None) -> Written:
    r"""Draw the visible curves as one `tikzpicture` in a document of class `standalone`.

    Coordinates are millimetres from the lower left corner. Curves are lines and cubic Béziers; labels are set
    as ``$P_{i}$``.

    Raises
    ------
    DrawingError
        If the picture is larger than TeX can measure.
    """
    shown = scene(drawing, options, size=options.size or PAGE, arcs=False, progress=progress)
    if max(shown.size) > _LARGEST:
        raise DrawingError(f"TeX cannot draw pictures longer than {_LARGEST:g} mm: ask for a smaller size.")
    width, height = shown.size
    colour = BLACK if options.print_style else POLYGON
    lines = [
        r"\documentclass[tikz]{standalone}",
        r"\begin{document}",
        r"\begin{tikzpicture}[x=1mm, y=1mm, line cap=round, line join=round]",
        f"\\definecolor{{polygon}}{{HTML}}{{{colour[1:]}}}",
        f"\\definecolor{{comb}}{{HTML}}{{{COMB[1:]}}}",
        f"\\useasboundingbox (0,0) rectangle ({width:.6f},{height:.6f});",
        *(line for figure in shown.figures for line in _behind(figure, shown)),
        *(line for number, figure in enumerate(shown.figures, 1) for line in _curve(number, figure, shown)),
        *(line for figure in shown.figures for line in _points(figure, shown)),
        r"\end{tikzpicture}",
        r"\end{document}",
    ]
    text = "\n".join(lines) + "\n"
    deviation = shown.deviation + (_ROUNDING / shown.unit if shown.figures else 0.0)
    return Written(text.encode(), deviation, shown.notes)


def _curve(number: int, figure: Figure, shown: Scene) -> Iterator[str]:
    yield f"% {figure.item.name}"
    yield f"\\definecolor{{curve{number}}}{{HTML}}{{{figure.color[1:].upper()}}}"
    for stroke in figure.strokes:
        yield f"\\draw[curve{number}, line width={figure.width:.4g}mm{_dashed(stroke)}]"
        yield from _path(stroke.outline, shown)


def _dashed(stroke: Stroke) -> str:
    if not stroke.dashes:
        return ""
    pattern = " ".join(f"{'off' if i % 2 else 'on'} {length:g}mm" for i, length in enumerate(stroke.dashes))
    return f", line cap=butt, dash pattern={pattern}"


def _path(pieces: Outline, shown: Scene) -> Iterator[str]:
    """Yield a path a piece a line."""
    placed = pieces.scaled(shown.unit, -shown.low * shown.unit)
    ends = placed.ends.tolist()
    yield f"  {_at(ends[0])}"
    for kind, end, (first, second) in zip(
        placed.kinds.tolist(), ends[1:], placed.inner.tolist(), strict=True
    ):
        if kind == Piece.LINE:
            yield f"  -- {_at(end)}"
        else:
            yield f"  .. controls {_at(first)} and {_at(second)} .. {_at(end)}"
    yield "  -- cycle;" if pieces.closed else "  ;"


def _behind(figure: Figure, shown: Scene) -> Iterator[str]:
    lines = [*figure.teeth, *figure.crests]
    if lines:
        yield f"\\draw[comb, opacity=0.6, line width={THIN / 2:g}mm]"
        yield from (f"  {_chain(line, shown)}" for line in lines)
        yield "  ;"
    if len(figure.polygon):
        yield f"\\draw[polygon, line width={THIN:g}mm] {_chain(figure.polygon, shown)};"


def _points(figure: Figure, shown: Scene) -> Iterator[str]:
    for point in _placed(figure.points, shown):
        yield f"\\filldraw[fill=white, draw=polygon, line width={THIN:g}mm] {_at(point)} circle[radius={POINT:g}];"
    for index, place in figure.labels.items():
        (point,) = _placed(np.array([place]), shown)
        yield f"\\node[inner sep=0pt] at {_at(point)} {{$P_{{{index}}}$}};"


def _chain(points: Floats, shown: Scene) -> str:
    return " -- ".join(map(_at, _placed(points, shown)))


def _placed(points: Floats, shown: Scene) -> list[list[float]]:
    placed: list[list[float]] = ((points - shown.low) * shown.unit).tolist()
    return placed


def _at(point: list[float]) -> str:
    return f"({point[0]:.6f},{point[1]:.6f})"
