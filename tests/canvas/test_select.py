"""Selecting and nudging: what a second click, a double click, Tab and the arrow keys do."""

import numpy as np
import pytest
from hand import CTRL, NONE, SHIFT
from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QLineEdit, QVBoxLayout, QWidget

from theditor.canvas import Canvas
from theditor.canvas.grid import steps
from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection
from theditor.spline import Curve, intersections

Key = Qt.Key
PILE = [[0.0, 0.0], [3.0, 3.0], [3.0, 3.0], [3.0, 3.0], [6.0, 0.0], [8.0, 2.0]]


def points(canvas, curve=0):
    return canvas.document.drawing[curve].curve.control_points


def step(canvas):
    return steps(canvas.plane.scale)[1]


def test_clicks_at_one_place_go_down_a_pile_of_handles_and_round_again(canvas, hand):
    canvas.document.start(Drawing([Item(Curve(PILE, ends="clamped"))]))
    canvas.fit()
    seen = []
    for _ in range(5):
        hand.click(PILE[2])
        seen.append(canvas.selection.points)
    assert seen == [{3}, {2}, {1}, {2}, {3}]  # the fourth is the joint that lies beneath
    assert canvas.document.undo_stack.count() == 0


def test_what_a_second_click_has_reached_is_what_is_dragged(canvas, hand):
    canvas.document.start(Drawing([Item(Curve(PILE))]))
    canvas.fit()
    hand.click(PILE[2])
    hand.click(PILE[2])
    hand.drag(PILE[2], [3.5, 4.0])
    assert points(canvas)[2] == pytest.approx([3.5, 4.0])
    assert points(canvas)[[1, 3]].tolist() == [[3.0, 3.0]] * 2


def test_a_second_click_reaches_the_crossing_curve_beneath(canvas, hand):
    across = Curve([[2.0, 0.0], [2.2, 2.0], [2.4, 4.0], [2.0, 7.0]], ends="clamped")
    drawing = canvas.document.drawing
    canvas.document.start(Drawing([*drawing, Item(across)]))
    place = across(intersections(drawing[0].curve, across)[0][1])
    reached = []
    for _ in range(4):
        hand.click(place)
        reached.append(canvas.selection.curve)
        assert canvas.selection.segments
    assert reached == [0, 2, 0, 2]


@pytest.mark.parametrize("change", [{"locked": True}, {"visible": False}])
def test_what_is_locked_or_hidden_is_never_reached(canvas, hand, change):
    first, second = canvas.document.drawing
    canvas.document.start(Drawing([first, second.with_(curve=first.curve, **change)]))
    for _ in range(3):
        hand.click(first.curve(1.5))
        assert canvas.selection.curve == 0
    hand.double_click(first.curve(1.5))
    assert canvas.selection.curve == 0


def test_a_double_click_on_another_curve_makes_it_current_and_selects_its_points(canvas, hand):
    hand.double_click(canvas.document.drawing[1].curve(0.3))
    assert canvas.selection.curve == 1
    assert canvas.selection.points == {0, 1, 2, 3}
    assert canvas.document.undo_stack.count() == 0


def test_tab_steps_through_the_points_and_f6_leaves(canvas, qtbot):
    window = QWidget()
    layout = QVBoxLayout(window)
    before, after = QLineEdit(), QLineEdit()
    for widget in (before, canvas, after):
        layout.addWidget(widget)
    qtbot.addWidget(window)
    with qtbot.waitExposed(window):
        window.show()
    canvas.setFocus()
    said = []
    canvas.announce.connect(said.append)
    for expected in (0, 1, 2):
        qtbot.keyClick(canvas, Key.Key_Tab)
        assert canvas.selection.points == {expected}
    qtbot.keyClick(canvas, Key.Key_Backtab, SHIFT)
    assert canvas.selection.points == {1}
    assert said[-1] == "P₁ at (1, 3), λ₁ = 0"
    QSettings().setValue("nudge", 0.5)
    qtbot.keyClick(canvas, Key.Key_Right)
    QSettings().remove("nudge")
    assert said[-1] == "P₁ at (1.5, 3), λ₁ = 0"
    canvas.document.undo()
    for _ in range(2):
        qtbot.keyClick(canvas, Key.Key_Backtab, SHIFT)
    assert canvas.selection.points == {5}
    qtbot.keyClick(canvas, Key.Key_F6)
    assert after.hasFocus()
    canvas.setFocus()
    qtbot.keyClick(canvas, Key.Key_F6, SHIFT)
    assert before.hasFocus()
    canvas.setFocus()
    canvas.document.start(Drawing())
    qtbot.keyClick(canvas, Key.Key_Tab)
    assert after.hasFocus()
    canvas.setParent(None)


