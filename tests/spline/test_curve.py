import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from spline_strategies import LIMITS, curves, defining_points, plainly, scale

from theditor.spline import (
    CONVEX_HULL_RANGE,
    INTERPOLATING,
    JOINT_SLOPE_ZERO,
    Curve,
    Mode,
    basis,
    lambda_of,
)

T = np.linspace(0, 1, 9)


def close(actual, expected, limit):
    np.testing.assert_allclose(actual, expected, rtol=0, atol=limit)


@given(curves(), st.floats(0, 1, allow_subnormal=False), st.data())
def test_a_point_is_basis_functions_times_control_points(curve, t, data):
    segment = data.draw(st.integers(0, curve.segment_count - 1))
    t = (segment + t) - segment
    side = "left" if t == 1 else "right"
    for nu in range(4):
        close(curve(segment + t, nu, side), plainly(curve, segment, t, nu), 4 * LIMITS[nu] * scale(curve))


@given(curves())
def test_shape_of_the_answer_follows_the_parameters(curve):
    u = np.linspace(0, curve.segment_count, 12).reshape(3, 4)
    assert curve(u).shape == (3, 4, curve.dimension)
    assert curve(0).shape == (curve.dimension,)
    np.testing.assert_array_equal(curve(u)[1, 2], curve(u[1, 2]))


@given(curves())
def test_a_moved_and_stretched_polygon_carries_its_curve_along(curve):
    d = curve.dimension
    matrix = np.arange(1.0, d * d + 1).reshape(d, d) / 4 - np.eye(d)
    shift = np.arange(d) - 3.0
    moved = curve.with_(control_points=curve.control_points @ matrix + shift)
    u = np.linspace(0, curve.segment_count, 31)
    close(moved(u), curve(u) @ matrix + shift, 1e-14 * (scale(curve) + scale(moved)))


@given(curves())
def test_joints_are_smooth_whatever_lambda(curve):
    inner = np.arange(0 if curve.closed else 1, curve.segment_count)
    for nu in range(curve.degree):
        ending = curve(inner, nu, side="left")
        close(curve(inner, nu), ending, 4 * LIMITS[nu] * scale(curve))
    close(curve(inner), curve.joints[inner], 0)


def test_the_third_derivative_jumps_and_each_side_is_given():
    curve = Curve([(0, 0), (1, 2), (3, -1), (4, 1), (6, 0)], 0.0)
    assert not np.allclose(curve(1, 3), curve(1, 3, side="left"))
    close(curve(1, 3, side="left"), plainly(curve, 0, 1.0, 3), 1e-13)
    close(curve(2, 3), curve(2, 3, side="left"), 0)


def test_before_the_start_of_a_closed_curve_comes_its_last_segment():
    curve = Curve([(0, 0), (1, 2), (3, -1)], [0.5, 3.0, -2.0], closed=True)
    close(curve(0, 3, side="left"), plainly(curve, 2, 1.0, 3), 1e-13)
    close(curve(3, 3), plainly(curve, 2, 1.0, 3), 1e-13)


@given(curves(degrees=(3,)))
def test_the_derivative_of_a_cubic_is_the_quadratic_of_differences(curve):
    assume(curve.closed or curve.ends == "free")
    points = np.concatenate((curve.control_points, curve.control_points[: curve.closed]))
    lambdas = curve.lambdas if curve.closed else curve.lambdas[:-1]
    slopes = Curve(np.diff(points, axis=0), lambdas, 2, curve.closed)
    u = np.linspace(0, curve.segment_count, 33)
    close(slopes(u), curve(u, 1), 2e-14 * scale(curve))


@given(curves(degrees=(2,)))
def test_a_quadratic_touches_the_middle_of_each_edge(curve):
    P = curve.polygon if not curve.closed else np.roll(curve.polygon[:-1], 1, axis=0)
    if curve.closed:
        P = np.concatenate((P, P[:1]))
    middles = (P[:-1] + P[1:]) / 2
    if curve.ends == "clamped" and not curve.closed:
        middles[0], middles[-1] = P[0], P[-1]
    close(curve.joints, middles[: len(curve.joints)], 2e-15 * scale(curve))


