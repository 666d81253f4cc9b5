import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from outline_points import along, farthest
from spline_strategies import curves, scale

from theditor.spline import INTERPOLATING, Curve, Piece, known, outline, path_data


def size_of(curve):
    return float(np.ptp(curve.sample(8), axis=0).max()) or 1.0


# There and back on a line, with a turn within rounding of a joint.
THERE_AND_BACK = Curve([[0, 0], [0, 0], [0, 0], [0, 0], [2, 0], [2**-24, 1.69664336e-32], [0, 0]], 0.0, 3)


@settings(max_examples=20)
@example(THERE_AND_BACK, 1e-2, False, False)
@given(curves(), st.sampled_from([1e-2, 1e-3, 1e-4]), st.booleans(), st.booleans())
def test_an_outline_is_the_curve_within_the_tolerance_and_says_how_nearly(curve, part, arcs, conics):
    size = size_of(curve)
    pieces = outline(curve, part * size, arcs=arcs, conics=conics)
    assume(size > 1e-100)  # else the test itself has no digits left
    rounding = 1e-14 * scale(curve)
    assert pieces.deviation <= part * size + rounding
    # What chords hide: 300 to a segment little, 64 to a piece more.
    assert farthest(along(pieces, 12), curve.sample(300)) <= pieces.deviation + 2e-5 * size + rounding
    assert farthest(curve.sample(12), along(pieces, 64)) <= pieces.deviation + 1e-4 * size + rounding
    np.testing.assert_allclose(
        pieces.ends[[0, -1]], curve([0, curve.segment_count]), atol=1e-14 * scale(curve)
    )
    if curve.closed:
        np.testing.assert_array_equal(pieces.ends[0], pieces.ends[-1])


@settings(max_examples=25)
@given(curves(degrees=(2,), low=0, high=0))
def test_quadratic_trigonometric_segments_are_ellipse_arcs_or_lines(curve):
    quadratic = curve.with_(lambdas=np.zeros(len(curve.lambdas)))
    pieces = outline(quadratic, conics=True)
    assert not (pieces.kinds == Piece.CUBIC).any()
    assert pieces.deviation == 0
    assert farthest(along(pieces, 7), quadratic.sample(700)) <= 1e-5 * size_of(quadratic)
    # Each arc's middle is the curve's, to rounding.
    arcs = np.flatnonzero(pieces.kinds == Piece.ARC)
    root = np.sqrt(0.5)
    middles = pieces.inner[arcs, 0] * (1 - 2 * root) + root * (pieces.ends[arcs] + pieces.ends[arcs + 1])
    every = quadratic(np.arange(quadratic.segment_count) + 0.5)
    for middle in middles:
        assert np.linalg.norm(every - middle, axis=1).min() <= 1e-14 * scale(quadratic)


@pytest.mark.parametrize("degree", [2, 3])
def test_a_known_ellipse_is_four_exact_quarters_of_either_degree(degree):
    points = (
        [[-3, 1], [3, 1], [3, -1], [-3, -1]]
        if degree == 2
        else np.array([[0, 1.0], [2, 0], [0, -1], [-2, 0]]) * np.pi / 2
    )
    ellipse = Curve(points, 0.0, degree, closed=True)
    pieces = outline(ellipse)
    assert pieces.kinds.tolist() == [Piece.ARC] * 4
    x, y = along(pieces).T
    a, b = (3, 1) if degree == 2 else (2, 1)
    np.testing.assert_allclose((x / a) ** 2 + (y / b) ** 2, 1, atol=1e-14)


def test_quadratic_hyperbolic_segments_are_exact_rational_quadratics_in_space_too():
    curve = Curve([[0, 0, 1], [1, 2, 0], [3, 2, 2], [4, 0, 5]], 1.0, 2)
    pieces = outline(curve, conics=True)
    assert pieces.kinds.tolist() == [Piece.CONIC] * 2
    assert pieces.deviation == 0
    # The middle of a rational quadratic lies at t = 1/2 by symmetry.
    middle = along(pieces, 2)[1::2]
    np.testing.assert_allclose(middle, curve([0.5, 1.5]), atol=1e-15 * scale(curve) * 4)
    assert farthest(along(pieces, 8), curve.sample(3000)) < 1e-7


