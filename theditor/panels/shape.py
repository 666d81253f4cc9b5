"""The shape panel: λ of the selected points or segments, by slider, exact number or mode."""

from __future__ import annotations

import operator

import numpy as np
from PySide6.QtCore import QEvent, QObject, Signal
from PySide6.QtWidgets import QLabel, QToolButton, QWidget

from theditor.model import Document, Selection, words
from theditor.panels.lambda_edit import (
    LambdaGesture,
    Targets,
    asked,
    mean,
    obstacle,
    set_lambdas,
    step_lambdas,
    targets,
)
from theditor.panels.lambda_slider import LambdaSlider
from theditor.panels.number_field import NumberField
from theditor.panels.parts import column, describe, heading, row, segmented
from theditor.spline import MAX_LAMBDA, Curve, Mode

_FIELD_TIP = (
    "Exact λ: 0 is trigonometric, 1 hyperbolic, λ* interpolating, anything else a blend. Arrow keys step."
)
_SLIDER_TIP = (
    "Drag λ; T, H and λ* attract it unless Shift is held, Ctrl drags ten times finer. "
    "The shaded band keeps the curve in the convex hull of its points."
)
_MODE_TIPS = {
    Mode.TRIGONOMETRIC: "Trigonometric: λ = 0",
    Mode.HYPERBOLIC: "Hyperbolic: λ = 1",
    Mode.INTERPOLATING: "Interpolating: λ = λ*, the curve meets its control points",
}
_LINKED_TIP = "Shows the mean of the linked λ; moving it moves all of them by as much. "
_LINK_TIP = "Link λ: slider and field show their mean and move all by as much, so that differences stay."
_ALL_TIP = "Act on every λ of the curve: takes the selection of points and segments away."
MOST_HOVERED = 4
"""More λ than this have no reach worth shading."""


