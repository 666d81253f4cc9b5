"""Unsaved work outlives whatever ends the program, and a change of mind."""

import json
import os
import re
import signal
import subprocess
import sys
from datetime import datetime, timedelta
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QItemSelectionModel
from PySide6.QtWidgets import QApplication, QMessageBox

from theditor.app.ending import prepare_end
from theditor.app.problems import catch_everything
from theditor.app.recover_dialog import RecoverDialog, offer_work
from theditor.app.windows import open_windows
from theditor.drawing import DrawingError, load, save
from theditor.model.kept_work import DAYS, kept_work

P5 = (1.0, 2.3130352854993315)


@pytest.fixture(autouse=True)
def data(monkeypatch, tmp_path):
    """The application's data, for this test alone."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return tmp_path / "data" / "theditor-tests" / "theditor-tests" / "recovery"


@pytest.fixture
def prompt(window):
    """The window keeps its work at once."""
    window.recovery._timer.setInterval(0)


def names(folder):
    """Endings of the files in the folder of kept work."""
    return sorted(path.suffix for path in folder.iterdir()) if folder.exists() else []


def shown_dialog():
    dialogs = [w for w in QApplication.topLevelWidgets() if isinstance(w, RecoverDialog) and w.isVisible()]
    assert len(dialogs) == 1
    return dialogs[0]


def abandon(window, drawing, path=None):
    """Leave work behind as a crash would."""
    window.document.undo_stack.setClean()
    window.document.recover(drawing, "Figure 10", path, None)
    window.recovery.leave()
    window.document.undo_stack.setClean()


def test_a_change_is_on_the_disk_soon_and_a_save_takes_it_away(window, prompt, hand, qtbot, data, tmp_path):
    assert names(data) == []
    with qtbot.waitSignal(window.recovery.kept):
        hand.drag(P5, (1.4, 2.0))
    assert names(data) == [".about", ".json", ".lock"]
    assert load(next(data.glob("*.json"))) == window.document.drawing
    assert kept_work() == []  # a window has it
    with qtbot.waitSignal(window.recovery.kept):
        window.actions_by_name["reverse"].trigger()
    assert load(next(data.glob("*.json"))) == window.document.drawing
    window.document.save(tmp_path / "saved.json")
    window.recovery.flush()
    assert names(data) == []


def test_undoing_everything_leaves_nothing(window, prompt, hand, qtbot, data):
    with qtbot.waitSignal(window.recovery.kept):
        hand.drag(P5, (1.4, 2.0))
    window.document.undo()
    window.recovery.flush()
    assert names(data) == []


def test_what_was_discarded_can_be_recovered_for_some_days(window, hand, answer, data, tmp_path):
    path = tmp_path / "mine.json"
    save(window.document.drawing, path)
    window.open_path(path)
    hand.drag(P5, (1.4, 2.0))
    mine = window.document.drawing
    answer(QMessageBox.StandardButton.Discard)
    window.actions_by_name["new"].trigger()
    window.recovery.flush()
    offer_work(window, discarded=False)  # nothing crashed
    assert not any(isinstance(w, RecoverDialog) for w in QApplication.topLevelWidgets())

    window.actions_by_name["recover"].trigger()
    dialog = shown_dialog()
    words = dialog.list.item(0).text()
    kept_until = datetime.now() + timedelta(days=DAYS)
    assert words.startswith(f"mine\nin {tmp_path}\n")
    assert f"discarded, kept until {kept_until.day} {kept_until:%B}" in words
    dialog.accept()
    assert window.document.drawing == mine
    assert window.document.path == path
    assert window.windowTitle() == "mine[*] — theditor"
    assert window.isWindowModified()
    window.actions_by_name["save"].trigger()  # the file is as it was then: nothing to ask
    assert load(path) == mine
    window.recovery.flush()
    assert names(data) == []


def test_discarded_work_goes_when_its_days_are_over(window, hand, answer, data, qtbot):
    hand.drag(P5, (1.4, 2.0))
    answer(QMessageBox.StandardButton.Discard)
    window.actions_by_name["new"].trigger()
    window.recovery.flush()
    about = next(data.glob("*.about"))
    told = json.loads(about.read_text())
    told["discarded"] = (datetime.now() - timedelta(days=DAYS, seconds=1)).isoformat()
    about.write_text(json.dumps(told))
    window.actions_by_name["recover"].trigger()
    assert "no unsaved work" in window.announced
    assert names(data) == []


def test_each_work_is_recovered_in_a_window_of_its_own(window, hand, qtbot, tmp_path, data):
    first = window.document.drawing
    hand.drag(P5, (1.4, 2.0))
    one = window.document.drawing
    hand.drag((1.4, 2.0), (1.6, 2.0))
    two = window.document.drawing
    abandon(window, one)
    abandon(window, two, tmp_path / "two.json")
    window.document.start(first)
    offer_work(window, discarded=False)
    dialog = shown_dialog()
    assert [dialog.list.item(row).text().partition("\n")[0] for row in (0, 1)] == ["two", "Figure 10"]
    assert len(dialog.list.selectedItems()) == 2
    assert kept_work() == []  # no other process offers it meanwhile
    dialog.accept()
    other = next(each for each in open_windows if each is not window)
    qtbot.addWidget(other, before_close_func=lambda w: w.document.undo_stack.setClean())
    assert (window.document.drawing, window.document.path) == (two, tmp_path / "two.json")
    assert (other.document.drawing, other.document.path) == (one, None)
    assert other.isWindowModified()
    assert "is recovered" in other.messages.text


def test_work_on_a_file_that_was_opened_anew_comes_into_its_window(window, hand, tmp_path):
    path = tmp_path / "mine.json"
    save(window.document.drawing, path)
    hand.drag(P5, (1.4, 2.0))
    mine = window.document.drawing
    abandon(window, mine, path)
    window.open_path(path)
    offer_work(window, discarded=False)
    shown_dialog().accept()
    assert (window.document.drawing, window.document.path) == (mine, path)
    assert window.isWindowModified()


def test_work_is_kept_for_later_or_discarded_or_deleted(window, hand, data):
    hand.drag(P5, (1.4, 2.0))
    mine = window.document.drawing
    for _ in range(2):
        abandon(window, mine)
    offer_work(window, discarded=False)
    shown_dialog().reject()
    offer_work(window, discarded=False)
    dialog = shown_dialog()
    dialog.list.setCurrentRow(0, QItemSelectionModel.SelectionFlag.ClearAndSelect)
    dialog.discard_button.click()
    assert dialog.list.count() == 1
    dialog.reject()
    assert sorted(json.loads(a.read_text())["discarded"] is None for a in data.glob("*.about")) == [
        False,
        True,
    ]

    window.actions_by_name["recover"].trigger()
    dialog = shown_dialog()
    dialog.list.selectAll()
    assert dialog.discard_button.text() == "Discard"
    row = next(r for r in (0, 1) if "discarded" in dialog.list.item(r).text())
    dialog.list.setCurrentRow(row, QItemSelectionModel.SelectionFlag.ClearAndSelect)
    assert dialog.discard_button.text() == "Delete for good"
    dialog.discard_button.click()
    dialog.list.selectAll()
    dialog.discard_button.click()
    assert "discarded, kept until" in dialog.list.item(0).text()
    dialog.discard_button.click()
    assert not dialog.isVisible()
    assert names(data) == []


@pytest.mark.parametrize("damage", [b"", b"{", b"\x00\xff"])
def test_damaged_work_is_told_and_passed_over(window, hand, data, damage):
    hand.drag(P5, (1.4, 2.0))
    mine = window.document.drawing
    for _ in range(2):
        abandon(window, mine)
    broken = sorted(data.glob("*.json"))[0]
    broken.write_bytes(damage)
    broken.with_suffix(".about").write_bytes(damage)
    offer_work(window, discarded=False)
    assert "“Untitled” is damaged and cannot be recovered" in window.messages.text
    dialog = shown_dialog()
    assert dialog.list.count() == 1
    dialog.accept()
    assert window.document.drawing == mine


def test_a_disk_without_room_is_told_once_and_editing_goes_on(window, prompt, hand, qtbot, monkeypatch, data):
    def full(*_, **__):
        raise DrawingError("the disk is full.")

    monkeypatch.setattr("theditor.model.kept_work.write_atomically", full)
    with qtbot.waitSignal(window.recovery.failed):
        hand.drag(P5, (1.4, 2.0))
    assert "cannot be kept" in window.announced
    assert "disk is full" in window.announced
    window.announce("")
    window.actions_by_name["reverse"].trigger()
    with qtbot.waitSignal(window.recovery._written):
        pass
    assert "cannot be kept" not in window.announced
    monkeypatch.undo()
    monkeypatch.setenv("XDG_DATA_HOME", str(data.parents[2]))
    with qtbot.waitSignal(window.recovery.kept):
        window.actions_by_name["reverse"].trigger()
    assert load(next(data.glob("*.json"))) == window.document.drawing


def test_a_data_folder_that_cannot_be_is_no_hindrance(window, prompt, hand, qtbot, monkeypatch, tmp_path):
    (tmp_path / "file").touch()
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "file"))
    with qtbot.waitSignal(window.recovery.failed):
        hand.drag(P5, (1.4, 2.0))
    window.document.save(tmp_path / "mine.json")
    assert window.open_path(tmp_path / "mine.json")
    window.actions_by_name["recover"].trigger()
    assert "no unsaved work" in window.announced


def test_an_error_inside_keeps_the_work_at_once(window, hand, monkeypatch, data):
    from theditor.app.main import _caught

    monkeypatch.setattr(sys, "excepthook", sys.excepthook)
    catch_everything(_caught)
    hand.drag(P5, (1.4, 2.0))
    try:
        raise RuntimeError("a bug")
    except RuntimeError as error:
        sys.excepthook(type(error), error, error.__traceback__)
    assert "a bug" in window.messages.text
    window.recovery.flush()
    assert load(next(data.glob("*.json"))) == window.document.drawing


def test_the_end_of_the_session_asks_nothing_and_loses_nothing(window, hand, answer, data):
    asked = answer(QMessageBox.StandardButton.Cancel)
    hand.drag(P5, (1.4, 2.0))
    hints = []
    prepare_end(SimpleNamespace(setRestartHint=hints.append))
    hand.drag((1.4, 2.0), (1.6, 2.0))  # the session went on after all
    window.close()
    assert (len(asked), window.isVisible()) == (1, True)

    hand.press((1.6, 2.0))
    hand.move((1.8, 2.0))  # even this is kept
    prepare_end(SimpleNamespace(setRestartHint=hints.append))
    mine = window.document.drawing
    assert window.close()
    assert len(asked) == 1
    left = kept_work()
    assert [work.read() for work in left] == [mine]
    assert left[0].about.discarded is None


def test_recovered_work_on_a_file_that_changed_since_is_asked_about(window, hand, qtbot, tmp_path):
    path = tmp_path / "mine.json"
    save(window.document.drawing, path)
    window.open_path(path)
    hand.drag(P5, (1.4, 2.0))
    mine = window.document.drawing
    window.recovery.leave()
    window.document.undo_stack.setClean()
    window.document.start(mine)
    save(mine.without(0), path)
    offer_work(window, discarded=False)
    shown_dialog().accept()
    qtbot.waitUntil(lambda: "Another program has changed “mine.json”" in window.messages.text)
    assert window.document.drawing == mine


# A process of its own, which the system ends

EDITS = """
import sys
from pathlib import Path
from PySide6.QtCore import QTimer
from theditor.app import main
from theditor.app.windows import open_windows

