"""How a control turns asked-for λ into edits of the current curve: one gesture, or one merging step."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.drawing import Drawing
from theditor.model import Document, Gesture, Selection
from theditor.panels.lambda_scale import stepped

TEXT = "Change λ"


def editable(selection: Selection) -> NDArray[np.intp]:
    """Control points whose λ the controls change: of those they act on, the active ones; none if locked."""
    item = selection.item
    if item is None or item.locked:
        return np.empty(0, dtype=np.intp)
    indices = selection.lambda_indices()
    return indices[item.curve.active_lambdas[indices]]


class LambdaGesture:
    """A drag over λ: every preview is built from the drawing at the press."""

    def __init__(self, document: Document, selection: Selection) -> None:
        self._curve = selection.curve
        self._gesture: Gesture = document.begin(TEXT)
        self.commit = self._gesture.commit
        self.cancel = self._gesture.cancel

    @property
    def is_open(self) -> bool:
        """Whether the hand is still on it: saving, undo or another file may have ended it."""
        return self._gesture.is_open

    def preview(self, indices: ArrayLike, values: ArrayLike) -> None:
        """Show the curve with these λ; the others are as they were at the press. Ignored once it is over."""
        if not self.is_open:
            return
        before: Drawing = self._gesture.before
        curve = before[self._curve].curve.with_lambdas(indices, values)
        self._gesture.preview(before.with_curve(self._curve, curve))


def set_lambdas(
    document: Document,
    selection: Selection,
    indices: NDArray[np.intp],
    values: ArrayLike,
    *,
    run: bool = False,
) -> None:
    """Set λ in one undo step; steps of a `run` on the same points merge."""
    item = selection.item
    if item is None or not indices.size:
        return
    curve = item.curve.with_lambdas(indices, values)
    document.apply_curve(TEXT, selection.curve, curve, merge=indices.tobytes() if run else None)


def step_lambdas(
    document: Document, selection: Selection, indices: NDArray[np.intp], count: int, *, fine: bool = False
) -> None:
    """Move every λ by `count` steps of the scale, each from where it is; a run of steps is one undo step."""
    item = selection.item
    if item is not None:
        values = stepped(item.curve.lambdas[indices], count, item.curve.degree, fine)
        set_lambdas(document, selection, indices, values, run=True)
