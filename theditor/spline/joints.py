"""The joint form of a curve: what every evaluation starts from.

A segment is a straight part plus one bend vector W at each of its two joints, W_start and W_end:

    quadratic    P − r(1−t; λ_start) W_start + r(t; λ_end) W_end
    cubic        (1−t) P + t P' + R(1−t; λ_start) W_start + R(t; λ_end) W_end

A quadratic's W is the polygon's edge at the joint, a cubic's the second difference of the control points
there. A clamped end needs no extra control points in this form: its edge counts twice (quadratic), or its
second difference is zero (cubic). Arrays are coordinate-major, (d, k): each coordinate is contiguous.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.spline.basis import INTERPOLATING, Floats, blended

if TYPE_CHECKING:
    from theditor.spline.curve import Curve


_SMALL = 10_000  # numbers are copied sooner than two rows are put together


class Segments(NamedTuple):
    """Some segments of a curve in joint form; a quadratic has `start` = `end`."""

    start: Floats  # (d, k)
    end: Floats  # (d, k)
    bend_start: Floats  # (d, k)
    bend_end: Floats  # (d, k)
    lambda_start: Floats  # (k,)
    lambda_end: Floats  # (k,)

    def take(self, indices: NDArray[np.intp]) -> "Segments":
        """Return those of the segments, in the given order."""
        return Segments(*(_taken(part, indices) for part in self))


def _taken(part: Floats, indices: NDArray[np.intp]) -> Floats:
    """Some columns; where rows share a part's memory with others, NumPy would copy all of it to take from both."""
    if part.ndim == 1 or part.size < _SMALL:
        return part.take(indices, axis=-1)
    return np.stack([row.take(indices) for row in part])


def all_segments(curve: "Curve") -> Segments:
    """Return every segment of a curve; neighbours share memory."""
    points, lambdas = curve.control_points.T, curve.lambdas
    if curve.closed:
        points = np.concatenate((points[:, -1:], points, points[:, : curve.degree - 1]), axis=1)
        lambdas = np.append(lambdas, lambdas[0])
    else:
        points = np.ascontiguousarray(points)
        lambdas = lambdas[curve.first_segment :]
    clamped = curve.ends == "clamped" and not curve.closed
    straight, bends = points[:, 1:-1], points[:, 1:] - points[:, :-1]
    if curve.degree == 3:
        bends = bends[:, 1:] - bends[:, :-1]
    if clamped and curve.degree == 2:
        bends[:, 0] *= 2
        bends[:, -1] *= 2
    elif clamped:
        straight, inner = points, bends
        bends = np.zeros_like(points)
        bends[:, 1:-1] = inner
    count = curve.segment_count
    return Segments(
        straight[:, :count],
        straight[:, -count:],
        bends[:, :-1],
        bends[:, 1:],
        lambdas[:count],
        lambdas[1 : count + 1],
    )


def some_segments(curve: "Curve", segments: NDArray[np.intp]) -> Segments:
    """Return the given segments of a curve without touching the others."""
    count = len(curve.control_points)
    first = segments + curve.first_segment
    # Past a clamped end the indices wrap; the bend formed there is replaced below.
    points = curve.control_points[(first[:, None] + np.arange(-1, curve.degree)) % count]
    bends = np.diff(points, curve.degree - 1, axis=1)
    if curve.ends == "clamped" and not curve.closed:
        factor = 2.0 if curve.degree == 2 else 0.0
        bends[segments == 0, 0] *= factor
        bends[segments == curve.segment_count - 1, 1] *= factor
    return Segments(
        points[:, 1].T,
        points[:, curve.degree - 1].T,
        bends[:, 0].T,
        bends[:, 1].T,
        curve.lambdas[first % count],
        curve.lambdas[(first + 1) % count],
    )


def take_segments(curve: "Curve", segments: NDArray[np.intp]) -> Segments:
    """Return the given segments of a curve, whichever way is quicker."""
    if "joint_form" in vars(curve) or 8 * len(segments) > curve.segment_count:
        return curve.joint_form.take(segments)
    return some_segments(curve, segments)


def mode_codes(curve: "Curve", segments: NDArray[np.intp]) -> NDArray[np.int8]:
    """Return the modes of some segments as numbers: 0 trigonometric, 1 hyperbolic, 2 interpolating, 3 blend."""
    first, count = segments + curve.first_segment, len(curve.lambdas)
    start, end = curve.lambdas[first % count], curve.lambdas[(first + 1) % count]
    if _ends_are_silent(curve):
        begins, ends = segments == 0, segments == curve.segment_count - 1
        start, end = np.where(begins, end, start), np.where(ends, start, end)
    return _codes(start, end, INTERPOLATING[curve.degree])


def codes_of_all(curves: Sequence["Curve"], lambdas: Floats) -> NDArray[np.int8]:
    """Return the modes, as `mode_codes` has them, of all segments of several curves, one after the other.

    Parameters
    ----------
    curves : sequence of Curve
    lambdas : ndarray, shape (2, k)
        λ at the start and at the end of each segment.
    """
    counts = np.array([curve.segment_count for curve in curves], dtype=np.intp)
    silent = np.array([_ends_are_silent(curve) for curve in curves], dtype=np.bool_)
    beyond = np.cumsum(counts)
    first, last = (beyond - counts)[silent], beyond[silent] - 1
    start, end = lambdas.copy()
    start[first], end[last] = end[first], start[last]
    return _codes(start, end, np.repeat([INTERPOLATING[curve.degree] for curve in curves], counts))


def _ends_are_silent(curve: "Curve") -> bool:
    """Whether the λ of both ends has no say, as at the ends of a clamped cubic.

    A lone straight segment goes by the λ it keeps.
    """
    return curve.degree == 3 and curve.ends == "clamped" and not curve.closed and curve.segment_count > 1


def _codes(start: Floats, end: Floats, interpolating: Floats | float) -> NDArray[np.int8]:
    """Return the modes of segments with these λ at their ends, where λ* is that of their degrees."""
    codes = np.full(len(start), 3, dtype=np.int8)
    for code, lam in enumerate((0.0, 1.0, interpolating)):
        codes[(start == lam) & (end == lam)] = code
    return codes


def evaluate(segments: Segments, t: Floats, degree: int, nu: int) -> Floats:
    """Return derivative `nu` of each segment at its own parameter: `t` of shape (k,) gives (d, k)."""
    sign = 1.0 if (nu + degree) % 2 else -1.0
    bend = sign * blended(1 - t, segments.lambda_start, degree, nu) * segments.bend_start
    bend += blended(t, segments.lambda_end, degree, nu) * segments.bend_end
    if degree == 2:
        return segments.start + bend if nu == 0 else bend
    if nu == 0:
        return (1 - t) * segments.start + t * segments.end + bend
    return (segments.end - segments.start) + bend if nu == 1 else bend
