"""How far two curves lie apart as shapes, whatever their parameters."""

from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline.basis import Floats
from theditor.spline.curve import Curve
from theditor.spline.distinct import distinct
from theditor.spline.geometry import nearest
from theditor.spline.joints import take_segments
from theditor.spline.polylines import nearest_on_line
from theditor.spline.refit import feet
from theditor.spline.sampling import sample_adaptively

_PER_SEGMENT: Final = 32
_COARSE: Final = 8  # steps between the points that are measured first
_REACH: Final = 3.0  # segments on either side of where a foot is expected
_COARSELY: Final = 0.02  # of a distance: how near chords are where feet are looked for on the whole curve
_CHORD: Final = 0.125  # of a segment: how far apart they are looked for
_BLOCK: Final = 1024  # points at a time
_ROUNDING: Final = 1e-14


def deviation(a: Curve, b: Curve, u: ArrayLike, v: ArrayLike, both: bool = True) -> float:
    """Return the largest distance between corresponding parts of two curves.

    Each of 32 points a segment, and both ends, is measured to the nearest point of the whole other curve, so
    the result is the Hausdorff distance between them but for what lies between these points.

    Parameters
    ----------
    a, b : Curve
    u, v : array_like, shape (k,)
        Ascending parameters of a, and those of b that correspond to them more or less: from the first to the
        last is the part that counts. Those of a closed curve may run over its seam.
    both : bool
        Whether the points of b count as well as those of a.
    """
    u, v = np.asarray(u, dtype=np.float64), np.asarray(v, dtype=np.float64)
    changed = _changed(a, b, u, v)
    found = _one_way(a, b, u, v, changed)
    return max(found, _one_way(b, a, v, u, changed)) if both else found


def _one_way(a: Curve, b: Curve, u: Floats, v: Floats, changed: NDArray[np.intp] | None) -> float:
    """Return the largest distance of points of a, in all or in some of its segments from u on, to b.

    A curve leaves the chord of an interval by at most h²/8·max|C''|. So no point between two of a is farther from
    b than the farther one of these, and what both curves leave their chords by: only intervals where that is more
    than has been found are divided.
    """
    steps = int(np.ceil(_PER_SEGMENT * (u[-1] - u[0])))
    step = (u[-1] - u[0]) / max(steps, 1)
    found = 0.0

    def measured(index: NDArray[np.intp], expected: Floats) -> Floats:
        """Return parameters of the points, their feet, and their distances, (3, n)."""
        nonlocal found
        where = u[0] + index * step
        points = a(_round(a, where))
        foot = feet(b, points, expected if b.closed else _round(b, expected))
        gap = np.linalg.norm(b(_round(b, foot)) - points, axis=1)
        found = farthest(points, b, foot, found)
        return np.stack((where, foot, gap))

    if changed is None:
        begin = np.arange(0, max(steps, 1), _COARSE)
    else:
        begin = (changed[:, None] * _PER_SEGMENT + np.arange(0, _PER_SEGMENT, _COARSE)).ravel()
    end = np.minimum(begin + _COARSE, steps)
    index = distinct(np.concatenate((begin, end)))
    all_ends = measured(index, np.interp(u[0] + index * step, u, v))
    start, stop = all_ends[:, np.searchsorted(index, begin)], all_ends[:, np.searchsorted(index, end)]
    while True:
        most = (
            np.maximum(start[2], stop[2])
            + _off_chord(a, start[0], stop[0])
            + _off_chord(b, start[1], stop[1])
        )
        divided = np.flatnonzero((most > found) & (end - begin > 1))
        if not len(divided):
            return found
        begin, end, start, stop = begin[divided], end[divided], start[:, divided], stop[:, divided]
        middle = (begin + end) // 2
        between = measured(middle, (start[1] + stop[1]) / 2)
        begin, end = np.concatenate((begin, middle)), np.concatenate((middle, end))
        start, stop = np.hstack((start, between)), np.hstack((between, stop))


def _off_chord(curve: Curve, start: Floats, stop: Floats) -> Floats:
    """Return how far a curve can get from its chords between parameters, which may count round; ∞ if they are long."""
    low, high = np.minimum(start, stop), np.maximum(start, stop)
    first, last = np.floor(low), np.ceil(high) - 1
    count = curve.segment_count
    segments = np.stack((first, last)).astype(np.intp)
    segments = segments % count if curve.closed else np.clip(segments, 0, count - 1)
    bend = curve.turning[segments].max(axis=0)
    return np.where(last - first > 1, np.inf, (high - low) ** 2 / 8 * bend)


