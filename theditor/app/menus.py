"""Menus and toolbar, made from the table of commands."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QDockWidget, QMenu, QToolBar

from theditor.app.actions import Command, make_action
from theditor.app.theme import Theme, choose_theme, chosen_theme

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


def build_menus(window: MainWindow, table: tuple[Command, ...]) -> dict[str, QAction]:
    """Fill the menu bar and the toolbar; return the actions by the names of their commands."""
    actions: dict[str, QAction] = {}
    menus: dict[str, QMenu] = {}
    for command in table:
        menu = menus.get(command.menu) or window.menuBar().addMenu("&" + command.menu)
        menus[command.menu] = menu
        if command.gap:
            menu.addSeparator()
        action = make_action(window, command)
        actions[command.name] = action
        menu.addAction(action)
    menus["File"].insertMenu(actions["gallery"], _recent_menu(window))
    _add_themes_and_panels(window, menus["View"])
    window.addToolBar(_toolbar([(command, actions[command.name]) for command in table if command.brief]))
    return actions


def _toolbar(buttons: list[tuple[Command, QAction]]) -> QToolBar:
    """A button for each command with a brief text, in groups by what their names begin with."""
    toolbar = QToolBar("Toolbar")
    toolbar.setObjectName("toolbar")
    toolbar.setMovable(False)
    toolbar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
    group = ""
    for command, action in buttons:
        part = command.name.split("_")[0]
        if group and part != group and not {part, group} <= {"undo", "redo"}:
            toolbar.addSeparator()
        group = part
        toolbar.addAction(action)
    return toolbar


def _recent_menu(window: MainWindow) -> QMenu:
    menu = QMenu("Open &recent", window)
    menu.setObjectName("recent")
    menu.aboutToShow.connect(lambda: window.files.list_recent(menu))
    return menu


def _add_themes_and_panels(window: MainWindow, menu: QMenu) -> None:
    menu.addSeparator()
    themes = menu.addMenu("&Theme")
    choice = QActionGroup(window)
    for theme, text in ((Theme.SYSTEM, "&System"), (Theme.LIGHT, "&Light"), (Theme.DARK, "&Dark")):
        action = themes.addAction(text)
        action.setObjectName(f"theme_{theme}")
        action.setCheckable(True)
        action.setChecked(theme is chosen_theme())
        action.triggered.connect(lambda _checked=False, theme=theme: choose_theme(theme))
        choice.addAction(action)
    panels = menu.addMenu("&Panels")
    for dock in window.findChildren(QDockWidget):
        panels.addAction(dock.toggleViewAction())
