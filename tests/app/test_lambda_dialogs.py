"""Many λ at once, by the commands of the Curve menu: seen while the dialog is open, kept by OK, gone by Cancel."""

import math

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QDialogButtonBox, QLabel, QLineEdit, QMessageBox

from theditor.app.preview_dialog import PreviewDialog
from theditor.panels.live_inputs import LambdaInput, StrengthInput
from theditor.spline import gradient, smoothed

KEY = Qt.Key
LEFT = Qt.MouseButton.LeftButton
CTRL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def ask(window, qtbot, answer):
    """Choose a command of the menu, and return the dialog that opens."""
    answer(QMessageBox.StandardButton.Discard)  # a failing test leaves changes, and must not wait for a hand

    def chosen(name):
        window.actions_by_name[name].trigger()
        (dialog,) = open_dialogs(window)
        with qtbot.waitExposed(dialog):
            dialog.activateWindow()
        qtbot.waitUntil(dialog.isActiveWindow)
        return dialog

    return chosen


def open_dialogs(window):
    return [dialog for dialog in window.findChildren(PreviewDialog) if dialog.isVisible()]


def lambdas(window):
    return window.document.drawing[0].curve.lambdas


def type_into(qtbot, field, text):
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, text)


def ok(dialog):
    return dialog.buttons.button(QDialogButtonBox.StandardButton.Ok)


def heading(dialog):
    return dialog.findChild(QLabel).text()


