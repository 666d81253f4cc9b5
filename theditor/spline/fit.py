"""A curve through a stroke: as few control points as keep it within a tolerance."""

from collections.abc import Callable, Sequence
from math import e, pi, sinh
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from theditor.spline import strokes
from theditor.spline.basis import CONVEX_HULL_RANGE, JOINT_SLOPE_ZERO, Floats, check_degree
from theditor.spline.checks import check_closed, check_ends, clean_points
from theditor.spline.curve import Curve, Ends
from theditor.spline.pieces import with_free_ends
from theditor.spline.refit import Indices, design, refitted

_MOST: Final = 200  # free control points between two corners
_TARGETS: Final = 8  # points of the stroke that count, for each control point
_FEWEST_TARGETS: Final = 64
_STEPS: Final = 5  # of the least squares
_GRADED: Final = 4.0  # steps from control point to control point that are shorter near a corner
_AT_CORNER: Final = 0.03  # of a step
LIKE_POLYNOMIALS: Final = {
    2: (1 - pi / 4) / ((e + 1) / (2 * (e - 1)) - pi / 4),
    3: (1 / 3 - 1 / pi) / (1 / 2 - 1 / pi - e / (e - 1) ** 2 * (sinh(1) - 1)),
}
"""The λ, by degree, with which a curve is nearest to the ordinary uniform B-spline.

Its joints are the same, a quadratic's velocities there."""
_BOUNDS: Final = (JOINT_SLOPE_ZERO, CONVEX_HULL_RANGE[3][1])  # λ without cusps and within the hull


class _Start(NamedTuple):
    """Where a fit begins."""

    curve: Curve
    free: Indices
    s: Floats  # (n,) lengths along the stroke, of the points that count
    u: Floats  # (n,) about where the curve is to meet them
    held: bool = (
        False  # whether the first and last point are to be met as they are, by control points that may move
    )


class Fitted(NamedTuple):
    """A curve made from points, and how well it fits."""

    curve: Curve
    deviation: float  # largest distance of a point from the curve, or of the curve from the polyline


class _Met(NamedTuple):
    """A fit, and where the curve meets the stroke's points."""

    fitted: Fitted
    u: Floats  # (n,)


def fit(
    points: ArrayLike,
    degree: int = 3,
    tolerance: float = 1.0,
    closed: bool = False,
    ends: Ends = "clamped",
    shape: bool = True,
    corners: bool | Sequence[int] = True,
    lam: float = 0.0,
    progress: Callable[[], object] | None = None,
) -> Fitted:
    """Return a curve along a stroke or samples, with as few control points as meet a tolerance.

    The number of control points is found by bisection, each by least squares with parameter correction. The
    curve of an open stroke begins and ends at its first and last point.

    Parameters
    ----------
    points : array_like, shape (n, 2) or (n, 3)
        In order; repeated ones count once.
    degree : {2, 3}
    tolerance : float
        How far the points may be from the curve, and the curve from the polyline through them; positive.
        Where 200 control points between two corners do not meet it, the closest curve found is returned.
    closed : bool
        Whether the stroke runs round.
    ends : {"free", "clamped"}
        With free ends the outer control points of a cubic are fitted as well, which spares it the zero curvature
        of clamped ends, unless it has corners. Otherwise they are the reflected ones of the clamped curve.
    shape : bool
        Whether λ is fitted too, where that saves control points; otherwise all are `lam`.
    corners : bool or sequence of int
        Whether turns of more than 60° within four tolerances become corners: repeated control points. Or which
        points are to be corners, ascending; then no point may repeat the one before.
    lam : float
        The λ of all control points, or that from which they are fitted. With `LIKE_POLYNOMIALS` of the degree
        a smooth outline needs fewest control points where the tolerance is tight.
    progress : callable, optional
        Called before each attempt; what it raises ends the work.

    Raises
    ------
    ValueError
        If there are fewer than two different points (three of a closed stroke), or an argument makes no sense.
    """
    check_degree(degree)
    check_closed(closed)
    check_ends(ends)
    if not 0 < tolerance < np.inf:
        raise ValueError(f"tolerance must be a positive number, not {tolerance!r}")
    given = clean_points(points)
    stroke = strokes.cleaned(given, closed)
    if isinstance(corners, bool):
        at = strokes.corners(stroke, tolerance, closed) if corners else []
    else:
        at = _corners_given(corners, given, stroke, closed)
    if closed and not at:
        return _fewest(
            stroke, lambda count: _ring(stroke, count, degree, tolerance, lam), 3, tolerance, shape, progress
        ).fitted
    if ends == "free" and degree == 3 and not closed and not at:
        return _fit_loose(stroke, tolerance, shape, lam, progress).fitted
    parts = strokes.parts(stroke, at, closed)
    last = len(parts) - 1
    met = [
        _fit_part(part, degree, tolerance, shape, lam, closed or i > 0, closed or i < last, progress)
        for i, part in enumerate(parts)
    ]
    curve, where = _assembled(met, closed)
    if ends == "free" and not closed:
        curve = with_free_ends(curve)
    # As a whole: a part of the stroke may have come nearer to another part of the curve.
    return Fitted(curve, strokes.distance(np.concatenate(parts), curve, where))


