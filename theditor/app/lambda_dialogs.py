"""Dialogs that change many λ at once: a gradient, smoothing, a formula.

They act on what the shape panel acts on: the selected points, else the selected segments, else the curve.
Each raises a `ValueError` with a sentence if there is nothing it could act on.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from PySide6.QtWidgets import QLineEdit, QWidget

from theditor.app.preview_dialog import PreviewDialog
from theditor.drawing import Drawing
from theditor.model import Document, Selection, words
from theditor.panels.lambda_edit import editable, obstacle
from theditor.panels.live_inputs import LambdaInput, StrengthInput
from theditor.panels.parts import describe
from theditor.spline import Curve, formula, gradient, smoothed

_FORMULA_TIP = "A formula in i, n and λ, such as sin(i/3), λ + 0.1 or 0 if i < 4 else 1"


def gradient_dialog(document: Document, selection: Selection, window: QWidget) -> PreviewDialog:
    """Ask for λ at two ends, between which it runs evenly."""
    curve, targets = _at_hand(selection)
    if len(targets) < 2:
        raise ValueError("A gradient needs two λ: select more points, or none for the whole curve.")
    start, end = (
        (f"{word} {words.indexed('λ', i)}", LambdaInput(f"λ {word.lower()}", curve.lambdas[i], curve.degree))
        for word, i in (("From", targets[0]), ("To", targets[-1]))
    )
    dialog = _dialog(
        (document, selection, window),
        "Gradient of λ",
        "λ runs evenly from the first of these points to the last.",
        lambda curve: gradient(curve, targets, start[1].value(), end[1].value()),
    )
    for label, field in (start, end):
        dialog.add_field(label, field, field.changed)
    return dialog


def smooth_dialog(document: Document, selection: Selection, window: QWidget) -> PreviewDialog:
    """Ask how strongly to smooth λ that jump up and down."""
    _, targets = _at_hand(selection)
    strength = StrengthInput(0.5)

    def change(curve: Curve) -> Curve:
        result = smoothed(curve, targets, strength.value())
        if result == curve and strength.value() > 0:
            raise ValueError("There is nothing to smooth: these λ are even, or at the ends of the curve.")
        return result

    dialog = _dialog(
        (document, selection, window),
        "Smooth λ",
        "Each λ is drawn towards its neighbours; those at the ends of an open curve stay.",
        change,
    )
    dialog.add_field("Strength", strength, strength.changed)
    return dialog


def formula_dialog(document: Document, selection: Selection, window: QWidget) -> PreviewDialog:
    """Ask for a formula that gives each λ."""
    curve, targets = _at_hand(selection)
    count = len(curve.control_points)
    text = QLineEdit("λ")
    describe(text, "λ by formula", _FORMULA_TIP)
    text.selectAll()

    def change(curve: Curve) -> Curve:
        return curve.with_lambdas(targets, formula.evaluate(text.text(), count, curve.lambdas, targets))

    dialog = _dialog(
        (document, selection, window),
        "λ by formula",
        f"i is the number of the control point, from 0 to {count - 1}; n = {count}; λ (or l) is the present value. "
        "There are pi, e, sin, cos, exp, sqrt, abs, min, max and the like, and conditions: 0 if i < 4 else 1.",
        change,
    )
    dialog.add_field("λ =", text, text.textChanged)
    return dialog


def _at_hand(selection: Selection) -> tuple[Curve, NDArray[np.intp]]:
    """Return the current curve and the control points whose λ are to change."""
    found, item = editable(selection), selection.item
    if item is None or not found.size:
        other = "These λ can change on other curves alone: make one of those current."
        raise ValueError(obstacle(selection) or other)
    return item.curve, found


def _dialog(
    where: tuple[Document, Selection, QWidget], step: str, about: str, change: Callable[[Curve], Curve]
) -> PreviewDialog:
    """Return a dialog that previews a change of the current curve, and says which λ it is about."""
    document, selection, window = where
    index, targets = selection.curve, editable(selection).tolist()

    def outcome(before: Drawing) -> Drawing:
        return before.with_curve(index, change(before[index].curve))

    what = f"{words.symbols('λ', targets)}, {words.counted(len(targets), 'point')}"
    return PreviewDialog(document, step, what, about, outcome, window)
