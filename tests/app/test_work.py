"""Long work beside the window: what comes of it is handed over in the window's own time, or called off."""

import gc
import threading
import weakref

import numpy as np
import pytest
from hand import Hand
from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QApplication, QMessageBox
from shiboken6 import isValid

from theditor.app.work import MOMENT
from theditor.app.work_card import WorkCard
from theditor.canvas import freehand
from theditor.canvas import points as point_edits
from theditor.drawing import Drawing, DrawingError
from theditor.model import reshape

P5 = (1.0, 2.3130352854993315)


@pytest.fixture
def held():
    """Work that reports a quarter, then goes on when it is let go."""
    gate, ended = threading.Event(), []

    def work(progress):
        progress(0.25)
        assert gate.wait(20)
        try:
            progress(0.5)
        finally:
            ended.append(threading.current_thread())
        return threading.current_thread()

    work.let_go, work.ended = gate.set, ended
    yield work
    gate.set()


def idle(window):
    return not window.work._jobs


def test_the_window_is_used_while_work_goes_on_and_is_handed_what_comes_of_it(window, qtbot, held):
    card, done = window.findChild(WorkCard), []
    window.work.start("Counting sheep", held, done.append)
    assert card.isHidden()  # a moment's work is not worth a word
    qtbot.waitUntil(card.isVisible)
    assert (card.words.text(), card.bar.value()) == ("Counting sheep", 250)
    assert window.canvas.rect().contains(card.geometry())
    before = window.document.drawing
    Hand(window.canvas).drag(P5, (1.4, 2.0))
    assert window.document.drawing != before
    assert done == []
    held.let_go()
    qtbot.waitUntil(lambda: bool(done))
    assert done == held.ended
    assert done[0] is not threading.current_thread()
    assert card.isHidden()


def test_a_hand_on_the_drawing_is_not_disturbed(window, qtbot, held):
    hand, done = Hand(window.canvas), []
    window.work.start("Counting sheep", held, done.append)
    hand.press(P5)
    hand.move((1.2, 2.0))
    with qtbot.waitSignal(window.work.jobs[0].ended):
        held.let_go()
    QApplication.processEvents()
    assert done == []
    hand.release((1.2, 2.0))
    qtbot.waitUntil(lambda: bool(done))


def test_work_is_called_off_at_once_and_nothing_comes_of_it(window, qtbot, held):
    card, done = window.findChild(WorkCard), []
    window.work.start("Counting sheep", held, done.append)
    window.work.start("Counting goats", held, done.append)
    qtbot.waitUntil(card.isVisible)
    assert card.words.text() == "Counting sheep (and 1 more)"
    qtbot.mouseClick(card.button, Qt.MouseButton.LeftButton)
    assert window.announced == "Counting sheep was cancelled."
    assert card.words.text() == "Counting goats"
    held.let_go()
    qtbot.waitUntil(lambda: idle(window))
    assert len(held.ended) == 2
    assert len(done) == 1


def test_a_new_drawing_calls_off_what_was_for_the_old_one(window, qtbot, held):
    done = []
    window.work.start("Importing sheep", held, done.append, bound=True)
    window.work.start("Exporting sheep", held, done.append)
    window.document.start(Drawing())
    assert [job.words for job in window.work.jobs] == ["Exporting sheep"]
    held.let_go()
    qtbot.waitUntil(lambda: idle(window))
    assert len(done) == 1


def test_closing_waits_for_what_goes_to_files(window, held):
    window.work.start("Importing sheep", held, lambda _: None, bound=True)
    window.work.start("Exporting sheep", held, lambda _: None)
    exporting = window.work.jobs[1]
    threading.Timer(0.05, held.let_go).start()
    window.document.undo_stack.setClean()
    assert window.close()
    assert exporting.result is not None


def test_a_closed_window_is_gone_with_its_drawing_and_work_may_outlive_it(window, held):
    other = window.beside()
    other.open_picture("figure-10")
    Hand(other.canvas).drag(P5, (1.4, 2.0))
    done = []
    other.work.start("Importing sheep", held, done.append, bound=True)
    thread, curve = other.work.jobs[0].task, weakref.ref(other.document.drawing[0].curve)
    other.document.undo_stack.setClean()
    assert other.close()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert not isValid(other)
    del other
    gc.collect()
    assert curve() is None
    held.let_go()
    thread.join()
    QApplication.processEvents()
    assert done == []


