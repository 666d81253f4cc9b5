"""A small picture of a drawing."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QSize
from PySide6.QtGui import QColor, QPainter, QPixmap

from theditor.canvas.curves import CurvesPainter
from theditor.canvas.fit import extent
from theditor.canvas.viewport import Viewport
from theditor.drawing import Drawing
from theditor.model import Colours

MARGIN = 10


def thumbnail(drawing: Drawing, size: QSize, ratio: float, colours: Colours) -> QPixmap:
    """The drawing's visible curves fitted into `size`, the first coloured by mode, at `ratio` device pixels each."""
    pixmap = QPixmap(size * ratio)
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(QColor(colours.canvas))
    low, high = extent(drawing, polygons=False)
    room = np.array([size.width(), size.height()]) - 2 * MARGIN
    scale = float(np.min(room / np.maximum(high - low, 1e-9)))
    x, y = ((low + high) / 2).tolist()
    curves = CurvesPainter()
    curves.update(drawing)
    plane = Viewport(x, y, scale, size.width(), size.height())
    painter = QPainter(pixmap)
    curves.paint(painter, drawing, 0, plane, colours, by_mode=True)
    painter.end()
    return pixmap