@given(curves(degrees=(3,), ends=("free",)))
def test_at_a_cubics_joint_the_slope_is_half_the_chord_and_the_bend_along_the_second_difference(curve):
    before, at, after = (defining_points(curve)[:, i] for i in range(3))
    starts = np.arange(curve.segment_count)
    close(curve(starts, 1), (after - before) / 2, 2e-14 * scale(curve))
    lam = curve.lambdas[(starts + curve.first_segment) % len(curve.control_points), None]
    slope = (1 - lam) * np.pi / 4 + lam * (np.e + 1) / (2 * (np.e - 1))
    close(curve(starts, 2), slope * (before - 2 * at + after), 4e-14 * scale(curve))


@given(curves(), st.data())
def test_moving_one_point_or_one_lambda_changes_nearby_segments_only(curve, data):
    count = len(curve.control_points)
    index = data.draw(st.integers(0, count - 1))
    u = (np.arange(curve.segment_count)[:, None] + T[:-1]).ravel()

    def changed(other):
        differs = (other(u) != curve(u)).any(axis=-1)
        return set(np.flatnonzero(differs.reshape(curve.segment_count, -1).any(axis=1)).tolist())

    near = {index - curve.first_segment + step for step in range(1 - curve.degree, 2)}
    beside = {index - curve.first_segment + step for step in (-1, 0)}
    if curve.closed:
        near, beside = ({s % count for s in group} for group in (near, beside))
    assert changed(curve.with_points(index, curve.control_points[index] + 5)) <= near
    bent = curve.with_lambdas(index, curve.lambdas[index] + 1)
    assert changed(bent) <= beside
    if not curve.active_lambdas[index]:
        assert not changed(bent)


@given(st.data(), st.sampled_from([2, 3]))
def test_within_the_convex_hull_range_a_segment_stays_in_the_hull_of_its_points(data, degree):
    low, high = CONVEX_HULL_RANGE[degree]
    curve = data.draw(curves(degrees=(degree,), low=low, high=high))
    angle = np.linspace(0, 2 * np.pi, 16, endpoint=False)
    directions = np.stack((np.cos(angle), np.sin(angle), np.sin(3 * angle))[: curve.dimension])
    furthest = (defining_points(curve) @ directions).max(axis=1)
    for s in range(curve.segment_count):
        reach = (curve(s + T) @ directions).max(axis=0)
        assert (reach <= furthest[s] + 1e-14 * scale(curve)).all()


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("side", [0, 1])
def test_beyond_the_convex_hull_range_a_segment_leaves_the_hull(degree, side):
    lam = 1.5 * CONVEX_HULL_RANGE[degree][side]
    weights = basis(np.linspace(0, 1, 101), lam, lam, degree)
    _, column = np.unravel_index(weights.argmin(), weights.shape)
    points = np.zeros((degree + 1, 2))
    points[column, 1] = 1  # where this one's weight is negative, the curve dips below the hull
    assert Curve(points, lam, degree).sample(100)[:, 1].min() < -1e-3


@given(curves(low=INTERPOLATING[3], high=INTERPOLATING[3], degrees=(3,)))
def test_an_interpolating_cubic_meets_its_points_at_the_joints(curve):
    first = curve.first_segment
    met = curve.control_points[first : first + len(curve.joints)]
    close(curve.joints, met, 1e-15 * scale(curve))


@given(curves(low=INTERPOLATING[2], high=INTERPOLATING[2], degrees=(2,)))
def test_an_interpolating_quadratic_meets_its_points_halfway(curve):
    halfway = curve(np.arange(curve.segment_count) + 0.5)
    first = curve.first_segment
    expected = curve.control_points[first : first + curve.segment_count]
    if curve.ends == "clamped" and not curve.closed:  # the mirrored points have no say in this
        halfway, expected = halfway[1:-1], expected[1:-1]
    close(halfway, expected, 2e-15 * scale(curve))


@given(curves(closed=(False,), ends=("clamped",)))
def test_a_clamped_curve_begins_and_ends_at_its_end_points_tangent_to_the_polygon(curve):
    points, end = curve.control_points, curve.segment_count
    close(curve(0), points[0], 2e-15 * scale(curve))
    close(curve(end), points[-1], 2e-15 * scale(curve))
    if curve.degree == 3:
        close(curve(0, 1), points[1] - points[0], 1e-14 * scale(curve))
        close(curve([0, end], 2), 0, 0)  # no curvature
    else:
        slope = (curve.lambdas[[1, -1]] - JOINT_SLOPE_ZERO)[:, None]
        slope *= (np.e + 1) / (2 * (np.e - 1)) - np.pi / 4
        edges = points[[1, -1]] - points[[0, -2]]
        close(curve([0, end], 1), 2 * slope * edges, 4e-14 * scale(curve))


