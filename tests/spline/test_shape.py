import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from spline_strategies import curves, defining_points, scale

from theditor.spline import CONVEX_HULL_RANGE, PULL_BOUNDS, Curve, pull, pull_points
from theditor.spline.shape import defining_points as defined_by

LOW, HIGH = PULL_BOUNDS
within = curves(low=LOW, high=HIGH)


def place(data, curve, low=0.0, high=1.0):
    segment = data.draw(st.integers(0, curve.segment_count - 1))
    return segment, segment + data.draw(st.floats(low, high, allow_subnormal=False))


def active(curve, segment):
    return [i for i in curve.lambda_indices(segment) if i is not None]


def largest(curve):
    return max(1e-300, np.abs(curve.control_points).max())


def targets(curve):
    return arrays(np.float64, curve.dimension, elements=st.floats(-30, 30, allow_subnormal=False))


@given(within, st.data())
def test_what_two_lambdas_within_bounds_can_reach_is_met(curve, data):
    segment, u = place(data, curve)
    indices = active(curve, segment)
    values = data.draw(st.lists(st.floats(LOW, HIGH), min_size=len(indices), max_size=len(indices)))
    target = curve.with_lambdas(indices, values)(u)
    curve = curve.with_lambdas(indices, data.draw(st.sampled_from([0.0, 1.0, -15.0, 9.0])))
    pulled = pull(curve, u, target)
    assert np.abs(pulled.residual).max() <= 1e-12 * largest(curve)
    np.testing.assert_array_equal(pulled.residual, target - pulled.curve(u))
    np.testing.assert_array_equal(pulled.curve.control_points, curve.control_points)


@given(within, st.data())
def test_no_lambdas_within_bounds_come_closer_than_the_pulled_ones(curve, data):
    segment, u = place(data, curve)
    indices, target = active(curve, segment), data.draw(targets(curve))
    assume(indices)
    low, high = data.draw(st.sampled_from([PULL_BOUNDS, CONVEX_HULL_RANGE[curve.degree], (0.0, 1.0)]))
    curve = curve.with_lambdas(indices, np.clip(curve.lambdas[indices], low, high))
    pulled = pull(curve, u, target, (low, high))
    reached = pulled.curve.lambdas[indices]
    assert ((low <= reached) & (reached <= high)).all()

    # The miss is convex in λ: what no step on nested grids improves is the optimum.
    def miss(lambdas):
        return np.linalg.norm(curve.with_lambdas(indices, lambdas)(u) - target)

    best = np.linalg.norm(pulled.residual)
    for width in 26 * 0.5 ** np.arange(0, 24, 3):
        for step in (
            width * np.stack(np.meshgrid(*[[-1, -0.5, 0, 0.5, 1]] * len(indices))).reshape(len(indices), -1).T
        ):
            assert miss(np.clip(reached + step, low, high)) >= best - 1e-12 * max(30, largest(curve))


@given(within, st.data())
def test_a_pull_held_by_a_bound_says_so(curve, data):
    segment, u = place(data, curve)
    pulled = pull(curve, u, data.draw(targets(curve)))
    assert set(pulled.at_bound) <= set(active(curve, segment))
    assert all(pulled.curve.lambdas[i] in PULL_BOUNDS for i in pulled.at_bound)
    if not pulled.at_bound:  # nothing holds it: what is missed lies across both directions of motion
        for i in active(curve, segment):
            motion = pulled.curve.with_lambdas(i, pulled.curve.lambdas[i] + 1)(u) - pulled.curve(u)
            assert abs(motion @ pulled.residual) <= 1e-12 * max(30, largest(curve)) ** 2


@given(within, st.data())
def test_a_pull_to_where_the_point_is_changes_nothing(curve, data):
    _, u = place(data, curve)
    pulled = pull(curve, u, curve(u))
    assert pulled.curve == curve
    np.testing.assert_array_equal(pulled.residual, 0)


@given(st.floats(0.1, 0.9), st.floats(-3, 3), st.sampled_from([2, 3]), st.floats(0, 6.3))
def test_on_a_straight_polygon_both_lambdas_share_the_change(t, along, degree, angle):
    direction = np.array([np.cos(angle), np.sin(angle)])
    curve = Curve(np.outer([0, 1, 4, 5, 9], direction), 0.5, degree)
    target = curve(1 + t) + 0.01 * along * direction + 5 * direction[::-1] * [-1, 1]
    pulled = pull(curve, 1 + t, target)
    moved = pulled.curve(1 + t) - curve(1 + t)
    np.testing.assert_allclose(moved, 0.01 * along * direction, atol=1e-12)
    assert np.abs(pulled.curve.lambdas - 0.5).max() < 16
    effect = [curve.with_lambdas(i, 1.5)(1 + t) - curve(1 + t) for i in active(curve, 1)]
    change = (pulled.curve.lambdas - 0.5)[active(curve, 1)]
    # The smallest change is proportional to what each λ does.
    assert change[0] * (effect[1] @ direction) == pytest.approx(change[1] * (effect[0] @ direction), abs=1e-9)


