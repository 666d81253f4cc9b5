"""What one undo step keeps: only what differs between two drawings, bit for bit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from msgspec import Struct

from theditor.drawing.drawing import Drawing, Item
from theditor.spline import Curve
from theditor.spline.basis import Floats
from theditor.spline.changed import differing_rows

# A step can be taken to either side; everything it keeps is a pair (before, after), indexed by these.
_BEFORE, _AFTER = 0, 1
_NOTHING: tuple[dict[str, Any], dict[str, Any]] = ({}, {})


class _Rows(Struct, frozen=True, eq=False):
    """The rows of an array that differ."""

    indices: Any  # (k,) integers
    values: tuple[Floats, Floats]


class _Edit(Struct, frozen=True, eq=False):
    """One item that keeps most of its curve's rows."""

    start: tuple[int, int]
    points: _Rows
    lambdas: _Rows
    ends: tuple[dict[str, Any], dict[str, Any]]
    style: tuple[dict[str, Any], dict[str, Any]]

    def turned(self, drawing: Drawing, side: int) -> tuple[int, Sequence[Item]]:
        position = self.start[1 - side]
        item = drawing[position]
        curve = item.curve
        if self.ends[_BEFORE]:
            curve = curve.with_(**self.ends[side])
        if self.points.indices.size:
            curve = curve.with_points(self.points.indices, self.points.values[side])
        if self.lambdas.indices.size:
            curve = curve.with_lambdas(self.lambdas.indices, self.lambdas.values[side])
        return position + 1, [item.with_(curve=curve, **self.style[side])]


class _Splice(Struct, frozen=True, eq=False):
    """A run of items replaced by another run; either may be empty."""

    start: tuple[int, int]
    items: tuple[tuple[Item, ...], tuple[Item, ...]]

    def turned(self, drawing: Drawing, side: int) -> tuple[int, Sequence[Item]]:
        return self.start[1 - side] + len(self.items[1 - side]), self.items[side]


class Change(Struct, frozen=True, eq=False):
    """The difference of two drawings, which turns either into the other; made by `difference`.

    It keeps no reference to what both have in common, so a long history of small edits stays small.
    """

    _steps: tuple[_Edit | _Splice, ...]

    def apply(self, drawing: Drawing) -> Drawing:
        """Turn the drawing before into the one after, equal to it bit for bit."""
        return self._turned(drawing, _AFTER)

    def revert(self, drawing: Drawing) -> Drawing:
        """Turn the drawing after into the one before, equal to it bit for bit."""
        return self._turned(drawing, _BEFORE)

    def _turned(self, drawing: Drawing, side: int) -> Drawing:
        items: list[Item] = []
        position = 0
        for step in self._steps:
            items += drawing[position : step.start[1 - side]]
            position, replacement = step.turned(drawing, side)
            items += replacement
        return Drawing([*items, *drawing[position:]])


def difference(before: Drawing, after: Drawing) -> Change:
    """Find what turns one drawing into another.

    Items that are the same object in both cost nothing to compare and nothing to keep. Of an item edited in
    its place only the differing rows of points and λ are kept, unless they are more than half of either; of
    any other difference the items themselves, before and after.
    """
    return Change(tuple(_steps(before, after)))


def _steps(before: Drawing, after: Drawing) -> Iterator[_Edit | _Splice]:
    start, end = common_ends(before, after)
    old, new = before[start : len(before) - end], after[start : len(after) - end]
    from difflib import SequenceMatcher  # loaded when it is first asked for

    matcher = SequenceMatcher(None, [id(item) for item in old], [id(item) for item in new], autojunk=False)
    for tag, *places in matcher.get_opcodes():
        if tag == "equal":
            continue
        i, i_end, j, j_end = (place + start for place in places)
        if i_end - i == j_end - j:
            for k in range(i_end - i):
                yield from _edit((i + k, j + k), before[i + k], after[j + k])
        else:
            yield _Splice((i, j), (before[i:i_end], after[j:j_end]))


def common_ends(before: Sequence[Item], after: Sequence[Item]) -> tuple[int, int]:
    """Return how many items are the same objects at the start of both, and how many of the rest at the end."""
    shorter = min(len(before), len(after))
    start = next((i for i in range(shorter) if before[i] is not after[i]), shorter)
    rest = shorter - start
    return start, next((i for i in range(rest) if before[-1 - i] is not after[-1 - i]), rest)


def _edit(start: tuple[int, int], before: Item, after: Item) -> Iterator[_Edit | _Splice]:
    """Yield the one step that turns an item into another in the same place, or none if they are the same."""
    old, new = before.curve, after.curve
    if old.degree != new.degree or old.control_points.shape != new.control_points.shape:
        yield _Splice(start, ((before,), (after,)))
        return
    points = _differing_rows(old.control_points, new.control_points)
    lambdas = _differing_rows(old.lambdas, new.lambdas)
    ends = _differing(_ends(old), _ends(new))
    style = _differing(_style(before), _style(after))
    most = max(points.indices.size, lambdas.indices.size)
    if 2 * most > len(old.lambdas):
        yield _Splice(start, ((before,), (after,)))
    elif most or ends[_BEFORE] or style[_BEFORE]:
        yield _Edit(start, points, lambdas, ends, style)


def _ends(curve: Curve) -> dict[str, Any]:
    return {"closed": curve.closed, "ends": curve.ends}


def _style(item: Item) -> dict[str, Any]:
    return {name: getattr(item, name) for name in item.__struct_fields__ if name != "curve"}


def _differing(before: dict[str, Any], after: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return of two dictionaries with the same keys what differs: for most edits, nothing, which is kept once."""
    keys = [key for key in before if before[key] != after[key]]
    return ({key: before[key] for key in keys}, {key: after[key] for key in keys}) if keys else _NOTHING


def _differing_rows(before: Floats, after: Floats) -> _Rows:
    if before is after:
        before = after = before[:0]
    # Bits, not values: 0.0 and −0.0 are equal, and a file tells them apart.
    indices = differing_rows(before.view("i8"), after.view("i8"))
    return _Rows(indices, (before[indices], after[indices]))