class ShapePanel(QWidget):
    """Edits the λ of the selected points, else of the selected segments, else every λ of the selected curves.

    All get the same value; while they are linked, slider and field show their mean and shift them together.
    """

    announce = Signal(str)
    """A sentence for the status line."""
    hovered = Signal(object)
    """The control points whose λ the slider under the pointer moves; none when it is elsewhere, or they are many."""

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._selection = document, selection
        self._gesture: LambdaGesture | None = None
        self._targets = targets(selection)
        self._curve: Curve | None = None
        self._curves: list[Curve] = []
        self._scope: object = None
        self._chosen = selection.chosen

        self._heading = heading("SHAPE", capitals=False)
        self.slider = LambdaSlider()
        self.field = NumberField(-MAX_LAMBDA, MAX_LAMBDA)
        self.mode_buttons = {mode: _toggle(letter) for mode, letter in words.MODE_LETTERS.items()}
        self.link_button, self.all_button = _toggle("Link"), _toggle("All")
        label = QLabel("λ")
        label.setBuddy(self.field)

        layout = column(self)
        layout.addWidget(self._heading)
        layout.addWidget(self.slider)
        controls = row(label, self.field)
        controls.setStretch(1, 1)
        controls.addLayout(segmented(list(self.mode_buttons.values())))
        controls.addWidget(self.link_button)
        controls.addWidget(self.all_button)
        layout.addLayout(controls)

        self.slider.installEventFilter(self)
        self.slider.pressed.connect(self._begin)
        self.slider.moved.connect(self._preview)
        self.slider.released.connect(self._commit)
        self.slider.cancelled.connect(self._cancel)
        self.slider.stepped.connect(self._step)
        self.slider.jumped.connect(lambda value: self._set(value, run=True))
        self.field.entered.connect(self._set)
        self.field.stepped.connect(self._step)
        self.field.refused.connect(self._refuse)
        for mode, button in self.mode_buttons.items():
            button.clicked.connect(lambda _=False, mode=mode: self.set_mode(mode))
        self.link_button.toggled.connect(self._link)
        self.all_button.clicked.connect(self._act_on_all)
        document.changed.connect(self._follow)
        selection.changed.connect(self._follow)
        self._follow()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Tell when the pointer comes to the slider and leaves it."""
        if watched is self.slider and event.type() in (QEvent.Type.Enter, QEvent.Type.Leave):
            points = self._targets.points.get(self._selection.curve, [])
            here = event.type() == QEvent.Type.Enter and len(points) <= MOST_HOVERED
            self.hovered.emit(tuple(int(i) for i in points) if here else ())
        return super().eventFilter(watched, event)

    # Edits

    def _begin(self) -> None:
        self._gesture = LambdaGesture(self._document)

    def _preview(self, value: float) -> None:
        if self._gesture is not None and self._gesture.is_open:
            values = self._targets.values(self._gesture.before)
            self._gesture.preview(self._targets, asked(values, value, self._linked))

    def _commit(self) -> None:
        if self._gesture is not None:
            self._gesture.commit()
            self._gesture = None

    def _cancel(self) -> None:
        if self._gesture is not None:
            self._gesture.cancel()
            self._gesture = None

    @property
    def _linked(self) -> bool:
        return self.link_button.isChecked()

    def _set(self, value: float, run: bool = False) -> None:
        if self._curve is not None:
            values = asked(self._targets.values(self._document.drawing), value, self._linked)
            set_lambdas(self._document, self._targets, values, run=run)
        self._show_values()

    def _step(self, count: int, fine: bool = False) -> None:
        step_lambdas(self._document, self._targets, count, fine=fine, linked=self._linked)

    def set_mode(self, mode: Mode) -> None:
        """Give the λ that the controls act on the value of a mode."""
        if self._curve is not None:
            set_lambdas(self._document, self._targets, self._targets.of_mode(self._document.drawing, mode))
        self._show_values()

    def _link(self) -> None:
        self._show_scope()
        self._show_values()

    def _act_on_all(self) -> None:
        self._selection.select(points=(), segments=())
        self._show_scope()

    def _refuse(self, sentence: str) -> None:
        self.field.setToolTip(sentence)
        self.announce.emit(sentence)

    # Following

    def _follow(self) -> None:
        item, selection = self._selection.item, self._selection
        curve = item.curve if item is not None else None
        items, old = [selection.drawing[i] for i in selection.curves], self._curves
        curves = [each.curve for each in items]
        guards = [(each.locked, each.visible) for each in items]
        scope = (selection.curve, selection.segments, guards, item.name if item is not None else "")
        same_scope = scope == self._scope and selection.chosen is self._chosen
        if same_scope and len(curves) == len(old) and all(map(operator.is_, curves, old)):
            return
        same_scope = same_scope and [*map(_kind, curves)] == [*map(_kind, old)]
        self._scope, self._chosen, self._curve, self._curves = scope, selection.chosen, curve, curves
        if not same_scope:
            self._targets = targets(selection)
            self._show_scope()
        if not same_scope or any(
            not np.array_equal(a.lambdas, b.lambdas) for a, b in zip(curves, old, strict=True)
        ):
            self._show_values()

    def _show_scope(self) -> None:
        """Say which λ the controls act on, and disable them, with the reason, if there is nothing to do."""
        selection, reason = self._selection, obstacle(self._selection)
        self._heading.setText(_title(selection))
        self.slider.setEnabled(not reason)
        self.field.setEnabled(not reason)
        shown, tip = ("Mean of the linked λ", _LINKED_TIP) if self._linked else ("Shape parameter λ", "")
        describe(self.slider, f"{shown}, slider", reason or tip + _SLIDER_TIP)
        describe(self.field, f"{shown}, exact", reason or tip + _FIELD_TIP)
        for mode, button in self.mode_buttons.items():
            button.setEnabled(not reason)
            describe(button, f"Make λ {mode.value}", reason or _MODE_TIPS[mode])
        self.link_button.setEnabled(not reason)
        describe(self.link_button, "Link λ: keep their differences", reason or _LINK_TIP)
        on_all = not selection.count and not selection.segments
        self.all_button.setEnabled(selection.item is not None)
        self.all_button.setChecked(on_all and selection.item is not None)
        describe(self.all_button, "Act on every λ", "The controls act on every λ." if on_all else _ALL_TIP)

    def _show_values(self) -> None:
        curve = self._curve
        degree = curve.degree if curve is not None else 3
        shown = self._targets if self._targets.size else Targets(self._selection.lambdas_across())
        values = shown.values(self._document.drawing)
        common = float(values[0]) if values.size and (values == values[0]).all() else None
        middle = mean(values) if values.size and self._linked else None
        self.slider.show_values(values, degree, middle)
        self.field.show_value(common if middle is None else middle)
        for mode, button in self.mode_buttons.items():
            of_mode = shown.of_mode(self._document.drawing, mode)
            button.setChecked(bool(values.size and (values == of_mode).all()))


def _title(selection: Selection) -> str:
    """Say which λ the controls act on."""
    if selection.item is None:
        return "SHAPE"
    across = selection.lambdas_across()
    if len(across) > 1:
        whole = not selection.count and not selection.segments
        what = "all λ" if whole else words.counted(sum(map(len, across.values())), "point")
        what += f" on {len(across)} curves"
    elif not selection.points and not selection.segments:
        what = "all λ"
    else:
        indices = selection.lambda_indices().tolist()
        told = (
            f"{words.counted(len(indices), 'point')} selected"
            if selection.points
            else words.segments_named(selection.item.curve, selection.segments)
        )
        what = f"{words.symbols('λ', indices)} ({told})".lstrip()
    return f"SHAPE · {what}"


def _toggle(text: str) -> QToolButton:
    button = QToolButton()
    button.setText(text)
    button.setCheckable(True)
    return button


def _kind(curve: Curve) -> tuple[object, ...]:
    return len(curve.control_points), curve.degree, curve.closed, curve.ends
