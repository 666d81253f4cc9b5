"""How far plane segments stray from the straight lines between their ends, and how fast they are run through.

All of it is seen from the chord: along it and across it. There a segment's bends are small numbers, so that
the points that are looked at need no more than single precision.
"""

from functools import lru_cache
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.spline.basis import Floats
from theditor.spline.enclosures import steepest
from theditor.spline.joints import Segments
from theditor.spline.sampling import generators

STEPS: Final = 8
"""Into so many equal steps of t each segment is cut to be looked at."""


class Flatness(NamedTuple):
    """What is known of k segments; bounds are not far above the truth."""

    start: Floats  # (2, k)
    end: Floats  # (2, k)
    stray: Floats  # (k,) a bound of the distance from the straight line between the ends
    turning: Floats  # (k,) a bound of |C''|, as `enclosures.turning` has it
    speed: Floats  # (k,) a bound of |C'|


def flatness(segments: Segments, degree: int) -> Flatness:
    """Measure plane segments, preferably so many at a time that their numbers stay in the processor's cache.

    Between the points that are looked at, no point is further from the chord over a step h than h²/8·max|C''|,
    and no derivative further than h/2·max|C''| from that chord divided by h.
    """
    at_ends = generators(1, degree)[-4:]
    halves = ((segments.bend_start, segments.lambda_start), (segments.bend_end, segments.lambda_end))
    start, end = (
        straight + bend * (at_ends[2 * side, side] + at_ends[2 * side + 1, side] * lam)
        for side, (straight, (bend, lam)) in enumerate(
            zip((segments.start, segments.end), halves, strict=True)
        )
    )
    chord = end - start
    length = np.sqrt(chord[0] * chord[0] + chord[1] * chord[1])
    forward = chord / np.where(length > 0, length, 1.0)
    forward[0, length == 0] = 1.0
    along, across = np.empty((5, len(length)), np.float32), np.empty((4, len(length)), np.float32)
    along[4] = length
    turning = np.zeros(len(length))
    for row, ((x, y), lam) in zip((0, 2), halves, strict=True):
        along[row] = x * forward[0] + y * forward[1]
        across[row] = y * forward[0] - x * forward[1]
        for parts in (along, across):
            np.multiply(parts[row], lam, out=parts[row + 1], casting="same_kind")
        turning += np.sqrt(x * x + y * y) * steepest(lam, degree)
    weights = _weights(degree)
    x, y = weights @ along, weights[:, :4] @ across
    beyond = np.maximum(x - along[4], -x).max(axis=0).clip(0.0).astype(np.float64)
    away = np.maximum(y.max(axis=0), -y.min(axis=0)).astype(np.float64)
    x, y = x[1:] - x[:-1], y[1:] - y[:-1]
    fastest = np.sqrt((x * x + y * y).max(axis=0), dtype=np.float64) * STEPS
    return Flatness(
        start,
        end,
        np.sqrt(away * away + beyond * beyond) + turning / (8 * STEPS**2),
        turning,
        fastest + turning / (2 * STEPS),
    )


@lru_cache(maxsize=2)
def _weights(degree: int) -> NDArray[np.float32]:
    """Weights of the bends' features and of the chord for points at equal steps of t, (STEPS + 1, 5).

    The bends are taken without what they add to the ends, in which the chord has it.
    """
    t = np.arange(STEPS + 1) / STEPS
    bends = generators(STEPS, degree)[-4:]
    inner = bends - bends[:, :1] * (1 - t) - bends[:, -1:] * t
    weights: NDArray[np.float32] = np.vstack((inner, t)).T.astype(np.float32)
    return weights
