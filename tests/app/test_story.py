"""The user's story on the real window: open, drag, slide λ, toggle a segment, undo, redo, save, reopen."""

import json
import sys

import numpy as np
import pytest
from hand import SHIFT
from PySide6.QtCore import QPoint, QSettings, Qt, QTimer
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QApplication, QLineEdit, QMenu, QMessageBox

from theditor.app.ask import where_to_save
from theditor.app.problems import catch_everything
from theditor.drawing import load
from theditor.model import DARK
from theditor.resources import gallery
from theditor.spline import INTERPOLATING, Mode

P5 = (1.0, 2.3130352854993315)


def curve(window):
    return window.document.drawing[0].curve


def trigger(window, name):
    window.actions_by_name[name].trigger()


def save_to(monkeypatch, path):
    monkeypatch.setattr("theditor.app.ask.where_to_save", lambda *_: path)


def test_the_whole_story(window, hand, qtbot, monkeypatch, tmp_path):
    values = [window.document.drawing]
    assert window.windowTitle() == "Figure 10[*] — theditor"
    assert not window.isWindowModified()

    hand.drag(P5, (1.4, 2.0))
    assert curve(window).control_points[5] == pytest.approx([1.4, 2.0])
    values.append(window.document.drawing)
    assert window.isWindowModified()

    hand.click(curve(window).control_points[9])
    slider = window.shape.slider
    middle = slider.height() // 3
    qtbot.mousePress(slider, Qt.MouseButton.LeftButton, pos=QPoint(slider.width() // 2, middle))
    for share in (0.6, 0.7, 0.8):
        qtbot.mouseMove(slider, QPoint(int(slider.width() * share), middle))
    qtbot.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=QPoint(int(slider.width() * 0.8), middle))
    assert curve(window).lambdas[9] > 0.5
    assert window.document.undo_stack.count() == 2
    values.append(window.document.drawing)

    hand.click(curve(window)(4.5))
    assert window.selection.segments == {4}
    window.canvas.setFocus()
    qtbot.keyClick(window.canvas, Qt.Key.Key_T)
    assert curve(window).modes[4] is Mode.TRIGONOMETRIC
    assert curve(window).modes[5] is Mode.BLEND
    assert "blend" in window.announced
    values.append(window.document.drawing)

    for value in reversed(values[:-1]):
        qtbot.keyClick(window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
        assert window.document.drawing == value
    assert not window.isWindowModified()
    for value in values[1:]:
        qtbot.keyClick(window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier | SHIFT)
        assert window.document.drawing == value

    save_to(monkeypatch, tmp_path / "mine.json")
    qtbot.keyClick(window, Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    assert window.windowTitle() == "mine[*] — theditor"
    assert not window.isWindowModified()
    assert load(tmp_path / "mine.json") == values[-1]

    trigger(window, "new")
    assert len(window.document.drawing) == 0
    monkeypatch.setattr("theditor.app.ask.which_to_open", lambda *_: tmp_path / "mine.json")
    trigger(window, "open")
    assert window.document.drawing == values[-1]


def test_interpolating_points_lie_on_the_curve(window, hand, qtbot):
    window.selection.select(segments={7})
    qtbot.keyClick(window.canvas, Qt.Key.Key_I)
    assert curve(window).lambdas[8:10].tolist() == [INTERPOLATING[3]] * 2
    assert np.allclose(curve(window).joints[7:9], curve(window).control_points[8:10], atol=1e-14)


def test_unsaved_changes_are_asked_about(window, hand, answer, monkeypatch, tmp_path):
    hand.drag(P5, (1.4, 2.0))
    drawing = window.document.drawing
    asked = answer(QMessageBox.StandardButton.Cancel)
    for name in ("new", "open", "gallery"):
        trigger(window, name)
    window.close()
    assert len(asked) == 4
    assert "“Figure 10” has changes that are not saved" in asked[0]
    assert window.isVisible()
    assert window.document.drawing is drawing

    save_to(monkeypatch, None)
    answer(QMessageBox.StandardButton.Save)
    trigger(window, "new")
    assert window.document.drawing is drawing

    save_to(monkeypatch, tmp_path / "kept.json")
    trigger(window, "new")
    assert load(tmp_path / "kept.json") == drawing

    trigger(window, "add")
    answer(QMessageBox.StandardButton.Discard)
    assert window.close()
    assert not window.isVisible()


def test_a_faulty_file_is_told_and_nothing_is_lost(window, tmp_path):
    drawing = window.document.drawing
    bad = tmp_path / "bad.json"
    bad.write_text('{"format": "theditor", "version": 99, "curves": []}')
    assert not window.open_path(bad)
    assert "bad.json" in window.messages.text
    assert "99" in window.messages.text
    assert window.document.drawing is drawing
    assert window.open_path(gallery()[0].path)
    assert window.messages.text == ""


def test_a_save_that_fails_is_told_and_the_drawing_stays_unsaved(window, hand, monkeypatch, tmp_path):
    hand.drag(P5, (1.4, 2.0))
    save_to(monkeypatch, tmp_path / "no folder" / "a.json")
    trigger(window, "save")
    assert "a.json" in window.messages.text
    assert window.isWindowModified()


def test_an_error_in_a_slot_is_told_and_the_window_lives_on(window, hand, monkeypatch):
    monkeypatch.setattr(sys, "excepthook", sys.excepthook)
    catch_everything(window.messages.tell)
    try:
        raise RuntimeError("a bug")
    except RuntimeError as error:
        sys.excepthook(type(error), error, error.__traceback__)
    assert "RuntimeError: a bug" in window.messages.text
    hand.drag(P5, (1.4, 2.0))
    assert curve(window).control_points[5] == pytest.approx([1.4, 2.0])


def test_what_is_being_typed_is_saved_and_asked_about(window, qtbot, monkeypatch, tmp_path, answer):
    save_to(monkeypatch, tmp_path / "a.json")
    window.curve.name.setFocus()
    window.curve.name.selectAll()
    qtbot.keyClicks(window.curve.name, "Typed")
    qtbot.keyClick(window, Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    assert load(tmp_path / "a.json")[0].name == "Typed"
    qtbot.keyClicks(window.curve.name, " on")
    asked = answer(QMessageBox.StandardButton.Cancel)
    window.close()
    assert len(asked) == 1
    assert window.document.drawing[0].name == "Typed on"


@pytest.mark.parametrize("typed", ["b", "b.json"])
def test_the_save_dialog_completes_the_name_and_asks_before_replacing(window, tmp_path, typed):
    (tmp_path / "b.json").write_text("{}")
    asked = []

    def refuse():
        box = QApplication.activeModalWidget()
        asked.append(box.text())
        box.button(QMessageBox.StandardButton.No).click()

    def name_it():
        dialog = QApplication.activeModalWidget()
        dialog.findChild(QLineEdit).setText(typed)
        QTimer.singleShot(0, refuse)
        dialog.accept()
        dialog.reject()

    QTimer.singleShot(0, name_it)
    assert where_to_save(window, tmp_path / "suggested.json") is None
    assert len(asked) == 1
    assert "b.json" in asked[0]


def test_a_drawing_is_not_saved_by_the_name_of_another_kind_of_file(window, tmp_path):
    def name_it():
        dialog = QApplication.activeModalWidget()
        dialog.findChild(QLineEdit).setText("b.svg")
        dialog.accept()

    QTimer.singleShot(0, name_it)
    assert where_to_save(window, tmp_path / "suggested.json") == tmp_path / "b.svg.json"


def test_saving_over_something_else_than_a_drawing_asks_once_more(window, monkeypatch, tmp_path):
    notes = tmp_path / "notes.json"
    notes.write_text("[1, 2]")
    save_to(monkeypatch, notes)
    asked = []
    monkeypatch.setattr(QMessageBox, "warning", lambda *about: asked.append(about[2]) or about[-1])
    trigger(window, "save_as")
    assert notes.read_text() == "[1, 2]"
    assert window.document.path is None
    monkeypatch.setattr(QMessageBox, "warning", lambda *_: QMessageBox.StandardButton.Yes)
    trigger(window, "save_as")
    assert load(notes) == window.document.drawing
    assert len(asked) == 1
    assert f"{notes} holds something other than a drawing" in asked[0]
    assert "The file must be an object with format" in asked[0]


def test_letters_act_on_points_when_points_are_selected(window, qtbot):
    window.selection.select(points={5})
    qtbot.keyClick(window.canvas, Qt.Key.Key_I)
    assert np.flatnonzero(curve(window).lambdas == INTERPOLATING[3]).tolist() == [3, 4, 5]


def test_recent_files_are_offered(window, tmp_path, monkeypatch):
    QSettings().remove("recent")
    for name in ("a.json", "b.json", "a.json"):
        save_to(monkeypatch, tmp_path / name)
        trigger(window, "save_as")
    recent = window.findChild(QMenu, "recent")
    recent.aboutToShow.emit()
    assert [a.text() for a in recent.actions()] == [str(tmp_path / n) for n in ("a.json", "b.json")]
    (tmp_path / "b.json").unlink()
    recent.aboutToShow.emit()
    assert len(recent.actions()) == 1
    recent.actions()[0].trigger()
    assert window.document.path == tmp_path / "a.json"


def test_every_gallery_picture_opens_and_saves_unchanged(window, monkeypatch, tmp_path):
    for picture in gallery():
        window.open_picture(picture.name)
        window.grab()
        assert not window.isWindowModified()
        assert picture.title.startswith(window.document.title)
        assert window.document.path is None
        window.document.save(tmp_path / "copy.json")
        assert (tmp_path / "copy.json").read_bytes() == picture.path.read_bytes()


def test_curves_are_added_duplicated_and_deleted_by_undoable_commands(window):
    first = window.document.drawing
    trigger(window, "add")
    assert window.selection.curve == 1
    assert window.document.drawing[1].name == "Curve 1"
    trigger(window, "duplicate")
    assert len(window.document.drawing) == 3
    trigger(window, "delete")
    trigger(window, "delete")
    assert window.document.drawing == first
    trigger(window, "reverse")
    assert np.array_equal(curve(window).control_points, first[0].curve.control_points[::-1])
    window.document.undo_stack.setIndex(0)
    assert window.document.drawing == first


def test_the_gallery_shows_a_picture_of_each_file(window, qtbot, monkeypatch):
    from theditor.app.gallery_dialog import GalleryDialog

    dialog = GalleryDialog(window)
    qtbot.addWidget(dialog)
    pictures = dialog._list
    assert pictures.count() == len(gallery())
    pictures.setCurrentRow(3)
    dialog.accept()
    assert dialog.chosen == gallery()[3]
    assert dialog._about.text() == gallery()[3].about


def test_the_theme_reaches_the_canvas(window, qtbot):
    trigger_theme = window.findChild(type(window.actions_by_name["new"]), "theme_dark")
    trigger_theme.trigger()
    assert window.palette().color(QPalette.ColorRole.Window).name().upper() == DARK.window
    image = window.canvas.grab().toImage()
    corner = image.pixelColor(1, 1).name().upper()
    assert corner in (DARK.canvas, DARK.grid_minor, DARK.grid_major)
    QSettings().remove("theme")


def test_what_is_shown_is_toggled(window):
    before = window.canvas.grab().toImage()
    for name in ("polygon", "labels", "joints", "modes", "grid"):
        trigger(window, f"show_{name}")
        after = window.canvas.grab().toImage()
        assert after != before, name
        before = after


def test_the_saved_file_is_readable_and_in_order(window, tmp_path):
    window.document.save(tmp_path / "a.json")
    data = json.loads((tmp_path / "a.json").read_text())
    assert list(data) == ["format", "version", "curves"]
    assert list(data["curves"][0])[:6] == ["name", "degree", "closed", "ends", "points", "lambda"]


def test_nothing_is_clipped_in_a_small_window(window, qtbot):
    window.resize(1024, 700)
    assert window.width() == 1024
    for widget in (window.canvas, window.lambda_strip, window.shape, window.curve):
        assert widget.width() >= widget.minimumSizeHint().width()


def test_an_error_while_painting_or_resizing_is_told_and_the_window_lives_on(
    window, hand, monkeypatch, qtbot
):
    told = []
    monkeypatch.setattr(sys, "excepthook", lambda kind, error, trace: told.append(kind))
    with monkeypatch.context() as broken:
        broken.setattr("theditor.canvas.picture.paint_grid", lambda *_: ()[0])  # an error raised in C
        broken.setattr("theditor.canvas.canvas.fitted", lambda *_: int("no number"))
        window.canvas.grab()
        window.resize(window.width() + 10, window.height())
        window.canvas.grab()
    assert set(told) == {IndexError, ValueError}
    hand.drag(P5, (1.4, 2.0))
    assert curve(window).control_points[5] == pytest.approx([1.4, 2.0])
