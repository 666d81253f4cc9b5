import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from spline_strategies import coordinates, curves, scale

import theditor.spline
from theditor.spline import JOINT_SLOPE_ZERO, Curve, bounds, known, nearest


@given(curves(), st.data())
def test_no_sample_is_nearer_than_the_nearest_point(curve, data):
    point = np.array([data.draw(coordinates) for _ in range(curve.dimension)])
    u, distance = nearest(curve, point)
    assert 0 <= u <= curve.segment_count
    noise = 4e-15 * (scale(curve) + 10)
    assert np.linalg.norm(curve(u) - point) == pytest.approx(distance, abs=noise)
    sampled = np.linalg.norm(curve.sample(400) - point, axis=1).min()
    assert distance <= sampled + 1e-12 * (scale(curve) + 10)


@given(curves(), st.floats(0, 1), st.booleans())
def test_a_point_of_the_curve_is_met(curve, where, at_a_joint):
    u = where * curve.segment_count
    point = curve(round(u) if at_a_joint else u)
    _, distance = nearest(curve, point)
    assert distance <= 1e-12 * scale(curve)


@given(st.floats(-3, 3), st.floats(-3, 3))
def test_the_nearest_point_of_an_ellipse_is_where_the_normal_passes(x, y):
    curve = known.ellipse()
    u, distance = nearest(curve, (x, y))
    slope = curve(u, 1) @ (curve(u) - (x, y))
    assert slope == pytest.approx(0, abs=1e-7)
    angle = np.linspace(0, 2 * np.pi, 20001)
    assert distance <= np.hypot(2 * np.cos(angle) - x, np.sin(angle) - y).min() + 1e-14


def test_from_its_centre_every_point_of_a_circle_is_as_near():
    _, distance = nearest(known.ellipse((3, 4), (2, 2)), (3, 4))
    assert distance == pytest.approx(2, rel=1e-14)


def test_cusps_corners_lines_and_points_are_met_too():
    cusped = Curve([(0, 0), (1, 2), (3, -1), (4, 1), (6, 0)], JOINT_SLOPE_ZERO, 2)
    for joint, beyond in ((1, (5, 10)), (2, (-3, 7))):
        assert nearest(cusped, cusped(joint))[1] < 1e-15
        sampled = np.linalg.norm(cusped.sample(20_000) - beyond, axis=1).min()
        assert nearest(cusped, beyond)[1] <= sampled
    cycloid = known.cycloid(quarters=12)
    u, distance = nearest(cycloid, cycloid(8) + np.array([0, -1.0]))
    assert distance == pytest.approx(1, abs=1e-13)
    assert u == pytest.approx(8, abs=1e-6)
    line = Curve([(0, 0), (4, 8)], ends="clamped")
    assert nearest(line, (6, 2)) == pytest.approx((0.5, np.hypot(4, 2)))
    assert nearest(line, (-1, -1)) == (0.0, np.sqrt(2))
    assert nearest(Curve([(1, 1)] * 5), (4, 5))[1] == 5


def test_far_away_points_and_large_coordinates_keep_the_accuracy():
    curve = known.ellipse((1e6, -1e6), (2, 1))
    assert nearest(curve, (1e6 + 5, -1e6))[1] == pytest.approx(3, abs=1e-9)
    assert nearest(known.ellipse(), (1e9, 0))[1] == pytest.approx(1e9 - 2, abs=1e-3)


@settings(max_examples=25)
@given(curves())
def test_many_points_are_as_near_as_one_by_one(curve):
    points = np.random.default_rng(2).uniform(-9, 9, (2, 3, curve.dimension))
    u, distance = nearest(curve, points)
    alone = [[nearest(curve, point) for point in row] for row in points]
    np.testing.assert_array_equal(np.stack((u, distance), axis=-1), alone)
    assert nearest(curve, points[0, :0])[0].shape == (0,)


def test_a_closed_curves_seam_is_its_start():
    curve = known.ellipse()
    u, distance = nearest(curve, curve(0))
    assert distance < 1e-15
    assert min(u, 4 - u) < 1e-7
    assert u < 4


@given(curves())
def test_the_bounds_hold_and_are_touched(curve):
    low, high = bounds(curve)
    samples = curve.sample(300)
    noise = 1e-12 * scale(curve)  # the accuracy
    assert (samples >= low - noise).all()
    assert (samples <= high + noise).all()
    sag = 24 * scale(curve) / (8 * 300**2)  # no arc between two samples rises higher
    assert (samples.min(axis=0) - low <= sag).all()
    assert (high - samples.max(axis=0) <= sag).all()


@given(st.floats(0, 7), st.floats(0.1, 5), st.floats(0.1, 5), st.sampled_from([2, 3]))
def test_the_bounds_of_a_turned_ellipse(rotation, a, b, degree):
    low, high = bounds(known.ellipse((1, -2), (a, b), rotation=rotation, degree=degree))
    cos, sin = np.cos(rotation), np.sin(rotation)
    half = np.array((np.hypot(a * cos, b * sin), np.hypot(a * sin, b * cos)))
    np.testing.assert_allclose(low, (1, -2) - half, atol=1e-12)
    np.testing.assert_allclose(high, (1, -2) + half, atol=1e-12)


def test_what_makes_no_sense_is_refused():
    curve = known.ellipse()
    for point in ((1, 2, 3), (np.nan, 0), 5.0, [(0, 0), (1, np.inf)]):
        with pytest.raises(ValueError, match="each point needs 2 finite coordinates"):
            nearest(curve, point)
    with pytest.raises(ValueError, match="accuracy must be a positive number"):
        bounds(curve, -1.0)


def test_every_measure_is_called_from_the_library_itself():
    for name in (
        "arc_length",
        "nearest",
        "bounds",
        "curvature",
        "inflections",
        "self_intersections",
        "intersections",
        "curvature_extremes",
        "bending_energy",
        "osculating_circle",
        "continuity",
        "hull",
        "negative_basis",
        "reversed_joints",
        "pull",
        "reach",
        "joint_track",
        "recognise",
        "missing",
    ):
        assert callable(getattr(theditor.spline, name)), name
        assert name in theditor.spline.__all__
