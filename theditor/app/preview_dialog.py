"""A small dialog whose outcome is seen in the drawing while its fields are changed."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QPoint, Qt, SignalInstance
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QGridLayout, QLabel, QVBoxLayout, QWidget

from theditor.app.problem_line import ProblemLine
from theditor.drawing import Drawing
from theditor.model import Document
from theditor.panels.parts import GAP, MARGIN, Paragraph, heading

_WIDTH = 400
_FROM_TOP = 72
_SENTENCE_LINES = 3


class PreviewDialog(QDialog):
    """A heading, what happens, labelled fields, a sentence if something is wrong, OK and Cancel.

    It stands over the panels of its window, so that the canvas stays in sight. OK keeps what is seen as one
    undo step; Cancel and Escape leave no trace.

    Parameters
    ----------
    document
        Whose drawing is changed.
    step
        Title of the dialog, and name of the undo step.
    what, about
        The heading, and a sentence or two under it.
    outcome
        Makes of the drawing before the dialog the one that the fields ask for. A `ValueError` bars OK, and
        its message is shown under the fields; the drawing stays as it last was.
    parent
        The window.
    """

    def __init__(
        self,
        document: Document,
        step: str,
        what: str,
        about: str,
        outcome: Callable[[Drawing], Drawing],
        parent: QWidget,
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(step)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setFixedWidth(_WIDTH)
        self._outcome, self._window = outcome, parent
        self._gesture = document.begin(step)
        paragraph = Paragraph()
        paragraph.setText(about)
        self.sentence = ProblemLine(_SENTENCE_LINES)
        self.buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        self._fields = QGridLayout()
        self._fields.setHorizontalSpacing(GAP)
        self._fields.setVerticalSpacing(GAP)
        self._fields.setColumnStretch(1, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(MARGIN, MARGIN, MARGIN, MARGIN)
        layout.setSpacing(GAP)
        layout.addWidget(heading(what, capitals=False))
        layout.addWidget(paragraph)
        layout.addLayout(self._fields)

    def add_field(self, text: str, field: QWidget, changed: SignalInstance) -> None:
        """Add a labelled field under those that are there; `changed` is its signal that asks for a new outcome."""
        changed.connect(self.refresh)
        label = QLabel(text)
        label.setBuddy(field)
        line = self._fields.rowCount()
        self._fields.addWidget(label, line, 0)
        self._fields.addWidget(field, line, 1)

    def refresh(self) -> None:
        """Show what the fields ask for now, or say why that cannot be."""
        problem = ""
        try:
            drawing = self._outcome(self._gesture.before)
        except ValueError as error:
            problem = str(error)
        else:
            self._gesture.preview(drawing)
        self.sentence.show_problem(problem)
        self.buttons.button(QDialogButtonBox.StandardButton.Ok).setEnabled(not problem)

    def open(self) -> None:
        """Show the dialog over the panels of its window, with the outcome of its first values."""
        layout = self.layout()
        assert layout is not None
        # Only now, so that Tab comes to the buttons after the fields.
        layout.addWidget(self.sentence)
        layout.addWidget(self.buttons)
        self.refresh()
        self.move(self._window.mapToGlobal(QPoint(self._window.width() - _WIDTH, _FROM_TOP)))
        super().open()

    def done(self, result: int) -> None:
        """Keep what is seen, or take it back."""
        if result == QDialog.DialogCode.Accepted:
            self._gesture.commit()
        else:
            self._gesture.cancel()
        super().done(result)