def test_a_gradient_is_seen_while_it_is_typed_and_slid_and_is_one_step(window, ask, qtbot):
    before = window.document.drawing
    window.selection.select(points=range(3, 10))
    dialog = ask("gradient")
    assert heading(dialog) == "λ₃ … λ₉, 7 points"
    start, end = dialog.findChildren(LambdaInput)
    assert (start.value(), end.value()) == (lambdas(window)[3], 0.5)
    type_into(qtbot, start.field, "-1")
    assert lambdas(window)[[3, 6, 9]].tolist() == [-1, -0.25, 0.5]

    slider = end.slider
    at = QPoint(slider.width() // 2, 12)
    qtbot.mousePress(slider, LEFT, pos=at)
    for _ in range(3):
        at += QPoint(9, 0)
        qtbot.mouseMove(slider, at)
        assert end.field.value() == end.value() == lambdas(window)[9]
        expected = gradient(before[0].curve, range(3, 10), -1, end.value())
        assert lambdas(window).tolist() == expected.lambdas.tolist()
    qtbot.keyClick(slider, KEY.Key_Escape)
    assert dialog.isVisible()
    assert end.value() == lambdas(window)[9] == 0.5
    qtbot.mouseRelease(slider, LEFT, pos=at)
    qtbot.keyClick(slider, KEY.Key_PageUp)
    assert window.document.undo_stack.count() == 0
    qtbot.mouseClick(ok(dialog), LEFT)
    assert not dialog.isVisible()
    assert window.document.undo_stack.count() == 1
    assert window.document.undo_stack.undoText() == "Gradient of λ"
    assert lambdas(window)[[3, 6, 9]].tolist() == [-1, 0, 1]
    window.document.undo()
    assert window.document.drawing == before


@pytest.mark.parametrize("leave", ["escape", "cancel", "close"])
def test_a_dialog_given_up_leaves_no_trace(window, ask, qtbot, leave):
    qtbot.keyClick(window.canvas, KEY.Key_H)
    window.document.undo()
    before = window.document.drawing
    dialog = ask("formula")
    type_into(qtbot, dialog.findChild(QLineEdit), "i/n")
    assert window.document.drawing != before
    if leave == "escape":
        qtbot.keyClick(dialog, KEY.Key_Escape)
    elif leave == "cancel":
        qtbot.mouseClick(dialog.buttons.button(QDialogButtonBox.StandardButton.Cancel), LEFT)
    else:
        dialog.close()
    assert window.document.drawing == before
    assert not window.document.undo_stack.canUndo()
    assert window.document.undo_stack.canRedo()


def test_smoothing_follows_its_strength_and_says_when_there_is_nothing_to_do(window, ask, qtbot):
    curve = window.document.drawing[0].curve
    dialog = ask("smooth")
    strength = dialog.findChild(StrengthInput)
    qtbot.keyClick(strength.slider, KEY.Key_End)
    assert strength.value() == 1
    assert lambdas(window).tolist() == smoothed(curve, range(13), 1).lambdas.tolist()
    type_into(qtbot, strength.field, "0,25")
    assert lambdas(window).tolist() == smoothed(curve, range(13), 0.25).lambdas.tolist()
    assert strength.slider.value() == 25
    qtbot.keyClick(strength.field, KEY.Key_Down)
    assert strength.value() == 0.2
    type_into(qtbot, strength.field, "1.01")
    assert "from 0 to 1" in dialog.sentence.text()
    type_into(qtbot, strength.field, "0")
    assert window.document.drawing[0].curve == curve
    qtbot.keyClick(strength.field, KEY.Key_Return)
    assert window.document.undo_stack.count() == 0

    window.selection.select(points=[6, 7])
    dialog = ask("smooth")
    assert dialog.sentence.text().startswith("There is nothing to smooth")
    assert not ok(dialog).isEnabled()


def test_a_formula_gives_the_active_parameters_and_its_faults_bar_ok(window, ask, qtbot):
    before = lambdas(window)
    dialog = ask("formula")
    text = dialog.findChild(QLineEdit)
    qtbot.keyClicks(text, "l + sin(i/3)")
    expected = [old + math.sin(i / 3) for i, old in enumerate(before)]
    assert lambdas(window)[1:-1] == pytest.approx(expected[1:-1])
    assert lambdas(window)[[0, -1]].tolist() == before[[0, -1]].tolist()

    shown = lambdas(window)
    qtbot.keyClicks(text, " + sun(i)")
    assert dialog.sentence.text().startswith("“sun(i)” at character 16 is not understood: use numbers")
    assert np.array_equal(lambdas(window), shown)
    qtbot.keyClick(text, KEY.Key_Return)
    assert dialog.isVisible()
    for _ in " + sun(i)":
        qtbot.keyClick(text, KEY.Key_Backspace)
    assert dialog.sentence.text() == ""
    qtbot.keyClick(text, KEY.Key_Return)
    assert not dialog.isVisible()
    assert window.document.undo_stack.undoText() == "λ by formula"
    assert np.array_equal(lambdas(window), shown)


def test_a_formula_need_not_hold_where_no_parameter_is_asked_for(window, ask, qtbot):
    dialog = ask("formula")
    text = dialog.findChild(QLineEdit)
    type_into(qtbot, text, "1/i")  # λ₀ shapes nothing
    assert dialog.sentence.text() == ""
    assert lambdas(window)[1:4] == pytest.approx([1, 1 / 2, 1 / 3])
    type_into(qtbot, text, "1/(i-1)")
    assert dialog.sentence.text().startswith("At i = 1 the formula gives no finite λ")


def test_a_bad_number_an_escape_and_an_undo_stay_within_the_field(window, ask, qtbot):
    window.actions_by_name["reverse"].trigger()
    dialog = ask("gradient")
    start, _ = dialog.findChildren(LambdaInput)
    type_into(qtbot, start.field, "zero")
    assert "“zero” is no number" in dialog.sentence.text()
    qtbot.keyClick(start.field, KEY.Key_Return)
    assert dialog.isVisible()
    qtbot.waitUntil(ok(dialog).isEnabled)
    assert start.value() == 0
    assert dialog.sentence.text() == ""
    type_into(qtbot, start.field, "2")
    qtbot.keyClick(start.field, KEY.Key_Escape)
    assert start.value() == lambdas(window)[1] == 0
    qtbot.keyClick(start.field, KEY.Key_Up)
    assert 0 < start.value() == lambdas(window)[1]
    for widget in (start.field, start.slider):
        qtbot.keyClick(widget, KEY.Key_Z, CTRL)
        assert window.document.undo_stack.index() == 1
        assert 0 < start.value() == lambdas(window)[1]


def test_tab_goes_from_field_to_field_and_then_to_the_buttons(window, ask, qtbot):
    dialog = ask("gradient")
    start, end = dialog.findChildren(LambdaInput)
    assert start.field.hasFocus()
    for widget in (start.slider, end.field, end.slider, ok(dialog)):
        qtbot.keyClick(dialog.focusWidget(), KEY.Key_Tab)
        assert widget.hasFocus()


def test_what_cannot_be_changed_is_said_and_no_dialog_opens(window):
    window.selection.select(points=[0])
    for name in ("gradient", "smooth", "formula"):
        window.actions_by_name[name].trigger()
        assert "λ₀ shapes nothing" in window.announced
    window.selection.select(points=[5])
    window.actions_by_name["gradient"].trigger()
    assert "needs two λ" in window.announced
    assert open_dialogs(window) == []
    drawing = window.document.drawing
    window.document.apply("Lock", drawing.with_item(0, drawing[0].with_(locked=True)))
    assert not window.actions_by_name["formula"].isEnabled()


def test_without_selected_points_the_segments_points_are_meant(window, ask):
    window.selection.select(points=(), segments=[4, 5])
    dialog = ask("gradient")
    assert heading(dialog) == "λ₅, λ₆, λ₇, 3 points"
