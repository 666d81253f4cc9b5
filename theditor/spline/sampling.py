"""Many samples at once: whole curves, some segments of them, and what a window shows.

One strategy serves all: since the basis is affine in λ, a segment's points are a fixed combination of five
(quadratic) or six (cubic) rows of features: its straight part, its two bend vectors, and these times λ. The
features of a block of segments, kept coordinate by coordinate and small enough to stay in the cache, times
the matrix of the generators at the wanted t give all the block's points in one matrix product, written
straight into place. Where a curve keeps its features, writing the result is then the limit.
"""

from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline import enclosures, joints
from theditor.spline.basis import Floats, hyperbolic, trigonometric
from theditor.spline.checks import clean_indices

if TYPE_CHECKING:
    from theditor.spline.curve import Curve

_BLOCK = 8192
MOST_INTERVALS = 512
"""Into more steps of t no segment is cut unless asked for."""


class Samples(NamedTuple):
    """Points along some segments: those of the j-th one are ``points[starts[j] : starts[j + 1]]``."""

    segments: NDArray[np.intp]  # (k,) which segments of the curve, ascending unless asked for otherwise
    intervals: NDArray[np.intp]  # (k,) equal steps of t in each
    starts: NDArray[np.intp]  # (k + 1,)
    points: Floats  # (N, d), each segment with both its ends


def sample(curve: "Curve", per_segment: int, out: Floats | None = None) -> Floats:
    """Return points at equal steps of t along the whole curve; see `Curve.sample`."""
    _check_positive(per_segment, "per_segment")
    count = curve.segment_count
    shape = curve.dimension, count * int(per_segment) + 1
    matrix = generators(per_segment, curve.degree)
    keep = out is not None  # who has a place ready for them will ask again
    if out is None:
        out = np.empty(shape)
    elif not isinstance(out, np.ndarray) or (
        out.shape != shape or out.dtype != np.float64 or not (out.flags.c_contiguous and out.flags.writeable)
    ):
        raise ValueError(f"out must be a writeable C-contiguous float64 array of shape {shape}")
    inner = out[:, :-1].reshape(shape[0], count, per_segment)
    if keep:
        for first in range(0, count, _BLOCK):
            block = slice(first, first + _BLOCK)
            _multiply(curve.features[:, block], matrix[:, :-1], inner[:, block])
    else:
        _fill(curve.joint_form, matrix[:, :-1], inner)
    if curve.closed:
        out[:, -1] = out[:, 0]
    elif keep:
        out[:, -1] = curve.features[:, -1] @ matrix[:, -1]
    else:
        _fill(curve.joint_form.take(np.array([count - 1])), matrix[:, -1:], out[:, -1:].reshape(-1, 1, 1))
    return out.T


def features(segments: joints.Segments, degree: int) -> Floats:
    """Return the features of the segments, (d, k, features), as the matrix products of `sample` take them."""
    dimension, count = segments.start.shape
    rows = np.empty((dimension, count, degree + 3))
    for first in range(0, count, _BLOCK):
        block = slice(first, first + _BLOCK)
        _collect(segments, block, rows[:, block].transpose(0, 2, 1))
    return rows


def evaluate_segments(curve: "Curve", segments: ArrayLike, intervals: int) -> Floats:
    """Return the points at t = j/intervals, both ends included, of some segments.

    The cost depends on the number of these segments, not on the size of the curve.

    Parameters
    ----------
    curve : Curve
    segments : int or array_like of int, shape (k,)
    intervals : int
        Steps in each segment, at least 1.

    Returns
    -------
    ndarray, shape (k, intervals + 1, d)
        Stored coordinate by coordinate.

    Raises
    ------
    ValueError
        If there is no such segment, or `intervals` is not a positive integer.
    """
    _check_positive(intervals, "intervals")
    chosen = clean_indices(segments, curve.segment_count, "segment")
    out = np.empty((curve.dimension, len(chosen), int(intervals) + 1))
    _fill(joints.take_segments(curve, chosen), generators(intervals, curve.degree), out)
    return out.transpose(1, 2, 0)


