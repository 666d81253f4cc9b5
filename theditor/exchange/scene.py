"""What a picture of a drawing shows, in the drawing's units, whatever draws it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from theditor.drawing import Drawing, Item
from theditor.exchange.options import Options, Progress, watched
from theditor.spline import Curve, Outline, bounds, curvature, outline, projected
from theditor.spline.extent import extent
from theditor.spline.numerals import counted

Floats = NDArray[np.float64]

INCH: Final = 25.4
"""In mm."""
MM_PER_PIXEL: Final = INCH / 96
"""Widths of curves are in pixels of 1/96 inch."""
ORDINARY: Final = (120.0, 1200.0)
"""A picture at a size of its own choice that is shorter or longer than this, in mm, has lines in proportion."""
BLACK: Final = "#000000"
POLYGON: Final = "#8793A2"
COMB: Final = "#7A5AC8"
THIN: Final = 0.2
"""Width of the polygon's lines in mm."""
POINT: Final = 0.75
"""Radius of a point in mm."""
LABEL: Final = 3.6
"""Height of letters in mm."""
TEETH: Final = 24
"""Teeth of the comb on each segment, fewer on a very long curve."""
MOST_TEETH: Final = 48_000
MEASURED, COLLECTED = 0.4, 0.7
"""Shares of the work done when the curves are measured, and when all that is shown of them is collected."""
_DASHES: Final[tuple[tuple[float, ...], ...]] = ((), (2.4, 1.2), (2.8, 0.9, 0.5, 0.9), (0.5, 0.8))
"""In print style, in mm: trigonometric, hyperbolic, interpolating, blend."""
PRINTED: Final = frozenset({"polygon", "points", "labels"})
"""Shown in print style whatever else is asked for."""
_NOTHING: Final = 1e-100  # an extent of which squares and tolerances would be none
_TYPICAL: Final = 0.03  # length of a typical tooth, as a share of the drawing's size
_LONGEST: Final = 0.3  # of the longest one


@dataclass(frozen=True, slots=True)
class Stroke:
    """A part of a curve to be drawn in one go."""

    outline: Outline
    dashes: tuple[float, ...]  # lengths of dashes and gaps in mm, none for a whole line


@dataclass(frozen=True, slots=True, eq=False)
class Figure:
    """A curve with what is shown of it; what is not shown is empty."""

    item: Item
    color: str
    width: float  # mm
    strokes: tuple[Stroke, ...]
    polygon: Floats  # (n, 2)
    points: Floats  # (m, 2)
    labels: dict[int, tuple[float, float]]  # the middle of the label of each point that has one
    teeth: Floats  # (k, 2, 2): feet and tips of the comb
    crests: tuple[Floats, ...]  # (n, 2) each


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """The visible curves of a drawing at a scale, with the room that they take."""

    figures: tuple[Figure, ...]
    low: Floats  # (2,) of the picture, margins included
    high: Floats  # (2,)
    unit: float
    """Millimetres for each unit of the drawing."""
    line: float
    """By how much lines, points and letters are to be scaled."""
    deviation: float
    notes: tuple[str, ...]

    @property
    def size(self) -> tuple[float, float]:
        """Width and height in millimetres."""
        width, height = ((self.high - self.low) * self.unit).tolist()
        return width, height

    def length(self, millimetres: float) -> float:
        """Return a width or a height of the picture's lines and letters in units of the drawing."""
        return millimetres * self.line / self.unit


def scene(
    drawing: Drawing, options: Options, *, size: float | None, arcs: bool, progress: Progress | None
) -> Scene:
    """Collect what a picture shows.

    Parameters
    ----------
    drawing : Drawing
    options : Options
    size : float or None
        Longer side of the picture in mm, unless the options have a scale; None for 1 mm for each unit.
    arcs : bool
        Whether what draws it knows elliptical arcs.
    progress : callable or None
        Told the share of the work that is done, up to `COLLECTED`.
    """
    shown = [(item, projected(item.curve)) for item in visible(drawing)]
    show = options.show | PRINTED if options.print_style else options.show
    low, high, whole = box([curve for _, curve in shown], progress)
    around = [low, high]
    combs = []
    for _, curve in shown:
        teeth, crests = _comb(curve, whole) if "comb" in show else (np.empty((0, 2, 2)), ())
        combs.append((teeth, crests))
        around += [teeth.reshape(-1, 2)]
        if show & {"polygon", "points", "labels"}:
            around.append(curve.control_points)
    low, high = extent(np.vstack(around))
    longest = _longer(low, high)
    natural = size is None and options.scale is None
    line = longest / float(np.clip(longest, *ORDINARY)) if natural else 1.0
    widest = max((item.width for item, _ in shown), default=1.0) * MM_PER_PIXEL
    margin = (widest + (5.5 if "labels" in show else 1.5)) * line
    unit = options.scale or 1.0
    if options.scale is None and size is not None:
        margin = min(margin, size / 4)
        unit = (size - 2 * margin) / longest
    figures = tuple(
        _figure(item, curve, options, show, options.tolerance * whole, arcs, line / unit, *comb)
        for (item, curve), comb in zip(watched(shown, progress, MEASURED, COLLECTED), combs, strict=True)
    )
    deviation = max((stroke.outline.deviation for each in figures for stroke in each.strokes), default=0.0)
    notes = (f"1 unit is {unit:.6g} mm.", *remarks(drawing, plane=True))
    return Scene(figures, low - margin / unit, high + margin / unit, unit, line, deviation, notes)


