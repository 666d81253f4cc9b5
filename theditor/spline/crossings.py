"""Where a plane curve crosses itself, and where two curves meet."""

import numpy as np
from numpy.typing import NDArray

from theditor.spline import joints
from theditor.spline.basis import Floats
from theditor.spline.contacts import APART, FOLLOWING, SAME, contacts
from theditor.spline.curve import Curve
from theditor.spline.extent import extent
from theditor.spline.meetings import Boxes, meeting_boxes
from theditor.spline.merging import merged
from theditor.spline.parameters import check_accuracy, check_plane

_FINEST = 1e-14  # accuracies beyond rounding are of no use


def self_intersections(curve: Curve, accuracy: float = 1e-9) -> Floats:
    """Return where a plane curve meets itself.

    Every crossing is found, to rounding, and every touch, to about √accuracy along the curve. Adjacent
    segments do not meet in their joint, nor does a closed curve in its seam, nor a curve at a cusp. A stretch
    that the curve runs along twice is given as one pair, or as none if the curve turned back on itself to do
    so. The work is bounded: where stretches coincide without being straight, some may be given as several
    pairs.

    Parameters
    ----------
    curve : Curve
    accuracy : float
        Points nearer to each other than this, relative to the largest side of the polygon's box, count as
        meeting; two meetings no farther apart than that may be given as one.

    Returns
    -------
    ndarray, shape (k, 2)
        Parameters u < v, ascending by u, then by v.

    Raises
    ------
    ValueError
        If the curve is not plane, or `accuracy` is not a positive number.
    """
    check_accuracy(accuracy)
    check_plane(curve, "self-intersections")
    return _found(curve, curve, True, accuracy)


def intersections(a: Curve, b: Curve, accuracy: float = 1e-9) -> Floats:
    """Return where two plane curves meet.

    Every crossing is found, to rounding, and every touch, to about √accuracy along the curves. A stretch that
    both run along is given as one pair, some place on it. It looks like a touch, for the directions agree
    there; that it is a stretch is told by points of `a` beside it, whose distance from `b` by `nearest` is
    no more than rounding. The work is bounded: where stretches coincide without being straight, some may be
    given as several pairs.

    Parameters
    ----------
    a, b : Curve
    accuracy : float
        Points nearer to each other than this, relative to the largest side of both polygons' common box,
        count as meeting; two meetings no farther apart than that may be given as one.

    Returns
    -------
    ndarray, shape (k, 2)
        The parameter on `a` and that on `b`, ascending by the first, then by the second.

    Raises
    ------
    ValueError
        If a curve is not plane, or `accuracy` is not a positive number.
    """
    check_accuracy(accuracy)
    for curve in (a, b):
        check_plane(curve, "intersections")
    return _found(a, b, False, accuracy)


def _found(a: Curve, b: Curve, same: bool, accuracy: float) -> Floats:
    points = np.concatenate((a.control_points, b.control_points))
    low, high = extent(points)
    tolerance = max(accuracy, _FINEST) * float((high - low).max())
    if tolerance == 0:  # a point
        return np.empty((0, 2))
    middle = ((low + high) / 2)[:, None]  # moved there, coordinates lose least
    tables = []
    for i, j in meeting_boxes(_padded(a.boxes, tolerance), None if same else b.boxes):
        kind = np.full(len(i), APART)
        if same:
            kind[i == j], kind[i + 1 == j] = SAME, FOLLOWING
            if a.closed:
                seam = (i == 0) & (j == a.segment_count - 1)
                i, j, kind = np.where(seam, j, i), np.where(seam, i, j), np.where(seam, FOLLOWING, kind)
        one, other = _moved(a, i, middle), _moved(b, j, middle)
        found = contacts(one, other, (a.degree, b.degree), kind, tolerance)
        tables.append((i[found.row] + found.s, j[found.row] + found.t, *found[3:]))
    if not tables:
        return np.empty((0, 2))
    u, v, width, gap, own = (np.concatenate(column) for column in zip(*tables, strict=True))
    periods = a.segment_count if a.closed else None, b.segment_count if b.closed else None
    return merged(u, v, width, gap, own, periods, same)


def _moved(curve: Curve, segments: NDArray[np.intp], middle: Floats) -> joints.Segments:
    parts = joints.take_segments(curve, segments)
    return parts._replace(start=parts.start - middle, end=parts.end - middle)


def _padded(boxes: Boxes, tolerance: float) -> Boxes:
    return boxes[0] - tolerance, boxes[1] + tolerance
