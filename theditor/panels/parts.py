"""Small widgets and layout habits that the panels share."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QFont, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QSizePolicy, QToolButton, QVBoxLayout, QWidget

MARGIN = 16
GAP = 8


def column(panel: QWidget) -> QVBoxLayout:
    """Give a panel its vertical layout."""
    layout = QVBoxLayout(panel)
    layout.setContentsMargins(MARGIN, 12, MARGIN, 9)
    layout.setSpacing(GAP)
    return layout


def row(*widgets: QWidget) -> QHBoxLayout:
    """Lay widgets out in one row."""
    layout = QHBoxLayout()
    layout.setSpacing(GAP)
    for widget in widgets:
        layout.addWidget(widget)
    return layout


def heading(text: str, *, capitals: bool = True) -> QLabel:
    """Return a section heading, small and quiet; `capitals` only in how it looks."""
    label = QLabel(text)
    label.setProperty("role", "heading")
    label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
    font = small_font(label.font())
    font.setWeight(QFont.Weight.DemiBold)
    if capitals:
        font.setCapitalization(QFont.Capitalization.AllUppercase)
        font.setLetterSpacing(QFont.SpacingType.PercentageSpacing, 104)
    label.setFont(font)
    return label


class Paragraph(QLabel):
    """Secondary text in lines as wide as there is room, and just as high as they need.

    A wrapping `QLabel` would make its whole column trade height for width, and keep the lists in it from
    shrinking; this one settles its own height whenever its width or its text changes.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "secondary")
        self.setWordWrap(True)

    def hasHeightForWidth(self) -> bool:
        """Never: the height is settled here."""
        return False

    def setText(self, text: str) -> None:
        """Show another text."""
        super().setText(text)
        self._settle()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Break the lines anew."""
        super().resizeEvent(event)
        self._settle()

    def _settle(self) -> None:
        width = max(self.width(), 1)
        box = self.fontMetrics().boundingRect(0, 0, width, 10_000, Qt.TextFlag.TextWordWrap, self.text())
        self.setFixedHeight(box.height() + 2)


def small_font(font: QFont) -> QFont:
    """Return the same font, two pixels smaller, with figures of one width."""
    small = QFont(font)
    if font.pixelSize() > 0:
        small.setPixelSize(max(font.pixelSize() - 2, 9))
    else:
        small.setPointSizeF(max(font.pointSizeF() - 1.5, 7.0))
    return tabular(small)


def tabular(font: QFont) -> QFont:
    """Return the same font with figures of one width: numbers do not dance while they change."""
    result = QFont(font)
    result.setFeature(QFont.Tag("tnum"), 1)
    return result


def segmented(buttons: list[QToolButton]) -> QHBoxLayout:
    """Lay buttons out as one segmented control."""
    layout = QHBoxLayout()
    layout.setSpacing(0)
    last = len(buttons) - 1
    for i, button in enumerate(buttons):
        button.setProperty("segment", "left" if i == 0 else "right" if i == last else "middle")
        layout.addWidget(button)
    return layout


def describe(widget: QWidget, name: str, tip: str) -> None:
    """Give a control its accessible name and its tooltip."""
    widget.setAccessibleName(name)
    widget.setToolTip(tip)


class ComboBox(QComboBox):
    """A combo box that leaves the wheel to the panel it scrolls in."""

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Pass on: a wheel meant for scrolling must not change the curve."""
        event.ignore()
