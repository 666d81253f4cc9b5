"""What stands still is painted once, what moves on every frame: how a drag costs the same on any drawing.

Two pictures of the drawing are kept: one, opaque, of what lies below the curves (ground, grid, polygons, comb,
halos), one of the curves and what lies above them (joints, signs, handles). A frame shows the first, then the
second, each followed by what is alive there, and paints what is above all: what is selected, what is under the
pointer, what the hand is about to do. The pictures are painted anew only when something that they show has
changed: the view, the theme, the drawing. While the hand pans, the second is shifted, and painted where it
comes into view. While it zooms, and the curves are more lines than a frame has time for, they are enlarged or
reduced as they were last painted, until the hand rests.

As long as a gesture is under way the pictures show the drawing before it, less the segments, edges, joints and
handles that differ from it now. Those are alive, painted by the same functions as all others.

Painting the pictures takes as many lines as the eye can tell apart (`chords`, `handles.detail`), so what changes
everything depends on how much ink there is to see, not on the size of the drawing.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPixmap

from theditor.canvas.curves import CurvesPainter, paint_ghost, paint_modes, paint_segments
from theditor.canvas.handles import Detail, detail
from theditor.canvas.labels import MOST
from theditor.canvas.moved import scaled, shift
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
MOST_LINES = 40_000
"""Curves that are more lines than this are not painted anew while the hand zooms."""
ROUGH = 1.0
"""So many pixels the lines may be away from what comes into view meanwhile."""


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


class Ink(NamedTuple):
    """A picture of the curves alone."""

    plane: Viewport
    picture: QPixmap


class Layers:
    """Paints frames, and keeps between them the pictures of what stands still."""

    def __init__(self, curves: CurvesPainter) -> None:
        self._curves = curves
        self._still: Still | None = None
        self._alive: dict[int, Part] = {}
        self._details: dict[int, Detail] = {}
        self._below, self._above = QPixmap(), QPixmap()
        self._ink: Ink | None = None
        """What the upper picture shows of the curves, if they are many lines."""
        self._rough = False
        """Whether it shows them enlarged or reduced."""

    def paint(self, painter: QPainter, frame: Frame, *, zooming: bool = False) -> None:
        """Paint a frame; while the hand zooms, curves of many lines as they were painted in another view."""
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

        self._keep(still, {i: alive[i] for i in now}, frame, zooming=zooming)
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

    def _keep(self, still: Still, alive: dict[int, Part], frame: Frame, *, zooming: bool) -> None:
        """Paint the kept pictures anew unless they show what stands still, without what is alive."""
        left_out = all(i in self._alive and self._alive[i].holds(part) for i, part in alive.items())
        over = frame.before is None and self._alive
        if still == self._still and left_out and not over and (zooming or not self._rough):
            return
        if self._still is not None and still.drawing is self._still.drawing and alive:
            for i, part in self._alive.items():
                alive[i] = part.united(curve := still.drawing[i].curve, alive.get(i) or no_part(curve))
        former = None if alive or self._alive else self._former_view(still)
        shifted = former.shift_to(still.plane, still.ratio) if former and not self._rough else None
        self._still, self._alive = still, alive
        self._details = {}
        packed = self._curves.packed(still.plane)
        pieces = [self._still_piece(frame, index) for index in still.held if index not in packed]
        areas = self._blank() if shifted is None else shift(self._above, *shifted)
        self._below.fill(QColor(still.colours.canvas))
        painter = QPainter(self._below)
        paint_ground(painter, frame)
        for piece in pieces:
            paint_below(painter, frame, piece)
        painter.end()
        if shifted is None:
            self._paint_ink(areas, self._ink if zooming and former else None)
        else:
            self._paint_curves(areas)
        painter = QPainter(self._above)
        for area in areas:
            painter.setClipRect(QRectF(*area))
            for piece in pieces:
                paint_above(painter, frame, piece)
        painter.end()

    def _paint_ink(self, areas: list[Area], former: Ink | None) -> None:
        """Paint the curves into the empty upper picture, or if they are many lines as they are in a former one."""
        assert self._still is not None
        plane = self._still.plane
        lines = self._paint_curves(areas, most=MOST_LINES if former else None)
        self._rough = former is not None and lines is None
        if former is not None and lines is None:
            self._above, areas = scaled(former.picture, former.plane, plane)
            self._paint_curves(areas, tolerance=ROUGH)
        self._ink = Ink(plane, QPixmap(self._above)) if lines is None or lines > MOST_LINES else None

    def _paint_curves(
        self, areas: list[Area], *, most: int | None = None, tolerance: float | None = None
    ) -> int | None:
        """Paint, in some areas, what stands still of the curves, as `CurvesPainter.paint` does."""
        still = self._still
        assert still is not None
        painter = QPainter(self._above)
        counts = []
        for area in areas:
            painter.setClipRect(QRectF(*area))
            count = self._curves.paint(
                painter,
                still.drawing,
                still.current,
                still.plane,
                still.colours,
                by_mode=still.shown.modes,
                without={i: part.segments for i, part in self._alive.items()},
                area=area,
                most=most,
                tolerance=tolerance,
            )
            if count is not None:
                counts.append(count)
        painter.end()
        return sum(counts) if len(counts) == len(areas) else None

    def _former_view(self, still: Still) -> Viewport | None:
        """The part of the plane that the kept pictures show, if they differ in nothing else from those wanted."""
        former = self._still
        if former is None or former._replace(plane=still.plane) != still:
            return None
        size = still.plane.width, still.plane.height
        return former.plane if (former.plane.width, former.plane.height) == size else None

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
