"""Preferences are in force as soon as they are changed, and kept."""

import numpy as np
import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QApplication

from theditor.app.preferences import Preferences
from theditor.model import DARK

KEYS = ("theme", "nudge", "pen_degree", "freehand_tolerance")


def forget():
    for key in KEYS:
        QSettings().remove(key)


@pytest.fixture
def ask(window, qtbot):
    """Opens the dialog anew."""
    forget()

    def opened():
        window.actions_by_name["preferences"].trigger()
        dialog = window.findChildren(Preferences)[-1]
        dialog.activateWindow()
        qtbot.waitUntil(dialog.isActiveWindow)
        return dialog

    yield opened
    forget()


def choose(qtbot, box, text):
    box.setFocus()
    while box.currentText() != text:
        qtbot.keyClick(box, Qt.Key.Key_Down if box.findText(text) > box.currentIndex() else Qt.Key.Key_Up)


def test_the_theme_changes_at_once(window, ask, qtbot):
    dialog = ask()
    choose(qtbot, dialog.theme, "Dark")
    ground = QApplication.palette().color(QPalette.ColorRole.Window).name()
    assert ground.upper() == DARK.window
    assert window.actions_by_name["theme_dark"].isChecked()
    dialog.reject()
    assert ask().theme.currentText() == "Dark"


def test_the_next_nudge_is_as_long_as_preferred(window, ask, qtbot):
    dialog = ask()
    dialog.nudge.setFocus()
    dialog.nudge.selectAll()
    qtbot.keyClicks(dialog.nudge, "0,25")
    qtbot.keyClick(dialog.nudge, Qt.Key.Key_Tab)
    dialog.reject()
    window.selection.select(points={5})
    before = window.document.drawing[0].curve.control_points[5]
    qtbot.keyClick(window.canvas, Qt.Key.Key_Right)
    after = window.document.drawing[0].curve.control_points[5]
    assert after - before == pytest.approx([0.25, 0.0])
    dialog = ask()
    assert dialog.nudge.value() == 0.25
    qtbot.keyClick(dialog.nudge, Qt.Key.Key_Up)
    assert QSettings().value("nudge") == pytest.approx(0.35)
    dialog.reject()


def test_the_pen_draws_in_the_degree_chosen(window, ask, qtbot, hand):
    dialog = ask()
    choose(qtbot, dialog.degree, "Quadratic · C¹")
    dialog.reject()
    window.actions_by_name["tool_pen"].trigger()
    for point in ((-3.0, 0.5), (-2.6, 1.0), (-2.2, 0.4), (-1.8, 1.0)):
        hand.click(point)
    qtbot.keyClick(window.canvas, Qt.Key.Key_Return)
    assert window.document.drawing[-1].curve.degree == 2


def test_settings_that_make_no_sense_are_passed_over(ask):
    for key in KEYS:
        QSettings().setValue(key, "nonsense")
    dialog = ask()
    assert (dialog.theme.currentText(), dialog.nudge.value()) == ("As the system", 0.0)
    assert dialog.degree.currentText() == "Cubic · C²"
    assert dialog.tolerance.value() == 2.0


def test_the_freehand_tool_stays_as_near_as_chosen_and_no_nearer(window, ask, qtbot, hand):
    t = np.linspace(0.0, 1.0, 60)
    stroke = np.c_[-3.4 + 2.4 * t, 1.0 + 0.4 * np.sin(18 * t)]
    misses = []
    for tolerance in ("0.5", "10"):
        dialog = ask()
        dialog.tolerance.setFocus()
        dialog.tolerance.selectAll()
        qtbot.keyClicks(dialog.tolerance, tolerance)
        qtbot.keyClick(dialog.tolerance, Qt.Key.Key_Tab)
        dialog.reject()
        window.actions_by_name["tool_freehand"].trigger()
        hand.press(stroke[0])
        for point in stroke[1:]:
            hand.move(point)
        hand.release(stroke[-1])
        misses.append(float(window.announced.partition("at most ")[2].partition(" px")[0]))
        window.document.undo()
    assert misses[0] <= 0.5 < misses[1] <= 10.0


def test_a_curve_is_added_with_the_degree_that_is_preferred(window, ask, qtbot):
    dialog = ask()
    choose(qtbot, dialog.degree, "Quadratic · C¹")
    dialog.reject()
    window.actions_by_name["add"].trigger()
    assert window.document.drawing[-1].curve.degree == 2
