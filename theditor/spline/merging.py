"""One pair of parameters for each place where curves meet, however often it was found."""

import numpy as np
from numpy.typing import NDArray

from theditor.spline.basis import Floats

_ALIKE = 1e-9  # meetings as near as this in both parameters are one, found from both sides of a joint


def merged(
    u: Floats,
    v: Floats,
    width: Floats,
    gap: Floats,
    own: NDArray[np.bool_],
    periods: tuple[int | None, int | None],
    same: bool,
) -> Floats:
    """Return one pair of parameters, (k, 2), for each group of findings that hang together, in order.

    Parameters
    ----------
    u, v : ndarray, shape (n,)
        What was found.
    width : ndarray, shape (n,)
        How far each is known to extend, in both parameters and to either side at most; 0 for a point.
    gap : ndarray, shape (n,)
        How far the curves are apart there: of the points, else of the stretches, the nearest stands for all.
    own : ndarray of bool, shape (n,)
        Where one curve turns back on itself; a group with such a member is no meeting.
    periods : (int or None, int or None)
        Those of u and of v, where the curves are closed.
    same : bool
        Whether both parameters belong to one curve; then each pair comes with the lesser first.
    """
    pairs = np.stack((u, v))
    for row, period in zip(pairs, periods, strict=True):
        if period is not None:
            row %= period
    if same:
        pairs.sort(axis=0)
    group = _groups(pairs, width + _ALIKE / 2, periods, same)
    real = ~np.isin(group, group[own])
    order = np.lexsort((gap, width > 0, group))
    order = order[real[order]]
    _, first = np.unique(group[order], return_index=True)
    chosen = pairs[:, order[first]]
    return np.ascontiguousarray(chosen[:, np.lexsort(chosen[::-1])].T)


def _groups(
    pairs: Floats, width: Floats, periods: tuple[int | None, int | None], same: bool
) -> NDArray[np.intp]:
    """Return for each finding the number of its group: their squares meet, directly or through others."""
    squares = [(pairs, np.arange(len(width)))]
    for row, period in enumerate(periods):
        if period is None:
            continue
        for known, index in list(squares):  # those at the seam's end show at its beginning as well
            late = known[row] + width[index] >= period
            copy = known[:, late]
            copy[row] -= period
            squares.append((np.sort(copy, axis=0) if same else copy, index[late]))
    where = np.concatenate([known for known, _ in squares], axis=1)
    index = np.concatenate([index for _, index in squares])
    half = width[index]
    order = np.argsort(where[0] - half)
    where, index, half = where[:, order], index[order], half[order]
    # Candidates: squares whose range of u begins within that of an earlier one.
    counts = np.searchsorted(where[0] - half, where[0] + half, side="right") - np.arange(len(half)) - 1
    one = np.repeat(np.arange(len(half)), counts)
    other = one + 1 + np.arange(len(one)) - np.repeat(np.cumsum(counts) - counts, counts)
    linked = np.abs(where[1, one] - where[1, other]) <= half[one] + half[other]
    one, other = index[one[linked]], index[other[linked]]
    group = np.arange(len(width))
    while True:
        least = np.minimum(group[one], group[other])
        new = group.copy()
        for ends in (one, other):
            np.minimum.at(new, group[ends], least)
            np.minimum.at(new, ends, least)
        new = new[new]
        if np.array_equal(new, group):
            return group
        group = new
