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
    if values.size == 0 or (values == values[0]).all():
        return values[:1]
    ascending: NDArray[Scalar] = np.sort(values)
    result: NDArray[Scalar] = ascending[np.append(True, ascending[1:] != ascending[:-1])]
    return result


def moves_on(points: Floats) -> NDArray[np.bool_]:
    """Return of each of the points, (n, d), whether it is not the same as the one before."""
    return np.append(True, (points[1:] != points[:-1]).any(axis=1))
