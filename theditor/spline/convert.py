"""A curve as pieces that other programs know: exact where exactness exists, else cubic Béziers.

Straight segments are lines. Every quadratic trigonometric segment is a quarter of an ellipse, from one of two
conjugate radii to the other, and so is a cubic one without linear term; every quadratic hyperbolic segment is
a hyperbola arc, which as a point set is the rational quadratic Bézier on joint, control point, joint with
middle weight cosh ½ (an ellipse's: √½). All else is approximated within a tolerance.
"""

from enum import IntEnum
from itertools import pairwise
from math import cosh, sqrt
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline import bernstein
from theditor.spline.basis import Floats, Mode
from theditor.spline.coefficients import coefficients
from theditor.spline.cubics import cubics
from theditor.spline.curve import Curve
from theditor.spline.geometry import bounds
from theditor.spline.joints import Segments, evaluate
from theditor.spline.roots import sign_changes
from theditor.spline.turns import cross, grain, straight

TOLERANCE: Final = 1e-4
"""The default tolerance, relative to the longer side of the box around a curve."""
_THINNEST: Final = 1e-5  # axis ratio of an ellipse whose centre others find from its ends and axes
_NONE: Final = 1e-12  # of a segment's size: a linear term this small is none
_LEAST: Final = 1e-150  # of tolerances to calculate with
_EPS: Final = float(np.finfo(float).eps)


class Piece(IntEnum):
    """What a piece of an outline is."""

    LINE = 0
    ARC = 1
    CONIC = 2
    CUBIC = 3


class Outline(NamedTuple):
    """A curve as a chain of pieces; piece k runs from ``ends[k]`` to ``ends[k + 1]``.

    An arc is the quarter of an ellipse on the conjugate radii from its centre ``inner[k, 0]`` to its two ends.
    A conic is the rational quadratic Bézier with the middle point ``inner[k, 0]`` of weight ``weights[k]``. A
    cubic has the inner Bézier points ``inner[k]``.
    """

    kinds: NDArray[np.int8]  # (n,) of Piece
    ends: Floats  # (n + 1, d); of a closed curve the last is the first
    inner: Floats  # (n, 2, d), where of no use zero
    weights: Floats  # (n,), where of no use one
    segments: NDArray[np.intp]  # (n,) on which segment of the curve each piece starts
    closed: bool
    deviation: float
    """Largest distance between a cubic and the curve, measured, in units of the curve; 0 without cubics."""

    def scaled(self, scale: ArrayLike, offset: ArrayLike = 0.0) -> "Outline":
        """Return the outline with every point times `scale` plus `offset`, numbers or one for each coordinate."""
        factor, shift = np.asarray(scale, dtype=np.float64), np.asarray(offset, dtype=np.float64)
        return self._replace(ends=self.ends * factor + shift, inner=self.inner * factor + shift)

    def runs(self, breaks: NDArray[np.bool_]) -> list["Outline"]:
        """Return the outline in open parts, the first from its start, the others from where a break is.

        Parameters
        ----------
        breaks : ndarray, shape (n,)
            Before which pieces to break. Without any after the first piece it is returned whole.
        """
        cuts = np.flatnonzero(breaks[1:]) + 1
        if not len(cuts):
            return [self]
        edges = [0, *cuts.tolist(), len(breaks)]
        return [
            Outline(
                self.kinds[i:j],
                self.ends[i : j + 1],
                self.inner[i:j],
                self.weights[i:j],
                self.segments[i:j],
                False,
                self.deviation,
            )
            for i, j in pairwise(edges)
        ]


def outline(
    curve: Curve, tolerance: float | None = None, *, arcs: bool = True, conics: bool = False
) -> Outline:
    """Convert a curve into lines, elliptical arcs, rational quadratics and cubic Béziers.

    Parameters
    ----------
    curve : Curve
        In the plane or in space.
    tolerance : float, optional
        Largest distance between a cubic Bézier and the curve, in units of the curve; by default `TOLERANCE`
        of its size. Below the rounding of the coordinates it is met as far as they allow.
    arcs : bool
        Whether segments that are elliptical arcs become such, exact to rounding; a very thin one, with an
        axis ratio below 1e-5, does not.
    conics : bool
        Whether a quadratic's hyperbola arcs, and its elliptical ones that have not become arcs, become
        rational quadratics, exact to rounding.

    Returns
    -------
    Outline
        With at least one piece, in the order and sense of the curve; a segment takes one or more. Straight
        segments in a row that go on in the same direction make one line.

    Raises
    ------
    ValueError
        If the tolerance is not a positive number.
    """
    if tolerance is None:
        low, high = bounds(curve, 1e-3)
        tolerance = max(TOLERANCE * float((high - low).max()), _LEAST)
    if not 0 < tolerance < np.inf:
        raise ValueError(f"tolerance must be a positive number, not {tolerance!r}")
    parts = curve.joint_form
    joints = curve(np.arange(curve.segment_count + 1))
    if curve.closed:
        joints[-1] = joints[0]
    kinds, middles, weights = _exact(curve, joints, arcs, conics)
    whole = np.flatnonzero((kinds == Piece.ARC) | (kinds == Piece.CONIC))
    flat, bent = np.flatnonzero(kinds == Piece.LINE), np.flatnonzero(kinds == Piece.CUBIC)
    line_row, line_t, line_start = _lines(parts.take(flat), curve.degree)
    found = cubics(parts.take(bent), curve.degree, tolerance)
    row = np.concatenate((whole, flat[line_row], bent[found.row]))
    t = np.concatenate((np.zeros(len(whole)), line_t, found.t))
    ends = np.concatenate((joints[whole], line_start, found.start))
    ends[t == 0] = joints[row[t == 0]]
    inner = np.zeros((len(row), 2, curve.dimension))
    inner[: len(whole), 0] = middles[whole]
    inner[len(row) - len(found.row) :] = found.inner
    order = np.lexsort((t, row))
    row = row[order]
    ends = np.concatenate((ends[order], joints[-1:]))
    pieces = Outline(kinds[row], ends, inner[order], weights[row], row, curve.closed, found.deviation)
    return _merged(pieces)


