"""Reading SVG: every path and basic shape becomes a curve, and a drawing of this program comes back as it was."""

from __future__ import annotations

import unicodedata
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Final, NamedTuple

import numpy as np

from theditor.drawing import Drawing, DrawingError, Item
from theditor.drawing.drawing import NAME_LENGTH, WIDTH_RANGE
from theditor.exchange import embedded, path_data
from theditor.exchange.contour import Contour, size
from theditor.exchange.options import DEFAULTS, PARTS, Imported, Options, Progress
from theditor.exchange.svg_place import FaultError, Place, outer_size, then, transform, viewbox, within_view
from theditor.exchange.svg_shapes import SHAPES, Measures
from theditor.exchange.svg_style import Look, Rules, colour, inherited, properties, rules
from theditor.exchange.traced import traced
from theditor.exchange.xml_tree import MAX_DEPTH, Node, parse
from theditor.spline.numerals import counted

MAX_PIECES: Final = 200_000
"""Lines, Béziers and arcs of the largest picture that is read."""
MAX_USED: Final = 20_000
"""Elements that `use` may draw again."""

_SVG: Final = "http://www.w3.org/2000/svg "
_LINK: Final = "http://www.w3.org/1999/xlink href"
_LABEL: Final = "http://www.inkscape.org/namespaces/inkscape label"
_GROUPS: Final = frozenset({"g", "a", "svg", "switch"})
_LEFT_OUT: Final = {
    "text": "text", "image": "image", "foreignObject": "foreign object", "script": "script",
    "video": "video", "audio": "sound",
}  # fmt: skip
_EFFECTS: Final = {"clip-path": "clip paths", "mask": "masks", "filter": "filters"}
_NAMED_FAULTS: Final = 3
_LEAST_SIZE: Final = 1e-100


class _Drawn(NamedTuple):
    """A contour in the drawing's coordinates, with the name and style of what it is of."""

    contour: Contour
    name: str
    color: str
    width: float
    visible: bool


@dataclass(slots=True)
class _Picture:
    """What is gathered while the elements are gone through."""

    sheet: Rules
    by_id: dict[str, Node]
    stroke_scale: float
    aside: frozenset[str]  # ids of groups that show what belongs to curves
    drawn: list[_Drawn] = field(default_factory=list)
    left_out: Counter[str] = field(default_factory=Counter)
    effects: set[str] = field(default_factory=set)
    faults: list[str] = field(default_factory=list)
    names: Counter[str] = field(default_factory=Counter)
    used: int = 0
    pieces: int = 0


def read(data: bytes, options: Options = DEFAULTS, progress: Progress | None = None) -> Imported:
    """Read the curves of an SVG picture; `exchange.read` says what the arguments are.

    Coordinates are the picture's own user units, with y turned upward about its origin: where 1 unit is 1 mm
    there, it is here. Each subpath is a curve, in the colour of its stroke or else of its fill. Lines, ellipses,
    quarter turns and smooth runs of these are exact; what else there is is fitted within the tolerance. A
    picture that this program wrote gives back the very drawing, unless its paths were changed since.
    """
    notes: list[str] = []
    ours = embedded.NAMESPACE.encode() in data
    try:
        own = embedded.extract(data)
    except DrawingError:
        own = None
        notes.append("The drawing that theditor put into the picture is damaged, so the paths were read.")
    if own is not None and own.current:
        return Imported(own.drawing)
    if own is not None:
        notes.append(
            "Another program changed the picture since theditor wrote it, so its paths were read anew."
        )
    picture = _picture(parse(data), frozenset(PARTS) if ours else frozenset())
    if not picture.drawn:
        raise DrawingError(" ".join(["There is no path or shape to be read.", *_remarks(picture)]))
    drawing, deviation, more = _curves(picture.drawn, options, progress)
    return Imported(drawing, deviation, (*notes, *_remarks(picture), *more))


def read_path_data(text: str, options: Options = DEFAULTS, progress: Progress | None = None) -> Imported:
    """Read bare path data, such as ``M0 0 C1 1 2 1 3 0``, as SVG would draw it: y runs downward in it.

    Raises
    ------
    DrawingError
        If it draws nothing, or cannot be read to its end.
    """
    found = path_data.contours(text)
    if found.fault is not None:
        raise DrawingError(f"The path data cannot be read from character {found.fault} on.")
    if not found.contours:
        raise DrawingError("The path data draws nothing.")
    _check_pieces(sum(len(contour.pieces) for contour in found.contours))
    look = Look(stroke="none", fill="none")
    names = _numbered("Path", len(found.contours))
    upward = np.array([[1.0, 0, 0], [0, -1.0, 0]])
    try:
        drawn = [
            _Drawn(contour.moved(upward), name, colour(look), 2.0, True)
            for contour, name in zip(found.contours, names, strict=True)
        ]
    except DrawingError as error:
        raise DrawingError(f"In the path data {error}.") from None
    drawing, deviation, notes = _curves(drawn, options, progress)
    return Imported(drawing, deviation, notes)


