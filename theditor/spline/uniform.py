"""The ordinary uniform B-spline on the same control points, to compare a curve with."""

import numpy as np
from numpy.typing import NDArray

from theditor.spline import joints
from theditor.spline.basis import Floats
from theditor.spline.curve import Curve


def uniform_b_spline_samples(curve: Curve, per_segment: int = 16) -> Floats:
    """Return points of the uniform polynomial B-spline of the same degree on the same control points.

    It is closed, free or clamped as the curve is, a clamped end by the same reflected control point, so the
    two correspond segment by segment. It does not depend on λ.

    Parameters
    ----------
    curve : Curve
    per_segment : int
        Equal steps of t in each segment, at least 1.

    Returns
    -------
    ndarray, shape (N, d)
        N = segment_count·per_segment + 1 points, as `Curve.sample` has them.

    Raises
    ------
    ValueError
        If `per_segment` is not a positive integer.
    """
    inner = uniform_segments(curve, np.arange(curve.segment_count), per_segment)
    joined = inner[:, :-1].reshape(-1, curve.dimension)
    return np.concatenate((joined, joined[:1] if curve.closed else inner[-1:, -1]))


def uniform_segments(curve: Curve, segments: NDArray[np.intp], per_segment: int = 16) -> Floats:
    """Return points of some segments of that B-spline, both ends of each included, (k, per_segment + 1, d).

    Raises
    ------
    ValueError
        If `per_segment` is not a positive integer.
    """
    if per_segment < 1:
        raise ValueError(f"per_segment must be a positive integer, not {per_segment!r}")
    parts, degree = joints.take_segments(curve, segments), curve.degree
    t = np.arange(per_segment + 1) / per_segment
    # The joint form with t²/2 in place of r(t; λ), and t³/6 in place of R(t; λ).
    if degree == 2:
        weights = np.stack((np.ones_like(t), 0 * t, -((1 - t) ** 2) / 2, t**2 / 2))
    else:
        weights = np.stack((1 - t, t, (1 - t) ** 3 / 6, t**3 / 6))
    features = np.stack((parts.start, parts.end, parts.bend_start, parts.bend_end), axis=-1)
    points: Floats = np.matmul(features, weights)
    return points.transpose(1, 2, 0)
