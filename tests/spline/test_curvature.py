import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from spline_strategies import curves

from theditor.spline import (
    JOINT_SLOPE_ZERO,
    Curve,
    bending_energy,
    curvature,
    known,
    osculating_circle,
)
from theditor.spline.curvature import curvature_along

CUSPED = Curve([(0, 0), (1, 2), (3, -1), (4, 1), (6, 0)], JOINT_SLOPE_ZERO, 2)


@given(st.floats(0.01, 1000), st.sampled_from([2, 3]), st.booleans())
def test_a_circle_has_the_curvature_of_its_radius_and_is_its_own_osculating_circle(r, degree, backwards):
    curve = known.ellipse((5, 7), (r, r), degree=degree)
    turns_left = not backwards
    if backwards:
        curve = curve.reversed()
    u = np.linspace(0, 4, 23)
    np.testing.assert_allclose(curvature(curve, u), 1 / r if turns_left else -1 / r, rtol=1e-9)
    centre, radius = osculating_circle(curve, u)
    np.testing.assert_allclose(centre, np.tile((5.0, 7.0), (23, 1)), atol=1e-9 * (r + 7))
    np.testing.assert_allclose(radius, r, rtol=1e-9)
    assert bending_energy(curve) == pytest.approx(2 * np.pi / r, rel=1e-8)


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("closed", [False, True])
def test_what_goes_on_along_a_segment_is_what_goes_on_at_its_points(degree, closed):
    rng = np.random.default_rng(0)
    curve = Curve(rng.normal(size=(40, 2)), rng.uniform(-5, 9, 40), degree, closed, ends="clamped")
    t, segments = np.array([0.0, 0.3, 0.8]), np.arange(curve.segment_count)
    points, directions, bends = curvature_along(curve, segments, np.append(t, 1.0))
    u = segments[:, None] + t
    np.testing.assert_allclose(np.moveaxis(points[..., :-1], 0, -1), curve(u), rtol=0, atol=1e-12)
    np.testing.assert_allclose(bends[:, :-1], curvature(curve, u), rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(
        bends[:, -1], curvature(curve, segments + 1.0, side="left"), rtol=1e-9, atol=1e-9
    )
    np.testing.assert_allclose(np.hypot(*directions), 1.0)


@given(curves(low=-2, high=9), st.floats(0.05, 0.95), st.data())
def test_the_circle_through_three_near_points_has_the_curvature(curve, t, data):
    u = data.draw(st.integers(0, curve.segment_count - 1)) + t
    a, b, c = curve([u - 1e-3, u, u + 1e-3])
    chord = np.linalg.norm(c - a)
    assume(chord > 1e-4 and abs(curvature(curve, u)) < 10 / chord)  # no sharper bend than chords can tell
    first, second = b - a, c - a
    area = np.linalg.norm(
        np.cross(np.append(first, [0] * (3 - len(a))), np.append(second, [0] * (3 - len(a))))
    )
    menger = 2 * area / (np.linalg.norm(first) * np.linalg.norm(c - b) * chord)
    size = max(1.0, np.abs(curve(u, 3)).max(), np.abs(curve(u, 2)).max()) / np.linalg.norm(curve(u, 1)) ** 2
    assert abs(curvature(curve, u)) == pytest.approx(menger, abs=0.02 * size + 1e-6)
    if curve.dimension == 2:
        turn = first[0] * second[1] - first[1] * second[0]
        if abs(turn) > 1e-3 * chord**2:
            assert np.sign(curvature(curve, u)) == np.sign(turn)


def test_sides_of_a_joint_differ_where_the_curvature_jumps():
    curve = Curve([(0, 0), (1, 2), (3, -1), (4, 1), (6, 0)], 0.5, 2)
    left, right = curvature(curve, 1, "left"), curvature(curve, 1)
    assert left == pytest.approx(float(curvature(curve, 1 - 1e-9)), rel=1e-6)
    assert right == pytest.approx(float(curvature(curve, 1 + 1e-9)), rel=1e-6)
    assert left * right < 0


def test_where_the_curve_stands_still_there_is_no_curvature_and_no_circle():
    for u in (0, 1, 2, 3):
        assert np.isnan(curvature(CUSPED, u, "left"))
        centre, radius = osculating_circle(CUSPED, u)
        assert np.isnan(centre).all()
        assert np.isnan(radius)
    assert np.isfinite(curvature(CUSPED, [0.5, 1.5, 2.5])).all()
    assert np.isnan(curvature(Curve([(1, 1)] * 4), [0, 0.5, 1])).all()


def test_a_straight_curve_has_an_infinite_circle_and_no_energy():
    line = Curve([(0, 0), (4, 8)], ends="clamped")
    np.testing.assert_array_equal(curvature(line, [0, 0.3, 1]), 0)
    centre, radius = osculating_circle(line, 0.3)
    assert np.isnan(centre).all()
    assert radius == np.inf
    uneven = Curve(np.outer([0, 3, 1, 2, 0.7, 5], (0.1, 0.3)), -9.0)
    assert bending_energy(uneven) == 0


@given(curves(low=-2, high=9), st.floats(0.1, 10))
def test_energy_adds_up_and_falls_as_the_curve_grows(curve, factor):
    energy = bending_energy(curve)
    middle = curve.segment_count / 3
    parts = bending_energy(curve, u1=middle) + bending_energy(curve, u0=middle)
    assume(energy < 1e6)  # beyond, near a cusp, rounding speaks
    assert parts == pytest.approx(energy, rel=1e-6, abs=1e-6)
    larger = curve.with_(control_points=curve.control_points * factor)
    assert bending_energy(larger) == pytest.approx(energy / factor, rel=1e-6, abs=1e-6)


def test_a_cusp_takes_infinite_energy():
    assert bending_energy(CUSPED) == np.inf
    assert bending_energy(CUSPED, 0.25, 0.75) < 100
    assert bending_energy(known.cycloid(quarters=8)) == np.inf


def test_what_lies_outside_is_refused():
    with pytest.raises(ValueError, match="outside"):
        curvature(CUSPED, 3.5)
    with pytest.raises(ValueError, match="lesser parameter first"):
        bending_energy(CUSPED, 2, 1)
