"""Drawing the curves: the current one coloured by the modes of its segments, the others in their own colours."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache, partial
from itertools import groupby
from operator import is_, itemgetter

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPainter, QPen

from theditor.canvas.chords import ChordTree, Leaves
from theditor.canvas.dense import NARROWEST, WIDEST, paint_dense, spacing
from theditor.canvas.handles import FEW, MOST_IN_SQUARE, SQUARE
from theditor.canvas.held import Held
from theditor.canvas.lines import clipped, draw_lines
from theditor.canvas.projection import projected
from theditor.canvas.raster import Along
from theditor.canvas.trace import TOLERANCE, Stroke, strokes, traced
from theditor.canvas.viewport import Area, Floats, Viewport
from theditor.drawing import Drawing, Item
from theditor.model.colours import Colours
from theditor.spline import Curve, Mode
from theditor.spline.distinct import distinct

Ints = NDArray[np.intp]
Style = tuple[str, float]
"""Colour and width of a pen."""

MODES = (Mode.TRIGONOMETRIC, Mode.HYPERBOLIC, Mode.INTERPOLATING, Mode.BLEND)
"""Modes by their code in `Curve.mode_codes`."""
CROWDED = 10_000
"""In a drawing of more segments than this, lines may run over several of them more freely."""
CROWDED_TOLERANCE = 0.25
"""So many pixels they may then be away from the curve."""
DENSE, MOST_LINES = 0.037, 25_000
"""Curves of more lines than this for each pixel, and that in all, are laid as points, which takes less time, …"""
MOST_INKS, MOST_POINTS = 16, 8
"""… unless they come in more colours and widths one over the other, or run to more points for each pixel."""
VISIBLE, CLEAR = 70.0, 110.0
"""A curve that is not so much, of 255, darker or lighter than the canvas is made to be, and by so much."""
FRAYING = 6.0
"""In bends of lines wider than this the corners of square caps would stick out."""
MOST_FORMER, MOST_KEPT = 10, 1_000_000
"""So many trees, over so many segments in all, are kept for going back to former drawings.

