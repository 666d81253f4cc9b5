"""What differs between two versions of a curve, and what they have in common."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from theditor.spline.distinct import distinct

if TYPE_CHECKING:
    from theditor.spline.curve import Curve

_FIRST = 64  # rows


def changed_segments(old: "Curve", new: "Curve") -> NDArray[np.intp] | None:
    """Return which segments may differ between two curves, ascending.

    A segment counts as changed when one of the control points or active λ that define it differs. The others
    are equal to the last bit, and so are their modes.

    Returns
    -------
    ndarray of int, shape (k,), or None
        None when the curves do not correspond segment by segment: they differ in degree, ends, being closed,
        dimension or number of points.
    """
    if (old.degree, old.closed, old.ends, old.control_points.shape) != (
        new.degree,
        new.closed,
        new.ends,
        new.control_points.shape,
    ):
        return None
    count, first = new.segment_count, new.first_segment
    touched: list[NDArray[np.intp]] = []
    if old.control_points is not new.control_points:
        moved = differing_rows(old.control_points, new.control_points)
        touched.append(_within_reach(moved - first, range(1 - new.degree, 2), count, new.closed))
    if old.lambdas is not new.lambdas:
        differing = differing_rows(old.lambdas, new.lambdas)
        if new.active_lambdas.any():  # else the modes alone depend on λ
            differing = differing[new.active_lambdas[differing]]
        touched.append(_within_reach(differing - first, range(-1, 1), count, new.closed))
    return _united(touched, count)


def differing_rows(old: NDArray[Any], new: NDArray[Any]) -> NDArray[np.intp]:
    """Return where the rows of two arrays of one shape differ, ascending."""
    places = np.flatnonzero(
        (old != new).ravel()
    )  # flat: nothing is quicker, and few are left to be told apart
    if old.ndim == 1 or not places.size:
        return places
    rows: NDArray[np.intp] = places // old.shape[1]
    begins = np.ones(len(rows), dtype=np.bool_)
    np.not_equal(rows[1:], rows[:-1], out=begins[1:])
    return rows[begins]


def common_rows(one: NDArray[Any], other: NDArray[Any]) -> int:
    """Return how many rows are the same at the beginnings of two arrays."""
    count = min(len(one), len(other))
    for end in (min(count, _FIRST), count):  # most often it is seen at once, or not at all
        differ = (one[:end] != other[:end]).ravel()
        if differ.any():
            return int(differ.argmax()) * end // len(differ)
    return count


def _within_reach(places: NDArray[np.intp], reach: range, count: int, closed: bool) -> NDArray[np.intp]:
    """Return the segments, of `count` in all, at the given steps from ascending places; they too ascend."""
    if not places.size:
        return places
    low = places[0] + reach.start
    marked = np.zeros(places[-1] + reach.stop - low, dtype=np.bool_)
    for step in reach:
        marked[places - low + step] = True
    segments = np.flatnonzero(marked) + low
    return _united([segments % count], count) if closed else segments[(segments >= 0) & (segments < count)]


def _united(parts: list[NDArray[np.intp]], count: int) -> NDArray[np.intp]:
    """Return what is in any of the parts, ascending, of the numbers below `count`."""
    filled = [part for part in parts if part.size]
    if sum(part.size for part in filled) < count // 16:  # a few are sorted sooner than all are marked
        return distinct(np.concatenate(filled)) if filled else np.empty(0, dtype=np.intp)
    marked = np.zeros(count, dtype=np.bool_)
    for part in filled:
        marked[part] = True
    return np.flatnonzero(marked)
