"""Chains of segments with a prescribed equation: control points from coefficients.

A trigonometric cubic spans 1, t, cos(πt/2), sin(πt/2) and a hyperbolic one 1, t, cosh t, sinh t; quadratics
have no t. These spaces do not change when t is shifted, so one formula gives the control points of chains of
any length: the equation itself, at whole t (cubic) or half-way between (quadratic), with its trigonometric or
hyperbolic part enlarged by a constant.
"""

from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline.basis import Floats, Mode, check_degree, lambda_of
from theditor.spline.checks import MAX_COORDINATE
from theditor.spline.curve import Curve
from theditor.spline.numerals import number

MAX_SEGMENTS: Final = 10_000
"""The longest chain of segments that is made."""

_FURTHEST = 600.0  # exp of it, times any coordinate, is still finite, and far beyond the largest coordinate


def trigonometric(
    c0: ArrayLike,
    c1: ArrayLike,
    c2: ArrayLike,
    c3: ArrayLike,
    segments: int = 1,
    start: float = 0.0,
    degree: int = 3,
) -> Curve:
    """Return the open curve c0 + c1 t + c2 cos(πt/2) + c3 sin(πt/2), t from `start` on, λ = 0.

    Parameters
    ----------
    c0, c1, c2, c3 : array_like, shape (d,)
        Coefficients; c1 must be zero for a quadratic.
    segments : int
        Number of segments, each one unit of t, at most `MAX_SEGMENTS`.
    start : float
        The t to begin at.
    degree : {2, 3}

    Returns
    -------
    Curve
        With free ends; segment s runs over t from start + s to start + s + 1, exactly but for rounding.

    Raises
    ------
    ValueError
        If a number is not finite, a quadratic has c1, the count is senseless or the curve reaches too far.
    """
    c0, c1, c2, c3 = _coefficients(c0, c1, c2, c3)
    t = _places(segments, start, c1, degree)
    cosine, sine = turn(t)
    if degree == 2:  # √2 times those of an eighth of a turn further on
        points = c0 + (cosine - sine) * c2 + (cosine + sine) * c3
    else:
        points = c0 + c1 * t + np.pi / 2 * (cosine * c2 + sine * c3)
    return _chain(points, Mode.TRIGONOMETRIC, degree)


def hyperbolic(
    c0: ArrayLike,
    c1: ArrayLike,
    c2: ArrayLike,
    c3: ArrayLike,
    segments: int = 1,
    start: float = 0.0,
    degree: int = 3,
) -> Curve:
    """Return the open curve c0 + c1 t + c2 cosh t + c3 sinh t, t from `start` on, λ = 1.

    Parameters, result and refusals are those of `trigonometric`.
    """
    c0, c1, c2, c3 = _coefficients(c0, c1, c2, c3)
    t = _places(segments, start, c1, degree) + (0.5 if degree == 2 else 0.0)
    # As exponentials, so that a curve that falls as exp(−t) does so to the last digit.
    grown = np.exp(np.clip(t, -_FURTHEST, _FURTHEST))
    shrunk = np.exp(np.clip(-t, -_FURTHEST, _FURTHEST))
    enlarged = 2 * (np.cosh(0.5) if degree == 2 else np.sinh(1.0))
    points = c0 + c1 * t + ((c2 + c3) * grown + (c2 - c3) * shrunk) / enlarged
    return _chain(points, Mode.HYPERBOLIC, degree)


def turn(quarters: Floats) -> tuple[Floats, Floats]:
    """Return cosine and sine of so many quarter turns, exact for whole ones."""
    whole = np.rint(quarters)
    angle = np.pi / 2 * (quarters - whole)
    cosine, sine = np.cos(angle), np.sin(angle)
    turns: NDArray[np.intp] = np.mod(whole, 4).astype(np.intp)
    return (
        np.choose(turns, (cosine, -sine, -cosine, sine)) + 0.0,
        np.choose(turns, (sine, cosine, -sine, -cosine)) + 0.0,
    )


def clean_numbers(values: ArrayLike, what: str, count: int = 1) -> Floats:
    """Return so many numbers as an array, or refuse them by name."""
    numbers = np.atleast_1d(np.asarray(values, dtype=np.float64))
    if numbers.shape != (count,):
        wanted = "one number" if count == 1 else f"{count} numbers"
        raise ValueError(f"{what} must be {wanted}, not an array of shape {np.shape(values)}")
    if not (np.abs(numbers) <= MAX_COORDINATE).all():
        raise ValueError(
            f"{what} must be finite and at most {MAX_COORDINATE:g} in size, not {listed(numbers)}"
        )
    return numbers


def listed(numbers: Floats) -> str:
    """Write numbers in a sentence: ``2, −1``."""
    return ", ".join(map(number, numbers.tolist()))


def _places(segments: int, start: float, c1: Floats, degree: int) -> Floats:
    """Return the t of the joints that the control points belong to, from the one before `start` on."""
    check_degree(degree)
    if degree == 2 and c1.any():
        raise ValueError("a quadratic has no term in t: leave c1 at zero or take degree 3")
    whole = isinstance(segments, int | np.integer) and not isinstance(segments, bool)
    if not whole or not 1 <= segments <= MAX_SEGMENTS:
        raise ValueError(
            f"the number of segments must be a whole one from 1 to {MAX_SEGMENTS}, not {segments!r}"
        )
    return clean_numbers(start, "start") + np.arange(-1.0, segments + degree - 1)[:, None]


def _chain(points: Floats, mode: Mode, degree: int) -> Curve:
    _check_reach(points)
    return Curve(points, lambda_of(mode, degree), degree)


def _check_reach(vectors: Floats) -> None:
    if not (np.abs(vectors) <= MAX_COORDINATE).all():
        raise ValueError(
            f"the curve would reach beyond {MAX_COORDINATE:g}: make it shorter, smaller or start nearer to 0"
        )


def _coefficients(*vectors: ArrayLike) -> list[Floats]:
    dimension = np.size(vectors[0])
    if dimension not in (2, 3):
        raise ValueError(f"c0 needs 2 or 3 coordinates, not {dimension}")
    for vector in vectors:
        if np.isfinite(vector).all():
            _check_reach(np.asarray(vector))
    return [clean_numbers(vector, f"c{i}", dimension) for i, vector in enumerate(vectors)]
