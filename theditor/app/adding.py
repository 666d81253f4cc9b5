"""New curves come into the drawing on top of the others, and selected."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from theditor.drawing import Drawing, Item
from theditor.model.words import counted

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


def add_curves(window: MainWindow, verb: str, items: Sequence[Item]) -> None:
    """Add curves in one undo step, called by a verb such as ``"Paste"``, and select all their points."""
    window.document.settle()
    drawing = window.document.drawing
    what = "curve" if len(items) == 1 else counted(len(items), "curve")
    window.document.apply(f"{verb} {what}", Drawing([*drawing, *items]))
    new = {i: np.arange(len(item.curve.control_points)) for i, item in enumerate(items, len(drawing))}
    window.selection.select_across(new, len(drawing), ())
