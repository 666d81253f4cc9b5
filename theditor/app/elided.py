"""A line of words for where room is scarce."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QLabel


class Elided(QLabel):
    """Gives its room to others, down to a least width: what does not fit ends in dots."""

    least = 0

    def minimumSizeHint(self) -> QSize:
        """No more than the words take."""
        size = super().minimumSizeHint()
        return QSize(min(self.least, size.width()), size.height())

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint as much as fits."""
        room = self.contentsRect()
        text = self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, room.width())
        painter = QPainter(self)
        painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
        painter.drawText(room, Qt.AlignmentFlag.AlignVCenter, text)
        painter.end()
