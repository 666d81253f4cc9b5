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
from theditor.spline.sampling import intervals_within, sample_adaptively, sample_parts

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]

TOLERANCE = 0.1
"""Largest distance in pixels between a segment and the line drawn for it."""


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
    low, high = viewport.window(margin)
    samples = sample_adaptively(curve, TOLERANCE / viewport.scale, low, high, segments)
    ends, run, parameters = samples.pieces()
    lines, kept = clipped(viewport.lines_to_pixels(ends), viewport.width, viewport.height, margin)
    owners, parameters = samples.segments[run[kept]], parameters[kept]
    codes = curve.codes_of(samples.segments)[run[kept]]
    result = []
    for code in distinct(codes).tolist():
        chosen = codes == code
        result.append(Stroke(code, lines[chosen], owners[chosen], parameters[chosen]))
    return result


def traced(parts: Sequence[tuple[Curve, Ints]], viewport: Viewport, margin: float = 8.0) -> list[Floats]:
    """The visible lines (n, 4) of some segments of each of several curves: as in `strokes`, all in one go."""
    low, high = viewport.window(margin)
    result = [np.empty((0, 4))] * len(parts)
    for degree in (2, 3):
        own = [k for k, (curve, _) in enumerate(parts) if curve.degree == degree]
        if not own:
            continue
        forms = [joints.take_segments(*parts[k]) for k in own]
        form = joints.Segments(*(np.concatenate(rows, axis=-1) for rows in zip(*forms, strict=True)))
        owners = np.repeat(np.arange(len(own)), [len(parts[k][1]) for k in own])
        lowest, highest = enclosures.boxes(form, degree)
        seen = np.flatnonzero(((highest >= low[:, None]) & (lowest <= high[:, None])).all(axis=0))
        form = form.take(seen)
        steps = intervals_within(enclosures.turning(form, degree), TOLERANCE / viewport.scale)
        ends, run, _ = sample_parts(form, degree, steps).pieces()
        lines, kept = clipped(viewport.lines_to_pixels(ends), viewport.width, viewport.height, margin)
        cuts = np.searchsorted(owners[seen[run[kept]]], np.arange(1, len(own)))
        for k, of in zip(own, np.split(lines, cuts), strict=True):
            result[k] = of
    return result
