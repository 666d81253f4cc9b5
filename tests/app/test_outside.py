"""Other programs change the file, and other windows have it open: nothing is lost, and nobody is surprised."""

import os
import subprocess
import sys

import pytest
from hand import Hand
from PySide6.QtCore import QEvent, QTimer
from PySide6.QtWidgets import QApplication, QPushButton

from theditor.app.outside import PATIENCE
from theditor.drawing import encode, load, save
from theditor.model.claim import owner_of_file

P5 = (1.0, 2.3130352854993315)


@pytest.fixture(autouse=True)
def data(monkeypatch, tmp_path):
    """The application's data, for this test alone."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))


@pytest.fixture
def impatient(monkeypatch):
    monkeypatch.setattr("theditor.app.outside.PATIENCE", 1)


@pytest.fixture
def file(window, tmp_path):
    """A file that the window has open."""
    path = tmp_path / "mine.json"
    save(window.document.drawing, path)
    assert window.open_path(path)
    return path


def shifted(drawing, by):
    curve = drawing[0].curve
    return drawing.with_curve(0, curve.with_points([5], [curve.control_points[5] + (by, 0.0)]))


def answer(window, words):
    button = next(b for b in window.messages.findChildren(QPushButton) if b.text() == words)
    button.click()


def replace(path, drawing):
    """Save as many editors do: another file takes the place of this one."""
    other = path.with_suffix(".new")
    other.write_bytes(encode(drawing))
    os.replace(other, path)


def write_in_place(path, drawing):
    path.write_bytes(encode(drawing))


def reply(words):
    """Press a button of the question that comes next; the list fills with its text."""
    asked = []

    def press():
        box = QApplication.activeModalWidget()
        asked.append(box.text())
        next(b for b in box.buttons() if b.text().replace("&", "") == words).click()

    QTimer.singleShot(0, press)
    return asked


@pytest.mark.parametrize("write", [replace, write_in_place])
def test_a_script_drives_the_window_live(window, file, qtbot, write):
    first = window.document.drawing
    window.selection.select(points={5, 6})
    window.canvas.show_view(1.0, 2.0, 50.0)
    for by in (0.25, 0.5):
        write(file, shifted(first, by))
        qtbot.waitUntil(lambda by=by: window.document.drawing == shifted(first, by))
    assert window.selection.points == {5, 6}
    assert (window.canvas.plane.x, window.canvas.plane.scale) == pytest.approx((1.0, 50.0))
    assert not window.isWindowModified()
    assert "Reloaded “mine.json”" in window.announced
    window.actions_by_name["undo"].trigger()
    assert "Reloaded" not in window.announced
    assert window.document.drawing == first
    assert window.isWindowModified()
    window.document.redo()
    assert not window.isWindowModified()


def test_a_rush_of_changes_is_one(window, file, qtbot):
    first, seen = window.document.drawing, []
    window.document.changed.connect(lambda _old, new: seen.append(new))
    for number in range(1, 31):
        write_in_place(file, shifted(first, number / 10))
    qtbot.waitUntil(lambda: window.document.drawing == shifted(first, 3.0))
    assert len(seen) <= 2


def test_own_saves_do_not_count(window, file, qtbot, hand):
    Hand(window.canvas).drag(P5, (1.4, 2.0))
    window.actions_by_name["save"].trigger()
    steps = window.document.undo_stack.count()
    with qtbot.waitSignal(window.outside._watch.touched):
        pass
    assert window.messages.text == ""
    assert (window.document.undo_stack.count(), window.isWindowModified()) == (steps, False)


def test_unsaved_changes_are_not_overrun(window, file, qtbot, hand):
    first = window.document.drawing
    hand.drag(P5, (1.4, 2.0))
    mine = window.document.drawing
    replace(file, shifted(first, 0.5))
    qtbot.waitUntil(lambda: "Another program has changed “mine.json”" in window.messages.text)
    assert window.document.drawing is mine
    answer(window, "Reload")
    assert window.document.drawing == shifted(first, 0.5)
    assert not window.isWindowModified()
    window.document.undo()
    assert window.document.drawing == mine
    assert window.isWindowModified()

    replace(file, shifted(first, 0.75))
    qtbot.waitUntil(lambda: "Another program" in window.messages.text)
    answer(window, "Keep mine")
    assert window.messages.text == ""
    window.document.undo()  # this state was saved once, but the file does not hold it any more
    assert window.document.drawing == first
    assert window.isWindowModified()
    window.actions_by_name["save"].trigger()
    assert load(file) == first


def test_a_save_over_a_changed_file_asks(window, file, hand, monkeypatch, tmp_path):
    hand.drag(P5, (1.4, 2.0))
    mine = window.document.drawing
    other = shifted(mine, 0.5)
    replace(file, other)  # and the user is quicker than the news
    asked = reply("Cancel")
    window.actions_by_name["save"].trigger()
    assert "“mine.json” has been changed by another program" in asked[0]
    assert load(file) == other
    assert window.isWindowModified()

    monkeypatch.setattr("theditor.app.ask.where_to_save", lambda *_: tmp_path / "elsewhere.json")
    reply("Save as…")
    window.actions_by_name["save"].trigger()
    assert load(file) == other
    assert load(tmp_path / "elsewhere.json") == mine
    assert window.document.path == tmp_path / "elsewhere.json"

    file.write_text("{ no drawing")
    replace(tmp_path / "elsewhere.json", other)
    reply("Replace")
    window.actions_by_name["save"].trigger()
    assert load(tmp_path / "elsewhere.json") == mine


def test_a_file_that_goes_is_told_and_one_that_comes_back_is_taken(impatient, window, file, qtbot):
    first = window.document.drawing
    away = file.with_name("away.json")
    file.rename(away)
    qtbot.waitUntil(lambda: "“mine.json” has been deleted or moved" in window.messages.text)
    assert window.isWindowModified()
    away.rename(file)
    qtbot.waitUntil(lambda: window.messages.text == "")
    assert not window.isWindowModified()
    assert window.document.drawing == first

    file.unlink()
    qtbot.waitUntil(lambda: "deleted or moved" in window.messages.text)
    window.actions_by_name["save"].trigger()
    assert load(file) == first
    assert (window.messages.text, window.isWindowModified()) == ("", False)


def test_a_half_written_file_is_waited_for(window, file, qtbot):
    first, told = window.document.drawing, []
    text = encode(shifted(first, 0.5))
    window.messages.tell = lambda *what: told.append(what)
    with file.open("wb", buffering=0) as stream:
        stream.write(text[:100])
        for _ in range(PATIENCE // 2):
            with qtbot.waitSignal(window.outside._watch.touched):
                pass
        assert window.document.drawing is first
        stream.write(text[100:])
    qtbot.waitUntil(lambda: window.document.drawing == shifted(first, 0.5))
    assert told == []


def test_a_broken_file_is_told_and_the_drawing_stays(impatient, window, file, qtbot):
    first = window.document.drawing
    file.write_text('{"format": "theditor", "version": 1, "curves": 7}')
    qtbot.waitUntil(lambda: "curves" in window.messages.text)
    assert "Another program has changed the file; the drawing here is as it was." in window.messages.text
    assert window.messages.text.count("mine.json") == 1
    assert window.document.drawing is first
    assert window.isWindowModified()
    replace(file, shifted(first, 0.5))
    qtbot.waitUntil(lambda: window.document.drawing == shifted(first, 0.5))
    assert (window.messages.text, window.isWindowModified()) == ("", False)
    assert "Reloaded" in window.announced
    file.write_text("{")
    qtbot.waitUntil(lambda: "the drawing here is as it was" in window.messages.text)
    assert "Reloaded" not in window.announced


def test_a_hand_on_the_drawing_is_not_disturbed(window, file, qtbot, hand):
    first = window.document.drawing
    hand.press(P5)
    hand.move((1.2, 2.0))
    held = window.document.drawing
    replace(file, shifted(first, 0.5))
    for _ in range(3):
        with qtbot.waitSignal(window.outside._watch.touched):
            pass
    assert window.document.drawing is held
    hand.release((1.2, 2.0))
    qtbot.waitUntil(lambda: "Another program" in window.messages.text)
    assert window.document.drawing == held


def test_a_file_system_that_tells_nothing_is_looked_at_when_the_user_comes_back(window, file, qtbot):
    first, watch = window.document.drawing, window.outside._watch
    with qtbot.waitSignal(watch.touched):
        watch.look_soon()
    watch._watcher.blockSignals(True)
    replace(file, shifted(first, 0.5))
    window.activateWindow()
    QApplication.sendEvent(window, QEvent(QEvent.Type.ActivationChange))
    qtbot.waitUntil(lambda: window.document.drawing == shifted(first, 0.5))


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_links_are_followed(window, file, qtbot, tmp_path):
    first = window.document.drawing
    (tmp_path / "links").mkdir()
    link = tmp_path / "links" / "link.json"
    link.symlink_to(file)
    assert window.open_path(link)
    assert owner_of_file(file).is_this_process
    replace(file, shifted(first, 0.5))
    qtbot.waitUntil(lambda: window.document.drawing == shifted(first, 0.5))
    save(shifted(first, 1.0), tmp_path / "other.json")
    link.unlink()
    link.symlink_to(tmp_path / "other.json")
    qtbot.waitUntil(lambda: window.document.drawing == shifted(first, 1.0))


@pytest.mark.qt_log_ignore("This plugin does not support")  # windows are not raised offscreen
def test_two_windows_on_one_file_know_of_each_other(window, file, qtbot, hand):
    other = window.beside()
    qtbot.addWidget(other)
    assert other.open_path(file)
    assert "“mine.json” is open in another window, too" in other.messages.text
    assert window.messages.text == ""
    answer(other, "Go to that window")
    qtbot.waitUntil(window.isActiveWindow)

    hand.drag(P5, (1.4, 2.0))
    window.actions_by_name["save"].trigger()  # it had the file first, and is not asked
    assert not window.isWindowModified()
    qtbot.waitUntil(lambda: other.document.drawing == window.document.drawing)
    other.actions_by_name["add"].trigger()
    asked = reply("Cancel")
    other.actions_by_name["save"].trigger()
    assert "is open in another window, too" in asked[0]

    reply("Replace")
    other.actions_by_name["save"].trigger()
    assert load(file) == other.document.drawing
    qtbot.waitUntil(lambda: window.document.drawing == other.document.drawing)
    other.actions_by_name["reverse"].trigger()
    other.actions_by_name["save"].trigger()  # who said so once is not asked again
    assert load(file) == other.document.drawing

    window.close()
    other.actions_by_name["save"].trigger()
    assert owner_of_file(file) is not None


def test_work_goes_on_in_a_copy(window, file, qtbot):
    other = window.beside()
    qtbot.addWidget(other)
    other.open_path(file)
    answer(other, "Work on a copy")
    assert other.windowTitle() == "mine copy[*] — theditor"
    assert other.document.path is None
    assert other.document.drawing == window.document.drawing
    assert other.messages.text == ""


HOLDER = """
import sys
from pathlib import Path
from PySide6.QtCore import QCoreApplication
from theditor.model.claim import Claim
app = QCoreApplication([])
app.setOrganizationName("theditor-tests")
app.setApplicationName("theditor-tests")
claim = Claim()
print(claim.hold(Path(sys.argv[1])), flush=True)
sys.stdin.read()
"""


def test_another_process_that_has_the_file_is_named_and_its_death_frees_it(window, tmp_path):
    path = tmp_path / "theirs.json"
    save(window.document.drawing, path)
    command = [sys.executable, "-c", HOLDER, str(path)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as holder:
        assert holder.stdout.readline() == "None\n"
        assert window.open_path(path)
        assert f"open in another theditor (process {holder.pid}, since " in window.messages.text
        window.actions_by_name["add"].trigger()
        asked = reply("Cancel")
        window.actions_by_name["save"].trigger()
        assert f"process {holder.pid}" in asked[0]
        holder.kill()
    window.actions_by_name["save"].trigger()
    assert load(path) == window.document.drawing
    assert sorted(os.listdir(tmp_path)) == ["data", "theirs.json"]
