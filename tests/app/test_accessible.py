"""The window without eyes or without a mouse: mnemonics, names, the way of the focus, a small screen."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QAbstractScrollArea,
    QAbstractSpinBox,
    QApplication,
    QDockWidget,
    QMenu,
    QTabBar,
    QWidget,
)

from theditor.app.letters import lettered


def mnemonics(actions):
    """The underlined letter of each action that has a text, by its text."""
    texts = [action.text().replace("&&", "") for action in actions if not action.isSeparator()]
    return {text: text[text.index("&") + 1].lower() if "&" in text else None for text in texts}


def clashes(menu, title=""):
    """Entries without a letter, or with that of another one, in a menu and all below it."""
    letters = mnemonics(menu.actions())
    faults = [
        f"{title}{text}" for text, letter in letters.items() if list(letters.values()).count(letter) > 1
    ]
    faults += [f"{title}{text} has none" for text, letter in letters.items() if letter is None]
    for action in menu.actions():
        below = action.menu()
        if isinstance(below, QMenu) and below.objectName() != "recent":
            faults += clashes(below, f"{title}{action.text()} › ")
    return faults


def test_every_entry_of_a_menu_has_a_letter_of_its_own(window):
    assert clashes(window.menuBar()) == []


@pytest.mark.parametrize("place", ["point", "segment", "ground", "curve"])
def test_no_two_entries_of_a_context_menu_share_a_letter(window, place):
    assert clashes(window.context_menus.menu(place)) == []


def test_letters_are_wishes_and_each_is_granted_once_in_a_menu():
    one, both, other = frozenset("a"), frozenset("ab"), frozenset("b")
    texts = lettered([("&Open", one), ("&Order", both), ("O&pen", other), ("Rod", both)], {"a": "r"})
    assert texts == ["&Open", "Or&der", "O&pen", "Rod"]


def focusable(window):
    return [
        widget
        for widget in window.findChildren(QWidget)
        if widget.focusPolicy() & Qt.FocusPolicy.TabFocus
        and widget.isVisibleTo(window)
        and not isinstance(widget.parent(), QAbstractScrollArea | QAbstractSpinBox)  # those speak for it
    ]


def name_of(widget):
    return widget.accessibleName() or getattr(widget, "text", str)()


def test_every_control_has_a_name(window):
    for dock in window.findChildren(QDockWidget):
        dock.raise_()
        QApplication.processEvents()
        nameless = [w for w in focusable(window) if not name_of(w) and not isinstance(w, QTabBar)]
        assert nameless == [], dock.objectName()


def test_every_command_explains_itself(window):
    for command in window.commands:
        action = window.actions_by_name[command.name]
        assert isinstance(action, QAction)
        assert len(action.statusTip()) > 10
        assert action.toolTip().startswith(action.statusTip()) or command.name in ("undo", "redo")


def test_tab_goes_down_the_column_of_panels(window, qtbot):
    window.curves.list.setFocus()
    visited = []
    for _ in range(60):
        panel = QApplication.focusWidget()
        while panel is not None and panel not in (window.curves, window.curve, window.shape, window.segments):
            panel = panel.parentWidget()
        if panel is not None and (not visited or visited[-1] is not panel):
            visited.append(panel)
        qtbot.keyClick(QApplication.focusWidget(), Qt.Key.Key_Tab)
        if len(visited) > 4:
            break
    assert visited[:4] == [window.curves, window.curve, window.shape, window.segments]
