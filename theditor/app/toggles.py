"""What is switched on and off in the menus: kept from one run to the next."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from PySide6.QtCore import QSettings
from PySide6.QtGui import QAction

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


def keep_toggles(window: MainWindow) -> None:
    """Remember what is switched otherwise than at first."""
    toggles = _toggles(window).items()
    kept = {name: action.isChecked() for name, (action, first) in toggles if action.isChecked() is not first}
    QSettings().setValue("toggles", json.dumps(kept))


def restore_toggles(window: MainWindow) -> None:
    """Switch on and off what was so the last time."""
    try:
        kept = json.loads(str(QSettings().value("toggles", "{}")))
    except ValueError:
        return
    for name, (action, _) in _toggles(window).items():
        if isinstance(kept, dict) and isinstance(kept.get(name), bool):
            action.setChecked(kept[name])


def _toggles(window: MainWindow) -> dict[str, tuple[QAction, bool]]:
    """The actions that are on or off each for itself, and what they are at first."""
    actions = window.actions_by_name
    return {
        command.name: (actions[command.name], command.checked)
        for command in window.commands
        if command.checked is not None and not command.choice
    }
