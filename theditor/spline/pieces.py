"""Curves cut, joined, opened and closed, with the shape kept.

Curves with free ends lie end to end without a seam when they share `degree` control points, so a cut at a
joint is exact, and so is joining again what was cut. A clamped end is a free one with its reflected control
point written out.
"""

from typing import Final, NamedTuple

import numpy as np

from theditor.spline.basis import Floats
from theditor.spline.curve import Curve
from theditor.spline.deviation import deviation
from theditor.spline.distinct import distinct
from theditor.spline.points import Edited
from theditor.spline.refit import refitted
from theditor.spline.shape import locate

_AROUND: Final = 3  # control points refitted on either side of a seam
_PER_SEGMENT: Final = 16  # samples of the old shapes
_TOUCH: Final = 1e-9  # gap between ends, relative to the coordinates, that is none
_TURN: Final = 0.1  # sine of a turn from which ends make a corner


class Split(NamedTuple):
    """Two curves made from one, and how far their shape is from its."""

    first: Curve
    second: Curve
    deviation: float  # nothing but rounding


def with_free_ends(curve: Curve) -> Curve:
    """Return the same open curve with free ends, the reflected control points of clamped ones written out."""
    if curve.closed or curve.ends == "free":
        return curve
    points, lambdas = curve.control_points, curve.lambdas
    first, last = 2 * points[0] - points[1], 2 * points[-1] - points[-2]
    if curve.degree == 2:
        points = np.concatenate(([first], points[1:-1], [last]))
    else:
        points = np.concatenate(([first], points, [last]))
        # The λ at a clamped end has no effect, but a say in the segment's mode from now on.
        lambdas = np.pad(lambdas[1:-1], 2, "edge") if len(lambdas) > 2 else np.pad(lambdas, 1, "edge")
    return curve.with_(control_points=points, lambdas=lambdas, ends="free")


def stretch(curve: Curve, first: int, last: int) -> Curve:
    """Return an open curve with free ends that consists of segments `first` to `last` of a curve alone."""
    free = with_free_ends(curve)
    begin = first + free.first_segment - 1
    where = np.arange(begin, begin + last - first + curve.degree + 1) % len(free.control_points)
    return Curve(free.control_points[where], free.lambdas[where], curve.degree)


def split(curve: Curve, u: float) -> Split:
    """Return the two parts of an open curve before and after a joint, both with free ends; this is exact.

    Parameters
    ----------
    curve : Curve
    u : float
        The joint: a whole number within the domain, not one of its ends.

    Raises
    ------
    ValueError
        If the curve is closed, or there is no joint at `u` between two segments.
    """
    if curve.closed:
        raise ValueError("a closed curve has no two parts: open it at the joint instead")
    joint = _joint(curve, u)
    if not 0 < joint < curve.segment_count:
        raise ValueError(f"u = {joint} is an end of the curve: split at a joint between two segments")
    free = with_free_ends(curve)
    start, end = slice(joint + curve.degree), slice(joint, None)
    first, second = (
        free.with_(control_points=free.control_points[part], lambdas=free.lambdas[part])
        for part in (start, end)
    )
    count = curve.segment_count
    apart = max(
        deviation(first, curve, (0, joint), (0, joint)),
        deviation(second, curve, (0, count - joint), (joint, count)),
    )
    return Split(first, second, apart)


def opened(curve: Curve, u: float = 0) -> Edited:
    """Return a closed curve cut at a joint: open, with free ends that meet there; this is exact.

    Raises
    ------
    ValueError
        If the curve is open already, or there is no joint at `u`.
    """
    if not curve.closed:
        raise ValueError("the curve is open already: split it at a joint instead")
    count = len(curve.control_points)
    order = np.arange(_joint(curve, u) - 1, _joint(curve, u) - 1 + count + curve.degree) % count
    cut = Curve(curve.control_points[order], curve.lambdas[order], curve.degree)
    return Edited(cut, deviation(curve, cut, (u, u + count), (0, count)))


def closed(curve: Curve) -> Edited:
    """Return an open curve closed.

    Where its ends meet, they become one joint: exactly where the curve was opened, otherwise with the control
    points around refitted. Where they lie apart, `degree` segments more lead from the end to the start, the curve
    itself stays, and the deviation is of it alone.

    Raises
    ------
    ValueError
        If the curve is closed already.
    """
    if curve.closed:
        raise ValueError("the curve is closed already")
    free, count = with_free_ends(curve), curve.segment_count
    if count < 3 or not _touch(curve(count), curve(0)):
        ring = free.with_(closed=True)
        return Edited(ring, deviation(curve, ring, (0, count), (1, count + 1), both=False))
    ring = Curve(
        free.control_points[1 : count + 1], free.lambdas[1 : count + 1], curve.degree, True, curve.ends
    )
    if not _alike(free, free):
        seam = distinct(np.arange(-_AROUND, _AROUND + 1) % count)
        u = _samples(count)
        ring, _ = refitted(ring, curve(u), u, seam)
    return Edited(ring, deviation(curve, ring, (0, count), (0, count)))


