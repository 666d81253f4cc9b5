"""Drawing ↔ JSON: strict when reading, one fixed layout when writing.

The file is meant to be read and compared line by line: one control point and one λ per line, the keys always
in the same order, every number the shortest decimal that reads back as the same float.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta, Struct, field

from theditor.drawing.drawing import (
    DEFAULT_COLOR,
    DEFAULT_NAME,
    DEFAULT_WIDTH,
    NAME_LENGTH,
    WIDTH_RANGE,
    Drawing,
    DrawingError,
    Item,
)
from theditor.spline import MAX_COORDINATE, MAX_LAMBDA, Curve, fewest_points

FORMAT = "theditor"
VERSION = 1

_Coordinate = Annotated[float, Meta(ge=-MAX_COORDINATE, le=MAX_COORDINATE)]
_Lambda = Annotated[float, Meta(ge=-MAX_LAMBDA, le=MAX_LAMBDA)]


class _Style(Struct, forbid_unknown_fields=True):
    color: Annotated[str, Meta(pattern="^#[0-9A-Fa-f]{6}$")] = DEFAULT_COLOR
    width: Annotated[float, Meta(ge=WIDTH_RANGE[0], le=WIDTH_RANGE[1])] = DEFAULT_WIDTH


class _Curve(Struct, forbid_unknown_fields=True):
    points: list[Annotated[list[_Coordinate], Meta(min_length=2, max_length=3)]]
    lambdas: list[_Lambda] = field(name="lambda")
    degree: Literal[2, 3]
    closed: bool
    name: Annotated[str, Meta(max_length=NAME_LENGTH)] = DEFAULT_NAME
    ends: Literal["free", "clamped"] = "free"
    style: _Style = field(default_factory=_Style)
    visible: bool = True
    locked: bool = False


class _File(Struct, forbid_unknown_fields=True):
    format: Literal["theditor"]
    version: Literal[1]
    curves: list[_Curve]


class _Header(Struct):
    """What every version of the file has; read first, so that a newer file is refused by its number."""

    format: Any = None
    version: Any = None


# What belongs at each place, for the reader of a message; list positions are left out.
_EXPECTED = {
    "": "an object with format, version and curves",
    "curves": "a list of curves",
    "curves[]": "an object with points, lambda, degree and closed",
    "curves[].name": f"text of at most {NAME_LENGTH} characters",
    "curves[].degree": "2 or 3",
    "curves[].closed": "true or false",
    "curves[].ends": '"free" or "clamped"',
    "curves[].points": "a list of points",
    "curves[].points[]": "a list of 2 or 3 numbers",
    "curves[].points[][]": f"a number from {-MAX_COORDINATE:g} to {MAX_COORDINATE:g}",
    "curves[].lambda": "a list with one number per point",
    "curves[].lambda[]": f"a number from {-MAX_LAMBDA:g} to {MAX_LAMBDA:g}",
    "curves[].style": "an object with color and width",
    "curves[].style.color": f'a colour such as "{DEFAULT_COLOR}"',
    "curves[].style.width": f"a number from {WIDTH_RANGE[0]:g} to {WIDTH_RANGE[1]:g}",
    "curves[].visible": "true or false",
    "curves[].locked": "true or false",
}


def encode(drawing: Drawing) -> bytes:
    """Write a drawing as JSON in UTF-8, with a newline at the end.

    Decoding gives back the same values bit for bit, and encoding those the same bytes.
    """
    curves = ",\n".join(_curve_text(item) for item in drawing)
    body = f"\n{curves}\n " if curves else ""
    return f'{{"format": "{FORMAT}", "version": {VERSION},\n "curves": [{body}]}}\n'.encode()


def _curve_text(item: Item) -> str:
    curve = item.curve
    name, ends, color = (json.dumps(text, ensure_ascii=False) for text in (item.name, curve.ends, item.color))
    closed, visible, locked = (json.dumps(bool(flag)) for flag in (curve.closed, item.visible, item.locked))
    points = ",\n".join(f"    {point!r}" for point in curve.control_points.tolist())
    lambdas = ",\n".join(f"    {value!r}" for value in curve.lambdas.tolist())
    return (
        f'  {{"name": {name}, "degree": {curve.degree}, "closed": {closed}, "ends": {ends},\n'
        f'   "points": [\n{points}\n   ],\n'
        f'   "lambda": [\n{lambdas}\n   ],\n'
        f'   "style": {{"color": {color}, "width": {item.width!r}}}, '
        f'"visible": {visible}, "locked": {locked}}}'
    )


def decode(data: bytes) -> Drawing:
    """Read a drawing from JSON.

    Raises
    ------
    DrawingError
        If the data is not UTF-8 or not JSON (with line and column), has a field that is missing, unknown,
        given twice or of another type or range (with its JSON path), or is of a newer version.
    """
    _refuse_foreign_text(data)
    try:
        _refuse_other_versions(msgspec.json.decode(data, type=_Header))
        file = msgspec.json.decode(data, type=_File)
    except msgspec.ValidationError as error:
        raise DrawingError(_validation_sentence(str(error))) from None
    except msgspec.DecodeError as error:
        raise DrawingError(_syntax_sentence(str(error), data)) from None
    except RecursionError:
        raise DrawingError("Lists or objects are nested too deeply for a drawing.") from None
    _refuse_duplicate_keys(data.decode())
    return Drawing(_item(curve, f"curves[{index}]") for index, curve in enumerate(file.curves))


def _item(source: _Curve, path: str) -> Item:
    points, lambdas = source.points, source.lambdas
    fewest = fewest_points(source.degree, source.closed, source.ends)
    if len(points) < fewest:
        kind = f"{'closed' if source.closed else source.ends} curve of degree {source.degree}"
        raise DrawingError(
            f"{path}.points must be at least {fewest} points for a {kind}, but there are {len(points)}."
        )
    for index, point in enumerate(points):
        if len(point) != len(points[0]):
            raise DrawingError(
                f"{path}.points[{index}] must have {len(points[0])} coordinates like the points before it, "
                f"but has {len(point)}."
            )
    if len(lambdas) != len(points):
        raise DrawingError(
            f"{path}.lambda must have one number per point, but {len(points)} points have {len(lambdas)} λ."
        )
    curve = Curve(points, lambdas, source.degree, source.closed, source.ends)
    style = source.style
    try:
        return Item(curve, source.name, style.color, style.width, source.visible, source.locked)
    except DrawingError as error:
        raise DrawingError(f"{path}: {error}") from None


def _refuse_foreign_text(data: bytes) -> None:
    if data.startswith(b"\xef\xbb\xbf"):
        raise DrawingError("The text begins with a byte order mark: save it as UTF-8 without one.")
    try:
        data.decode()
    except UnicodeDecodeError as error:
        raise DrawingError(f"The text is not UTF-8 at {_position(data, error.start)}.") from None


def _refuse_other_versions(header: _Header) -> None:
    if header.format != FORMAT:
        raise DrawingError(f'format must be "{FORMAT}": this is not a drawing of this program.')
    version = header.version
    if type(version) is not int or version < 1:
        raise DrawingError("version must be a whole number from 1.")
    if version > VERSION:
        raise DrawingError(
            f"version is {version}, and {VERSION} is the newest this program reads: "
            "open it with a newer release of theditor."
        )


def _validation_sentence(message: str) -> str:
    """Turn msgspec's message on a wrong value into a sentence with path and expectation."""
    what, _, place = message.partition(" - at `$")
    path = place.rstrip("`").removeprefix(".")
    owner = path or "the file"
    if missing := re.search("missing required field `(.*)`", what):
        return f'{owner} must have the field "{missing[1]}".'
    if unknown := re.search("unknown field `(.*)`", what):
        return f"{owner} has the field {unknown[1]!a}, which is not part of the format."
    kind = re.sub(r"\[\d+\]", "[]", path)
    return f"{owner} must be {_EXPECTED[kind]}."