Each one is asked at every change whether it can follow; each segment takes some 270 bytes, its curve's included.
"""


class CurvesPainter:
    """Draws the visible curves of a drawing, and finds what of them lies where."""

    def __init__(self) -> None:
        self._places: dict[int, int] = {}
        self._sources: list[Curve] = []
        self._curves: list[Curve] = []
        self._tree = ChordTree([])
        self._former: list[ChordTree] = []
        """Trees over drawings that were left, the last one first, for going back to them."""
        self._passing = False
        self.handles = Held(Drawing(), {})
        """All control points of the visible curves."""

    def update(self, drawing: Drawing, *, passing: bool = False) -> None:
        """Follow the drawing; costs what has changed since the last time.

        Trees over the last drawings that were not just `passing` are kept for going back to them.
        """
        visible = [i for i, item in enumerate(drawing) if item.visible]
        sources = [drawing[i].curve for i in visible]
        same = len(sources) == len(self._sources)
        if same and visible == list(self._places) and all(map(is_, sources, self._sources)):
            self._passing = passing
            return
        kept = {id(source): plane for source, plane in zip(self._sources, self._curves, strict=True)}
        curves = [kept.get(id(source)) or projected(source) for source in sources]
        if not self._tree.follow(curves):
            self._leave(curves)
        self._passing = passing
        self._places = {i: place for place, i in enumerate(visible)}
        self._sources, self._curves = sources, curves
        self.handles = Held(drawing, {i: np.arange(len(drawing[i].curve.control_points)) for i in visible})

    def forget(self) -> None:
        """Let go of former drawings, and of this one once another is shown: nobody goes back to them."""
        self._former, self._passing = [], True

    def _leave(self, curves: list[Curve]) -> None:
        """Take up a former tree that can follow the curves, or else a new one."""
        former = [*([] if self._passing else [self._tree]), *self._former]
        follower = next((tree for tree in self._former if tree.follow(curves)), None)
        self._tree = follower or ChordTree(curves, self._tree)
        self._former, size = [], 0
        for tree in former:
            if tree is not self._tree and len(self._former) < MOST_FORMER and size < MOST_KEPT:
                self._former.append(tree)
                size += tree.size

    def plane_curve(self, index: int) -> Curve:
        """Curve `index` as it is seen; it must be visible."""
        return self._curves[self._places[index]]

    def seen(self, index: int, viewport: Viewport, margin: float = 8.0) -> Ints:
        """The segments of curve `index` that may be in view, ascending."""
        return self._tree.seen(self._places[index], *viewport.window(margin))

    def packed(self, viewport: Viewport) -> set[int]:
        """Curves that have many control points in very little room on the screen."""
        width, height = self._tree.sizes * (viewport.scale / SQUARE)
        counts = np.array([len(curve.control_points) for curve in self._curves])
        packed = (counts > FEW) & (counts > 2 * MOST_IN_SQUARE * (width + 1) * (height + 1))
        indices = list(self._places)
        return {indices[place] for place in np.flatnonzero(packed).tolist()}

    def near(
        self, at: Floats, reach: float, viewport: Viewport, without: Mapping[int, Ints] | None = None
    ) -> dict[int, Stroke]:
        """What of each curve passes within reach, in pixels, of a pixel (2,), and some more around it.

        Some segments of some curves may be left out.
        """
        point, away = viewport.to_points(at), reach / viewport.scale
        tolerance = TOLERANCE / viewport.scale
        found = self._tree.chords(
            point - away, point + away, tolerance, without=self._by_place(without), whole=True
        )
        assert found is not None, "however many they are"
        lines = viewport.lines_to_pixels(found.lines)
        indices, result = list(self._places), {}
        for place in distinct(found.curves).tolist():
            own = slice(*np.searchsorted(found.curves, (place, place + 1)).tolist())
            result[indices[place]] = Stroke(-1, lines[own], found.segments[own], found.parameters[own])
        return result

    def _by_place(self, segments: Mapping[int, Ints] | None) -> dict[int, Ints]:
        return {self._places[i]: of for i, of in (segments or {}).items() if i in self._places}

    def paint(
        self,
        painter: QPainter,
        drawing: Drawing,
        current: int,
        viewport: Viewport,
        colours: Colours,
        *,
        by_mode: bool,
        without: Mapping[int, Ints] | None = None,
        area: Area | None = None,
    ) -> None:
        """Paint all curves, the current one last, so that it lies on top.

        Some segments of some may be left out; what lies outside an area in pixels may be, too.
        """
        margin = 8.0 + max((drawing[i].width for i in self._places), default=0.0) / 2
        area = area or (0.0, 0.0, viewport.width, viewport.height)
        low, high = viewport.window(margin, area)
        ratio = painter.device().devicePixelRatioF()
        room = ratio**2 * (area[2] + 2 * margin) * (area[3] + 2 * margin)
        tolerance = TOLERANCE if self._tree.size <= CROWDED else CROWDED_TOLERANCE
        top, without = self._places.get(current, -1), self._by_place(without)
        lines_if = partial(
            self._tree.chords,
            low,
            high,
            tolerance / ratio / viewport.scale,
            by_mode=top if by_mode else -1,
            without=without,
        )
        inks = partial(self._inks, drawing, top, colours, by_mode=by_mode)
        whole = ratio**2 * viewport.width * viewport.height  # of which an area has its share
        chords = lines_if(most=(DENSE + MOST_LINES / whole) * room)
        if chords is None:
            leaves = self._tree.leaves(low, high, without)
            laid = self._laid(leaves, inks(leaves.curves, leaves.codes), viewport.scale, ratio, room)
            if laid is not None:
                for (colour, width), points in laid:
                    paint_dense(painter, points, viewport, width, colour, area)
                return
            chords = lines_if()
            assert chords is not None, "however many they are"
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        lines, kept = clipped(viewport.lines_to_pixels(chords.lines), viewport.width, viewport.height, margin)
        pens: dict[Style, QPen] = {}
        for style, chosen in inks(chords.curves[kept], chords.codes[kept]):
            painter.setPen(_pen_of(style, pens))
            draw_lines(painter, lines[chosen] if isinstance(chosen, slice) else lines.take(chosen, axis=0))

    def _inks(
        self,
        drawing: Drawing,
        top: int,
        colours: Colours,
        owners: Ints,
        codes: NDArray[np.int8],
        *,
        by_mode: bool,
    ) -> Iterator[tuple[Style, slice | Ints]]:
        """Which parts of what belongs to some curves, by their places, ascending, to paint how, from the bottom up."""
        indices = list(self._places)
        starts = np.searchsorted(owners, np.arange(len(indices) + 1)).tolist()
        for place in sorted(distinct(owners).tolist(), key=lambda place: place == top):
            item, own = drawing[indices[place]], slice(starts[place], starts[place + 1])
            if by_mode and place == top:
                for code in distinct(codes[own]).tolist():
                    style = colours.of_mode(MODES[code]), item.width
                    yield style, own.start + np.flatnonzero(codes[own] == code)
            else:
                yield _style_of(item, colours), own

    def _laid(
        self,
        leaves: Leaves,
        inks: Iterator[tuple[Style, slice | Ints]],
        scale: float,
        ratio: float,
        room: float,
    ) -> list[tuple[Style, Along]] | None:
        """Points along some segments, by how to paint them; None where lines take less time."""
        result: list[tuple[Style, Along]] = []
        for style, group in groupby(inks, key=itemgetter(0)):
            own = np.concatenate([leaves.rows[chosen] for _, chosen in group])
            width = style[1] * ratio
            if not NARROWEST <= width <= WIDEST or len(result) == MOST_INKS:
                return None
            points = self._tree.points(own, spacing(width) / ratio / scale, MOST_POINTS * room)
            if points is None:
                return None
            result.append((style, points))
        return result


def paint_segments(
    painter: QPainter, parts: Sequence[tuple[Item, Curve, Ints]], viewport: Viewport, colours: Colours
) -> None:
    """Paint some segments of items' plane curves in their own colours, as `CurvesPainter.paint` does all."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    margin = 8.0 + max((item.width for item, *_ in parts), default=0.0) / 2
    pens: dict[Style, QPen] = {}
    for (item, *_), lines in zip(parts, traced([part[1:] for part in parts], viewport, margin), strict=True):
        painter.setPen(_pen_of(_style_of(item, colours), pens))
        draw_lines(painter, lines)


