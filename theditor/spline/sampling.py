"""Many samples at once."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from theditor.spline import joints
from theditor.spline.basis import Floats, hyperbolic, trigonometric

if TYPE_CHECKING:
    from theditor.spline.curve import Curve

_BLOCK = 4096


def take_segments(curve: "Curve", segments: NDArray[np.intp]) -> joints.Segments:
    """Return the given segments in joint form, whichever way is quicker."""
    if "_segments" in vars(curve) or 8 * len(segments) > curve.segment_count:
        return curve._segments.take(segments)
    return joints.some_segments(curve, segments)


def sample(curve: "Curve", per_segment: int, out: Floats | None) -> Floats:
    """Return points at equal steps of t; see `Curve.sample`."""
    if isinstance(per_segment, bool) or not isinstance(per_segment, int | np.integer) or per_segment < 1:
        raise ValueError(f"per_segment must be a positive integer, not {per_segment!r}")
    shape = curve.dimension, curve.segment_count * int(per_segment) + 1
    if out is None:
        out = np.empty(shape)
    elif (
        out.shape != shape or out.dtype != np.float64 or not out.flags.c_contiguous or not out.flags.writeable
    ):
        raise ValueError(f"out must be a writeable C-contiguous float64 array of shape {shape}")
    segments = curve._segments
    grid = out[:, :-1].reshape(shape[0], curve.segment_count, per_segment)
    _fill(segments, weights(np.arange(per_segment) / per_segment, curve.degree), grid)
    if curve.closed:
        out[:, -1] = out[:, 0]
    else:
        end = np.empty((shape[0], 1, 1))
        _fill(segments.take(slice(-1, None)), weights(np.ones(1), curve.degree), end)
        out[:, -1] = end[:, 0, 0]
    return out.T


def weights(t: Floats, degree: int) -> Floats:
    """Return the weights of a segment's features at `t`, (features, len(t))."""
    sign = -1 if degree == 2 else 1
    order = 2 - degree
    rows = []
    for s, factor in ((1 - t, sign), (t, 1)):
        free = trigonometric(s, order)
        rows += [factor * free, factor * (hyperbolic(s, order) - free)]
    straight = [np.ones_like(t)] if degree == 2 else [1 - t, t]
    return np.stack(straight + rows)


def _fill(segments: joints.Segments, matrix: Floats, out: Floats) -> None:
    """Write the points of the segments into `out`, (d, k, samples)."""
    dimension, count = segments.start.shape
    features = len(matrix)
    scratch = np.empty((dimension, features, min(count, _BLOCK)))
    for first in range(0, count, _BLOCK):
        block = slice(first, first + _BLOCK)
        size = min(_BLOCK, count - first)
        rows = scratch[:, :, :size]
        rows[:, 0] = segments.start[:, block]
        if features == 6:
            rows[:, 1] = segments.end[:, block]
        rows[:, -4] = segments.bend_start[:, block]
        np.multiply(rows[:, -4], segments.lambda_start[block], out=rows[:, -3])
        rows[:, -2] = segments.bend_end[:, block]
        np.multiply(rows[:, -2], segments.lambda_end[block], out=rows[:, -1])
        for axis in range(dimension):
            np.matmul(rows[axis].T, matrix, out=out[axis, block])
