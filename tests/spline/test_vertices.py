import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from spline_strategies import curves

from theditor.spline import (
    JOINT_SLOPE_ZERO,
    Curve,
    curvature,
    curvature_extremes,
    inflections,
    known,
)

ZIGZAG = [(0, 0), (1, 2), (3, -1), (4, 1), (6, 0)]


def of_one_size(curve):
    """Whether no part is so much smaller than the curve that dense samples see its rounding only."""
    sizes = np.abs(curve.control_points[curve.control_points != 0])
    return bool(sizes.min(initial=1) > 1e-4)


plane_curves = curves().filter(lambda curve: curve.dimension == 2 and of_one_size(curve))
mild_curves = curves(low=-2, high=9).filter(of_one_size)


def dense(curve, per_segment=200):
    """Parameters inside all segments, and κ there, a row for each segment."""
    t = (np.arange(per_segment) + 0.5) / per_segment
    u = np.arange(curve.segment_count)[:, None] + t
    return u, curvature(curve, u)


def clear(curve, kappa):
    """κ with what may be rounding, or no curvature at all, taken out."""
    size = np.abs(curve.control_points).max()
    return np.where(np.isfinite(kappa) & (np.abs(kappa) * size > 1e-6), kappa, np.nan)


@given(plane_curves)
def test_every_change_of_sign_among_dense_samples_has_its_inflections(curve):
    u, kappa = dense(curve)
    u, kappa = u.ravel(), clear(curve, kappa).ravel()
    found = inflections(curve).u
    assert (np.diff(found) >= 0).all()
    seen = np.isfinite(kappa[1:]) & np.isfinite(kappa[:-1])
    between = np.searchsorted(found, u[1:], "left") - np.searchsorted(found, u[:-1], "left")
    changed = kappa[1:] * kappa[:-1] < 0
    np.testing.assert_array_equal(between[seen] % 2 == 1, changed[seen])


@given(plane_curves)
def test_on_the_two_sides_of_an_inflection_the_curve_turns_two_ways(curve):
    found = inflections(curve)
    for u in found.u:
        gaps = np.abs(found.u - u)
        if curve.closed:
            gaps = np.minimum(gaps, curve.segment_count - gaps)
        step = min(1e-4, gaps[gaps > 0].min(initial=1) / 3)
        around = np.array([u - step, u + step])
        if curve.closed:
            around %= curve.segment_count
        if step > 1e-6 and around[0] >= 0 and around[1] <= curve.segment_count:
            signs = np.sign(clear(curve, curvature(curve, around)))
            assert not signs[0] * signs[1] > 0


def test_the_inflections_of_a_sine_are_its_zeros():
    curve = known.sine(wavelength=4.0, start=-np.pi / 4, quarters=8)
    found = inflections(curve)
    np.testing.assert_allclose(found.u, [0.5, 2.5, 4.5, 6.5], atol=1e-12)
    assert not found.jump.any()


def test_a_quadratic_may_jump_from_one_sign_to_the_other_at_a_joint():
    found = inflections(Curve(ZIGZAG, 0.5, 2))
    np.testing.assert_array_equal(found.u, [1, 2])
    assert found.jump.all()
    closed = inflections(Curve([(-2, -1), (2, 1), (2, -1), (-2, 1)], 0.5, 2, closed=True))
    np.testing.assert_array_equal(closed.u, [1, 3])


def test_an_inflection_at_a_cubics_joint_passes_through_zero_there():
    points = [(-3, -3), (-2, -1), (0, 0), (2, 1), (3, 3)]
    found = inflections(Curve(points, 0.5, 3))
    np.testing.assert_array_equal(found.u, [1])
    assert not found.jump.any()


@pytest.mark.parametrize("lam", [0.0, 5.0, -9.0])
def test_straight_parts_have_no_inflections_and_no_extremes(lam):
    line = Curve(np.outer([0, 3, 1, 2, 0.7, 5, 5], (0.1, 0.3)) + 7, lam)
    assert len(inflections(line).u) == 0
    assert len(curvature_extremes(line).u) == 0
    bent = Curve([(-3, 2), (-2, 0), *[(x, 0.0) for x in range(5)], (5, 1)], 0.5)
    assert len(inflections(bent).u) == 0  # bends left, runs straight, bends left