def visible(drawing: Drawing) -> list[Item]:
    """Return the curves that are not hidden."""
    return [item for item in drawing if item.visible]


def box(curves: Sequence[Curve], progress: Progress | None = None) -> tuple[Floats, Floats, float]:
    """Return the corners of the box around curves, and its longer side.

    The longer side is what tolerances are relative to; 1 if there is no extent. A plane curve among those in
    space lies at z = 0. Of no curves it is the unit square. A progress is told up to `MEASURED`.
    """
    if not curves:
        return np.zeros(2), np.ones(2), 1.0
    dimension = max(curve.dimension for curve in curves)
    corners = [
        np.pad(bounds(curve, 1e-6), ((0, 0), (0, dimension - curve.dimension)))
        for curve in watched(curves, progress, 0.0, MEASURED)
    ]
    low, high = np.min(corners, axis=0)[0], np.max(corners, axis=0)[1]
    return low, high, _longer(low, high)


def _longer(low: Floats, high: Floats) -> float:
    """Return the longer side of a box; 1 if it has none to calculate with."""
    side = float((high - low).max())
    return side if side > _NOTHING else 1.0


def remarks(drawing: Drawing, *, plane: bool) -> Iterator[str]:
    """Yield what a format does not show of a drawing, a sentence each."""
    hidden = len(drawing) - len(visible(drawing))
    if hidden == len(drawing):
        yield "There is no curve to show in it."
    if hidden:
        yield f"{counted(hidden, 'hidden curve')} {'is' if hidden == 1 else 'are'} left out."
    if plane and any(item.curve.dimension == 3 for item in visible(drawing)):
        yield "Curves in space are drawn as seen from above."


def _figure(
    item: Item,
    curve: Curve,
    options: Options,
    show: frozenset[str],
    tolerance: float,
    arcs: bool,
    millimetre: float,
    teeth: Floats,
    crests: tuple[Floats, ...],
) -> Figure:
    """Return one curve's figure; a millimetre is given in units of the drawing."""
    pieces = outline(curve, tolerance, arcs=arcs)
    none = np.empty((0, 2))
    if options.print_style:
        modes = curve.mode_codes[pieces.segments]
        runs = pieces.runs(np.append(False, modes[1:] != modes[:-1]))
        strokes = tuple(Stroke(run, _DASHES[curve.mode_codes[run.segments[0]]]) for run in runs)
    else:
        strokes = (Stroke(pieces, ()),)
    return Figure(
        item,
        BLACK if options.print_style else item.color,
        item.width * MM_PER_PIXEL,
        strokes,
        curve.polygon if "polygon" in show else none,
        curve.control_points if "points" in show else none,
        _labels(curve, millimetre) if "labels" in show else {},
        teeth,
        crests,
    )


def _labels(curve: Curve, millimetre: float) -> dict[int, tuple[float, float]]:
    """Return a place for each point's label, away from the point's neighbours; of several at one place the first."""
    points = curve.control_points
    before, after = np.roll(points, 1, axis=0), np.roll(points, -1, axis=0)
    if not curve.closed:
        before[0], after[-1] = points[0], points[-1]
    away = _unit(points - before) + _unit(points - after)
    lengths = np.linalg.norm(away, axis=1)
    # In a straight row they go above, or to the left of where it climbs.
    along = _unit(after - before)
    row = lengths < 0.2
    away[row] = np.where(along[row, :1] < 0, -1.0, 1.0) * np.stack((-along[row, 1], along[row, 0]), axis=1)
    away[row & (np.linalg.norm(along, axis=1) == 0)] = (0.0, 1.0)
    places = points + 4.2 * millimetre * _unit(away)
    _, first = np.unique(np.round(places / (2.5 * millimetre)), axis=0, return_index=True)
    return {
        index: (x, y)
        for index, (x, y) in zip(sorted(first.tolist()), places[np.sort(first)].tolist(), strict=True)
    }


def _unit(vectors: Floats) -> Floats:
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    unit: Floats = vectors / np.where(lengths > 0, lengths, 1.0)
    return unit


def _comb(curve: Curve, size: float) -> tuple[Floats, tuple[Floats, ...]]:
    """Return teeth, (k, 2, 2), on the outer side of the bend, and the crests that join their tips."""
    teeth = max(1, min(TEETH, MOST_TEETH // curve.segment_count))
    u = np.arange(curve.segment_count)[:, None] + np.arange(teeth + 1) / teeth
    feet, along, bend = (
        np.concatenate((first, last), axis=1)
        for first, last in zip(_at(curve, u[:, :-1], "right"), _at(curve, u[:, -1:], "left"), strict=True)
    )
    bends = np.abs(bend[np.isfinite(bend) & (bend != 0)])
    if not len(bends):
        return np.empty((0, 2, 2)), ()
    reach = np.clip(bend * (_TYPICAL * size / np.median(bends)), -_LONGEST * size, _LONGEST * size)
    tips = feet + np.stack((along[..., 1], -along[..., 0]), axis=-1) * reach[..., None]
    sound = np.isfinite(tips).all(axis=-1)
    pairs = np.stack((feet[sound], tips[sound]), axis=1)
    return pairs, tuple(row[good] for row, good in zip(tips, sound, strict=True) if good.sum() > 1)


def _at(curve: Curve, u: Floats, side: Literal["left", "right"]) -> tuple[Floats, Floats, Floats]:
    """Return points, unit tangents and curvatures."""
    return curve(u, 0, side), _unit(curve(u, 1, side)), curvature(curve, u, side)
