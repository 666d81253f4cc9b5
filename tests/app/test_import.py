"""Curves from the files of other programs: by the menu, dropped, opened; and what cannot be read."""

import pytest
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent, QKeySequence
from PySide6.QtWidgets import QApplication, QFileDialog, QLabel, QMessageBox

from theditor.app.import_dialog import ImportDialog
from theditor.app.windows import open_windows
from theditor.drawing import Drawing, DrawingError, Item, encode
from theditor.exchange import Imported, write
from theditor.spline import Curve

FAR = Curve([(900, 0), (1000, 50), (1100, 0), (1200, 50)])


@pytest.fixture
def reader(monkeypatch):
    """Reads files as if other programs had written them; the list fills with the options it was given."""
    given = []

    def read(data, suffix, options, progress):
        progress(0.5)
        given.append(options)
        if data == b"bad":
            raise DrawingError("line 1 is no picture.")
        if data == b"empty":
            return Imported(Drawing())
        return Imported(Drawing([Item(FAR, data.decode()[:9])]), 0.25, ("A text was left out.",))

    monkeypatch.setattr("theditor.app.importing.read", read)
    return given


@pytest.fixture
def files(tmp_path):
    """Makes files by their names and what they hold."""

    def make(**contents):
        paths = [tmp_path / name.replace("_", ".") for name in contents]
        for path, data in zip(paths, contents.values(), strict=True):
            path.write_bytes(data if isinstance(data, bytes) else data.encode())
        return paths

    return make


@pytest.fixture
def chosen(monkeypatch):
    def prepare(paths):
        names = [str(path) for path in paths]
        monkeypatch.setattr(QFileDialog, "getOpenFileNames", lambda *_: (names, ""))
        monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (names[0], ""))

    return prepare


def idle(window, qtbot):
    qtbot.waitUntil(lambda: not window.work.jobs)


def dialog_of(window, qtbot):
    dialog = window.findChildren(ImportDialog)[-1]
    qtbot.waitUntil(dialog.isActiveWindow)
    return dialog


def test_curves_are_imported_by_keys_in_one_step_and_shown(window, qtbot, reader, files, chosen):
    before = window.document.drawing
    window.resize(1024, 700)
    chosen(files(house_svg="House", path_csv="Path"))
    qtbot.keySequence(window.canvas, QKeySequence("Ctrl+I"))
    dialog_of(window, qtbot)

    def press(key, keys=Qt.KeyboardModifier.NoModifier):
        qtbot.keyClick(QApplication.focusWidget(), key, keys)

    press(Qt.Key.Key_R, Qt.KeyboardModifier.AltModifier)
    press(Qt.Key.Key_Down)
    press(Qt.Key.Key_D, Qt.KeyboardModifier.AltModifier)
    press(Qt.Key.Key_Down)
    press(Qt.Key.Key_T, Qt.KeyboardModifier.AltModifier)
    qtbot.keyClicks(QApplication.focusWidget(), "0.01")
    press(Qt.Key.Key_Return)
    idle(window, qtbot)
    assert {(o.degree, o.tolerance, o.control_points) for o in reader} == {(2, 0.01, True)}
    assert window.document.drawing == Drawing([*before, Item(FAR, "House"), Item(FAR, "Path")])
    assert window.announced == (
        "Imported 2 curves from 2 files. The largest deviation is 0.25 units. A text was left out."
    )
    said = next(
        label for label in window.statusBar().findChildren(QLabel) if label.text() == window.announced
    )
    qtbot.waitUntil(lambda: said.width() >= said.sizeHint().width())  # the whole of it can be read
    assert (window.selection.curve, list(window.selection.chosen)) == (1, [1, 2])
    pixels = window.canvas.plane.to_pixels(FAR.control_points)
    assert (pixels >= 0).all()
    assert (pixels <= (window.canvas.width(), window.canvas.height())).all()
    assert window.document.undo_stack.undoText() == "Import 2 curves"
    window.document.undo()
    assert window.document.drawing == before

    window.actions_by_name["import"].trigger()
    again = dialog_of(window, qtbot)
    assert (again.options().degree, again.options().tolerance) == (2, 0.01)
    assert not again.findChildren(QMessageBox)
    again.tolerance.selectAll()
    qtbot.keyClicks(again.tolerance, "9")
    assert "“9” is no number" in again.sentence.text()
    assert not again.button.isEnabled()
    again.reject()
    assert window.document.drawing == before