@given(st.floats(0.1, 10), st.floats(0.1, 10), st.floats(0, 7), st.sampled_from([2, 3]))
def test_an_ellipse_has_four_vertices_and_a_circle_none(a, b, start, degree):
    if abs(a - b) < 0.01 * a:
        b = a
    curve = known.ellipse((1, 2), (a, b), start=start, degree=degree)
    found = curvature_extremes(curve)
    assert len(inflections(curve).u) == 0
    if a == b:
        assert len(found.u) == 0
        return
    assert len(found.u) == 4
    assert found.maximum.sum() == 2
    sharp, flat = max(a, b) / min(a, b) ** 2, min(a, b) / max(a, b) ** 2
    np.testing.assert_allclose(found.curvature, np.where(found.maximum, sharp, flat), rtol=1e-8)


@given(mild_curves)
def test_every_peak_and_dip_among_dense_samples_is_an_extreme(curve):
    u, kappa = dense(curve)
    speed = np.linalg.norm(curve(u, 1), axis=-1)
    kappa[speed < 0.02 * speed.max()] = np.nan  # near a cusp rounding has its say
    size = clear(curve, np.abs(kappa))
    found = curvature_extremes(curve)
    for peak in (True, False):
        sign = 1 if peak else -1
        inner = sign * size[:, 1:-1]
        drops = np.stack((inner - sign * size[:, :-2], inner - sign * size[:, 2:]))
        real = (drops > 1e-6 * np.nanmax(size, initial=0)).all(axis=0)
        real &= peak | (size[:, 1:-1] > 2 * drops.max(axis=0))  # else a dip to 0
        for place in u[:, 1:-1][real]:
            assert np.abs(found.u[found.maximum == peak] - place).min(initial=1) < 0.006


@given(mild_curves)
def test_an_extreme_between_joints_is_one_among_its_neighbours(curve):
    found = curvature_extremes(curve)
    assert (np.diff(found.u) >= 0).all()
    for u, value, peak in zip(*found, strict=True):
        if 0.001 < u % 1 < 0.999 and value < 1e3:
            around = np.abs(curvature(curve, [u - 5e-4, u + 5e-4]))
            slack = 1e-9 + 1e-9 * value
            close = np.abs(found.u - u)
            if np.sort(close)[1:2].min(initial=1) > 1e-3:  # else the next extreme lies between
                assert (around <= value + slack).all() if peak else (around >= value - slack).all()


def test_at_a_quadratics_joint_both_sides_may_be_extreme():
    curve = Curve(ZIGZAG, [0, 0, 2, 1, 0], 2)
    found = curvature_extremes(curve)
    for u in (1, 2):
        sides = sorted(abs(float(curvature(curve, u, side))) for side in ("left", "right"))
        for value in found.curvature[found.u == u]:
            assert any(value == pytest.approx(side) for side in sides)
    u, kappa = dense(curve, 2000)
    peaks = np.abs(kappa).max(axis=1)
    np.testing.assert_allclose(found.curvature[found.maximum].max(), peaks.max(), rtol=1e-2)


def test_a_cusp_is_a_peak():
    cycloid = known.cycloid(quarters=12)
    found = curvature_extremes(cycloid)
    cusps = found.u[found.maximum]
    np.testing.assert_allclose(cusps, [4, 8], atol=1e-4)
    assert (found.curvature[found.maximum] > 1e3).all()
    np.testing.assert_allclose(found.u[~found.maximum], [2, 6, 10], atol=1e-9)
    np.testing.assert_allclose(found.curvature[~found.maximum], 1 / 4, rtol=1e-9)
    still = curvature_extremes(Curve([(0, 0), (1, 2), (3, -1), (4, 1), (6, 0)], JOINT_SLOPE_ZERO, 2))
    assert {1.0, 2.0} <= set(still.u[still.curvature == np.inf].tolist())


def test_a_helix_turns_evenly():
    quarter = np.arange(9) * np.pi / 2
    curve = Curve(np.stack((np.cos(quarter), np.sin(quarter), 0.3 * quarter), axis=1))
    assert len(curvature_extremes(curve).u) == 0
    np.testing.assert_allclose(np.ptp(curvature(curve, np.linspace(0, 6, 50))), 0, atol=1e-12)


def test_space_curves_have_no_inflections():
    with pytest.raises(ValueError, match="take two of the three coordinates"):
        inflections(Curve([(0, 0, 0), (1, 1, 0), (2, 0, 1), (3, 1, 1)]))
