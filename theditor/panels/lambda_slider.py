"""A slider for λ that shows it among its landmarks: hull, cusp or inflection, T, H and λ*."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFocusEvent,
    QFontMetricsF,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from theditor.model import Colours, colours_for, unbreakable
from theditor.model.words import exact
from theditor.panels import lambda_scale as scale
from theditor.panels.parts import small_font
from theditor.spline import CONVEX_HULL_RANGE
from theditor.spline.distinct import distinct

_INSET = 8.0
_TRACK_Y = 12.0
_TRACK_HEIGHT = 5.0
_RADIUS = 7.5
_LABEL_TOP = 26.0
_MERGED = 6.0
_IMPORTANCE = ("T", "H", "λ*", "hull", "cusp", "inflection")
_FAINT_HANDLES = 40


@unbreakable
class LambdaSlider(QWidget):
    """Shows one λ, or several that differ, and turns hands into asked-for values; it changes nothing itself.

    A drag starts where the pointer is. T, H and λ* attract it, unless Shift is held; Ctrl drags ten times
    finer. Values beyond the scale stand at its end with an arrow.
    """

    pressed = Signal()
    """A drag begins."""

    moved = Signal(float)
    """The drag asks for this λ."""

    released = Signal()
    """The drag is over and stands."""

    cancelled = Signal()
    """The drag was taken back with Escape."""

    stepped = Signal(int, bool)
    """Arrow key or wheel: so many steps, ten times finer or not."""

    jumped = Signal(float)
    """A key asks for this landmark or end of the scale."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._values: NDArray[np.float64] = np.empty(0)
        self._mean: float | None = None
        self._degree = 3
        self._drag: scale.ScaleDrag | None = None
        self._pointer = 0.0
        self._hovered = False
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName("Shape parameter λ")

    def show_values(self, values: ArrayLike, degree: int, mean: float | None = None) -> None:
        """Show the different ones among `values` on the scale of a degree.

        The handle of values that differ stands at their `mean` if it is given, else in the middle of their range.
        """
        self._values = distinct(np.asarray(values, dtype=np.float64))
        self._degree, self._mean = degree, mean
        self.setAccessibleDescription(self._description())
        self.update()

    def _description(self) -> str:
        if not self._values.size:
            return "none"
        if self._values.size == 1:
            return f"λ = {exact(self._values[0])}"
        mean = "" if self._mean is None else f", mean {exact(self._mean)}"
        return f"{self._values.size} different values{mean}"

    def sizeHint(self) -> QSize:
        """Wide enough for every label."""
        return QSize(300, self.minimumSizeHint().height())

    def minimumSizeHint(self) -> QSize:
        """High enough for track, ticks and labels."""
        return QSize(160, round(_LABEL_TOP + QFontMetricsF(small_font(self.font())).height() + 2))

    # What the hand does

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Start a drag: from the handle where it is, elsewhere by jumping to the pointer."""
        if event.button() != Qt.MouseButton.LeftButton or not self._values.size:
            return
        self._pointer = event.position().x()
        on_handle = abs(self._pointer - self._x(self._place())) <= _RADIUS
        place = self._place() if on_handle else (self._pointer - _INSET) / self._length()
        self._drag = scale.ScaleDrag(self._degree, self._length(), place)
        self.pressed.emit()
        if not on_handle:
            self._move(0.0, event.modifiers())
        self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Follow the drag."""
        pixels = event.position().x() - self._pointer
        if self._drag is not None and pixels:
            self._pointer = event.position().x()
            self._move(pixels, event.modifiers())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End the drag."""
        if event.button() == Qt.MouseButton.LeftButton and self._drag is not None:
            self._drag = None
            self.released.emit()
            self.update()

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Step only with the focus: a wheel meant for scrolling must not change the curve."""
        notches = round(event.angleDelta().y() / 120)
        if self.hasFocus() and notches and self._drag is None:
            self.stepped.emit(notches, _fine(event.modifiers()))
        else:
            event.ignore()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows step, Page keys go from landmark to landmark, Home and End to the ends of the scale."""
        key, keys = event.key(), Qt.Key
        if key == keys.Key_Escape and self._drag is not None:
            self._drag = None
            self.cancelled.emit()
            self.update()
        elif self._drag is not None or not self._values.size:
            event.ignore()
        elif key in (keys.Key_Right, keys.Key_Up):
            self.stepped.emit(1, _fine(event.modifiers()))
        elif key in (keys.Key_Left, keys.Key_Down):
            self.stepped.emit(-1, _fine(event.modifiers()))
        elif key in (keys.Key_PageUp, keys.Key_PageDown):
            direction = 1 if key == keys.Key_PageUp else -1
            self.jumped.emit(scale.next_landmark(self._middle(), direction, self._degree))
        elif key in (keys.Key_Home, keys.Key_End):
            self.jumped.emit(scale.LOWEST if key == keys.Key_Home else scale.HIGHEST)
        else:
            event.ignore()

    def event(self, event: QEvent) -> bool:
        """Keep Escape for the drag while there is one."""
        if (
            isinstance(event, QKeyEvent)
            and event.type() == QEvent.Type.ShortcutOverride
            and self._drag is not None
            and event.key() == Qt.Key.Key_Escape
        ):
            event.accept()
            return True
        if event.type() in (QEvent.Type.Enter, QEvent.Type.Leave):
            self._hovered = event.type() == QEvent.Type.Enter
            self.update()
        return super().event(event)

    def changeEvent(self, event: QEvent) -> None:
        """Repaint in the new colours."""
        super().changeEvent(event)
        self.update()

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Show the focus."""
        super().focusInEvent(event)
        self.update()

    def _move(self, pixels: float, modifiers: Qt.KeyboardModifier) -> None:
        assert self._drag is not None
        free = bool(modifiers & Qt.KeyboardModifier.ShiftModifier)
        self.moved.emit(self._drag.move(pixels, fine=_fine(modifiers), free=free))

    # Where things are

    def _length(self) -> float:
        return max(self.width() - 2 * _INSET, 1.0)

    def _x(self, place: float) -> float:
        return _INSET + place * self._length()

    def _place(self) -> float:
        """Place of the handle; of values that differ, their mean or the middle of their range."""
        shown = self._values[[0, -1]] if self._mean is None else self._mean
        return float(scale.position(shown).mean())

    def _middle(self) -> float:
        if self._mean is not None:
            return self._mean
        return float(self._values[0] if self._values.size == 1 else scale.value_at(self._place()))

    # How it looks

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw band, ticks, labels and handles."""
        colours = colours_for(self.palette())
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if not self.isEnabled():
            painter.setOpacity(0.4)
        self._paint_track(painter, colours)
        self._paint_landmarks(painter, colours)
        if self._values.size:
            self._paint_handles(painter, colours)
        painter.end()

    def _paint_track(self, painter: QPainter, colours: Colours) -> None:
        def bar(start: float, end: float, colour: QColor) -> None:
            painter.setBrush(colour)
            left, right = self._x(start), self._x(end)
            painter.drawRoundedRect(
                QRectF(left, _TRACK_Y - _TRACK_HEIGHT / 2, right - left, _TRACK_HEIGHT), 2.5, 2.5
            )

        painter.setPen(Qt.PenStyle.NoPen)
        bar(0.0, 1.0, QColor(colours.grid_major))
        start, end = scale.position(CONVEX_HULL_RANGE[self._degree])
        band = QColor(colours.interpolating)
        band.setAlphaF(0.42)
        bar(float(start), float(end), band)
        if self._values.size > 1:
            low, high = scale.position(self._values[[0, -1]])
            bar(float(low), float(high), QColor(colours.accent))

    def _paint_landmarks(self, painter: QPainter, colours: Colours) -> None:
        font = small_font(self.font())
        painter.setFont(font)
        metrics = QFontMetricsF(font)
        marks = sorted(scale.landmarks(self._degree), key=lambda mark: _IMPORTANCE.index(mark.label))
        places = [self._x(float(scale.position(mark.value))) for mark in marks]
        widths = [metrics.horizontalAdvance(mark.label) for mark in marks]
        lefts = scale.placed_labels(places, widths, float(self.width()))
        pen = QPen(QColor(colours.secondary), 1.2)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        painter.setPen(pen)
        drawn: list[float] = []
        for mark, x, left in zip(marks, places, lefts, strict=True):
            if all(abs(x - other) >= _MERGED for other in drawn):
                drawn.append(x)
                painter.drawLine(QPointF(x, 18.0), QPointF(x, 24.0))
            if left is not None:
                painter.drawText(QPointF(left, _LABEL_TOP + metrics.ascent()), mark.label)

    def _paint_handles(self, painter: QPainter, colours: Colours) -> None:
        accent, ground = QColor(colours.accent), QColor(colours.panel)
        differing = self._values.size > 1
        if differing:
            faint = QColor(accent)
            faint.setAlphaF(0.35)
            painter.setPen(QPen(ground, 1.0))
            painter.setBrush(faint)
            pixels = distinct(np.round(scale.position(self._values) * self._length() / 4) * 4)
            for x in pixels if pixels.size <= _FAINT_HANDLES else ():
                painter.drawEllipse(QPointF(_INSET + x, _TRACK_Y), 4.5, 4.5)
        centre = QPointF(self._x(self._place()), _TRACK_Y)
        if self.hasFocus() or self._drag is not None or (self._hovered and self.isEnabled()):
            halo = QColor(accent)
            halo.setAlphaF(0.22)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(halo)
            painter.drawEllipse(centre, _RADIUS + 4, _RADIUS + 4)
        painter.setPen(QPen(accent if differing else ground, 2.0))
        painter.setBrush(ground if differing else accent)
        painter.drawEllipse(centre, _RADIUS, _RADIUS)
        beyond = -1 if self._values[-1] < scale.LOWEST else 1 if self._values[0] > scale.HIGHEST else 0
        if beyond:
            painter.setPen(QPen(ground if not differing else accent, 1.6))
            for side in (-3.0, 3.0):
                painter.drawLine(
                    QPointF(centre.x() - 1.5 * beyond, centre.y() + side),
                    QPointF(centre.x() + 1.5 * beyond, centre.y()),
                )


def _fine(modifiers: Qt.KeyboardModifier) -> bool:
    return bool(modifiers & Qt.KeyboardModifier.ControlModifier)
