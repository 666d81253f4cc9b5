"""Cut, copy and paste of curves: as a drawing, as its text, and as a picture."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication, QImage, QStandardItemModel
from PySide6.QtWidgets import QAbstractSpinBox, QLineEdit

from theditor.app.adding import add_curves
from theditor.app.kept_options import kept_options
from theditor.app.view import all_in_view, drawn_box, show_added
from theditor.canvas import Pointed
from theditor.canvas.projection import moved, projected
from theditor.drawing import Drawing, DrawingError, Item, decode, encode
from theditor.exchange import Imported, Options, Progress, read, told, write
from theditor.exchange.scene import MM_PER_PIXEL
from theditor.model import words

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow
    from theditor.panels.points import PointsView

OWN_TYPE = "application/vnd.theditor+json"
SVG_TYPE = "image/svg+xml"
PNG_TYPE = "image/png"
LARGEST = 4000.0
"""Size in pixels of the largest picture."""
MOST_PAINTED = 2000
"""Curves of more segments than this are not painted as pixels too, and drawn as lines in long work."""
_PICTURES = (SVG_TYPE, "image/x-inkscape-svg")
_WHAT = (
    "copy a curve, a drawing's text (JSON), an SVG picture or its path data, "
    "or a table of numbers with columns x, y and perhaps z"
)


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
            window.work.start(f"Copying {named} as a picture", lambda _: pictures(items, scale), add)
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
        data = QGuiApplication.clipboard().mimeData() or QMimeData()  # None when empty
        reader = picture_reader(data)
        if reader is not None:

            def take(found: Imported | str) -> None:
                if isinstance(found, str):
                    window.announce(found)
                else:
                    self._add(_free(found.drawing), middle, told(found.deviation, found.notes))

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


def carried(text: bytes, made: Mapping[str, bytes]) -> QMimeData:
    """Return curves as the clipboard carries them: the drawing's file, the same as text, and pictures by type."""
    data = _lasting()
    data.setData(OWN_TYPE, text)
    data.setText(text.decode())
    for kind, picture in made.items():
        if kind == PNG_TYPE:
            data.setImageData(QImage.fromData(picture))
        else:
            data.setData(kind, picture)
    return data


def pictures(items: Sequence[Item], scale: float, *, painted: bool = False) -> dict[str, bytes]:
    """Return pictures of curves by their type: lines and, if asked for, pixels.

    Parameters
    ----------
    scale
        Pixels of the picture per unit.
    """
    shown = Drawing(item.with_(visible=True) for item in items)
    extent = float(
        np.ptp(np.concatenate([projected(item.curve).control_points for item in items]), axis=0).max()
    )
    options = Options(scale=min(scale, LARGEST / extent if extent else scale) * MM_PER_PIXEL)
    made = {SVG_TYPE: write(shown, ".svg", options).data}
    if painted:
        made[PNG_TYPE] = write(shown, ".png", options).data
    return made


def _lasting() -> QMimeData:
    """Return empty data that Qt made itself.

    What Python makes calls Python when it is deleted; the clipboard keeps its data until Python has ended.
    """
    model = QStandardItemModel(1, 1)
    data: QMimeData = model.mimeData([model.index(0, 0)])
    for name in data.formats():
        data.removeFormat(name)
    return data


def picture_reader(data: QMimeData) -> Callable[[Progress], Imported | str] | None:
    """Return what reads the SVG picture, or the path data, that the clipboard carries; None if it carries none.

    What cannot be read makes it return a sentence that says why: all that goes wrong with a paste is told alike.
    Curves of this program and text of drawings come first: they lose nothing.
    """
    # Loaded when first asked for: the libraries behind them take their time.
    from theditor.exchange.path_data import is_path_data
    from theditor.exchange.svg_in import read_path_data

    text = data.text().strip()
    if data.hasFormat(OWN_TYPE) or text.startswith("{"):
        return None
    kind = next((name for name in _PICTURES if data.hasFormat(name)), None)
    options, picture = (
        kept_options("import"),
        bytes(data.data(kind).data()) if kind else text.encode(errors="replace"),
    )
    if kind or (text.startswith("<") and "<svg" in text):
        return _told_of(lambda progress: read(picture, ".svg", options, progress))
    if is_path_data(text):
        return _told_of(lambda progress: read_path_data(text, options, progress))
    return None


def _told_of(reader: Callable[[Progress], Imported]) -> Callable[[Progress], Imported | str]:
    """Return a reader that returns its error, in words that say what it is about."""

    def reading(progress: Progress) -> Imported | str:
        try:
            return reader(progress)
        except DrawingError as error:
            return f"What was copied cannot be pasted: {error}"

    return reading


def _free(items: Iterable[Item]) -> list[Item]:
    return [item.with_(visible=True, locked=False) for item in items]


def pasted(data: QMimeData) -> list[Item]:
    """Return the curves that the clipboard carries other than as a picture, visible and unlocked.

    A table of numbers makes one.

    Raises
    ------
    ValueError
        There is none; the message is a sentence that says why and what can be pasted.
    """
    text = bytes(data.data(OWN_TYPE).data()) or data.text().strip().encode(errors="replace")
    if not text.startswith(b"{"):
        return _from_table(text.decode())
    try:
        items = list(decode(text))
    except DrawingError as error:
        raise ValueError(f"What was copied is no drawing: {error}") from None
    if not items:
        raise ValueError(f"The drawing that was copied has no curves: {_WHAT}.")
    return _free(items)


def _from_table(text: str) -> list[Item]:
    if not text:
        raise ValueError(f"The clipboard holds nothing that can be pasted: {_WHAT}.")
    try:
        return list(read(text.encode(errors="replace"), ".csv", Options(control_points=True)).drawing)
    except DrawingError as error:
        raise ValueError(f"What was copied cannot be pasted: {error} C{_WHAT[1:]}.") from None


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
