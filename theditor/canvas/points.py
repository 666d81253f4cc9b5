"""Control points more and fewer: each edit of the current curve is one undo step and one sentence."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.viewport import Floats
from theditor.drawing import Drawing
from theditor.model import Document, Selection
from theditor.model.long_edits import edit_curves
from theditor.model.words import counted, indexed, listed, points_counted, shape_changed, symbols
from theditor.model.worker import Report, part_of
from theditor.spline import Curve, corners, fewest_points
from theditor.spline import points as edits
from theditor.spline.points import Edited

MOST_NAMED = 3
"""More curves than this are counted, not named."""


AT_ONCE = 20
"""When points go in or out at more places than this, it is long work."""
FEW = 100
"""The same when more go out than this."""

Tell = Callable[[str], None]


def insert_at(document: Document, selection: Selection, u: float, tell: Tell) -> None:
    """Insert a control point where the current curve's parameter is `u`; tell what happened."""
    _insert(document, selection, {selection.curve: [u]}, tell)


def insert(document: Document, selection: Selection, tell: Tell) -> None:
    """Insert control points into the selected segments, else between or after the selected points of each curve."""
    item = selection.item
    if selection.segments and item is not None and not item.locked:
        _insert(document, selection, {selection.curve: [s + 0.5 for s in selection.segments]}, tell)
        return
    places: dict[int, list[float]] = {}
    for i, of in selection.movable.items():
        curve = selection.drawing[i].curve
        places[i] = [_middle(curve, edge) for edge in _edges(curve, frozenset(of.tolist()))]
    _insert(document, selection, places, tell)


class _Inserted(NamedTuple):
    """A curve with more control points: which are new, and how far its shape is from what it was at most."""

    curve: Curve
    new: list[int]
    change: float


def _insert(document: Document, selection: Selection, places: Mapping[int, list[float]], tell: Tell) -> None:
    document.settle()
    drawing, count = document.drawing, sum(map(len, places.values()))

    def edit(report: Report) -> dict[int, _Inserted]:
        done = 0
        edited = {}
        for i, at in places.items():
            edited[i] = _inserted(drawing[i].curve, at, part_of(report, done, count))
            done += len(at)
        return edited

    chosen = selection.chosen

    def finish(edited: dict[int, _Inserted]) -> str:
        untouched = selection.chosen is chosen  # what was selected meanwhile stays so
        new = {i: result.new for i, result in edited.items()}
        curves = {i: result.curve for i, result in edited.items()}
        change = max((result.change for result in edited.values()), default=0.0)
        document.apply(f"Insert {points_counted(new)}", document.drawing.with_curves(curves))
        if untouched:
            selection.select_across(new, selection.curve, ())
        names = symbols("P", new[selection.curve]) if len(new) == 1 and selection.curve in new else ""
        return f"Inserted {names or points_counted(new)}; {shape_changed(change, *curves.values())}"

    words = f"Inserting {counted(count, 'control point')}"
    edit_curves(document, places, words, edit, finish, tell, long=count > AT_ONCE)


def _inserted(curve: Curve, places: list[float], report: Report) -> _Inserted:
    """Insert from the last place to the first, so that those to come stay where they are; many all together."""
    change = 0.0
    places = sorted(places, reverse=True)
    new = np.sort([edits.edge_at(curve, u) + 1 for u in places]) + np.arange(len(places))
    if len(places) > AT_ONCE:
        curve, change = edits.insert_many(curve, places, lambda share: report(share * len(places)))
        return _Inserted(curve, new.tolist(), change)
    for number, u in enumerate(places):
        report(number)
        curve, deviation = edits.insert(curve, u)
        change += deviation
    return _Inserted(curve, new.tolist(), change)


def insert_on_edge(document: Document, selection: Selection, edge: int, fraction: float) -> str:
    """Insert a control point on an edge of the current curve's polygon; all others stay."""
    item = selection.item
    assert item is not None, "the polygon is the current curve's"
    curve, deviation = edits.insert_on_edge(item.curve, edge, fraction)
    document.apply_curve("Insert control point", selection.curve, curve)
    selection.select(points={edge + 1}, segments=())
    return f"Inserted {indexed('P', edge + 1)} on the polygon; {shape_changed(deviation, curve)}"


