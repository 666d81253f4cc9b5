"""Where the elements of an SVG picture lie: transforms, views within views, and how they look there."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import svgelements

from theditor.exchange.contour import Floats
from theditor.exchange.svg_shapes import Measures
from theditor.exchange.svg_style import Look, length
from theditor.exchange.xml_tree import Node


class FaultError(Exception):
    """Something in an element's attributes cannot be read; the element is left out."""


class Place(NamedTuple):
    """Where and how elements are drawn."""

    matrix: Floats
    look: Look
    width: float
    height: float
    depth: int
    uses: tuple[str, ...] = ()


def within_view(node: Node, place: Place) -> Place:
    """Return the place within an inner svg or a symbol, which has a view of its own."""
    of = Measures(node, place.width, place.height)
    try:
        x, y = of.x("x"), of.y("y")
        width, height = of.x("width", "100%"), of.y("height", "100%")
    except ValueError as error:
        raise FaultError(str(error)) from None
    box = viewbox(node)
    if box is None or width <= 0 or height <= 0:
        shift = np.array([[1.0, 0, x], [0, 1.0, y]])
        return place._replace(matrix=then(place.matrix, shift), width=width, height=height)
    left, top, across, down = box
    fit = node.attributes.get("preserveAspectRatio", "xMidYMid meet").split() or ["xMidYMid"]
    scale = np.array([width / across, height / down])
    room = np.zeros(2)
    if fit[0] != "none":
        scale[:] = scale.max() if "slice" in fit else scale.min()
        room = np.array([width, height]) - scale * (across, down)
        room *= [{"Min": 0.0, "Max": 1.0}.get(fit[0][i : i + 3], 0.5) for i in (1, 5)]
    offset = np.array([x, y]) + room - scale * (left, top)
    inner = np.column_stack([np.diag(scale), offset])
    return place._replace(matrix=then(place.matrix, inner), width=across, height=down)


def viewbox(node: Node) -> tuple[float, float, float, float] | None:
    """Return left, top, width and height of the view that an element gives to those within, if it does."""
    numbers = node.attributes.get("viewBox", "").replace(",", " ").split()
    try:
        left, top, width, height = (length(number) for number in numbers)
    except ValueError:
        return None
    return (left, top, width, height) if 0 < width < np.inf and 0 < height < np.inf else None


def outer_size(root: Node) -> tuple[float, float] | None:
    """Return width and height of the picture in pixels, if it has any."""
    try:
        sizes = [length(root.attributes[name], np.nan) for name in ("width", "height")]
    except (KeyError, ValueError):
        return None
    return (sizes[0], sizes[1]) if all(0 < one < np.inf for one in sizes) else None


def transform(node: Node) -> Floats:
    """Return the affine map of an element's own transform, (2, 3)."""
    text = node.attributes.get("transform", "")
    if not text:
        return np.eye(2, 3)
    try:
        matrix = svgelements.Matrix(text)
        found = np.array([[matrix.a, matrix.c, matrix.e], [matrix.b, matrix.d, matrix.f]], dtype=np.float64)
    except (ValueError, TypeError, IndexError, AttributeError, ArithmeticError):
        raise FaultError(f"the transform {text[:40]!a} cannot be read") from None
    if not np.isfinite(found).all():
        raise FaultError(f"the transform {text[:40]!a} is not finite")
    return found


def then(outer: Floats, inner: Floats) -> Floats:
    """Return the affine map that does the inner one first."""
    with np.errstate(all="ignore"):
        linear = outer[:, :2] @ inner[:, :2]
        return np.column_stack([linear, outer[:, :2] @ inner[:, 2] + outer[:, 2]])
