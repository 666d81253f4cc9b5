"""Refusals: turn what a caller hands in into clean arrays, or say what is wrong and where."""

from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline.basis import Floats, check_degree

MAX_COORDINATE: Final = 1e12
"""The largest |coordinate| of a control point."""

MAX_LAMBDA: Final = 1e6
"""The largest |λ|."""

ENDS: Final = ("free", "clamped")


def fewest_points(degree: int, closed: bool, ends: str) -> int:
    """Return how many control points such a curve needs at least.

    Raises
    ------
    ValueError
        If `degree` is not 2 or 3, or `ends` neither ``"free"`` nor ``"clamped"``.
    """
    check_degree(degree)
    check_ends(ends)
    if closed or degree == 2:
        return 3
    return 2 if ends == "clamped" else 4


def check_count(count: int, degree: int, closed: bool, ends: str) -> None:
    """Refuse too few control points."""
    fewest = fewest_points(degree, closed, ends)
    if count < fewest:
        kind = f"{'closed' if closed else ends} {'quadratic' if degree == 2 else 'cubic'}"
        raise ValueError(f"a {kind} curve needs at least {fewest} control points, not {count}")


def check_closed(closed: bool) -> None:
    """Refuse what is not a truth value."""
    if not isinstance(closed, bool | np.bool_):
        raise ValueError(f"closed must be True or False, not {closed!r}")


def check_ends(ends: str) -> None:
    """Refuse an unknown end condition."""
    if ends not in ENDS:
        raise ValueError(f'ends must be "free" or "clamped", not {ends!r}')


def clean_points(points: ArrayLike) -> Floats:
    """Return a copy of the control points of a curve as an (m, 2) or (m, 3) array."""
    numbers = _numbers(points, "control points")
    if numbers.ndim != 2 or numbers.shape[1] not in (2, 3):
        raise ValueError(f"control points must have the shape (m, 2) or (m, 3), not {numbers.shape}")
    check_coordinates(numbers, None)
    return numbers


def clean_values(values: ArrayLike, what: str, shape: tuple[int, ...]) -> Floats:
    """Return new values for part of a curve, broadcast to `shape`."""
    numbers = _numbers(values, what)
    if numbers.size == 0 and 0 in shape:
        return np.empty(shape)
    try:
        return np.broadcast_to(numbers, shape)
    except ValueError:
        raise ValueError(f"{what} must have the shape {shape}, not {numbers.shape}") from None


def clean_lambdas(lambdas: ArrayLike, count: int) -> Floats:
    """Return shape parameters, one for each of `count` control points; a single number serves all."""
    numbers = _numbers(lambdas, "shape parameters λ")
    if numbers.ndim == 0:
        numbers = np.full(count, numbers)
    if numbers.shape != (count,):
        raise ValueError(
            f"shape parameters λ must be one number or one for each of the {count} control points, "
            f"not an array of shape {numbers.shape}"
        )
    check_lambdas(numbers, None)
    return numbers


def clean_indices(indices: ArrayLike, count: int, what: str) -> NDArray[np.intp]:
    """Return a flat array of indices from 0 to `count` − 1; a single index becomes an array of one."""
    given = np.asarray(indices)
    if given.size == 0:
        return np.empty(0, dtype=np.intp)
    if given.ndim > 1 or given.dtype.kind not in "iu":
        raise ValueError(f"give the {what} as one integer or a flat sequence of integers")
    wrong = (given < 0) | (given >= count)
    if wrong.any():
        raise ValueError(
            f"there is no {what} {np.atleast_1d(given[wrong])[0]}: they run from 0 to {count - 1}"
        )
    return np.atleast_1d(given).astype(np.intp)


def check_coordinates(points: Floats, indices: NDArray[np.intp] | None) -> None:
    """Refuse control points that are not finite or too far out; `indices` are their places in the curve."""
    place = _first_bad(points, MAX_COORDINATE)
    if place is not None:
        row, axis = place
        value = float(points[row, axis])
        raise ValueError(
            f"control point {row if indices is None else indices[row]}: {'xyz'[axis]} is {value}, "
            f"but coordinates must be finite and at most {MAX_COORDINATE:g} in size"
        )


def check_lambdas(lambdas: Floats, indices: NDArray[np.intp] | None) -> None:
    """Refuse shape parameters that are not finite or too large; `indices` are their places in the curve."""
    place = _first_bad(lambdas, MAX_LAMBDA)
    if place is not None:
        (row,) = place
        raise ValueError(
            f"control point {row if indices is None else indices[row]}: λ is {float(lambdas[row])}, "
            f"but λ must be finite and at most {MAX_LAMBDA:g} in size"
        )


def _first_bad(numbers: Floats, largest: float) -> tuple[int, ...] | None:
    # Extremes first: one pass without a temporary decides the usual case, and NaN fails the comparison too.
    if numbers.size == 0 or (numbers.min() >= -largest and numbers.max() <= largest):
        return None
    return tuple(int(i) for i in np.argwhere(~(np.abs(numbers) <= largest))[0])


def _numbers(values: ArrayLike, what: str) -> Floats:
    try:
        given = np.asarray(values)
    except ValueError:
        raise ValueError(f"{what} must be an array of numbers, without rows of different length") from None
    if given.dtype.kind not in "iuf":
        raise ValueError(f"{what} must be real numbers")
    numbers = np.array(given, dtype=np.float64, order="C")
    numbers += 0.0  # turns −0.0 into 0.0
    return numbers