def _exact(curve: Curve, joints: Floats, arcs: bool, conics: bool) -> tuple[NDArray[np.int8], Floats, Floats]:
    """Return of each segment its kind, (k,), the centre or middle point, (k, d), and the weight, (k,)."""
    parts, degree, codes = curve.joint_form, curve.degree, curve.mode_codes
    kinds = np.full(len(codes), Piece.CUBIC, dtype=np.int8)
    middles = np.zeros((len(codes), curve.dimension))
    weights = np.ones(len(codes))
    flat = straight(parts, degree)
    kinds[flat] = Piece.LINE
    free = np.flatnonzero((codes == 0) & ~flat)
    if arcs and len(free):
        of_these = parts.take(free)
        centre, linear, *_ = coefficients(of_these, degree, Mode.TRIGONOMETRIC)
        radii = (joints[free].T - centre, joints[free + 1].T - centre)
        size = np.sqrt((radii[0] ** 2).sum(axis=0) + (radii[1] ** 2).sum(axis=0))
        area = np.sqrt((np.atleast_2d(cross(*(radius / size for radius in radii))) ** 2).sum(axis=0))
        round_ = (area > _THINNEST) & (np.linalg.norm(linear, axis=0) <= _none(of_these))
        kinds[free[round_]] = Piece.ARC
        middles[free[round_]] = centre.T[round_]
    if conics and degree == 2:
        for code, weight in ((0, sqrt(0.5)), (1, cosh(0.5))):
            rest = (codes == code) & (kinds == Piece.CUBIC)
            kinds[rest], weights[rest] = Piece.CONIC, weight
            middles[rest] = parts.start.T[rest]
    return kinds, middles, weights


def _none(parts: Segments) -> Floats:
    """Return how long a linear term, (k,), may be for the segment still to be an ellipse's to rounding."""
    size = np.linalg.norm(parts.bend_start, axis=0) + np.linalg.norm(parts.bend_end, axis=0)
    limit: Floats = np.minimum(_NONE * size + 8 * _EPS * np.abs(parts.start).max(axis=0), 1e-9 * size)
    return limit


def _lines(parts: Segments, degree: int) -> tuple[NDArray[np.intp], Floats, Floats]:
    """Return row, t and start, (n, d), of the lines that straight segments run through, there and back."""
    spans = np.stack((parts.end - parts.start, parts.bend_start, parts.bend_end))
    lengths = np.linalg.norm(spans, axis=1)
    longest = lengths.argmax(axis=0)[None, None]
    direction = np.take_along_axis(spans, longest, axis=0)[0] / np.maximum(lengths.max(axis=0), 1e-300)
    slopes = np.einsum("dk,dkn->kn", direction, bernstein.polynomials(parts, degree, 1))
    turns = sign_changes(slopes, 8 * grain(parts), 1e-9)
    row = np.concatenate((np.arange(len(lengths[0])), turns.row))
    t = np.concatenate((np.zeros(len(lengths[0])), turns.t))
    return row, t, evaluate(parts.take(row), t, degree, 0).T


def _merged(pieces: Outline) -> Outline:
    """Return the outline without lines of no length, and with those in a row in one direction as one."""
    steps = np.diff(pieces.ends, axis=0).T
    line = pieces.kinds == Piece.LINE
    kept = ~line | (steps != 0).any(axis=0)
    kept[0] |= not kept.any()
    pieces = _chosen(pieces, kept)
    steps, line = np.diff(pieces.ends, axis=0).T, pieces.kinds == Piece.LINE
    before, after = steps[:, :-1], steps[:, 1:]
    sizes = np.linalg.norm(before, axis=0), np.linalg.norm(after, axis=0)
    area = np.sqrt((np.atleast_2d(cross(before, after)) ** 2).sum(axis=0))
    rounding = 4 * _EPS * float(np.abs(pieces.ends).max())
    # A line no longer than rounding has a direction by chance: next to it, sideways is not onward.
    along = (before * after).sum(axis=0) > sizes[0] * sizes[1] / 2
    onward = (area <= rounding * (sizes[0] + sizes[1])) & along
    return _chosen(pieces, np.append(True, ~(onward & line[:-1] & line[1:])))


def _chosen(pieces: Outline, kept: NDArray[np.bool_]) -> Outline:
    """Return the outline of only some pieces, each reaching on to where the next one starts."""
    return pieces._replace(
        kinds=pieces.kinds[kept],
        ends=pieces.ends[np.append(kept, True)],
        inner=pieces.inner[kept],
        weights=pieces.weights[kept],
        segments=pieces.segments[kept],
    )
