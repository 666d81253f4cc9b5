"""The selection: what the λ controls act on, and how it follows the drawing."""

import numpy as np
import pytest

from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection
from theditor.spline import Curve

POINTS = [[0.0, 0.0], [1.0, 2.0], [3.0, 1.0], [4.0, 0.0], [5.0, 2.0]]


@pytest.fixture
def document(qapp):
    hidden = Item(Curve(POINTS), name="hidden", visible=False)
    return Document(Drawing([hidden, Item(Curve(POINTS)), Item(Curve(POINTS, degree=2))]))


@pytest.fixture
def selection(document):
    return Selection(document)


def test_the_first_visible_curve_is_current(selection):
    assert selection.curve == 1


def test_lambda_controls_act_on_points_else_segments_else_all(selection):
    assert selection.lambda_indices().tolist() == [0, 1, 2, 3, 4]
    selection.select(segments={1})
    assert selection.lambda_indices().tolist() == [2, 3]
    selection.select(points={4, 0})
    assert selection.lambda_indices().tolist() == [0, 4]


def test_another_curve_starts_with_nothing_selected(selection):
    selection.select(points={1}, segments={0})
    selection.select(curve=2)
    assert (selection.points, selection.segments) == (frozenset(), frozenset())


def test_what_no_longer_exists_is_dropped(document, selection):
    selection.select(points={3, 4, 77}, segments={0, 1})
    assert selection.points == {3, 4}
    document.apply("Shorten", document.drawing.with_curve(1, Curve(POINTS[:4])))
    assert (selection.points, selection.segments) == ({3}, {0})
    document.apply("Delete all", Drawing())
    assert (selection.curve, selection.item, selection.points) == (-1, None, frozenset())
    document.undo()
    assert selection.curve == 1


def test_another_drawing_starts_with_nothing_selected(document, selection):
    selection.select(curve=2, points={1}, segments={0})
    document.start(document.drawing)
    assert (selection.curve, selection.points, selection.segments) == (1, frozenset(), frozenset())


def test_it_tells_of_changes_only(selection, qtbot):
    selection.select(points={1})
    with qtbot.assertNotEmitted(selection.changed):
        selection.select(points={1})
    with qtbot.waitSignal(selection.changed):
        selection.select(points=())


def across(selection):
    return {curve: points.tolist() for curve, points in selection.across.items()}


def test_points_are_selected_on_several_curves(document, selection):
    selection.select_across({1: [4, 0, 4], 2: {3, 99}})
    assert across(selection) == {1: [0, 4], 2: [3]}
    assert (selection.curve, selection.points, selection.curves) == (1, {0, 4}, (1, 2))
    assert {i: of.tolist() for i, of in selection.lambdas_across().items()} == {1: [0, 4], 2: [3]}
    selection.select(points={2})
    assert across(selection) == {1: [2]}, "a selection on one curve leaves no other"


def test_the_current_curve_is_one_with_something_selected(selection):
    selection.select_across({2: [1]})
    assert selection.curve == 2
    selection.select_across({1: [], 2: []}, curve=1)
    assert (selection.curve, selection.curves, across(selection)) == (1, (1, 2), {})
    assert selection.lambdas_across().keys() == {1, 2}


def test_hidden_and_locked_curves_have_no_points_selected(document, selection):
    selection.select_across({0: [1], 1: [1], 2: [1]})
    assert across(selection) == {1: [1], 2: [1]}
    document.apply("Lock", document.drawing.with_item(2, document.drawing[2].with_(locked=True)))
    assert across(selection) == {1: [1]}
    assert selection.curves == (0, 1, 2), "chosen as a whole it stays, to be unlocked"


def test_it_follows_curves_that_come_go_and_change_places(document, selection):
    drawing = document.drawing
    selection.select_across({1: [1], 2: [2]}, curve=2)
    document.apply("Insert", drawing.inserted(0, Item(Curve(POINTS))))
    assert (selection.curve, across(selection)) == (3, {2: [1], 3: [2]})
    moved = drawing[1].curve.with_points([0], [[9.0, 9.0]])
    document.apply("Edit", document.drawing.with_curve(2, moved))
    document.apply("Reorder", document.drawing.without(3).inserted(0, document.drawing[3]))
    assert (selection.curve, across(selection)) == (0, {0: [2], 3: [1]})
    document.apply("Delete", document.drawing.without(0))
    assert across(selection) == {2: [1]}, "nothing is selected on the curve that takes its place"
    for _ in range(4):
        document.undo()
    assert (document.drawing, across(selection)) == (drawing, {1: [1]})


def test_what_is_selected_stays_the_same_where_points_before_it_come_and_go(document, selection):
    points = np.array([[k, k % 3] for k in range(9)], dtype=float)
    document.apply("Lengthen", document.drawing.with_curve(1, Curve(points)))
    selection.select(points={1, 3, 7}, segments={0, 5})
    document.apply("Delete", document.drawing.with_curve(1, Curve(np.delete(points, 3, axis=0))))
    assert (selection.points, selection.segments) == ({1, 6}, {4})
    document.undo()
    assert (selection.points, selection.segments) == ({1, 7}, {5})


def test_one_edit_of_many_curves_keeps_what_is_selected_on_them(qapp):
    document = Document(Drawing([Item(Curve(POINTS)) for _ in range(5)]))
    selection = Selection(document)
    selection.select_across({i: [i] for i in range(5)})
    new = {i: document.drawing[i].curve.with_points([i], [[7.0, 7.0]]) for i in range(5)}
    document.apply("Move", document.drawing.with_curves(new))
    document.undo()
    assert across(selection) == {i: [i] for i in range(5)}


def test_curves_that_do_not_exist_are_dropped(selection):
    selection.select_across({2: [1], 7: [0], -1: [0]})
    assert (selection.curve, across(selection)) == (2, {2: [1]})