def _corners_given(corners: Sequence[int], given: Floats, stroke: Floats, closed: bool) -> list[int]:
    """Return the corners that were asked for, if there can be corners there."""
    if len(given) != len(stroke):
        raise ValueError("with corners given, no point may repeat the one before it")
    at = [int(index) for index in corners]
    inner = range(len(stroke)) if closed else range(1, len(stroke) - 1)
    if sorted(set(at)) != at or not set(at) <= set(inner):
        raise ValueError(f"corners must be ascending indices from {inner.start} to {inner.stop - 1}")
    return at


def _fit_part(
    part: Floats,
    degree: int,
    tolerance: float,
    shape: bool,
    lam: float,
    corner_before: bool,
    corner_after: bool,
    progress: Callable[[], object] | None,
) -> _Met:
    """Return a clamped curve along a stroke without corners, its first or last point twice at a corner."""
    least = 1 if degree == 2 and not (corner_before or corner_after) else 0

    s, efforts = strokes.effort(part, tolerance)

    def start(count: int) -> _Start:
        places = _places(count, degree, corner_before, corner_after)
        free = np.arange(1 + corner_before, len(places) - 1 - corner_after)
        spread = np.interp(places * (efforts[-1] / places[-1]), efforts, s)
        control = strokes.along(part, spread)
        control[[0, -1]] = part[[0, -1]]
        if corner_before:
            control[1] = control[0]
        if corner_after:
            control[-2] = control[-1]
        curve = Curve(control, lam, degree, ends="clamped")
        targets = _targets(spread)
        # A quadratic's segment has its control point in its middle.
        met = np.clip(np.arange(len(places)) - (degree == 2) / 2, 0, curve.segment_count)
        return _Start(curve, free, targets, np.interp(targets, spread, met))

    return _fewest(part, start, least, tolerance, shape, progress)


def _places(count: int, degree: int, corner_before: bool, corner_after: bool) -> Floats:
    """Return where along a stroke its control points begin, in steps: the second one at a corner is hardly on its way.

    Steps are shorter towards a corner, and towards a cubic's clamped end, since the curve is straight there. A
    quadratic's first edge counts twice, so that half of one does.
    """
    apart = np.arange(count + 1.0)
    steps = np.ones(count + 1)
    for corner, away in ((corner_before, apart), (corner_after, apart[::-1])):
        if corner or degree == 3:
            steps *= np.minimum((away + 1) / _GRADED, 1)
        elif count:
            steps[away == 0] /= 2
    places = np.append(0.0, np.cumsum(steps))
    if corner_before:
        places = np.insert(places, 1, _AT_CORNER)
    if corner_after:
        places = np.insert(places, -1, places[-1] - _AT_CORNER)
    return places


