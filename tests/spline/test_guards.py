import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st
from spline_strategies import curves, defining_points, scale

from theditor.spline import (
    CONVEX_HULL_RANGE,
    JOINT_SLOPE_ZERO,
    Curve,
    basis,
    hull,
    negative_basis,
    reversed_joints,
)

T = np.linspace(0, 1, 2001)

edges = [edge for bounds in CONVEX_HULL_RANGE.values() for edge in bounds]
lambdas = st.one_of(
    st.floats(-40, 40, allow_subnormal=False),
    st.tuples(st.sampled_from(edges), st.floats(-0.01, 0.01, allow_subnormal=False)).map(sum),
    st.floats(-1e6, 1e6, allow_subnormal=False),
)


def one_segment(start, end, degree):
    points = [(0, 0), (1, 2), (3, -1), (5, 1)][: degree + 1]
    return Curve(points, [0, start, end, 0][: degree + 1], degree)


@given(lambdas, lambdas, st.sampled_from([2, 3]))
@example(3.9412, 0.0, 3)  # negative near t = 1 only, and by no more than 1e-11
@example(-15.7, -15.7, 3)
@example(0.0, -16.0, 2)  # outside the range, and not negative
def test_negative_basis_functions_are_those_of_a_dense_table(start, end, degree):
    guards = negative_basis(one_segment(start, end, degree))
    unit = max(1.0, abs(start), abs(end))
    table = basis(T, start, end, degree)
    lowest = dict(zip(guards.functions.tolist(), guards.values.tolist(), strict=True))
    for function, least in enumerate(table.min(axis=0)):
        # At most as low as found, and found wherever the table sees it.
        assert lowest.get(function, -1e-12 * unit) <= least + 1e-12 * unit
    for function, t, value in zip(guards.functions, guards.t, guards.values, strict=True):
        assert value < -1e-12 * unit
        assert basis(t, start, end, degree)[function] == pytest.approx(value, abs=1e-14 * unit)


@given(curves(low=-40, high=40))
def test_every_segment_is_guarded_as_it_would_be_alone(curve):
    guards = negative_basis(curve)
    odd = np.arange(1, curve.segment_count, 2)
    some = negative_basis(curve, odd)
    np.testing.assert_array_equal(some.segments, guards.segments[guards.segments % 2 == 1])
    where = list(zip(guards.segments.tolist(), guards.functions.tolist(), strict=True))
    assert where == sorted(set(where))
    for segment in range(curve.segment_count):
        pair = [0.0 if i is None else curve.lambdas[i] for i in curve.lambda_indices(segment)]
        alone = negative_basis(one_segment(*pair, curve.degree))
        own = guards.segments == segment
        np.testing.assert_array_equal(guards.functions[own], alone.functions)
        np.testing.assert_array_equal(guards.values[own], alone.values)
        assert bool(guards.reason(segment)) == bool(own.any())


@pytest.mark.parametrize("degree", [2, 3])
def test_the_range_guards_for_sure_and_beyond_it_only_what_is_negative(degree):
    low, high = CONVEX_HULL_RANGE[degree]
    for pair in ((low, high), (high, low), (low, low), (high, high)):
        assert not len(negative_basis(one_segment(*pair, degree)).segments)
    assert len(negative_basis(one_segment(high + 0.01, 0, degree)).segments)
    assert len(negative_basis(one_segment(low - 0.01, low - 0.01, degree)).segments)
    # With the other λ at 0 a quadratic may go further down; a cubic may not.
    assert len(negative_basis(one_segment(-17, 0, degree)).segments) == (degree == 3)


def test_many_segments_are_guarded_like_few():
    few = np.random.default_rng(7).uniform(-20, 12, 5000)
    points = np.arange(10000).reshape(5000, 2) % 11
    guards = negative_basis(Curve(points, few, closed=True))
    for segment in guards.segments[::500].tolist():
        alone = negative_basis(one_segment(few[segment], few[(segment + 1) % 5000], 3))
        np.testing.assert_array_equal(guards.functions[guards.segments == segment], alone.functions)


def test_the_reason_names_function_place_and_consequence():
    end = "; the convex hull no longer bounds this segment"
    guards = negative_basis(Curve([(0, 0), (1, 2), (3, -1), (5, 1), (6, 0)], [0, 5, 0, 0, 0]))
    assert guards.reason(0) == f"basis function c₀ is negative near t = 0.51{end}"
    assert guards.reason(1) == ""
    both = negative_basis(Curve([(0, 0), (1, 2), (3, -1)], 5.0, 2))
    assert both.reason(0) == f"basis functions q₀ (near t = 0.65) and q₂ (near t = 0.35) are negative{end}"


