"""What a command is: something the user can do, declared once and offered in many places."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Literal, NamedTuple

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

Keys = tuple[str | QKeySequence.StandardKey, ...]
Place = Literal["point", "segment", "ground", "curve"]
"""What a context menu is about: a control point, a segment, the empty ground, a row in the list of curves."""


def always(window: MainWindow) -> bool:
    """Can be done whatever the drawing holds."""
    return True


def has_curve(window: MainWindow) -> bool:
    """Needs a current curve."""
    return window.selection.item is not None


def can_edit(window: MainWindow) -> bool:
    """Needs a current curve that is not locked."""
    item = window.selection.item
    return item is not None and not item.locked


def can_edit_any(window: MainWindow) -> bool:
    """Needs a selected curve that is not locked."""
    selection = window.selection
    return any(not selection.drawing[i].locked for i in selection.curves)


class Command(NamedTuple):
    """Something the user can do.

    Attributes
    ----------
    menu
        Title of the menu it is in; ``"View/Theme"`` is a submenu.
    text, tip
        A verb phrase for the menu, with the mnemonic that suits it best (see `letters`), and a sentence for the
        status line and the tooltip.
    run
        What it does; a checkable command is also given its new state.
    keys
        Standard keys or key names; the first that exists on the platform is shown.
    enabled
        Whether it can be done now. Asked after every change, so it must be quick.
    on_canvas, on_list
        The keys act only while the canvas, or the list of curves, has the focus.
    checked
        Initial state of a checkable command, None for others.
    choice
        Checkable commands of one choice exclude each other.
    brief
        Text on the toolbar; empty for commands that are not there.
    icon
        Name of its drawing (see `icons.icon`); commands with a brief text have one.
    places
        The context menus it is in.
    gap
        Whether a separator goes before it.
    """

    name: str
    menu: str
    text: str
    tip: str
    run: Callable[..., object]
    keys: Keys = ()
    enabled: Callable[[MainWindow], bool] = always
    on_canvas: bool = False
    on_list: bool = False
    checked: bool | None = None
    choice: str = ""
    brief: str = ""
    icon: str = ""
    places: tuple[Place, ...] = ()
    gap: bool = False


def plain(text: str) -> str:
    """Return a menu text without its mnemonic and without dots."""
    return text.replace("&&", "\0").replace("&", "").replace("\0", "&").removesuffix("…")


def make_action(window: MainWindow, command: Command, text: str) -> QAction:
    """Return the action of a command, under a text with its mnemonic and with its keys in force."""
    action = QAction(text, window)
    action.setObjectName(command.name)
    sequences = [s for key in command.keys for s in _sequences(key)]
    action.setShortcuts(list(dict.fromkeys(sequences)))
    shortcut = f" ({sequences[0].toString(QKeySequence.SequenceFormat.NativeText)})" if sequences else ""
    action.setToolTip(command.tip + shortcut)
    action.setStatusTip(command.tip)
    if command.brief:
        action.setIconText(command.brief)
    focused = window.canvas if command.on_canvas else window.curves.list if command.on_list else None
    if focused is not None:
        action.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
        focused.addAction(action)
    if command.checked is None:
        action.triggered.connect(lambda _checked=False: command.run())
    else:
        action.setCheckable(True)
        action.setIconVisibleInMenu(False)  # its place is the check mark's
        action.setChecked(command.checked)
        action.toggled.connect(command.run)
    if command.choice:
        group = window.findChild(QActionGroup, command.choice) or QActionGroup(window)
        group.setObjectName(command.choice)
        group.addAction(action)
    return action


def _sequences(key: str | QKeySequence.StandardKey) -> list[QKeySequence]:
    return [QKeySequence(key)] if isinstance(key, str) else QKeySequence.keyBindings(key)
