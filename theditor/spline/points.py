"""Control points more and fewer, with the shape kept as well as it can be.

TH-splines have no exact knot insertion: the control points around the place are refitted by least squares,
and what that changed is measured.
"""

from collections.abc import Callable
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from theditor.spline.basis import Floats
from theditor.spline.checks import check_count, clean_indices
from theditor.spline.curve import Curve
from theditor.spline.deviation import deviation
from theditor.spline.distinct import distinct
from theditor.spline.refit import Indices, refitted
from theditor.spline.respread import AROUND, PER_SEGMENT, WORTH, respread
from theditor.spline.shape import locate

_MANY: Final = 20  # more places than this are refitted together, not one after the other
_CROWD: Final = 2  # more points than this on one edge are inserted one after the other


class Edited(NamedTuple):
    """A curve made from another one, and how far its shape is from that."""

    curve: Curve
    deviation: float  # largest distance between old and new shape, in the units of the control points


def insert(curve: Curve, u: float) -> Edited:
    """Return the curve with one control point more, its shape changed least.

    The new point lies between the two control points whose edge is the nearest to the place by its
    parameter. It and three control points on either side are refitted; points farther away stay, and so do
    the ends and every other λ. The new λ is the mean of its neighbours', a quadratic's that of the edge
    divided, unless another value at least halves the change of shape.

    Parameters
    ----------
    curve : Curve
    u : float
        Where on the curve, within its domain.

    Raises
    ------
    ValueError
        If `u` lies outside the domain.
    """
    return _resized(curve, edge_at(curve, u) + 1, 1)


def insert_many(curve: Curve, u: ArrayLike, progress: Callable[[float], None] | None = None) -> Edited:
    """Return the curve with a control point more at each of many places, all refitted together.

    As `insert` at one place after the other, but much quicker, and the new λ are those in between unless others
    at least halve the change of shape as a whole.

    Parameters
    ----------
    curve : Curve
    u : array_like, shape (k,)
        Where on the curve, within its domain.
    progress : callable, optional
        Told now and then about which share of the work is done, 0 to 1; what it raises ends the work.

    Raises
    ------
    ValueError
        If a parameter lies outside the domain.
    """
    edges = sorted(edge_at(curve, place) for place in np.ravel(u).tolist())
    if not edges:
        return Edited(curve, 0.0)
    count = len(curve.control_points)
    edge, first, of = np.unique(edges, return_index=True, return_counts=True)
    if of.max() > _CROWD:
        change = 0.0
        for number, place in enumerate(
            sorted(np.ravel(u).tolist(), reverse=True)
        ):  # those to come stay there
            if progress is not None:
                progress(number / len(edges))
            curve, more = insert(curve, place)
            change += more
        return Edited(curve, change)
    # Those on one edge divide it evenly.
    rank = np.arange(len(edges)) - np.repeat(first, of)
    places = np.repeat(edge, of) + (rank + 1) / (np.repeat(of, of) + 1)
    every: Floats = np.concatenate((np.arange(float(count)), places))
    order = np.argsort(every, kind="stable")
    between = np.array([_lambda_between(curve, index + 1) for index in edges])
    lambdas = np.concatenate((curve.lambdas, between))[order]
    return Edited(*respread(curve, every[order], lambdas, order >= count, progress))


def edge_at(curve: Curve, u: float) -> int:
    """Return the polygon's edge on which a point inserted at `u` goes."""
    segment, t = locate(curve, u)
    edge = segment + curve.first_segment
    if curve.degree == 2 and t < 0.5:
        edge -= 1  # a quadratic's segment bends round a point, from one edge to the next
    count = len(curve.control_points)
    return edge % count if curve.closed else min(max(edge, 0), count - 2)


