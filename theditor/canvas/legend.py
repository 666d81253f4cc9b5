"""The legend: which colour means which mode."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from theditor.model import colours_for, unbreakable
from theditor.spline import Mode

WORDS = {
    Mode.TRIGONOMETRIC: "trigonometric",
    Mode.HYPERBOLIC: "hyperbolic",
    Mode.INTERPOLATING: "interpolating",
    Mode.BLEND: "blend",
}
SWATCH, GAP, BETWEEN, PADDING = 18, 6, 16, 12


@unbreakable
class Legend(QWidget):
    """A small card that lies over the canvas and lets the mouse through."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAccessibleName("Legend: colours of the segment modes")

    def sizeHint(self) -> QSize:
        """Room for all modes in one line."""
        metrics = self.fontMetrics()
        words = sum(metrics.horizontalAdvance(word) for word in WORDS.values())
        width = words + len(WORDS) * (SWATCH + GAP) + (len(WORDS) - 1) * BETWEEN + 2 * PADDING
        return QSize(width, metrics.height() + 14)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the card, a line in each mode's colour, and the modes' names."""
        colours, metrics = colours_for(self.palette()), self.fontMetrics()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(colours.border), 1))
        painter.setBrush(QColor(colours.panel))
        painter.drawRoundedRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6)
        x, middle = float(PADDING), self.height() / 2
        for mode, word in WORDS.items():
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(colours.of_mode(mode)))
            painter.drawRoundedRect(QRectF(x, middle - 1.5, SWATCH, 3), 1.5, 1.5)
            x += SWATCH + GAP
            width = metrics.horizontalAdvance(word)
            painter.setPen(QColor(colours.secondary))
            painter.drawText(QRectF(x, 0, width + 2, self.height()), Qt.AlignmentFlag.AlignVCenter, word)
            x += width + BETWEEN
        painter.end()
