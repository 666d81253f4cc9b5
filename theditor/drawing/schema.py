"""Drawing ↔ JSON: strict when reading, one fixed layout when writing.

The file is meant to be read and compared line by line: one control point and one λ per line, the keys always
in the same order, every number the shortest decimal that reads back as the same float.
"""

# Annotations are not postponed here: msgspec would have to compile each.

import json
import re
from collections.abc import Iterator
from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta, Raw, Struct, field

from theditor.drawing import migrations
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
from theditor.drawing.faults import FaultError, position, quoted, refuse_duplicate_keys
from theditor.spline import MAX_COORDINATE, MAX_LAMBDA, Curve, Ends, fewest_points
from theditor.spline.basis import Floats

FORMAT = "theditor"
VERSION = 1
_PART = 2048
"""Points in a part of the text: about a millisecond's work."""

# Patterns in the dialect that JSON Schema and Python share; the lengths keep out a last newline, which $ lets pass.
_ONE_LINE = r"^(?![\s\S]*[\u0000-\u001f\u007f-\u009f\u2028\u2029])"
_COLOR = "^#[0-9A-Fa-f]{6}$"

_Coordinate = Annotated[float, Meta(ge=-MAX_COORDINATE, le=MAX_COORDINATE)]
_Point = Annotated[list[_Coordinate], Meta(min_length=2, max_length=3, description="x, y, and in space z.")]
_Lambda = Annotated[float, Meta(ge=-MAX_LAMBDA, le=MAX_LAMBDA)]


def _fewest_points_rules() -> dict[str, Any]:
    """Say in JSON Schema what `fewest_points` says, and that all points lie in the plane or all in space."""
    rules: list[dict[str, Any]] = []
    ends: tuple[Ends, ...] = ("free", "clamped")
    for degree, closed, end in ((d, c, e) for d in (2, 3) for c in (False, True) for e in ends):
        fewest = {"minItems": fewest_points(degree, closed, end)}
        given = {"degree": {"const": degree}, "closed": {"const": closed}, "ends": {"const": end}}
        required = ["degree", "closed"] + (["ends"] if end != "free" else [])  # left out, they are free
        rules.append(
            {
                "if": {"properties": given, "required": required},
                "then": {"properties": {"points": fewest, "lambda": fewest}},
            }
        )
    plane, space = {"items": {"maxItems": 2}}, {"items": {"minItems": 3}}
    return {"allOf": [*rules, {"properties": {"points": {"anyOf": [plane, space]}}}]}


class Style(Struct, forbid_unknown_fields=True):
    """How a curve is drawn."""

    color: Annotated[str, Meta(pattern=_COLOR, max_length=7, description="Stroke colour.")] = DEFAULT_COLOR
    width: Annotated[
        float, Meta(ge=WIDTH_RANGE[0], le=WIDTH_RANGE[1], description="Stroke width in pixels.")
    ] = DEFAULT_WIDTH


class CurveRecord(Struct, forbid_unknown_fields=True):
    """A TH-type uniform B-spline with its name and style."""

    points: Annotated[list[_Point], Meta(description="The control points in order.")]
    lambdas: Annotated[
        list[_Lambda], Meta(description="The shape parameter λ of each control point: as many as points.")
    ] = field(name="lambda")
    degree: Annotated[Literal[2, 3], Meta(description="Quadratic (C¹) or cubic (C²).")]
    closed: Annotated[bool, Meta(description="Whether the curve ends where it began.")]
    name: Annotated[str, Meta(max_length=NAME_LENGTH, pattern=_ONE_LINE, description="One line of text.")] = (
        DEFAULT_NAME
    )
    ends: Annotated[
        Literal["free", "clamped"], Meta(description="How an open curve ends; ignored while it is closed.")
    ] = "free"
    style: Style = field(default_factory=Style)
    visible: Annotated[bool, Meta(description="Whether it is drawn.")] = True
    locked: Annotated[bool, Meta(description="Whether it is guarded against edits.")] = False


_RuledCurve = Annotated[CurveRecord, Meta(extra_json_schema=_fewest_points_rules())]