def edit():
    window = open_windows[0]
    window.recovery._timer.setInterval(0)
    window.recovery.kept.connect(lambda: print("kept", flush=True))
    window.actions_by_name["reverse"].trigger()

QTimer.singleShot(0, edit)
sys.exit(main.run([Path(sys.argv[1])]))
"""

RECOVERS = """
import sys
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
from theditor.app import main
from theditor.app.recover_dialog import RecoverDialog
from theditor.app.windows import open_windows

def recover():
    dialog = next(w for w in QApplication.topLevelWidgets() if isinstance(w, RecoverDialog))
    for row in range(dialog.list.count()):
        print(dialog.list.item(row).text().replace(chr(10), "|"))
    dialog.recover_button.click()
    for window in list(open_windows):
        print(window.document.path, window.isWindowModified())
        window.files.save()
        window.close()

QTimer.singleShot(0, recover)
sys.exit(main.run([]))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_after_the_end_of_a_process_the_next_start_offers_its_work(window, tmp_path):
    first = window.document.drawing
    paths = {end: tmp_path / f"{end.name}.json" for end in (signal.SIGKILL, signal.SIGTERM)}
    editors = {}
    for end, path in paths.items():
        save(first, path)
        command = [sys.executable, "-c", EDITS, str(path)]
        editors[end] = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    for end, editor in editors.items():
        with editor:
            assert editor.stdout.readline() == "kept\n"
            editor.send_signal(end)
        assert load(paths[end]) == first
    codes = {end: editor.returncode for end, editor in editors.items()}
    assert codes == {signal.SIGKILL: -signal.SIGKILL, signal.SIGTERM: 128 + signal.SIGTERM}

    again = subprocess.run([sys.executable, "-c", RECOVERS], capture_output=True, text=True)
    assert again.stderr == ""
    told = sorted(again.stdout.splitlines())
    for end, line in zip(paths, told[2:], strict=True):
        assert re.fullmatch(rf"{end.name}\|in {re.escape(str(tmp_path))}\|.*\d\d:\d\d", line)
    assert told[:2] == [f"{path} True" for path in paths.values()]
    for path in paths.values():
        assert np.array_equal(load(path)[0].curve.control_points, first[0].curve.control_points[::-1])
    left = [name for _, _, files in os.walk(tmp_path / "data") for name in files if "log" not in name]
    assert left == []
