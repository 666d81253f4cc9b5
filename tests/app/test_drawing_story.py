"""Selecting, drawing and snapping on the real window: toolbar, keys, menu, status line."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QToolBar

Key = Qt.Key


def action(window, name):
    return window.actions_by_name[name]


def test_the_pen_is_taken_up_by_its_key_and_put_away_by_escape(window, hand, qtbot):
    before = len(window.document.drawing)
    canvas = window.canvas
    canvas.setFocus()
    qtbot.keyClick(canvas, Key.Key_B)
    assert action(window, "tool_pen").isChecked()
    assert not action(window, "tool_select").isChecked()
    hand.move((0.0, 0.0))
    assert window._hint.text().startswith("Click: first control point of a cubic")
    plane = canvas.plane
    places = plane.to_points(np.array([[60.0, 60.0], [160.0, 80.0], [200.0, 180.0]]))
    for place in places:
        hand.click(place)
    qtbot.keyClick(canvas, Key.Key_Return)
    qtbot.keyClick(canvas, Key.Key_Escape)
    assert action(window, "tool_select").isChecked()
    assert len(window.document.drawing) == before + 1
    assert window.document.drawing[-1].curve.control_points == pytest.approx(places)
    assert action(window, "undo").text() == "&Undo Draw curve"
    qtbot.keyClick(window, Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert len(window.document.drawing) == before


def test_tools_stand_first_on_the_toolbar_and_change_at_a_click(window, qtbot):
    toolbar = window.findChild(QToolBar)
    first = [a.iconText() for a in toolbar.actions()[:3]]
    assert first == ["Select", "Pen", "Freehand"]
    qtbot.mouseClick(toolbar.widgetForAction(action(window, "tool_pen")), Qt.MouseButton.LeftButton)
    assert window.canvas.viewport().cursor().shape() != Qt.CursorShape.SizeAllCursor
    assert action(window, "tool_pen").isChecked()
    window.canvas.setFocus()
    qtbot.keyClick(window.canvas, Key.Key_S)
    assert action(window, "tool_select").isChecked()


def test_a_stroke_with_a_free_hand_becomes_a_curve(window, hand, qtbot):
    window.canvas.setFocus()
    qtbot.keyClick(window.canvas, Key.Key_P)
    assert action(window, "tool_freehand").isChecked()
    x = np.linspace(80.0, 300.0, 40)
    stroke = window.canvas.plane.to_points(np.stack([x, 200 + 40 * np.sin(x / 40)], axis=1))
    hand.press(stroke[0])
    for place in stroke[1:]:
        hand.move(place)
    hand.release(stroke[-1])
    assert len(window.document.drawing) == 2
    assert window.announced.startswith("Drew a curve of ")
    assert action(window, "undo").text() == "&Undo Draw curve"


def test_snapping_is_switched_by_its_key(window, qtbot):
    window.canvas.setFocus()
    assert not window.canvas.snapper.on
    qtbot.keyClick(window.canvas, Key.Key_Percent)
    assert window.canvas.snapper.on
    assert action(window, "snap").isChecked()


def test_the_selection_is_inverted_by_its_key(window, qtbot):
    window.selection.select(points={1, 2})
    keys = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    qtbot.keyClick(window, Key.Key_I, keys)
    count = len(window.selection.item.curve.control_points)
    assert window.selection.points == set(range(count)) - {1, 2}


def test_stepping_says_where_the_point_is(window, qtbot):
    window.canvas.setFocus()
    qtbot.keyClick(window.canvas, Key.Key_Tab)
    assert window.announced.startswith("P₀ at (")


def test_insert_and_delete_act_on_what_is_selected_and_say_how_well(window, qtbot):
    canvas, before = window.canvas, window.document.drawing
    count = len(before[0].curve.control_points)
    canvas.setFocus()
    window.selection.select(segments={4})
    qtbot.keyClick(canvas, Key.Key_Insert)
    assert len(window.document.drawing[0].curve.control_points) == count + 1
    assert window.announced.startswith("Inserted P")
    assert "the shape changed by at most" in window.announced
    qtbot.keyClick(canvas, Key.Key_Delete)
    assert len(window.document.drawing[0].curve.control_points) == count
    assert window.announced.startswith("Deleted 1 control point; the shape changed by at most")
    assert action(window, "undo").text() == "&Undo Delete control point"
    inner = window.document.drawing[0].curve
    window.selection.select(points={5})
    qtbot.keyClick(canvas, Key.Key_Delete, Qt.KeyboardModifier.ControlModifier)
    left = window.document.drawing[0].curve
    assert left.control_points.tolist() == np.delete(inner.control_points, 5, axis=0).tolist()
    window.selection.select(points=range(3, count))
    assert window._hint.text().startswith("Delete: the whole curve")
    qtbot.keyClick(canvas, Key.Key_Delete)
    assert len(window.document.drawing) == len(before) - 1
    for _ in range(4):
        qtbot.keyClick(window, Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert window.document.drawing == before
    assert not action(window, "delete_points").isEnabled() or window.selection.points
