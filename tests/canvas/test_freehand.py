"""Drawing with a free hand: strokes become curves that stay near them."""

import numpy as np
import pytest
from PySide6.QtCore import QSettings, Qt

from theditor.spline import nearest

Key = Qt.Key


@pytest.fixture
def freehand(canvas):
    canvas.show_view(4.0, 3.0, 60.0)
    canvas.use("freehand")
    yield canvas
    QSettings().clear()


def draw(hand, places):
    hand.press(places[0])
    for place in places[1:]:
        hand.move(place)
    hand.release(places[-1])


def wave(count=60):
    x = np.linspace(0.5, 7.5, count)
    noise = np.random.default_rng(4).normal(0, 0.008, count)
    return np.stack([x, 3 + 1.5 * np.sin(x) + noise], axis=1)


@pytest.mark.parametrize("degree", [2, 3])
def test_a_stroke_becomes_a_curve_with_few_points_that_stays_near_it(freehand, hand, degree):
    said = []
    freehand.announce.connect(said.append)
    QSettings().setValue("pen_degree", degree)
    stroke = wave()
    draw(hand, stroke)
    assert len(freehand.document.drawing) == 3
    curve = freehand.document.drawing[2].curve
    assert (curve.degree, curve.ends) == (degree, "clamped")
    assert len(curve.control_points) <= 12
    scale = freehand.plane.scale
    assert max(nearest(curve, place)[1] for place in stroke) * scale <= 3.5
    assert said[-1].startswith(f"Drew a curve of {len(curve.control_points)} control points, at most ")
    assert freehand.document.undo_stack.undoText() == "Draw curve"
    assert freehand.document.undo_stack.count() == 1
    assert freehand._frame().sketch is None


def test_a_stroke_that_comes_back_is_closed(freehand, hand):
    turn = np.linspace(0, 2 * np.pi, 50)
    draw(hand, np.stack([4 + 2 * np.cos(turn), 3 + 2 * np.sin(turn)], axis=1))
    assert freehand.document.drawing[2].curve.closed


def test_the_stroke_is_shown_and_escape_gives_it_up_then_leaves(freehand, hand, qtbot):
    stroke = wave()
    hand.press(stroke[0])
    for place in stroke[1:30]:
        hand.move(place)
    assert len(freehand._frame().sketch.points) == 30
    assert not freehand.grab().isNull()
    qtbot.keyClick(freehand, Key.Key_Escape)
    assert freehand._frame().sketch is None
    hand.release(stroke[30])
    assert len(freehand.document.drawing) == 2
    with qtbot.waitSignal(freehand.tool_changed) as told:
        qtbot.keyClick(freehand, Key.Key_Escape)
    assert told.args == ["select"]


def test_a_click_draws_nothing(freehand, hand):
    hand.click([4.0, 3.0])
    hand.double_click([4.0, 3.0])
    assert len(freehand.document.drawing) == 2
    assert freehand._frame().sketch is None
