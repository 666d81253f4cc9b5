"""Enclosures that hold along a whole segment, for any λ: its box, and how fast its direction turns."""

import numpy as np

from theditor.spline.basis import CONVEX_HULL_RANGE, JOINT_SLOPE_ZERO, Floats, hyperbolic, trigonometric
from theditor.spline.joints import Segments

_ROUNDING = 1e-15  # of a computed point, relative to the sum of its terms

_END = np.ones(1)


def boxes(segments: Segments, degree: int) -> tuple[Floats, Floats]:
    """Return the lowest and highest corners, (d, k) each, of boxes that contain the segments."""
    low = np.minimum(segments.start, segments.end)
    high = np.maximum(segments.start, segments.end)
    size = np.maximum(np.abs(low), np.abs(high))
    for bend, lam, sign in (
        (segments.bend_start, segments.lambda_start, -1 if degree == 2 else 1),
        (segments.bend_end, segments.lambda_end, 1),
    ):
        least, greatest = _range(lam, degree)
        one, other = sign * least * bend, sign * greatest * bend
        low += np.minimum(one, other)
        high += np.maximum(one, other)
        size += np.abs(bend) * (1 + np.abs(lam))
    size *= _ROUNDING
    low -= size
    high += size
    return low, high


def turning(segments: Segments, degree: int) -> Floats:
    """Return a bound of |C''|, (k,), along each segment: 0 where it is straight and run through evenly."""
    bound = np.zeros(segments.start.shape[1])
    for bend, lam in ((segments.bend_start, segments.lambda_start), (segments.bend_end, segments.lambda_end)):
        bound += np.sqrt(np.einsum("dk,dk->k", bend, bend)) * steepest(lam, degree)
    return bound


def _range(lam: Floats, degree: int) -> tuple[Floats, Floats]:
    """Return bounds of r(t; λ), or of R(t; λ) for the cubic, over 0 ≤ t ≤ 1.

    Both fall as λ rises, since h ≤ s. Up to the upper end of the convex-hull range they are not negative;
    beyond it, each unit of λ lowers them by no more than the depth of h − s (H − S). The quadratic's is at
    most 1/2 from the λ of slope zero on; the cubic's, as long as r is not negative, is greatest at t = 1.
    """
    largest = CONVEX_HULL_RANGE[degree][1]
    if degree == 2:
        depth = np.full(1, 0.038079)  # of h − s, at t = 0.7023; rounded up
        greatest = 0.5 + depth * np.maximum(JOINT_SLOPE_ZERO - lam, 0)
    else:
        depth = trigonometric(_END, -1) - hyperbolic(_END, -1)
        greatest = trigonometric(_END, -1) - depth * np.minimum(lam, largest)
    return -depth * np.maximum(lam - largest, 0), greatest


def steepest(lam: Floats, degree: int) -> Floats:
    """Return a bound of |r''(t; λ)|, or of |R''(t; λ)| for the cubic, over 0 ≤ t ≤ 1.

    Affine in λ, it is at most |1−λ| max|s''| + |λ| max|h''|, and at most max|s''| + |λ| max|h'' − s''|.
    """
    if degree == 2:  # s'' falls to 0 at t = 1, where h'' and h'' − s'' are greatest
        free, pulled = trigonometric(0 * _END, 2), hyperbolic(_END, 2)
        apart = pulled
    else:  # all three are greatest at t = 1
        free, pulled = trigonometric(_END, 1), hyperbolic(_END, 1)
        apart = pulled - free
    size = np.abs(lam)
    return np.minimum(np.abs(1 - lam) * free + size * pulled, free + size * apart)
