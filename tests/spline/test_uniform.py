import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from spline_strategies import curves, defining_points

from theditor.spline import Curve, uniform_b_spline_samples, uniform_segments

# The textbook's matrices: powers of t times these times the segment's points.
MATRICES = {
    2: np.array([[1, 1, 0], [-2, 2, 0], [1, -2, 1]]) / 2,
    3: np.array([[1, 4, 1, 0], [-3, 0, 3, 0], [3, -6, 3, 0], [-1, 3, -3, 1]]) / 6,
}


@given(curves(), st.integers(1, 9))
def test_samples_are_those_of_the_uniform_b_spline(curve, per_segment):
    samples = uniform_b_spline_samples(curve, per_segment)
    powers = (np.arange(per_segment + 1) / per_segment)[:, None] ** np.arange(curve.degree + 1)
    expected = powers @ MATRICES[curve.degree] @ defining_points(curve)
    size = max(1e-300, np.abs(curve.control_points).max())
    assert len(samples) == curve.segment_count * per_segment + 1
    np.testing.assert_allclose(samples[:-1], np.concatenate(expected[:, :-1]), rtol=0, atol=4e-15 * size)
    np.testing.assert_allclose(samples[-1], expected[-1, -1], rtol=0, atol=4e-15 * size)
    last = np.array([curve.segment_count - 1])
    alone = uniform_segments(curve, last, per_segment)[0]
    np.testing.assert_allclose(alone, expected[-1], rtol=0, atol=4e-15 * size)
    if curve.closed:
        np.testing.assert_array_equal(samples[0], samples[-1])
    np.testing.assert_array_equal(samples, uniform_b_spline_samples(curve.with_(lambdas=7.0), per_segment))


def test_a_senseless_number_of_samples_is_refused():
    with pytest.raises(ValueError, match="per_segment must be a positive integer, not 0"):
        uniform_b_spline_samples(Curve([(0, 0), (1, 2), (3, -1), (5, 1)]), 0)
