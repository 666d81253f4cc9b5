"""Segments as cubic Béziers, with handles as good as they can be and a deviation that is measured.

A piece is a segment's polynomial (see `bernstein`) halved as often as needed, so that everything about all
pieces at once is a product with a constant matrix: points and derivatives at a few steps of t. The handles
keep to the tangents at both ends; their two lengths bring the Bézier as near to the curve as least squares
across the curve can, which gains two orders over those of the derivatives.
"""

from functools import cache
from math import comb
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.spline import bernstein
from theditor.spline.basis import Floats
from theditor.spline.joints import Segments
from theditor.spline.turns import grain

_STEPS: Final = 10  # of t on a piece where it is compared with its Bézier
_FINE_STEPS: Final = 64  # the same where it matters
_SAFETY: Final = 1.3  # between steps a piece may deviate by so much more
_SHARP: Final = 0.96  # cosine of a turn from one step to the next that is not to be measured across
_DEEPEST: Final = 26  # halvings of a segment
_STIFFNESS: Final = 1e-9  # of the derivatives' lengths, which decide where a piece is all but straight
_BLOCK: Final = 2048  # segments at a time, to stay within the cache


class Cubics(NamedTuple):
    """Cubic Béziers of some segments, in no particular order."""

    row: NDArray[np.intp]  # (n,) which segment
    t: Floats  # (n,) where on it the piece starts
    start: Floats  # (n, d)
    inner: Floats  # (n, 2, d) the two handles' ends
    deviation: float


def cubics(segments: Segments, degree: int, tolerance: float) -> Cubics:
    """Approximate segments by cubic Béziers, each halved until it is within the tolerance.

    Every piece has the segment's points and tangents at its ends. The deviation is the largest distance
    between a Bézier and its segment, measured at a few steps and closely where it is greatest. It exceeds the
    tolerance only where rounding does, or where a segment turns too sharply even for 2⁻²⁶ of it.
    """
    found = []
    for first in range(0, len(segments.lambda_start), _BLOCK):
        rows = np.arange(first, min(first + _BLOCK, len(segments.lambda_start)))
        found.append(_block(segments.take(rows), degree, tolerance, first))
    if not found:
        d = len(segments.start)
        return Cubics(np.empty(0, np.intp), np.empty(0), np.empty((0, d)), np.empty((0, 2, d)), 0.0)
    return _together(found, max(each.deviation for each in found))


def _together(found: list[Cubics], deviation: float) -> Cubics:
    """Return the same as one."""
    row, t, start, inner = (np.concatenate(part) for part in list(zip(*found, strict=True))[:4])
    return Cubics(row, t, start, inner, deviation)


def _block(segments: Segments, degree: int, tolerance: float, first: int) -> Cubics:
    """Approximate some segments, the first of which is row `first`."""
    # Near its own start a segment is known more exactly than far from the origin.
    origin = segments.start
    near = segments._replace(start=np.zeros_like(origin), end=segments.end - origin)
    coefficients = bernstein.polynomials(near, degree)
    finest = np.maximum(tolerance, 16 * grain(near))
    rows, t = np.arange(len(finest)), np.zeros(len(finest))
    found: list[Cubics] = []
    worst = 0.0
    for depth in range(_DEEPEST + 1):
        inner, off = _fitted(coefficients)
        limit = finest[rows]
        _look_closely(off, (off <= limit) & (off * _SAFETY > limit), coefficients, inner)
        good = (off <= limit) | (depth == _DEEPEST)
        if good.any():
            _look_closely(off, good & (off * _SAFETY >= off[good].max()), coefficients, inner)
            worst = max(worst, float(off[good].max()))
            start = coefficients[:, good, 0] + origin[:, rows[good]]
            handles = inner[:, :, good] + origin[:, None, rows[good]]
            found.append(Cubics(rows[good] + first, t[good], start.T, handles.transpose(2, 1, 0), worst))
        if good.all():
            break
        rows, t = rows[~good], t[~good]
        coefficients = np.concatenate(bernstein.halves(coefficients[:, ~good]), axis=1)
        rows, t = np.tile(rows, 2), np.concatenate((t, t + 0.5 ** (depth + 1)))
    return _together(found, worst)


def _fitted(coefficients: Floats) -> tuple[Floats, Floats]:
    """Return the ends of the handles, (d, 2, n), of the Bézier for each piece, and how far it is off, (n,)."""
    start, end = coefficients[..., 0], coefficients[..., -1]
    ahead = _direction(coefficients)
    behind = _direction(coefficients[..., ::-1])
    third = bernstein.DEGREE / 3
    natural = third * np.stack((_length(coefficients[..., 1] - start), _length(coefficients[..., -2] - end)))
    curve = _derivatives(coefficients, _STEPS)
    weights = _weights(_STEPS)
    along = curve[1] / np.maximum(_length(curve[1]), 1e-300)
    sharp = _sharp(ahead, along, -behind)

    def across(vectors: Floats) -> Floats:
        inside: Floats = vectors - along * (vectors * along).sum(axis=0)
        return inside

    base = start[..., None] * (weights[0] + weights[1]) + end[..., None] * (weights[2] + weights[3])
    gap = across(base - curve[0])
    pulls = across(ahead[..., None] * weights[1]), across(behind[..., None] * weights[2])
    lengths = np.where(sharp, natural, _least_squares(pulls, gap, natural))
    inner = np.stack((start + lengths[0] * ahead, end + lengths[1] * behind), axis=1)
    return inner, _distances(coefficients, curve, _bezier(start, inner, end, weights), sharp).max(axis=1)