def _fit_loose(
    stroke: Floats, tolerance: float, shape: bool, lam: float, progress: Callable[[], object] | None
) -> _Met:
    """Return a cubic with free ends along an open stroke without corners."""
    s, efforts = strokes.effort(stroke, tolerance)

    def start(count: int) -> _Start:
        places = np.linspace(0, 1, count + 2)
        spread = np.interp(places, efforts, s)
        curve = with_free_ends(Curve(strokes.along(stroke, spread), lam, ends="clamped"))
        targets = _targets(spread)
        u = np.interp(targets, spread, np.arange(len(places)))
        return _Start(curve, np.arange(len(curve.control_points)), targets, u, held=True)

    curve, deviation = (met := _fewest(stroke, start, 0, tolerance, shape, progress)).fitted
    # Held points are met nearly; the outermost control points make it exact.
    points = curve.control_points.copy()
    for end, u in ((0, 0), (-1, curve.segment_count)):
        _, weights = design(curve, np.array([float(u)]))
        points[end] += (stroke[end] - curve(u)) / weights[0, end]
    return _Met(Fitted(curve.with_(control_points=points), deviation), met.u)


def _ring(stroke: Floats, count: int, degree: int, tolerance: float, lam: float) -> _Start:
    """Return the like for a closed stroke without corners."""
    line = np.concatenate((stroke, stroke[:1]))
    s, efforts = strokes.effort(line, tolerance)
    # A quadratic's segment lies around its point, a cubic's begins at it.
    shift = (degree == 2) / 2
    control = strokes.along(line, np.interp((np.arange(count) + shift) / count, efforts, s))
    targets = _targets(np.interp(np.arange(count + 1) / count, efforts, s))[:-1]
    u = np.interp(targets, s, efforts) * count
    return _Start(Curve(control, lam, degree, closed=True), np.arange(count), targets, u)


def _targets(spread: Floats) -> Floats:
    """Return lengths along a stroke, enough between those of any two control points to determine both."""
    each = max(_TARGETS, -(-_FEWEST_TARGETS // (len(spread) - 1)))
    places = np.arange(len(spread))
    return np.interp(np.linspace(0, places[-1], each * places[-1] + 1), places, spread)


def _fewest(
    stroke: Floats,
    start: Callable[[int], _Start],
    least: int,
    tolerance: float,
    shape: bool,
    progress: Callable[[], object] | None,
) -> _Met:
    """Return the fit with the fewest free control points that meets the tolerance, or the closest one."""

    def attempt(count: int, bent: bool = False) -> _Met:
        if progress is not None:
            progress()
        curve, free, s, u, at_ends = start(count)
        line = np.concatenate((stroke, stroke[:1])) if curve.closed else stroke
        if len(free):
            targets = strokes.along(line, s)
            lambdas = free if bent else None
            held = np.isin(np.arange(len(u)), (0, len(u) - 1)) & at_ends
            curve, u = refitted(curve, targets, u, free, lambdas, held, _STEPS, _BOUNDS)
        where = np.interp(strokes.lengths(line)[: len(stroke)], s, u)
        return _Met(Fitted(curve, strokes.distance(stroke, curve, where)), where)

    count, too_few, best = least, least - 1, attempt(least)
    while best.fitted.deviation > tolerance and count < _MOST:
        too_few, count = count, min(max(2 * count, 1), _MOST)
        best = min(best, attempt(count), key=lambda met: met.fitted.deviation)
    if best.fitted.deviation > tolerance:
        return best
    while count - too_few > 1:
        middle = (count + too_few) // 2
        fewer = attempt(middle)
        if fewer.fitted.deviation <= tolerance:
            count, best = middle, fewer
        else:
            too_few = middle
    while shape and count > least:
        fewer = attempt(count - 1, bent=True)
        if fewer.fitted.deviation > tolerance:
            break
        count, best = count - 1, fewer
    return best


def _assembled(met: list[_Met], closed: bool) -> tuple[Curve, Floats]:
    """Return one curve of clamped ones, and where it meets their points.

    They meet at corners, each with its own two copies of the point there.
    """
    curves = [piece.fitted.curve for piece in met]
    degree = curves[0].degree
    shared = 4 - degree
    first = shared if closed else 0
    points = [curves[0].control_points[first:], *(piece.control_points[shared:] for piece in curves[1:])]
    lambdas = [curves[0].lambdas[first:], *(piece.lambdas[shared:] for piece in curves[1:])]
    whole = Curve(np.concatenate(points), np.concatenate(lambdas), degree, closed, "clamped")
    begins = np.cumsum([-int(closed), *(piece.segment_count for piece in curves[:-1])])
    where = np.concatenate([piece.u + begin for piece, begin in zip(met, begins, strict=True)])
    return whole, where % whole.segment_count if closed else where