def insert_on_edge(curve: Curve, edge: int, fraction: float = 0.5) -> Edited:
    """Return the curve with one control point more on an edge of its polygon, all others left alone.

    Parameters
    ----------
    curve : Curve
    edge : int
        From control point `edge` to the next one; on a closed curve the last edge leads back to the first.
    fraction : float
        How far along the edge, from 0 to 1.

    Raises
    ------
    ValueError
        If there is no such edge, or `fraction` is not from 0 to 1.
    """
    count = len(curve.control_points)
    (index,) = clean_indices(edge, count if curve.closed else count - 1, "edge").tolist()
    if not 0 <= fraction <= 1:
        raise ValueError(f"fraction must be from 0 to 1 along the edge, not {fraction!r}")
    points = curve.control_points
    new = (1 - fraction) * points[index] + fraction * points[(index + 1) % count]
    grown = curve.with_(
        control_points=np.insert(points, index + 1, new, axis=0),
        lambdas=np.insert(curve.lambdas, index + 1, _lambda_between(curve, index + 1)),
    )
    start, end = index + 2 - curve.degree - curve.first_segment, index + 2 - curve.first_segment
    return Edited(grown, deviation(curve, grown, _within(curve, start, end), _within(grown, start, end + 1)))


def remove(
    curve: Curve, indices: ArrayLike, refit: bool = True, progress: Callable[[float], None] | None = None
) -> Edited:
    """Return the curve with some control points fewer.

    Points at the ends of an open curve take the end with them; the others are taken out run by run, those of
    more than 20 runs together.

    Parameters
    ----------
    curve : Curve
    indices : int or array_like of int
        Which control points.
    refit : bool
        Whether three control points on either side of each run are refitted, so that the shape changes
        least, or all are left alone.
    progress : callable, optional
        Told now and then about how many runs are refitted; what it raises ends the work.

    Raises
    ------
    ValueError
        If there is no such control point, or fewer would stay than the curve needs.
    """
    count = len(curve.control_points)
    where = distinct(clean_indices(indices, count, "control point"))
    check_count(count - len(where), curve.degree, curve.closed, curve.ends)
    if not len(where):
        return Edited(curve, 0.0)
    stay = np.setdiff1d(np.arange(count), where)
    result = curve
    runs = _runs(where, stay)
    if refit and len(runs) > _MANY:
        result, change = _without_many(
            curve, stay, lambda share: progress(share * len(runs)) if progress is not None else None
        )
        if curve.closed or (stay[0] == 0 and stay[-1] == count - 1):
            return Edited(result, change)
    elif refit:
        for number, run in enumerate(reversed(runs)):
            if progress is not None:
                progress(number)
            result = _without(result, run)
    else:
        result = curve.with_(control_points=curve.control_points[stay], lambdas=curve.lambdas[stay])
    return Edited(result, deviation(curve, result, *_matched(curve, where, stay)))


def _matched(curve: Curve, where: Indices, stay: Indices) -> tuple[Floats, Floats]:
    """Return parameters before and after points went, around where they were; see `deviation`."""
    reach = AROUND + curve.degree
    low, high = int(where[0]) - reach - curve.first_segment, int(where[-1]) + reach - curve.first_segment
    count, fewer = curve.segment_count, len(where)
    if low < 0 or high > count:
        low, high = (0, count) if curve.closed else (max(low, 0), min(high, count))
    u, v = stay - curve.first_segment, np.arange(len(stay)) - curve.first_segment
    inner = (u > low) & (u < high) & (v > low) & (v < high - fewer)
    return np.array([low, *u[inner], high]), np.array([low, *v[inner], high - fewer])


def _runs(where: Indices, stay: Indices) -> list[Indices]:
    """Return consecutive indices together."""
    return np.split(where, np.flatnonzero(np.diff(where) > 1) + 1)


def _without_many(curve: Curve, stay: Indices, progress: Callable[[float], None]) -> Edited:
    """Return the curve with only some control points, those around the others refitted together."""
    count = len(curve.control_points)
    begin, end = (0, count) if curve.closed else (int(stay[0]), int(stay[-1]) + 1)
    # The ends of an open curve go with their points.
    inner = curve.with_(control_points=curve.control_points[begin:end], lambdas=curve.lambdas[begin:end])
    places = (stay - begin).astype(np.float64)
    fresh = np.zeros(len(stay), dtype=np.bool_)
    return Edited(*respread(inner, places, curve.lambdas[stay], fresh, progress))


def _without(curve: Curve, run: Indices) -> Curve:
    """Return the curve without consecutive control points, those around them refitted."""
    count = len(curve.control_points)
    if not curve.closed and (run[0] == 0 or run[-1] == count - 1):
        return curve.with_(
            control_points=np.delete(curve.control_points, run, axis=0), lambdas=np.delete(curve.lambdas, run)
        )
    return _resized(curve, int(run[0]), -len(run)).curve