def _sharp(ahead: Floats, along: Floats, back: Floats) -> NDArray[np.bool_]:
    """Return which pieces, (n,), turn too far from one step to the next to be measured across."""
    directions = np.concatenate((ahead[..., None], along, back[..., None]), axis=-1)
    cosines = (directions[..., 1:] * directions[..., :-1]).sum(axis=0)
    sharp: NDArray[np.bool_] = cosines.min(axis=1) < _SHARP
    return sharp


def _least_squares(pulls: tuple[Floats, Floats], gap: Floats, natural: Floats) -> Floats:
    """Return both handles' lengths, (2, n), that bring the gap nearest to 0; the natural ones if none do."""
    rest = gap + pulls[0] * natural[0][:, None] + pulls[1] * natural[1][:, None]
    a, b, c = (np.einsum("dnk,dnk->n", pulls[i], pulls[j]) for i, j in ((0, 0), (0, 1), (1, 1)))
    p, q = (-np.einsum("dnk,dnk->n", pull, rest) for pull in pulls)
    a, c = a + _STIFFNESS, c + _STIFFNESS
    determinant = a * c - b * b
    lengths = natural + np.stack((c * p - b * q, a * q - b * p)) / determinant
    sound = (lengths > natural / 8).all(axis=0) & (lengths <= 8 * natural).all(axis=0)
    return np.where(sound, lengths, natural)


def _distances(coefficients: Floats, curve: Floats, bezier: Floats, sharp: NDArray[np.bool_]) -> Floats:
    """Return bounds, (n, k), of how far points, (d, n, k), are from the curve, tight if that is near.

    The curve is given by its derivatives at the t of the points, and for the rest of Taylor's series by its
    coefficients. On sharp pieces it is the distance at the same t, smooth whatever lies between the steps.
    """
    apart = bezier - curve[0]
    plain = _length(apart)
    # One step of Newton's method takes us to the foot, or to a point that is hardly farther.
    slope = (apart * curve[1]).sum(axis=0)
    steep = (curve[1] ** 2).sum(axis=0) - (apart * curve[2]).sum(axis=0)
    step = np.divide(slope, steep, out=np.zeros_like(slope), where=(steep > 0) & ~sharp[:, None])
    t = _places(step.shape[1] + 1)
    step = np.clip(step, -t, 1 - t)
    foot = curve[0] + step * (curve[1] + step / 2 * (curve[2] + step / 3 * curve[3]))
    fourth = _length(np.diff(coefficients, 4, axis=-1)).max(axis=-1) * comb(bernstein.DEGREE, 4)
    near: Floats = np.minimum(plain, _length(bezier - foot) + fourth[:, None] * step**4)
    return near


def _look_closely(off: Floats, chosen: NDArray[np.bool_], coefficients: Floats, inner: Floats) -> None:
    """Raise the deviations of chosen pieces to what finer steps find."""
    pieces = np.flatnonzero(chosen)
    for first in range(0, len(pieces), _BLOCK):
        some = pieces[first : first + _BLOCK]
        coefs, handles = coefficients[:, some], inner[:, :, some]
        curve = _derivatives(coefs, _FINE_STEPS)
        along = curve[1] / np.maximum(_length(curve[1]), 1e-300)
        sharp = _sharp(along[..., 0], along, along[..., -1])
        bezier = _bezier(coefs[..., 0], handles, coefs[..., -1], _weights(_FINE_STEPS))
        off[some] = np.maximum(off[some], _distances(coefs, curve, bezier, sharp).max(axis=1))


def _bezier(start: Floats, inner: Floats, end: Floats, weights: Floats) -> Floats:
    """Return points of Béziers, (d, n, k)."""
    controls = np.stack((start, inner[:, 0], inner[:, 1], end), axis=-1)
    points: Floats = controls @ weights
    return points


def _direction(coefficients: Floats) -> Floats:
    """Return unit vectors, (d, n), in which pieces set off, a cusp at their start included."""
    away = coefficients[..., 1:4] - coefficients[..., :1]
    lengths = _length(away)
    size = _length(coefficients - coefficients[..., :1]).max(axis=-1)
    first = (lengths > 1e-9 * size[:, None]).argmax(axis=-1)
    vector = np.take_along_axis(away, first[None, :, None], axis=-1)[..., 0]
    return vector / np.maximum(_length(vector), 1e-300)


def _derivatives(coefficients: Floats, steps: int) -> Floats:
    """Return points and three derivatives of pieces at the inner steps of t, (4, d, n, steps − 1)."""
    matrices = _matrices(steps)
    values = coefficients @ matrices
    return np.moveaxis(values.reshape(*values.shape[:-1], 4, steps - 1), -2, 0)


@cache
def _matrices(steps: int) -> Floats:
    """Return what takes coefficients to points and three derivatives, (DEGREE + 1, 4 · (steps − 1))."""
    t = _places(steps)
    blocks, difference = [], np.eye(bernstein.DEGREE + 1)
    for nu in range(4):
        n = bernstein.DEGREE - nu
        values = np.array([comb(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1)])
        blocks.append(difference @ values)
        difference = difference @ (np.eye(n + 1, n, -1) - np.eye(n + 1, n)) * n
    return np.concatenate(blocks, axis=1)


def _places(steps: int) -> Floats:
    """Return the inner t of the steps, closer towards the ends, where a sharp bend may hide."""
    places: Floats = np.sin(np.pi / 2 * np.arange(1, steps) / steps) ** 2
    return places


@cache
def _weights(steps: int) -> Floats:
    t = _places(steps)
    return np.array([comb(3, i) * t**i * (1 - t) ** (3 - i) for i in range(4)])


def _length(vectors: Floats) -> Floats:
    """Return the lengths of vectors, (d, …)."""
    lengths: Floats = np.sqrt((vectors * vectors).sum(axis=0))
    return lengths
