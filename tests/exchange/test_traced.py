"""Contours become TH-curves: exactly where such a curve exists, else within the tolerance."""

import numpy as np
import pytest
import svgelements
from hypothesis import given, settings
from hypothesis import strategies as st

from theditor.drawing import DrawingError
from theditor.exchange.contour import ellipse, polyline, size
from theditor.exchange.path_data import contours
from theditor.exchange.traced import traced
from theditor.spline import nearest

KAPPA = 0.5522847498307936


def only(data):
    found, fault = contours(data)
    assert fault is None
    (contour,) = found
    return contour


def along(data, per_piece=40):
    """Points of path data, by the library that knows paths."""
    t = np.linspace(0, 1, per_piece)
    pieces = [part for part in svgelements.Path(data) if not isinstance(part, svgelements.Move)]
    return np.array([(part.point(s).x, part.point(s).y) for part in pieces for s in t])


def missed(points, curve):
    return nearest(curve, points)[1].max()


@pytest.mark.parametrize(
    ("data", "points", "closed"),
    [
        ("M0 0L10 0", 2, False),
        ("M0 0L10 0 10 5 3 3", 6, False),
        ("M0 0L10 0 10 5Z", 6, True),
        ("M0 5a5 5 0 1 0 10 0a5 5 0 1 0-10 0z", 4, True),
        ("M2 0H8A2 2 0 0 1 10 2V6A2 2 0 0 1 8 8H2A2 2 0 0 1 0 6V2A2 2 0 0 1 2 0Z", 12, True),
        ("M0 0H20A5 5 0 0 1 20 10H0A5 5 0 0 1 0 0", 8, True),
        ("M0 0A1 1 0 0 1 0 2L-5 2", 6, False),
    ],
)
def test_lines_and_quarter_turns_are_exact(data, points, closed):
    curve, deviation, _ = traced(only(data), 1e-3)
    assert (len(curve.control_points), curve.closed, deviation) == (points, closed, 0)
    assert missed(along(data), curve) < 1e-14 * 20 + 1e-15
    assert not curve.lambdas.any()


@given(
    st.tuples(*[st.floats(-2, 2)] * 4).filter(lambda m: abs(m[0] * m[3] - m[1] * m[2]) > 0.05),
    st.tuples(*[st.floats(0.1, 5)] * 2),
)
def test_an_ellipse_stays_one_however_it_is_turned_and_skewed(linear, axes):
    matrix = np.column_stack([np.reshape(linear, (2, 2)), (3.0, -1.0)])
    curve, deviation, _ = traced(ellipse(1.0, 2.0, *axes).moved(matrix), 1e-9)
    assert (curve.degree, curve.closed, len(curve.control_points), deviation) == (2, True, 4, 0)
    inverse = np.linalg.inv(matrix[:, :2])
    back = ((curve.sample(20) - matrix[:, 2]) @ inverse.T - (1, 2)) / axes
    assert np.abs(np.hypot(*back.T) - 1).max() < 1e-9


def test_a_circle_drawn_with_beziers_is_the_circle_that_it_stands_for():
    k = 5 * KAPPA
    data = f"M5 0C5 {k} {k} 5 0 5S-5 {k}-5 0S{-k}-5 0-5S5{-k} 5 0Z"
    curve, deviation, meant = traced(only(data), 1e-6)
    assert meant
    np.testing.assert_allclose(np.hypot(*curve.sample(16).T), 5, rtol=1e-12)
    # So a point is as far from the curve as from the circle.
    assert deviation == pytest.approx(np.abs(np.hypot(*along(data, 400).T) - 5).max(), rel=1e-3)


few = settings(max_examples=12)
numbers = st.integers(-50, 50).map(str)
commands = st.one_of(
    st.tuples(st.just("L"), numbers, numbers),
    st.tuples(st.just("C"), *[numbers] * 6),
    st.tuples(st.just("Q"), *[numbers] * 4),
    st.tuples(st.just("A"), st.just("30 20 10 0 1"), numbers, numbers),
)


@few
@given(st.lists(commands, min_size=1, max_size=4), st.booleans(), st.sampled_from([2, 3]))
def test_any_path_is_met_as_nearly_as_is_said(parts, closed, degree):
    data = "M0 0" + " ".join(" ".join(part) for part in parts) + "Z" * closed
    for contour in contours(data).contours:
        tolerance = 2e-3 * size([contour])
        curve, deviation, meant = traced(contour, tolerance, degree)
        assert deviation <= tolerance or meant
        apart = missed(along(data, 12)[:: max(1, len(parts) // 2)], curve)
        assert apart <= deviation * (1 + 1e-6) + 1e-12 * size([contour])
        assert curve.closed == contour.closed


def test_a_smooth_path_takes_few_points():
    curve, deviation, _ = traced(only("M0 0C1 2 3 2 4 0"), 4e-4)
    assert len(curve.control_points) == 4
    assert 0 < deviation <= 4e-4


def test_cusps_are_corners():
    data = "M0 0C4 4 0 4 4 0"
    curve, deviation, _ = traced(only(data), 4e-4)
    assert deviation <= 4e-4
    assert nearest(curve, (2, 3))[1] < 4e-4
    assert len(curve.control_points) < 24


def test_places_that_cannot_be_coordinates_are_refused():
    for data in ("M0 0L1e400 1", "M0 0L1e13 1", "M0 0A1e300 1e300 0 0 1 1e299 5"):
        for contour in contours(data).contours:
            with pytest.raises(DrawingError, match="coordinates must be numbers within"):
                contour.moved(np.eye(2, 3))


@pytest.mark.parametrize(
    ("data", "count", "fault"),
    [
        ("", 0, None),
        ("M0 0", 0, None),
        ("M0 0L1 1 nonsense", 1, 10),
        ("L1 1", 0, 1),
        ("M0 0 1 1 2 x", 1, 12),
        ("M0 0 1 1M2 2 3 3zm1 1 2 2", 3, None),
        ("M0,0 h", 0, 7),
    ],
)
def test_path_data_is_read_up_to_its_fault(data, count, fault):
    found = contours(data)
    assert (len(found.contours), found.fault) == (count, fault)


def test_a_polyline_forgets_points_that_repeat():
    contour = polyline([(0, 0), (0, 0), (1, 0), (1, 0), (1, 1), (0, 0)], closed=True)
    assert len(contour.pieces) == 3
    assert len(traced(contour, 1e-3).curve.control_points) == 6
