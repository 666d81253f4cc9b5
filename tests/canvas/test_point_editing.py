"""Control points more and fewer, by double click, and what is said about the shape."""

import numpy as np
import pytest
from hand import CTRL, NONE
from hypothesis import given, settings
from hypothesis import strategies as st
from PySide6.QtCore import Qt

from theditor.canvas import points as edits
from theditor.canvas.points import near_edge, takes_the_curve
from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection
from theditor.model.words import shape_changed
from theditor.spline import Curve, nearest

POINTS = [[0.0, 0.0], [1.0, 3.0], [3.0, 3.0], [5.0, -1.0], [7.0, 0.0], [8.0, 2.0]]


def curve(canvas):
    return canvas.document.drawing[0].curve


@pytest.fixture
def said(canvas):
    sentences = []
    canvas.announce.connect(sentences.append)
    return sentences


def farthest(old, new):
    """How far places on one shape are from the other."""
    return max(nearest(new, place)[1] for place in old.sample(20))


def test_a_double_click_on_the_curve_inserts_a_point_and_says_what_that_changed(canvas, hand, said):
    before = curve(canvas)
    hand.double_click(before(1.5))
    after = curve(canvas)
    assert len(after.control_points) == 7
    (new,) = canvas.selection.points
    assert new == 3
    assert said[-1].startswith("Inserted P₃; the shape changed by at most 0.")
    told = float(said[-1].rsplit(" ", 1)[1])
    assert farthest(before, after) <= told
    assert told < 0.2
    assert canvas.document.undo_stack.undoText() == "Insert control point"
    canvas.document.undo()
    assert curve(canvas) == before


def test_ctrl_and_a_double_click_inserts_on_the_polygon(canvas, hand, said):
    place = np.array([1.0, 3.0]) * 0.25 + np.array([3.0, 3.0]) * 0.75
    hand.double_click(place, CTRL)
    assert np.insert(POINTS, 2, place, axis=0) == pytest.approx(curve(canvas).control_points)
    assert canvas.selection.points == {2}
    assert "on the polygon" in said[-1]


@pytest.mark.parametrize("keys", [NONE, CTRL])
def test_a_double_click_inserts_nothing_on_a_locked_curve_or_on_a_handle(canvas, hand, keys):
    hand.double_click(POINTS[2], keys)
    drawing = canvas.document.drawing
    canvas.document.start(drawing.with_item(0, drawing[0].with_(locked=True)))
    hand.double_click(curve(canvas)(1.5), keys)
    hand.double_click([2.0, 3.0], keys)
    assert curve(canvas).control_points.tolist() == POINTS


def test_the_status_line_warns_before_the_whole_curve_goes(canvas, hand, qtbot):
    with qtbot.waitSignal(canvas.pointed) as told:
        canvas.selection.select(points={0, 1})
    assert not told.args[0].hint.startswith("Delete")
    with qtbot.waitSignal(canvas.pointed) as told:
        canvas.selection.select(points={0, 1, 2})
    assert told.args[0].hint == "Delete: the whole curve, for too few control points would stay"


@st.composite
def selected(draw):
    degree, closed = draw(st.sampled_from([2, 3])), draw(st.booleans())
    ends = draw(st.sampled_from(["free", "clamped"]))
    count = draw(st.integers(5, 9))
    angles = np.linspace(0, 5, count)
    shape = np.stack([np.cos(angles) * 3, np.sin(angles) * 2], axis=1)
    chosen = draw(st.sets(st.integers(0, count - 1), min_size=1))
    return Curve(shape, draw(st.floats(-1, 2)), degree, closed, ends), chosen


@settings(max_examples=12)
@given(selected(), st.booleans())
def test_inserting_and_removing_go_one_step_each_and_keep_count(case, segments):
    curve, chosen = case
    document = Document(Drawing([Item(curve, name="a")]))
    selection = Selection(document)
    if segments:
        chosen = {i for i in chosen if i < curve.segment_count} or {0}
        selection.select(segments=chosen)
    else:
        selection.select(points=chosen)
    said = []
    edits.insert(document, selection, said.append)
    (text,) = said
    new = document.drawing[0].curve
    assert text.startswith("Inserted P")
    assert len(new.control_points) == len(curve.control_points) + len(selection.points)
    assert not segments or len(selection.points) == len(chosen)
    assert document.undo_stack.count() == 1
    edits.remove(document, selection, said.append, refit=True)
    fewer = said[-1]
    assert document.undo_stack.count() == 2
    assert fewer.startswith("Deleted")
    assert len(document.drawing[0].curve.control_points) == len(curve.control_points)


@given(selected(), st.booleans())
def test_too_few_points_left_are_none(case, refit):
    curve, chosen = case
    document = Document(Drawing([Item(curve, name="a")]))
    selection = Selection(document)
    selection.select(points=chosen)
    said = []
    edits.remove(document, selection, said.append, refit=refit)
    (text,) = said
    if takes_the_curve(curve, len(chosen)):
        assert len(document.drawing) == 0
        assert "“a”" in text
    else:
        left = document.drawing[0].curve
        assert len(left.control_points) == len(curve.control_points) - len(chosen)
        if not refit:
            assert (left.control_points == np.delete(curve.control_points, sorted(chosen), axis=0)).all()
    document.undo()
    assert document.drawing[0].curve == curve


@pytest.mark.parametrize("degree", [2, 3])
def test_corners_are_made_and_taken_away(degree):
    shape = Curve(POINTS, degree=degree)
    document = Document(Drawing([Item(shape)]))
    selection = Selection(document)
    selection.select(points={2, 4})
    assert edits.make_corners(document, selection) == "Made a corner at P₂, P₄"
    sharp = document.drawing[0].curve
    assert len(sharp.control_points) == len(POINTS) + 2 * (degree - 1)
    assert nearest(sharp, POINTS[2])[1] < 1e-12
    assert nearest(sharp, POINTS[4])[1] < 1e-12
    assert document.undo_stack.count() == 1
    # What was chosen stays so, with its repeats: the next command may take the corners back.
    assert len(selection.points) == 2 * degree
    assert edits.make_smooth(document, selection).startswith("Made the curve smooth at")
    assert document.drawing[0].curve.control_points.tolist() == POINTS
    assert selection.points == {2, 4}
    selection.select(points={2})
    assert edits.make_smooth(document, selection).startswith("Nothing changed")
    selection.select(points={0})
    with pytest.raises(ValueError, match="end of the curve"):
        edits.make_corners(document, selection)
    assert document.undo_stack.count() == 2


def test_words_round_up_and_say_when_nothing_changed():
    shape = Curve(POINTS)
    assert shape_changed(0.0, shape) == "the shape is the same"
    assert shape_changed(0.00321, shape) == "the shape changed by at most 0.0033"


def test_edges_are_found_within_reach():
    polygon = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 0.0], [10.0, 10.0]])
    assert near_edge(polygon, np.array([4.0, 3.0]), 8.0) == (0, pytest.approx(0.4))
    assert near_edge(polygon, np.array([12.0, 5.0]), 8.0) == (2, pytest.approx(0.5))
    assert near_edge(polygon, np.array([50.0, 50.0]), 8.0) is None


def test_what_was_inserted_can_be_moved_at_once(canvas, hand, qtbot):
    hand.double_click(curve(canvas)(1.5))
    before = curve(canvas).control_points[3]
    qtbot.keyClick(canvas, Qt.Key.Key_Up)
    assert curve(canvas).control_points[3][1] > before[1]
