"""Segments of curves in pixels: straight pieces that stay with them to a fraction of a pixel."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.lines import clipped
from theditor.canvas.viewport import Viewport
from theditor.spline import Curve, enclosures, joints
from theditor.spline.distinct import distinct
from theditor.spline.magnified import Pieces, pieces_in_view

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]

TOLERANCE = 0.1
"""Largest distance in pixels between a segment and the line drawn for it."""

NO_PIECES = Pieces(np.empty((0, 4)), np.empty(0, dtype=np.intp), np.empty((0, 2)))


class Stroke(NamedTuple):
    """Visible straight pieces of the segments of one mode, in ascending order of segments."""

    code: int
    """Mode, as in `Curve.mode_codes`."""
    lines: Floats
    """(n, 4), in pixels."""
    segments: Ints
    """(n,): the segment each line belongs to."""
    parameters: Floats
    """(n, 2): t at the start and the end of each line."""


def strokes(
    curve: Curve, viewport: Viewport, segments: Ints | None = None, margin: float = 8.0
) -> list[Stroke]:
    """The visible lines of some segments (default all), one stroke per mode that occurs.

    They are as good as visible up to `margin` pixels beyond the edge: a wide line shows from there.
    """
    segments = np.arange(curve.segment_count) if segments is None else segments
    ends, run, parameters = _pieces(joints.take_segments(curve, segments), curve.degree, viewport, margin)
    lines, kept = clipped(viewport.lines_to_pixels(ends), viewport.width, viewport.height, margin)
    owners, parameters = segments[run[kept]], parameters[kept]
    codes = curve.codes_of(owners)
    result = []
    for code in distinct(codes).tolist():
        chosen = codes == code
        result.append(Stroke(code, lines[chosen], owners[chosen], parameters[chosen]))
    return result


def traced(parts: Sequence[tuple[Curve, Ints]], viewport: Viewport, margin: float = 8.0) -> list[Floats]:
    """The visible lines (n, 4) of some segments of each of several curves: as in `strokes`, all in one go."""
    result = [np.empty((0, 4))] * len(parts)
    for degree in (2, 3):
        own = [k for k, (curve, _) in enumerate(parts) if curve.degree == degree]
        if not own:
            continue
        forms = [joints.take_segments(*parts[k]) for k in own]
        form = joints.Segments(*(np.concatenate(rows, axis=-1) for rows in zip(*forms, strict=True)))
        owners = np.repeat(np.arange(len(own)), [len(parts[k][1]) for k in own])
        ends, run, _ = _pieces(form, degree, viewport, margin)
        lines, kept = clipped(viewport.lines_to_pixels(ends), viewport.width, viewport.height, margin)
        cuts = np.searchsorted(owners[run[kept]], np.arange(1, len(own)))
        for k, of in zip(own, np.split(lines, cuts), strict=True):
            result[k] = of
    return result


def _pieces(form: joints.Segments, degree: int, viewport: Viewport, margin: float) -> Pieces:
    """Straight pieces of those segments that may be visible, in their order."""
    low, high = viewport.window(margin)
    lowest, highest = enclosures.boxes(form, degree)
    seen = np.flatnonzero(((highest >= low[:, None]) & (lowest <= high[:, None])).all(axis=0))
    form, tolerance = form.take(seen), TOLERANCE / viewport.scale
    found = pieces_in_view(form, seen, degree, enclosures.turning(form, degree), tolerance, low, high)
    lines, of, t = (np.concatenate(rows) for rows in zip(NO_PIECES, *found, strict=True))
    order = np.argsort(of, kind="stable")
    return Pieces(lines[order], of[order], t[order])
