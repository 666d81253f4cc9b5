"""Several curves edited together in the real window, by mouse and keys."""

import numpy as np
import pytest
from hand import SHIFT
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget

from theditor.drawing import Drawing, Item
from theditor.spline import Curve

Key = Qt.Key
POINTS = np.array([[0.0, 0.0], [1.0, 2.0], [3.0, 1.0], [4.0, 0.5], [5.0, 2.0]])


@pytest.fixture
def three(window):
    window.document.start(Drawing([Item(Curve(POINTS + [0.0, 3.0 * k]), f"Curve {k}") for k in range(3)]))
    window.canvas.fit()
    window.activateWindow()
    window.canvas.setFocus()
    return window


def across(window):
    return {i: points.tolist() for i, points in window.selection.across.items()}


def points(window, curve):
    return window.document.drawing[curve].curve.control_points


@pytest.mark.parametrize("panel", ["lambda_strip", "points", "curvature", "continuity"])
def test_whatever_panel_is_open_a_selection_across_curves_stays(three, hand, qtbot, panel):
    dock = three.findChild(QDockWidget, panel)
    dock.show()
    dock.raise_()
    qtbot.waitUntil(lambda: dock.widget() is not None and dock.widget().isVisible())
    hand.drag([0.5, 6.0], [3.5, 0.6])
    assert across(three) == {0: [1, 2], 1: [1, 2]}
    hand.click(points(three, 1)[4], keys=SHIFT)
    assert (three.selection.curve, across(three)) == (1, {0: [1, 2], 1: [1, 2, 4]})
    hand.move([0.2, 7.8])
    assert three.announced == "5 control points selected on 2 curves"
    start = three.document.drawing
    for key in (Key.Key_Right, Key.Key_H):
        qtbot.keyClick(three.canvas, key)
        assert across(three) == {0: [1, 2], 1: [1, 2, 4]}
    assert points(three, 0)[1, 0] > 1.0
    lambdas = [item.curve.lambdas.tolist() for item in three.document.drawing]
    assert lambdas == [[0, 1, 1, 0, 0], [0, 1, 1, 0, 0], [0] * 5], (
        "that of a free end shapes nothing and stays"
    )
    three.document.undo()
    three.document.undo()
    assert three.document.drawing == start
    assert across(three) == {0: [1, 2], 1: [1, 2, 4]}


def test_select_all_takes_the_selected_curves_and_with_alt_all_of_them(three, qtbot):
    alt = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
    three.selection.select_across({0: [], 2: []})
    qtbot.keyClick(three.canvas, Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    assert across(three) == {0: [*range(5)], 2: [*range(5)]}
    three.curves.list.setFocus()
    qtbot.keyClick(three.curves.list, Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    assert three.selection.curves == (0, 1, 2)
    qtbot.keyClick(three.canvas, Key.Key_A, alt)
    assert across(three) == {k: [*range(5)] for k in range(3)}
    qtbot.keyClick(three.canvas, Key.Key_Delete)
    assert three.document.drawing == Drawing()
    assert three.document.undo_stack.undoText() == "Delete 3 curves"
