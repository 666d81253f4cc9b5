"""Drawing the curves: the current one coloured by the modes of its segments, the others in their own colours."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPainter, QPen

from theditor.canvas.lines import draw_lines
from theditor.canvas.projection import projected
from theditor.canvas.trace import Trace, strokes
from theditor.canvas.viewport import Viewport
from theditor.drawing import Drawing, Item
from theditor.model.colours import Colours
from theditor.spline import Curve, Mode

MODES = (Mode.TRIGONOMETRIC, Mode.HYPERBOLIC, Mode.INTERPOLATING, Mode.BLEND)
"""Modes by their code in `Curve.mode_codes`."""


class CurvesPainter:
    """Draws the visible curves of a drawing and remembers their traces from one frame to the next."""

    def __init__(self) -> None:
        self._traces: dict[int, tuple[Curve, Curve, Trace]] = {}
        self._ghosts: dict[int, tuple[Curve, Trace]] = {}

    def update(self, drawing: Drawing, viewport: Viewport) -> None:
        """Bring the traces of all visible curves up to date."""
        for index in [i for i in self._traces if i >= len(drawing) or not drawing[i].visible]:
            del self._traces[index]
        for index, item in enumerate(drawing):
            if item.visible:
                curve, plane, trace = self._traces.get(index) or (None, None, Trace())
                if plane is None or curve is not item.curve:
                    plane = projected(item.curve)
                self._traces[index] = item.curve, plane, trace
                trace.update(plane, viewport)

    def plane_curve(self, index: int) -> Curve:
        """Curve `index` as it is seen; it must be visible."""
        return self._traces[index][1]

    def trace(self, index: int) -> Trace:
        """The trace of curve `index`; it must be visible."""
        return self._traces[index][2]

    def paint(
        self, painter: QPainter, drawing: Drawing, current: int, colours: Colours, *, by_mode: bool
    ) -> None:
        """Paint all curves, the current one last, so that it lies on top."""
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for index in sorted(self._traces, key=lambda i: i == current):
            item = drawing[index]
            for stroke in self._traces[index][2].strokes():
                own = index != current or not by_mode
                colour = _legible(item, colours) if own else colours.of_mode(MODES[stroke.code])
                painter.setPen(curve_pen(colour, item.width))
                draw_lines(painter, stroke.lines)

    def paint_ghost(
        self, painter: QPainter, before: Drawing, now: Drawing, viewport: Viewport, colours: Colours
    ) -> None:
        """Paint, faint, the curves as they were where they have changed since."""
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        faint = QColor(colours.secondary)
        faint.setAlpha(110)
        for index, (old, new) in enumerate(zip(before, now, strict=False)):
            if old.visible and old.curve is not new.curve:
                curve, trace = self._ghosts.get(index) or (None, Trace())
                if curve is not old.curve:
                    self._ghosts[index] = old.curve, trace
                trace.update(projected(old.curve), viewport)
                for stroke in trace.strokes():
                    painter.setPen(QPen(faint, 1.0))
                    draw_lines(painter, stroke.lines)

    def paint_halo(
        self,
        painter: QPainter,
        index: int,
        segments: Iterable[int],
        viewport: Viewport,
        colours: Colours,
        width: float = 11.0,
    ) -> None:
        """Paint the soft band behind selected (or, narrower, hovered) segments of curve `index`."""
        chosen = np.array(sorted(segments), dtype=np.intp)
        if index in self._traces and len(chosen):
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            pen = curve_pen(colours.selection, width)
            pen.setCapStyle(Qt.PenCapStyle.RoundCap)
            painter.setPen(pen)
            for stroke in strokes(self.plane_curve(index), viewport, chosen):
                draw_lines(painter, stroke.lines)


def curve_pen(colour: str, width: float) -> QPen:
    """The pen for curves. Square caps close the gaps between the straight pieces."""
    pen = QPen(QColor(colour), width)
    pen.setCapStyle(Qt.PenCapStyle.SquareCap)
    return pen


def _legible(item: Item, colours: Colours) -> str:
    """The item's colour, lightened or darkened where it would vanish in the canvas."""
    colour, ground = QColor(item.color), QColor(colours.canvas)
    if abs(_luma(colour) - _luma(ground)) >= 70:
        return item.color
    hue, saturation, lightness = colour.hslHue(), colour.hslSaturation(), colour.lightness()
    target = 255 - lightness if abs(255 - 2 * lightness) > 60 else (220 if _luma(ground) < 128 else 60)
    return QColor.fromHsl(max(hue, 0), saturation, target).name()


def _luma(colour: QColor) -> float:
    return 0.299 * colour.red() + 0.587 * colour.green() + 0.114 * colour.blue()
