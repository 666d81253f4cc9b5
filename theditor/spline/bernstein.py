"""Segments as polynomials in Bernstein form, whose coefficients bound what they stand for.

The generators are so tame on [0, 1] that their Taylor polynomials of degree 16 about t = 1/2 are exact to
rounding. A polynomial on [0, 1] lies between the least and the greatest of its Bernstein coefficients, and
changes sign no more often than they do; sums, products and halves keep this, which turns "all extremes",
"all inflections" or "nowhere nearer than" into counting. Coefficients are on the last axis.
"""

from functools import cache
from math import comb, factorial
from typing import Final

import numpy as np

from theditor.spline.basis import Floats, hyperbolic, trigonometric
from theditor.spline.joints import Segments

DEGREE: Final = 16
"""The degree of the polynomials that stand for segments."""


def polynomials(segments: Segments, degree: int, nu: int = 0) -> Floats:
    """Return derivative `nu` of each coordinate of each segment, (d, k, DEGREE + 1), exact to rounding."""
    free, pulled = _generators(nu + 2 - degree)
    start, end = segments.lambda_start[:, None], segments.lambda_end[:, None]
    sign = 1.0 if (nu + degree) % 2 else -1.0
    out = (sign * segments.bend_start)[..., None] * ((1 - start) * free[::-1] + start * pulled[::-1])
    out += segments.bend_end[..., None] * ((1 - end) * free + end * pulled)
    if nu == 0:
        t = np.linspace(0, 1, DEGREE + 1)
        out += segments.start[..., None] * (1 - t) + segments.end[..., None] * t
    elif nu == 1 and degree == 3:
        out += (segments.end - segments.start)[..., None]
    return out


def product(a: Floats, b: Floats) -> Floats:
    """Return the products of polynomials, (…, p + 1) times (…, q + 1) giving (…, p + q + 1)."""
    p, q = a.shape[-1] - 1, b.shape[-1] - 1
    left, right = a * _binomials(p), b * _binomials(q)
    out = np.zeros((*np.broadcast_shapes(a.shape[:-1], b.shape[:-1]), p + q + 1))
    for i in range(p + 1):
        out[..., i : i + q + 1] += left[..., i, None] * right
    out /= _binomials(p + q)
    return out


def halves(coefficients: Floats) -> tuple[Floats, Floats]:
    """Return the same polynomials over [0, 1/2] and over [1/2, 1], each again with its own [0, 1]."""
    first, second = _halving(coefficients.shape[-1] - 1)
    return coefficients @ first, coefficients @ second


def value(coefficients: Floats, t: Floats) -> Floats:
    """Return each polynomial's value at its own parameter, (…, n + 1) at (…,) giving (…,), for n ≥ 1."""
    n = coefficients.shape[-1] - 1
    binomials = _binomials(n)
    power = np.ones_like(t)
    out = coefficients[..., 0] * (1 - t)
    for i in range(1, n):
        power = power * t
        out = (out + binomials[i] * power * coefficients[..., i]) * (1 - t)
    return out + power * t * coefficients[..., n]


@cache
def _generators(order: int) -> tuple[Floats, Floats]:
    """Return the trigonometric and the hyperbolic generator's derivative of that order (−1: integral)."""
    middle = np.array(0.5)
    free, pulled = np.zeros(DEGREE + 1), np.zeros(DEGREE + 1)
    for j in range(DEGREE + 1):
        # (t − 1/2)ʲ, its degree raised by a factor 1
        power = product((-0.5) ** np.arange(j, -1, -1) * 0.5 ** np.arange(j + 1), np.ones(DEGREE + 1 - j))
        folds = max(0, (order + j - 1) // 2)  # s''' = −(π/2)² s', h''' = h', and so on
        base = order + j - 2 * folds
        free += (-(np.pi**2) / 4) ** folds * trigonometric(middle, base) / factorial(j) * power
        pulled += hyperbolic(middle, base) / factorial(j) * power
    return free, pulled


@cache
def _binomials(n: int) -> Floats:
    return np.array([comb(n, i) for i in range(n + 1)], dtype=np.float64)


@cache
def _halving(n: int) -> tuple[Floats, Floats]:
    first = np.array([[comb(j, i) / 2**j for j in range(n + 1)] for i in range(n + 1)])
    return first, np.ascontiguousarray(first[::-1, ::-1])
