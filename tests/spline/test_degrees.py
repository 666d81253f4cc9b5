import numpy as np
import pytest

from theditor.spline import INTERPOLATING, Curve, with_degree


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("kind", ["free", "clamped", "closed"])
@pytest.mark.parametrize("count", [4, 9, 40])
def test_a_change_of_degree_keeps_shape_ends_and_count(degree, kind, count):
    angle = np.linspace(0, 2 * np.pi, count, endpoint=kind != "closed")
    points = np.stack((2 * np.cos(angle), np.sin(angle), np.sin(2 * angle)), axis=1)
    curve = Curve(points, 0.3, degree, kind == "closed", "clamped" if kind == "clamped" else "free")
    edited = with_degree(curve, 5 - degree)
    new = edited.curve
    assert (new.degree, new.closed, new.ends) == (5 - degree, curve.closed, curve.ends)
    np.testing.assert_array_equal(new.lambdas, curve.lambdas)
    assert edited.deviation < {4: 0.35, 9: 0.15, 40: 0.02}[count]
    # What is reported is what dense samples say, both ways.
    a, b = curve.sample(40), new.sample(40)
    gaps = np.linalg.norm(a[:, None] - b, axis=2)
    far = max(gaps.min(axis=0).max(), gaps.min(axis=1).max())
    step = max(np.linalg.norm(np.diff(x, axis=0), axis=1).max() for x in (a, b))
    assert abs(edited.deviation - far) <= step / 2 + 0.05 * far
    if kind != "closed":
        ends = [c([0, c.segment_count]) for c in (curve, new)]
        np.testing.assert_allclose(*ends, atol=1e-6)


def test_a_quadratic_with_too_few_points_for_a_cubic_gets_more():
    cubic = with_degree(Curve([(0, 0), (1, 1), (2, 0)], 0, 2), 3)
    assert len(cubic.curve.control_points) == 4
    assert cubic.deviation < 0.1


def test_interpolating_values_follow_the_degree_and_the_same_degree_changes_nothing():
    curve = Curve(np.random.default_rng(0).normal(size=(7, 2)), INTERPOLATING[3])
    assert set(with_degree(curve, 2).curve.lambdas) == {INTERPOLATING[2]}
    assert with_degree(curve, 3) == (curve, 0.0)
    with pytest.raises(ValueError, match="degree must be 2 or 3"):
        with_degree(curve, 4)
