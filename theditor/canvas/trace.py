"""The picture of one curve in pixels, kept up to date by recomputing only what changed.

A trace samples the visible segments once, to a fraction of a pixel: the *base*. As long as the view stays, a
changed curve is compared with the base's curve and only the segments that differ are sampled again: the *patch*,
drawn instead of them. A drag thus costs what moves, however long the curve.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.lines import clipped
from theditor.canvas.viewport import Viewport
from theditor.spline import Curve
from theditor.spline.sampling import Samples, changed_segments, sample_adaptively

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


class Trace:
    """The visible lines of one plane curve."""

    def __init__(self) -> None:
        self._viewport: Viewport | None = None
        self._base_curve: Curve | None = None
        self._curve: Curve | None = None
        self._base: list[Stroke] = []
        self._patch: list[Stroke] = []
        self._changed: Ints = np.empty(0, dtype=np.intp)

    def update(self, curve: Curve, viewport: Viewport) -> None:
        """Make the trace that of `curve` in `viewport`; cheap where little or nothing changed."""
        if curve is self._curve and viewport == self._viewport:
            return
        changed = None
        if viewport == self._viewport and self._base_curve is not None:
            changed = changed_segments(self._base_curve, curve)
        if changed is None or 2 * len(changed) > curve.segment_count:
            self._base, self._base_curve = strokes(curve, viewport), curve
            self._patch, self._changed = [], np.empty(0, dtype=np.intp)
        else:
            self._patch = strokes(curve, viewport, changed) if len(changed) else []
            self._changed = changed
        self._curve, self._viewport = curve, viewport

    def strokes(self) -> Iterator[Stroke]:
        """What to draw now."""
        for stroke in self._base:
            yield from without(stroke, self._changed)
        yield from self._patch


def strokes(curve: Curve, viewport: Viewport, segments: Ints | None = None) -> list[Stroke]:
    """The visible lines of some segments (default all), one stroke per mode that occurs."""
    low, high = viewport.window(margin=8.0)
    samples = sample_adaptively(curve, TOLERANCE / viewport.scale, low, high, segments)
    lines, owners, parameters = _lines(samples, viewport)
    codes = curve.mode_codes[owners]
    result = []
    for code in np.unique(codes).tolist():
        chosen = codes == code
        result.append(Stroke(code, lines[chosen], owners[chosen], parameters[chosen]))
    return result


def _lines(samples: Samples, viewport: Viewport) -> tuple[Floats, Ints, Floats]:
    pixels = viewport.to_pixels(samples.points)
    starts_line = np.ones(len(pixels), dtype=bool)
    starts_line[samples.starts[1:] - 1] = False
    first = np.flatnonzero(starts_line)
    ends = np.hstack([pixels[first], pixels[first + 1]])
    run = np.repeat(np.arange(len(samples.segments)), samples.intervals)
    step = 1.0 / samples.intervals[run]
    t = (first - samples.starts[run]) * step
    lines, kept = clipped(ends, viewport.width, viewport.height)
    return lines, samples.segments[run[kept]], np.stack([t[kept], t[kept] + step[kept]], axis=1)


def without(stroke: Stroke, segments: Ints) -> Iterator[Stroke]:
    """The stroke less some segments, as runs of consecutive lines (views, not copies)."""
    if not len(segments):
        yield stroke
        return
    begins = np.concatenate([[0], np.searchsorted(stroke.segments, segments, side="right")])
    ends = np.append(np.searchsorted(stroke.segments, segments, side="left"), len(stroke.segments))
    for begin, end in zip(begins.tolist(), ends.tolist(), strict=True):
        if begin < end:
            run = slice(begin, end)
            yield Stroke(stroke.code, stroke.lines[run], stroke.segments[run], stroke.parameters[run])
