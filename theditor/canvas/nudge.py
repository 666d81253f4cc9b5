"""Moving the selected control points by keys."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QSettings, Qt

from theditor.canvas.grid import steps
from theditor.canvas.held import Held
from theditor.canvas.tool import Bench, Keys
from theditor.model.words import points_counted
from theditor.spline import MAX_COORDINATE

ARROWS: dict[int, tuple[float, float]] = {
    Qt.Key.Key_Left: (-1.0, 0.0),
    Qt.Key.Key_Right: (1.0, 0.0),
    Qt.Key.Key_Up: (0.0, 1.0),
    Qt.Key.Key_Down: (0.0, -1.0),
}


def nudge(bench: Bench, keys: Keys) -> bool:
    """Move the selected control points by an arrow key; returns whether there was something to move.

    The step is the preference ``nudge`` in units or, while that is not set, the distance of the grid's minor
    lines; ten of them with Shift; one pixel with Ctrl. Steps that follow each other are one undo step.
    """
    direction, chosen = ARROWS.get(keys.key), bench.selection.movable
    if direction is None or not chosen:
        return False
    scale = bench.view.plane.scale
    length = 1.0 / scale if keys.ctrl else step(scale)
    offset = np.array(direction) * length * (10 if keys.shift else 1)
    bench.document.settle()
    held = Held(bench.document.drawing, chosen)
    same = tuple((i, of.tobytes()) for i, of in chosen.items())
    bench.document.apply(f"Nudge {points_counted(chosen)}", held.at(held.places + offset), merge=same)
    return True


def step(scale: float) -> float:
    """The step of an arrow key at a scale in pixels per unit: the preferred one, else that of the grid."""
    return preferred_step() or steps(scale)[1]


def preferred_step() -> float:
    """The step that the user prefers, in units; 0 if none is set."""
    try:
        step = float(str(QSettings().value("nudge", 0.0)))
    except ValueError:
        return 0.0
    return step if 0.0 < step <= MAX_COORDINATE else 0.0
