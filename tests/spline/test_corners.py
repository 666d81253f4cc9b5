import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from spline_strategies import curves

from theditor.spline import INTERPOLATING, Curve, corner, smooth
from theditor.spline.corners import kept_places

ZIGZAG = [(0, 0), (4, 6), (9, 1), (13, 7), (18, 0), (22, 5)]


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("lam", [0.0, 1.0, -10.0, "interpolating"])
def test_a_corner_meets_its_point_straight_along_both_edges(degree, lam):
    curve = Curve(ZIGZAG, INTERPOLATING[degree] if lam == "interpolating" else lam, degree)
    new = corner(curve, 2)
    points = new.sample(200)
    gaps = np.linalg.norm(points - ZIGZAG[2], axis=1)
    tip = int(gaps.argmin())
    assert gaps[tip] < 1e-12
    for way, neighbour in ((-1, 1), (1, 3)):
        leg = points[tip + way * np.arange(1, 150)] - ZIGZAG[2]
        edge = np.subtract(ZIGZAG[neighbour], ZIGZAG[2]) / np.linalg.norm(
            np.subtract(ZIGZAG[neighbour], ZIGZAG[2])
        )
        np.testing.assert_allclose(leg - np.outer(leg @ edge, edge), 0, atol=1e-12)
        assert (np.diff(leg @ edge) > -1e-15).all()  # straight away from the corner, never past it


@given(curves(low=-2, high=3), st.data())
@settings(deadline=None)
def test_smoothing_takes_a_corner_away_again(curve, data):
    low = 0 if curve.closed else 1
    if len(curve.control_points) - 1 > low:
        index = data.draw(st.integers(low, len(curve.control_points) - 1 - low))
        if (curve.control_points == curve.control_points[index]).all(axis=1).sum() == 1:
            sharp = corner(curve, index)
            assert len(sharp.control_points) == len(curve.control_points) + curve.degree - 1
            assert corner(sharp, index) == sharp
            assert smooth(sharp, index + 1) == curve
            run = range(index, index + curve.degree)
            assert kept_places(curve, sharp, index).tolist() == [*run]
            assert kept_places(sharp, curve, run).tolist() == [index]
            assert smooth(curve, index) == curve


@given(curves(low=-2, high=3), st.data())
@settings(deadline=None)
def test_many_corners_at_once_are_as_many_one_after_the_other(curve, data):
    count = len(curve.control_points)
    # Some points lie on the one before, on a closed curve perhaps over the seam.
    again = data.draw(st.sets(st.integers(0 if curve.closed else 1, count - 1)))
    points = curve.control_points.copy()
    for i in sorted(again):
        points[i] = points[i - 1]
    curve = curve.with_(control_points=points)
    inner = [i for i in range(count) if curve.closed or not (points[[0, -1]] == points[i]).all(axis=1).any()]
    chosen = sorted(data.draw(st.sets(st.sampled_from(inner)))) if inner else []
    if (points == points[0]).all() and curve.closed:
        chosen = chosen[:1]
    one = curve
    for i in reversed(chosen):  # those before stay where they are
        one = corner(one, i)
    many = corner(curve, chosen)
    np.testing.assert_array_equal(many.control_points, one.control_points)
    np.testing.assert_array_equal(many.lambdas, one.lambdas)


@given(curves(low=-2, high=3))
@settings(deadline=None)
def test_smoothed_everywhere_a_curve_has_no_point_twice_in_a_row(curve):
    count = len(curve.control_points)
    inner = range(count) if curve.closed else range(1, count - 1)
    sharp = corner(
        curve,
        [
            i
            for i in inner
            if not (curve.control_points[[0, -1]] == curve.control_points[i]).all(axis=1).any()
        ],
    )
    try:
        plain = smooth(sharp, np.arange(len(sharp.control_points))).control_points
    except ValueError:
        assert len(np.unique(sharp.control_points, axis=0)) < 4
    else:
        steps = np.diff(plain, axis=0, append=plain[:1] if curve.closed else plain[-1:] + 1)
        assert steps.any(axis=1).all()


def test_a_corner_at_the_seam_of_a_closed_curve_can_be_smoothed():
    ring = Curve(ZIGZAG, 0.5, closed=True)
    for index in (0, 5):
        sharp = corner(ring, index)
        assert smooth(sharp, index) == ring
    wrapped = ring.with_(control_points=[ZIGZAG[0], *ZIGZAG, ZIGZAG[0]], lambdas=np.full(8, 0.5))
    plain = smooth(wrapped, 0)
    assert len(plain.control_points) == 6
    assert (plain.control_points[kept_places(wrapped, plain, 0)] == ZIGZAG[0]).all()
    again = corner(plain, kept_places(wrapped, plain, [0, 7]))
    assert kept_places(plain, again, 5).tolist() == [5, 6, 7]


def test_ends_have_no_corner():
    with pytest.raises(
        ValueError, match="control point 5 is an end of the curve: choose one between the ends"
    ):
        corner(Curve(ZIGZAG), 5)
    with pytest.raises(ValueError, match="at least 3 control points, not 2"):
        smooth(Curve([(0, 0), (0, 0), (1, 1)], degree=2), 0)
