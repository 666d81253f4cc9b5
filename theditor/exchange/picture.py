"""Painting PNG and PDF with Qt's painter, on a machine with or without a display. The one module here with Qt."""

from __future__ import annotations

import re
from functools import cache
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QMarginsF, QSizeF, Qt, QUuid
from PySide6.QtGui import (
    QColor,
    QFont,
    QGuiApplication,
    QImage,
    QImageWriter,
    QPageLayout,
    QPageSize,
    QPainter,
    QPainterPath,
    QPdfWriter,
    QPen,
    QTransform,
)

from theditor.drawing import Drawing, DrawingError
from theditor.exchange.options import DEFAULTS, MOST_PIXELS, PAGE, PIXELS, Options, Progress, Written, watched
from theditor.exchange.scene import (
    BLACK,
    COLLECTED,
    COMB,
    INCH,
    LABEL,
    POINT,
    POLYGON,
    THIN,
    Figure,
    Scene,
    Stroke,
    scene,
)
from theditor.spline import Outline, Piece

Floats = NDArray[np.float64]

_PDF_SMALLEST: Final = 1.0
_PDF_LARGEST: Final = 5000.0  # the format ends at 200 inches
_PDF_DPI: Final = 1200
_ID: Final = "{d2c1a2c4-6e0c-4d7e-9a55-5d1f5c0b7a11}"
_TIMES: Final = re.compile(rb'/(?:CreationDate|ModDate) \(D:[^)]*\)|xmp:\w+Date="[^"]*"')
_FAMILIES: Final = ("Times New Roman", "Times", "Liberation Serif", "DejaVu Serif", "serif")


def write_png(drawing: Drawing, options: Options = DEFAULTS, progress: Progress | None = None) -> Written:
    """Paint the visible curves as a PNG, `options.size` pixels long.

    Raises
    ------
    DrawingError
        If it would have too many pixels.
    """
    _application()
    scale = options.dpi / INCH
    shown = scene(drawing, options, size=(options.size or PIXELS) / scale, arcs=False, progress=progress)
    longest = max(shown.size) * scale
    if longest > MOST_PIXELS + 0.5:
        raise DrawingError(
            f"A PNG may be at most {MOST_PIXELS} pixels long, not {longest:.7g}: ask for a smaller size."
        )
    width, height = (max(1, round(side * scale)) for side in shown.size)
    image = QImage(width, height, QImage.Format.Format_ARGB32_Premultiplied)
    if image.isNull():
        raise DrawingError(
            f"There is not enough memory for {width} × {height} pixels: ask for a smaller size."
        )
    image.fill(Qt.GlobalColor.transparent if options.transparent else Qt.GlobalColor.white)
    image.setDotsPerMeterX(round(options.dpi / INCH * 1000))
    image.setDotsPerMeterY(round(options.dpi / INCH * 1000))
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    try:
        _paint(painter, shown, scale, options.print_style, progress)
    finally:
        painter.end()
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    QImageWriter(buffer, QByteArray(b"png")).write(image)
    notes = (f"1 unit is {shown.unit * scale:.6g} pixels.", *shown.notes[1:])
    return Written(bytes(buffer.data().data()), shown.deviation, notes)


def write_pdf(drawing: Drawing, options: Options = DEFAULTS, progress: Progress | None = None) -> Written:
    """Paint the visible curves as a PDF of one page, `options.size` millimetres long, in cubic Béziers.

    Raises
    ------
    DrawingError
        If the page would be larger or smaller than the format allows.
    """
    _application()
    shown = scene(drawing, options, size=options.size or PAGE, arcs=False, progress=progress)
    if not _PDF_SMALLEST <= max(shown.size) <= _PDF_LARGEST:
        raise DrawingError(
            f"A PDF page must be {_PDF_SMALLEST:g} to {_PDF_LARGEST:g} mm long, not {max(shown.size):.6g} mm: "
            "ask for another size."
        )
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    writer = QPdfWriter(buffer)
    writer.setResolution(_PDF_DPI)
    page = QPageSize(QSizeF(*shown.size), QPageSize.Unit.Millimeter, "", QPageSize.SizeMatchPolicy.ExactMatch)
    writer.setPageLayout(QPageLayout(page, QPageLayout.Orientation.Portrait, QMarginsF()))
    writer.setCreator("theditor")
    writer.setDocumentId(QUuid(_ID))
    painter = QPainter(writer)
    try:
        _paint(painter, shown, _PDF_DPI / INCH, options.print_style, progress)
    finally:
        painter.end()
    # Without the time the same drawing gives the same bytes; blanks keep every offset in the file.
    data = _TIMES.sub(lambda found: b" " * len(found[0]), bytes(buffer.data().data()))
    return Written(data, shown.deviation, shown.notes)


