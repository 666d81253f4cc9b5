import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from spline_strategies import curves, lambdas_for, scale

from theditor.spline import INTERPOLATING, PULL_BOUNDS, Curve, joint_track, middle_track, reach

within = curves(low=PULL_BOUNDS[0], high=PULL_BOUNDS[1])


def some_active(data, curve):
    return data.draw(st.sampled_from(np.flatnonzero(curve.active_lambdas).tolist()))


def targets(curve):
    return arrays(np.float64, curve.dimension, elements=st.floats(-30, 30, allow_subnormal=False))


def equal(actual, expected, curve):
    np.testing.assert_allclose(actual, expected, rtol=0, atol=1e-13 * scale(curve))


@given(curves(degrees=(3,)), st.data())
def test_a_joint_slides_on_its_track_as_lambda_varies(curve, data):
    assume(curve.active_lambdas.any())
    i = some_active(data, curve)
    track, joint = joint_track(curve, i), i - curve.first_segment
    equal(track.position(curve.lambdas[i]), curve.joints[joint], curve)
    for lam in (0.0, 1.0, -9.0):
        equal(track.position(lam), curve.with_lambdas(i, lam).joints[joint], curve)
    equal(track.position(INTERPOLATING[3]), curve.control_points[i], curve)
    assert track.position(np.zeros((2, 3))).shape == (2, 3, curve.dimension)


@given(curves(), st.data())
def test_a_segments_middle_slides_on_its_track_as_both_lambdas_vary(curve, data):
    segment = data.draw(st.integers(0, curve.segment_count - 1))
    track = middle_track(curve, segment)
    indices = [i for i in curve.lambda_indices(segment) if i is not None]
    for lam in (0.0, 1.0, INTERPOLATING[curve.degree], -9.0):
        equal(track.position(lam), curve.with_lambdas(indices, lam)(segment + 0.5), curve)
    ends = curve.ends == "clamped" and not curve.closed and segment in (0, curve.segment_count - 1)
    if curve.degree == 2 and not ends:
        met = curve.control_points[segment + curve.first_segment]
        equal(track.position(INTERPOLATING[2]), met, curve)


@given(within, st.data())
def test_the_nearest_parameter_is_the_nearest(curve, data):
    track = middle_track(curve, data.draw(st.integers(0, curve.segment_count - 1)))
    target = data.draw(targets(curve))
    lam = track.parameter_nearest(target)
    assert PULL_BOUNDS[0] <= lam <= PULL_BOUNDS[1]
    least = np.linalg.norm(track.position(lam) - target)
    others = np.linalg.norm(track.position(np.linspace(*PULL_BOUNDS, 501)) - target, axis=1)
    assert least <= others.min() + 1e-13 * max(30, scale(curve))


def test_where_lambda_moves_nothing_the_nearest_parameter_is_the_current_one():
    for even in (Curve(np.outer([0, 1, 2, 3, 4], [0.1, 0.7]), 0.3), Curve([(5, 5)] * 5, 0.3)):
        assert joint_track(even, 2).parameter_nearest((9, -9)) == 0.3


def test_a_current_lambda_outside_the_bounds_may_stay_there():
    track = joint_track(Curve([(0, 0), (1, 2), (3, -1), (5, 1)], 14.0), 1)
    assert track.parameter_nearest(track.position(30)) == 14
    assert track.parameter_nearest(track.position(-30)) == PULL_BOUNDS[0]
    assert track.parameter_nearest(track.position(12)) == pytest.approx(12)


@given(curves(), st.data())
def test_the_band_holds_every_curve_of_its_range(curve, data):
    assume(curve.active_lambdas.any())
    i = some_active(data, curve)
    low, high = sorted(data.draw(st.tuples(lambdas_for(curve.degree), lambdas_for(curve.degree))))
    band = reach(curve, i, (low, high), 8)
    assert band.low.shape == (len(band.segments), 9, curve.dimension)
    share = data.draw(st.floats(0, 1))
    bent = curve.with_lambdas(i, low + share * (high - low))
    u = band.segments[:, None] + np.linspace(0, 1, 9)[:-1]
    # Each point of any such curve divides the way across the band in the same ratio.
    equal(bent(u), ((1 - share) * band.low + share * band.high)[:, :-1], bent)
    outside = set(range(curve.segment_count)) - set(band.segments.tolist())
    for s in outside:
        np.testing.assert_array_equal(bent(s + 0.5), curve(s + 0.5))
    for lam, drawn in (
        (0, band.trigonometric),
        (1, band.hyperbolic),
        (INTERPOLATING[curve.degree], band.interpolating),
    ):
        equal(drawn[:, :-1], curve.with_lambdas(i, lam)(u), curve)


@given(curves(), st.data())
def test_quadrangles_cover_the_band_and_all_turn_the_same_way(curve, data):
    assume(curve.dimension == 2 and curve.active_lambdas.any())
    band = reach(curve, some_active(data, curve), intervals=6)
    corners = band.quads
    assert corners.shape == (len(band.segments), 6, 4, 2)
    size = np.abs(corners).max()
    edges = np.roll(corners, -1, axis=2) - corners
    nexts = np.roll(edges, -1, axis=2)
    turns = edges[..., 0] * nexts[..., 1] - edges[..., 1] * nexts[..., 0]
    assert turns.min() >= -1e-13 * max(1e-290, size) * size
    for j in range(6):  # each has its own four points of the two bounding curves
        own = np.concatenate((band.low[:, j : j + 2], band.high[:, j : j + 2]), axis=1)
        for segment, quad in enumerate(corners[:, j]):
            assert sorted(map(tuple, quad)) == sorted(map(tuple, own[segment]))


def test_an_end_lambda_of_an_open_curve_shapes_one_segment_others_two():
    points = np.arange(12).reshape(6, 2) ** 2
    assert reach(Curve(points), 1).segments.tolist() == [0]
    assert reach(Curve(points), 2).segments.tolist() == [0, 1]
    assert reach(Curve(points, degree=2), 5).segments.tolist() == [3]
    assert reach(Curve(points, ends="clamped"), 1).segments.tolist() == [0, 1]
    assert reach(Curve(points, closed=True), 0).segments.tolist() == [5, 0]


def test_a_lambda_without_say_has_no_track_and_no_reach():
    points = [(0, 0), (1, 2), (3, -1), (5, 1)]
    with pytest.raises(ValueError, match="control point 0 does not shape the curve: choose one from 1 to 2"):
        reach(Curve(points), 0)
    with pytest.raises(ValueError, match="control point 3 does not shape the curve"):
        joint_track(Curve(points), 3)
    with pytest.raises(ValueError, match="a straight line has none"):
        reach(Curve(points[:2], ends="clamped"), 1)
    with pytest.raises(ValueError, match="take the track of a segment's middle"):
        joint_track(Curve(points, degree=2), 1)
    with pytest.raises(ValueError, match="no control point 4"):
        reach(Curve(points), 4)