def test_errors_of_files_are_told_and_others_reported(window, qtbot):
    def fail(error):
        def work(progress):
            raise error

        return work

    window.work.start("Reading", fail(DrawingError("sheep.svg: it holds no sheep.")), pytest.fail)
    qtbot.waitUntil(lambda: window.messages.text == "sheep.svg: it holds no sheep.")
    with qtbot.captureExceptions() as caught:
        window.work.start("Reading", fail(ZeroDivisionError("nobody thought of that")), pytest.fail)
        qtbot.waitUntil(lambda: idle(window))
    assert [str(error) for _, error, _ in caught] == ["nobody thought of that"]


@pytest.fixture
def refitted(monkeypatch, held):
    """A change of degree is long work, and goes on when it is let go."""
    with_degree = reshape.with_degree

    def wait(curve, degree, progress):
        held(progress)
        return with_degree(curve, degree, progress)

    monkeypatch.setattr(reshape, "AT_ONCE", 0)
    monkeypatch.setattr(reshape, "with_degree", wait)
    return held


def choose_degree(window, index):
    window.curve.degree.setCurrentIndex(index)
    window.curve.degree.activated.emit(index)


def test_the_degree_of_a_large_curve_changes_beside_the_window(window, qtbot, refitted):
    box, before = window.curve.degree, window.document.drawing
    old = box.currentIndex()
    choose_degree(window, 1 - old)
    assert (window.document.drawing, box.currentIndex()) == (before, old)
    window.selection.select(points=[2])
    refitted.let_go()
    qtbot.waitUntil(lambda: idle(window))
    assert window.document.drawing[0].curve.degree == 5 - before[0].curve.degree
    assert box.currentIndex() == 1 - old
    assert "the shape changed by at most" in window.announced
    window.document.undo()
    assert window.document.drawing == before
    assert box.currentIndex() == old


def test_a_curve_that_was_edited_while_its_degree_was_to_change_stays_as_it_was_edited(
    window, qtbot, refitted
):
    choose_degree(window, 1 - window.curve.degree.currentIndex())
    Hand(window.canvas).drag(P5, (1.4, 2.0))
    assert window.work.jobs == ()
    edited = window.document.drawing
    refitted.let_go()
    qtbot.waitUntil(lambda: idle(window))
    assert window.document.drawing is edited
    assert window.announced == "Making “Figure 10” quadratic was given up: “Figure 10” changed meanwhile."


def test_many_points_are_inserted_and_deleted_beside_the_window(window, qtbot, monkeypatch):
    monkeypatch.setattr(point_edits, "AT_ONCE", 1)
    before = window.document.drawing
    count = len(before[0].curve.control_points)
    window.selection.select(points=[2, 3, 5, 6])
    window.actions_by_name["insert_point"].trigger()
    assert window.work.jobs[0].words == "Inserting 2 control points"
    assert window.document.drawing is before
    qtbot.waitUntil(lambda: idle(window))
    assert window.announced.startswith("Inserted P₃, P₇; the shape changed by at most ")
    assert set(window.selection.points) == {3, 7}
    assert len(window.document.drawing[0].curve.control_points) == count + 2
    window.actions_by_name["delete_points"].trigger()
    assert window.work.jobs[0].words == "Deleting 2 control points"
    qtbot.waitUntil(lambda: idle(window))
    assert len(window.document.drawing[0].curve.control_points) == count
    window.selection.select(points=[2, 3, 5, 6])
    window.actions_by_name["insert_point"].trigger()
    window.work.cancel(window.work.jobs[0])
    assert window.announced == "Inserting 2 control points was cancelled."
    qtbot.waitUntil(lambda: idle(window))
    window.document.undo()
    window.document.undo()
    assert window.document.drawing == before


@pytest.fixture
def scribble(window, monkeypatch, held):
    """Draws a stroke that is fitted in long work, which goes on when it is let go."""
    fit = freehand.fit

    def wait(*args, **options):
        held(lambda share: None)
        return fit(*args, **options)

    monkeypatch.setattr(freehand, "AT_ONCE", 0)
    monkeypatch.setattr(freehand, "fit", wait)
    window.canvas.use("freehand")

    def draw(y):
        x = np.linspace(-0.5, 1.5, 30)
        hand = Hand(window.canvas)
        hand.press((x[0], y))
        for place in zip(x, y + 0.2 * np.sin(4 * x), strict=True):
            hand.move(place)
        hand.release(place)

    return draw


