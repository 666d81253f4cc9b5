"""Where the curvature changes sign, and where it is extreme."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.spline import bernstein, joints
from theditor.spline.basis import Floats
from theditor.spline.curvature import Side, curvature
from theditor.spline.curve import Curve
from theditor.spline.parameters import check_accuracy, check_plane
from theditor.spline.roots import sign_changes, signs
from theditor.spline.turns import speed_scale, turns, turns_and_growth

_BLOCK = 2048  # segments at a time
_LEAP = 1e-9  # relative difference of |κ| on the two sides of a joint from which on it is a jump
_CUSP = (
    1e-3  # speed, beside its terms, below which a root of the turn too smeared to be told from 0 is a cusp
)


class Inflections(NamedTuple):
    """Where the curvature of a plane curve changes sign, ascending."""

    u: Floats  # (k,)
    jump: NDArray[np.bool_]  # (k,) at a joint, without passing through 0 there


class CurvatureExtremes(NamedTuple):
    """Where |κ| is a local maximum or minimum, ascending; a joint may be both, one on each side."""

    u: Floats  # (k,)
    curvature: Floats  # (k,) |κ| there, on the side where it is extreme
    maximum: NDArray[np.bool_]  # (k,)


def inflections(curve: Curve, accuracy: float = 1e-9) -> Inflections:
    """Return where the curvature of a plane curve changes sign, in and between segments.

    A segment that is straight to rounding has no inflection, nor has the place where it meets its
    neighbours. On a closed curve one at the seam is given as u = 0.

    Parameters
    ----------
    curve : Curve
    accuracy : float
        Two inflections of a segment closer than this in u may be missed together; those found are exact to
        rounding.

    Raises
    ------
    ValueError
        If the curve is not plane, or `accuracy` is not a positive number.
    """
    check_accuracy(accuracy)
    check_plane(curve, "inflections")
    inner = [np.empty(0)]
    begins, ends = np.zeros((2, curve.segment_count))
    bent = np.zeros((2, curve.segment_count), dtype=np.bool_)
    for block in _blocks(curve):
        turn, noise = turns(joints.take_segments(curve, block), curve.degree)
        found = sign_changes(turn, noise, accuracy)
        inner.append(block[found.row] + found.t)
        begins[block], ends[block] = found.first, found.last
        bent[:, block] = np.abs(turn[:, [0, -1]].T) > noise
    before, at = _meetings(curve)
    changed = ends[before] * begins[at] < 0
    u = np.concatenate((*inner, at[changed]))
    jump = np.zeros(len(u), dtype=np.bool_)
    jump[len(u) - np.count_nonzero(changed) :] = (bent[1, before] | bent[0, at])[changed]
    order = np.argsort(u, kind="stable")
    return Inflections(u[order], jump[order])


def curvature_extremes(curve: Curve, accuracy: float = 1e-9) -> CurvatureExtremes:
    """Return where |κ| is a local maximum or minimum, in and between segments.

    Zeros of κ are not given (see `inflections`), nor are stretches of constant curvature and the ends of an
    open curve. A cusp is a maximum; its |κ| is what rounding leaves of infinity, or inf.

    Parameters
    ----------
    curve : Curve
    accuracy : float
        Two extremes of a segment closer than this in u may be missed together; those found are exact to
        rounding.

    Raises
    ------
    ValueError
        If `accuracy` is not a positive number.
    """
    check_accuracy(accuracy)
    u, maximum = [np.empty(0)], [np.empty(0, dtype=np.bool_)]
    begins, ends = np.zeros((2, curve.segment_count))  # whether |κ| grows or shrinks there
    bent = np.zeros((2, curve.segment_count), dtype=np.bool_)
    for block in _blocks(curve):
        segments = joints.take_segments(curve, block)
        turn, turn_noise, growth, noise = turns_and_growth(segments, curve.degree)
        found = sign_changes(growth, noise, accuracy)
        velocity = joints.evaluate(segments.take(found.row), found.t, curve.degree, 1)
        cusp = np.linalg.norm(velocity, axis=0) <= _CUSP * speed_scale(segments)[found.row]
        height = bernstein.value(turn[found.row], found.t)
        real = np.abs(height) > turn_noise[found.row]
        u.append((block[found.row] + found.t)[real | cusp])
        maximum.append(np.where(real, found.rising == (height < 0), cusp)[real | cusp])
        first, last, _ = signs(turn, turn_noise)
        begins[block], ends[block] = found.first * first, found.last * last
        bent[:, block] = np.abs(turn[:, [0, -1]].T) > turn_noise
    inner = np.concatenate(u)
    value = _size(curve, inner, "right")
    before, at = _meetings(curve)
    table = [(inner, value, np.concatenate(maximum))]
    left, right = _size(curve, at, "left"), _size(curve, at, "right")
    with np.errstate(invalid="ignore"):  # inf on both sides is level already
        level = (left == right) | (np.abs(left - right) <= _LEAP * np.maximum(left, right))
    up, down = ~level & (left < right), ~level & (left > right)
    grows, shrinks = ends[before], begins[at]
    for size, peak, there in (
        (left, True, (grows > 0) & (down | (level & (shrinks < 0)))),
        (left, False, (grows < 0) & (up | (level & (shrinks > 0))) & bent[1, before]),
        (right, True, up & (shrinks < 0)),
        (right, False, down & (shrinks > 0) & bent[0, at]),
    ):
        table.append((at[there], size[there], np.full(np.count_nonzero(there), peak)))
    columns = [np.concatenate(column) for column in zip(*table, strict=True)]
    order = np.argsort(columns[0], kind="stable")
    return CurvatureExtremes(*(column[order] for column in columns))


def _size(curve: Curve, u: NDArray[np.float64] | NDArray[np.intp], side: Side) -> Floats:
    """Return |κ|, inf where the curve stands still."""
    size = np.abs(curvature(curve, u, side))
    return np.where(np.isnan(size), np.inf, size)


def _blocks(curve: Curve) -> Iterator[NDArray[np.intp]]:
    for first in range(0, curve.segment_count, _BLOCK):
        yield np.arange(first, min(first + _BLOCK, curve.segment_count))


def _meetings(curve: Curve) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the segments that end, and those that begin, at each joint where two meet."""
    at = np.arange(0 if curve.closed else 1, curve.segment_count)
    return (at - 1) % curve.segment_count, at
