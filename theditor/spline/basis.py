"""Generators, constants and basis functions of TH-type uniform B-splines.

Each segment of a curve mixes two pairs of generators, on t in [0, 1] with κ = e/(e−1)²:

    s(t) = (1 − cos(πt/2))/2    S(t) = ∫s    trigonometric
    h(t) = κ (cosh t − 1)       H(t) = ∫h    hyperbolic

A shape parameter λ blends them, r = (1−λ)s + λh for the quadratic and R = (1−λ)S + λH for the cubic, so
that everything is affine in λ.

Source: J. Xie, "A Geometric Modeling Method Based on TH-Type Uniform B-Splines", Mathematical Problems in
Engineering 2014, 242469. Several formulas printed there carry misprints; the forms here are derived from the
definitions above.
"""

from enum import Enum
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]

INTERPOLATING: Final[dict[int, float]] = {
    2: 5.059521767515924,  # (√e + 1)² / (1 − √(2e) + e)
    3: 8.912056875738365,  # (2 − π)(e − 1)² / (2(e − 1)² − 2π)
}
"""The λ at which a curve of that degree meets its control points."""

CONVEX_HULL_RANGE: Final[dict[int, tuple[float, float]]] = {
    2: (-12.214766070258836, 3.9411958835214436),
    3: (-15.6133746090849, 3.9411958835214436),
}
"""The closed range of λ in which no basis function of that degree is negative."""

JOINT_SLOPE_ZERO: Final = -2.6481961715882543
"""The λ at which r'(1; λ) vanishes: there a quadratic stands still at the joint, a cubic has no curvature."""

_KAPPA: Final = float(np.e / (np.e - 1) ** 2)


class Mode(Enum):
    """What kind of curve a segment is; follows from the two λ at its ends."""

    TRIGONOMETRIC = "trigonometric"
    HYPERBOLIC = "hyperbolic"
    INTERPOLATING = "interpolating"
    BLEND = "blend"


def lambda_of(mode: Mode, degree: int) -> float:
    """Return the λ that, at both ends of a segment, gives it this mode.

    Raises
    ------
    ValueError
        For ``Mode.BLEND``, which no single λ stands for, for what is no mode, and for a degree other than 2 and 3.
    """
    check_degree(degree)
    if mode is Mode.TRIGONOMETRIC:
        return 0.0
    if mode is Mode.HYPERBOLIC:
        return 1.0
    if mode is Mode.INTERPOLATING:
        return INTERPOLATING[degree]
    if mode is Mode.BLEND:
        raise ValueError("a blend has no λ of its own: choose trigonometric, hyperbolic or interpolating")
    raise ValueError(f"mode must be a Mode such as Mode.HYPERBOLIC, not {mode!r}")


def mode_of(lambda_start: float, lambda_end: float, degree: int) -> Mode:
    """Return the mode of a segment with these λ at its ends; equality is exact."""
    for mode in (Mode.TRIGONOMETRIC, Mode.HYPERBOLIC, Mode.INTERPOLATING):
        if lambda_start == lambda_end == lambda_of(mode, degree):
            return mode
    return Mode.BLEND


def trigonometric(t: Floats, order: int) -> Floats:
    """Return s (order 0), its derivatives (1, 2, 3) or its integral S (−1) at `t`."""
    if order == -1:
        return t / 2 - np.sin(np.pi / 2 * t) / np.pi
    if order == 0:  # as a square, and exactly 1/2 at t = 1, where the factor λ may be huge
        root: Floats = np.sin(np.pi / 4 * t) / np.sin(np.pi / 4)
        return root * root / 2
    if order == 1:
        return np.pi / 4 * np.sin(np.pi / 2 * t)
    if order == 2:
        return np.pi**2 / 8 * np.cos(np.pi / 2 * t)
    return -(np.pi**3) / 16 * np.sin(np.pi / 2 * t)


def hyperbolic(t: Floats, order: int) -> Floats:
    """Return h (order 0), its derivatives (1, 2, 3) or its integral H (−1) at `t`."""
    if order == -1:
        return _KAPPA * (np.sinh(t) - t)
    if order == 0:  # κ(cosh t − 1), as a square
        root: Floats = np.sinh(t / 2) / np.sinh(0.5)
        return root * root / 2
    if order == 2:
        return _KAPPA * np.cosh(t)
    return _KAPPA * np.sinh(t)


def blended(t: Floats, lam: Floats, degree: int, nu: int) -> Floats:
    """Return derivative `nu` of r(t; λ) for the quadratic, of R(t; λ) for the cubic."""
    order = nu + 2 - degree
    return (1 - lam) * trigonometric(t, order) + lam * hyperbolic(t, order)


def basis(
    t: ArrayLike, lambda_start: ArrayLike, lambda_end: ArrayLike, degree: int = 3, nu: int = 0
) -> Floats:
    """Return the basis functions of one segment, or their derivatives.

    The arguments broadcast. Values are within 1e-15·max(1, |λ|) of the exact ones, derivatives within
    1e-14·max(1, |λ|).

    Parameters
    ----------
    t : array_like
        Parameter within the segment, 0 to 1.
    lambda_start, lambda_end : array_like
        The shape parameters at the start (t = 0) and at the end (t = 1) of the segment.
    degree : {2, 3}
        Quadratic or cubic.
    nu : {0, 1, 2, 3}
        Order of the derivative with respect to `t`.

    Returns
    -------
    ndarray, shape (..., degree + 1)
        The weights of the segment's control points, in their order. They sum to 1 (derivatives to 0).

    Raises
    ------
    ValueError
        If `degree` or `nu` is none of the values above.
    """
    check_degree(degree)
    check_order(nu)
    t = np.asarray(t, dtype=np.float64)
    first = (-1) ** nu * blended(1 - t, np.asarray(lambda_start, dtype=np.float64), degree, nu)
    last = blended(t, np.asarray(lambda_end, dtype=np.float64), degree, nu)
    if degree == 2:
        middle = float(nu == 0) - first - last
        return np.stack(np.broadcast_arrays(first, middle, last), axis=-1)
    second = (1 - t if nu == 0 else -float(nu == 1)) + last - 2 * first
    third = (t if nu == 0 else float(nu == 1)) + first - 2 * last
    return np.stack(np.broadcast_arrays(first, second, third, last), axis=-1)


def check_degree(degree: int) -> None:
    """Refuse a degree other than 2 and 3."""
    if isinstance(degree, bool) or degree not in (2, 3):
        raise ValueError(f"degree must be 2 or 3, not {degree!r}")


def check_order(nu: int) -> None:
    """Refuse an order of derivative other than 0 to 3."""
    if isinstance(nu, bool) or nu not in (0, 1, 2, 3):
        raise ValueError(f"the order nu of the derivative must be 0, 1, 2 or 3, not {nu!r}")
