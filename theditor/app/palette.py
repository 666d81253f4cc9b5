"""The command palette: type a few letters of what you want to do."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QKeyEvent, QKeySequence
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QHeaderView,
    QLineEdit,
    QMenu,
    QMenuBar,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from theditor.app.command import plain

_ROWS = 12


class Palette(QDialog):
    """Finds commands by words among all that the menus hold; Enter runs the one that is marked."""

    def __init__(self, menus: QMenuBar | QMenu, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Find a command")
        self.resize(560, 440)
        self._offers = list(_leaves(menus, ""))
        self.field = QLineEdit()
        self.field.setPlaceholderText("What do you want to do?")
        self.field.setAccessibleName("Words of a command")
        self.table = QTableWidget(0, 3)
        self.table.setAccessibleName("Commands")
        self.table.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.table.setShowGrid(False)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.horizontalHeader().hide()
        self.table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.table.horizontalHeader().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        self.table.verticalHeader().hide()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(12, 12, 12, 12)
        layout.setSpacing(8)
        layout.addWidget(self.field)
        layout.addWidget(self.table)
        self.field.textChanged.connect(self._filter)
        self.field.returnPressed.connect(self._run)
        self.table.cellClicked.connect(self._run)
        self._filter("")

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Up and Down mark another command while the field keeps the focus."""
        steps = {
            Qt.Key.Key_Up: -1,
            Qt.Key.Key_Down: 1,
            Qt.Key.Key_PageUp: -_ROWS,
            Qt.Key.Key_PageDown: _ROWS,
        }
        step = steps.get(Qt.Key(event.key()))
        if step is None:
            super().keyPressEvent(event)
        elif self._found:
            self.table.selectRow(min(max(self.table.currentRow() + step, 0), len(self._found) - 1))

    def _filter(self, text: str) -> None:
        """List what holds every word; what can be done now, and what begins with the words, comes first."""
        words = text.casefold().split()
        found = [offer for offer in self._offers if all(word in offer[0].casefold() for word in words)]

        def rank(offer: tuple[str, QAction]) -> tuple[bool, bool]:
            name = plain(offer[1].text()).casefold()
            return not offer[1].isEnabled(), not name.startswith(tuple(words[:1]))

        self._found = [action for _, action in sorted(found, key=rank)]
        self.table.setRowCount(len(self._found))
        for row, action in enumerate(self._found):
            path = next(path for path, offered in self._offers if offered is action).rpartition(" › ")[0]
            key = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
            mark = "✓ " if action.isChecked() else ""
            for column, shown in enumerate((mark + plain(action.text()), path, key)):
                item = QTableWidgetItem(shown)
                item.setToolTip(action.statusTip())
                if not action.isEnabled():
                    item.setFlags(Qt.ItemFlag.ItemIsSelectable)
                self.table.setItem(row, column, item)
        self.table.selectRow(0)

    def _run(self) -> None:
        row = self.table.currentRow()
        if 0 <= row < len(self._found) and self._found[row].isEnabled():
            self.accept()
            self._found[row].trigger()


def _leaves(menus: QMenuBar | QMenu, path: str) -> Iterator[tuple[str, QAction]]:
    """Everything that menus hold, with its path: ``View › Theme › Dark``."""
    for action in menus.actions():
        name = path + plain(action.text())
        menu = action.menu()
        if isinstance(menu, QMenu):
            yield from _leaves(menu, f"{name} › ")
        elif not action.isSeparator():
            yield name, action
