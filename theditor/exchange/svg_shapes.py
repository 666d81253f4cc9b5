"""The basic shapes of SVG as contours."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Final

import numpy as np

from theditor.exchange.contour import Arc, Bezier, Contour, Piece, ellipse, polyline
from theditor.exchange.svg_style import length
from theditor.exchange.xml_tree import Node

_NUMBER: Final = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


class Measures:
    """The lengths of one element, in user units.

    Parameters
    ----------
    width, height
        What per cent are of.
    """

    def __init__(self, node: Node, width: float, height: float) -> None:
        self._attributes, self.width, self.height = node.attributes, width, height

    def x(self, name: str, default: str = "0") -> float:
        """Return a length along x."""
        return length(self._attributes.get(name, default), self.width)

    def y(self, name: str, default: str = "0") -> float:
        """Return a length along y."""
        return length(self._attributes.get(name, default), self.height)

    def r(self, name: str) -> float:
        """Return a length along neither."""
        return length(self._attributes.get(name, "0"), float(np.hypot(self.width, self.height) / np.sqrt(2)))

    def numbers(self, name: str) -> list[float]:
        """Return a list of numbers."""
        return [float(number) for number in _NUMBER.findall(self._attributes.get(name, ""))]

    def given(self, name: str) -> bool:
        """Whether there is such an attribute, and it is not left to the program."""
        return self._attributes.get(name, "auto").strip() != "auto"


def _rectangle(of: Measures) -> list[Contour]:
    left, top, width, height = of.x("x"), of.y("y"), of.x("width"), of.y("height")
    if width <= 0 or height <= 0:
        return []
    right, bottom = left + width, top + height
    across, down = (of.given(name) for name in ("rx", "ry"))
    a = of.x("rx") if across else of.y("ry") if down else 0.0
    b = of.y("ry") if down else a
    a, b = min(a, width / 2), min(b, height / 2)
    if a <= 0 or b <= 0:
        return [polyline([(left, top), (right, top), (right, bottom), (left, bottom)], closed=True)]
    arcs = [
        _quarter((right - a, top + b), (0, -b), (a, 0)),
        _quarter((right - a, bottom - b), (a, 0), (0, b)),
        _quarter((left + a, bottom - b), (0, b), (-a, 0)),
        _quarter((left + a, top + b), (-a, 0), (0, -b)),
    ]
    pieces: list[Piece] = []
    for before, arc in zip([arcs[-1], *arcs], arcs, strict=False):
        line = np.stack([before.centre + before.sine, arc.centre + arc.cosine])
        if np.abs(line[1] - line[0]).max() > 1e-12 * max(width, height):
            pieces.append(Bezier(line))
        pieces.append(arc)
    return [Contour(tuple(pieces), True)]


def _quarter(*vectors: tuple[float, float]) -> Arc:
    centre, cosine, sine = (np.array(vector, dtype=np.float64) for vector in vectors)
    return Arc(centre, cosine, sine, np.pi / 2)


def _circle(of: Measures) -> list[Contour]:
    r = of.r("r")
    return [ellipse(of.x("cx"), of.y("cy"), r, r)] if r > 0 else []


def _ellipse(of: Measures) -> list[Contour]:
    across, down = of.given("rx"), of.given("ry")
    a = of.x("rx") if across else of.y("ry")
    b = of.y("ry") if down else a
    return [ellipse(of.x("cx"), of.y("cy"), a, b)] if a > 0 and b > 0 else []


def _line(of: Measures) -> list[Contour]:
    return _polyline([of.x("x1"), of.y("y1"), of.x("x2"), of.y("y2")], closed=False)


def _polyline(numbers: list[float], closed: bool) -> list[Contour]:
    points = np.reshape(numbers[: len(numbers) // 2 * 2], (-1, 2))
    contour = polyline(points, closed) if len(points) else None
    return [contour] if contour is not None and contour.pieces else []


SHAPES: Final[dict[str, Callable[[Measures], list[Contour]]]] = {
    "rect": _rectangle,
    "circle": _circle,
    "ellipse": _ellipse,
    "line": _line,
    "polyline": lambda of: _polyline(of.numbers("points"), closed=False),
    "polygon": lambda of: _polyline(of.numbers("points"), closed=True),
}
"""Contours by the name of the element; each raises a ValueError where something is no length."""
