"""The history panel: every step that can be taken back or done once more, and the way to any of them."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QAbstractListModel, QItemSelectionModel, QModelIndex, Qt
from PySide6.QtGui import QFont
from PySide6.QtWidgets import QVBoxLayout, QWidget

from theditor.model import Document
from theditor.model.item_index import NO_INDEX, ModelIndex
from theditor.panels.parts import describe
from theditor.panels.rows import RowList

_START = "Start"


class HistoryModel(QAbstractListModel):
    """The states of a document: its start, then the one after each step."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._stack = document.undo_stack
        self._count = self._stack.count()
        document.stepped.connect(self._follow)

    def rowCount(self, parent: ModelIndex = NO_INDEX) -> int:
        """One more than there are steps."""
        return 0 if parent.isValid() else self._count + 1

    def data(self, index: ModelIndex, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """The step that led to a state; the saved state is marked, those undone are quiet."""
        row = index.row()
        if role == Qt.ItemDataRole.DisplayRole:
            text = self._stack.text(row - 1) if row else _START
            return f"{text} · saved" if row == self._stack.cleanIndex() else text
        if role == Qt.ItemDataRole.FontRole and row > self._stack.index():
            font = QFont()
            font.setItalic(True)
            return font
        return None

    def _follow(self) -> None:
        before, now = self._count, self._stack.count()
        if now > before:
            self.beginInsertRows(QModelIndex(), before + 1, now)
            self._count = now
            self.endInsertRows()
        elif now < before:
            self.beginRemoveRows(QModelIndex(), now + 1, before)
            self._count = now
            self.endRemoveRows()
        self.dataChanged.emit(self.index(0), self.index(now))


class HistoryPanel(QWidget):
    """A list of the states; choosing one goes there at once."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._following = False
        self.model = HistoryModel(document, self)
        self.list = RowList(least=3, greatest=12)
        self.list.setModel(self.model)
        self.list.setSelectionMode(RowList.SelectionMode.SingleSelection)
        describe(self.list, "Undo history", "Every step so far; choose one to go back to it, or on again")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 4, 8, 8)
        layout.addWidget(self.list)
        self.list.selectionModel().currentChanged.connect(self._go)
        document.stepped.connect(self._follow)
        self._follow()

    def _go(self, current: QModelIndex) -> None:
        if current.isValid() and not self._following:
            self._document.jump(current.row())

    def _follow(self) -> None:
        self._following = True
        row = self.model.index(self._document.undo_stack.index())
        self.list.selectionModel().setCurrentIndex(row, QItemSelectionModel.SelectionFlag.ClearAndSelect)
        self.list.scrollTo(row)
        self._following = False
