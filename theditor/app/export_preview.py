"""What an export will look like: the picture on white paper, or the first rows of the table."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import QLabel, QWidget

from theditor.drawing import Drawing, DrawingError
from theditor.exchange import Options, write
from theditor.exchange.options import PAGE, PIXELS
from theditor.exchange.scene import INCH, ORDINARY, box, visible
from theditor.spline import projected

SIDE: Final = 240
"""Width and height of the picture in pixels."""
MOST: Final = 2000
"""Drawings of more segments are not shown, which would take long."""
_ROWS: Final = 10
_EDGE: Final = 8


class ExportPreview(QLabel):
    """A small picture of the outcome, painted when the hand has stopped changing fields."""

    def __init__(self, drawing: Drawing, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._take(drawing)
        self._asked: tuple[str, Options] | None = None
        self._timer = QTimer(self, singleShot=True, interval=0)
        self._timer.timeout.connect(self._draw)
        self.setFixedSize(SIDE + 2 * _EDGE, SIDE + 2 * _EDGE)
        self.setMargin(_EDGE - 1)
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setProperty("role", "paper")
        self.setAccessibleName("Preview")

    def show_outcome(self, drawing: Drawing, suffix: str, options: Options) -> None:
        """Show what these options make of a drawing."""
        if drawing is not self._drawing:
            self._take(drawing)
        self._asked = suffix, options
        self._timer.start()

    def _take(self, drawing: Drawing) -> None:
        self._drawing = drawing
        self._few = sum(item.curve.segment_count for item in visible(drawing)) <= MOST
        *_, self._extent = box([projected(item.curve) for item in visible(drawing)]) if self._few else (1.0,)

    def _draw(self) -> None:
        assert self._asked is not None
        suffix, options = self._asked
        if not self._few:
            self.setText("Drawings of so many segments are not shown here.")
            return
        try:
            if suffix == ".csv":
                self._show_table(write(self._drawing, suffix, options).data)
            else:
                self._show_picture(write(self._drawing, ".png", self._small(suffix, options)).data)
        except DrawingError as error:
            self.setText(str(error))

    def _small(self, suffix: str, options: Options) -> Options:
        """Return options for a picture of the size of this widget, whose lines are as wide in proportion."""
        if suffix == ".dxf":
            options = Options()
        if options.scale:
            length = options.scale * self._extent
        elif suffix == ".png":
            length = (options.size or PIXELS) / options.dpi * INCH
        elif suffix in (".pdf", ".tex"):
            length = options.size or PAGE
        else:
            length = options.size or float(np.clip(self._extent, *ORDINARY))
        pixels = SIDE * self.devicePixelRatioF()
        dpi = min(max(pixels / length * INCH, 1.0), 10_000.0)
        return replace(options, size=pixels, scale=None, dpi=dpi, transparent=False)

    def _show_picture(self, data: bytes) -> None:
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        picture = QPixmap.fromImage(QImage.fromData(data))
        picture.setDevicePixelRatio(self.devicePixelRatioF())
        self.setPixmap(picture)

    def _show_table(self, data: bytes) -> None:
        self.setAlignment(Qt.AlignmentFlag.AlignTop)
        lines = data[:4000].decode(errors="replace").split("\n")[: _ROWS + 1]
        metrics = self.fontMetrics()
        fitting = (metrics.elidedText(line, Qt.TextElideMode.ElideRight, SIDE) for line in lines)
        self.setText("\n".join(fitting))
