"""The basis panel: the basis functions of the selected segment, live, and their weights at one t."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QShowEvent
from PySide6.QtWidgets import QWidget

from theditor.model import Document, Selection, colours_for, unbreakable
from theditor.model.words import number
from theditor.panels.basis_plot import SegmentBasis, paint_basis, plots
from theditor.panels.parts import describe
from theditor.spline import Curve

HINT = "Select a segment, or point at one on the canvas, to see its basis functions."
_TIP = (
    "Weights of the segment's control points over t; thin behind: trigonometric (T) and hyperbolic (H). "
    "Move over the plot to see the weights at any t, and the place on the canvas."
)
_STEP, _LEAP = 0.01, 0.1


@unbreakable
class BasisPanel(QWidget):
    """Shows the selected segment's basis functions; of several, the one under the pointer or the first.

    If none is selected it shows the segment under the pointer. The arrow keys move t.
    """

    hovered = Signal(object)
    """The place pointed at in the plot, as a parameter u of the current curve; None when there is none."""

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._selection = selection
        self._index = selection.curve
        self._curve: Curve | None = None
        self._segments: frozenset[int] = frozenset()
        self._pointed: int | None = None
        self.t = 0.5
        self.shown: SegmentBasis | None = None
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        describe(self, "Basis functions", _TIP)
        document.changed.connect(self._follow)
        selection.changed.connect(self._follow)
        self._show()

    def sizeHint(self) -> QSize:
        """Room for the plot and the bars."""
        return QSize(640, 160)

    def minimumSizeHint(self) -> QSize:
        """Room for a small plot."""
        return QSize(360, 120)

    def show_place(self, u: float | None) -> None:
        """Show the weights at parameter `u` of the current curve, if it lies on the segment that is shown."""
        if not self.isVisible():
            return
        if u is None or self._curve is None or not 0 <= u <= self._curve.segment_count:
            self._pointed = None
        else:
            self._pointed = min(int(u), self._curve.segment_count - 1)
        self._choose()
        if u is not None and self.shown is not None and 0 <= u - self.shown.segment <= 1:
            self._set_t(u - self.shown.segment)

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with what changed while nobody saw it."""
        super().showEvent(event)
        self._follow()

    def _follow(self) -> None:
        if not self.isVisible():
            return
        item, segments = self._selection.item, self._selection.segments
        curve = item.curve if item is not None else None
        if curve is not self._curve or segments != self._segments:
            another = self._selection.curve != self._index
            if curve is None or another or (self._pointed or 0) >= curve.segment_count:
                self._pointed = None
            self._index = self._selection.curve
            self._curve, self._segments = curve, segments
            self._choose()

    def _choose(self) -> None:
        """Show the segment that is due."""
        chosen = self._pointed
        if self._segments and self._pointed not in self._segments:
            chosen = min(self._segments)
        shown = SegmentBasis(self._curve, chosen) if self._curve is not None and chosen is not None else None
        if shown != self.shown:
            self.shown = shown
            self._show()

    def _set_t(self, t: float) -> None:
        if t != self.t:
            self.t = t
            self._show()

    def _show(self) -> None:
        self.setAccessibleDescription(self.words())
        self.update()

    def words(self) -> str:
        """What is shown, in words."""
        if self.shown is None:
            return HINT
        weights = zip(self.shown.names, self.shown.weights(self.t).tolist(), strict=True)
        values = ", ".join(f"{name} = {number(round(weight, 6))}" for name, weight in weights)
        return f"{self.shown.title()}. At t = {self.t:.3f}: {values}"

    # What the hand does

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Show the weights at the t under the pointer, and the place on the canvas."""
        if self.shown is not None:
            functions, _, _ = plots(self.shown, self.width(), self.height())
            self._point(functions.value_x(event.position().x()))

    def leaveEvent(self, event: QEvent) -> None:
        """Nothing is pointed at any more."""
        super().leaveEvent(event)
        self.hovered.emit(None)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Left and right move t, with Shift ten times as far; Home and End go to the joints."""
        keys = Qt.Key
        step = _LEAP if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else _STEP
        places = {
            keys.Key_Left: max(self.t - step, 0.0),
            keys.Key_Right: min(self.t + step, 1.0),
            keys.Key_Home: 0.0,
            keys.Key_End: 1.0,
        }
        if self.shown is not None and event.key() in places:
            self._point(places[keys(event.key())])
        else:
            event.ignore()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The keys point at nothing any more."""
        super().focusOutEvent(event)
        self.hovered.emit(None)

    def _point(self, t: float) -> None:
        assert self.shown is not None
        self._set_t(t)
        self.hovered.emit(self.shown.segment + t)

    # Painting

    def changeEvent(self, event: QEvent) -> None:
        """Repaint in the new colours or font."""
        super().changeEvent(event)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the plot and the bars, or say how to get them."""
        painter = QPainter(self)
        colours = colours_for(self.palette())
        painter.fillRect(event.rect(), QColor(colours.panel))
        if self.shown is None:
            painter.setPen(QColor(colours.secondary))
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, HINT)
        else:
            paint_basis(painter, self.shown, self.t, self.width(), self.height(), self.font(), colours)
        painter.end()
