"""What is wrong in the text of a drawing, as one sentence with its JSON path, line and column."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from itertools import islice

from theditor.drawing.drawing import DrawingError

_LONGEST_QUOTE = 40


class FaultError(Exception):
    """Something wrong with the value at a JSON path such as ``curves[0].points[3]``, or with a key in it.

    Parameters
    ----------
    path
        Where; empty for the whole text.
    saying
        What is said of it, without the full stop.
    key
        The key of the object at the path that is to be pointed to, instead of the whole object.
    again
        Whether the second such key is meant.
    """

    def __init__(self, path: str, saying: str, key: str | None = None, again: bool = False) -> None:
        self.path, self.saying, self.key, self.again = path, saying, key, again

    def located(self, text: str) -> DrawingError:
        """Return the fault as an error, with the place in a text where it was found."""
        pointed = self.path != "" or self.key is not None
        place = _offset(text, self.path, self.key, self.again) if pointed else None
        where = "" if place is None else f" ({position(text, place)})"
        return DrawingError(f"{self.path or 'The file'}{where} {self.saying}.")

    def unlocated(self) -> DrawingError:
        """Return the fault as an error, of a text that is not the one it was found in."""
        return DrawingError(f"{self.path or 'The file'} {self.saying}.")


def position(text: str, offset: int) -> str:
    """Return line and column, both counted from 1, of a character."""
    return f"line {text.count(chr(10), 0, offset) + 1}, column {offset - text.rfind(chr(10), 0, offset)}"


def quoted(text: str) -> str:
    """Return text from a file in quotes, on one line, and shortened if it is long."""
    return ascii(text if len(text) <= _LONGEST_QUOTE else f"{text[:_LONGEST_QUOTE]}…")


def refuse_duplicate_keys(text: str) -> None:
    """Raise a `FaultError` for a key given twice in a valid JSON text; JSON libraries silently keep the last."""
    outline = json.loads(_NUMBERS.sub("0", text), object_pairs_hook=tuple)
    for path, key in _duplicate_keys(outline, ""):
        raise FaultError(path, f"has the field {quoted(key)} twice", key, again=True)


# Lists of numbers hold no keys, and are nearly the whole of a file.
_NUMBERS = re.compile(r'\[[^"{}]*\]')


def _duplicate_keys(node: object, path: str) -> Iterator[tuple[str, str]]:
    if isinstance(node, list):
        for index, value in enumerate(node):
            yield from _duplicate_keys(value, f"{path}[{index}]")
    elif isinstance(node, tuple):  # an object, as its (key, value) pairs
        seen: set[str] = set()
        for key, value in node:
            if key in seen:
                yield path, key
            seen.add(key)
            yield from _duplicate_keys(value, f"{path}.{key}".removeprefix("."))


_SPACE = re.compile(r"[ \t\r\n]*")
# Numbers stay text: they are passed over, however large.
_scan = json.JSONDecoder(parse_int=str, parse_float=str).raw_decode


def _offset(text: str, path: str, key: str | None, again: bool) -> int | None:
    """Return where the value at a path begins in a JSON text, or the first or second such key of the object there."""
    try:
        place = _skip(text, 0)
        for name, index in re.findall(r"(\w+)|\[(\d+)\]", path):
            if name:
                place = next(value for _, found, value in _fields(text, place) if found == name)
            else:
                place = _element(text, place, int(index))
        if key is not None:
            starts = (start for start, found, _ in _fields(text, place) if found == key)
            place = next(islice(starts, again, None))
    except (
        LookupError,
        ValueError,
        RecursionError,
        StopIteration,
    ):  # the text breaks off, or is not what the path says
        return None
    return place


def _fields(text: str, place: int) -> Iterator[tuple[int, str, int]]:
    """Yield where each key of an object begins, the key, and where its value begins."""
    while text[place] in "{,":
        start = _skip(text, place + 1)
        key, place = _scan(text, start)
        value = _skip(text, _skip(text, place) + 1)
        yield start, key, value
        place = _skip(text, _scan(text, value)[1])


def _element(text: str, place: int, index: int) -> int:
    for _ in range(index):
        place = _skip(text, _scan(text, _skip(text, place + 1))[1])
    return _skip(text, place + 1)


def _skip(text: str, place: int) -> int:
    space = _SPACE.match(text, place)
    assert space is not None
    return space.end()