# From contours to curves


def _curves(
    drawn: Sequence[_Drawn], options: Options, progress: Progress | None
) -> tuple[Drawing, float, tuple[str, ...]]:
    tolerance = options.tolerance * size([one.contour for one in drawn])
    items: list[Item] = []
    largest, meant, beyond = 0.0, 0, 0
    total, done = sum(len(one.contour.pieces) for one in drawn), 0
    for one in drawn:
        if progress is not None:
            progress(done / total)
        done += len(one.contour.pieces)
        if size([one.contour]) < _LEAST_SIZE:
            continue
        curve, deviation, stands_for = traced(one.contour, tolerance, options.degree)
        items.append(Item(curve, one.name, one.color, one.width, one.visible))
        largest = max(largest, deviation)
        meant += stands_for
        beyond += deviation > tolerance and not stands_for
    if not items:
        raise DrawingError("There is nothing to be read but outlines without length.")
    notes = []
    if meant:
        notes.append(
            f"{counted(meant, 'curve')} drawn with Béziers: the ellipse arcs they stand for were taken."
        )
    if beyond:
        notes.append(f"{counted(beyond, 'curve')} could not be fitted within the tolerance.")
    return Drawing(items), largest, tuple(notes)


# From elements to contours


def _picture(root: Node, aside: frozenset[str]) -> _Picture:
    if _tag(root) != "svg":
        raise DrawingError(f"The outermost element is {root.name.rpartition(' ')[2][:40]!a}, not svg.")
    nodes = list(root.walk())
    sheet = rules(node.text for node in nodes if _tag(node) == "style")
    by_id: dict[str, Node] = {}
    for node in nodes:
        by_id.setdefault(node.attributes.get("id", ""), node)
    box, outer = viewbox(root), outer_size(root)
    if box is not None:
        width, height = box[2:]
        scale = outer[0] / width if outer is not None else 1.0
    else:
        width, height = outer if outer is not None else (100.0, 100.0)
        scale = 1.0
    picture = _Picture(sheet, by_id, scale, aside)
    place = Place(np.array([[1.0, 0, 0], [0, -1.0, 0]]), Look(), width, height, 0)
    _go_through(root, place, picture)
    return picture


def _go_through(node: Node, place: Place, picture: _Picture, shown_by_use: bool = False) -> None:
    """Gather what an element draws, and those within."""
    tag = _tag(node)
    if node.attributes.get("id") in picture.aside:
        return
    picture.used += bool(place.uses)
    if picture.used > MAX_USED:
        raise DrawingError(
            f"Line {node.line}: more than {MAX_USED:,} elements are drawn again, the most that are."
        )
    if tag in _LEFT_OUT:
        picture.left_out[_LEFT_OUT[tag]] += 1
    drawn = tag in SHAPES or tag == "path"
    group = tag in _GROUPS or (tag == "symbol" and shown_by_use)
    if not (drawn or group or tag == "use"):
        return
    if place.depth > MAX_DEPTH:
        raise DrawingError(f"Line {node.line}: elements are nested more than {MAX_DEPTH} deep.")
    try:
        said = properties(tag, node, picture.sheet)
        place = place._replace(
            matrix=then(place.matrix, transform(node)),
            look=inherited(place.look, said),
            depth=place.depth + 1,
        )
        picture.effects |= {words for name, words in _EFFECTS.items() if said.get(name, "none") != "none"}
        if drawn:
            _draw(tag, node, place, picture)
        elif tag == "use":
            _use(node, place, picture)
        else:
            if tag == "symbol" or (tag == "svg" and place.depth > 1):
                place = within_view(node, place)
            children = node.children
            if tag == "switch":
                children = [child for child in children if child.name.startswith(_SVG)][:1]
            for child in children:
                _go_through(child, place, picture)
    except FaultError as fault:
        picture.faults.append(f"line {node.line} ({tag}: {fault})")


