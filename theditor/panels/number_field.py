"""A field for exact numbers: it shows few digits, keeps them all, and changes nothing it was not asked to."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QLocale, QSize, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QKeySequence, QValidator, QWheelEvent
from PySide6.QtWidgets import QAbstractSpinBox, QDoubleSpinBox, QStyle, QStyleOptionSpinBox, QWidget

from theditor.model import unbreakable
from theditor.model.arithmetic import calculated
from theditor.model.words import exact
from theditor.panels.parts import tabular

# More decimals than any double has: QDoubleSpinBox rounds to them.
_DECIMALS = 323
_LONGEST = f"{-1.23456789e-10:.6g}"  # of what is shown without the focus
_INSET = 7  # of the text, in pixels


@unbreakable
class NumberField(QDoubleSpinBox):
    """Shows a number in six digits, or the shortest exact text while it has the focus.

    Typing takes a decimal point or comma, simple arithmetic (``2/3``) and changes of the value shown (``+1.5``,
    ``*2``); it acts on Enter or when the focus leaves. Untouched text acts on nothing. Bad text is put back to
    the old value.

    Parameters
    ----------
    minimum, maximum
        The numbers that may be typed.
    """

    entered = Signal(float)
    """A number was typed."""

    stepped = Signal(int)
    """Steps were asked for by key or wheel; the owner decides what they do."""

    refused = Signal(str)
    """What was typed is no such number: a sentence that says what is expected."""

    def __init__(self, minimum: float, maximum: float, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._differing = False
        self._shown = ""
        self.setLocale(QLocale.c())
        self.setDecimals(_DECIMALS)
        self.setRange(minimum, maximum)
        self.setKeyboardTracking(False)
        self.setButtonSymbols(QAbstractSpinBox.ButtonSymbols.NoButtons)
        self.lineEdit().setTextMargins(_INSET, 0, _INSET, 0)
        self.setFont(tabular(self.font()))
        self._show_text()

    def show_value(self, value: float | None) -> None:
        """Show `value`, or that several values differ (None). Emits nothing."""
        differing = value is None
        if differing == self._differing and (value is None or value == self.value()):
            return
        self._differing = differing
        self.blockSignals(True)
        self.setValue(self.value() if value is None else value)
        self.blockSignals(False)
        self.lineEdit().setPlaceholderText("differ" if differing else "")
        self._show_text()

    def width_at_rest(self) -> int:
        """Return the width in pixels that shows any number in six digits, with its sign and its exponent."""
        self.ensurePolished()
        option = QStyleOptionSpinBox()
        self.initStyleOption(option)
        wide = self.fontMetrics().horizontalAdvance(_LONGEST) + 2 * _INSET
        contents = QSize(wide, self.fontMetrics().height())
        kind = QStyle.ContentsType.CT_SpinBox
        return self.style().sizeFromContents(kind, option, contents, self).width()

    def take_back(self) -> None:
        """Put the old text back in place of what is being typed."""
        self._show_text()

    def textFromValue(self, value: float) -> str:
        """Return the text to show: nothing if values differ, exact with the focus, else six digits."""
        if self._differing:
            return ""
        return exact(value) if self.hasFocus() else f"{value:.6g}"

    def valueFromText(self, text: str) -> float:
        """Return the number that a text means, the present value if it means none."""
        number = self._number(text)
        return self.value() if number is None else number

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        """Let everything be typed; what it means is judged when the typing ends."""
        good = text == self._shown or self._number(text) is not None
        state = QValidator.State.Acceptable if good else QValidator.State.Intermediate
        return state, text, position

    def stepBy(self, steps: int) -> None:
        """Ask the owner for steps from the present value."""
        self._finish()
        self.stepped.emit(steps)

    def stepEnabled(self) -> QAbstractSpinBox.StepEnabledFlag:
        """Allow steps always; the owner knows the limits."""
        flags = QAbstractSpinBox.StepEnabledFlag
        return flags.StepUpEnabled | flags.StepDownEnabled

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Show every digit."""
        super().focusInEvent(event)
        self._show_text()
        self.selectAll()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Take what was typed, and show few digits again."""
        self._finish()
        super().focusOutEvent(event)
        self._show_text()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter takes what was typed; Escape puts the old text back."""
        if event.matches(QKeySequence.StandardKey.InsertParagraphSeparator):
            self._finish()
        elif event.matches(QKeySequence.StandardKey.Cancel) and self._text() != self._shown:
            self._show_text()
            event.accept()
            return
        super().keyPressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Step only with the focus: a wheel meant for scrolling must not change a number."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()

    def event(self, event: QEvent) -> bool:
        """Leave undo and redo to the document while nothing is being typed."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride:
            keys = QKeySequence.StandardKey
            if self._text() == self._shown and (event.matches(keys.Undo) or event.matches(keys.Redo)):
                event.ignore()
                return False
        return super().event(event)

    def _finish(self) -> None:
        text = self._text()
        if text == self._shown:
            return
        number = self._number(text)
        if number is None:
            self._show_text()
            limits = f"{exact(self.minimum())} to {exact(self.maximum())}"
            self.refused.emit(f"“{text}” is no number from {limits}: type one such as 0.5, 2/3 or +1.5.")
        elif self._differing or number != self.value():
            self.show_value(number)
            self.entered.emit(number)
        else:
            self._show_text()

    def _number(self, text: str) -> float | None:
        try:
            number = calculated(text, None if self._differing else self.value())
        except ValueError:
            return None
        return number if self.minimum() <= number <= self.maximum() else None

    def _text(self) -> str:
        return self.lineEdit().text()

    def _show_text(self) -> None:
        self._shown = self.textFromValue(self.value())
        edit = self.lineEdit()
        edit.blockSignals(True)
        edit.setText(self._shown)
        if not self.hasFocus():
            edit.setCursorPosition(0)  # where there is no room for all, the sign and the first digits count
        edit.blockSignals(False)