def farthest(points: Floats, curve: Curve, u: Floats, least: float = 0.0) -> float:
    """Return the largest of the distances of points to a curve, or `least` if none is larger.

    Parameters
    ----------
    points : ndarray, shape (n, d)
    curve : Curve
    u : ndarray, shape (n,)
        About where on the curve their feet are to be expected, which saves time and changes no result.
    """
    # No point is farther than from where it is expected: those that can be farthest come first.
    most = np.linalg.norm(curve(_round(curve, u)) - points, axis=1)
    order = np.flatnonzero(most > least)
    order = order[np.argsort(-most[order])]
    nothing = _ROUNDING * float(np.abs(curve.control_points).max())
    found = least
    for i in range(0, len(order), _BLOCK):
        block = order[i : i + _BLOCK]
        if most[block[0]] <= max(found, nothing):
            return max(found, float(most[block[0]])) if most[block[0]] <= nothing else found
        foot, distances = _near(points[block], curve, u[block])
        # These feet are local: only where the largest is confirmed by the global minimum is it the answer.
        everywhere = False
        while distances[worst := int(np.argmax(distances))] > max(found, nothing):
            true = float(nearest(curve, points[block[worst]], near=foot[worst])[1])
            if true >= distances[worst] * (1 - 1e-9):
                found = true
                break
            distances[worst] = true
            if not everywhere:
                # So others are likely to be nearer to another part of the curve, too.
                everywhere = True
                far = np.flatnonzero(distances > max(found, nothing))
                start = _nearest_chord(points[block[far]], curve, _COARSELY * float(distances.max()))
                foot[far], distances[far] = _nearer(
                    points[block[far]], curve, start, foot[far], distances[far]
                )
        else:
            found = max(found, float(distances[worst]))
    return found


def _changed(a: Curve, b: Curve, u: Floats, v: Floats) -> NDArray[np.intp] | None:
    """Return which segments of a, from u on, differ from those of b, from v on; None if they do not correspond."""
    first, last = np.array([u[0], v[0]]), np.array([u[-1], v[-1]])
    even = len(u) == len(v) == 2 and (first == np.floor(first)).all() and np.ptp(last - first) == 0
    if not even or a.degree != b.degree or u[1] - u[0] != np.floor(u[1] - u[0]):
        return None
    steps = np.arange(int(u[1] - u[0]))
    same = np.ones(len(steps), dtype=np.bool_)
    parts = (
        take_segments(curve, (int(start) + steps) % curve.segment_count)
        for curve, start in ((a, u[0]), (b, v[0]))
    )
    for one, other in zip(*parts, strict=True):
        same &= (one == other).all(axis=0) if one.ndim == 2 else one == other
    return np.flatnonzero(~same)


def _near(points: Floats, curve: Curve, u: Floats) -> tuple[Floats, Floats]:
    """Return local feet of points on a curve, begun at the nearest of its chords around u, and how far these are."""
    around = u[:, None] + np.arange(-_REACH, _REACH + 0.1, _CHORD)
    corners = curve(_round(curve, around))
    chords, gaps = np.diff(corners, axis=1), points[:, None] - corners[:, :-1]
    lengths = np.einsum("nkd,nkd->nk", chords, chords)
    t = np.einsum("nkd,nkd->nk", chords, gaps)
    t = np.clip(np.divide(t, lengths, out=np.zeros_like(t), where=lengths > 0), 0, 1)
    gaps -= t[:, :, None] * chords
    best = np.einsum("nkd,nkd->nk", gaps, gaps).argmin(axis=1)[:, None]
    start = np.take_along_axis(around, best, axis=1) + _CHORD * np.take_along_axis(t, best, axis=1)
    before = _round(curve, u)
    return _nearer(points, curve, start[:, 0], before, np.linalg.norm(curve(before) - points, axis=1))


def _nearest_chord(points: Floats, curve: Curve, tolerance: float) -> Floats:
    """Return about where on the whole curve points are nearest, by chords that are within a tolerance."""
    samples = sample_adaptively(curve, tolerance)
    places, _ = nearest_on_line(points, samples.points)
    segment = np.searchsorted(samples.starts, places, side="right") - 1
    t = (places - samples.starts[segment]) / samples.intervals[segment]
    return np.asarray(samples.segments[segment] + np.minimum(t, 1.0), dtype=np.float64)


def _nearer(
    points: Floats, curve: Curve, start: Floats, foot: Floats, distances: Floats
) -> tuple[Floats, Floats]:
    """Return the feet of points found from some starts and their distances, or those known if they are nearer."""
    new = _round(curve, feet(curve, points, _round(curve, start), 6))
    apart = np.linalg.norm(curve(new) - points, axis=1)
    nearer = apart <= distances
    return np.where(nearer, new, foot), np.where(nearer, apart, distances)


def _round(curve: Curve, u: Floats) -> Floats:
    """Return parameters within the domain: counted round, or the nearest end."""
    return np.mod(u, curve.segment_count) if curve.closed else np.clip(u, 0, curve.segment_count)
