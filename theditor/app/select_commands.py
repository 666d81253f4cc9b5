"""The commands that select control points by themselves: all, none, the others."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtGui import QKeySequence

from theditor.app.command import Command, can_edit, has_curve
from theditor.canvas.held import every_point

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

_Standard = QKeySequence.StandardKey


def has_selection(window: MainWindow) -> bool:
    """Needs a selected point or segment, or a curve beside the current one."""
    selection = window.selection
    return bool(selection.count or selection.segments or len(selection.curves) > 1)


def select_all(window: MainWindow) -> None:
    """Select every control point of the selected curves or, in the list of curves, every curve."""
    if window.curves.list.hasFocus():
        window.curves.list.selectAll()
        return
    selection = window.selection
    chosen = {**selection.chosen, **every_point(window.document.drawing, selection.curves)}
    selection.select_across(chosen, segments=())


def select_all_curves(window: MainWindow) -> None:
    """Select every control point of all curves that are visible and not locked."""
    window.selection.select_across(every_point(window.document.drawing), segments=())


def select_none(window: MainWindow) -> None:
    """Select no point and no segment."""
    window.selection.select(points=(), segments=())


def invert_selection(window: MainWindow) -> None:
    """Select just those control points of the selected curves that are not selected."""
    every, chosen = every_point(window.document.drawing), window.selection.chosen
    new = {i: np.delete(every[i], of) for i, of in chosen.items() if i in every}
    window.selection.select_across({**chosen, **new}, segments=())


def select_commands(window: MainWindow) -> tuple[Command, ...]:
    """The rows of the table of commands that select."""
    return (
        Command(
            "select_all",
            "Edit",
            "Select &all",
            "Select all control points of the selected curves",
            lambda: select_all(window),
            (_Standard.SelectAll,),
            has_curve,
            places=("point", "segment", "ground"),
            gap=True,
        ),
        Command(
            "select_all_curves",
            "Edit",
            "Select all on all &curves",
            "Select all control points of every curve that is visible and not locked",
            lambda: select_all_curves(window),
            ("Ctrl+Alt+A",),
            has_curve,
        ),
        Command(
            "select_none",
            "Edit",
            "Select &none",
            "Select no control point and no segment",
            lambda: select_none(window),
            ("Ctrl+Shift+A",),
            has_selection,
        ),
        Command(
            "invert",
            "Edit",
            "&Invert selection",
            "Select just those control points of the selected curves that are not selected",
            lambda: invert_selection(window),
            ("Ctrl+Shift+I",),
            can_edit,
            places=("point",),
        ),
    )