def test_a_picture_exported_here_comes_back_without_loss_or_question(window, qtbot, files, chosen):
    (item,) = window.document.drawing
    chosen(files(house_svg=write(window.document.drawing, ".svg").data))
    window.actions_by_name["import"].trigger()
    assert window.findChildren(ImportDialog) == []
    idle(window, qtbot)
    assert window.document.drawing == Drawing([item, item])
    assert "Exact." in window.announced


def test_one_bad_file_does_not_keep_the_others_back(window, qtbot, reader, files, chosen):
    before = window.document.drawing
    drop(window, files(good_svg="House", bad_svg="bad"))
    qtbot.waitUntil(lambda: "bad.svg: line 1 is no picture." in window.messages.text)
    assert len(window.document.drawing) == 2
    assert window.announced.startswith("Imported 1 curve from “good.svg”. ")
    window.actions_by_name["undo"].trigger()
    assert "Imported" not in window.announced
    drop(window, files(bad_svg="bad", empty_csv="empty"))
    qtbot.waitUntil(lambda: "empty.csv: it holds no curves." in window.messages.text)
    assert len(window.messages.text.split("\n")) == 2
    assert window.document.drawing == before


def event(kind, window, paths):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    place = window.canvas.mapTo(window, window.canvas.rect().center())
    if kind is QDropEvent:
        place = QPointF(place)
    arguments = (place, Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton)
    made = kind(*arguments, Qt.KeyboardModifier.NoModifier)
    made.data = data  # which the event does not keep
    return made


def drag(window, paths):
    """Drag files into the window's middle; returns whether they may be dropped there."""
    made = event(QDragEnterEvent, window, paths)
    QApplication.sendEvent(window.windowHandle(), made)
    return made.isAccepted()


def drop(window, paths):
    assert drag(window, paths)
    QApplication.sendEvent(window.windowHandle(), event(QDropEvent, window, paths))


def test_a_dropped_picture_is_imported(window, qtbot, reader, files):
    before = window.document.drawing
    drop(window, files(House_SVG="House"))
    qtbot.waitUntil(lambda: window.announced.startswith("Imported 1 curve from “House.SVG”. "))
    assert window.document.drawing == Drawing([*before, Item(FAR, "House")])


@pytest.mark.qt_log_ignore("This plugin does not support")  # windows are not raised offscreen
def test_dropped_drawings_are_opened_each_in_a_window(window, qtbot, files, answer):
    one, two = (Drawing([Item(FAR, name)]) for name in ("One", "Two"))
    paths = files(one_json=encode(one), two_json=encode(two), bad_json="{")
    window.actions_by_name["add"].trigger()
    asked = answer(QMessageBox.StandardButton.Cancel)
    drop(window, paths)
    qtbot.waitUntil(lambda: len(asked) == 1)
    assert window.document.path is None
    answer(QMessageBox.StandardButton.Discard)
    drop(window, paths)
    qtbot.waitUntil(lambda: "bad.json" in window.messages.text)
    other = next(each for each in open_windows if each is not window)
    assert (window.document.drawing, other.document.drawing) == (one, two)
    other.close()


def test_only_what_can_be_read_is_taken(window, qtbot, reader, files):
    before = window.document.drawing
    good, bad = files(a_svg="House", b_txt="text")
    assert not drag(window, [bad])
    assert not drag(window, [])
    drop(window, [good, bad])
    qtbot.waitUntil(lambda: len(window.document.drawing) > len(before))
    assert window.messages.text == (
        "“b.txt” cannot be opened here: drop files that end in .json, .svg and .csv."
    )


def test_a_picture_is_opened_as_a_new_drawing(window, qtbot, reader, files, chosen, answer):
    chosen(files(house_svg="House"))
    window.actions_by_name["open"].trigger()
    qtbot.waitUntil(lambda: window.document.title == "house")
    assert window.document.drawing == Drawing([Item(FAR, "House")])
    assert (window.document.path, window.isWindowModified()) == (None, False)
    assert "saving makes a drawing of it" in window.announced

    # What was done while the file was being read is not lost unasked.
    asked = answer(QMessageBox.StandardButton.Cancel)
    window.files.open_path(files(shed_svg="Shed")[0])
    window.actions_by_name["add"].trigger()
    qtbot.waitUntil(lambda: len(asked) == 1)
    idle(window, qtbot)
    assert window.document.title == "house"
    assert len(window.document.drawing) == 2


def test_a_file_that_is_gone_is_told_and_the_drawing_stays(window, qtbot, tmp_path):
    before = window.document.drawing
    assert window.open_path(tmp_path / "gone.svg")
    qtbot.waitUntil(lambda: "gone.svg cannot be read: there is no such file" in window.messages.text)
    assert window.document.drawing is before
