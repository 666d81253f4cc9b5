"""Cut, copy and paste of curves: as a drawing, as its text, and as a picture."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QAbstractSpinBox, QLineEdit

from theditor.app.adding import add_curves
from theditor.app.view import all_in_view, drawn_box, show_added
from theditor.canvas import Pointed
from theditor.canvas.projection import moved
from theditor.drawing import Drawing, Item, encode
from theditor.model import words

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow
    from theditor.exchange import Imported
    from theditor.panels.points import PointsView

MOST_PAINTED = 2000
"""Curves of more segments than this are not painted as pixels too, and drawn as lines in long work."""


class Clipboard:
    """Carries curves of one window to and from the clipboard; a field with the focus keeps its own text commands."""

    def __init__(self, window: MainWindow) -> None:
        self._window = window
        self._pointer: tuple[float, float] | None = None
        window.canvas.pointed.connect(self._point)

    def copy(self) -> None:
        """Copy the selected curves, whole whatever is selected on them."""
        field = self._field()
        if field is not None:
            field.copy()
        else:
            self._copy(self._window.selection.curves)

    def _copy(self, curves: Sequence[int]) -> str:
        """Copy some curves; returns what to call them. The pictures of large ones follow when they are made."""
        # Loaded when first asked for, as when pasting: pictures and the reading of them take their time.
        from theditor.app.clipboard_data import OWN_TYPE, carried, pictures

        window, clipboard = self._window, QGuiApplication.clipboard()
        window.document.settle()
        items, scale = [window.document.drawing[i] for i in curves], window.canvas.plane.scale
        if not items:
            return ""
        named, them = (f"“{items[0].name}”", "it") if len(items) == 1 else (f"{len(items)} curves", "them")
        text = encode(Drawing(items))
        if sum(item.curve.segment_count for item in items) <= MOST_PAINTED:
            clipboard.setMimeData(carried(text, pictures(items, scale, painted=True)))
        else:

            def add(made: Mapping[str, bytes]) -> None:
                if clipboard.mimeData().data(OWN_TYPE).data() == text:  # nothing else was copied since
                    clipboard.setMimeData(carried(text, made))

            clipboard.setMimeData(carried(text, {}))
            window.work.start(
                f"Copying {named} as a picture", lambda report: pictures(items, scale, report), add
            )
        window.announce(f"Copied {named}: paste {them} here, as text, or into a drawing program.")
        return named

    def cut(self) -> None:
        """Copy the selected curves, but for locked ones, and delete them."""
        window, field = self._window, self._field()
        if field is not None:
            field.cut()
            return
        drawing, chosen = window.document.drawing, window.selection.curves
        gone = dict.fromkeys(i for i in chosen if not drawing[i].locked)
        if not gone:
            if window.selection.item is not None:
                window.announce(words.locked_reason(window.selection.item.name))
            return
        named = self._copy([*gone])
        left = Drawing(item for i, item in enumerate(window.document.drawing) if i not in gone)
        window.document.apply("Cut curve" if len(gone) == 1 else f"Cut {len(gone)} curves", left)
        kept = len(chosen) - len(gone)
        window.announce(f"Cut {named}." + (f" {words.counted(kept, 'locked curve')} stayed." if kept else ""))

    def paste(self) -> None:
        """Paste curves with their middle at the pointer, or in the middle of the view if it is elsewhere."""
        plane = self._window.canvas.plane
        self._paste(self._pointer or (plane.x, plane.y))

    def paste_in_place(self) -> None:
        """Paste curves where they were copied from."""
        self._paste(None)

    def _paste(self, middle: tuple[float, float] | None) -> None:
        window, field = self._window, self._field()
        if field is not None:
            field.paste()
            return
        from theditor.app.clipboard_data import free, pasted, picture_reader
        from theditor.exchange import told

        data = QGuiApplication.clipboard().mimeData() or QMimeData()  # None when empty
        reader = picture_reader(data)
        if reader is not None:

            def take(found: Imported | str) -> None:
                if isinstance(found, str):
                    window.announce(found)
                else:
                    self._add(free(found.drawing), middle, told(found.deviation, found.notes))

            window.work.start("Pasting a picture", reader, take, bound=True)
            return
        try:
            items = pasted(data)
        except ValueError as error:
            window.announce(str(error))
            return
        self._add(items, middle)

    def _add(self, items: list[Item], middle: tuple[float, float] | None, remark: str = "") -> None:
        """Add curves where they are to be, show them if they are out of view, and tell."""
        window = self._window
        if middle is not None:
            try:
                items = _moved_to(items, middle)
            except ValueError as error:
                window.announce(str(error))
                return
        add_curves(window, "Paste", items)
        if not all_in_view(window.canvas, window.selection):
            show_added(window.canvas, window.selection)
        named = f"“{items[0].name}”" if len(items) == 1 else words.counted(len(items), "curve")
        window.announce(f"Pasted {named}. {remark}".rstrip())

    def _field(self) -> QLineEdit | PointsView | None:
        """Return what has the focus, if it deals in text."""
        from theditor.panels.points import PointsView  # loaded when it is first asked for

        widget = self._window.focusWidget()
        if isinstance(widget, QAbstractSpinBox):
            widget = widget.lineEdit()
        return widget if isinstance(widget, QLineEdit | PointsView) else None

    def _point(self, pointed: Pointed) -> None:
        self._pointer = pointed.position


def _moved_to(items: Sequence[Item], middle: tuple[float, float]) -> list[Item]:
    """Return curves moved together, so that the middle of them as drawn lies at a place."""
    low, high = drawn_box(items)
    offset = np.array(middle) - (low + high) / 2
    try:
        return [
            item.with_(curve=item.curve.with_(control_points=moved(item.curve.control_points, offset)))
            for item in items
        ]
    except ValueError as error:
        raise ValueError(f"The curves do not fit there: {error}.") from None
