"""Long work beside the window: what comes of it is handed over in the window's own time, or called off."""

import threading

import pytest
from hand import Hand
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from theditor.app.work_card import WorkCard
from theditor.drawing import Drawing, DrawingError

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
