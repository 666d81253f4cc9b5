"""Curves that have been moved as a whole, and nothing else."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from theditor.spline import Curve

Floats = NDArray[np.float64]


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
