import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from spline_strategies import curves

from theditor.spline import MAX_LAMBDA, Curve, gradient, shifted, smoothed

finite = st.floats(-30, 30, allow_subnormal=False)


def chosen(data, curve):
    return data.draw(st.lists(st.integers(0, len(curve.control_points) - 1), max_size=12))


def kept(old, new, indices):
    """Control points, and every λ not among the indices, are as before."""
    others = np.delete(np.arange(len(old.lambdas)), indices)
    np.testing.assert_array_equal(new.lambdas[others], old.lambdas[others])
    np.testing.assert_array_equal(new.control_points, old.control_points)
    np.testing.assert_array_equal(new.lambdas[~old.active_lambdas], old.lambdas[~old.active_lambdas])


@given(curves(), st.data(), finite, finite)
def test_a_gradient_runs_evenly_from_first_to_last(curve, data, first, last):
    indices = chosen(data, curve)
    new = gradient(curve, indices, first, last)
    kept(curve, new, indices)
    where = sorted({i for i in indices if curve.active_lambdas[i]})
    if len(where) > 1:
        assert new.lambdas[where[0]] == first
        assert new.lambdas[where[-1]] == last
        slopes = np.diff(new.lambdas[where]) / np.diff(where)
        np.testing.assert_allclose(slopes, (last - first) / (where[-1] - where[0]), rtol=0, atol=1e-13)


@given(curves(), st.data(), st.floats(0, 1))
def test_smoothing_calms_what_is_jagged_and_leaves_what_is_even(curve, data, strength):
    indices = chosen(data, curve)
    new = smoothed(curve, indices, strength)
    kept(curve, new, indices)
    active = curve.active_lambdas
    assume(active.any())

    def roughness(c):
        lambdas = c.lambdas[active]
        return np.abs(np.diff(lambdas, append=lambdas[:1] if c.closed else lambdas[-1:])).sum()

    assert roughness(new) <= roughness(curve) + 1e-12
    assert new.lambdas[active].min() >= curve.lambdas[active].min() - 1e-13
    assert new.lambdas[active].max() <= curve.lambdas[active].max() + 1e-13
    if not curve.closed:
        ends = np.flatnonzero(active)[[0, -1]]
        np.testing.assert_array_equal(new.lambdas[ends], curve.lambdas[ends])
        even = curve.with_(lambdas=0.25 * np.arange(len(active)))
        np.testing.assert_allclose(smoothed(even, indices, strength).lambdas, even.lambdas, atol=1e-14)


def test_full_strength_wipes_out_a_zigzag_and_goes_round_a_closed_curve():
    points = np.arange(16).reshape(8, 2) ** 2
    zigzag = np.tile([1.0, 3.0], 4)
    assert smoothed(Curve(points, zigzag, closed=True), range(8)).lambdas.tolist() == [2] * 8
    assert smoothed(Curve(points, zigzag), range(8), 0).lambdas.tolist() == zigzag.tolist()
    lone = smoothed(Curve(points, [8, *[0] * 7], closed=True), range(8)).lambdas
    np.testing.assert_array_equal(lone[1:], lone[:0:-1])
    assert lone[4] > 0


@given(curves(), st.data(), finite)
def test_shifted_lambdas_keep_their_differences(curve, data, delta):
    indices = chosen(data, curve)
    new = shifted(curve, indices, delta)
    others = np.delete(np.arange(len(curve.lambdas)), indices)
    np.testing.assert_array_equal(new.lambdas[others], curve.lambdas[others])
    np.testing.assert_allclose(new.lambdas[indices] - curve.lambdas[indices], delta, rtol=0, atol=1e-13)


def test_what_makes_no_sense_is_refused():
    curve = Curve([(0, 0), (1, 2), (3, -1), (5, 1)])
    with pytest.raises(ValueError, match="control point 1: λ is inf"):
        gradient(curve, [1, 2], np.inf, 0)
    with pytest.raises(ValueError, match="strength must be from 0 to 1"):
        smoothed(curve, [1, 2], 1.5)
    with pytest.raises(ValueError, match="control point 2: λ is"):
        shifted(curve, [2], 2 * MAX_LAMBDA)
    with pytest.raises(ValueError, match="no control point 9"):
        smoothed(curve, [9])