@given(curves(low=-16, high=6))
def test_where_nothing_is_negative_the_hull_bounds_the_segment(curve):
    assume(curve.dimension == 2)
    guarded = set(negative_basis(curve).segments.tolist())
    size = scale(curve)
    for segment in range(curve.segment_count):
        corners = hull(curve, segment)
        sides = np.roll(corners, -1, axis=0) - corners
        if len(corners) > 2:

            def outside(points, corners=corners, sides=sides):
                gaps, along = (points[:, None] - corners) / size, sides / size
                return (along[:, 0] * gaps[..., 1] - along[:, 1] * gaps[..., 0]).min()

            assert outside(defining_points(curve)[segment]) >= -1e-14
            if segment not in guarded:
                assert outside(curve(segment + T[::50])) >= -1e-11
        else:  # all the points lie on one line
            spread = np.linalg.svd(defining_points(curve)[segment] - corners[0])[1]
            assert spread[1] <= 1e-7 * size


def test_the_hull_has_corners_only_counterclockwise():
    square = Curve([(0, 0), (2, 0), (1, 0), (2, 2)])
    assert hull(square, 0).tolist() == [[0, 0], [2, 0], [2, 2]]
    inner = Curve([(0, 0), (1, 1), (4, 0), (0, 4)])
    assert hull(inner, 0).tolist() == [[0, 0], [4, 0], [0, 4]]
    assert hull(Curve([(3, 3)] * 4), 0).tolist() == [[3, 3]]
    assert hull(Curve(np.multiply([(0, 0), (4, 0), (0, 4)], 1e-289), 0.0, 2), 0).shape == (3, 2)
    assert hull(Curve([(0, 0), (1, 1), (2, 2), (3, 3)]), 0).tolist() == [[0, 0], [3, 3]]
    clamped = Curve([(0, 0), (1, 1), (3, 0)], degree=2, ends="clamped")
    assert hull(clamped, 0).tolist() == [[-1, -1], [5, -1], [1, 1]]
    with pytest.raises(ValueError, match="project the curve's control points first"):
        hull(Curve(np.eye(4)[:, :3]), 0)
    with pytest.raises(ValueError, match="there is no segment 1"):
        hull(square, 1)


@given(curves(low=-10, high=5))
def test_joints_are_reversed_where_velocity_or_bend_runs_against_the_polygons(curve):
    found = {joint.joint: joint for joint in reversed_joints(curve)}
    neutral = curve.with_(lambdas=0.0)
    nu = curve.degree - 1
    for joint in range(len(curve.joints)):
        now, usual = curve(joint, nu), neutral(joint, nu)
        if np.linalg.norm(usual) > 1e-9 * scale(curve):
            assert (joint in found) == (now @ usual <= 1e-14 * scale(curve) * np.linalg.norm(usual))
        elif joint in found:
            assert np.linalg.norm(usual) > 0
    for joint in found.values():
        assert joint.point == (joint.joint + curve.first_segment) % len(curve.control_points)


def test_what_happens_at_a_reversed_joint_is_said():
    points = [(0, 0), (1, 2), (3, -1), (5, 1), (6, 0), (9, 1)]

    def reasons(lam, degree):
        return [joint.reason for joint in reversed_joints(Curve(points, lam, degree))]

    below, at = [0, 0, -5, 0, 0, 0], [0, 0, JOINT_SLOPE_ZERO, 0, 0, 0]
    assert reasons(below, 2) == [
        "λ₂ = −5 is below −2.648…: the velocity reverses at joint 2, which makes a cusp or a loop"
    ]
    assert reasons(below, 3) == [
        "λ₂ = −5 is below −2.648…: the second derivative at joint 2 is reversed, which adds inflections"
    ]
    assert reasons(at, 2) == ["λ₂ = −2.648…: the curve stands still at joint 2, where it is C¹ but not G¹"]
    assert reasons(at, 3) == [
        "λ₂ = −2.648…: the second derivative vanishes at joint 2, where the curve has no curvature"
    ]
    assert reasons([0, -5, 0, 0, 0, -5], 2) == [
        f"λ{name} = −5 is below −2.648…: the velocity at joint {joint}, an end of the curve, is reversed"
        for name, joint in (("₁", 1), ("₅", 5))
    ]
    assert reasons(-2.6, 3) == []
    even = Curve(np.outer(range(6), (0.1, 0.7)), -5.0)
    assert reversed_joints(even) == ()  # straight: nothing bends there, whatever λ is
