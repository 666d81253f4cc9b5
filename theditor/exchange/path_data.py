"""The path data of SVG, such as ``M0 0 C1 1 2 1 3 0 Z``, as contours."""

from __future__ import annotations

import re
from typing import Any, Final, NamedTuple

import numpy as np
import svgelements

from theditor.exchange.contour import Arc, Bezier, Contour, Floats, Piece

LONGEST: Final = 16 * 2**20
"""Characters of the longest path data that is read."""

_START: Final = re.compile(r"\s*[Mm][\s,]*[-+.\d]")


class PathData(NamedTuple):
    """What path data draws, and where it cannot be read on."""

    contours: tuple[Contour, ...]
    fault: int | None  # number of a character from 1, None if all is well


def is_path_data(text: str) -> bool:
    """Whether a text looks like path data: it begins with M and a number."""
    return _START.match(text) is not None


def contours(text: str) -> PathData:
    """Return the contours of path data; as SVG demands, what comes before a fault counts.

    Coordinates are those of the text, and may be infinite.
    """
    path, parser = svgelements.Path(), svgelements.svgelements.SVGLexicalParser()
    fault: int | None = None
    text = text[:LONGEST].rstrip()
    try:
        if _START.match(text):
            parser.parse(path, text)
        if parser.pos < len(text):
            fault = parser.pos + 1
    except (ValueError, TypeError, AttributeError, IndexError, ArithmeticError):
        fault = parser.pos + 1
    with np.errstate(all="ignore"):
        return PathData(tuple(_contours(path)), fault)


def _contours(path: Any) -> list[Contour]:
    found: list[Contour] = []
    pieces: list[Piece] = []

    def finish(closed: bool) -> None:
        if pieces:
            found.append(Contour(tuple(pieces), closed))
            pieces.clear()

    for part in path:
        match part:
            case svgelements.Move():
                finish(False)
            case svgelements.Close():
                pieces.extend(_line(part))
                finish(True)
            case svgelements.Line():
                pieces.extend(_line(part))
            case svgelements.QuadraticBezier():
                pieces.extend(_bezier(part.start, part.control, part.end))
            case svgelements.CubicBezier():
                pieces.extend(_bezier(part.start, part.control1, part.control2, part.end))
            case svgelements.Arc():
                pieces.extend(_arc(part))
    finish(False)
    return [_closed_if_round(contour) for contour in found]


def _line(part: Any) -> list[Piece]:
    return _bezier(part.start, part.end)


def _bezier(*points: Any) -> list[Piece]:
    if any(point is None for point in points):
        return []
    corners = np.array([(point.x, point.y) for point in points], dtype=np.float64)
    return [Bezier(corners)] if (corners != corners[0]).any() else []


def _arc(part: Any) -> list[Piece]:
    """Return an arc with its own start as the first of its conjugate semi-axes; one without radius is a line."""
    centre, start, first, second = (
        np.array((point.x, point.y)) for point in (part.center, part.start, part.prx, part.pry)
    )
    axes = np.stack([first - centre, second - centre], axis=1)
    if not part.sweep or not np.isfinite(axes).all() or np.linalg.det(axes) == 0:
        return _line(part)
    cosine = start - centre
    along, across = np.linalg.solve(axes, cosine)
    sine: Floats = np.sign(part.sweep) * (axes @ (-across, along))
    return [Arc(centre, cosine, sine, abs(float(part.sweep)))]


def _closed_if_round(contour: Contour) -> Contour:
    """Return a contour as closed if it ends where it began, up to rounding."""
    ends = contour.pieces[0].ends[0], contour.pieces[-1].ends[1]
    room = 1e-12 * max(float(np.abs(piece.ends).max()) for piece in contour.pieces)
    if len(contour.pieces) > 1 and bool((np.abs(ends[0] - ends[1]) <= room).all()):
        return contour._replace(closed=True)
    return contour
