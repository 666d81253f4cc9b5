"""The curvature panel: curvature against arc length, linked to the canvas, and how its comb looks there."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPixmap,
    QShowEvent,
)
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QSlider, QVBoxLayout, QWidget

from theditor.model import Colours, Document, Selection, colours_for, unbreakable
from theditor.model.words import number
from theditor.panels.curvature_plot import (
    MOST_MARKED,
    NO_MARKS,
    Marks,
    marks,
    paint_curvature,
    paint_place,
    plot_of,
)
from theditor.panels.curvature_profile import Profile, profile
from theditor.panels.parts import GAP, MARGIN, Paragraph, describe
from theditor.spline import Curve
from theditor.spline.curvature import curvature

MOST_LIVE = 5000
"""Longer curves, in segments, are plotted anew when the hand lets go of them."""
EMPTY = "There is no curve yet."
NO_LENGTH = "All points of this curve coincide: it has no length and no curvature."
HINT = "Point at the curve, here or on the canvas, for curvature, radius and length."
_TIP = (
    "Curvature along the curve: rings mark inflections, triangles extremes (hollow: least). "
    "Move over the plot to see the place on the canvas."
)
_LENGTH_STEPS = 50  # of the slider to either side; at its ends teeth are ten times as long or short
_DENSITY = (1, 64, 16)  # least, most, default


@unbreakable
class CurvaturePlot(QWidget):
    """The plot itself. The arrow keys move the marker along the curve."""

    hovered = Signal(object)
    """The place pointed at in the plot, as a parameter u of the current curve; None when there is none."""
    changed = Signal()
    """Another curve, or another place on it, is shown."""

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._selection = document, selection
        self._index = selection.curve
        self._curve: Curve | None = None
        self._segments: frozenset[int] = frozenset()
        self._profile: Profile | None = None
        self._marked: tuple[Curve | None, Marks] = (None, NO_MARKS)
        self._picture: tuple[object, QPixmap] = (None, QPixmap())
        self.place: float | None = None
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        describe(self, "Curvature against arc length", _TIP)
        document.changed.connect(self._follow)
        selection.changed.connect(self._follow)
        document.stepped.connect(self._settle)

    def minimumSizeHint(self) -> QSize:
        """Room for a small plot."""
        return QSize(240, 100)

    def sizeHint(self) -> QSize:
        """Room for a wide one."""
        return QSize(640, 150)

    @property
    def shown(self) -> Profile | None:
        """The table of the current curve, made when first needed; None without a curve of any length."""
        curve = self._curve
        if curve is None:
            return None
        if self._profile is None or self._profile.curve is not curve:
            self._profile = profile(curve)
        return self._profile if self._profile.total > 0 else None

    @property
    def marks(self) -> Marks:
        """What is marked; nothing while a hand is on the drawing, and on very long curves."""
        curve = self._curve
        if curve is None or curve.segment_count > MOST_MARKED or self._document.before is not None:
            return NO_MARKS
        if self._marked[0] is not curve:
            self._marked = curve, marks(curve)
        return self._marked[1]

    def show_place(self, u: float | None) -> None:
        """Put the marker at parameter `u` of the current curve."""
        if not self.isVisible():
            return
        if u is not None and (self._curve is None or not 0 <= u <= self._curve.segment_count):
            u = None
        if u != self.place:
            self.place = u
            self._show()

    def _follow(self) -> None:
        if not self.isVisible():
            return
        item, segments = self._selection.item, self._selection.segments
        curve = item.curve if item is not None else None
        if self._document.before is not None and curve is not None and curve.segment_count > MOST_LIVE:
            return
        if curve is not self._curve or segments != self._segments:
            another = self._selection.curve != self._index
            if curve is None or another or (self.place or 0.0) > curve.segment_count:
                self.place = None
            self._index = self._selection.curve
            self._curve, self._segments = curve, segments
            self._show()

    def _settle(self) -> None:
        """Show what waited until the hand lets go: marks, and a very long curve."""
        self._follow()
        self.update()

    def _show(self) -> None:
        self.update()
        self.changed.emit()

    def words(self) -> list[str]:
        """Say what curvature, radius and length are at the marker, line by line."""
        curve, u = self._curve, self.place
        if curve is None:
            return [EMPTY]
        if u is None:
            return [HINT]
        shown = self.shown
        if shown is None:
            return [NO_LENGTH]
        segment = min(int(u), curve.segment_count - 1)
        bend = float(curvature(curve, u))
        radius = 1 / abs(bend) if bend else float("inf")
        circle = f"radius {number(radius)}" if abs(bend) * shown.total > 1e-9 else "straight"
        still = bend != bend  # nan: no direction to turn from
        length = f"{shown.length_at(u):.4g} of {shown.total:.4g}"
        return [
            f"Segment {segment + curve.first_segment} at t = {u - segment:.3f}",
            "the curve stands still" if still else f"κ = {number(bend)}, {circle}",
            f"length {length}",
        ]

    # What the hand does

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Show the place under the pointer, here and on the canvas."""
        shown = self.shown
        if shown is not None:
            plot, _, _ = plot_of(shown, self.width(), self.height())
            self._point(shown.parameter_at(plot.value_x(event.position().x())))

    def leaveEvent(self, event: QEvent) -> None:
        """Nothing is pointed at any more."""
        super().leaveEvent(event)
        self._point(None)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The keys point at nothing any more."""
        super().focusOutEvent(event)
        self._point(None)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Left and right go along the curve, with Shift ten times as far; Home and End to its ends."""
        shown, keys = self.shown, Qt.Key
        if shown is None:
            event.ignore()
            return
        step = shown.total / (20 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 200)
        here = shown.length_at(self.place) if self.place is not None else 0.0
        lengths = {
            keys.Key_Left: max(here - step, 0.0),
            keys.Key_Right: min(here + step, shown.total),
            keys.Key_Home: 0.0,
            keys.Key_End: shown.total,
        }
        if event.key() in lengths:
            self._point(shown.parameter_at(lengths[keys(event.key())]))
        else:
            event.ignore()

    def _point(self, u: float | None) -> None:
        self.show_place(u)
        self.hovered.emit(u)

    # Painting

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with what changed while nobody saw it."""
        super().showEvent(event)
        self._follow()

    def changeEvent(self, event: QEvent) -> None:
        """Repaint in the new colours or font."""
        super().changeEvent(event)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the plot."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        colours = colours_for(self.palette())
        painter.fillRect(event.rect(), QColor(colours.panel))
        shown, size = self.shown, (self.width(), self.height())
        if shown is None:
            painter.setPen(QColor(colours.secondary))
            reason = EMPTY if self._curve is None else NO_LENGTH
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, reason)
        else:
            painter.drawPixmap(0, 0, self._painted(shown, colours))
            if self.place is not None:
                paint_place(painter, shown, self.place, *size, colours)
        painter.end()

    def _painted(self, shown: Profile, colours: Colours) -> QPixmap:
        """Return a picture of the plot, painted anew only if it is another one: the marker moves often."""
        marked, font, ratio = self.marks, self.font(), self.devicePixelRatio()
        key = shown, marked, self._segments, self.size().toTuple(), ratio, font, colours
        if self._picture[0] != key:
            pixmap = QPixmap(self.size() * ratio)
            pixmap.setDevicePixelRatio(ratio)
            pixmap.fill(QColor(colours.panel))
            painter = QPainter(pixmap)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            chosen = sorted(self._segments)
            paint_curvature(painter, shown, marked, chosen, self.width(), self.height(), font, colours)
            painter.end()
            self._picture = key, pixmap
        return self._picture[1]


class CurvaturePanel(QWidget):
    """The plot, beside it the numbers at the marker and the sliders of the comb on the canvas."""

    hovered = Signal(object)
    """The place pointed at in the plot, as a parameter u of the current curve; None when there is none."""
    comb_changed = Signal(float, int)
    """Length of the comb's teeth, 1 being usual, and their number in each segment."""

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.plot = CurvaturePlot(document, selection)
        self.text = Paragraph()
        self.text.setAccessibleName("Curvature at the marker")
        self.length = _slider("Comb length", "How long the teeth of the curvature comb on the canvas are")
        self.length.setRange(-_LENGTH_STEPS, _LENGTH_STEPS)
        self.density = _slider("Comb density", "How many teeth the comb has in each segment")
        self.density.setRange(*_DENSITY[:2])
        self.density.setValue(_DENSITY[2])
        sliders = QGridLayout()
        sliders.setHorizontalSpacing(GAP)
        sliders.setVerticalSpacing(4)
        for row, slider in enumerate((self.length, self.density)):
            label = QLabel(slider.accessibleName())
            label.setProperty("role", "secondary")
            label.setBuddy(slider)
            sliders.addWidget(label, row, 0)
            sliders.addWidget(slider, row, 1)
        side = QVBoxLayout()
        side.setContentsMargins(0, 8, MARGIN, 8)
        side.addWidget(self.text)
        side.addStretch(1)
        side.addLayout(sliders)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GAP)
        layout.addWidget(self.plot, 1)
        layout.addLayout(side)
        self.text.setFixedWidth(220)

        self.plot.hovered.connect(self.hovered)
        self.plot.changed.connect(self._tell)
        self.length.valueChanged.connect(self._comb)
        self.density.valueChanged.connect(self._comb)
        self._tell()

    def show_place(self, u: float | None) -> None:
        """Put the marker at parameter `u` of the current curve; None takes it away."""
        self.plot.show_place(u)

    def _tell(self) -> None:
        self.text.setText("\n".join(self.plot.words()))

    def _comb(self) -> None:
        self.comb_changed.emit(10 ** (self.length.value() / _LENGTH_STEPS), self.density.value())


def _slider(name: str, tip: str) -> QSlider:
    slider = QSlider(Qt.Orientation.Horizontal)
    describe(slider, name, tip)
    return slider