class File(Struct, forbid_unknown_fields=True):
    """A drawing of theditor."""

    format: Literal["theditor"]
    version: Literal[1]
    curves: Annotated[list[_RuledCurve], Meta(description="The first is drawn first, so the last is on top.")]


class _Header(Struct):
    """What every version of the file has; read first, so that a newer file is refused by its number."""

    format: Raw = Raw()
    version: Raw = Raw()


# What belongs at each place, for the reader of a message; list positions are left out.
_EXPECTED = {
    "": "an object with format, version and curves",
    "format": f'"{FORMAT}": this is not a drawing of this program',
    "version": "a whole number such as 1",
    "curves": "a list of curves",
    "curves[]": "an object with points, lambda, degree and closed",
    "curves[].name": f"one line of text without control characters, at most {NAME_LENGTH} characters long",
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


def json_schema() -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of the file, made from the very definition that `decode` reads by.

    It cannot say that there are as many λ as points, that no key is given twice, and that 2.0 is no degree;
    `decode` refuses these as well.
    """
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **msgspec.json.schema(File)}


def encode(drawing: Drawing) -> bytes:
    """Write a drawing as JSON in UTF-8, with a newline at the end.

    Decoding gives back the same values bit for bit, and encoding those the same bytes.
    """
    return b"".join(encode_in_parts(drawing))


def encode_in_parts(drawing: Drawing) -> Iterator[bytes]:
    """Yield what `encode` returns in parts of some thousand points, between which a thread can let others work."""
    yield f'{{"format": "{FORMAT}", "version": {VERSION},\n "curves": ['.encode()
    for index, item in enumerate(drawing):
        yield b",\n" if index else b"\n"
        yield from _curve_in_parts(item)
    yield b"\n ]}\n" if drawing else b"]}\n"


def _curve_in_parts(item: Item) -> Iterator[bytes]:
    curve = item.curve
    name, ends, color = (json.dumps(text, ensure_ascii=False) for text in (item.name, curve.ends, item.color))
    closed, visible, locked = (json.dumps(bool(flag)) for flag in (curve.closed, item.visible, item.locked))
    yield (
        f'  {{"name": {name}, "degree": {curve.degree}, "closed": {closed}, "ends": {ends},\n'
        '   "points": [\n    '
    ).encode()
    for text in _numbers(curve.control_points):
        yield text.replace(b",", b", ").replace(b"], ", b"],\n    ")
    yield b'\n   ],\n   "lambda": [\n    '
    for text in _numbers(curve.lambdas):
        yield text.replace(b",", b",\n    ")
    yield (
        f'\n   ],\n   "style": {{"color": {color}, "width": {item.width!r}}}, '
        f'"visible": {visible}, "locked": {locked}}}'
    ).encode()


def _numbers(array: Floats) -> Iterator[bytes]:
    """The rows of an array as a JSON list without its brackets, in parts."""
    for start in range(0, len(array), _PART):
        rows = msgspec.json.encode(array[start : start + _PART].tolist())[1:-1]
        yield rows + b"," if start + _PART < len(array) else rows


def decode(data: bytes) -> Drawing:
    """Read a drawing from JSON in UTF-8, with or without a byte order mark.

    Raises
    ------
    DrawingError
        If the data is not UTF-8 or not JSON (with line and column), has a field that is missing, unknown,
        given twice or of another type or range (with its JSON path, line and column), or is of a newer version.
    """
    text = _text(data)
    try:
        version = _version(msgspec.json.decode(text, type=_Header))
        if version == VERSION:
            file = msgspec.json.decode(text, type=File)
            refuse_duplicate_keys(text)
            return _drawing(file)
        plain = msgspec.json.decode(text)
        refuse_duplicate_keys(text)
    except msgspec.ValidationError as error:
        raise _fault(str(error)).located(text) from None
    except FaultError as fault:
        raise fault.located(text) from None
    except msgspec.DecodeError as error:
        raise DrawingError(_syntax_sentence(str(error), text)) from None
    except RecursionError:
        raise DrawingError("Lists or objects are nested too deeply for a drawing.") from None
    return _drawing_of_version(version, plain)


def _text(data: bytes) -> str:
    encoding = json.detect_encoding(data)
    if not encoding.startswith("utf-8"):
        raise DrawingError(f"The text is {encoding[:6].upper()}: save it as UTF-8.")
    data = data.removeprefix(b"\xef\xbb\xbf")
    try:
        return data.decode()
    except UnicodeDecodeError as error:
        before = data[: error.start].decode()
        raise DrawingError(f"The text is not UTF-8 at {position(before, len(before))}.") from None


def _version(header: _Header) -> int:
    """Return a version that can be read."""
    form, version_text = bytes(header.format), bytes(header.version)
    if not form:
        raise FaultError("", 'must have the field "format": this is not a drawing of this program')
    if form != f'"{FORMAT}"'.encode():
        raise FaultError("format", f"must be {_EXPECTED['format']}")
    if not version_text:
        raise FaultError("", 'must have the field "version"')
    version = int(version_text) if re.fullmatch(rb"\d{1,9}", version_text) else -1
    if version < min(migrations.STEPS, default=VERSION):
        raise FaultError("version", f"must be {_EXPECTED['version']}")
    if version > VERSION:
        raise FaultError(
            "version",
            f"is {version}, and {VERSION} is the newest this program reads: open it with a newer release of theditor",
        )
    return version


def _drawing_of_version(version: int, plain: dict[str, Any]) -> Drawing:
    """Read what is of an older version; its faults have no place in the text, which is not what is looked at."""
    try:
        return _drawing(msgspec.convert(migrations.migrated(plain, version, VERSION), File))
    except msgspec.ValidationError as error:
        raise _fault(str(error)).unlocated() from None
    except FaultError as fault:
        raise fault.unlocated() from None


def _drawing(file: File) -> Drawing:
    return Drawing(_item(curve, f"curves[{index}]") for index, curve in enumerate(file.curves))


def _item(source: CurveRecord, path: str) -> Item:
    points, lambdas = source.points, source.lambdas
    fewest = fewest_points(source.degree, source.closed, source.ends)
    if len(points) < fewest:
        kind = f"{'closed' if source.closed else source.ends} curve of degree {source.degree}"
        raise FaultError(
            f"{path}.points", f"must be at least {fewest} points for a {kind}, but there are {len(points)}"
        )
    dimension = len(points[0])
    for index, point in enumerate(points):
        if len(point) != dimension:
            raise FaultError(
                f"{path}.points[{index}]",
                f"must have {dimension} coordinates like the points before it, but has {len(point)}",
            )
    if len(lambdas) != len(points):
        raise FaultError(
            f"{path}.lambda",
            f"must have one number per point, but {len(points)} points have {len(lambdas)} λ",
        )
    curve = Curve(points, lambdas, source.degree, source.closed, source.ends)
    style = source.style
    return Item(curve, source.name, style.color, style.width, source.visible, source.locked)


def _fault(message: str) -> FaultError:
    """Turn msgspec's message on a wrong value into a fault with path and expectation."""
    if unknown := re.fullmatch(
        r"Object contains unknown field `(.*?)`(?: - at `\$([\w.\[\]]*)`)?", message, re.S
    ):
        path = (unknown[2] or "").removeprefix(".")
        return FaultError(
            path, f"has the field {quoted(unknown[1])}, which is not part of the format", unknown[1]
        )
    what, _, place = message.partition(" - at `$")
    path = place.rstrip("`").removeprefix(".")
    if missing := re.search("missing required field `(.*)`", what):
        return FaultError(path, f'must have the field "{missing[1]}"')
    expected = _EXPECTED[re.sub(r"\[\d+\]", "[]", path)]
    return FaultError(path, f"must be {expected}")


def _syntax_sentence(message: str, text: str) -> str:
    """Turn msgspec's message on malformed JSON into a sentence with line and column."""
    place = re.fullmatch(r"JSON is malformed: (.*) \(byte (\d+)\)", message)
    if place is not None:
        before = text.encode()[: int(place[2])].decode(errors="replace")
        return f"The text is not JSON: {place[1]} at {position(before, len(before))}."
    if text.rstrip().endswith("}") and re.search(r"\\u[dD][89a-fA-F]", text):
        return (
            r"The text is not Unicode: an escape from \ud800 to \udfff stands alone, which is no character."
        )
    return f"The text is not complete JSON: it ends too early, at {position(text, len(text))}."
