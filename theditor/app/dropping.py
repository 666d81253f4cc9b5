"""Files dragged onto the window: drawings are opened, what other programs wrote is imported."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QMimeData, QObject, Qt, QTimer
from PySide6.QtGui import QDropEvent

from theditor.app.windows import open_each
from theditor.drawing import shown
from theditor.model.words import listed

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


class Dropping(QObject):
    """Takes files that are dropped anywhere on a window, if it can read one of them."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        window.setAcceptDrops(True)
        # Else the canvas would take what is dropped on it, and do nothing.
        window.canvas.viewport().setAcceptDrops(False)
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Say what can be dropped, and take it."""
        if not isinstance(event, QDropEvent):
            return False
        paths = _files(event.mimeData())
        if any(_can_be_read(path) for path in paths):
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
            if event.type() == QEvent.Type.Drop:
                # Later: a question would keep the program waiting that the files come from.
                QTimer.singleShot(0, self, partial(self._take, paths))
        else:
            event.ignore()
        return True

    def _take(self, paths: Sequence[Path]) -> None:
        from theditor.app.importing import import_files, is_foreign
        from theditor.exchange import readable

        window = self._window
        drawings = [path for path in paths if _is_drawing(path)]
        foreign = [path for path in paths if is_foreign(path)]
        others = [path for path in paths if not _can_be_read(path)]
        if drawings and window.files.may_discard():
            open_each(window, drawings)
        if foreign:
            import_files(window, foreign)
        if others:
            names = listed([f"“{shown(path.name)}”" for path in others])
            kinds = listed([".json", *readable()])
            window.messages.tell(f"{names} cannot be opened here: drop files that end in {kinds}.")


def _files(data: QMimeData) -> list[Path]:
    return [Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile()]


def _is_drawing(path: Path) -> bool:
    return path.suffix.lower() == ".json"


def _can_be_read(path: Path) -> bool:
    from theditor.app.importing import is_foreign  # loaded when it is first asked for

    return _is_drawing(path) or is_foreign(path)
