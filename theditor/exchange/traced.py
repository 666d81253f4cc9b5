"""Contours as TH-curves: exact where such a curve exists, else fitted within a tolerance.

A quadratic T segment is a quarter of an ellipse from the middle of one edge of its polygon to that of the next,
or a straight line where its points are in line. So lines, quarter turns and what is made of them smoothly, such
as ellipses and rectangles with rounded corners, are exact.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Final, Literal, NamedTuple

import numpy as np

from theditor.exchange.contour import Arc, Bezier, Contour, Floats, Piece, steps
from theditor.spline import Curve, fit
from theditor.spline.deviation import farthest
from theditor.spline.distinct import moves_on
from theditor.spline.fit import LIKE_POLYNOMIALS

_CHORD: Final = 0.05  # of the tolerance: how far from the contour the points are joined that a fit takes
_CORNER: Final = np.cos(np.radians(1))
_MOST_POINTS: Final = 1500  # that one part of a curve is fitted to at once
_CLOSE: Final = 1e-6  # of a contour's size: how well points must meet for an exact curve, measured afterwards
_ROUNDING: Final = 1e-12  # of a contour's size: a deviation below is none
_LEAST: Final = 1e-150  # a length whose square has lost its digits
_CIRCLE: Final = 0.5523  # of a handle's way to the corner, in a quarter turn drawn as a cubic Bézier
_MEANT: Final = 4e-4  # of its size: how far off such a quarter turn is

Degree = Literal[2, 3]


class Traced(NamedTuple):
    """A curve along a contour."""

    curve: Curve
    deviation: float  # largest distance between the two, 0 where the curve is exact
    meant: bool = False  # Béziers were taken for the quarters of ellipses that they stand for


class _Leg(NamedTuple):
    """A straight line, or a quarter of an ellipse and where the tangents at its ends meet."""

    start: Floats
    end: Floats
    corner: Floats | None = None
    piece: Piece | None = None  # what it is of, to be measured against
    span: tuple[float, float] = (0.0, 1.0)


def traced(contour: Contour, tolerance: float, degree: Degree = 3) -> Traced:
    """Return a curve along a contour; closed if that is, with corners where it has any.

    Lines, quarter turns of ellipses and smooth runs of them become an exact quadratic (a single line a curve of
    the degree asked for), and so do quarters drawn as cubic Béziers, which differ by 3·10⁻⁴ of their size. All
    else is fitted with the λ of `LIKE_POLYNOMIALS`. Long parts without a corner are fitted in pieces.

    Parameters
    ----------
    contour : Contour
        With at least one piece.
    tolerance : float
        Largest distance allowed where it is fitted. The closest curve is returned where that cannot be met.
    degree : {2, 3}
        Of a fitted curve.

    Raises
    ------
    ValueError
        If the contour is no more than one place.
    """
    exact = _exact(contour, tolerance, degree)
    return exact if exact is not None else _fitted(contour, tolerance, degree)


# Exact curves


def _exact(contour: Contour, tolerance: float, degree: Degree) -> Traced | None:
    legs: list[_Leg] = []
    for piece in contour.pieces:
        found = _legs(piece)
        if found is None:
            return None
        legs += found
    if not legs:
        raise ValueError("it is no more than one place")
    size = float(np.ptp([leg.start for leg in legs] + [leg.end for leg in legs], axis=0).max())
    if len(legs) == 1 and legs[0].corner is None:
        ends = [legs[0].start, legs[0].end]
        if degree == 2:
            ends.insert(1, (ends[0] + ends[1]) / 2)
        return Traced(Curve(ends, 0, degree, ends="clamped"), 0.0)
    joined = _joined(legs, contour.closed, _CLOSE * size)
    if joined is None:
        return None
    curve, places = joined
    off = _off(legs, curve, places)
    meant = any(isinstance(leg.piece, Bezier) for leg in legs if leg.corner is not None)
    if off > max(tolerance, _MEANT * size if meant else 0):
        return None
    return Traced(curve, off if off > _ROUNDING * size else 0.0, meant)


def _legs(piece: Piece) -> list[_Leg] | None:
    """Return a piece as lines and quarter turns, none of them where it has no length; None if it is neither."""
    if isinstance(piece, Arc):
        count = round(piece.angle / (np.pi / 2))
        if count == 0 or abs(piece.angle / count - np.pi / 2) > 1e-3:
            return None
        t = np.arange(count + 1) / count
        at = piece.at(t)
        if piece.angle == 2 * np.pi:
            at[-1] = at[0]
        return [
            _Leg(start, end, start + end - piece.centre, piece, span)
            for (start, end), span in zip(pairwise(at), pairwise(t.tolist()), strict=True)
        ]
    points = piece.points
    start, end = piece.ends
    chord = end - start
    length = float(np.hypot(*chord))
    if length <= _LEAST:
        return [] if len(points) == 2 else None
    handles = points[1:-1] - start
    across = handles @ (-chord[1], chord[0]) / length
    along = handles @ chord / length**2
    if (np.abs(across) <= _ROUNDING * length).all() and ((along >= 0) & (along <= 1)).all():
        return [_Leg(start, end)]
    corner = _corner_of_quarter(points) if len(points) == 4 else None
    return None if corner is None else [_Leg(start, end, corner, piece)]


def _corner_of_quarter(points: Floats) -> Floats | None:
    """Return where the tangents at the ends of a cubic Bézier meet, if it stands for a quarter of an ellipse."""
    start, first, second, end = points
    sides = np.stack([first - start, second - end], axis=1)
    area = float(sides[0, 0] * sides[1, 1] - sides[0, 1] * sides[1, 0])
    if abs(area) <= 1e-3 * float(np.prod(np.linalg.norm(sides, axis=0))):
        return None
    reach = np.linalg.solve(sides, end - start)[0]
    other = np.linalg.solve(sides, start - end)[1]
    if max(abs(1 - _CIRCLE * reach), abs(1 - _CIRCLE * other)) > 0.01:
        return None
    corner: Floats = start + reach * sides[:, 0]
    return corner


def _joined(legs: list[_Leg], closed: bool, near: float) -> tuple[Curve, list[int]] | None:
    """Return the quadratic along some legs, and the place of each leg's corner in it; None if there is none.

    The curve meets the middle of each edge of its polygon, and a control point where that is repeated.
    """
    bare = not closed and legs[0].corner is None and legs[-1].corner is None
    points: list[Floats] = []
    places: list[int] = []
    if bare:
        points.append(legs[0].start)
    elif not closed:
        points += _between(None, legs[0], near) or []
    for index, leg in enumerate(legs):
        places.append(len(points))
        if leg.corner is not None:
            points.append(leg.corner)
        if index < len(legs) - 1 or closed:
            between = _between(leg, legs[(index + 1) % len(legs)], near)
            if between is None:
                return None
            points += between
    if bare:
        points.append(legs[-1].end)
    elif not closed:
        points += _between(legs[-1], None, near) or []
    if len(points) < 3:
        return None
    return Curve(points, 0, 2, closed, "clamped" if bare else "free"), places


def _between(before: _Leg | None, after: _Leg | None, near: float) -> list[Floats] | None:
    """Return the control points around the place where one leg ends and another begins, or at an open end."""
    if before is None or after is None:
        leg = before or after
        assert leg is not None
        end = leg.start if before is None else leg.end
        return [end, end] if leg.corner is None else [2 * end - leg.corner]
    joint = before.end
    if before.corner is None and after.corner is None:
        return [joint, joint]
    if before.corner is not None and after.corner is not None:
        meet = np.hypot(*((before.corner + after.corner) / 2 - joint)) <= near
        return [] if meet else None
    # From a quarter into a line, or the other way: the next point on the line is as far off as the corner.
    corner, far = (before.corner, after.end) if after.corner is None else (after.corner, before.start)
    assert corner is not None
    point, line = 2 * joint - corner, far - joint
    # No farther than to the middle, so that the curve does not turn back where another quarter follows.
    t = float((point - joint) @ line / (line @ line))
    on_line = np.hypot(*(point - joint - t * line)) <= near
    return [point] if on_line and 0 < t <= 0.5 + 1e-9 else None


def _off(legs: list[_Leg], curve: Curve, places: list[int]) -> float:
    """Return the largest distance of the quarter turns from a curve."""
    t = np.linspace(0, 1, 129)
    points, where = [], []
    for leg, place in zip(legs, places, strict=True):
        if leg.corner is not None and leg.piece is not None:
            start, end = leg.span
            points.append(leg.piece.at(start + t * (end - start)))
            where.append(place - curve.first_segment + t)
    if not points:
        return 0.0
    return farthest(np.concatenate(points), curve, np.concatenate(where))


# Fitted curves


def _fitted(contour: Contour, tolerance: float, degree: Degree) -> Traced:
    points, corners, chord = _stroke(contour, tolerance)
    curve, deviation = fit(
        points,
        degree,
        (1 - _CHORD) * tolerance,
        contour.closed,
        "clamped" if corners else "free",
        shape=False,
        corners=corners,
        lam=LIKE_POLYNOMIALS[degree],
    )
    return Traced(curve, deviation + chord)


def _stroke(contour: Contour, tolerance: float) -> tuple[Floats, list[int], float]:
    """Return points along a contour, which of them are corners, and how far chords between them are off."""
    parts: list[Floats] = []
    corners: list[int] = []
    total, since, chord = 0, 0, 0.0
    arrived = contour.pieces[-1].directions[1] if contour.closed else None
    for piece in contour.pieces:
        leaves, arrives = piece.directions
        turns = arrived is not None and float(leaves @ arrived) < _CORNER
        if turns or since > _MOST_POINTS:
            corners.append(total)
            since = 0
        count = steps(piece, _CHORD * tolerance)
        points = piece.at(np.arange(count + 1) / count)
        corners += [total + index for index in _cusps(points)]
        parts.append(points[:-1])
        total, since, arrived = total + count, since + count, arrives
        chord = max(chord, piece.bend / (8 * count**2))
    if not contour.closed:
        parts.append(contour.pieces[-1].ends[1:])
    return *_distinct(np.concatenate(parts), corners, contour.closed), chord


def _cusps(points: Floats) -> list[int]:
    """Return which inner points of a densely sampled piece are the tips of cusps: it turns there at once."""
    moves = np.diff(points, axis=0)
    lengths = np.linalg.norm(moves, axis=1)
    straight = np.sum(moves[1:] * moves[:-1], axis=1)
    sharp = np.flatnonzero(straight < 0.5 * lengths[1:] * lengths[:-1]) + 1
    # Two in a row are one tip between points.
    return [int(index) for index in sharp if index - 1 not in sharp]


def _distinct(points: Floats, corners: list[int], closed: bool) -> tuple[Floats, list[int]]:
    """Return points without those that rounding put in the place of the one before, and the corners among them."""
    apart = moves_on(points)
    if closed and len(points) > 1 and (points[0] == points[-1]).all():
        apart[-1] = False
    places = np.cumsum(apart) - 1
    points = points[apart]
    inner = range(len(points)) if closed else range(1, len(points) - 1)
    return points, sorted({int(places[index]) for index in corners} & set(inner))