def remove(document: Document, selection: Selection, tell: Tell, *, refit: bool) -> None:
    """Remove the selected control points, of all curves; a curve on which too few would stay goes whole."""
    document.settle()
    drawing, chosen, gone = document.drawing, selection.movable, doomed(selection)
    fewer = {i: of for i, of in chosen.items() if i not in gone}
    runs = {i: 1 + int(np.count_nonzero(np.diff(of) > 1)) for i, of in fewer.items()}
    count = sum(runs.values())

    def edit(report: Report) -> dict[int, Edited]:
        done = 0
        edited = {}
        for i, of in fewer.items():
            edited[i] = edits.remove(drawing[i].curve, of, refit, part_of(report, done, count))
            done += runs[i]
        return edited

    def finish(edited: dict[int, Edited]) -> str:
        new = {i: result.curve for i, result in edited.items()}
        deviation = max((result.deviation for result in edited.values()), default=0.0)
        told = []
        text = f"Delete {points_counted(chosen)}"
        if new:
            gone_points = counted(sum(map(len, fewer.values())), "control point")
            told.append(f"Deleted {gone_points}; {shape_changed(deviation, *new.values())}")
        else:
            text = "Delete curve" if len(gone) == 1 else f"Delete {len(gone)} curves"
        if gone:
            names = [f"“{drawing[i].name}”" for i in gone]
            deleted = counted(len(gone), "curve") if len(gone) > MOST_NAMED else listed(names)
            told.append(f"Deleted {deleted}: too few control points would have stayed")
        left = document.drawing.with_curves(new)
        document.apply(text, Drawing(item for i, item in enumerate(left) if i not in gone))
        selection.select(points=(), segments=())
        return ". ".join(told)

    words = f"Deleting {points_counted(chosen)}"
    edit_curves(
        document,
        chosen,
        words,
        edit,
        finish,
        tell,
        long=count > AT_ONCE or sum(map(len, fewer.values())) > FEW,
    )


def make_corners(document: Document, selection: Selection) -> str:
    """Make a corner at each selected control point.

    Raises
    ------
    ValueError
        If one of them is the end of an open curve.
    """
    told = "Made a corner at", "there is a corner at"
    return _each(document, selection, corners.corner, "Make corner", told)


def make_smooth(document: Document, selection: Selection) -> str:
    """Take the corners at the selected control points away.

    Raises
    ------
    ValueError
        If fewer control points would stay than the curve needs.
    """
    told = "Made the curve smooth at", "the curve is smooth at"
    return _each(document, selection, corners.smooth, "Make smooth", told)


def _each(
    document: Document,
    selection: Selection,
    edit: Callable[[Curve, NDArray[np.intp]], Curve],
    text: str,
    told: tuple[str, str],
) -> str:
    """Edit the curves at the selected places; points in one place count once. Told is what was done, or what is so."""
    document.settle()
    drawing = document.drawing
    chosen = selection.movable
    new = {i: edit(drawing[i].curve, of) for i, of in chosen.items()}
    places = {i: _apart(drawing[i].curve, of.tolist()) for i, of in chosen.items()}
    named = symbols("P", places[selection.curve]) if [*places] == [selection.curve] else ""
    after = drawing.with_curves(new)
    if after == drawing:
        return f"Nothing changed: {told[1]} {named or points_counted(places)} already"
    document.apply(text, after)
    now = {i: corners.kept_places(drawing[i].curve, curve, chosen[i]) for i, curve in new.items()}
    selection.select_across(now, segments=())
    return f"{told[0]} {named or points_counted(places)}"


def _apart(curve: Curve, chosen: list[int]) -> list[int]:
    """Of control points that follow each other in one place, only the first."""
    points, known = curve.control_points, set(chosen)
    return [i for i in chosen if i - 1 not in known or (points[i] != points[i - 1]).any()]


def takes_the_curve(curve: Curve, count: int) -> bool:
    """Whether a curve without `count` of its control points would be none."""
    return len(curve.control_points) - count < fewest_points(curve.degree, curve.closed, curve.ends)


def doomed(selection: Selection) -> list[int]:
    """The curves that would be none without their selected control points."""
    chosen = selection.movable.items()
    return [i for i, of in chosen if takes_the_curve(selection.drawing[i].curve, len(of))]


def near_edge(polygon: Floats, at: Floats, reach: float) -> tuple[int, float] | None:
    """The edge of a polygon (n, 2) nearest to `at` (2,), and how far along it; None beyond `reach`."""
    start, along = polygon[:-1], np.diff(polygon, axis=0)
    squares = (along**2).sum(axis=1)
    f = (((at - start) * along).sum(axis=1) / np.where(squares > 0, squares, 1.0)).clip(0.0, 1.0)
    distances = np.hypot(*(start + f[:, None] * along - at).T)
    edge = int(np.argmin(distances))
    return (edge, float(f[edge])) if distances[edge] <= reach else None


def _middle(curve: Curve, edge: int) -> float:
    """The parameter at the middle of the curve's part that belongs to an edge."""
    u = edge - curve.first_segment + (1.0 if curve.degree == 2 else 0.5)
    count = curve.segment_count
    return u % count if curve.closed else min(max(u, 0.0), float(count))


def _edges(curve: Curve, points: frozenset[int]) -> list[int]:
    """The edges between neighbouring points of some; if there are none, those after (or before) each."""
    count = len(curve.control_points)
    last = count if curve.closed else count - 1
    between = [i for i in points if i < last and (i + 1) % count in points]
    return between or sorted({min(i, last - 1) for i in points})
