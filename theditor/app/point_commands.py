"""The commands that edit control points, more, fewer and elsewhere, and what curves are made of."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from theditor.app.command import Command, can_edit, plain
from theditor.canvas import arrange, pieces, points
from theditor.model.words import sentence

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


def has_points(window: MainWindow) -> bool:
    """Needs a selected control point that may be changed."""
    return bool(window.selection.movable)


def has_several(window: MainWindow) -> bool:
    """Needs two selected control points."""
    return _movable(window) > 1


def has_many(window: MainWindow) -> bool:
    """Needs three selected control points."""
    return _movable(window) > 2


def _movable(window: MainWindow) -> int:
    return sum(map(len, window.selection.movable.values()))


def has_something(window: MainWindow) -> bool:
    """Needs control points to arrange: selected ones, or a curve that is visible and not locked."""
    return bool(window.selection.in_hand)


def has_part(window: MainWindow) -> bool:
    """Needs a selected control point or segment that may be changed."""
    return has_points(window) or (can_edit(window) and bool(window.selection.segments))


def has_place(window: MainWindow) -> bool:
    """Needs a selected control point or segment on the current curve, which is not locked."""
    return can_edit(window) and bool(window.selection.points or window.selection.segments)


def can_join(window: MainWindow) -> bool:
    """Needs an open curve that may be changed, and another one."""
    item = window.selection.item
    return (
        can_edit(window) and item is not None and not item.curve.closed and len(window.document.drawing) > 1
    )


def point_commands(window: MainWindow) -> tuple[Command, ...]:
    """The rows of the table of commands that edit control points."""
    model = window.document, window.selection

    def told(edit: Callable[[Callable[[str], None]], None]) -> Callable[[], None]:
        """An edit that tells what happened, or why it cannot be."""

        def run() -> None:
            try:
                edit(window.announce)
            except ValueError as error:
                window.announce(sentence(str(error)))

        return run

    def said(edit: Callable[[], str]) -> Callable[[], None]:
        return told(lambda tell: tell(edit()))

    def arranged(title: str, how: arrange.Arrange) -> Callable[[], None]:
        return lambda: arrange.arrange(*model, title, how)

    def flip(name: str, text: str, tip: str, axis: int, key: str, *, gap: bool = False) -> Command:
        return Command(
            name,
            "Point",
            text,
            tip,
            arranged(plain(text), arrange.flipped(axis)),
            (key,),
            has_something,
            on_canvas=True,
            gap=gap,
        )

    def align(name: str, text: str, tip: str, axis: int, share: float) -> Command:
        run = arranged(f"Align {plain(text).lower()}", arrange.aligned(axis, share))
        return Command(name, "Point/Align", text, tip, run, enabled=has_several)

    def distribute(name: str, text: str, tip: str, axis: int) -> Command:
        run = arranged(f"Distribute {plain(text).lower()}", arrange.distributed(axis))
        return Command(name, "Point/Distribute", text, tip, run, enabled=has_many)

    return (
        Command(
            "coordinates",
            "Point",
            "T&ype coordinates",
            "Type x and y of the selected points: a number, 2/3, +1.5 or *2; several are moved together",
            window.coordinates.edit,
            ("Return", "Enter"),
            has_points,
            on_canvas=True,
            places=("point",),
        ),
        Command(
            "insert_point",
            "Point",
            "&Insert control point",
            "Insert a control point into each selected segment, or beside the selected points, with the shape kept",
            told(lambda tell: points.insert(*model, tell)),
            ("Ins",),
            has_part,
            on_canvas=True,
            places=("point", "segment"),
            icon="insert_point",
        ),
        Command(
            "delete_points",
            "Point",
            "De&lete control points",
            "Remove the selected control points and refit their neighbours; the curve goes if too few would stay",
            told(lambda tell: points.remove(*model, tell, refit=True)),
            ("Delete", "Backspace"),
            has_points,
            on_canvas=True,
            places=("point",),
            icon="delete",
        ),
        Command(
            "delete_points_alone",
            "Point",
            "Delete, leave the &others",
            "Remove the selected control points and move no other; the curve goes if too few would stay",
            told(lambda tell: points.remove(*model, tell, refit=False)),
            ("Ctrl+Delete",),
            has_points,
            on_canvas=True,
        ),
        Command(
            "corner",
            "Point",
            "Make a &corner",
            "Repeat the selected control points, so that the curve has corners there",
            said(lambda: points.make_corners(*model)),
            ("Shift+C",),
            has_points,
            on_canvas=True,
            places=("point",),
            gap=True,
            icon="corner",
        ),
        Command(
            "smooth_point",
            "Point",
            "Make &smooth",
            "Take repeated control points away, so that the curve has no corner there",
            said(lambda: points.make_smooth(*model)),
            ("Shift+S",),
            has_points,
            on_canvas=True,
            places=("point",),
            icon="smooth",
        ),
        flip(
            "flip_horizontally",
            "Flip &horizontally",
            "Mirror the selected points, or the selected curves, left to right",
            0,
            "Shift+H",
            gap=True,
        ),
        flip(
            "flip_vertically",
            "Flip &vertically",
            "Mirror the selected points, or the selected curves, top to bottom",
            1,
            "Shift+V",
        ),
        align("align_left", "&Left", "Move the selected points below the leftmost", 0, 0.0),
        align(
            "align_centre",
            "&Centre",
            "Move the selected points onto one upright line in their middle",
            0,
            0.5,
        ),
        align("align_right", "&Right", "Move the selected points below the rightmost", 0, 1.0),
        align("align_top", "&Top", "Move the selected points beside the topmost", 1, 1.0),
        align(
            "align_middle", "&Middle", "Move the selected points onto one level line in their middle", 1, 0.5
        ),
        align("align_bottom", "&Bottom", "Move the selected points beside the lowest", 1, 0.0),
        distribute(
            "distribute_horizontally",
            "&Horizontally",
            "Space the selected points evenly from left to right",
            0,
        ),
        distribute(
            "distribute_vertically", "&Vertically", "Space the selected points evenly from bottom to top", 1
        ),
        Command(
            "split",
            "Curve/Pieces",
            "Split at the &joint",
            "Cut the curve at the joint of the selected control point, or between two selected segments",
            said(lambda: pieces.split(*model)),
            ("Shift+B",),
            has_place,
            on_canvas=True,
            places=("point", "segment"),
            icon="split",
        ),
        Command(
            "join",
            "Curve/Pieces",
            "Join with the &nearest end",
            "Join the curve with the open curve, of those selected if any are, whose end is nearest to one of its own",
            said(lambda: pieces.join(*model)),
            ("Shift+J",),
            can_join,
            on_canvas=True,
            places=("curve",),
            icon="join",
        ),
        Command(
            "close_or_open",
            "Curve/Pieces",
            "Cl&ose or open",
            "Close the curve or, if it is closed, open it at the selected joint; the shape is kept as well as possible",
            told(lambda tell: pieces.close_or_open(*model, tell)),
            enabled=can_edit,
            places=("curve",),
        ),
        Command(
            "clamp_or_free",
            "Curve/Pieces",
            "Cla&mp or free the ends",
            "End at the outer control points or, if that is so, freely; the shape is kept as well as possible",
            told(lambda tell: pieces.clamp_or_free(*model, tell)),
            enabled=can_edit,
            places=("curve",),
        ),
        Command(
            "change_degree",
            "Curve/Pieces",
            "Chan&ge degree",
            "Make a cubic curve quadratic, a quadratic one cubic; the shape is kept as well as possible",
            told(lambda tell: pieces.change_degree(*model, tell)),
            enabled=can_edit,
            places=("curve",),
        ),
    )
