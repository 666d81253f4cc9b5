"""How a control turns asked-for λ into edits of the current curve: one gesture, or one merging step.

Linked λ keep their differences: a control shows their mean and moves all of them by as much.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.model import Document, Gesture, Selection, words
from theditor.panels.lambda_scale import stepped
from theditor.spline import MAX_LAMBDA, Curve

TEXT = "Change λ"


def editable(selection: Selection) -> NDArray[np.intp]:
    """Control points whose λ the controls change: of those they act on, the active ones; none if locked."""
    item = selection.item
    if item is None or item.locked:
        return np.empty(0, dtype=np.intp)
    indices = selection.lambda_indices()
    return indices[item.curve.active_lambdas[indices]]


def obstacle(selection: Selection) -> str:
    """Say why the controls can change no λ, and the cure; nothing if they can."""
    item = selection.item
    if item is None:
        return "There is no curve: add one in the list of curves."
    if item.locked:
        return words.locked_reason(item.name)
    if not editable(selection).size:
        return words.inactive_reason(item.curve, selection.lambda_indices().tolist())
    return ""


def mean(values: NDArray[np.float64]) -> float:
    """Return the mean of some λ: exactly the common value if there is one."""
    return float(values[0] if (values == values[0]).all() else values.mean())


def asked(values: NDArray[np.float64], value: float, linked: bool) -> NDArray[np.float64]:
    """Return what λ become when a control asks for a value: equal to it or, linked, that in the mean."""
    return moved_together(values, value) if linked and values.size else np.full_like(values, value)


def moved_together(values: NDArray[np.float64], new_mean: float) -> NDArray[np.float64]:
    """Return λ with their differences kept and another mean, or as near to it as ±`MAX_LAMBDA` allows."""
    if (values == values[0]).all():
        return np.full_like(values, new_mean)
    shift = np.clip(new_mean - mean(values), -MAX_LAMBDA - values.min(), MAX_LAMBDA - values.max())
    moved: NDArray[np.float64] = np.clip(values + shift, -MAX_LAMBDA, MAX_LAMBDA)
    return moved


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

    @property
    def before(self) -> Curve:
        """The curve at the press."""
        return self._gesture.before[self._curve].curve

    def preview(self, indices: ArrayLike, values: ArrayLike) -> None:
        """Show the curve with these λ; the others are as they were at the press. Ignored once it is over."""
        if not self.is_open:
            return
        curve = self.before.with_lambdas(indices, values)
        self._gesture.preview(self._gesture.before.with_curve(self._curve, curve))


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
    document: Document,
    selection: Selection,
    indices: NDArray[np.intp],
    count: int,
    *,
    fine: bool = False,
    linked: bool = False,
) -> None:
    """Move every λ by `count` steps of the scale; a run of steps is one undo step.

    Each steps from where it is or, linked, their mean does and takes them along.
    """
    item = selection.item
    if item is None or not indices.size:
        return
    values = item.curve.lambdas[indices]
    if linked:
        new = moved_together(values, float(stepped(mean(values), count, item.curve.degree, fine)))
    else:
        new = stepped(values, count, item.curve.degree, fine)
    set_lambdas(document, selection, indices, new, run=True)