def test_tab_brings_the_point_into_view(canvas, qtbot):
    canvas.show_view(100.0, 100.0, 50.0)
    qtbot.keyClick(canvas, Key.Key_Tab)
    pixel = canvas.plane.to_pixels(points(canvas)[0])
    assert ((pixel > 0) & (pixel < (canvas.plane.width, canvas.plane.height))).all()
    assert canvas.plane.scale == pytest.approx(50.0)


@pytest.mark.parametrize(
    ("key", "held", "direction", "size"),
    [
        (Key.Key_Left, NONE, [-1, 0], lambda canvas: step(canvas)),
        (Key.Key_Up, NONE, [0, 1], lambda canvas: step(canvas)),
        (Key.Key_Right, SHIFT, [1, 0], lambda canvas: 10 * step(canvas)),
        (Key.Key_Down, CTRL, [0, -1], lambda canvas: 1 / canvas.plane.scale),
    ],
)
def test_arrow_keys_move_the_selected_points(canvas, qtbot, key, held, direction, size):
    canvas.selection.select(points={1, 4})
    before = points(canvas)
    qtbot.keyClick(canvas, key, held)
    expected = before.copy()
    expected[[1, 4]] += np.array(direction) * size(canvas)
    assert points(canvas) == pytest.approx(expected, abs=1e-12)


def test_a_run_of_nudges_is_one_step_and_another_selection_begins_another(canvas, qtbot):
    canvas.selection.select(points={1})
    start = points(canvas)
    for _ in range(3):
        qtbot.keyClick(canvas, Key.Key_Right)
    qtbot.keyClick(canvas, Key.Key_Up)
    stack = canvas.document.undo_stack
    assert (stack.count(), stack.undoText()) == (1, "Nudge control point")
    canvas.selection.select(points={2})
    qtbot.keyClick(canvas, Key.Key_Right)
    assert stack.count() == 2
    canvas.document.undo()
    canvas.document.undo()
    assert points(canvas).tolist() == start.tolist()


def test_the_preferred_step_counts_and_locked_points_stay(canvas, qtbot):
    canvas.selection.select(points={1})
    QSettings().setValue("nudge", 0.125)
    try:
        qtbot.keyClick(canvas, Key.Key_Right)
        assert points(canvas)[1].tolist() == [1.125, 3.0]
    finally:
        QSettings().remove("nudge")
    drawing = canvas.document.drawing
    canvas.document.apply("Lock", drawing.with_item(0, drawing[0].with_(locked=True)))
    qtbot.keyClick(canvas, Key.Key_Right)
    assert points(canvas)[1].tolist() == [1.125, 3.0]


def test_a_canvas_without_curves_takes_every_key(qtbot):
    document = Document()
    canvas = Canvas(document, Selection(document))
    qtbot.addWidget(canvas)
    for key in (Key.Key_Left, Key.Key_Escape, Key.Key_Backtab, Key.Key_Return):
        qtbot.keyClick(canvas, key)
    assert document.drawing == Drawing()


def test_delete_without_a_selected_point_says_how_curves_are_deleted(canvas, qtbot):
    with qtbot.waitSignal(canvas.announce) as told:
        qtbot.keyClick(canvas, Key.Key_Delete)
    assert told.args == ["No control point is selected; whole curves are deleted in the list of curves."]
