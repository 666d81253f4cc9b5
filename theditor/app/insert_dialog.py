"""Insert a known curve: its parameters in a small dialog, the curve itself already in the drawing."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from PySide6.QtWidgets import QWidget

from theditor.app.preview_dialog import PreviewDialog
from theditor.canvas.viewport import Viewport
from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection, words
from theditor.panels.live_inputs import LiveField
from theditor.panels.parts import ComboBox
from theditor.spline import MAX_COORDINATE, Known, Parameter
from theditor.spline.catalogue import SMALLEST

_SHARE = 0.4
"""How much of the view a new curve takes."""
_PLACES = ("centre", "origin")
_DEGREES = {2: "Quadratic · C¹", 3: "Cubic · C²"}
_TURN = 15.0
_ABOUT = "Its control points give it exactly, but for rounding. Arrow keys change a number by a step."


class InsertDialog(PreviewDialog):
    """Asks for the parameters of a known curve; the curve they make is the current one meanwhile.

    Parameters
    ----------
    known
        What to insert.
    plane
        The part of the plane in view: the first values make a curve that fits into its middle.
    """

    def __init__(
        self, known: Known, document: Document, selection: Selection, plane: Viewport, parent: QWidget
    ) -> None:
        step = f"Insert {known.name.lower()}"
        super().__init__(document, step, known.name, _ABOUT, self._outcome_of_fields, parent)
        self._known, self._document, self._selection = known, document, selection
        self._select_again = selection.remember()
        self._place = len(document.drawing)
        self._name = _free_name(known.name, document.drawing)
        self.fields: dict[str, tuple[LiveField, ...]] = {}
        start = fitting_values(known, plane)
        for parameter in known.parameters:
            values = start[parameter.keyword]
            entries = tuple(_number_field(value, _step(parameter, plane), self) for value in values)
            for label, entry in zip(parameter.labels, entries, strict=True):
                entry.setAccessibleName(label)
                shown = f"{label} (°)" if parameter.unit == "radians" else label
                self.add_field(shown, entry, entry.edited)
            self.fields[parameter.keyword] = entries
        self.degree = ComboBox(self)
        if len(known.degrees) > 1:
            for degree in known.degrees:
                self.degree.addItem(_DEGREES[degree], degree)
            self.degree.setCurrentIndex(len(known.degrees) - 1)
            self.add_field("Degree", self.degree, self.degree.currentIndexChanged)
        else:
            self.degree.hide()

    def refresh(self) -> None:
        """Show the curve that the fields describe as the current one, or say why there is none."""
        super().refresh()
        if len(self._document.drawing) > self._place:
            self._selection.select(curve=self._place)

    def done(self, result: int) -> None:
        """Keep the curve, or select again what was selected before."""
        super().done(result)
        if result != self.DialogCode.Accepted:
            self._select_again()

    def _outcome_of_fields(self, before: Drawing) -> Drawing:
        arguments: dict[str, Any] = {p.keyword: self._value(p) for p in self._known.parameters}
        if len(self._known.degrees) > 1:
            arguments["degree"] = self.degree.currentData()
        return before.inserted(len(before), Item(self._known.make(**arguments), self._name))

    def _value(self, parameter: Parameter) -> float | int | tuple[float, ...]:
        """Return what the fields of a parameter say, as the function that makes the curve takes it."""
        fields = self.fields[parameter.keyword]
        numbers = [_judged(parameter, *each) for each in zip(parameter.labels, fields, strict=True)]
        if parameter.integer:
            return round(numbers[0])
        if parameter.unit == "radians":
            numbers = [math.radians(number) for number in numbers]
        return numbers[0] if len(numbers) == 1 else tuple(numbers)


def _judged(parameter: Parameter, label: str, field: LiveField) -> float:
    """Return the number in a field, or say what the parameter needs."""
    name = label.partition(" (")[0]
    try:
        number = field.number()
    except ValueError:
        limit = f"up to {MAX_COORDINATE:.0e} in size".replace("+", "")
        reason = f"{name}: “{field.text()}” is no number {limit}; type one such as 1.5 or 2/3."
        raise ValueError(reason) from None
    if parameter.integer:
        if number != round(number) or not parameter.minimum <= number <= parameter.maximum:
            raise ValueError(
                f"{name}: type a whole number from {parameter.minimum:.0f} to {parameter.maximum:.0f}."
            )
    elif number < parameter.minimum:
        raise ValueError(f"{name}: type a positive number, at least {words.number(parameter.minimum)}.")
    elif parameter.nonzero and abs(number) < SMALLEST:
        raise ValueError(f"{name}: type a number other than 0, at least {words.number(SMALLEST)} in size.")
    return number


def _number_field(value: float, step: float, parent: QWidget) -> LiveField:
    """Return a field for a number, which arrow keys and wheel change by a step."""
    field = LiveField(-MAX_COORDINATE, MAX_COORDINATE, parent)
    field.show_value(value)

    def change(steps: int) -> None:
        field.show_value(_rounded(field.value() + steps * step))
        field.edited.emit()

    field.stepped.connect(change)
    return field


def fitting_values(known: Known, plane: Viewport) -> dict[str, tuple[float, ...]]:
    """Return values, angles in degrees, that put a known curve of a fair size into the middle of the view.

    The sizes are the curve's own defaults times 1, 2 or 5 times a power of ten.
    """
    points = known.make().sample(16)[:, :2]
    low, high = points.min(axis=0), points.max(axis=0)
    view = np.array([plane.width, plane.height]) / plane.scale
    factor = _round_number(float(np.min(_SHARE * view / (high - low))))
    grid = _round_number(float(view.min()) / 50)
    middle = np.array([plane.x, plane.y]).clip(-MAX_COORDINATE / 2, MAX_COORDINATE / 2)
    place = np.round((middle - factor * (low + high) / 2) / grid) * grid
    values: dict[str, tuple[float, ...]] = {}
    for parameter in known.parameters:
        default = np.atleast_1d(np.asarray(parameter.default, dtype=np.float64))
        if parameter.keyword in _PLACES:
            default[:2] = place
        elif parameter.unit == "":
            default = default * factor
        elif parameter.unit == "radians":
            default = np.degrees(default)
        values[parameter.keyword] = tuple(_rounded(value) for value in default.tolist())
    return values


def _step(parameter: Parameter, plane: Viewport) -> float:
    if parameter.integer:
        return 1.0
    if parameter.unit == "radians":
        return _TURN
    return 0.5 if parameter.unit else _round_number(min(plane.width, plane.height) / plane.scale / 50)


def _round_number(value: float) -> float:
    """Return 1, 2 or 5 times a power of ten, the closest by ratio."""
    power = math.floor(math.log10(value))
    ratio = value / 10.0**power
    return min((1, 2, 5, 10), key=lambda digit: abs(math.log(ratio / digit))) * 10.0**power


def _rounded(value: float) -> float:
    """Drop the rounding of sums and products of short numbers."""
    return float(f"{value:.12g}") + 0.0


def _free_name(name: str, drawing: Drawing) -> str:
    """Return a name that no curve has: the given one, or with a number."""
    taken = {item.name for item in drawing}
    numbered = (f"{name} {number}" for number in range(2, len(taken) + 3))
    return name if name not in taken else next(each for each in numbered if each not in taken)
