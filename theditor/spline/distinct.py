"""The different ones among some values, or in a row of points."""

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from theditor.spline.basis import Floats

Scalar = TypeVar("Scalar", bound=np.generic)


def distinct(values: NDArray[Scalar]) -> NDArray[Scalar]:
    """Return each value of a flat array once, ascending.

    `numpy.unique` does so, too, but loads all of `numpy.ma` when it is first called, and hashes integers, which
    takes longer than to sort them.
    """
    if not values.size:
        return values
    # Equal ones often stand together: then few are left to sort.
    return _first_of_runs(np.sort(_first_of_runs(values)))


def _first_of_runs(values: NDArray[Scalar]) -> NDArray[Scalar]:
    begins = np.ones(len(values), dtype=np.bool_)
    np.not_equal(values[1:], values[:-1], out=begins[1:])
    return values[begins]


def moves_on(points: Floats) -> NDArray[np.bool_]:
    """Return of each of the points, (n, d), whether it is not the same as the one before."""
    return np.append(True, (points[1:] != points[:-1]).any(axis=1))