def segment_bounds(curve: "Curve", segments: ArrayLike | None = None) -> tuple[Floats, Floats]:
    """Return boxes that contain the segments, whatever their λ.

    The box adds up the ranges of a segment's terms, so it holds outside the convex-hull range too, but it is
    seldom the smallest one.

    Parameters
    ----------
    curve : Curve
    segments : int or array_like of int, shape (k,), optional
        All segments by default.

    Returns
    -------
    low, high : ndarray, shape (k, d)

    Raises
    ------
    ValueError
        If there is no such segment.
    """
    if segments is None:
        low, high = curve.boxes
    else:
        chosen = clean_indices(segments, curve.segment_count, "segment")
        low, high = enclosures.boxes(joints.take_segments(curve, chosen), curve.degree)
    return low.T, high.T


def intervals_for(
    curve: "Curve", tolerance: float, segments: ArrayLike | None = None, most: int = MOST_INTERVALS
) -> NDArray[np.intp]:
    """Return into how many equal steps of t to cut segments so that chords stay close to them.

    A chord over a step h is nowhere further from the curve than h²/8·max|C''|; the bound used for |C''| adds
    up the greatest bends of both joints, so it errs by some factor of two on the safe side.

    Parameters
    ----------
    curve : Curve
    tolerance : float
        Largest distance allowed, positive, in the units of the control points.
    segments : int or array_like of int, shape (k,), optional
        All segments by default.
    most : int
        Never return more than this, even if the tolerance is missed for it.

    Returns
    -------
    ndarray of int, shape (k,)
        Powers of two; 1 where a segment is straight and run through evenly.

    Raises
    ------
    ValueError
        If there is no such segment, `tolerance` is not a positive number or `most` not a positive integer.
    """
    if segments is None:
        return intervals_within(curve.turning, tolerance, most)
    chosen = clean_indices(segments, curve.segment_count, "segment")
    return intervals_within(
        enclosures.turning(joints.take_segments(curve, chosen), curve.degree), tolerance, most
    )


def sample_adaptively(
    curve: "Curve",
    tolerance: float,
    low: ArrayLike | None = None,
    high: ArrayLike | None = None,
    segments: ArrayLike | None = None,
) -> Samples:
    """Return what is needed to draw the segments that a window may show, as chords within a tolerance.

    Parameters
    ----------
    curve : Curve
    tolerance : float
        Largest distance of a chord from the curve, as for `intervals_for`.
    low, high : array_like, shape (d,), optional
        Corners of the window; no limit by default. Segments whose box lies outside are left out.
    segments : int or array_like of int, shape (k,), optional
        The segments to consider, all by default.

    Raises
    ------
    ValueError
        As `intervals_for` does, or if a corner has not one number for each coordinate.
    """
    window = low is not None or high is not None
    if segments is None:
        chosen, parts, turning = np.arange(curve.segment_count), curve.joint_form, curve.turning
        boxes = curve.boxes if window else None
    else:
        chosen = clean_indices(segments, curve.segment_count, "segment")
        parts = joints.take_segments(curve, chosen)
        turning = enclosures.turning(parts, curve.degree)
        boxes = enclosures.boxes(parts, curve.degree) if window else None
    shown = np.arange(len(chosen))
    if boxes is not None:
        seen = (boxes[1] >= _corner(low, -np.inf, curve)) & (boxes[0] <= _corner(high, np.inf, curve))
        shown = np.flatnonzero(np.logical_and.reduce(seen, axis=0))
    seen_parts = parts if len(shown) == len(chosen) else parts.take(shown)
    samples = sample_parts(seen_parts, curve.degree, intervals_within(turning[shown], tolerance))
    return samples._replace(segments=chosen[shown])


def sample_parts(parts: joints.Segments, degree: int, intervals: NDArray[np.intp]) -> Samples:
    """Return points along k segments given in joint form, numbered from 0, at so many steps of t in each, (k,)."""
    starts = np.concatenate(([0], np.cumsum(intervals + 1)))
    points = np.empty((len(parts.start), starts[-1]))
    for count in np.flatnonzero(np.bincount(intervals)).tolist():
        matrix = generators(count, degree)
        group = np.flatnonzero(intervals == count)
        if len(group) == len(intervals):
            _fill(parts, matrix, points.reshape(len(points), -1, count + 1))
            break
        part = np.empty((len(points), len(group), count + 1))
        _fill(parts.take(group), matrix, part)
        places = starts[group, None] + np.arange(count + 1)
        for axis, values in enumerate(part):
            points[axis][places] = values
    return Samples(np.arange(len(intervals)), intervals, starts, points.T)


