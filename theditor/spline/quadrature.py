"""Integrals along segments, as exact as asked for, whatever cusps they run through."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline import joints
from theditor.spline.basis import Floats

if TYPE_CHECKING:
    from theditor.spline.curve import Curve

Derivatives = Callable[[int], Floats]
"""The curve's derivatives at the nodes: an order to (d, n, k)."""

Integrand = Callable[[Derivatives], Floats]
"""What is integrated, (n, k), as a function of the curve's derivatives."""

# Gauss–Lobatto, so that no cusp near the end of an interval, beyond its outermost node, goes unseen.
# As numbers, since numpy.polynomial takes longer to load than all else here.
_RIGHT = np.array([0.16527895766638703, 0.4779249498104445, 0.738773865105505, 0.9195339081664589, 1.0])
_NODES = np.concatenate((-_RIGHT[::-1], _RIGHT))
_HALF = np.array([0.32753976118389744, 0.2920426836796838, 0.22488934206312644, 0.13330599085107012, 1 / 45])
_WEIGHTS = np.concatenate((_HALF[::-1], _HALF))
_BLOCK = 4096
_DEPTH = 50  # halvings: beyond them an integrand has no integral
_MOST = 64  # parts of one segment open at a time
_ROUNDING = 1e-15


def integrals(
    curve: "Curve",
    segments: NDArray[np.intp],
    start: ArrayLike,
    end: ArrayLike,
    integrand: Integrand,
    accuracy: float,
    bounded: bool = False,
) -> Floats:
    """Return the integral of a function over part of each segment, (k,).

    Gauss–Lobatto rules of ten nodes; every part is halved until rule and halves agree. Where they never do,
    as at a pole, the integral is infinite.

    Parameters
    ----------
    curve : Curve
    segments : ndarray of int, shape (k,)
    start, end : float or ndarray, shape (k,)
        The limits of t.
    integrand : callable
        Not negative.
    accuracy : float
        Largest error, relative to the value.
    bounded : bool
        Whether the integrand has no poles: what rounding keeps from settling then counts as it stands.
    """
    start = np.broadcast_to(np.asarray(start, dtype=np.float64), segments.shape)
    end = np.broadcast_to(np.asarray(end, dtype=np.float64), segments.shape)
    blocks = [slice(first, first + _BLOCK) for first in range(0, len(segments), _BLOCK)]
    parts = [_block(curve, segments[b], start[b], end[b], integrand, accuracy, bounded) for b in blocks]
    return np.concatenate(parts) if parts else np.empty(0)


def pieces(u0: float, u1: float) -> tuple[NDArray[np.intp], Floats, Floats]:
    """Return the segments between two parameters of a curve, and where in each to start and to end."""
    segments = np.arange(np.floor(u0), np.ceil(u1)).astype(np.intp)
    return segments, np.maximum(u0 - segments, 0), np.minimum(u1 - segments, 1)


def _block(
    curve: "Curve",
    segments: NDArray[np.intp],
    start: Floats,
    end: Floats,
    integrand: Integrand,
    accuracy: float,
    bounded: bool,
) -> Floats:
    parts = joints.take_segments(curve, segments)
    row = np.arange(len(segments))
    total = np.zeros(len(row))
    whole = _rule(parts, start, end, curve.degree, integrand)
    size = np.abs(whole)
    for depth in range(_DEPTH + 1):
        middle = (start + end) / 2
        left = _rule(parts, start, middle, curve.degree, integrand)
        right = _rule(parts, middle, end, curve.degree, integrand)
        both = left + right
        with np.errstate(invalid="ignore"):
            error = np.abs(both - whole)
            allowed = np.maximum(accuracy * 0.5**depth * size[row], accuracy * both)
            open_ = ~(error <= np.maximum(allowed, _ROUNDING * size[row]))
        # A pole, or one to rounding: a single bad place leaves one or two parts open, noise ever more.
        hopeless = open_ & ((depth == _DEPTH) | (np.bincount(row, open_, len(total))[row] > _MOST))
        if not bounded:
            both[hopeless] = np.inf
        open_ &= ~hopeless
        np.add.at(total, row[~open_], both[~open_])
        if not open_.any():
            break
        row = np.tile(row[open_], 2)
        again = np.tile(np.flatnonzero(open_), 2)
        whole = np.concatenate((left[open_], right[open_]))
        start, end = (
            np.concatenate((start[open_], middle[open_])),
            np.concatenate((middle[open_], end[open_])),
        )
        parts = parts.take(again)
    return total


def _rule(segments: joints.Segments, start: Floats, end: Floats, degree: int, integrand: Integrand) -> Floats:
    """Return the ten-node rule over one interval of each segment."""
    if len(start) and (start == start[0]).all() and (end == end[0]).all():
        start, end = start[:1], end[:1]  # the generators are then needed once for all segments
    half = (end - start) / 2
    t = (start + end) / 2 + half * _NODES[:, None]
    spread = joints.Segments(*(part[..., None, :] if part.ndim > 1 else part for part in segments))
    with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
        return _WEIGHTS @ integrand(lambda nu: joints.evaluate(spread, t, degree, nu)) * half