def test_a_long_stroke_is_seen_until_it_is_a_curve(window, qtbot, scribble, held):
    scribble(0.5)
    scribble(1.0)
    assert len(window.document.drawing) == 1
    waiting = window.canvas._frame().sketch.points
    assert np.isnan(waiting).any(axis=1).sum() == 1  # two strokes
    window.grab()  # paints them
    held.let_go()
    qtbot.waitUntil(lambda: idle(window))
    assert len(window.document.drawing) == 3
    assert window.canvas._frame().sketch is None
    assert window.announced.startswith("Drew a curve of ")
    window.document.undo()
    window.document.undo()
    assert len(window.document.drawing) == 1


def test_what_is_half_typed_or_selected_meanwhile_stays(window, qtbot, scribble, held):
    scribble(0.5)
    scribble(1.0)
    first, second = window.work.jobs
    window.selection.select(points=[3])
    field = window.curve.name
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "Mine")
    with qtbot.waitSignals([first.ended, second.ended]):
        held.let_go()
    QApplication.processEvents()
    assert (field.text(), len(window.document.drawing)) == ("Mine", 1)
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert window.document.drawing[0].name == "Mine"
    qtbot.waitUntil(lambda: idle(window))
    assert [item.name for item in window.document.drawing] == ["Mine", "Curve 1", "Curve 2"]
    assert (window.selection.curve, set(window.selection.points)) == (0, {3})


def test_escape_calls_off_strokes_that_are_being_fitted_then_leaves(window, qtbot, scribble, held):
    scribble(0.5)
    scribble(1.0)
    qtbot.keyClick(window.canvas, Qt.Key.Key_Escape)
    assert window.work.jobs == ()
    assert window.canvas._frame().sketch is None
    assert window.actions_by_name["tool_freehand"].isChecked()
    qtbot.keyClick(window.canvas, Qt.Key.Key_Escape)
    assert window.actions_by_name["tool_select"].isChecked()
    held.let_go()
    qtbot.waitUntil(lambda: idle(window))
    assert len(window.document.drawing) == 1


def test_undo_gives_up_what_was_for_a_curve_that_is_gone(window, qtbot, refitted):
    window.actions_by_name["add"].trigger()
    name = window.selection.item.name
    choose_degree(window, 0)
    window.document.undo()
    assert window.announced == f"Making “{name}” quadratic was given up: “{name}” changed meanwhile."
    assert window.work.jobs == ()


def test_a_stroke_that_is_called_off_is_gone_and_one_under_way_is_asked_about(
    window, qtbot, scribble, held, answer
):
    asked = answer(QMessageBox.StandardButton.Cancel)
    scribble(0.5)
    window.work.cancel(window.work.jobs[0])
    assert window.canvas._frame().sketch is None
    assert window.may_discard()
    assert asked == []
    scribble(1.0)
    threading.Timer(2 * MOMENT, held.let_go).start()
    assert not window.close()
    assert len(asked) == 1
    assert len(window.document.drawing) == 2


def test_an_edit_that_cannot_be_says_why(window, qtbot):
    window.actions_by_name["close_or_open"].trigger()
    before = window.document.drawing
    assert before[0].curve.closed
    window.selection.select(points=[2, 4])
    window.actions_by_name["close_or_open"].trigger()
    assert window.announced.startswith("Select one control point, or two segments that meet")
    assert window.document.drawing is before


def test_ends_of_many_curves_are_changed_beside_the_window(window, qtbot):
    window.actions_by_name["add"].trigger()
    for _ in range(3):
        window.selection.select_across(dict.fromkeys(range(len(window.document.drawing)), ()))
        window.actions_by_name["duplicate"].trigger()
    window.selection.select_across(dict.fromkeys(range(len(window.document.drawing)), ()))
    before = window.document.drawing
    ends = window.curve.ends
    ends.activated.emit(1 - ends.currentIndex())
    assert window.document.drawing is before
    qtbot.waitUntil(lambda: idle(window))
    assert len({item.curve.ends for item in window.document.drawing}) == 1
    assert f"{len(before)} curves" in window.announced
    window.document.undo()
    assert window.document.drawing == before