@cache
def _application() -> QGuiApplication:
    """Return the application, which letters need; one without a display if there is none."""
    return QGuiApplication.instance() or QGuiApplication(["theditor", "-platform", "offscreen"])  # type: ignore[return-value]


def _paint(
    painter: QPainter, shown: Scene, scale: float, print_style: bool, progress: Progress | None
) -> None:
    """Paint a scene at `scale` units of the painter for each millimetre."""
    zoom = shown.unit * scale
    factor = np.array((zoom, -zoom))
    shift = np.array((-shown.low[0], shown.high[1])) * zoom
    line = shown.line * scale
    grey = QColor(BLACK if print_style else POLYGON)
    faint = QColor(COMB)
    faint.setAlphaF(0.6)
    for figure in shown.figures:
        comb = QPainterPath()
        for chain in (*figure.teeth, *figure.crests):
            comb.addPath(_chain(chain * factor + shift))
        painter.strokePath(comb, QPen(faint, THIN / 2 * line))
        painter.strokePath(_chain(figure.polygon * factor + shift), QPen(grey, THIN * line))
    for figure in watched(shown.figures, progress, COLLECTED, 1.0):
        for stroke in figure.strokes:
            path = _path(stroke.outline.scaled(factor, shift))
            painter.strokePath(path, _pen(figure, stroke, line))
    painter.setPen(QPen(grey, THIN * line))
    painter.setBrush(QColor("white"))
    for figure in shown.figures:
        for x, y in (figure.points * factor + shift).tolist():
            circle = QPainterPath()
            circle.addEllipse(x - POINT * line, y - POINT * line, 2 * POINT * line, 2 * POINT * line)
            painter.drawPath(circle)
    for figure in shown.figures:
        for index, place in figure.labels.items():
            painter.fillPath(_label(index, np.array(place) * factor + shift, LABEL * line), QColor(BLACK))


def _pen(figure: Figure, stroke: Stroke, line: float) -> QPen:
    pen = QPen(QColor(figure.color), figure.width * line)
    pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    if stroke.dashes:
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        pen.setDashPattern([dash / figure.width for dash in stroke.dashes])
    return pen


def _path(pieces: Outline) -> QPainterPath:
    ends = pieces.ends.tolist()
    path = QPainterPath()
    path.moveTo(*ends[0])
    for kind, end, (first, second) in zip(
        pieces.kinds.tolist(), ends[1:], pieces.inner.tolist(), strict=True
    ):
        if kind == Piece.LINE:
            path.lineTo(*end)
        else:
            path.cubicTo(*first, *second, *end)
    if pieces.closed:
        path.closeSubpath()
    return path


def _chain(points: Floats) -> QPainterPath:
    path = QPainterPath()
    for index, (x, y) in enumerate(points.tolist()):
        (path.lineTo if index else path.moveTo)(x, y)
    return path


def _label(index: int, middle: Floats, height: float) -> QPainterPath:
    """Return the outlines of P with its index, which need no font where the picture is shown."""
    letter = QFont(list(_FAMILIES))
    letter.setPixelSize(100)
    subscript = QFont(letter)
    letter.setItalic(True)
    subscript.setPixelSize(70)
    path = QPainterPath()
    path.addText(0, 0, letter, "P")
    path.addText(path.boundingRect().right() + 2, 20, subscript, str(index))
    box = path.boundingRect()
    scale = height / 100
    place = QTransform.fromTranslate(float(middle[0]), float(middle[1])).scale(scale, scale)
    return place.translate(-box.center().x(), 33).map(path)
