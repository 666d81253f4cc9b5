"""Curves cut, joined, opened, closed and changed in degree: one undo step and one sentence each."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np

from theditor.canvas.projection import projected
from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection, reshape
from theditor.model.naming import part_name
from theditor.model.words import indexed, shape_changed
from theditor.spline import Curve
from theditor.spline import pieces as edits


def split(document: Document, selection: Selection) -> str:
    """Cut the current curve at the joint of the selected point, or between two selected segments.

    Raises
    ------
    ValueError
        If no joint inside the curve is selected.
    """
    item, index = _current(selection), selection.curve
    joint = _joint(item.curve, selection)
    if item.curve.closed:
        return _open(document, selection, joint)
    first, second, deviation = edits.split(item.curve, joint)
    drawing = document.drawing.with_curve(index, first)
    name = part_name(item.name, {other.name for other in drawing})
    document.apply("Split curve", drawing.inserted(index + 1, item.with_(curve=second, name=name)))
    selection.select(points=(), segments=())
    return f"Split “{name}” off “{item.name}”; {shape_changed(deviation, item.curve)}"


def _joint(curve: Curve, selection: Selection) -> int:
    """The joint that is selected; a cubic's belongs to a control point, a quadratic's to the edge before it."""
    count, chosen = curve.segment_count, sorted(selection.segments)
    if len(selection.points) == 1:
        (point,) = selection.points
        joint = point - curve.first_segment
    elif len(chosen) == 2 and chosen[1] == chosen[0] + 1:
        joint = chosen[1]
    else:
        raise ValueError(
            "select one control point, or two segments that meet, to say at which joint to split"
        )
    if curve.closed:
        return joint % count
    if not 0 < joint < count:
        raise ValueError(
            f"no two segments meet at {indexed('P', joint + curve.first_segment)}: select another"
        )
    return joint


def join(document: Document, selection: Selection) -> str:
    """Join the current curve with the open curve whose end is nearest to its own, or with a selected one.

    Raises
    ------
    ValueError
        If there is no such curve of the same degree and dimension.
    """
    item, index = _current(selection), selection.curve
    others = [i for i in selection.curves if i != index] or range(len(document.drawing))
    other, a, b = _nearest_ends(document.drawing, index, others)
    curve, deviation = edits.join(a, b)
    name = document.drawing[other].name
    document.apply("Join curves", document.drawing.with_curve(index, curve).without(other))
    selection.select(curve=index - (other < index), points=(), segments=())
    return f"Joined “{item.name}” and “{name}”; {shape_changed(deviation, curve)}"


def _nearest_ends(drawing: Drawing, index: int, others: Iterable[int]) -> tuple[int, Curve, Curve]:
    """Which of the others, and both curves turned so that the first's end is the one nearest to the second's start."""
    own = drawing[index].curve
    if own.closed:
        raise ValueError("a closed curve has no end to join: open it first")
    best: tuple[float, int, Curve, Curve] | None = None
    for i in others:
        item, curve = drawing[i], drawing[i].curve
        if i == index or item.locked or not item.visible or curve.closed:
            continue
        if (curve.degree, curve.dimension) != (own.degree, own.dimension):
            continue
        for a, b in ((own, curve), (curve, own), (own, curve.reversed()), (own.reversed(), curve)):
            gap = float(np.hypot(*(projected(a)(a.segment_count) - projected(b)(0))))
            if best is None or gap < best[0]:
                best = gap, i, a, b
    if best is None:
        kind = "quadratic" if own.degree == 2 else "cubic"
        raise ValueError(
            f"there is no other open {kind} curve to join with: draw one, or change the degree of one"
        )
    return best[1:]


def close_or_open(document: Document, selection: Selection, tell: Callable[[str], None]) -> None:
    """Close the selected curves or, if the current one is closed, open that at the selected joint or its beginning."""
    curve = _current(selection).curve
    if curve.closed:
        tell(_open(document, selection, _joint(curve, selection) if selection.points else 0))
    else:
        reshape.close(document, selection, tell)


def _open(document: Document, selection: Selection, joint: int) -> str:
    curve = _current(selection).curve
    new, deviation = edits.opened(curve, joint)
    document.apply_curve("Open curve", selection.curve, new)
    selection.select(points=(), segments=())
    return f"Opened the curve; {shape_changed(deviation, curve)}"


def clamp_or_free(document: Document, selection: Selection, tell: Callable[[str], None]) -> None:
    """Clamp the ends of the selected curves or, if the current one's are clamped, free them."""
    curve = _current(selection).curve
    clamped = curve.ends == "clamped" and not curve.closed
    reshape.set_ends(document, selection, "free" if clamped else "clamped", tell)


def change_degree(document: Document, selection: Selection, tell: Callable[[str], None]) -> None:
    """Make the selected curves cubic or, if the current one is, quadratic."""
    reshape.set_degree(document, selection, 5 - _current(selection).curve.degree, tell)


def _current(selection: Selection) -> Item:
    item = selection.item
    assert item is not None, "what is edited is there"
    return item
