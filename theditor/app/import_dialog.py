"""Asks how to read the files of other programs."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QFormLayout, QVBoxLayout, QWidget

from theditor.app.problem_line import ProblemLine
from theditor.drawing import shown
from theditor.exchange import Options
from theditor.model import words
from theditor.panels.live_inputs import LiveField
from theditor.panels.parts import GAP, MARGIN, ComboBox, Paragraph, describe, heading

_WIDTH = 440
_FIELD = 96
_NAMED = 3
_ABOUT = "Exact curves where there are any, such as ellipses; others are fitted, as closely as you ask for."


class ImportDialog(QDialog):
    """Fields for degree and tolerance and, if there is a table among the files, for what its rows are.

    Parameters
    ----------
    paths
        The files.
    options
        What to begin with.
    """

    def __init__(self, paths: Sequence[Path], options: Options, parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle("Import")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setFixedWidth(_WIDTH)
        self.degree, self.rows = ComboBox(), ComboBox()
        describe(self.degree, "Degree", "Degree of the curves that are fitted")
        self.degree.addItem("Cubic · C²", 3)
        self.degree.addItem("Quadratic · C¹", 2)
        self.degree.setCurrentIndex(self.degree.findData(options.degree))
        self.tolerance = LiveField(1e-12, 0.1)
        describe(self.tolerance, "Tolerance", "Largest deviation of a fitted curve, as a share of the size")
        self.tolerance.setFixedWidth(_FIELD)
        self.tolerance.show_value(options.tolerance)
        self.tolerance.edited.connect(self._refresh)
        describe(self.rows, "Rows of tables", "What the rows of a table are")
        self.rows.addItem("Points to pass through", False)
        self.rows.addItem("Control points", True)
        self.rows.setCurrentIndex(self.rows.findData(options.control_points))
        form = QFormLayout()
        form.setHorizontalSpacing(MARGIN)
        form.setVerticalSpacing(GAP)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        tables = [path.suffix.lower() == ".csv" for path in paths]
        if any(tables):
            form.addRow("&Rows of tables", self.rows)
        form.addRow("&Degree", self.degree)
        form.addRow("&Tolerance, share of size", self.tolerance)
        self._only_tables = all(tables)
        self.sentence = ProblemLine(2)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.button = buttons.addButton("&Import", QDialogButtonBox.ButtonRole.AcceptRole)
        self.button.setDefault(True)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        about = Paragraph()
        about.setText(_ABOUT)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(MARGIN, MARGIN, MARGIN, MARGIN)
        layout.setSpacing(GAP)
        layout.addWidget(heading(_listed(paths), capitals=False))
        layout.addWidget(about)
        layout.addLayout(form)
        layout.addWidget(self.sentence)
        layout.addWidget(buttons)
        self.rows.currentIndexChanged.connect(self._refresh)
        self._refresh()

    def options(self) -> Options:
        """Return what the fields say; a `ValueError` says in a sentence why that cannot be."""
        return Options(
            degree=self.degree.currentData(),
            tolerance=self.tolerance.number(),
            control_points=self.rows.currentData(),
        )

    def _refresh(self) -> None:
        # Control points are taken as they are: nothing is fitted.
        self.tolerance.setEnabled(not (self._only_tables and self.rows.currentData()))
        problem = ""
        try:
            self.options()
        except ValueError as error:
            problem = str(error)
        self.sentence.show_problem(problem)
        self.button.setEnabled(not problem)


def _listed(paths: Sequence[Path]) -> str:
    names = [f"“{shown(path.name)}”" for path in paths[:_NAMED]]
    more = len(paths) - len(names)
    return words.listed([*names, words.counted(more, "more file")] if more else names)
