"""Preferences: few, in the user's settings, and in force as soon as they are changed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QComboBox, QDialog, QDialogButtonBox, QFormLayout, QVBoxLayout

from theditor.app.theme import Theme, chosen_theme
from theditor.canvas.freehand import preferred_tolerance
from theditor.canvas.nudge import preferred_step
from theditor.canvas.pen import preferred_degree
from theditor.panels.number_field import NumberField
from theditor.panels.parts import GAP, MARGIN, ComboBox, Paragraph, describe
from theditor.spline import MAX_COORDINATE

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


class Preferences(QDialog):
    """Theme, nudge step, and the degree and tolerance of curves that are drawn."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self.setWindowTitle("Preferences")
        self._window = window
        self.theme = _choice({"As the system": Theme.SYSTEM, "Light": Theme.LIGHT, "Dark": Theme.DARK})
        describe(self.theme, "Theme", "Colours of all windows")
        self.theme.setCurrentIndex(self.theme.findData(chosen_theme()))
        self.nudge = NumberField(0.0, MAX_COORDINATE)
        describe(self.nudge, "Nudge step", "Units by which an arrow key moves the selected control points")
        self.nudge.show_value(preferred_step())
        self.degree = _choice({"Cubic · C²": 3, "Quadratic · C¹": 2})
        describe(self.degree, "Degree of new curves", "Degree of the curves that are added or drawn")
        self.degree.setCurrentIndex(self.degree.findData(preferred_degree()))
        self.tolerance = NumberField(0.1, 100.0)
        describe(
            self.tolerance,
            "Freehand tolerance in pixels",
            "Pixels by which a curve may stay away from the stroke it is fitted to",
        )
        self.tolerance.show_value(preferred_tolerance())
        about_nudge = Paragraph()
        about_nudge.setText("0 follows the grid. Shift makes ten steps, Ctrl one pixel.")

        form = QFormLayout()
        form.setHorizontalSpacing(MARGIN)
        form.setVerticalSpacing(GAP)
        form.addRow("&Theme", self.theme)
        form.addRow("&Nudge step", self.nudge)
        form.addRow("", about_nudge)
        form.addRow("&Degree of new curves", self.degree)
        form.addRow("&Freehand tolerance, pixels", self.tolerance)
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
        self.nudge.stepped.connect(lambda steps: _step(self.nudge, "nudge", 0.1 * steps))
        self.tolerance.entered.connect(lambda pixels: QSettings().setValue("freehand_tolerance", pixels))
        self.tolerance.stepped.connect(lambda steps: _step(self.tolerance, "freehand_tolerance", 0.5 * steps))
        self.degree.currentIndexChanged.connect(
            lambda _index: QSettings().setValue("pen_degree", self.degree.currentData())
        )

    def _choose_theme(self) -> None:
        self._window.actions_by_name[f"theme_{self.theme.currentData()}"].setChecked(True)


def _step(field: NumberField, name: str, by: float) -> None:
    """Add to the number of a field, within its limits, and keep it."""
    value = round(min(max(field.value() + by, field.minimum()), field.maximum()), 10)
    field.show_value(value)
    QSettings().setValue(name, value)


def _choice(entries: dict[str, object]) -> QComboBox:
    box = ComboBox()
    for text, value in entries.items():
        box.addItem(text, value)
    return box
