"""The sheet of shortcuts: what every key does, and what the mouse does on the canvas."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from theditor.app.command import plain

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

ON_CANVAS, ON_LIST = "On the canvas", "In the list of curves"
_COLUMNS = 3
_MOUSE = (
    ("Drag a point", "Move the selected control points"),
    ("Drag the curve", "Pull it, which changes λ"),
    ("Drag a joint", "Slide it, which changes λ"),
    ("Drag the ground", "Select the points in a rectangle"),
    ("Drag a box handle", "Scale or turn the selected points"),
    ("Click again", "Reach what lies beneath"),
    ("Double-click the curve", "Insert a point; Ctrl: on the polygon"),
    ("Tab, Shift+Tab, F6", "Step through the points; leave"),
    ("Arrow keys", "Nudge; Shift: ten steps, Ctrl: a pixel"),
    ("Enter, Backspace", "With the pen: end, take a point back"),
    ("Shift", "Add points and curves; suspend snapping"),
    ("Ctrl", "Keep to the horizontal or vertical"),
    ("Escape", "Take a drag back; select nothing"),
    ("Wheel, pinch", "Zoom at the pointer"),
    ("Two fingers", "Pan; with Ctrl: zoom"),
    ("Space or middle button", "Pan"),
    ("Right button, menu key", "What can be done here"),
)


class Shortcuts(QDialog):
    """All keys by menu, and the mouse, on one sheet."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self.setWindowTitle("Keys and mouse")
        self.resize(1000, 620)
        self.groups = keys_by_place(window)
        self.groups["With the mouse"] = list(_MOUSE)
        sheet = QWidget()
        columns = QHBoxLayout(sheet)
        columns.setSpacing(32)
        stacks = [QVBoxLayout() for _ in range(_COLUMNS)]
        heights = [0] * _COLUMNS
        for title, rows in sorted(self.groups.items(), key=lambda group: -len(group[1])):
            shortest = heights.index(min(heights))
            stacks[shortest].addWidget(_group(title, rows), 0, Qt.AlignmentFlag.AlignTop)
            heights[shortest] += len(rows) + 2
        for stack in stacks:
            stack.addStretch(1)
            columns.addLayout(stack)
        scroll = QScrollArea()
        scroll.setAccessibleName("Keys and mouse")
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setWidget(sheet)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addWidget(scroll)
        layout.addWidget(buttons)


def keys_by_place(window: MainWindow) -> dict[str, list[tuple[str, str]]]:
    """The key of each command that has one, and its text, by its menu or by where alone the key acts."""
    groups: dict[str, list[tuple[str, str]]] = {}
    for command in window.commands:
        key = window.actions_by_name[command.name].shortcut()
        if not key.isEmpty():
            title = command.menu.partition("/")[0]
            title = ON_CANVAS if command.on_canvas else ON_LIST if command.on_list else title
            text = key.toString(QKeySequence.SequenceFormat.NativeText)
            groups.setdefault(title, []).append((text, plain(command.text)))
    return groups


def _group(title: str, rows: list[tuple[str, str]]) -> QWidget:
    group = QWidget()
    grid = QGridLayout(group)
    grid.setContentsMargins(0, 0, 0, 12)
    grid.setVerticalSpacing(4)
    grid.setHorizontalSpacing(12)
    heading = QLabel(title)
    heading.setProperty("role", "heading")
    grid.addWidget(heading, 0, 0, 1, 2)
    for number, (keys, what) in enumerate(rows, start=1):
        key = QLabel(keys)
        key.setProperty("role", "secondary")
        key.setAlignment(Qt.AlignmentFlag.AlignTop)
        words = QLabel(what)
        words.setWordWrap(True)
        grid.addWidget(key, number, 0)
        grid.addWidget(words, number, 1)
    grid.setColumnStretch(1, 1)
    return group
