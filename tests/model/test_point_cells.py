"""Edited and pasted cells, against the curve's own methods."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from theditor.model.point_cells import (
    cells_of,
    columns,
    copied,
    differing_rows,
    edited,
    mode_at,
    pasted,
    text,
)
from theditor.spline import INTERPOLATING, Curve, Mode

coordinates = st.floats(-1e12, 1e12)
lambdas = st.sampled_from([0.0, 1.0, *INTERPOLATING.values()]) | st.floats(-1e6, 1e6)


@st.composite
def curves(draw):
    degree, closed, ends = draw(
        st.tuples(st.sampled_from([2, 3]), st.booleans(), st.sampled_from(["free", "clamped"]))
    )
    count, dimension = draw(st.integers(4, 7)), draw(st.sampled_from([2, 3]))
    points = draw(st.lists(st.tuples(*[coordinates] * dimension), min_size=count, max_size=count))
    return Curve(points, draw(st.lists(lambdas, min_size=count, max_size=count)), degree, closed, ends)


@st.composite
def blocks(draw):
    """A curve, and where a block of its cells begins and ends."""
    curve = draw(curves())
    rows = sorted(draw(st.tuples(*[st.integers(0, len(curve.lambdas) - 1)] * 2)))
    places = sorted(draw(st.tuples(*[st.integers(0, curve.dimension)] * 2)))
    return curve, rows, places


def some_curve(**kind):
    return Curve([[0, 1], [1, 3], [3, 2], [4, 0], [6, 1]], [0, 0.25, 1, 1, 0], **kind)


@given(curves(), st.data())
def test_a_typed_number_is_what_with_points_or_with_lambdas_makes_of_it(curve, data):
    row = data.draw(st.integers(0, len(curve.lambdas) - 1))
    column = data.draw(st.integers(0, curve.dimension))
    number = data.draw(lambdas if column == curve.dimension else coordinates)
    points = curve.control_points[row].copy()
    if column < curve.dimension:
        points[column] = number
        expected = curve.with_points([row], [points])
    else:
        expected = curve.with_lambdas([row], [number])
    assert edited(curve, row, column, repr(number)) == expected
    for old, new in ((curve, expected), (expected, curve)):
        changed = set(differing_rows(old, new).tolist())
        assert changed >= {r for r in range(len(curve.lambdas)) if _row(old, r) != _row(new, r)}
        assert changed <= {row, (row - 1) % len(curve.lambdas)}


def _row(curve, row):
    return [text(curve, row, column) for column in range(len(columns(curve)))]


@given(curves())
def test_text_that_was_not_changed_changes_no_bit(curve):
    for row in range(len(curve.lambdas)):
        for column in range(len(columns(curve))):
            assert edited(curve, row, column, text(curve, row, column)) is curve


@given(blocks())
def test_copied_cells_paste_back_bit_for_bit_whatever_was_there(block):
    curve, rows, places = block
    cells = [(place, np.arange(rows[0], rows[1] + 1)) for place in range(places[0], places[1] + 1)]
    other = Curve(curve.control_points * 0 + 7, 0.5, curve.degree, curve.closed, curve.ends)
    result = pasted(other, rows[0], places[0], cells_of(copied(curve, cells)))
    source = np.c_[curve.control_points, curve.lambdas]
    expected = np.c_[other.control_points, other.lambdas]
    inside = slice(rows[0], rows[1] + 1), slice(places[0], places[1] + 1)
    expected[inside] = source[inside]
    assert np.array_equal(np.c_[result.control_points, result.lambdas], expected)


def test_relative_input_and_arithmetic_go_on_from_the_cell():
    curve = some_curve()
    assert edited(curve, 1, 1, "+1,5").control_points[1].tolist() == [1, 4.5]
    assert edited(curve, 1, 1, "*2").control_points[1].tolist() == [1, 6]
    assert edited(curve, 1, 2, "2/3").lambdas[1] == 2 / 3


@pytest.mark.parametrize("typed", ["H", "h", "hyperbolic"])
def test_a_mode_is_typed_by_letter_or_word(typed):
    curve = some_curve(ends="clamped")
    assert edited(curve, 1, 3, typed) == curve.with_mode([1], Mode.HYPERBOLIC)
    assert mode_at(curve, 2) is Mode.HYPERBOLIC
    assert mode_at(curve, 4) is None


@pytest.mark.parametrize(
    ("row", "column", "typed", "words"),
    [
        (1, 0, "abc", "“abc” is no number for x of P₁: type one such as"),
        (1, 1, "1e13", "Control point 1: y is 1"),
        (1, 2, "*1e9", "Control point 1: λ is 2"),
        (1, 3, "round", "“round” is no mode for Segment at P₁: type T, H or λ"),
        (4, 3, "T", "No segment begins at P₄"),
    ],
)
def test_what_cannot_stand_in_a_cell_is_refused_with_place_and_cure(row, column, typed, words):
    with pytest.raises(ValueError, match=words.replace("*", r"\*")):
        edited(some_curve(), row, column, typed)


@pytest.mark.parametrize(
    ("row", "column", "block", "words"),
    [
        (1, 0, "1\t2\n3\tx\n", "“x” is no number for y of P₂: nothing was pasted"),
        (3, 0, "1\n2\n3\n", "3 rows cannot be pasted at P₃: there is room for 2 rows"),
        (0, 2, "1\t2\t3\n", "3 columns cannot be pasted at λ: there is room for 2 columns"),
        (0, 3, "blend\n", "Modes cannot be pasted"),
        (0, 0, "", "no text to paste"),
    ],
)
def test_a_block_that_does_not_fit_is_refused_whole(row, column, block, words):
    with pytest.raises(ValueError, match=words):
        pasted(some_curve(), row, column, cells_of(block))


def test_empty_cells_and_modes_beside_lambda_are_passed_over():
    curve = some_curve()
    result = pasted(curve, 1, 1, cells_of("9\t\tblend\r\n\t0,5\ttrigonometric\r\n"))
    assert result == curve.with_points([1], [[1, 9]]).with_lambdas([2], [0.5])
