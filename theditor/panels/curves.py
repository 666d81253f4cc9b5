"""The curves panel: every curve of the drawing, which of them is current, visible, locked."""

from __future__ import annotations

import re

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QToolButton, QWidget

from theditor.drawing import Drawing, DrawingError, Item
from theditor.drawing.drawing import NAME_LENGTH
from theditor.model import Document, Selection, words
from theditor.panels.curve_list import CurveList, CurveModel
from theditor.panels.parts import column, describe, heading

_LIST_TIP = (
    "Curves of the drawing, the topmost last. Double-click or F2 renames; eye and lock can be clicked; "
    "a drag or Ctrl with an arrow key reorders."
)


class CurvesPanel(QWidget):
    """Lists the curves; the current row is the curve being edited."""

    announce = Signal(str)
    """A sentence for the status line."""

    add_requested = Signal()
    """A new curve is wanted; where it goes depends on the view."""

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._selection = document, selection
        self._following = False
        self.model = CurveModel(document.drawing, self)
        self.list = CurveList()
        self.list.setModel(self.model)
        describe(self.list, "Curves", _LIST_TIP)
        self.add_button = _button("Add", "Add a curve", "Add a curve in the middle of the view")
        self.duplicate_button = _button("Duplicate", "Duplicate curve", "")
        self.delete_button = _button("Delete", "Delete curve", "")

        layout = column(self)
        layout.setContentsMargins(0, 12, 0, 12)
        title = heading("Curves")
        title.setContentsMargins(16, 0, 16, 0)
        layout.addWidget(title)
        layout.addWidget(self.list)
        buttons = QHBoxLayout()
        buttons.setContentsMargins(16, 0, 16, 0)
        buttons.setSpacing(8)
        for button in (self.add_button, self.duplicate_button, self.delete_button):
            buttons.addWidget(button)
        buttons.addStretch(1)
        layout.addLayout(buttons)

        self.add_button.clicked.connect(self.add_requested)
        self.duplicate_button.clicked.connect(self.duplicate)
        self.delete_button.clicked.connect(self.delete)
        self.model.renamed.connect(self._rename)
        self.list.eye_clicked.connect(self._toggle_visible)
        self.list.lock_clicked.connect(self._toggle_locked)
        self.list.dragged.connect(self._reorder)
        self.list.selectionModel().currentChanged.connect(self._select)
        document.changed.connect(self._follow)
        selection.changed.connect(self._show_current)
        self._show_current()

    def duplicate(self) -> None:
        """Put a copy of the current curve on top of it, and make the copy current."""
        item, index = self._selection.item, self._selection.curve
        if item is None:
            return
        drawing = self._document.drawing
        name = _copy_name(item.name, {other.name for other in drawing})
        copy = item.with_(name=name, locked=False)
        self._document.apply("Duplicate curve", drawing.inserted(index + 1, copy))
        self._selection.select(curve=index + 1)
        self.announce.emit(f"“{name}” lies on top of “{item.name}”: drag its points to move it away.")

    def delete(self) -> None:
        """Delete the current curve."""
        item = self._selection.item
        if item is None:
            return
        if item.locked:
            self.announce.emit(words.locked_reason(item.name))
            return
        self._document.apply("Delete curve", self._document.drawing.without(self._selection.curve))
        self.announce.emit(f"“{item.name}” is deleted; Undo brings it back.")

    def rename(self) -> None:
        """Let the name of the current curve be typed in its row."""
        self.list.setFocus()
        self.list.edit(self.list.currentIndex())

    def toggle_visible(self) -> None:
        """Hide the current curve, or show it."""
        self._toggle_visible(self._selection.curve)

    def toggle_locked(self) -> None:
        """Lock the current curve, or unlock it."""
        self._toggle_locked(self._selection.curve)

    def reorder(self, step: int) -> None:
        """Move the current curve by that many places in the list, as far as it goes."""
        self._reorder(self._selection.curve, self._selection.curve + step)

    def _reorder(self, row: int, place: int) -> None:
        """Take the curve of a row to another place; it becomes the current one and keeps what is selected on it."""
        drawing, selection = self._document.drawing, self._selection
        place = min(max(place, 0), len(drawing) - 1)
        if row == place:
            return
        kept = (selection.points, selection.segments) if row == selection.curve else ((), ())
        self._document.apply("Reorder curves", drawing.without(row).inserted(place, drawing[row]))
        selection.select(curve=place, points=kept[0], segments=kept[1])
        where = "beneath" if place < row else "above"
        neighbour = self._document.drawing[place + 1 if place < row else place - 1]
        self.announce.emit(f"“{drawing[row].name}” lies {where} “{neighbour.name}” now.")

    def _rename(self, row: int, name: str) -> None:
        drawing = self._document.drawing
        if drawing[row].locked:
            self.announce.emit(words.locked_reason(drawing[row].name))
            return
        try:
            item = drawing[row].with_(name=name)
        except DrawingError as error:
            self.announce.emit(str(error))
        else:
            self._replace("Rename curve", row, item)

    def _toggle_visible(self, row: int) -> None:
        item = self._document.drawing[row]
        text = "Hide curve" if item.visible else "Show curve"
        self._document.apply(
            text, self._document.drawing.with_item(row, item.with_(visible=not item.visible))
        )

    def _toggle_locked(self, row: int) -> None:
        item = self._document.drawing[row]
        text = "Unlock curve" if item.locked else "Lock curve"
        self._replace(text, row, item.with_(locked=not item.locked))

    def _replace(self, text: str, row: int, item: Item) -> None:
        self._document.apply(text, self._document.drawing.with_item(row, item))

    def _select(self) -> None:
        index = self.list.currentIndex()
        if not self._following and index.isValid():
            self._selection.select(curve=index.row())

    def _follow(self, old: Drawing, new: Drawing) -> None:
        # Rows that come and go make the list move its current row: that is no wish of the person's.
        self._following = True
        self.model.show_drawing(new)
        self._following = False
        if len(old) != len(new):
            self.list.updateGeometry()
        self._show_current()

    def _show_current(self) -> None:
        drawing, row = self.model.drawing, self._selection.curve
        if drawing is not self._document.drawing:
            return
        if self.list.currentIndex().row() != row:
            self._following = True
            self.list.setCurrentIndex(self.model.index(row))
            self._following = False
        item = self._selection.item
        none = "There is no curve: add one first."
        self.duplicate_button.setEnabled(item is not None)
        self.duplicate_button.setToolTip("Put a copy of the current curve on top of it" if item else none)
        self.delete_button.setEnabled(item is not None and not item.locked)
        reason = none if item is None else words.locked_reason(item.name) if item.locked else ""
        self.delete_button.setToolTip(reason or "Delete the current curve")


def _button(text: str, name: str, tip: str) -> QToolButton:
    button = QToolButton()
    button.setText(text)
    describe(button, name, tip)
    return button


def _copy_name(name: str, taken: set[str]) -> str:
    stem = re.sub(r" copy( \d+)?$", "", name[: NAME_LENGTH - 12]) + " copy"
    candidates = (stem if i == 1 else f"{stem} {i}" for i in range(1, len(taken) + 2))
    return next(candidate for candidate in candidates if candidate not in taken)
