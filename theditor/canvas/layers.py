"""What stands still is painted once, what moves on every frame: how a drag costs the same on any drawing.

Two pictures of the drawing are kept: one, opaque, of what lies below the curves (ground, grid, polygons, comb,
halos), one of the curves and what lies above them (joints, signs, handles). A frame shows the first, then the
second, each followed by what is alive there, and paints what is above all: what is selected, what is under the
pointer, what the hand is about to do. The pictures are painted anew only when something that they show has
changed: the view, the theme, the drawing. While the hand pans, the second is shifted, and painted where it
comes into view.

As long as a gesture is under way the pictures show the drawing before it, less the segments, edges, joints and
handles that differ from it now. Those are alive, painted by the same functions as all others.

Painting the pictures takes as many lines as the eye can tell apart (`chords`, `handles.detail`), and where these
would be very many a picture of bits (`dense`), so what changes everything depends on the pixels of the picture
more than on the size of the drawing.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPixmap

from theditor.canvas.comb import LONGEST, MOST_TEETH
from theditor.canvas.curves import CurvesPainter, paint_ghost, paint_modes, paint_segments
from theditor.canvas.handles import Detail, detail
from theditor.canvas.labels import MOST
from theditor.canvas.part import Part, changed_parts, no_part
from theditor.canvas.picture import (
    Frame,
    Piece,
    Shown,
    paint_above,
    paint_behind,
    paint_below,
    paint_ground,
    paint_hand,
    paint_names,
)
from theditor.canvas.projection import projected
from theditor.canvas.viewport import Area, Viewport
from theditor.drawing import Drawing
from theditor.model import Colours
from theditor.spline import Curve
from theditor.spline.distinct import distinct

MOST_ALIVE = 20_000
"""When more segments than this move, they are painted like those that stand still."""


class Still(NamedTuple):
    """All that the kept pictures depend on, besides what is left out of them."""

    drawing: Drawing
    current: int
    held: tuple[int, ...]
    segments: frozenset[int]
    plane: Viewport
    shown: Shown
    colours: Colours
    font: QFont
    ratio: float


class Layers:
    """Paints frames, and keeps between them the pictures of what stands still."""

    def __init__(self, curves: CurvesPainter) -> None:
        self._curves = curves
        self._still: Still | None = None
        self._alive: dict[int, Part] = {}
        self._details: dict[int, Detail] = {}
        self._below, self._above = QPixmap(), QPixmap()

    def paint(self, painter: QPainter, frame: Frame) -> None:
        """Paint a frame."""
        settled, alive = _told_apart(frame)
        held = frame.held if frame.has_current else ()
        still = Still(
            settled,
            frame.current if frame.has_current else -1,
            held,
            frame.segments,
            frame.plane,
            frame.shown,
            frame.colours,
            frame.font,
            painter.device().devicePixelRatioF(),
        )
        self._curves.update(settled, passing=frame.before is not None and frame.before is not settled)
        now = {i: projected(frame.drawing[i].curve) for i in alive if frame.drawing[i].visible}

        def seen(index: int) -> Curve:
            return now.get(index) or self._curves.plane_curve(index)

        self._keep(still, {i: alive[i] for i in now}, frame)
        painter.drawPixmap(0, 0, self._below)
        paint_behind(painter, frame, seen)
        alive_ones = [i for i in held if i in self._alive and i in self._details]
        pieces = [self._piece(frame, i, seen(i), self._alive[i]) for i in alive_ones]
        if frame.shown.ghost and frame.before is not None:
            were = [(self._curves.plane_curve(i), alive[i].segments) for i in now]
            paint_ghost(painter, were, frame.plane, frame.colours)
        for piece in pieces:
            paint_below(painter, frame, piece)
        painter.drawPixmap(0, 0, self._above)
        moved = [
            (frame.drawing[i], seen(i), self._alive[i].segments)
            for i in sorted(self._alive, key=lambda i: i == still.current)
        ]
        by_mode = still.current in self._alive and frame.shown.modes
        paint_segments(painter, moved[: len(moved) - by_mode], frame.plane, frame.colours)
        for item, curve, segments in moved[len(moved) - by_mode :]:
            paint_modes(painter, item, curve, segments, frame.plane, frame.colours)
        for piece in pieces:
            paint_above(painter, frame, piece)
        paint_hand(painter, frame, seen)
        if still.current in self._details and frame.shown.labels:
            part = self._alive.get(still.current) or no_part(seen(still.current))
            if self._details[still.current].points <= MOST + len(part.points):
                segments = np.concatenate([self._curves.seen(still.current, frame.plane), part.segments])
                paint_names(painter, frame, seen(still.current), distinct(segments))

    def _keep(self, still: Still, alive: dict[int, Part], frame: Frame) -> None:
        """Paint the kept pictures anew unless they show what stands still, without what is alive."""
        left_out = all(i in self._alive and self._alive[i].holds(part) for i, part in alive.items())
        over = frame.before is None and self._alive
        if still == self._still and left_out and not over:
            return
        if self._still is not None and still.drawing is self._still.drawing and alive:
            for i, part in self._alive.items():
                alive[i] = part.united(curve := still.drawing[i].curve, alive.get(i) or no_part(curve))
        shift = None if alive or self._alive else self._shift(still)
        self._still, self._alive = still, alive
        self._details = {}
        packed = self._curves.packed(still.plane)
        pieces = [self._still_piece(frame, index) for index in still.held if index not in packed]
        exposed = self._scrolled(*shift) if shift is not None else self._blank()
        self._below.fill(QColor(still.colours.canvas))
        painter = QPainter(self._below)
        paint_ground(painter, frame)
        for piece in pieces:
            paint_below(painter, frame, piece)
        painter.end()
        painter = QPainter(self._above)
        for area in exposed:
            painter.setClipRect(QRectF(*area))
            self._curves.paint(
                painter,
                still.drawing,
                still.current,
                still.plane,
                still.colours,
                by_mode=still.shown.modes,
                without={i: part.segments for i, part in alive.items()},
                area=area,
            )
            for piece in pieces:
                paint_above(painter, frame, piece)
        painter.end()

    def _shift(self, still: Still) -> tuple[int, int] | None:
        """By how many device pixels the kept pictures are shifted against those wanted, if that is all."""
        kept = self._still
        if kept is None or kept._replace(plane=still.plane) != still:
            return None
        return kept.plane.shift_to(still.plane, still.ratio)

    def _scrolled(self, x: int, y: int) -> list[Area]:
        """Shift the upper picture by some device pixels; returns the areas that come into view, empty."""
        picture = self._above
        width, height, ratio = picture.width(), picture.height(), picture.devicePixelRatio()
        if abs(x) >= width or abs(y) >= height:
            return self._blank()
        picture.scroll(x, y, picture.rect())
        upright = 0 if x > 0 else width + x, 0, abs(x), height
        level = max(x, 0), 0 if y > 0 else height + y, width - abs(x), abs(y)
        areas: list[Area] = [
            (left / ratio, top / ratio, wide / ratio, high / ratio)
            for left, top, wide, high in (upright, level)
            if wide and high
        ]
        painter = QPainter(picture)
        painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_Source)
        for area in areas:
            painter.fillRect(QRectF(*area), Qt.GlobalColor.transparent)
        painter.end()
        return areas

    def _blank(self) -> list[Area]:
        """Make both pictures new where the size is another, and the upper one empty; returns its whole area."""
        assert self._still is not None
        plane, ratio = self._still.plane, self._still.ratio
        size = QSize(math.ceil(plane.width * ratio), math.ceil(plane.height * ratio))
        if self._below.size() != size:
            self._below, self._above = QPixmap(size), QPixmap(size)
        for picture in (self._below, self._above):
            picture.setDevicePixelRatio(ratio)
        self._above.fill(Qt.GlobalColor.transparent)
        return [(0.0, 0.0, plane.width, plane.height)]

    def _still_piece(self, frame: Frame, index: int) -> Piece:
        """What stands still of a held curve."""
        curve = self._curves.plane_curve(index)
        segments = self._curves.seen(index, frame.plane)
        self._details[index] = detail(curve, frame.plane, segments)
        if index == frame.current and frame.shown.comb:
            # Teeth may reach into view from beside it.
            around = self._curves.seen(index, frame.plane, LONGEST)
            if len(around) * frame.shown.comb_density <= MOST_TEETH:
                segments = around
        return self._piece(
            frame, index, curve, (self._alive.get(index) or no_part(curve)).rest(curve, segments)
        )

    def _piece(self, frame: Frame, index: int, curve: Curve, part: Part) -> Piece:
        reference = self._curves.plane_curve(index)
        return Piece(curve, reference, part, self._details[index], index == frame.current)


def _told_apart(frame: Frame) -> tuple[Drawing, dict[int, Part]]:
    """The drawing that stands still, and the parts that are alive, by the curve."""
    if frame.before is None or frame.before is frame.drawing:
        return frame.drawing, {}
    parts = changed_parts(frame.before, frame.drawing, MOST_ALIVE)
    return (frame.drawing, {}) if parts is None else (frame.before, parts)
