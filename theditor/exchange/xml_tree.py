"""XML from anywhere as a plain tree: nothing is fetched, and nothing grows beyond a bound."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final
from xml.parsers import expat

from theditor.drawing import DrawingError

MAX_BYTES: Final = 64 * 2**20
MAX_ELEMENTS: Final = 200_000
MAX_DEPTH: Final = 200
_ENTITIES: Final = 256 * 2**20  # bytes that entities may grow to at the very most
_SHORTEST_REFERENCE: Final = 3  # &a;


@dataclass(slots=True, eq=False)
class Node:
    """An element: its name and those of its attributes with their namespace and a blank before, if they have any."""

    name: str
    attributes: dict[str, str]
    line: int
    children: list[Node] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)

    @property
    def text(self) -> str:
        """The text directly within."""
        return "".join(self.texts)

    def walk(self) -> Iterator[Node]:
        """Yield this element and all within, in order."""
        waiting = [self]
        while waiting:
            node = waiting.pop()
            yield node
            waiting += reversed(node.children)


def parse(data: bytes) -> Node:
    """Return the outermost element.

    Raises
    ------
    DrawingError
        If the data is no XML, or too large, too deep, or defines entities of some size; with its line.
    """
    if not data.strip():
        raise DrawingError("The file is empty.")
    if data.startswith(b"\x1f\x8b"):
        raise DrawingError("The data is compressed: unpack it with gzip first.")
    if len(data) > MAX_BYTES:
        raise DrawingError(f"There is more than {MAX_BYTES // 2**20} MiB of it, the most that is read.")
    reading = _Reading(len(data))
    try:
        reading.parser.Parse(data, True)
    except expat.ExpatError as error:
        raise DrawingError(
            f"The text is not XML: {expat.ErrorString(error.code)} at line {error.lineno}, "
            f"column {error.offset + 1}."
        ) from None
    except (LookupError, ValueError) as error:  # of an encoding
        if isinstance(error, DrawingError):
            raise
        raise DrawingError("The text is in an encoding that is not known: save it as UTF-8.") from None
    assert reading.root is not None  # else the parser would have complained
    return reading.root


class _Reading:
    def __init__(self, size: int) -> None:
        self.root: Node | None = None
        self._open: list[Node] = []
        self._count, self._size = 0, size
        self.parser = expat.ParserCreate(namespace_separator=" ")
        self.parser.buffer_text = True
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.CharacterDataHandler = self._text
        self.parser.EntityDeclHandler = self._entity

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        line = self.parser.CurrentLineNumber
        self._count += 1
        if self._count > MAX_ELEMENTS:
            raise DrawingError(f"There are more than {MAX_ELEMENTS:,} elements, the most that are read.")
        if len(self._open) >= MAX_DEPTH:
            raise DrawingError(f"Elements are nested more than {MAX_DEPTH} deep at line {line}.")
        node = Node(name, attributes, line)
        if self._open:
            self._open[-1].children.append(node)
        else:
            self.root = node
        self._open.append(node)

    def _end(self, name: str) -> None:
        self._open.pop()

    def _text(self, text: str) -> None:
        self._open[-1].texts.append(text)

    def _entity(self, name: str, parameter: bool, value: str | None, *_: object) -> None:
        line = self.parser.CurrentLineNumber
        if value is None:
            raise DrawingError(f"Line {line} defines an entity by another file, which is not fetched.")
        if "&" in value or "%" in value or len(value) * self._size // _SHORTEST_REFERENCE > _ENTITIES:
            raise DrawingError(f"Line {line} defines an entity that could grow beyond measure.")
