"""Curves with other ends: which are reached exactly, and how near the others come."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from spline_strategies import curves, scale

from theditor.spline import Curve, nearest, with_ends

few = settings(max_examples=25, deadline=None)


@few
@given(curves(low=-3, high=8), st.booleans(), st.sampled_from(["free", "clamped"]))
def test_any_curve_gets_any_ends_and_the_deviation_is_no_less_than_what_is_seen(curve, is_closed, ends):
    result, deviation = with_ends(curve, is_closed, ends)
    assert result.closed is is_closed
    assert is_closed or result.ends == ends
    away = max(nearest(result, place)[1] for place in curve.sample(3))
    assert away <= deviation + 1e-9 * scale(curve)
    if not is_closed and (ends == "free" or curve.degree == 2):
        assert deviation <= 1e-12 * scale(curve)


@pytest.mark.parametrize("count", [4, 5, 6, 9, 40, 5000])
@pytest.mark.parametrize("lam", [0.0, 1.0])
def test_a_clamped_cubic_keeps_its_ends_its_count_and_its_shape_nearly(count, lam):
    x = np.arange(count)
    free = Curve(np.stack([x, np.cos(2.0 * x)], axis=1), lam)
    result, deviation = with_ends(free, False, "clamped")
    assert len(result.control_points) == count
    ends = free([0, free.segment_count])
    np.testing.assert_allclose(result.control_points[[0, -1]], ends, atol=1e-12)
    assert deviation < 0.02