def test_a_straight_segment_that_turns_back_reaches_as_far_as_the_curve():
    curve = Curve([[0, 0], [5, 5], [2, 2], [3, 3]], 3.0, ends="clamped")
    pieces = outline(curve)
    assert set(pieces.kinds.tolist()) == {Piece.LINE}
    assert pieces.ends.max() == pytest.approx(curve.sample(2000).max(), abs=1e-6)
    np.testing.assert_allclose(pieces.ends[[0, -1]], [[0, 0], [3, 3]], atol=1e-15)


def test_a_polygon_of_a_clamped_curve_in_a_row_is_one_line():
    row = np.column_stack((np.arange(20.0), 2 * np.arange(20.0)))
    assert outline(Curve(row, ends="clamped")).ends.tolist() == [[0, 0], [19, 38]]


def test_a_curve_that_is_a_point_has_one_piece():
    pieces = outline(Curve([[2, 3]] * 4))
    assert pieces.ends.tolist() == [[2, 3], [2, 3]]


def test_a_cusp_and_a_loop_are_met_within_the_tolerance():
    cusp = known.cycloid(radius=1.0, start=-np.pi)
    loop = Curve([[0, 0], [9, 1], [-8, 1], [1, 0]], INTERPOLATING[3])
    for curve in (cusp, loop, cusp.with_(control_points=cusp.control_points + 1e6)):
        pieces = outline(curve, 1e-6)
        assert 0 < pieces.deviation <= 1e-6
        assert len(pieces.kinds) < 60 * curve.segment_count
        assert farthest(curve.sample(64), along(pieces, 64)) <= 2e-6


def test_a_quarter_circle_takes_one_cubic_within_a_thousandth():
    circle = Curve([[-1, 1], [1, 1], [1, -1], [-1, -1]], 0.0, 2, closed=True)
    pieces = outline(circle, 3e-4, arcs=False)
    assert len(pieces.kinds) == 4
    # The best cubic with these ends and tangents is 1.96e-4 off where both signs may occur.
    assert pieces.deviation == pytest.approx(2.1e-4, rel=0.05)


def test_a_finer_tolerance_costs_its_sixth_root():
    curve = Curve([[0, 0], [1, 2], [3, 2], [4, 0]], 0.5)
    counts = [len(outline(curve, tolerance).kinds) for tolerance in (1e-4, 1e-7, 1e-10)]
    assert counts[0] == 1
    assert counts == sorted(counts)
    assert counts[2] <= 32  # 10 for one, but pieces are halves of halves


@pytest.mark.parametrize("tolerance", [0, -1, float("nan"), float("inf")])
def test_a_tolerance_that_is_none_is_refused(tolerance):
    with pytest.raises(ValueError, match="tolerance must be a positive number"):
        outline(Curve([[0, 0], [1, 1], [2, 0], [3, 3]]), tolerance)


def test_path_data_reads_back_as_the_same_numbers():
    ellipse = Curve([[-3, 1], [3, 1], [3, -1], [-3, -1]], 0.0, 2, closed=True)
    assert path_data(outline(ellipse)) == (
        "M-3.0,0.0A3.0,1.0 0.0 0 0 0.0,1.0A3.0,1.0 0.0 0 0 3.0,0.0"
        "A3.0,1.0 0.0 0 0 0.0,-1.0A3.0,1.0 0.0 0 0 -3.0,0.0Z"
    )
    third = Curve([[0, 0], [1 / 3, 1e-9], [1e12, 5]], 0.0, 2, ends="clamped")
    assert repr(float(third(1.0)[0])) in path_data(outline(third))


def test_path_data_refuses_what_it_cannot_say():
    with pytest.raises(ValueError, match="plane outline"):
        path_data(outline(Curve([[0, 0, 0], [1, 1, 1], [2, 0, 3], [3, 3, 1]])))
    with pytest.raises(ValueError, match="rational"):
        path_data(outline(Curve([[0, 0], [1, 1], [2, 0]], 1.0, 2), conics=True))


def test_a_notebook_shows_a_curve_as_it_lies():
    svg = Curve([[0, 0], [4, 0], [4, 2], [0, 3]], ends="clamped")._repr_svg_()
    assert svg.startswith("<svg ")
    d = svg.split('d="')[1].split('"')[0]
    start, end = d[1:].split("C")[0].split(","), d.split(" ")[-1].split(",")
    assert float(start[1]) > float(end[1])  # the start is below the end: y runs upward
    assert Curve([[1, 1]] * 4)._repr_svg_().count("<path") == 1
