"""Curves that have been moved as a whole, and nothing else."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from theditor.spline import Curve

Floats = NDArray[np.float64]


def whole_offset(old: Curve, new: Curve) -> Floats | None:
    """By how much a whole curve has been moved, (2,); None if anything else has happened to it."""
    one, other = old.control_points, new.control_points
    if old.lambdas is not new.lambdas or one.shape != other.shape or one is other:
        return None
    if (old.degree, old.closed, old.ends) != (new.degree, new.closed, new.ends):
        return None
    offset: Floats = other[0] - one[0]
    if (
        not offset.any()
        or not _near(other[-1:] - one[-1:], offset, one)
        or not _near(other - one, offset, one)
    ):
        return None
    return offset


def _near(offsets: Floats, offset: Floats, points: Floats) -> bool:
    """Whether offsets, (k, 2), differ from one by rounding only, of points moved by them."""
    rounding = 4 * np.finfo(np.float64).eps * (np.abs(points).max() + np.abs(offset).max())
    return bool(np.abs(offsets - offset).max() <= rounding)