@given(st.floats(0, 6.3), st.floats(-0.3, 0.3))
def test_a_bound_on_one_lambda_leaves_the_rest_to_the_other(angle, miss):
    direction = np.array([np.cos(angle), np.sin(angle)])
    curve = Curve(np.outer([0, 1, 4, 9], direction), [0, 9.5, 0, 0])
    # Both λ move the middle alike, so it takes 4 units of them in all: many pairs within bounds would do.
    target = curve.with_lambdas([1, 2], [11.5, 2])(0.5) + miss * direction[::-1] * [-1, 1]
    pulled = pull(curve, 0.5, target)
    np.testing.assert_allclose(pulled.curve.lambdas[1:3], [10, 3.5], rtol=0, atol=1e-9)
    assert pulled.at_bound == (1,)


@given(within, st.data(), st.booleans())
def test_the_nearer_joint_alone_moves_when_asked(curve, data, late):
    segment, u = place(data, curve, *((0.6, 0.9) if late else (0.1, 0.4)))
    pair = curve.lambda_indices(segment)
    pulled = pull(curve, u, data.draw(targets(curve)), which="nearer")
    other = pair[not late]
    if pair[late] is not None and other is not None:
        straight = curve.with_lambdas(pair[late], curve.lambdas[pair[late]] + 1)(u)
        if np.linalg.norm(straight - curve(u)) > 1e-9 * scale(curve):
            assert pulled.curve.lambdas[other] == curve.lambdas[other]


def test_at_a_joint_a_cubic_moves_along_its_track_and_a_quadratic_not_at_all():
    points = [(0, 0), (1, 2), (3, -1), (5, 1), (6, 4)]
    cubic, quadratic = Curve(points), Curve(points, degree=2)
    pulled = pull(cubic, 1, cubic.with_lambdas(2, 7)(1))
    np.testing.assert_allclose(pulled.curve.lambdas, [0, 0, 7, 0, 0], atol=1e-12)
    assert pull(quadratic, 1, (9, 9)).curve == quadratic
    np.testing.assert_array_equal(pull(quadratic, 1, (9, 9)).residual, (9, 9) - quadratic(1))


def test_a_lambda_outside_the_bounds_may_stay_or_come_back():
    curve = Curve([(0, 0), (1, 2), (3, -1), (5, 1)], 14.0)
    back = curve.with_lambdas([1, 2], 3.0)(0.5)
    np.testing.assert_allclose(pull(curve, 0.5, back).curve.lambdas[1:3], 3, atol=1e-10)
    away = curve.with_lambdas([1, 2], 30.0)(0.5)
    held = pull(curve, 0.5, away)
    assert held.curve == curve
    assert held.at_bound == (1, 2)


def test_a_straight_clamped_cubic_has_nothing_to_pull_but_its_points():
    line = Curve([(0, 0), (2, 0)], ends="clamped")
    pulled = pull(line, 0.5, (1, 1))
    assert (pulled.curve, pulled.at_bound) == (line, ())
    np.testing.assert_array_equal(pulled.residual, (0, 1))
    np.testing.assert_allclose(pull_points(line, 0.5, (1, 1)).control_points, [(0, 1), (2, 1)], atol=1e-15)


@given(curves(), st.data())
def test_pulled_points_meet_the_target_with_the_least_change(curve, data):
    _, u = place(data, curve)
    target = data.draw(targets(curve))
    moved = pull_points(curve, u, target)
    size = max(largest(curve), 30) * max(1, np.abs(curve.lambdas).max())
    np.testing.assert_allclose(moved(u), target, rtol=0, atol=4e-15 * size)
    np.testing.assert_array_equal(moved.lambdas, curve.lambdas)
    # The curve is linear in its points, so the least change is a multiple of each point's influence on u.
    influence = []
    for i in range(len(curve.control_points)):
        unit = curve.with_(control_points=np.zeros_like(curve.control_points)).with_points(i, 1.0)
        influence.append(unit(u)[0])
    expected = np.outer(influence, target - curve(u)) / np.dot(influence, influence)
    np.testing.assert_allclose(
        moved.control_points - curve.control_points, expected, rtol=0, atol=1e-13 * size
    )


@given(curves())
def test_defining_points_are_the_segments_own(curve):
    for segment, expected in enumerate(defining_points(curve)):
        indices, matrix = defined_by(curve, segment)
        assert len(set(indices.tolist())) == len(indices)
        np.testing.assert_array_equal(matrix @ curve.control_points[indices], expected)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((9, (0, 0)), "u = 9.0 lies outside the curve's domain, 0 to 1"),
        ((np.nan, (0, 0)), "lies outside"),
        (([0.1, 0.2], (0, 0)), "give one parameter u"),
        ((0.5, (0, 0, 0)), "the target must have the shape"),
        ((0.5, (0, np.nan)), "the target must be finite"),
        ((0.5, (0, 0), (3, -3)), "bounds of λ run from low to high"),
        ((0.5, (0, 0), (-1, 1), "further"), 'which must be "both" or "nearer"'),
    ],
)
def test_what_makes_no_sense_is_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        pull(Curve([(0, 0), (1, 2), (3, -1), (5, 1)]), *arguments)
