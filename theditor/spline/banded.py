"""Linear equations in which an unknown meets only its neighbours, along a line or round a ring.

Neighbours together make a block, so that a block meets the one before and the one after it alone. Every other
block is then expressed by its two neighbours, all at once, and half of the blocks remain, which meet as before
(cyclic reduction): the cost is proportional to the number of unknowns.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from theditor.spline.basis import Floats

_FEWEST: Final = 3  # blocks: fewer meet one another on both sides


def solve(
    parts: Floats, right: Floats, unknowns: NDArray[np.intp], count: int, reach: int, damping: float
) -> Floats:
    """Return the solution of symmetric positive definite equations, given as a sum of small ones.

    Parameters
    ----------
    parts : ndarray, shape (n, k, k)
        What the matrix is the sum of.
    right : ndarray, shape (n, k)
        What the right-hand side is the sum of.
    unknowns : ndarray of int, shape (n, k)
        Which unknown each row and column belongs to; −1 for none.
    count : int
        How many unknowns there are.
    reach : int
        No part has two unknowns that are farther apart, counted round.
    damping : float
        By how much the diagonal grows, relative to itself; an unknown that is in no part is 0.

    Returns
    -------
    ndarray, shape (count,)
    """
    if not count:
        return np.empty(0)
    blocks = count // reach if count >= _FEWEST * reach else 1
    block = np.arange(count) * blocks // count
    slot = np.arange(count) - np.searchsorted(block, block)
    width = int(slot.max()) + 1

    none = unknowns < 0
    home, place = block[unknowns], slot[unknowns]
    row, column = home[:, :, None], home[:, None, :]
    beside = (row != column) & ((row + 1) % blocks == column)
    met = ((row == column) | beside) & ~(none[:, :, None] | none[:, None, :])
    index = ((beside * blocks + row) * width + place[:, :, None]) * width + place[:, None, :]
    shape = 2, blocks, width, width
    matrix, goal = np.zeros(shape), np.zeros(shape[1:3])
    np.add.at(matrix.ravel(), index[met], parts[met])
    np.add.at(goal, (home[~none], place[~none]), right[~none])

    # Each unknown in its own measure, so that their units do not matter.
    diagonal = np.arange(width)
    size = np.sqrt(matrix[0][:, diagonal, diagonal])
    empty = size == 0
    size[empty] = 1.0
    matrix[0] /= size[:, :, None] * size[:, None, :]
    matrix[1] /= size[:, :, None] * np.roll(size, -1, axis=0)[:, None, :]
    matrix[0][:, diagonal, diagonal] += damping + empty
    solution: Floats = (_reduced(matrix[0], matrix[1], goal / size) / size)[block, slot]
    return solution


def _reduced(own: Floats, after: Floats, right: Floats) -> Floats:
    """Solve equations of m blocks that meet the next one each, the last one the first, (m, w).

    `own` and `after`, (m, w, w), have the rows of a block and the columns of itself or of the next one.
    """
    count, width = right.shape
    if count == 1:
        return np.linalg.solve(own[0] + after[0] + after[0].T, right[0])[None]
    # Odd blocks go: x = free − before·(block before) − behind·(block behind).
    towards, from_it = after[: count - 1 : 2], after[1::2]
    sides = np.concatenate((towards.transpose(0, 2, 1), from_it, right[1::2, :, None]), axis=2)
    solved = np.linalg.solve(own[1::2], sides)
    pushed, pulled = towards @ solved, from_it.transpose(0, 2, 1) @ solved
    before, behind, free = np.split(solved, [width, 2 * width], axis=2)
    left, goal = own[::2].copy(), right[::2].copy()
    link = np.zeros_like(left)
    gone = len(solved)
    left[:gone] -= pushed[:, :, :width]
    link[:gone] = -pushed[:, :, width : 2 * width]
    goal[:gone] -= pushed[:, :, -1]
    follows = (np.arange(gone) + 1) % len(left)
    left[follows] -= pulled[:, :, width : 2 * width]
    goal[follows] -= pulled[:, :, -1]
    if count % 2:
        link[-1] = after[-1]
    rest = _reduced(left, link, goal)
    result = np.empty_like(right)
    result[::2] = rest
    result[1::2] = (free - before @ rest[:gone, :, None] - behind @ rest[follows, :, None])[:, :, 0]
    return result
