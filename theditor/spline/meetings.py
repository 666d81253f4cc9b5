"""Which segments come near which: pairs of boxes that meet, found without looking at all pairs."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from theditor.spline.basis import Floats

Boxes = tuple[Floats, Floats]
"""Lowest and highest corners, (d, k) each."""

_CHUNK = 8192  # pairs at a time, so that memory stays bounded however many there are


def meeting_boxes(
    one: Boxes, other: Boxes | None = None
) -> Iterator[tuple[NDArray[np.intp], NDArray[np.intp]]]:
    """Yield all pairs of boxes, one of each kind, that have a point in common; a chunk of pairs at a time.

    Descends two binary trees of boxes around ever fewer consecutive ones; as neighbours along a curve lie
    near each other, the work is about proportional to the number of boxes and of pairs. With one kind only,
    the pairs (i, j) have i ≤ j, each box with itself included.
    """
    most = max(one[0].shape[1], 0 if other is None else other[0].shape[1])
    levels = max(most - 1, 0).bit_length()
    tree = _tree(one, levels)
    second = tree if other is None else _tree(other, levels)
    stack = [(levels, np.zeros(1, dtype=np.intp), np.zeros(1, dtype=np.intp))]
    while stack:
        level, i, j = stack.pop()
        (low, high), (other_low, other_high) = tree[level], second[level]
        meet = ((low[:, i] <= other_high[:, j]) & (other_low[:, j] <= high[:, i])).all(axis=0)
        if other is None:
            meet &= i <= j
        i, j = i[meet], j[meet]
        for first in range(0, len(i), _CHUNK):
            a, b = i[first : first + _CHUNK], j[first : first + _CHUNK]
            if level == 0:
                yield a, b
            else:
                first_child = np.concatenate((2 * a, 2 * a, 2 * a + 1, 2 * a + 1))
                second_child = np.concatenate((2 * b, 2 * b + 1, 2 * b, 2 * b + 1))
                stack.append((level - 1, first_child, second_child))


def _tree(boxes: Boxes, levels: int) -> list[Boxes]:
    """Return the boxes, and around them boxes of 2, of 4, … consecutive ones, up to a single box."""
    spare = ((0, 0), (0, 2**levels - boxes[0].shape[1]))
    low, high = (
        np.pad(boxes[0], spare, constant_values=np.inf),
        np.pad(boxes[1], spare, constant_values=-np.inf),
    )
    tree = [(low, high)]
    for _ in range(levels):
        low, high = np.minimum(low[:, ::2], low[:, 1::2]), np.maximum(high[:, ::2], high[:, 1::2])
        tree.append((low, high))
    return tree
