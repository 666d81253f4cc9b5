"""Menus and toolbar, made from the table of commands."""

from __future__ import annotations

from collections.abc import Container, Iterable
from typing import TYPE_CHECKING

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QApplication, QDockWidget, QMenu

from theditor.app.command import make_action
from theditor.app.icons import icon
from theditor.app.letters import lettered
from theditor.app.toolbar import Toolbar

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

_SUBMENUS = {"File": "r", "View": "tp", "Point": "ad", "Curve": "p"}
"""Mnemonics of the menus within menus: recent files; theme and panels; align and distribute; pieces."""


def build_menus(window: MainWindow) -> dict[str, QAction]:
    """Fill the menu bar and the toolbar; return the actions by the names of their commands."""
    entries = [(command.text, frozenset({command.menu, *command.places})) for command in window.commands]
    actions = {
        command.name: make_action(window, command, text)
        for command, text in zip(window.commands, lettered(entries, _SUBMENUS), strict=True)
    }
    menus: dict[str, QMenu] = {}
    for command in window.commands:
        menu = _menu(window, menus, command.menu)
        if command.gap:
            menu.addSeparator()
        menu.addAction(actions[command.name])
    menus["File"].insertMenu(actions["gallery"], _recent_menu(window))
    panels = menus["View"].addMenu("&Panels")
    docks = window.findChildren(QDockWidget)
    titles = lettered((dock.windowTitle(), frozenset({""})) for dock in docks)
    for dock, title in zip(docks, titles, strict=True):
        dock.toggleViewAction().setText(title)
        panels.addAction(dock.toggleViewAction())
    buttons = [(command, actions[command.name]) for command in window.commands if command.brief]
    window.addToolBar(Toolbar(buttons))
    return actions


def tint_icons(window: MainWindow) -> None:
    """Give the buttons their icons, in the colours of the palette, and tint those that menus have shown.

    The others are drawn when a menu first shows them: see `draw_icons`.
    """
    actions = window.actions_by_name
    shown = {c.name for c in window.commands if c.brief or not actions[c.name].icon().isNull()}
    _draw(window, shown)


def draw_icons(window: MainWindow, actions: Iterable[QAction]) -> None:
    """Give the actions of a menu that is about to be shown the icons that they lack."""
    _draw(window, {action.objectName() for action in actions if action.icon().isNull()})


def _draw(window: MainWindow, names: Container[str]) -> None:
    """Draw the icons of commands in the colours of the palette, sharp on every screen there is."""
    palette = QApplication.palette()
    ratios = sorted({screen.devicePixelRatio() for screen in QApplication.screens()})
    for command in window.commands:
        if command.icon and command.name in names:
            window.actions_by_name[command.name].setIcon(icon(command.icon, palette, ratios))


def _menu(window: MainWindow, menus: dict[str, QMenu], path: str) -> QMenu:
    """The menu at a path such as ``"View/Theme"``, made when it is first asked for."""
    if path not in menus:
        above, _, title = path.rpartition("/")
        parent = _menu(window, menus, above) if above else window.menuBar()
        menu = menus[path] = parent.addMenu("&" + title)
        menu.aboutToShow.connect(lambda: draw_icons(window, menu.actions()))
    return menus[path]


def _recent_menu(window: MainWindow) -> QMenu:
    menu = QMenu("Open &recent", window)
    menu.setObjectName("recent")
    menu.aboutToShow.connect(lambda: window.files.list_recent(menu))
    return menu
