"""Control points of several curves selected and edited as one set."""

import numpy as np
import pytest
from hand import CTRL, SHIFT
from PySide6.QtCore import Qt

from theditor.canvas.arrange import aligned, arrange, flipped
from theditor.canvas.points import insert, make_corners, remove
from theditor.canvas.transform import MARGIN, box_around

GROUND = [-1.0, 7.0]
ACROSS = {0: [1, 2], 1: [0, 1]}
"""What a rectangle from the ground to (3.5, 2) holds."""


def points(canvas, curve):
    return canvas.document.drawing[curve].curve.control_points


def across(canvas):
    return {curve: of.tolist() for curve, of in canvas.selection.across.items()}


@pytest.fixture
def chosen(canvas, hand):
    hand.drag(GROUND, [3.5, 2.0])
    assert across(canvas) == ACROSS
    return canvas


def selected(canvas):
    return np.vstack([points(canvas, curve)[of] for curve, of in ACROSS.items()])


def test_a_rectangle_takes_points_of_all_curves_and_shift_and_ctrl_change_them(chosen, hand):
    assert chosen.selection.curve == 0, "the current curve stays if it has points inside"
    hand.drag([7.5, 7.0], [8.5, 1.5], keys=SHIFT)
    assert across(chosen) == {0: [1, 2, 5], 1: [0, 1, 3]}
    hand.drag(GROUND, [2.0, 2.0], keys=SHIFT | CTRL)
    assert across(chosen) == {0: [2, 5], 1: [1, 3]}
    hand.click([-1.0, 6.9])
    assert across(chosen) == {}


def test_a_rectangle_around_another_curve_makes_it_current(canvas, hand, qtbot):
    hand.press([-1.0, 7.0])
    hand.move([5.0, 4.5])
    assert (canvas.selection.curve, across(canvas)) == (1, {1: [0, 1]})
    qtbot.keyClick(canvas, Qt.Key.Key_Escape)
    assert (canvas.selection.curve, across(canvas)) == (0, {})


def test_locked_and_hidden_curves_are_not_taken(canvas, hand):
    drawing = canvas.document.drawing
    canvas.document.apply("Lock", drawing.with_item(1, drawing[1].with_(locked=True)))
    hand.drag(GROUND, [3.5, 2.0])
    assert across(canvas) == {0: [1, 2]}


def test_a_handle_that_shows_on_another_curve_can_be_added_dragged_and_chosen_alone(chosen, hand):
    hand.click(points(chosen, 1)[3], keys=SHIFT)
    assert across(chosen) == {0: [1, 2], 1: [0, 1, 3]}
    assert chosen.selection.curve == 1
    before = points(chosen, 0)[1]
    hand.drag(points(chosen, 1)[0], points(chosen, 1)[0] + [0.5, -0.25])
    assert points(chosen, 0)[1] == pytest.approx(before + [0.5, -0.25])
    assert chosen.document.undo_stack.undoText() == "Move 5 control points on 2 curves"
    chosen.document.undo()
    hand.click(points(chosen, 0)[2])
    assert (chosen.selection.curve, across(chosen)) == (0, {0: [2]})


def test_shift_and_a_click_on_another_curve_show_its_handles(canvas, hand):
    canvas.selection.select(points={1})
    hand.click(canvas.document.drawing[1].curve(0.5), keys=SHIFT)
    assert (canvas.selection.curves, across(canvas)) == ((0, 1), {0: [1]})
    hand.click(points(canvas, 1)[2], keys=SHIFT)
    assert across(canvas) == {0: [1], 1: [2]}
    hand.click(canvas.document.drawing[0].curve(0.5), keys=SHIFT)
    assert canvas.selection.curves == (1,)


def test_what_is_selected_is_counted_in_the_status_line(chosen, hand, qtbot):
    with qtbot.waitSignal(chosen.pointed) as told:
        hand.move([5.0, 7.0])
    assert told.args[0].over == "4 control points selected on 2 curves"


def test_arrow_keys_move_all_in_one_step(chosen, qtbot):
    before = selected(chosen)
    for _ in range(3):
        qtbot.keyClick(chosen, Qt.Key.Key_Right, Qt.KeyboardModifier.ControlModifier)
    assert selected(chosen) == pytest.approx(before + [3 / chosen.plane.scale, 0.0])
    stack = chosen.document.undo_stack
    assert (stack.count(), stack.undoText()) == (1, "Nudge 4 control points on 2 curves")


def test_one_box_scales_all(chosen, hand):
    before = selected(chosen)
    box = box_around(before)
    corner = chosen.plane.to_points(box.place((1, 1), chosen.plane, MARGIN))
    hand.drag(corner, corner + (box.high - box.low))
    assert selected(chosen) == pytest.approx(box.low + 2 * (before - box.low))
    assert chosen.document.undo_stack.undoText() == "Scale 4 control points on 2 curves"


def test_arranging_takes_them_as_one_set_and_whole_curves_if_none_is_selected(chosen):
    arrange(chosen.document, chosen.selection, "Align left", aligned(0, 0.0))
    assert selected(chosen)[:, 0].tolist() == [0.0] * 4
    assert chosen.document.undo_stack.undoText() == "Align left: 4 control points on 2 curves"
    chosen.document.undo()
    chosen.selection.select_across({0: [], 1: []})
    every = np.vstack([points(chosen, 0), points(chosen, 1)])
    arrange(chosen.document, chosen.selection, "Flip horizontally", flipped(0))
    assert np.vstack([points(chosen, 0), points(chosen, 1)])[:, 0].tolist() == (8.0 - every[:, 0]).tolist()


def test_delete_takes_points_of_all_curves_and_curves_with_too_few_left(chosen, hand, qtbot):
    with qtbot.waitSignal(chosen.pointed) as told:
        hand.move([5.0, 7.0])
    assert told.args[0].hint == "Delete: the whole curve, for too few control points would stay"
    before = chosen.document.drawing
    said = []
    remove(chosen.document, chosen.selection, said.append, refit=True)
    (told,) = said
    assert [item.name for item in chosen.document.drawing] == ["one"]
    assert len(points(chosen, 0)) == 4
    assert told.startswith("Deleted 2 control points; the shape changed by at most ")
    assert told.endswith(". Deleted “two”: too few control points would have stayed")
    assert chosen.document.undo_stack.undoText() == "Delete 4 control points on 2 curves"
    chosen.document.undo()
    assert chosen.document.drawing == before


def test_points_are_inserted_beside_those_selected_on_each_curve(chosen):
    said = []
    insert(chosen.document, chosen.selection, said.append)
    (told,) = said
    assert told.startswith("Inserted 2 control points on 2 curves; the shape ")
    assert [len(item.curve.control_points) for item in chosen.document.drawing] == [7, 5]
    assert across(chosen) == {0: [2], 1: [2]}
    assert chosen.document.undo_stack.undoText() == "Insert 2 control points on 2 curves"


def test_corners_are_made_on_each_curve(canvas):
    canvas.selection.select_across({0: [2], 1: [1]})
    assert make_corners(canvas.document, canvas.selection) == "Made a corner at 2 control points on 2 curves"
    assert [len(item.curve.control_points) for item in canvas.document.drawing] == [8, 6]
    assert across(canvas) == {0: [2, 3, 4], 1: [1, 2, 3]}
