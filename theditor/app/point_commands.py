"""The commands of the menu Point: control points more, fewer and elsewhere."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from theditor.app.command import Command, can_edit, plain
from theditor.canvas import arrange, points

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


def has_points(window: MainWindow) -> bool:
    """Needs a selected control point that may be changed."""
    return can_edit(window) and bool(window.selection.points)


def has_several(window: MainWindow) -> bool:
    """Needs two selected control points."""
    return can_edit(window) and len(window.selection.points) > 1


def has_many(window: MainWindow) -> bool:
    """Needs three selected control points."""
    return can_edit(window) and len(window.selection.points) > 2


def has_part(window: MainWindow) -> bool:
    """Needs a selected control point or segment that may be changed."""
    return can_edit(window) and bool(window.selection.points or window.selection.segments)


def point_commands(window: MainWindow) -> tuple[Command, ...]:
    """The rows of the table of commands that edit control points."""
    model = window.document, window.selection

    def said(edit: Callable[[], str]) -> Callable[[], None]:
        return lambda: window.announce(edit())

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
            can_edit,
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
            "insert_point",
            "Point",
            "&Insert control point",
            "Insert a control point into each selected segment, or beside the selected points, with the shape kept",
            said(lambda: points.insert(*model)),
            ("Ins",),
            has_part,
            on_canvas=True,
            places=("point", "segment"),
        ),
        Command(
            "delete_points",
            "Point",
            "&Delete control points",
            "Remove the selected control points and refit their neighbours; the curve goes if too few would stay",
            said(lambda: points.remove(*model, refit=True)),
            ("Delete", "Backspace"),
            has_points,
            on_canvas=True,
            places=("point",),
        ),
        Command(
            "delete_points_alone",
            "Point",
            "Delete, &leave the others",
            "Remove the selected control points and move no other; the curve goes if too few would stay",
            said(lambda: points.remove(*model, refit=False)),
            ("Ctrl+Delete",),
            has_points,
            on_canvas=True,
            places=("point",),
        ),
        flip(
            "flip_horizontally",
            "Flip &horizontally",
            "Mirror the selected points, or the whole curve, left to right",
            0,
            "Shift+H",
            gap=True,
        ),
        flip(
            "flip_vertically",
            "Flip &vertically",
            "Mirror the selected points, or the whole curve, top to bottom",
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
    )
