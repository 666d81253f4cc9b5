"""How a control turns asked-for λ into edits of the selected curves: one gesture, or one merging step.

Linked λ keep their differences: a control shows their mean and moves all of them by as much.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.drawing import Drawing
from theditor.model import Document, Gesture, Selection, words
from theditor.panels.lambda_scale import stepped
from theditor.spline import MAX_LAMBDA, Curve, Mode, lambda_of

TEXT = "Change λ"


def editable(selection: Selection) -> NDArray[np.intp]:
    """Control points of the current curve whose λ the controls change: the active ones; none if it is locked."""
    item = selection.item
    if item is None or item.locked:
        return np.empty(0, dtype=np.intp)
    indices = selection.lambda_indices()
    return indices[item.curve.active_lambdas[indices]]


class Targets:
    """λ of control points on one or several curves of a drawing, as one row of values."""

    def __init__(self, points: Mapping[int, Sequence[int] | NDArray[np.intp]]) -> None:
        self.points = {curve: of for curve, of in points.items() if len(of)}
        self.size = sum(map(len, self.points.values()))

    def values(self, drawing: Drawing) -> NDArray[np.float64]:
        """The λ as they are."""
        parts = [drawing[curve].curve.lambdas[of] for curve, of in self.points.items()]
        return np.concatenate(parts) if parts else np.empty(0)

    def curves(self, drawing: Drawing) -> list[Curve]:
        """The curves that they are on."""
        return [drawing[curve].curve for curve in self.points]

    def of_mode(self, drawing: Drawing, mode: Mode) -> NDArray[np.float64]:
        """What each λ is in a mode; λ* depends on the curve's degree."""
        each = [np.full(len(of), lambda_of(mode, drawing[i].curve.degree)) for i, of in self.points.items()]
        return np.concatenate(each) if each else np.empty(0)

    def set_to(self, drawing: Drawing, values: ArrayLike) -> Drawing:
        """The drawing with other values of the λ, one for all or one for each."""
        row = np.broadcast_to(np.asarray(values, dtype=np.float64), self.size)
        curves: dict[int, Curve] = {}
        start = 0
        for i, of in self.points.items():
            curves[i] = drawing[i].curve.with_lambdas(of, row[start : start + len(of)])
            start += len(of)
        return drawing.with_curves(curves)


def targets(selection: Selection) -> Targets:
    """The λ that the controls change, on all selected curves: the active ones of those they act on."""
    drawing = selection.drawing
    found = {i: of for i, of in selection.lambdas_across().items() if not drawing[i].locked}
    return Targets({i: of[drawing[i].curve.active_lambdas[of]] for i, of in found.items()})


def obstacle(selection: Selection) -> str:
    """Say why the controls can change no λ, and the cure; nothing if they can."""
    item = selection.item
    if item is None:
        return "There is no curve: add one in the list of curves."
    if targets(selection).size:
        return ""
    if item.locked:
        return words.locked_reason(item.name)
    return words.inactive_reason(item.curve, selection.lambda_indices().tolist())


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

    def __init__(self, document: Document) -> None:
        self._gesture: Gesture = document.begin(TEXT)
        self.commit = self._gesture.commit
        self.cancel = self._gesture.cancel

    @property
    def is_open(self) -> bool:
        """Whether the hand is still on it: saving, undo or another file may have ended it."""
        return self._gesture.is_open

    @property
    def before(self) -> Drawing:
        """The drawing at the press."""
        return self._gesture.before

    def preview(self, targets: Targets, values: ArrayLike) -> None:
        """Show these λ; the others are as they were at the press. Ignored once it is over."""
        if self.is_open:
            self._gesture.preview(targets.set_to(self.before, values))


def set_lambdas(document: Document, targets: Targets, values: ArrayLike, *, run: bool = False) -> None:
    """Set λ in one undo step; steps of a `run` on the same points merge."""
    if targets.size:
        document.settle()
        same = tuple((curve, bytes(np.asarray(of))) for curve, of in targets.points.items())
        document.apply(TEXT, targets.set_to(document.drawing, values), merge=same if run else None)


def step_lambdas(
    document: Document, targets: Targets, count: int, *, fine: bool = False, linked: bool = False
) -> None:
    """Move every λ by `count` steps of the scale; a run of steps is one undo step.

    Each steps from where it is or, linked, their mean does and takes them along. Steps stop at the modes of the
    first curve's degree.
    """
    if not targets.size:
        return
    document.settle()
    values, degree = targets.values(document.drawing), targets.curves(document.drawing)[0].degree
    if linked:
        new = moved_together(values, float(stepped(mean(values), count, degree, fine)))
    else:
        new = stepped(values, count, degree, fine)
    set_lambdas(document, targets, new, run=True)
