"""Writing CSV: points of curves to the last digit, with tangents and curvatures on request."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from typing import Final

import numpy as np
from numpy.typing import NDArray

from theditor.drawing import Drawing
from theditor.exchange.options import DEFAULTS, Options, Progress, Written, watched
from theditor.exchange.scene import MEASURED, box, remarks, visible
from theditor.spline import Curve, arc_length, curvature, intervals_for, parameter_at

Floats = NDArray[np.float64]

_MOST: Final = 2**16  # steps of a segment
_PROBES: Final = 7  # places on a chord where its distance from the curve is measured


def write(drawing: Drawing, options: Options = DEFAULTS, progress: Progress | None = None) -> Written:
    """Write points of the visible curves as a table with a header line, x and y first.

    Columns are ``curve`` (its name, if there are several), ``x``, ``y``, ``z`` (if any curve is in space; 0 for
    those that are not), ``u`` (the parameter), ``length`` (from the curve's start, if sampled by it), on request
    ``tangent_x`` … and ``curvature``, both empty where the curve stands still. At joints the segment that
    begins there counts. By tolerance, the deviation is that of the chords; the points themselves are exact.
    """
    curves = visible(drawing)
    *_, size = box([item.curve for item in curves], progress)
    axes = "xyz" if any(item.curve.dimension == 3 for item in curves) else "xy"
    header = [*(["curve"] if len(curves) > 1 else []), *axes, "u"]
    header += ["length"] if options.sampling == "length" else []
    header += [f"tangent_{axis}" for axis in axes] if options.tangent else []
    header += ["curvature"] if options.curvature else []
    stream = io.StringIO(newline="")
    table = csv.writer(stream, lineterminator="\n")
    table.writerow(header)
    deviation = 0.0
    for item in watched(curves, progress, MEASURED):
        u, length, off = _places(item.curve, options, options.tolerance * size)
        deviation = max(deviation, off)
        columns = [column.tolist() for column in _columns(item.curve, u, length, options, len(axes))]
        name = [[item.name] * len(u)] if len(curves) > 1 else []
        table.writerows(zip(*name, *map(_filled, columns), strict=True))
    notes = tuple(remarks(drawing, plane=False))
    return Written(stream.getvalue().encode(), deviation, notes)


def _places(curve: Curve, options: Options, tolerance: float) -> tuple[Floats, Floats | None, float]:
    """Return the parameters to take points at, the lengths to them if by length, and the chords' deviation."""
    count = curve.segment_count
    if options.sampling == "parameter":
        return np.arange(count * options.samples + 1) / options.samples, None, 0.0
    if options.sampling == "length":
        lengths = np.linspace(0.0, arc_length(curve), options.samples + 1)
        return parameter_at(curve, lengths), lengths, 0.0
    steps = intervals_for(curve, tolerance, most=_MOST)
    segments = np.repeat(np.arange(count), steps)
    within = np.arange(len(segments)) - np.repeat(np.cumsum(steps) - steps, steps)
    u = np.append(segments + within / np.repeat(steps, steps), float(count))
    return u, None, _chords(curve, u)


def _chords(curve: Curve, u: Floats) -> float:
    """Return how far the curve is from its chords between parameters."""
    t = np.arange(1, _PROBES + 1) / (_PROBES + 1)
    points = curve(u)
    start, chord = points[:-1, None], np.diff(points, axis=0)[:, None]
    away = curve(u[:-1, None] + np.diff(u)[:, None] * t) - start
    square = np.maximum((chord**2).sum(axis=-1), 1e-300)
    along = np.clip((away * chord).sum(axis=-1) / square, 0, 1)
    return float(np.linalg.norm(away - along[..., None] * chord, axis=-1).max())


def _columns(
    curve: Curve, u: Floats, length: Floats | None, options: Options, dimension: int
) -> Iterator[Floats]:
    missing = ((0, 0), (0, dimension - curve.dimension))
    yield from np.pad(curve(u), missing).T
    yield u
    if length is not None:
        yield length
    if options.tangent or options.curvature:
        bend = curvature(curve, u)
    if options.tangent:
        velocity = curve(u, 1)
        speed = np.linalg.norm(velocity, axis=1)
        speed[np.isnan(bend)] = np.nan
        yield from np.pad(velocity / speed[:, None], missing).T
    if options.curvature:
        yield bend


def _filled(column: list[float]) -> list[float | str]:
    """Return a column with nothing where there is no number."""
    return ["" if value != value else value for value in column]
