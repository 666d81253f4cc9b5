"""The icons of commands: one-colour drawings on a grid of 16, in the colours of the palette."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPalette, QPixmap
from PySide6.QtSvg import QSvgRenderer

from theditor.resources import resource

SIZE = 16
"""Width and height of an icon in logical pixels."""


def icon(name: str, palette: QPalette, ratios: Iterable[float]) -> QIcon:
    """Return an icon in the palette's text colour, its accent where checked, faded where disabled.

    It keeps these colours: ask for another one when the palette changes.

    Parameters
    ----------
    ratios
        Device pixels per logical pixel of the screens it is for; drawn anew for each, so that nothing is scaled.

    Raises
    ------
    FileNotFoundError
        If there is no such drawing.
    """
    group, role, mode, state = QPalette.ColorGroup, QPalette.ColorRole, QIcon.Mode, QIcon.State
    renderer = QSvgRenderer(f"{_folder()}/{name}.svg")
    if not renderer.isValid():
        raise FileNotFoundError(f"there is no icon {name!r}")
    result = QIcon()
    for ratio in ratios:
        drawn = _drawn(renderer, ratio)
        result.addPixmap(_tinted(drawn, palette.color(group.Active, role.ButtonText)), mode.Normal, state.Off)
        result.addPixmap(
            _tinted(drawn, palette.color(group.Active, role.HighlightedText)), mode.Normal, state.On
        )
        faded = _tinted(drawn, palette.color(group.Disabled, role.ButtonText))
        result.addPixmap(faded, mode.Disabled, state.Off)
        result.addPixmap(faded, mode.Disabled, state.On)
    return result


@cache
def _folder() -> str:
    return str(resource("icons"))


def _drawn(renderer: QSvgRenderer, ratio: float) -> QPixmap:
    pixmap = QPixmap(QSize(SIZE, SIZE) * ratio)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    renderer.render(painter)
    painter.end()
    pixmap.setDevicePixelRatio(ratio)
    return pixmap


def _tinted(drawn: QPixmap, colour: QColor) -> QPixmap:
    pixmap = QPixmap(drawn)
    painter = QPainter(pixmap)
    painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_SourceIn)
    painter.fillRect(pixmap.rect(), colour)
    painter.end()
    return pixmap
