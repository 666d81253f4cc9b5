"""The curves panel: every curve of the drawing, which of them is current, visible, locked."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QItemSelection, QItemSelectionModel, Signal
from PySide6.QtWidgets import QHBoxLayout, QToolButton, QWidget

from theditor.drawing import Drawing, DrawingError, Item
from theditor.model import Document, Selection, words
from theditor.model.naming import copy_name
from theditor.panels.curve_list import CurveList, CurveModel
from theditor.panels.parts import column, describe, heading
from theditor.panels.segment_model import runs

_LIST_TIP = (
    "Curves of the drawing, the topmost last. Ctrl+click and Shift+click select several. Double-click or F2 renames, "
    "a double click on the colour recolours; eye and lock can be clicked; a drag or Ctrl with an arrow key reorders."
)


class CurvesPanel(QWidget):
    """Lists the curves; those selected are the selected rows, and the current row is the curve being edited."""

    announce = Signal(str)
    """A sentence for the status line."""

    recolour_requested = Signal()
    """The current curve, and those selected with it, want another colour."""

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
        layout.setContentsMargins(0, 12, 0, 9)
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
        self.list.swatch_clicked.connect(self.recolour_requested)
        self.list.dragged.connect(self._reorder)
        self.list.selectionModel().currentChanged.connect(self._select)
        self.list.selectionModel().selectionChanged.connect(self._select)
        document.changed.connect(self._follow)
        selection.changed.connect(self._show_current)
        self._show_current()

    def duplicate(self) -> None:
        """Put a copy of each selected curve on top of it, and select the copies' points, to be moved away."""
        chosen, current = self._selection.curves, self._selection.curve
        if not chosen:
            return
        items: list[Item] = []
        copies: list[int] = []
        names = {item.name for item in self._document.drawing}
        for i, item in enumerate(self._document.drawing):
            items.append(item)
            if i in self._selection.chosen:
                name = copy_name(item.name, names)
                names.add(name)
                copies.append(len(items))
                items.append(item.with_(name=name, locked=False))
        what = _counted(len(copies))
        self._document.apply(f"Duplicate {what}", Drawing(items))
        points = {i: np.arange(len(items[i].curve.control_points)) for i in copies}
        self._selection.select_across(points, copies[chosen.index(current)])
        if len(copies) == 1:
            copy, original = items[copies[0]].name, items[copies[0] - 1].name
            self.announce.emit(f"“{copy}” lies on top of “{original}”: drag a point to move it away.")
        else:
            self.announce.emit(f"{len(copies)} copies lie on top of their curves: move them away.")

    def delete(self) -> None:
        """Delete the selected curves, but for locked ones."""
        drawing, chosen = self._document.drawing, self._selection.curves
        gone = {i for i in chosen if not drawing[i].locked}
        if not gone:
            self._explain_lock(chosen)
            return
        left = Drawing(item for i, item in enumerate(drawing) if i not in gone)
        self._document.apply(f"Delete {_counted(len(gone))}", left)
        what = f"“{drawing[min(gone)].name}” is" if len(gone) == 1 else f"{len(gone)} curves are"
        kept = len(chosen) - len(gone)
        locked = f" {words.counted(kept, 'locked curve')} stayed." if kept else ""
        self.announce.emit(f"{what} deleted; Undo brings {'it' if len(gone) == 1 else 'them'} back.{locked}")

    def _explain_lock(self, curves: Sequence[int]) -> None:
        drawing = self._document.drawing
        if len(curves) == 1:
            self.announce.emit(words.locked_reason(drawing[curves[0]].name))
        elif curves:
            self.announce.emit(
                f"All {len(curves)} curves are locked: unlock one in the list of curves to change it."
            )

    def rename(self) -> None:
        """Let the name of the current curve be typed in its row."""
        self.list.setFocus()
        self.list.edit(self.list.currentIndex())

    def toggle_visible(self) -> None:
        """Hide the selected curves or, if all of them are hidden, show them."""
        hide = any(self._document.drawing[i].visible for i in self._selection.curves)
        self._style("Hide" if hide else "Show", self._selection.curves, visible=not hide)

    def toggle_locked(self) -> None:
        """Lock the selected curves or, if all of them are locked, unlock them."""
        lock = not all(self._document.drawing[i].locked for i in self._selection.curves)
        self._style("Lock" if lock else "Unlock", self._selection.curves, locked=lock)

    def reorder(self, step: int) -> None:
        """Move the current curve by that many places in the list, as far as it goes."""
        self._reorder(self._selection.curve, self._selection.curve + step)

    def _reorder(self, row: int, place: int) -> None:
        """Take the curve of a row to another place; it becomes the current one."""
        drawing, selection = self._document.drawing, self._selection
        place = min(max(place, 0), len(drawing) - 1)
        if row == place:
            return
        self._document.apply("Reorder curves", drawing.without(row).inserted(place, drawing[row]))
        if place != selection.curve:
            selection.select(curve=place)
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
            self._document.apply("Rename curve", drawing.with_item(row, item))

    def _toggle_visible(self, row: int) -> None:
        visible = self._document.drawing[row].visible
        self._style("Hide" if visible else "Show", [row], visible=not visible)

    def _toggle_locked(self, row: int) -> None:
        locked = self._document.drawing[row].locked
        self._style("Unlock" if locked else "Lock", [row], locked=not locked)

    def _style(self, verb: str, rows: Sequence[int], **changes: bool) -> None:
        items = list(self._document.drawing)
        for row in rows:
            items[row] = items[row].with_(**changes)
        self._document.apply(f"{verb} {_counted(len(rows))}", Drawing(items))

    def _select(self) -> None:
        """Select the curves of the selected rows; points stay selected on those that were selected already."""
        rows = sorted(index.row() for index in self.list.selectionModel().selectedIndexes())
        if self._following or not rows:
            return
        wanted = self.list.currentIndex().row()
        current = wanted if wanted in rows else rows[-1]
        if rows == [current]:
            self._selection.select(curve=current)
        else:
            chosen = self._selection.chosen
            self._selection.select_across({row: chosen.get(row, ()) for row in rows}, current)
        if wanted in rows:  # else the list is about to select it
            self._show_current()

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
        self._following = True
        self._show_rows(row)
        self._following = False
        chosen = self._selection.curves
        none = "There is no curve: add one first."
        what = "the current curve" if len(chosen) == 1 else f"the {len(chosen)} selected curves"
        self.duplicate_button.setEnabled(bool(chosen))
        on_top = "on top of it" if len(chosen) == 1 else "on top of each"
        self.duplicate_button.setToolTip(f"Put a copy of {what} {on_top}" if chosen else none)
        free = not all(drawing[i].locked for i in chosen)
        self.delete_button.setEnabled(free)
        locked = words.locked_reason(drawing[row].name) if chosen else none
        self.delete_button.setToolTip(f"Delete {what}" if free else locked)

    def _show_rows(self, current: int) -> None:
        """Select the rows of the selected curves."""
        model, chosen = self.list.selectionModel(), self._selection.curves
        flags = QItemSelectionModel.SelectionFlag
        if self.list.currentIndex().row() != current:
            model.setCurrentIndex(self.model.index(current), flags.NoUpdate)
        if tuple(sorted(index.row() for index in model.selectedIndexes())) != chosen:
            rows = QItemSelection()
            for first, last in runs(chosen):
                rows.select(self.model.index(first), self.model.index(last))
            model.select(rows, flags.ClearAndSelect)


def _counted(count: int) -> str:
    """What an edit of whole curves is about: ``curve`` or ``3 curves``."""
    return "curve" if count == 1 else f"{count} curves"


def _button(text: str, name: str, tip: str) -> QToolButton:
    button = QToolButton()
    button.setText(text)
    describe(button, name, tip)
    return button
