"""Preferences: few, in the user's settings, and in force as soon as they are changed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QComboBox, QDialog, QDialogButtonBox, QFormLayout, QVBoxLayout

from theditor.app.theme import Theme, chosen_theme
from theditor.panels.number_field import NumberField
from theditor.panels.parts import GAP, MARGIN, ComboBox, Paragraph, describe
from theditor.spline import MAX_COORDINATE

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


class Preferences(QDialog):
    """Theme, nudge step and the degree of curves that are drawn."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self.setWindowTitle("Preferences")
        self._window = window
        self.theme = _choice({"As the system": Theme.SYSTEM, "Light": Theme.LIGHT, "Dark": Theme.DARK})
        describe(self.theme, "Theme", "Colours of all windows")
        self.theme.setCurrentIndex(self.theme.findData(chosen_theme()))
        self.nudge = NumberField(0.0, MAX_COORDINATE)
        describe(self.nudge, "Nudge step", "Units by which an arrow key moves the selected control points")
        self.nudge.show_value(number_preferred("nudge", 0.0))
        self.degree = _choice({"Cubic · C²": 3, "Quadratic · C¹": 2})
        describe(self.degree, "Degree of new curves", "Degree of the curves that the pen draws")
        self.degree.setCurrentIndex(self.degree.findData(int(number_preferred("pen_degree", 3))))
        about_nudge = Paragraph()
        about_nudge.setText("0 follows the grid. Shift makes ten steps, Ctrl one pixel.")

        form = QFormLayout()
        form.setHorizontalSpacing(MARGIN)
        form.setVerticalSpacing(GAP)
        form.addRow("&Theme", self.theme)
        form.addRow("&Nudge step", self.nudge)
        form.addRow("", about_nudge)
        form.addRow("&Degree of new curves", self.degree)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(MARGIN, MARGIN, MARGIN, MARGIN)
        layout.setSpacing(MARGIN)
        layout.addLayout(form)
        layout.addWidget(buttons)
        self.setMinimumWidth(400)

        self.theme.currentIndexChanged.connect(self._choose_theme)
        self.nudge.entered.connect(lambda step: QSettings().setValue("nudge", step))
        self.nudge.stepped.connect(self._step)
        self.degree.currentIndexChanged.connect(
            lambda _index: QSettings().setValue("pen_degree", self.degree.currentData())
        )

    def _choose_theme(self) -> None:
        self._window.actions_by_name[f"theme_{self.theme.currentData()}"].setChecked(True)

    def _step(self, steps: int) -> None:
        step = round(min(max(self.nudge.value() + 0.1 * steps, 0.0), MAX_COORDINATE), 10)
        self.nudge.show_value(step)
        QSettings().setValue("nudge", step)


def number_preferred(name: str, usual: float) -> float:
    """A number from the user's settings, the usual one while there is none."""
    try:
        return float(str(QSettings().value(name, usual)))
    except ValueError:
        return usual


def _choice(entries: dict[str, object]) -> QComboBox:
    box = ComboBox()
    for text, value in entries.items():
        box.addItem(text, value)
    return box
