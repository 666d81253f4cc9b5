"""Drawing with the pen, through the mouse and the keys."""

import numpy as np
import pytest
from hand import CTRL
from PySide6.QtCore import QSettings, Qt

from theditor.model import LIGHT
from theditor.spline import Curve

Key = Qt.Key
PLACES = [[1.0, 7.0], [2.0, 8.5], [4.0, 7.5], [6.0, 8.5]]


@pytest.fixture
def pen(canvas):
    canvas.show_view(4.0, 5.0, 60.0)
    canvas.use("pen")
    yield canvas
    QSettings().remove("pen_degree")


def drawn(canvas):
    assert len(canvas.document.drawing) == 3
    assert canvas.selection.curve == 2
    assert canvas.document.undo_stack.undoText() == "Draw curve"
    assert canvas.document.undo_stack.count() == 1
    return canvas.document.drawing[2]


def test_clicks_place_points_and_enter_ends_the_curve_in_one_step(pen, hand, qtbot):
    for place in PLACES:
        hand.click(place)
        assert len(pen.document.drawing) == 2
    qtbot.keyClick(pen, Key.Key_Return)
    item = drawn(pen)
    assert item.name == "Curve 1"
    assert item.curve == Curve(item.curve.control_points, ends="clamped")
    assert item.curve.control_points == pytest.approx(np.array(PLACES))
    hand.click(PLACES[0])
    hand.click(PLACES[1])
    qtbot.keyClick(pen, Key.Key_Enter)
    assert pen.document.drawing[3].name == "Curve 2"


def test_a_double_click_ends_with_its_own_point(pen, hand):
    for place in PLACES[:2]:
        hand.click(place)
    hand.double_click(PLACES[2])
    assert drawn(pen).curve.control_points == pytest.approx(np.array(PLACES[:3]))


def test_a_click_on_the_first_point_closes(pen, hand):
    for place in PLACES:
        hand.click(place)
    near = np.array(PLACES[0]) + 5.0 / pen.plane.scale
    hand.move(near)
    assert pen._frame().snapped.to == "close the curve"
    hand.click(near)
    curve = drawn(pen).curve
    assert curve.closed
    assert curve.control_points == pytest.approx(np.array(PLACES))


def test_the_curve_to_come_is_shown_and_follows_the_pointer(pen, hand):
    for place in PLACES[:3]:
        hand.click(place)
    hand.move(PLACES[3])
    to_come = pen._frame().sketch.curve
    assert to_come.control_points == pytest.approx(np.array(PLACES))
    x, y = pen.plane.to_pixels(to_come(1.5)).astype(int).tolist()
    image = pen.grab().toImage()
    assert LIGHT.accent.lower() in {
        image.pixelColor(x + i, y + j).name() for i in (-1, 0, 1) for j in (-1, 0, 1)
    }


def test_backspace_takes_back_and_escape_gives_up_then_leaves(pen, hand, qtbot):
    for place in PLACES:
        hand.click(place)
    qtbot.keyClick(pen, Key.Key_Backspace)
    assert len(pen._frame().sketch.points) == 4  # three, and the one at the pointer
    hand.move(PLACES[2])
    assert len(pen._frame().sketch.points) == 3
    with qtbot.assertNotEmitted(pen.tool_changed):
        qtbot.keyClick(pen, Key.Key_Escape)
    assert pen._frame().sketch is None
    with qtbot.waitSignal(pen.tool_changed) as told:
        qtbot.keyClick(pen, Key.Key_Escape)
    assert told.args == ["select"]
    assert len(pen.document.drawing) == 2


def test_too_few_points_are_refused_and_the_degree_is_kept(pen, hand, qtbot):
    said = []
    pen.announce.connect(said.append)
    qtbot.keyClick(pen, Key.Key_2)
    for place in PLACES[:2]:
        hand.click(place)
    qtbot.keyClick(pen, Key.Key_Return)
    assert said == ["A quadratic curve needs at least 3 control points: click on, or give it up."]
    hand.click(PLACES[2])
    qtbot.keyClick(pen, Key.Key_Return)
    assert drawn(pen).curve.degree == 2
    hand.click(PLACES[0])
    assert pen._tool.degree == 2


def test_a_press_places_a_point_that_follows_until_the_button_is_up(pen, hand, qtbot):
    hand.click(PLACES[0])
    hand.drag(PLACES[1], PLACES[3])
    hand.press(PLACES[2])
    hand.move([5.0, 5.0])
    qtbot.keyClick(pen, Key.Key_Escape)
    hand.release([5.0, 5.0])
    qtbot.keyClick(pen, Key.Key_Return)
    assert drawn(pen).curve.control_points == pytest.approx(np.array([PLACES[0], PLACES[3]]))


def test_ctrl_keeps_to_the_horizontal_and_taking_up_another_tool_keeps_the_curve(pen, hand):
    hand.click(PLACES[0])
    hand.click([5.0, 7.4], keys=CTRL)
    pen.use("select")
    assert drawn(pen).curve.control_points == pytest.approx(np.array([PLACES[0], [5.0, 7.0]]))


def test_the_pen_starts_an_empty_drawing(pen, hand, qtbot):
    pen.document.start(type(pen.document.drawing)())
    for place in PLACES:
        hand.click(place)
    qtbot.keyClick(pen, Key.Key_Return)
    assert pen.selection.curve == 0
    assert not pen.grab().isNull()
