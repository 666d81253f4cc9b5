"""The box around several selected points: scaling and turning them by its handles."""

import numpy as np
import pytest
from hand import CTRL, NONE, SHIFT
from PySide6.QtCore import Qt

from theditor.canvas.transform import MARGIN, OUTSIDE, Box, box_around
from theditor.drawing import Drawing, Item
from theditor.spline import Curve

POINTS = np.array([[0.0, 0.0], [1.0, 3.0], [3.0, 3.0], [5.0, -1.0], [7.0, 0.0], [8.0, 2.0]])
CHOSEN = [1, 2, 3]
LOW, HIGH = np.array([1.0, -1.0]), np.array([5.0, 3.0])


def points(canvas):
    return canvas.document.drawing[0].curve.control_points


@pytest.fixture
def boxed(canvas):
    canvas.document.start(Drawing([Item(Curve(POINTS))]))
    canvas.show_view(4.0, 1.0, 60.0)
    canvas.selection.select(points=CHOSEN)
    return canvas


def grip(canvas, *sides, beyond=MARGIN):
    return canvas.plane.to_points(Box(LOW, HIGH).place(sides, canvas.plane, beyond))


def others_stay(canvas):
    assert np.delete(points(canvas), CHOSEN, axis=0).tolist() == np.delete(POINTS, CHOSEN, axis=0).tolist()


@pytest.mark.parametrize(
    ("sides", "keys", "anchor", "factors", "offset"),
    [
        ((1, 1), NONE, LOW, (1.5, 1.25), (2.0, 1.0)),
        ((1, 0), NONE, LOW, (1.5, 1.0), (2.0, 1.0)),
        ((-1, -1), NONE, HIGH, (1.5, 1.5), (-2.0, -2.0)),
        ((1, 1), SHIFT, (LOW + HIGH) / 2, (2.0, 1.5), (2.0, 1.0)),
        ((1, 1), CTRL, LOW, (1.375, 1.375), (2.0, 1.0)),
        ((0, 1), CTRL, np.array([3.0, -1.0]), (1.25, 1.25), (2.0, 1.0)),
    ],
)
def test_a_handle_scales_about_the_opposite_side_or_the_middle(
    boxed, hand, sides, keys, anchor, factors, offset
):
    start = grip(boxed, *sides)
    hand.press(start)
    hand.move(start + np.array(offset) / 2, keys)
    hand.move(start + offset, keys)
    hand.release(start + offset, keys)
    expected = anchor + (POINTS[CHOSEN] - anchor) * factors
    assert points(boxed)[CHOSEN] == pytest.approx(expected, abs=1e-9)
    others_stay(boxed)
    assert boxed.document.undo_stack.undoText() == "Scale 3 control points"
    assert boxed.document.undo_stack.count() == 1


@pytest.mark.parametrize(
    ("keys", "pivot"), [(NONE, (LOW + HIGH) / 2), (SHIFT, LOW), (CTRL, (LOW + HIGH) / 2)]
)
def test_the_handles_outside_the_corners_turn(boxed, hand, keys, pivot):
    start = grip(boxed, 1, 1, beyond=MARGIN + OUTSIDE)
    angle = np.deg2rad(32)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    goal = pivot + (start - pivot) @ turn
    hand.press(start)
    hand.move(goal, keys)
    hand.release(goal, keys)
    if keys == CTRL:
        angle = np.deg2rad(30)
        turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    assert points(boxed)[CHOSEN] == pytest.approx(pivot + (POINTS[CHOSEN] - pivot) @ turn, abs=1e-9)
    others_stay(boxed)
    assert boxed.document.undo_stack.undoText() == "Turn 3 control points"


def test_escape_puts_the_points_back(boxed, hand, qtbot):
    start = grip(boxed, 1, 1)
    hand.press(start)
    hand.move(start + [1.0, 1.0])
    assert points(boxed)[2].tolist() != POINTS[2].tolist()
    assert not boxed.grab().isNull()
    qtbot.keyClick(boxed, Qt.Key.Key_Escape)
    assert points(boxed).tolist() == POINTS.tolist()
    assert boxed.document.undo_stack.count() == 0


def test_the_pointer_and_the_status_line_tell_what_a_handle_does(boxed, hand, qtbot):
    boxed.selection.select(points={2, 3})
    box = box_around(boxed.document.drawing[0].curve.control_points[sorted(boxed.selection.points)])
    with qtbot.waitSignal(boxed.pointed) as told:
        hand.move(boxed.plane.to_points(box.place((1, 1), boxed.plane, MARGIN)))
    assert told.args[0].hint == "Drag: scale the selected points"
    assert boxed.viewport().cursor().shape() == Qt.CursorShape.SizeBDiagCursor


def test_points_in_one_line_have_no_handles_across_and_one_point_no_box(boxed, hand):
    boxed.selection.select(points={1, 2})
    level = box_around(boxed.document.drawing[0].curve.control_points[sorted(boxed.selection.points)])
    start = boxed.plane.to_points(level.place((1, 0), boxed.plane, MARGIN))
    hand.drag(start, start + [2.0, 1.0])
    assert points(boxed)[CHOSEN[:2]] == pytest.approx(np.array([[1.0, 3.0], [5.0, 3.0]]))
    above = boxed.plane.to_points(level.place((0, 1), boxed.plane, MARGIN))
    assert boxed.hit(boxed.plane.to_pixels(above)) is None
    assert box_around(POINTS[1:2]) is None


def test_a_locked_curve_has_no_box(boxed, hand):
    item = boxed.document.drawing[0]
    boxed.document.start(Drawing([item.with_(locked=True)]))
    boxed.selection.select(points=CHOSEN)
    start = grip(boxed, 1, 1)
    hand.drag(start, start + [1.0, 1.0])
    assert points(boxed).tolist() == POINTS.tolist()


def test_while_a_handle_is_dragged_the_status_line_tells_by_how_much(boxed, hand, qtbot):
    start = grip(boxed, 1, 1)
    hand.press(start)
    with qtbot.waitSignal(boxed.pointed) as told:
        hand.move(start + (2.0, 1.0))
    assert told.args[0].hint.startswith("Scaled by 1.5 in x, 1.25 in y · Esc: take it back")
    hand.move(start + (2.0, 1.0), CTRL)
    hand.release(start + (2.0, 1.0), CTRL)
    boxed.document.undo()
    start = grip(boxed, 1, 1, beyond=MARGIN + OUTSIDE)
    middle = (LOW + HIGH) / 2
    hand.press(start)
    with qtbot.waitSignal(boxed.pointed) as told:
        hand.move(middle + (start - middle) @ np.array([[0, 1], [-1, 0]]))
    assert told.args[0].hint.startswith("Turned by 90° · ")
