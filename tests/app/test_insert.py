"""Known curves from the Insert menu: seen while they are typed, kept by OK, gone without trace by Cancel."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QApplication, QDialogButtonBox

from theditor.app.insert_dialog import InsertDialog
from theditor.spline import KNOWN, known, recognise

KEY = Qt.Key
OK, CANCEL = QDialogButtonBox.StandardButton.Ok, QDialogButtonBox.StandardButton.Cancel


@pytest.fixture
def insert(window):
    def opened(name):
        window.actions_by_name[f"insert_{name}"].trigger()
        dialogs = [d for d in window.findChildren(InsertDialog) if d.isVisible()]
        return dialogs[-1]

    return opened


def type_into(qtbot, dialog, keyword, *texts):
    for entry, text in zip(dialog.fields[keyword], texts, strict=True):
        entry.setFocus()
        entry.selectAll()
        qtbot.keyClicks(entry, text)


def press(qtbot, dialog, button):
    qtbot.mouseClick(dialog.buttons.button(button), Qt.MouseButton.LeftButton)


def test_an_ellipse_is_seen_while_it_is_typed_and_kept_in_one_step(window, insert, qtbot):
    before = window.document.drawing
    dialog = insert("ellipse")
    assert dialog.windowTitle() == "Insert ellipse"
    assert len(window.document.drawing) == 2
    assert window.selection.curve == 1
    type_into(qtbot, dialog, "centre", "1", "2")
    type_into(qtbot, dialog, "semi_axes", "3", "1,5")
    type_into(qtbot, dialog, "rotation", "30")
    type_into(qtbot, dialog, "start", "-90")
    type_into(qtbot, dialog, "quarters", "2")
    expected = known.ellipse((1, 2), (3, 1.5), np.radians(30), -np.pi / 2, 2)
    assert window.document.drawing[1].curve == expected
    dialog.degree.setCurrentIndex(0)
    assert window.document.drawing[1].curve.degree == 2
    assert window.document.undo_stack.count() == 0
    qtbot.keyClick(dialog.fields["quarters"][0], KEY.Key_Return)
    assert not dialog.isVisible()
    kept = window.document.drawing
    assert kept[1].curve == known.ellipse((1, 2), (3, 1.5), np.radians(30), -np.pi / 2, 2, degree=2)
    assert kept[1].name == "Ellipse"
    assert window.selection.curve == 1
    assert window.document.undo_stack.undoText() == "Insert ellipse"
    window.actions_by_name["undo"].trigger()
    assert window.document.drawing == before
    window.actions_by_name["redo"].trigger()
    assert window.document.drawing == kept


def test_cancel_leaves_no_trace(window, insert, qtbot):
    window.selection.select(points={3, 5}, segments={2})
    before = window.document.drawing
    dialog = insert("catenary")
    type_into(qtbot, dialog, "units", "7")
    assert window.document.drawing[1].curve.segment_count == 7
    press(qtbot, dialog, CANCEL)
    assert window.document.drawing is before
    assert (window.selection.curve, window.selection.points, window.selection.segments) == (0, {3, 5}, {2})
    assert window.document.undo_stack.count() == 0
    qtbot.keyClick(insert("cycloid"), KEY.Key_Escape)
    assert window.document.drawing is before
    assert not window.isWindowModified()


@pytest.mark.parametrize(
    ("name", "keyword", "text", "sentence"),
    [
        (
            "trochoid",
            "radius",
            "wide",
            "Rolling radius: “wide” is no number up to 1e12 in size; type one such as",
        ),
        (
            "trochoid",
            "radius",
            "inf",
            "Rolling radius: “inf” is no number up to 1e12 in size",
        ),
        (
            "trochoid",
            "origin",
            "1e13",
            "Origin x: “1e13” is no number up to 1e12 in size",
        ),
        ("trochoid", "arm", "-1", "Arm: type a positive number, at least 1e−12."),
        ("trochoid", "arm", "1e-320", "Arm: type a positive number, at least 1e−12."),
        ("cycloid", "radius", "1e12", "The curve would reach beyond 1e+12: make it shorter, smaller"),
        ("trochoid", "quarters", "2.5", "Quarter turns: type a whole number from 1 to 10000."),
        ("trochoid", "quarters", "0", "Quarter turns: type a whole number from 1 to 10000."),
        ("hyperbola", "start", "40", "The curve would reach beyond 1e+12"),
        ("catenary", "parameter", "0", "Parameter a: type a number other than 0, at least 1e−12 in size."),
        ("exponential_curve", "length", "-1e-320", "Length L of growth by e: type a number other than 0"),
    ],
)
def test_bad_values_say_why_and_bar_ok(window, insert, qtbot, name, keyword, text, sentence):
    dialog = insert(name)
    good = window.document.drawing
    old = dialog.fields[keyword][0].text()
    others = [field.text() for field in dialog.fields[keyword][1:]]
    type_into(qtbot, dialog, keyword, text, *others)
    assert dialog.sentence.text().startswith(sentence)
    assert not dialog.buttons.button(OK).isEnabled()
    qtbot.keyClick(dialog.fields[keyword][0], KEY.Key_Return)
    assert dialog.isVisible()
    type_into(qtbot, dialog, keyword, old, *others)
    assert dialog.sentence.text() == ""
    assert window.document.drawing == good
    press(qtbot, dialog, OK)
    assert window.document.undo_stack.count() == 1


def test_arrow_keys_step_numbers(window, insert, qtbot):
    dialog = insert("ellipse")
    qtbot.keyClick(dialog.fields["quarters"][0], KEY.Key_Up)
    qtbot.keyClick(dialog.fields["rotation"][0], KEY.Key_Down)
    assert dialog.fields["quarters"][0].text() == "5"
    assert window.document.drawing[1].curve.segment_count == 5
    assert dialog.fields["rotation"][0].text() == "-15"
    dialog.fields["rotation"][0].selectAll()
    QApplication.clipboard().setText("−30")  # a pasted number may have a true minus sign
    qtbot.keySequence(dialog.fields["rotation"][0], QKeySequence.StandardKey.Paste)
    assert recognise(window.document.drawing[1].curve, 0).parameters["rotation"] == pytest.approx(-np.pi / 6)
    press(qtbot, dialog, CANCEL)


def test_numbers_may_be_worked_out(window, insert, qtbot):
    dialog = insert("ellipse")
    type_into(qtbot, dialog, "semi_axes", "1/2", "(1+2)/4")
    expected = known.ellipse(tuple(field.value() for field in dialog.fields["centre"]), (0.5, 0.75))
    assert window.document.drawing[1].curve == expected
    press(qtbot, dialog, OK)
    assert window.document.drawing[1].curve == expected


@pytest.mark.parametrize("each", KNOWN, ids=lambda each: each.name)
@pytest.mark.parametrize("view", [(0.0, 0.0, 90.0), (-3.7e5, 42.0, 1e-3), (0.001, -0.02, 1e5)])
def test_every_known_curve_fits_the_view_under_its_own_name(window, insert, qtbot, each, view):
    window.canvas.show_view(*view)
    plane = window.canvas.plane
    dialog = insert(each.name.lower().replace(" ", "_"))
    item = window.document.drawing[1]
    press(qtbot, dialog, OK)
    assert item.name == each.name
    names = {recognise(item.curve, s).name for s in range(item.curve.segment_count)}
    assert len(names) == 1
    pixels = plane.to_pixels(item.curve.sample(16)[:, :2])
    low, high = pixels.min(axis=0), pixels.max(axis=0)
    assert (low > 0).all()
    assert (high < (plane.width, plane.height)).all()
    assert 0.15 < ((high - low) / (plane.width, plane.height)).max() < 0.75
    assert np.abs((low + high) / 2 - (plane.width / 2, plane.height / 2)).max() < 0.05 * plane.width


def test_names_are_told_apart(window, insert, qtbot):
    for _ in range(3):
        press(qtbot, insert("sine_wave"), OK)
    names = [item.name for item in window.document.drawing]
    assert names == ["Figure 10", "Sine wave", "Sine wave 2", "Sine wave 3"]