def _resized(curve: Curve, at: int, change: int) -> Edited:
    """Return the curve with one control point more before `at` (change = 1), or −change fewer from there on.

    The points around are refitted.
    """
    if not curve.closed:
        return _rebuilt(curve, at, change)
    # Turned so that the place lies in the middle, then back.
    count = len(curve.control_points)
    middle = (count + min(change, 0)) // 2
    order = np.roll(np.arange(count), middle - at)
    edited = _rebuilt(_turned(curve, at - middle), middle, change)
    order = (
        np.insert(order, middle, count) if change > 0 else np.delete(order, slice(middle, middle - change))
    )
    return Edited(_turned(edited.curve, int(order.argmin())), edited.deviation)


def _turned(curve: Curve, start: int) -> Curve:
    """Return a closed curve that begins with another of its control points."""
    return curve.with_(
        control_points=np.roll(curve.control_points, -start, axis=0), lambdas=np.roll(curve.lambdas, -start)
    )


def _rebuilt(curve: Curve, at: int, change: int) -> Edited:
    """As `_resized`, for a place that is not near a closed curve's seam."""
    start, free = _renumbered(curve, at, change)
    first, count, new_count = curve.first_segment, curve.segment_count, start.segment_count
    if len(free) in (0, len(start.control_points)):
        low, high = 0, new_count
    else:
        low, high = int(free[0]) - first - curve.degree + 1, int(free[-1]) - first + 2
    interval, new_interval = _within(curve, low, high - change), _within(start, low, high)
    u = np.linspace(*interval, PER_SEGMENT * (interval[1] - interval[0]) + 1)
    v = np.interp(u, interval, new_interval)
    held = np.zeros(len(u), dtype=np.bool_)
    if not curve.closed:
        held = (u == 0) | (u == count)
    targets = curve(u % count if curve.closed else u)
    fitted, v = refitted(start, targets, v, free, held=held) if len(free) else (start, v)
    best = Edited(fitted, deviation(curve, fitted, interval, new_interval))
    if change > 0 and start.active_lambdas[at]:
        fitted, _ = refitted(fitted, targets, v, free, np.array([at]), held)
        apart = deviation(curve, fitted, interval, new_interval)
        if apart <= WORTH * best.deviation:
            best = Edited(fitted, apart)
    return best


def _renumbered(curve: Curve, at: int, change: int) -> tuple[Curve, Indices]:
    """Return the curve to start from, and the control points of it that are free.

    These are spread evenly over the part of the polygon that they replace.
    """
    points, lambdas = curve.control_points, curve.lambdas
    count = len(points) + change
    low, high = at - AROUND, at + AROUND - (change < 0)
    if curve.closed and high - low + 1 >= count:
        low, high = 0, count - 1
        before, after = 0, count
    else:
        kept = int(not curve.closed and curve.ends == "clamped")
        if not curve.closed:
            low, high = max(low, kept), min(high, count - 1 - kept)
        before, after = (low - 1, high + 1) if curve.closed else (max(low - 1, 0), min(high + 1, count - 1))
    free = np.arange(low, high + 1)
    places = before + (free - before) * (after - change - before) / max(after - before, 1)
    around = np.arange(-1, len(points) + 2)
    polygon = points[around % len(points)]
    spread = np.stack([np.interp(places, around, x) for x in polygon.T], axis=1)
    if change > 0:
        lambdas = np.insert(lambdas, at, _lambda_between(curve, at))
    else:
        lambdas = np.delete(lambdas, slice(at, at - change))
    points = np.concatenate((points[:low], spread, points[high + 1 - change :]))
    return curve.with_(control_points=points, lambdas=lambdas), free


def _lambda_between(curve: Curve, at: int) -> float:
    """Return the λ for a new control point before `at`: a quadratic's edge hands on its own."""
    pair = np.array([at - 1, at]) % len(curve.lambdas)
    if curve.degree == 2:
        pair = pair[1:]
    active = pair[curve.active_lambdas[pair]]
    return float(np.mean(curve.lambdas[active if len(active) else pair]))


def _within(curve: Curve, low: int, high: int) -> tuple[int, int]:
    """Return an interval cut down to the domain; a closed curve's may run over the seam."""
    return (low, high) if curve.closed else (max(low, 0), min(high, curve.segment_count))
