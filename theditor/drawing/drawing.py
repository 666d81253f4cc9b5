"""The value a file holds: an ordered, immutable row of named and styled curves."""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Iterable, Mapping
from typing import Any, Self

from msgspec import Struct
from msgspec.structs import force_setattr, replace

from theditor.spline import Curve

NAME_LENGTH = 200
WIDTH_RANGE = (0.1, 100.0)
DEFAULT_NAME = "Curve"
DEFAULT_COLOR = "#334155"
DEFAULT_WIDTH = 2.0

_COLOR = re.compile(r"#[0-9A-Fa-f]{6}")
# Control characters, lone surrogates, line and paragraph separators: none fits on one line of UTF-8 text.
_UNPRINTABLE = frozenset({"Cc", "Cs", "Zl", "Zp"})


class DrawingError(ValueError):
    """A drawing, or the file that should hold one, is not as it must be; the message is one sentence."""


class Item(Struct, frozen=True):
    """One curve of a drawing with its name and style; immutable, compared and hashed by value.

    Parameters
    ----------
    curve
        The spline itself.
    name
        What people call it: one line of at most 200 characters.
    color
        Stroke colour ``"#rrggbb"``, in either case.
    width
        Stroke width in pixels, 0.1 to 100.
    visible, locked
        Whether it is drawn, and whether it is guarded against edits.

    Raises
    ------
    DrawingError
        If the name, the colour or the width is not as above.
    """

    curve: Curve
    name: str = DEFAULT_NAME
    color: str = DEFAULT_COLOR
    width: float = DEFAULT_WIDTH
    visible: bool = True
    locked: bool = False

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or len(self.name) > NAME_LENGTH:
            raise DrawingError(f"A curve's name must be text of at most {NAME_LENGTH} characters.")
        if any(unicodedata.category(character) in _UNPRINTABLE for character in self.name):
            raise DrawingError(
                f"A curve's name must be one line without control characters, not {self.name!a}."
            )
        if not isinstance(self.color, str) or not _COLOR.fullmatch(self.color):
            raise DrawingError(f'A curve\'s colour must be of the form "#rrggbb", not {self.color!a}.')
        lowest, highest = WIDTH_RANGE
        if not (math.isfinite(self.width) and lowest <= self.width <= highest):
            raise DrawingError(
                f"A curve's width must be between {lowest:g} and {highest:g}, not {self.width!r}."
            )
        force_setattr(self, "width", float(self.width))

    def with_(self, **changes: Any) -> Self:
        """Return a copy with some fields changed, checked like a new item."""
        return replace(self, **changes)


class Drawing(tuple[Item, ...]):
    """An immutable, hashable sequence of items; the first is drawn first, so the last lies on top."""

    __slots__ = ()

    def __new__(cls, items: Iterable[Item] = ()) -> Self:
        """Collect the items, refusing with a TypeError whatever is not an `Item`."""
        drawing = super().__new__(cls, items)
        for index, item in enumerate(drawing):
            if not isinstance(item, Item):
                raise TypeError(f"A drawing holds items; number {index} is a {type(item).__name__}.")
        return drawing

    def __repr__(self) -> str:
        return f"Drawing({list(self)!r})"

    def with_item(self, index: int, item: Item) -> Drawing:
        """Return a drawing with the item at an index replaced; IndexError if there is none."""
        items = list(self)
        items[index] = item
        return Drawing(items)

    def with_curve(self, index: int, curve: Curve) -> Drawing:
        """Return a drawing where the item at an index has another curve and keeps its name and style."""
        return self.with_item(index, self[index].with_(curve=curve))

    def with_curves(self, curves: Mapping[int, Curve]) -> Drawing:
        """Return a drawing where the items at some indices have other curves, as `with_curve`, all at once."""
        items = list(self)
        for index, curve in curves.items():
            items[index] = items[index].with_(curve=curve)
        return Drawing(items)

    def inserted(self, index: int, item: Item) -> Drawing:
        """Return a drawing with an item inserted before an index, counted like `list.insert`."""
        items = list(self)
        items.insert(index, item)
        return Drawing(items)

    def without(self, index: int) -> Drawing:
        """Return a drawing without the item at an index; IndexError if there is none."""
        items = list(self)
        del items[index]
        return Drawing(items)
