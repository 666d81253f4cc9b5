"""Numbers for previews: fields with a slider beside them, which tell every change while it is made."""

from __future__ import annotations

from contextlib import suppress

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QSlider, QWidget

from theditor.model import unbreakable
from theditor.model.words import exact
from theditor.panels.lambda_scale import stepped
from theditor.panels.lambda_slider import LambdaSlider
from theditor.panels.number_field import NumberField
from theditor.panels.parts import describe, row
from theditor.spline import MAX_LAMBDA

_FIELD_WIDTH = 96
_STEP = 0.05
_PERCENT = 100
_SLIDER_STYLE = """
QSlider::groove { height: 5px; border-radius: 2px; background: palette(mid); }
QSlider::sub-page { border-radius: 2px; background: palette(accent); }
QSlider::handle { width: 15px; margin: -5px 0; border-radius: 7px; background: palette(accent); }
QSlider::handle:focus { border: 2px solid palette(text); width: 11px; }
"""


@unbreakable
class LiveField(NumberField):
    """A number field that tells every change, while it is typed too."""

    edited = Signal()
    """The text is another one; `number` says what it means."""

    def __init__(self, minimum: float, maximum: float, parent: QWidget | None = None) -> None:
        super().__init__(minimum, maximum, parent)
        self.lineEdit().textEdited.connect(self.edited)
        self.entered.connect(self.edited)
        # Queued, so that the Enter that ends a bad text does not also accept the dialog with the old one.
        self.refused.connect(self.edited, Qt.ConnectionType.QueuedConnection)

    def number(self) -> float:
        """Return the number that the text means.

        Raises
        ------
        ValueError
            It means none within the limits; the message is a sentence that says what is expected.
        """
        text = self._text()
        number = self.value() if text == self._shown else self._number(text)
        if number is None:
            limits = f"{exact(self.minimum())} to {exact(self.maximum())}"
            raise ValueError(f"“{text}” is no number from {limits}: type one such as 0.5.")
        return number

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Tell that Escape puts the old text back."""
        super().keyPressEvent(event)
        if event.matches(QKeySequence.StandardKey.Cancel):
            self.edited.emit()


class LambdaInput(QWidget):
    """Asks for one λ, by slider or exact number."""

    changed = Signal()
    """Another λ is asked for; `value` says which."""

    def __init__(self, name: str, value: float, degree: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._degree, self._pressed = degree, value
        self.field, self.slider = LiveField(-MAX_LAMBDA, MAX_LAMBDA), LambdaSlider()
        self.field.setFixedWidth(_FIELD_WIDTH)
        describe(self.field, f"{name}, exact", f"{name}: any number; arrow keys step")
        describe(self.slider, f"{name}, slider", f"{name}: T, H and λ* attract it unless Shift is held")
        self.setFocusProxy(self.field)
        layout = row(self.field, self.slider)
        layout.setContentsMargins(0, 0, 0, 0)
        self.setLayout(layout)
        self._set(value)
        self.field.edited.connect(self._follow)
        self.field.stepped.connect(self._step)
        self.slider.pressed.connect(self._press)
        self.slider.moved.connect(self._set)
        self.slider.jumped.connect(self._set)
        self.slider.stepped.connect(self._step)
        self.slider.cancelled.connect(lambda: self._set(self._pressed))

    def value(self) -> float:
        """Return the λ asked for; a `ValueError` says in a sentence why there is none."""
        return self.field.number()

    def _press(self) -> None:
        self._pressed = self.field.value()

    def _step(self, count: int, fine: bool = False) -> None:
        self._set(float(stepped(self.field.value(), count, self._degree, fine)))

    def _set(self, value: float) -> None:
        self.field.show_value(value)
        self._follow()

    def _follow(self) -> None:
        with suppress(ValueError):
            self.slider.show_values([self.value()], self._degree)
        self.changed.emit()


class StrengthInput(QWidget):
    """Asks for a strength from 0 to 1, by slider or number."""

    changed = Signal()
    """Another strength is asked for; `value` says which."""

    def __init__(self, value: float, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.field, self.slider = LiveField(0.0, 1.0), QSlider(Qt.Orientation.Horizontal)
        self.field.setFixedWidth(_FIELD_WIDTH)
        self.slider.setRange(0, _PERCENT)
        self.slider.setStyleSheet(_SLIDER_STYLE)
        describe(self.field, "Strength, exact", "Strength, from 0 to 1; arrow keys step")
        describe(self.slider, "Strength, slider", "Strength, from 0 to 1")
        self.setFocusProxy(self.field)
        layout = row(self.field, self.slider)
        layout.setContentsMargins(0, 0, 0, 0)
        self.setLayout(layout)
        self._set(value)
        self.field.edited.connect(self._follow)
        self.field.stepped.connect(self._step)
        self.slider.valueChanged.connect(lambda percent: self._set(percent / _PERCENT))

    def value(self) -> float:
        """Return the strength asked for; a `ValueError` says in a sentence why there is none."""
        return self.field.number()

    def _step(self, count: int) -> None:
        self._set(round(min(max(self.field.value() + count * _STEP, 0.0), 1.0), 6))

    def _set(self, value: float) -> None:
        self.field.show_value(value)
        self._follow()

    def _follow(self) -> None:
        with suppress(ValueError), QSignalBlocker(self.slider):
            self.slider.setValue(round(self.value() * _PERCENT))
        self.changed.emit()