def middles(parts: joints.Segments, degree: int, intervals: int) -> NDArray[np.float32]:
    """Return points in the middle of equal steps of t along k segments in joint form, (d, k · intervals)."""
    dimension, count = parts.start.shape
    points = np.empty((dimension, count, intervals), dtype=np.float32)
    _fill(parts, generators(intervals, degree, middle=True), points)
    return points.reshape(dimension, -1)


@lru_cache(maxsize=64)
def generators(intervals: int, degree: int, *, middle: bool = False) -> Floats:
    """Return the weights of a segment's features at t = j/intervals, (features, intervals + 1), or in between."""
    t = (np.arange(intervals) + 0.5 if middle else np.arange(intervals + 1)) / intervals
    order = 2 - degree
    straight = [np.ones_like(t)] if degree == 2 else [1 - t, t]
    bends = []
    for s, sign in ((1 - t, -1 if degree == 2 else 1), (t, 1)):
        free = trigonometric(s, order)
        bends += [sign * free, sign * (hyperbolic(s, order) - free)]
    matrix = np.stack(straight + bends)
    matrix.flags.writeable = False
    return matrix


def _fill(segments: joints.Segments, matrix: Floats, out: NDArray[Any]) -> None:
    """Write the points of the segments, at the parameters of the matrix, into `out`, (d, k, samples)."""
    dimension, count = segments.start.shape
    scratch = np.empty((dimension, len(matrix), min(count, _BLOCK)), dtype=out.dtype)
    matrix = matrix.astype(out.dtype, copy=False)
    for first in range(0, count, _BLOCK):
        block = slice(first, first + _BLOCK)
        rows = scratch[:, :, : count - first]
        _collect(segments, block, rows)
        _multiply(rows.transpose(0, 2, 1), matrix, out[:, block])


def _collect(segments: joints.Segments, block: slice, rows: Floats) -> None:
    """Write the features of a block of segments into `rows`, (d, features, k)."""
    rows[:, 0] = segments.start[:, block]
    if rows.shape[1] == 6:
        rows[:, 1] = segments.end[:, block]
    rows[:, -4] = segments.bend_start[:, block]
    np.multiply(segments.bend_start[:, block], segments.lambda_start[block], out=rows[:, -3])
    rows[:, -2] = segments.bend_end[:, block]
    np.multiply(segments.bend_end[:, block], segments.lambda_end[block], out=rows[:, -1])


def _multiply(rows: Floats, matrix: Floats, out: Floats) -> None:
    """Write the points of a block of segments with these features, (d, k, features), into `out`."""
    for axis, values in enumerate(rows):
        np.matmul(values, matrix, out=out[axis])


def intervals_within(bound: Floats, tolerance: float, most: int = MOST_INTERVALS) -> NDArray[np.intp]:
    """Return into how many steps, (k,), to cut segments with these bounds of |C''|; see `intervals_for`."""
    if not 0 < tolerance < np.inf:
        raise ValueError(f"tolerance must be a positive number, not {tolerance!r}")
    _check_positive(most, "most")
    limit = int(most).bit_length() - 1
    # A step of 2⁻ᵉ will do if 4ᵉ ≥ bound / (8 tolerance); frexp gives a power of two above the ratio.
    ratio = np.minimum(bound, 8 * tolerance * 4.0**limit) / (8 * tolerance)
    doublings = (np.frexp(ratio)[1] + 1) // 2
    steps: NDArray[np.intp] = np.left_shift(np.intp(1), np.clip(doublings, 0, limit))
    return steps


def _corner(corner: ArrayLike | None, otherwise: float, curve: "Curve") -> Floats:
    values = np.full(curve.dimension, otherwise) if corner is None else np.asarray(corner, dtype=np.float64)
    if values.shape != (curve.dimension,):
        raise ValueError(f"a window's corner needs {curve.dimension} numbers, not shape {values.shape}")
    return values[:, None]


def _check_positive(number: int, what: str) -> None:
    if isinstance(number, bool) or not isinstance(number, int | np.integer) or number < 1:
        raise ValueError(f"{what} must be a positive integer, not {number!r}")