def paint_modes(
    painter: QPainter, item: Item, curve: Curve, segments: Ints, viewport: Viewport, colours: Colours
) -> None:
    """Paint some segments of an item's plane curve in the colours of their modes."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for stroke in strokes(curve, viewport, segments, 8.0 + item.width / 2):
        painter.setPen(curve_pen(colours.of_mode(MODES[stroke.code]), item.width))
        draw_lines(painter, stroke.lines)


def paint_ghost(
    painter: QPainter, parts: Sequence[tuple[Curve, Ints]], viewport: Viewport, colours: Colours
) -> None:
    """Paint, faint, some segments of plane curves as they were."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    faint = QColor(colours.secondary)
    faint.setAlpha(110)
    painter.setPen(QPen(faint, 1.0))
    for lines in traced(parts, viewport):
        draw_lines(painter, lines)


def paint_halo(
    painter: QPainter, curve: Curve, segments: Ints, viewport: Viewport, colours: Colours, width: float = 11.0
) -> None:
    """Paint the soft band behind selected (or, narrower, hovered) segments of a plane curve."""
    if len(segments):
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        pen = curve_pen(colours.selection, width)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        painter.setPen(pen)
        for stroke in strokes(curve, viewport, segments, 8.0 + width / 2):
            draw_lines(painter, stroke.lines)


def curve_pen(colour: str, width: float) -> QPen:
    """The pen for curves. Its caps close the gaps between the straight pieces: square ones take a third of the time."""
    pen = QPen(QColor(colour), width)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap if width > FRAYING else Qt.PenCapStyle.SquareCap)
    return pen


def _pen_of(style: Style, pens: dict[Style, QPen]) -> QPen:
    """The pen of a style; pens are kept for the next time."""
    return pens.get(style) or pens.setdefault(style, curve_pen(*style))


def _style_of(item: Item, colours: Colours) -> Style:
    """How to paint an item in its own colour."""
    return _legible(item.color, colours.canvas), item.width


@lru_cache(maxsize=256)
def _legible(own: str, canvas: str) -> str:
    """A curve's own colour, lightened or darkened, where it would vanish in the canvas."""
    colour, ground = QColor(own), _luma(QColor(canvas))
    if abs(_luma(colour) - ground) >= VISIBLE:
        return own
    hue, saturation, step = max(colour.hslHue(), 0), colour.hslSaturation(), 3 if ground < 128 else -3
    while abs(_luma(colour) - ground) < CLEAR:
        colour = QColor.fromHsl(hue, saturation, min(max(colour.lightness() + step, 0), 255))
    return colour.name()


def _luma(colour: QColor) -> float:
    return 0.299 * colour.red() + 0.587 * colour.green() + 0.114 * colour.blue()