def join(a: Curve, b: Curve) -> Edited:
    """Return one curve that runs through a and then through b.

    Where the end of a meets the start of b, they become one joint: exactly where they share `degree` control
    points, as the parts of a split curve do; otherwise with the control points around refitted, and with a
    repeated control point where they meet at a corner. Where they lie apart, `degree` segments more lead
    across, both curves stay, and the deviation is of them alone. The result is clamped if both are.

    Raises
    ------
    ValueError
        If a curve is closed, or they differ in degree or dimension.
    """
    if a.closed or b.closed:
        raise ValueError("a closed curve has no end to join: open it at a joint first")
    if (a.degree, a.dimension) != (b.degree, b.dimension):
        raise ValueError("curves to join must agree in degree and dimension: change one of them first")
    before, after = with_free_ends(a), with_free_ends(b)
    first, second = a.segment_count, b.segment_count
    meet = _touch(a(first), b(0))
    if meet:
        whole, start = _merged(before, after)
        end = start
    else:
        whole = _chained(before, after, len(before.control_points), 0)
        end, start = first, first + a.degree
    count = whole.segment_count
    if a.ends == b.ends == "clamped":
        whole = clamped_form(whole)
    apart = max(
        deviation(a, whole, (0, first), (0, end), meet),
        deviation(b, whole, (0, second), (start, count), meet),
    )
    return Edited(whole, apart)


def _merged(a: Curve, b: Curve) -> tuple[Curve, int]:
    """Return curves with free ends that meet as one, and the joint where b begins."""
    first, second, degree = a.segment_count, b.segment_count, a.degree
    if _alike(a, b):
        return _chained(a, b, first + 1, 1), first
    at, joint = first + 1, first
    if _corner(a, b):
        joint += 1
        tip = b(0)
        repeated = np.repeat(tip[None], degree, axis=0)
        points = np.concatenate((a.control_points[:at], repeated, b.control_points[degree - 1 :]))
        lambdas = np.concatenate((a.lambdas[:at], np.full(degree, a.lambdas[first]), b.lambdas[degree - 1 :]))
        whole = a.with_(control_points=points, lambdas=lambdas)
        near = [*range(at - _AROUND, at), *range(at + degree, at + degree + _AROUND)]
    else:
        whole = _chained(a, b, at, 1)
        near = [*range(at - _AROUND, at + _AROUND)]
    # The outer two control points at either end keep that end, clamped or not.
    free = np.array([i for i in near if 2 <= i < len(whole.control_points) - 2], dtype=np.intp)
    if len(free):
        u, v = _samples(first), _samples(second)
        targets = np.concatenate((a(u), b(v)))
        expected = np.concatenate((u * joint / first, joint + v * (whole.segment_count - joint) / second))
        whole, _ = refitted(whole, targets, expected, free)
    return whole, joint


def _chained(a: Curve, b: Curve, end: int, start: int) -> Curve:
    """Return the curve of a's control points up to `end` and b's from `start` on."""
    return a.with_(
        control_points=np.concatenate((a.control_points[:end], b.control_points[start:])),
        lambdas=np.concatenate((a.lambdas[:end], b.lambdas[start:])),
    )


def clamped_form(curve: Curve) -> Curve:
    """Return the clamped curve whose free form this is."""
    points, lambdas = curve.control_points, curve.lambdas
    if curve.degree == 3:
        return curve.with_(control_points=points[1:-1], lambdas=lambdas[1:-1], ends="clamped")
    ends = (points[:1] + points[1:2]) / 2, (points[-2:-1] + points[-1:]) / 2
    return curve.with_(control_points=np.concatenate((ends[0], points[1:-1], ends[1])), ends="clamped")


def _alike(a: Curve, b: Curve) -> bool:
    """Return whether the end of a is the start of b: the same control points, and λ at the joint."""
    degree = a.degree
    same = _touch(a.control_points[-degree:], b.control_points[:degree])
    return same and bool(a.lambdas[1 - degree] == b.lambdas[1])


def _corner(a: Curve, b: Curve) -> bool:
    """Return whether a ends in another direction than b begins."""
    before, after = a(a.segment_count, 1), b(0, 1)
    scale = float(np.linalg.norm(before) * np.linalg.norm(after))
    along = float(before @ after)
    return along <= 0 or scale * scale - along * along > (_TURN * scale) ** 2


def _touch(a: Floats, b: Floats) -> bool:
    size = max(float(np.abs(a).max()), float(np.abs(b).max()))
    return float(np.abs(a - b).max()) <= _TOUCH * size


def _samples(count: int) -> Floats:
    return np.linspace(0, count, _PER_SEGMENT * count + 1)


def _joint(curve: Curve, u: float) -> int:
    """Return a parameter that is a joint, or refuse it."""
    segment, t = locate(curve, u)
    if t not in (0, 1):
        raise ValueError(
            f"u = {float(u)} lies within a segment: the joints next to it are {segment} and {segment + 1}"
        )
    return segment + int(t)
