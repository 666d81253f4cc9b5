"""What the clipboard carries: curves as a drawing's text and as pictures, and what else can be read as curves."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

import numpy as np
from PySide6.QtCore import QMimeData
from PySide6.QtGui import QImage, QStandardItemModel

from theditor.app.kept_options import kept_options
from theditor.canvas.projection import projected
from theditor.drawing import Drawing, DrawingError, Item, decode
from theditor.exchange import Imported, Options, Progress, read, write
from theditor.exchange.scene import MM_PER_PIXEL

OWN_TYPE = "application/vnd.theditor+json"
SVG_TYPE = "image/svg+xml"
PNG_TYPE = "image/png"
LARGEST = 4000.0
"""Size in pixels of the largest picture."""
_PICTURES = (SVG_TYPE, "image/x-inkscape-svg")
_WHAT = (
    "copy a curve, a drawing's text (JSON), an SVG picture or its path data, "
    "or a table of numbers with columns x, y and perhaps z"
)


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


def pictures(
    items: Sequence[Item], scale: float, progress: Progress | None = None, *, painted: bool = False
) -> dict[str, bytes]:
    """Return pictures of curves by their type: lines and, if asked for, pixels.

    Parameters
    ----------
    scale
        Pixels of the picture per unit.
    progress
        Told the share of each picture that is done.
    """
    shown = Drawing(item.with_(visible=True) for item in items)
    extent = float(
        np.ptp(np.concatenate([projected(item.curve).control_points for item in items]), axis=0).max()
    )
    options = Options(scale=min(scale, LARGEST / extent if extent else scale) * MM_PER_PIXEL)
    made = {SVG_TYPE: write(shown, ".svg", options, progress).data}
    if painted:
        made[PNG_TYPE] = write(shown, ".png", options, progress).data
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


def free(items: Iterable[Item]) -> list[Item]:
    """Return curves visible and unlocked."""
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
    return free(items)


def _from_table(text: str) -> list[Item]:
    if not text:
        raise ValueError(f"The clipboard holds nothing that can be pasted: {_WHAT}.")
    try:
        return list(read(text.encode(errors="replace"), ".csv", Options(control_points=True)).drawing)
    except DrawingError as error:
        raise ValueError(f"What was copied cannot be pasted: {error} C{_WHAT[1:]}.") from None