def _syntax_sentence(message: str, data: bytes) -> str:
    """Turn msgspec's message on malformed JSON into a sentence with line and column."""
    place = re.fullmatch(r"JSON is malformed: (.*) \(byte (\d+)\)", message)
    if place is None:
        return f"The text is not complete JSON: it ends too early, at {_position(data, len(data))}."
    return f"The text is not JSON: {place[1]} at {_position(data, int(place[2]))}."


def _position(data: bytes, byte: int) -> str:
    before = data[:byte].decode(errors="replace")
    return f"line {before.count(chr(10)) + 1}, column {len(before) - before.rfind(chr(10))}"


# Lists of numbers hold no keys, and are nearly the whole of a file.
_NUMBERS = re.compile(r'\[[^"{}]*\]')


def _refuse_duplicate_keys(text: str) -> None:
    """Refuse a key given twice, of which JSON libraries silently keep the last; the text is valid JSON."""
    outline = json.loads(_NUMBERS.sub("0", text), object_pairs_hook=tuple)
    for path in _duplicate_keys(outline, ""):
        raise DrawingError(f"{path} is given twice.")


def _duplicate_keys(node: object, path: str) -> Iterator[str]:
    if isinstance(node, list):
        for index, value in enumerate(node):
            yield from _duplicate_keys(value, f"{path}[{index}]")
    elif isinstance(node, tuple):  # an object, as its (key, value) pairs
        seen: set[str] = set()
        for key, value in node:
            child = f"{path}.{key}".removeprefix(".")
            if key in seen:
                yield child
            seen.add(key)
            yield from _duplicate_keys(value, child)
