"""The document: every edit one exact undo step, previews that leave no trace, files."""

import gc
import weakref

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from theditor.drawing import Drawing, DrawingError, Item, load
from theditor.model import Document
from theditor.spline import Curve


def drawing(shift=0.0):
    points = np.array([[0.0, 0.0], [1.0, 2.0], [3.0, 1.0], [4.0, 0.0], [5.0, 2.0]])
    return Drawing(
        [Item(Curve(points + shift, 0.5), name="one"), Item(Curve(points * 2, degree=2), name="two")]
    )


def moved(value, index, x):
    curve = value[0].curve
    return value.with_curve(0, curve.with_points([index], [[x, curve.control_points[index, 1]]]))


@pytest.fixture
def document(qapp):
    return Document(drawing())


def test_a_gesture_is_one_step_however_many_previews(document):
    before = document.drawing
    gesture = document.begin("Move control point")
    for x in (1.1, 1.2, 1.3):
        gesture.preview(moved(gesture.before, 1, x))
    gesture.commit()
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "Move control point"
    document.undo()
    assert document.drawing == before
    document.redo()
    assert document.drawing[0].curve.control_points[1, 0] == 1.3


def test_a_cancelled_gesture_leaves_no_trace_and_keeps_the_redo_branch(document):
    document.apply("Edit", moved(document.drawing, 1, 9.0))
    document.undo()
    before = document.drawing
    gesture = document.begin("Move control point")
    gesture.preview(moved(gesture.before, 2, 7.0))
    assert not document.is_clean
    gesture.cancel()
    gesture.preview(moved(before, 2, 8.0))
    assert document.drawing == before
    assert document.is_clean
    assert document.undo_stack.canRedo()


def test_a_gesture_that_ends_where_it_began_is_no_step(document):
    gesture = document.begin("Move control point")
    gesture.preview(moved(gesture.before, 1, 5.0))
    gesture.preview(gesture.before)
    gesture.commit()
    assert document.undo_stack.count() == 0


def test_undo_during_a_gesture_takes_the_gesture_back(document):
    before = document.drawing
    gesture = document.begin("Move control point")
    gesture.preview(moved(before, 1, 5.0))
    document.undo()
    assert document.drawing == before
    assert not gesture.is_open
    assert document.undo_stack.redoText() == "Move control point"


def test_only_an_unbroken_run_of_steps_with_the_same_key_merges(document):
    first = document.drawing
    for x in (1.1, 1.2):
        document.apply("Nudge", moved(document.drawing, 1, x), merge=("nudge", 1))
    assert document.undo_stack.count() == 1
    document.break_run()
    document.apply("Nudge", moved(document.drawing, 1, 1.3), merge=("nudge", 1))
    assert document.undo_stack.count() == 2
    document.apply("Nudge", moved(document.drawing, 2, 1.4), merge=("nudge", 2))
    assert document.undo_stack.count() == 3
    while document.undo_stack.canUndo():
        document.undo()
    assert document.drawing == first


def test_a_run_that_comes_back_to_its_start_is_no_step(document):
    start = document.drawing
    document.apply("Nudge", moved(start, 1, 2.0), merge="nudge")
    document.apply("Nudge", moved(start, 1, 1.0), merge="nudge")
    assert document.drawing == start
    assert not document.undo_stack.canUndo()


def test_views_hear_of_the_old_and_the_new_value(document, qtbot):
    before = document.drawing
    with qtbot.waitSignal(document.changed) as heard:
        document.apply("Edit", moved(before, 1, 9.0))
    assert heard.args == [before, document.drawing]
    assert heard.args[0][0].curve is before[0].curve


def test_save_settles_the_gesture_and_makes_clean(document, tmp_path):
    gesture = document.begin("Move control point")
    gesture.preview(moved(gesture.before, 1, 5.0))
    document.save(tmp_path / "a.json")
    assert not gesture.is_open
    assert load(tmp_path / "a.json") == document.drawing
    assert document.is_clean
    assert document.title == "a"
    document.undo()
    assert not document.is_clean
    document.redo()
    assert document.is_clean


def test_a_failed_save_or_open_changes_nothing(document, tmp_path):
    document.apply("Edit", moved(document.drawing, 1, 9.0))
    value = document.drawing
    with pytest.raises(DrawingError):
        document.save(tmp_path / "no such folder" / "a.json")
    with pytest.raises(DrawingError):
        document.open(tmp_path / "missing.json")
    assert document.drawing is value
    assert document.path is None
    assert document.undo_stack.canUndo()
    assert not document.is_clean


def test_opening_forgets_the_history(document, tmp_path):
    document.save(tmp_path / "a.json")
    document.apply("Edit", moved(document.drawing, 1, 9.0))
    document.open(tmp_path / "a.json")
    assert document.undo_stack.count() == 0
    assert document.drawing == drawing()


def test_a_jump_tells_of_the_drawing_before_it_tells_of_the_step(document):
    for index in range(4):
        document.apply("Add", document.drawing.inserted(0, drawing(index)[0]))
    heard = []
    document.changed.connect(lambda old, new: heard.append(len(new)))
    document.stepped.connect(lambda: heard.append("step"))
    document.jump(1)
    assert heard[0] == len(document.drawing) == 3
    assert "step" in heard
    assert heard.count(3) == 1
    document.jump(4)
    assert len(document.drawing) == 6


edits = st.lists(
    st.tuples(
        st.sampled_from(["move", "shape", "drop", "add", "undo", "redo"]), st.integers(0, 4), st.floats(-5, 5)
    )
)


@given(edits)
def test_undoing_everything_gives_the_first_value_and_redoing_the_last(edits):
    document = Document(drawing())
    first = document.drawing
    for kind, index, value in edits:
        now = document.drawing
        match kind:
            case "undo":
                document.undo()
            case "redo":
                document.redo()
            case "drop" if len(now) > 1:
                document.apply("Delete", now.without(0))
            case "add":
                document.apply("Add", now.inserted(0, drawing(value)[0]))
            case "move":
                document.apply("Move", moved(now, index, value), merge=index)
            case "shape":
                document.apply("Shape", now.with_curve(0, now[0].curve.with_lambdas([index], [value])))
    last, stack = document.drawing, document.undo_stack
    done = stack.index()
    stack.setIndex(0)
    assert document.drawing == first
    stack.setIndex(done)
    assert document.drawing == last


def test_documents_that_nobody_needs_go_with_all_their_steps(qapp):
    gone = []
    for _ in range(12):
        document = Document(Drawing([Item(Curve([[0, 0], [1, 2], [3, 2], [4, 0]]))]))
        for x in (1.0, 2.0):
            document.apply_curve("Move", 0, document.drawing[0].curve.with_points(1, [x, 0.0]))
        gone.append(weakref.ref(document))
    del document
    gc.collect()
    assert [ref() for ref in gone] == [None] * 12
