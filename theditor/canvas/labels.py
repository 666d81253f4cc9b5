"""The names P₀, P₁ … beside the control points: where they go, and painting them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter

from theditor.model.colours import Colours

Floats = NDArray[np.float64]

MOST = 80
"""More visible control points than this are too crowded for labels."""

_TURNS = np.deg2rad(np.arange(0, 360, 45))
DIRECTIONS = np.stack([np.cos(_TURNS), np.sin(_TURNS)], axis=1)


def place(handles: Floats, sizes: Floats, obstacles: Floats, clearance: float = 9.0) -> list[Floats | None]:
    """Centres for labels beside handles, clear of each other, of all handles and, where possible, of the curve.

    Parameters
    ----------
    handles : (n, 2)
        Where the labelled points are, in the polygon's order.
    sizes : (n, 2)
        Width and height of each label.
    obstacles : (k, 2)
        Points on the curve.
    clearance
        Distance from a handle's centre to the label's box.

    Returns
    -------
    list
        The centre of each label, None where there is no room.
    """
    half = sizes[:, None] / 2
    order = np.argsort(-(_outward(handles) @ DIRECTIONS.T), axis=1, kind="stable")
    directions = DIRECTIONS[order]  # (n, 8, 2), of each handle the best first
    reach = clearance + (np.abs(directions) * half).sum(axis=2, keepdims=True)
    centres = handles[:, None] + directions * reach
    low, high = centres - half, centres + half
    hiding = _contain(low - 2, high + 2, obstacles)
    around = np.hstack([handles - 6.0, handles + 6.0])
    taken: list[Floats] = []
    result: list[Floats | None] = []
    for i in range(len(handles)):
        others = np.vstack([np.delete(around, i, axis=0), *taken])
        rank = np.where(_meet(low[i], high[i], others), 2, hiding[i])
        best = int(rank.argmin())
        if rank[best] == 2:
            result.append(None)
        else:
            result.append(centres[i, best])
            taken.append(np.concatenate([low[i, best], high[i, best]]))
    return result


def _outward(handles: Floats) -> Floats:
    """Away from the neighbours in the polygon; up and right where that says nothing."""
    before, after = np.roll(handles, 1, axis=0), np.roll(handles, -1, axis=0)
    if len(handles):
        before[0], after[-1] = handles[0], handles[-1]
    away: Floats = _unit(handles - before) + _unit(handles - after) + np.array([0.15, -0.15])
    return away


def _unit(vectors: Floats) -> Floats:
    lengths: Floats = np.hypot(*vectors.T)[:, None]
    unit: Floats = vectors / np.where(lengths > 0, lengths, 1.0)
    return unit


def _meet(low: Floats, high: Floats, boxes: Floats) -> NDArray[np.bool_]:
    """Which of some boxes (..., 2) meet one of others (n, 4)."""
    left, top, right, bottom = boxes.T
    (x, y), (x_end, y_end) = np.moveaxis(low, -1, 0)[..., None], np.moveaxis(high, -1, 0)[..., None]
    found: NDArray[np.bool_] = np.any((left < x_end) & (right > x) & (top < y_end) & (bottom > y), axis=-1)
    return found


def _contain(low: Floats, high: Floats, points: Floats) -> NDArray[np.bool_]:
    """Which of some boxes (..., 2) contain one of some points (n, 2)."""
    return _meet(low, high, np.hstack([points, points]))


def paint_labels(
    painter: QPainter,
    indices: list[int],
    handles: Floats,
    obstacles: Floats,
    selected: frozenset[int],
    colours: Colours,
    font: QFont,
) -> None:
    """Paint the labels of control points `indices` at `handles` (n, 2) where there is room."""
    letter, subscript = QFont(font), QFont(font)
    letter.setPixelSize(13)
    letter.setItalic(True)
    subscript.setPixelSize(9)
    letter_metrics, subscript_metrics = QFontMetricsF(letter), QFontMetricsF(subscript)
    first = letter_metrics.horizontalAdvance("P") + 1
    widths = [first + subscript_metrics.horizontalAdvance(str(i)) for i in indices]
    height = letter_metrics.ascent() + 3
    sizes = np.array([(width, height) for width in widths]).reshape(-1, 2)
    for i, size, centre in zip(indices, sizes, place(handles, sizes, obstacles), strict=True):
        if centre is None:
            continue
        x, top = centre - size / 2
        baseline = top + letter_metrics.ascent() - 1
        painter.setPen(QColor(colours.accent_text if i in selected else colours.secondary))
        painter.setFont(letter)
        painter.drawText(QPointF(x, baseline), "P")
        painter.setFont(subscript)
        painter.drawText(QPointF(x + first, baseline + 3), str(i))
