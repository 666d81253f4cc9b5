"""The selection: what the λ controls act on, and how it follows the drawing."""

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
