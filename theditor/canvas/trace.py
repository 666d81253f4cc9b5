"""Segments of one curve in pixels: straight pieces that stay with them to a fraction of a pixel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.lines import clipped
from theditor.canvas.viewport import Viewport
from theditor.spline import Curve
from theditor.spline.distinct import distinct
from theditor.spline.sampling import sample_adaptively

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]

TOLERANCE = 0.1
"""Largest distance in pixels between a segment and the line drawn for it."""


@dataclass(frozen=True)
class Stroke:
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
