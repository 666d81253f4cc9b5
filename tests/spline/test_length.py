import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from spline_strategies import curves, scale

from theditor.spline import Curve, arc_length, arc_lengths, known, parameter_at


def ellipse_circumference(a, b):
    """By the arithmetic-geometric mean, after Gauss and Legendre."""
    x, y, total, power = max(a, b), min(a, b), (a * a + b * b) / 2, 1.0
    for _ in range(8):
        x, y, half = (x + y) / 2, np.sqrt(x * y), (x - y) / 2
        total -= power * half**2
        power *= 2
    return 2 * np.pi * total / x


@given(st.floats(0.05, 20), st.floats(0.05, 20), st.sampled_from([2, 3]))
def test_an_ellipse_is_as_long_as_the_elliptic_integral_says(a, b, degree):
    curve = known.ellipse(semi_axes=(a, b), degree=degree)
    length = ellipse_circumference(a, b)
    assert arc_length(curve) == pytest.approx(length, rel=1e-9)
    assert arc_length(curve, accuracy=1e-13) == pytest.approx(length, rel=2e-13)


def test_a_catenary_is_as_long_as_the_hyperbolic_sine():
    curve = known.catenary(parameter=2.0, start=-1.0, units=3)
    assert arc_length(curve, accuracy=1e-13) == pytest.approx(2 * (np.sinh(2) + np.sinh(1)), rel=1e-13)


@pytest.mark.parametrize("accuracy", [1e-3, 1e-9, 1e-13])
def test_an_arch_of_a_cycloid_is_eight_radii_cusps_and_all(accuracy):
    three_arches = known.cycloid(radius=1.5, quarters=12)
    assert arc_length(three_arches, accuracy=accuracy) == pytest.approx(36, rel=max(accuracy, 1e-14))
    assert arc_length(three_arches, 2, 6, accuracy) == pytest.approx(12, rel=max(accuracy, 1e-14))


def test_a_line_run_through_there_and_back_counts_every_stretch():
    curve = Curve([(0, 0), (3, 4), (0, 0), (3, 4)], -20.0, 2, closed=True)
    dense = np.linalg.norm(np.diff(curve.sample(200_000), axis=0), axis=1).sum()
    assert arc_length(curve) == pytest.approx(dense, rel=1e-8)


@given(curves(), st.data())
def test_lengths_of_parts_add_up_and_exceed_their_chords(curve, data):
    u0, u1, u2 = sorted(data.draw(st.floats(0, curve.segment_count, allow_subnormal=False)) for _ in range(3))
    whole = arc_length(curve, u0, u2)
    assert whole == pytest.approx(arc_length(curve, u0, u1) + arc_length(curve, u1, u2), rel=1e-8)
    chords = np.linalg.norm(np.diff(curve(np.linspace(u0, u2, 2001)), axis=0), axis=1).sum()
    noise = 1e-11 * max(scale(curve), 1e-120)  # the norms above square
    assert chords <= whole * (1 + 1e-9) + noise
    assert whole <= chords * 1.01 + noise


@given(curves(), st.integers(2, 9))
def test_the_parameter_at_a_length_has_that_length_behind_it(curve, count):
    whole = arc_lengths(curve, accuracy=1e-10)
    assert whole[0] == 0
    assert whole[-1] == pytest.approx(arc_length(curve, accuracy=1e-10), rel=1e-12)
    lengths = np.linspace(0, whole[-1], count)
    u = parameter_at(curve, lengths, 1e-10)
    assert u.shape == lengths.shape
    noise = 1e-13 * scale(curve) * curve.segment_count  # of u itself, as a length
    np.testing.assert_allclose(arc_lengths(curve, u, 1e-12), lengths, rtol=0, atol=2e-10 * whole[-1] + noise)


def test_a_point_has_no_length():
    point = Curve([(1, 2)] * 5)
    assert arc_length(point) == 0
    assert parameter_at(point, 0.0) >= 0


@given(curves())
def test_what_lies_outside_is_refused(curve):
    with pytest.raises(ValueError, match="give the lesser parameter first"):
        arc_length(curve, 1, 0.5)
    with pytest.raises(ValueError, match="outside the curve's domain"):
        arc_length(curve, 0, curve.segment_count + 0.5)
    with pytest.raises(ValueError, match="outside the curve's domain"):
        arc_lengths(curve, [0, np.nan])
    with pytest.raises(ValueError, match="accuracy must be a positive number"):
        arc_lengths(curve, accuracy=0)
    length = arc_length(curve)
    assume(length > 0)
    with pytest.raises(ValueError, match="lies outside the curve"):
        parameter_at(curve, [0, 1.1 * length])
