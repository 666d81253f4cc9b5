"""Curves split, joined, opened, closed and changed in degree, as undo steps that say how well."""

import numpy as np
import pytest

from theditor.canvas import pieces
from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection
from theditor.spline import Curve, nearest

POINTS = [[0.0, 0.0], [1.0, 3.0], [3.0, 3.0], [5.0, -1.0], [7.0, 0.0], [8.0, 2.0]]


def opened_with(*curves, **style):
    document = Document(Drawing([Item(curve, name=name) for name, curve in zip("abc", curves, strict=False)]))
    return document, Selection(document)


def on(shape, curve):
    """How far places on one curve are from another at most."""
    return max(nearest(curve, place)[1] for place in shape.sample(8))


def test_a_curve_is_split_at_the_joint_of_the_selected_point_and_joined_again():
    whole = Curve(POINTS, [0, 0.5, 1, 0, -1, 0], ends="clamped")
    document, selection = opened_with(whole)
    selection.select(points={2})
    assert pieces.split(document, selection) == "Split “a (2)” off “a”; the shape is the same"
    first, second = (item.curve for item in document.drawing)
    assert first(first.segment_count) == pytest.approx(whole(2), abs=1e-12)
    assert on(first, whole) < 1e-12
    assert on(second, whole) < 1e-12
    assert document.undo_stack.undoText() == "Split curve"
    assert pieces.join(document, selection) == "Joined “a” and “a (2)”; the shape is the same"
    assert len(document.drawing) == 1
    assert on(whole, document.drawing[0].curve) < 1e-9
    document.undo()
    document.undo()
    assert document.drawing[0].curve == whole


def test_each_part_of_a_curve_has_a_name_of_its_own():
    document, selection = opened_with(Curve(POINTS))
    for _ in range(2):
        selection.select(curve=len(document.drawing) - 1, segments={0, 1})
        pieces.split(document, selection)
    assert [item.name for item in document.drawing] == ["a", "a (2)", "a (3)"]


def test_two_segments_say_where_to_split_too():
    document, selection = opened_with(Curve(POINTS))
    selection.select(segments={1, 2})
    pieces.split(document, selection)
    assert [item.curve.segment_count for item in document.drawing] == [2, 1]


@pytest.mark.parametrize(
    ("chosen", "reason"),
    [
        ({"points": {1}}, "no two segments meet at P₁"),
        ({"points": {2, 3}}, "select one control point"),
        ({"segments": {0, 2}}, "select one control point"),
    ],
)
def test_a_split_that_cannot_be_is_refused_with_its_reason(chosen, reason):
    document, selection = opened_with(Curve(POINTS))
    selection.select(**chosen)
    with pytest.raises(ValueError, match=reason):
        pieces.split(document, selection)
    assert document.undo_stack.count() == 0


@pytest.mark.parametrize("turn_first", [False, True])
@pytest.mark.parametrize("turn_second", [False, True])
@pytest.mark.parametrize("swap", [False, True])
def test_the_nearest_ends_are_joined_whichever_way_the_curves_run(turn_first, turn_second, swap):
    left = Curve([[0, 0], [1, 1], [2, 0], [3, 1]], ends="clamped")
    right = Curve([[3.2, 1], [4, 2], [5, 1]], ends="clamped")
    far = Curve([[90, 90], [91, 92], [93, 90]], ends="clamped")
    curves = [left.reversed() if turn_first else left, right.reversed() if turn_second else right]
    document, selection = opened_with(*(curves[::-1] if swap else curves), far)
    selection.select(curve=1)
    pieces.join(document, selection)
    assert len(document.drawing) == 2
    assert selection.curve == 0
    joined = document.drawing[0].curve
    ends = joined([0, joined.segment_count])
    assert sorted(ends[:, 0].tolist()) == pytest.approx([0, 5], abs=1e-9)
    assert document.drawing[1].curve == far


def test_of_several_selected_curves_one_of_those_is_joined():
    left = Curve([[0, 0], [1, 1], [2, 0], [3, 1]], ends="clamped")
    near, far = (Curve([[x, 1], [x + 1, 2], [x + 2, 1]], ends="clamped") for x in (3.2, 9))
    document, selection = opened_with(left, near, far)
    selection.select_across({0: [], 2: []})
    assert pieces.join(document, selection).startswith("Joined “a” and “c”; ")
    assert document.drawing[1].curve == near


def test_a_curve_without_a_partner_is_told():
    document, selection = opened_with(Curve(POINTS), Curve(POINTS, degree=2))
    with pytest.raises(ValueError, match="no other open cubic curve"):
        pieces.join(document, selection)


def test_closing_and_opening_keep_the_curve():
    ring = Curve(POINTS, closed=True)
    document, selection = opened_with(ring)
    selection.select(points={3})
    said = []
    pieces.close_or_open(document, selection, said.append)
    assert said.pop() == "Opened the curve; the shape is the same"
    cut = document.drawing[0].curve
    assert not cut.closed
    assert cut(0) == pytest.approx(ring(3), abs=1e-12)
    pieces.close_or_open(document, selection, said.append)
    assert said == ["Closed “a” by a new part from end to start; elsewhere the shape is the same"]
    again = document.drawing[0].curve
    assert np.sort(again.control_points, axis=0) == pytest.approx(np.sort(POINTS, axis=0))


def test_the_degree_changes_with_the_shape_kept_and_its_change_told():
    cubic = Curve(POINTS, ends="clamped")
    document, selection = opened_with(cubic)
    said = []
    pieces.change_degree(document, selection, said.append)
    (text,) = said
    quadratic = document.drawing[0].curve
    assert quadratic.degree == 2
    told = float(text.removeprefix("Made “a” quadratic; the shape changed by at most "))
    assert on(cubic, quadratic) <= told < 0.5
    assert document.undo_stack.undoText() == "Make curve quadratic"