def _draw(tag: str, node: Node, place: Place, picture: _Picture) -> None:
    contours: Sequence[Contour]
    if tag == "path":
        found = path_data.contours(node.attributes.get("d", ""))
        contours = found.contours
        if found.fault is not None:
            picture.faults.append(f"line {node.line} (path: from character {found.fault} of its data on)")
    else:
        try:
            with np.errstate(all="ignore"):  # what is not finite is refused below
                contours = SHAPES[tag](Measures(node, place.width, place.height))
        except ValueError as error:
            raise FaultError(str(error)) from None
    if not contours:
        return
    picture.pieces += sum(len(contour.pieces) for contour in contours)
    _check_pieces(picture.pieces)
    with np.errstate(all="ignore"):
        scale = float(np.sqrt(abs(np.linalg.det(place.matrix[:, :2])))) * picture.stroke_scale
    width = float(np.clip(place.look.width * scale, *WIDTH_RANGE)) if np.isfinite(scale) else WIDTH_RANGE[1]
    try:
        moved = [contour.moved(place.matrix) for contour in contours]
    except DrawingError as error:
        raise DrawingError(f"Line {node.line}: {error}.") from None
    visible = place.look.visible and place.look.displayed
    for contour, name in zip(moved, _numbered(_name(tag, node, picture), len(moved)), strict=True):
        picture.drawn.append(_Drawn(contour, name, colour(place.look), width, visible))


def _use(node: Node, place: Place, picture: _Picture) -> None:
    target = (node.attributes.get("href") or node.attributes.get(_LINK, "")).strip()
    other = picture.by_id.get(target[1:]) if target.startswith("#") and len(target) > 1 else None
    if other is None:
        raise FaultError(f"{target[:40]!a} is not in this file" if target else "it names no other element")
    if target in place.uses:
        raise FaultError(f"{target[:40]!a} uses itself")
    of = Measures(node, place.width, place.height)
    try:
        shift = np.array([[1.0, 0, of.x("x")], [0, 1.0, of.y("y")]])
        if _tag(other) in ("symbol", "svg"):
            sizes = {
                name: str(node.attributes[name]) for name in ("width", "height") if name in node.attributes
            }
            other = Node(other.name, other.attributes | sizes, other.line, other.children, other.texts)
    except ValueError as error:
        raise FaultError(str(error)) from None
    place = place._replace(matrix=then(place.matrix, shift), uses=(*place.uses, target))
    _go_through(other, place, picture, shown_by_use=True)


def _tag(node: Node) -> str:
    """Return the name of an SVG element, "" of others."""
    name = node.name.removeprefix(_SVG)
    return "" if " " in name else name


# Words


def _name(tag: str, node: Node, picture: _Picture) -> str:
    """Return what an element is called: its title, its label or its id, else what it is with a number."""
    title = next((child.text for child in node.children if _tag(child) == "title"), "")
    for name in (title, node.attributes.get(_LABEL, ""), node.attributes.get("id", "")):
        plain = " ".join(
            "".join(" " if unicodedata.category(c)[0] in "CZ" else c for c in name[:1000]).split()
        )
        if plain:
            return plain
    word = {"rect": "rectangle"}.get(tag, tag).capitalize()
    picture.names[word] += 1
    return f"{word} {picture.names[word]}"


def _numbered(name: str, count: int) -> list[str]:
    """Return the names of the parts of what has a name."""
    if count == 1:
        return [name[:NAME_LENGTH]]
    return [f"{name[: NAME_LENGTH - 8]} {number}" for number in range(1, count + 1)]


def _remarks(picture: _Picture) -> list[str]:
    """Return what was not taken over, a sentence each."""
    notes = []
    if picture.left_out:
        what = [counted(count, word) for word, count in sorted(picture.left_out.items())]
        notes.append(f"Left out, as no curve: {', '.join(what)}.")
    if picture.effects:
        notes.append(f"What is drawn with {' or '.join(sorted(picture.effects))} is read without them.")
    if picture.faults:
        more = len(picture.faults) - _NAMED_FAULTS
        ending = f", and {more} more" if more > 0 else ""
        notes.append(
            f"What could not be read was left out: {'; '.join(picture.faults[:_NAMED_FAULTS])}{ending}."
        )
    return notes


def _check_pieces(count: int) -> None:
    if count > MAX_PIECES:
        raise DrawingError(
            f"There are more than {MAX_PIECES:,} lines, Béziers and arcs, the most that are read."
        )
