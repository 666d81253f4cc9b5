import numpy as np
import pytest

from theditor.spline.banded import solve


@pytest.mark.parametrize("ring", [False, True])
@pytest.mark.parametrize("count", [1, 2, 5, 7, 12, 40, 41, 203])
@pytest.mark.parametrize("reach", [1, 2, 6])
def test_equations_solved_in_blocks_are_those_solved_at_once(count, reach, ring):
    rng = np.random.default_rng(count)
    each = min(reach + 1, count)
    parts = count if ring else count - each + 1
    unknowns = (np.arange(parts)[:, None] + np.arange(each)) % count
    unknowns[rng.random(unknowns.shape) < 0.1] = -1
    roots = rng.normal(size=(parts, each, 2 * each)) * 10.0 ** rng.integers(-3, 4, (parts, 1, 1))
    matrices, right = roots @ roots.transpose(0, 2, 1), rng.normal(size=(parts, each))
    whole, goal = np.zeros((count, count)), np.zeros(count)
    for matrix, side, where in zip(matrices, right, unknowns, strict=True):
        known = where >= 0
        whole[np.ix_(where[known], where[known])] += matrix[np.ix_(known, known)]
        goal[where[known]] += side[known]
    solution = solve(matrices, right, unknowns, count, reach, 0.0)
    missing = ~np.isin(np.arange(count), unknowns)
    assert not solution[missing].any()
    size = np.sqrt(np.diag(whole)) + missing
    np.testing.assert_allclose((whole @ solution) / size, goal / size, atol=1e-8 * np.abs(goal / size).max())
