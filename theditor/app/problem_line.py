"""Where a dialog says what is wrong with its fields."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel

from theditor.model import words


class ProblemLine(QLabel):
    """A sentence if something is wrong; room is kept for it, so that nothing jumps while a hand is typing."""

    def __init__(self, lines: int) -> None:
        super().__init__()
        self.setWordWrap(True)
        self.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setMinimumHeight(lines * self.fontMetrics().lineSpacing() + 4)

    def show_problem(self, problem: str) -> None:
        """Show what an error says; nothing if there is none."""
        self.setText(words.sentence(problem))
