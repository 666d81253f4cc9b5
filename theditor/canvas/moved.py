"""How two versions of a curve differ, seen quickly: moved as a whole and nothing else, or in how much."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from theditor.spline import Curve

Floats = NDArray[np.float64]
Array = NDArray[Any]

SAMPLE = 64
"""About so many of the control points are compared to see in how many they differ."""


def whole_offset(old: Curve, new: Curve, slight: float) -> Floats | None:
    """By how much a whole curve has been moved, (2,); None if anything else may have happened to it.

    None, too, if rounding moves its points by more than is `slight`.
    """
    one, other = old.control_points, new.control_points
    if old.lambdas is not new.lambdas or one.shape != other.shape or one is other:
        return None
    if (old.degree, old.closed, old.ends) != (new.degree, new.closed, new.ends):
        return None
    offset: Floats = other[0] - one[0]
    length = np.abs(offset).max()
    rounding = 4 * np.finfo(np.float64).eps * (np.abs(one).max() + length)
    if not rounding < min(length / 2, slight):  # shorter ways could be of some points alone
        return None
    for offsets in (other[-1:] - one[-1:], other - one):
        if np.abs(offsets - offset).max() > rounding:
            return None
    return offset


def changed_share(old: Curve, new: Curve) -> float:
    """In about which share of the control points, or of their λ, two versions of a curve differ, from 0 to 1."""
    pairs = (old.control_points, new.control_points), (old.lambdas, new.lambdas)
    return max(_share(one, other) for one, other in pairs)


def _share(one: Array, other: Array) -> float:
    if one is other or one.shape != other.shape:
        return 0.0 if one is other else 1.0
    some = slice(None, None, len(one) // SAMPLE + 1)
    differ = one[some] != other[some]
    return float(np.mean(differ.any(axis=1) if differ.ndim == 2 else differ))
