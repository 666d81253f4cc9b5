"""The numbers beside the selection: where they lie, what can be typed, and how they are reached and left."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from theditor.canvas.transform import grips
from theditor.drawing import Drawing, Item
from theditor.spline import Curve

KEY = Qt.Key


@pytest.fixture
def card(window):
    points = np.array([[0.0, 0.0], [1.0, 2.0], [3.0, 1.0], [4.0, 0.5], [5.0, 2.0]])
    window.document.start(Drawing([Item(Curve(points), "one"), Item(Curve(points + [0.0, 4.0]), "two")]))
    window.canvas.fit()
    window.activateWindow()
    window.canvas.setFocus()
    return window.coordinates


def points(window, curve=0):
    return window.document.drawing[curve].curve.control_points


def shown(card):
    return [field.text() for field in card.fields]


def write(qtbot, card, text, key=KEY.Key_Return):
    field = card.window().focusWidget()
    assert field in card.fields
    field.selectAll()
    qtbot.keyClicks(field, text)
    qtbot.keyClick(field, key)


def test_enter_goes_there_and_numbers_move_the_point(window, card, qtbot):
    assert not card.isVisible()
    window.selection.select(points={2})
    assert card.isVisible()
    assert shown(card) == ["3", "1"]
    qtbot.keyClick(window.canvas, KEY.Key_Return)
    write(qtbot, card, "+1.5", KEY.Key_Tab)
    write(qtbot, card, "2/3")
    assert points(window)[2].tolist() == [4.5, 2 / 3]
    assert window.canvas.hasFocus()
    assert window.document.undo_stack.undoText() == "Move control point"
    window.document.undo()
    window.document.undo()
    assert points(window)[2].tolist() == [3.0, 1.0]
    assert shown(card) == ["3", "1"]


def test_escape_leaves_and_changes_nothing(window, card, qtbot):
    window.selection.select(points={2})
    qtbot.keyClick(window.canvas, KEY.Key_Enter)
    write(qtbot, card, "77", KEY.Key_Escape)
    assert window.canvas.hasFocus()
    assert window.document.undo_stack.count() == 0
    assert window.selection.points == {2}


def test_several_points_are_moved_together_by_their_middle(window, card, qtbot):
    window.selection.select_across({0: [1, 2], 1: [1]})
    assert shown(card) == ["2", "3.5"]
    before = np.vstack([points(window, 0)[[1, 2]], points(window, 1)[1]])
    qtbot.keyClick(window.canvas, KEY.Key_Return)
    write(qtbot, card, "*2")
    after = np.vstack([points(window, 0)[[1, 2]], points(window, 1)[1]])
    assert after.tolist() == (before + [2.0, 0.0]).tolist()
    assert window.document.undo_stack.undoText() == "Move 3 control points on 2 curves"


def test_the_arrow_keys_step_in_one_run(window, card, qtbot):
    window.selection.select(points={2})
    qtbot.keyClick(window.canvas, KEY.Key_Return)
    for _ in range(3):
        qtbot.keyClick(card.fields[0], KEY.Key_Up)
    assert points(window)[2, 0] > 3.0
    assert window.document.undo_stack.count() == 1


def test_it_hides_while_the_hand_drags_and_when_it_is_switched_off(window, card, hand, qtbot):
    hand.press([3.0, 1.0])
    hand.move([3.5, 1.5])
    assert not card.isVisible()
    hand.release([3.5, 1.5])
    assert card.isVisible()
    assert shown(card) == ["3.5", "1.5"]
    action = window.actions_by_name["show_coordinates"]
    action.setChecked(False)
    assert not card.isVisible()
    window.actions_by_name["coordinates"].trigger()
    assert card.fields[0].hasFocus()
    qtbot.keyClick(card.fields[0], KEY.Key_Escape)
    assert not card.isVisible()
    action.setChecked(True)
    window.selection.select(points=())
    assert not card.isVisible()


def test_the_longest_numbers_show_from_their_sign_on_in_any_font(window, card, qtbot):
    places = [[-1.23456789e-10, -123456.789], [-0.570796327, -1.0], [3.0, 1.0], [4.0, 0.5]]
    window.document.start(Drawing([Item(Curve(places))]))
    for point in (0, 1):
        for size in (9, 15):
            card.setStyleSheet(f"font-size: {size}pt")
            window.selection.select(points={point})
            for field in card.fields:
                edit = field.lineEdit()
                margins = edit.textMargins()
                room = edit.width() - margins.left() - margins.right()
                assert edit.fontMetrics().horizontalAdvance(edit.text()) < room
            window.selection.select(points=())
    window.selection.select(points={1})
    field = card.fields[0]
    for key in (KEY.Key_Return, KEY.Key_Escape):
        qtbot.keyClick(window.focusWidget(), key)
    assert field.lineEdit().cursorPosition() == 0


@pytest.mark.parametrize("chosen", [[0], [1], [2], [4], [1, 3], [0, 1, 2, 3, 4]])
def test_it_lies_within_the_canvas_and_covers_no_selected_point(window, card, chosen):
    window.selection.select(points=chosen)
    assert window.canvas.rect().contains(card.geometry())
    for pixel in window.canvas.plane.to_pixels(points(window)[chosen]):
        assert not card.geometry().contains(QPoint(*pixel.astype(int)))
    for pixel in grips(points(window)[chosen], window.canvas.plane):
        assert not card.geometry().contains(QPoint(*pixel.astype(int)))
    assert not card.geometry().intersects(window.canvas.legend_area)