def test_a_clamped_cubic_through_two_points_is_the_straight_line():
    line = Curve([(1, 2), (4, -2)], 0.7, ends="clamped")
    close(line([0, 0.25, 1]), [(1, 2), (1.75, 1), (4, -2)], 0)
    assert line.lambda_indices(0) == (None, None)
    assert not line.active_lambdas.any()
    assert line.with_mode(0, Mode.HYPERBOLIC).modes == (Mode.HYPERBOLIC,)


@given(curves())
def test_reversed_runs_the_same_way_backwards(curve):
    backwards = curve.reversed()
    assert backwards.reversed() == curve
    count = curve.segment_count
    u = np.linspace(0, count, 25)[1:-1]
    mirrored = count - u
    if curve.closed and curve.degree == 3:
        mirrored = (mirrored - 1) % count
    close(backwards(u), curve(mirrored), 2e-14 * scale(curve))


@given(curves())
def test_active_lambdas_are_those_that_shape_some_segment(curve):
    used = {i for s in range(curve.segment_count) for i in curve.lambda_indices(s)} - {None}
    assert used == set(np.flatnonzero(curve.active_lambdas).tolist())


@given(curves(), st.sampled_from([Mode.TRIGONOMETRIC, Mode.HYPERBOLIC, Mode.INTERPOLATING]), st.data())
def test_setting_a_mode_sets_these_segments_and_leaves_distant_ones(curve, mode, data):
    count = curve.segment_count
    chosen = data.draw(st.lists(st.integers(0, count - 1), max_size=3, unique=True))
    changed = curve.with_mode(chosen, mode)
    assert all(changed.modes[s] is mode for s in chosen)
    shared = {i for s in chosen for i in curve.lambda_indices(s)}
    for s in set(range(count)) - set(chosen):
        if not shared & set(curve.lambda_indices(s)) - {None}:
            assert changed.modes[s] is curve.modes[s]
    assert [list(Mode)[code] for code in changed.mode_codes] == list(changed.modes)
    assert [changed.mode_at(s) for s in range(changed.segment_count)] == list(changed.modes)


def test_neighbours_of_a_changed_segment_become_blends_unless_they_agree():
    curve = Curve(np.arange(16).reshape(8, 2), lambda_of(Mode.HYPERBOLIC, 3))
    T, H, B = Mode.TRIGONOMETRIC, Mode.HYPERBOLIC, Mode.BLEND
    assert curve.with_mode(2, T).modes == (H, B, T, B, H)
    assert curve.with_mode([1, 3], T).modes == (B, T, T, T, B)


def test_the_mode_of_a_clamped_end_segment_is_its_one_active_lambda():
    curve = Curve(np.arange(10).reshape(5, 2), 0.5, ends="clamped").with_mode([0, 3], Mode.HYPERBOLIC)
    assert curve.lambdas.tolist() == [0.5, 1, 0.5, 1, 0.5]
    assert curve.modes == (Mode.HYPERBOLIC, Mode.BLEND, Mode.BLEND, Mode.HYPERBOLIC)


def test_segments_are_numbered_and_counted_as_degree_and_ends_demand():
    points = np.arange(14).reshape(7, 2) ** 2
    table = {
        (2, False, "free"): (5, 1, (1, 2)),
        (2, False, "clamped"): (5, 1, (1, 2)),
        (3, False, "free"): (4, 1, (1, 2)),
        (3, False, "clamped"): (6, 0, (None, 1)),
        (2, True, "free"): (7, 0, (0, 1)),
        (3, True, "clamped"): (7, 0, (0, 1)),
    }
    for (degree, closed, ends), expected in table.items():
        curve = Curve(points, 0, degree, closed, ends)
        assert (curve.segment_count, curve.first_segment, curve.lambda_indices(0)) == expected
        assert curve.domain == (0, curve.segment_count)
        assert len(curve.joints) == curve.segment_count + (not closed)
        np.testing.assert_array_equal(curve.polygon[:7], points)
        assert len(curve.polygon) == 7 + closed


@pytest.mark.parametrize("u", [-1e-9, 4.0000001, np.nan, [1.0, np.inf]])
def test_a_parameter_outside_the_domain_is_refused(u):
    with pytest.raises(ValueError, match="outside the curve's domain, 0 to 4"):
        Curve(np.arange(14).reshape(7, 2))(u)
