"""The curve panel: name, degree, ends, colour and width of the current curve."""

from __future__ import annotations

from typing import Any, NamedTuple

from PySide6.QtCore import QEvent, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QIcon, QKeyEvent, QKeySequence, QPainter, QPen, QPixmap
from PySide6.QtWidgets import QColorDialog, QGridLayout, QLabel, QLineEdit, QToolButton, QWidget

from theditor.drawing import Drawing, DrawingError, Item
from theditor.drawing.drawing import NAME_LENGTH, WIDTH_RANGE
from theditor.model import Document, Selection, colours_for, reshape, unbreakable, words
from theditor.panels.number_field import NumberField
from theditor.panels.parts import GAP, ComboBox, column, describe, heading, row
from theditor.panels.rows import swatch_outline
from theditor.spline import Curve, Ends

_DEGREES = {2: "Quadratic · C¹", 3: "Cubic · C²"}
_WIDTH_STEP = 0.5


class _EndsChoice(NamedTuple):
    closed: bool
    ends: Ends
    label: str


_ENDS = (
    _EndsChoice(False, "free", "Open, free ends"),
    _EndsChoice(False, "clamped", "Open, clamped ends"),
    _EndsChoice(True, "free", "Closed"),
)


@unbreakable
class _NameField(QLineEdit):
    """A line of text that leaves undo and redo to the document while nothing is being typed."""

    def event(self, event: QEvent) -> bool:
        """Claim undo and redo only for what was typed here."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride:
            keys = QKeySequence.StandardKey
            if not self.isModified() and (event.matches(keys.Undo) or event.matches(keys.Redo)):
                event.ignore()
                return False
        return super().event(event)


class CurvePanel(QWidget):
    """Shows and edits what the current curve is as a whole."""

    announce = Signal(str)
    """A sentence for the status line."""

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._selection = document, selection
        self._item: Item | None = None
        self._shown_kind: object = None

        self.name = _NameField()
        self.name.setMaxLength(NAME_LENGTH)
        self.degree = ComboBox()
        self.degree.addItems(list(_DEGREES.values()))
        self.ends = ComboBox()
        self.ends.addItems([choice.label for choice in _ENDS])
        self.colour = QToolButton()
        self.colour.setIconSize(QSize(36, 14))
        self.width_field = NumberField(*WIDTH_RANGE)
        self._controls = {
            self.name: ("Name of the curve", "Name of the curve"),
            self.degree: (
                "Degree",
                "Degree: quadratic curves are C¹, cubic ones C²; the shape is kept as well as possible",
            ),
            self.ends: (
                "Ends",
                "How the curve ends: free as the basis has it, clamped to its end points, or closed; "
                "the shape is kept as well as possible",
            ),
            self.colour: ("Line colour", "Colour of the line, in lists and exports"),
            self.width_field: ("Line width", "Width of the line in pixels, 0.1 to 100"),
        }

        layout = column(self)
        layout.addWidget(heading("Curve"))
        grid = QGridLayout()
        grid.setHorizontalSpacing(GAP)
        grid.setVerticalSpacing(GAP)
        grid.setColumnStretch(1, 1)
        grid.setColumnStretch(2, 1)
        for line, (text, control) in enumerate(
            (("Name", self.name), ("Degree", self.degree), ("Line", self.colour))
        ):
            label = QLabel(text)
            label.setBuddy(control)
            grid.addWidget(label, line, 0)
        grid.addWidget(self.name, 0, 1, 1, 2)
        grid.addWidget(self.degree, 1, 1)
        grid.addWidget(self.ends, 1, 2)
        grid.addWidget(self.colour, 2, 1)
        width_label = QLabel("Width")
        width_label.setBuddy(self.width_field)
        width_row = row(width_label, self.width_field)
        width_row.setStretch(1, 1)
        grid.addLayout(width_row, 2, 2)
        layout.addLayout(grid)

        self.name.editingFinished.connect(self._rename)
        self.degree.activated.connect(self._set_degree)
        self.ends.activated.connect(self._set_ends)
        self.colour.clicked.connect(self.choose_colour)
        self.width_field.entered.connect(lambda width: self._set_style("Change line width", width=width))
        self.width_field.stepped.connect(self._step_width)
        self.width_field.refused.connect(self.announce)
        document.changed.connect(self._follow)
        selection.changed.connect(self._follow)
        self._show_guard()
        self._follow()

    # Edits

    def _rename(self) -> None:
        item = self._item
        self.name.setModified(False)
        if item is None or self.name.text() == item.name:
            return
        try:
            named = item.with_(name=self.name.text())
            self._document.apply(
                "Rename curve", self._document.drawing.with_item(self._selection.curve, named)
            )
        except DrawingError as error:
            self.name.setText(item.name)
            self.name.setCursorPosition(0)
            self.announce.emit(str(error))

    def _set_style(self, text: str, merge: object = None, **changes: Any) -> None:
        """Change the style of the selected curves that are not locked."""
        items, chosen = list(self._document.drawing), self._selection.curves
        for i in chosen:
            if not items[i].locked:
                items[i] = items[i].with_(**changes)
        of = "" if len(chosen) == 1 else f" of {len(chosen)} curves"
        self._document.apply(text + of, Drawing(items), merge)

    def _step_width(self, steps: int) -> None:
        if self._item is not None:
            least, most = WIDTH_RANGE
            width = min(max(self._item.width + steps * _WIDTH_STEP, least), most)
            self._set_style("Change line width", merge=self._selection.curves, width=width)

    def _set_degree(self, choice: int) -> None:
        reshape.set_degree(self._document, self._selection, list(_DEGREES)[choice], self.announce.emit)
        self._show_what_is()

    def _set_ends(self, choice: int) -> None:
        chosen = _ENDS[choice]
        if chosen.closed:
            reshape.close(self._document, self._selection, self.announce.emit)
        else:
            reshape.set_ends(self._document, self._selection, chosen.ends, self.announce.emit)
        self._show_what_is()

    def _show_what_is(self) -> None:
        """Show degree and ends as they are: an edit may still go on, and can be called off."""
        self._shown_kind = None
        if self._item is not None:
            self._show_kind(self._item.curve)

    def choose_colour(self) -> None:
        """Ask for another colour of the selected curves."""
        chosen = [self._document.drawing[i] for i in self._selection.curves]
        if self._item is None:
            return
        if all(item.locked for item in chosen):
            self.announce.emit(words.locked_reason(self._item.name))
        else:
            colour = QColorDialog.getColor(QColor(self._item.color), self, "Colour of the line")
            if colour.isValid():
                self._set_style("Change line colour", color=colour.name())

    # Following

    def _follow(self) -> None:
        item = self._selection.item
        if item is self._item:
            return
        old, self._item = self._item, item
        if item is None:
            self.name.clear()
            self.width_field.show_value(None)
            self.width_field.lineEdit().setPlaceholderText("")
            self._shown_kind = None
        else:
            self._show_style(old, item)
            self._show_kind(item.curve)
        if item is None or old is None or (item.locked, item.name) != (old.locked, old.name):
            self._show_guard()

    def _show_style(self, old: Item | None, item: Item) -> None:
        if old is None or old.name != item.name:
            self.name.setText(item.name)
        if old is None or old.color != item.color:
            self._show_colour(item.color)
        self.width_field.show_value(item.width)

    def _show_colour(self, colour: str) -> None:
        self.colour.setIcon(_swatch(colour, swatch_outline(colours_for(self.palette()))))
        self.colour.setAccessibleDescription(colour)

    def changeEvent(self, event: QEvent) -> None:
        """Draw the swatch for the new colours."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and self._item is not None:
            self._show_colour(self._item.color)

    def _show_kind(self, curve: Curve) -> None:
        """Show degree and ends."""
        kind = (curve.degree, curve.closed, curve.ends)
        if kind == self._shown_kind:
            return
        self._shown_kind = kind
        self.degree.setCurrentIndex(list(_DEGREES).index(curve.degree))
        ends = next(i for i, c in enumerate(_ENDS) if (c.closed if curve.closed else c.ends == curve.ends))
        self.ends.setCurrentIndex(ends)

    def _show_guard(self) -> None:
        item = self._item
        reason = ""
        if item is None:
            reason = "There is no curve: add one in the list of curves."
        elif item.locked:
            reason = words.locked_reason(item.name)
        for control, (name, tip) in self._controls.items():
            control.setEnabled(not reason)
            describe(control, name, reason or tip)


def _swatch(colour: str, outline: QColor) -> QIcon:
    pixmap = QPixmap(72, 28)
    pixmap.setDevicePixelRatio(2.0)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(outline, 1.0))
    painter.setBrush(QColor(colour))
    painter.drawRoundedRect(QRectF(0.5, 0.5, 35, 13), 3, 3)
    painter.end()
    return QIcon(pixmap)
