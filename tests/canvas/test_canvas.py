"""The canvas under a real mouse: what is grabbed moves, what is clicked is selected, what is shown is true."""

import numpy as np
import pytest
from hand import CTRL, MIDDLE, NONE, SHIFT
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor

from theditor.drawing import Drawing, Item
from theditor.model import LIGHT
from theditor.spline import Curve, Mode

POINTS = [[0.0, 0.0], [1.0, 3.0], [3.0, 3.0], [5.0, -1.0], [7.0, 0.0], [8.0, 2.0]]
OTHER = [[0.0, 5.0], [3.0, 6.0], [6.0, 5.0], [8.0, 6.0]]


def points(canvas, curve=0):
    return canvas.document.drawing[curve].curve.control_points


def test_a_dragged_handle_follows_the_pointer_in_one_step(canvas, hand):
    hand.drag(POINTS[2], [3.5, 4.0])
    assert points(canvas)[2] == pytest.approx([3.5, 4.0], abs=1e-12)
    assert np.delete(points(canvas), 2, axis=0).tolist() == np.delete(POINTS, 2, axis=0).tolist()
    assert canvas.document.undo_stack.undoText() == "Move control point"
    canvas.document.undo()
    assert points(canvas).tolist() == POINTS


def test_a_press_beside_the_middle_of_a_handle_does_not_make_it_jump(canvas, hand):
    off = np.array([4.0, 3.0]) / canvas.plane.scale
    hand.drag(POINTS[2] + off, np.array([3.5, 4.0]) + off)
    assert points(canvas)[2] == pytest.approx([3.5, 4.0], abs=1e-12)


def test_the_curve_follows_live_and_escape_takes_the_drag_back(canvas, hand, qtbot):
    hand.press(POINTS[2])
    hand.move([4.0, 5.0])
    assert points(canvas)[2] == pytest.approx([4.0, 5.0])
    qtbot.keyClick(canvas, Qt.Key.Key_Escape)
    assert points(canvas).tolist() == POINTS
    hand.move([6.0, 6.0])
    hand.release([6.0, 6.0])
    assert points(canvas).tolist() == POINTS
    assert canvas.document.undo_stack.count() == 0


def test_a_wheel_in_mid_drag_leaves_the_point_under_the_pointer(canvas, hand):
    hand.press(POINTS[2])
    hand.move([3.4, 3.2])
    hand.wheel([3.4, 3.2], 3)
    hand.move([3.5, 3.3])
    assert points(canvas)[2] == pytest.approx([3.5, 3.3], abs=1e-9)


def test_another_curve_made_current_in_mid_drag_does_no_harm(canvas, hand):
    hand.press(POINTS[2])
    hand.move([3.4, 3.2])
    moved = canvas.document.drawing
    canvas.document.apply("Duplicate", moved.inserted(2, moved[0]))
    canvas.selection.select(curve=2)
    hand.move([6.0, 6.0])
    hand.release([6.0, 6.0])
    assert canvas.document.drawing[0] == moved[0]
    assert canvas.document.undo_stack.count() == 2


def test_ctrl_keeps_to_the_horizontal_or_vertical(canvas, hand):
    hand.drag(POINTS[2], [4.0, 3.2], keys=CTRL)
    assert points(canvas)[2] == pytest.approx([4.0, 3.0])


def test_click_selects_shift_adds_and_dragging_one_of_several_moves_all(canvas, hand):
    hand.click(POINTS[1])
    assert canvas.selection.points == {1}
    hand.click(POINTS[3], SHIFT)
    assert canvas.selection.points == {1, 3}
    hand.drag(POINTS[1], [1.5, 3.5])
    assert points(canvas)[[1, 3]] == pytest.approx(np.array([[1.5, 3.5], [5.5, -0.5]]))
    assert canvas.document.undo_stack.undoText() == "Move 2 control points"
    hand.click([5.5, -0.5], SHIFT)
    assert canvas.selection.points == {1}
    hand.click([20.0, 20.0])
    assert canvas.selection.points == frozenset()


def test_a_click_on_one_of_several_selects_it_alone(canvas, hand):
    canvas.selection.select(points={1, 2, 3})
    hand.click(POINTS[2])
    assert canvas.selection.points == {2}
    assert canvas.document.undo_stack.count() == 0


def test_a_marquee_selects_adds_and_removes(canvas, hand):
    hand.drag([-0.5, -0.5], [3.5, 3.6])
    assert canvas.selection.points == {0, 1, 2}
    hand.drag([4.2, -1.6], [5.6, -0.4], SHIFT)
    assert canvas.selection.points == {0, 1, 2, 3}
    hand.drag([2.4, 3.8], [3.6, 2.6], CTRL | SHIFT)
    assert canvas.selection.points == {0, 1, 3}


def test_clicking_on_the_curve_selects_the_segment_and_frees_the_points(canvas, hand):
    canvas.selection.select(points={1})
    curve = canvas.document.drawing[0].curve
    hand.click(curve(1.4))
    assert canvas.selection.segments == {1}
    assert canvas.selection.points == frozenset()
    hand.click(curve(0.4), SHIFT)
    assert canvas.selection.segments == {0, 1}


def test_clicking_another_curve_makes_it_current_but_not_a_locked_or_hidden_one(canvas, hand):
    place = canvas.document.drawing[1].curve(0.5)
    hand.click(place)
    assert (canvas.selection.curve, canvas.selection.segments) == (1, {0})
    canvas.selection.select(curve=0)
    for change in ({"locked": True}, {"visible": False}):
        drawing = canvas.document.drawing
        canvas.document.apply("Style", drawing.with_item(1, drawing[1].with_(**change)))
        hand.click(place)
        assert canvas.selection.curve == 0


def test_points_of_a_locked_curve_stay(canvas, hand):
    drawing = canvas.document.drawing
    canvas.document.apply("Lock", drawing.with_item(0, drawing[0].with_(locked=True)))
    hand.drag(POINTS[2], [3.5, 4.0])
    assert points(canvas).tolist() == POINTS


def test_hover_says_what_would_be_grabbed(canvas, hand, qtbot):
    with qtbot.waitSignal(canvas.pointed) as told:
        hand.move(POINTS[3])
    assert told.args[0].over == "over control point P₃"
    assert told.args[0].position == pytest.approx(POINTS[3])
    assert canvas.viewport().cursor().shape() == Qt.CursorShape.SizeAllCursor
    with qtbot.waitSignal(canvas.pointed) as told:
        hand.move(canvas.document.drawing[0].curve(1.5))
    assert told.args[0].over.startswith("over segment 2 at t = 0.50 · κ ")
    beside = canvas.document.drawing[0].curve(1.5) + np.array([0, 3.0 / canvas.plane.scale])
    assert colour_near(canvas, beside, LIGHT.selection)
    hand.move([20.0, 20.0])
    assert not colour_near(canvas, beside, LIGHT.selection)


def test_the_wheel_zooms_at_the_pointer_and_f_fits(canvas, hand):
    fitted = canvas.plane
    pixel = hand.pixel(POINTS[2])
    hand.wheel(POINTS[2], 3)
    assert canvas.plane.scale == pytest.approx(fitted.scale * 1.25**3)
    assert canvas.plane.to_pixels(POINTS[2]) == pytest.approx(pixel, abs=1e-6)
    canvas.fit()
    assert canvas.plane.scale == pytest.approx(fitted.scale)


def test_middle_and_space_drags_pan(canvas, hand, qtbot):
    scale = canvas.plane.scale
    pixel = hand.pixel([4.0, 2.0])
    hand.drag([4.0, 2.0], [5.0, 2.5], NONE, MIDDLE)
    assert canvas.plane.to_points(pixel) == pytest.approx([3.0, 1.5])
    qtbot.keyPress(canvas, Qt.Key.Key_Space)
    hand.drag(points(canvas)[2], points(canvas)[2] + [1.0, 0.5])
    qtbot.keyRelease(canvas, Qt.Key.Key_Space)
    assert canvas.plane.to_points(pixel) == pytest.approx([2.0, 1.0])
    assert canvas.plane.scale == pytest.approx(scale)
    assert points(canvas).tolist() == POINTS


def test_zoom_stops_where_numbers_end(canvas, hand):
    for notches in (400, -800):
        hand.wheel([1.0, 1.0], notches)
        assert np.isfinite(canvas.plane.scale)
        assert 1e-13 < canvas.plane.scale < 1e13
        canvas.grab()


def test_a_point_stops_where_coordinates_end(canvas, hand):
    canvas.show_view(0.0, 0.0, 1e-10)
    canvas.document.start(Drawing([Item(Curve([[0, 0], [1e11, 1e12], [-1e12, 1e12], [0, -1e12]]))]))
    hand.drag([1e11, 1e12], [4e12, 3e12])
    assert points(canvas)[1].tolist() == [1e12, 1e12]


def test_fitting_leaves_a_margin_and_survives_resizing(canvas, qtbot):
    def margins():
        pixels = canvas.plane.to_pixels(np.vstack([POINTS, OTHER]))
        low, high = pixels.min(axis=0), pixels.max(axis=0)
        return np.array([*low, *(np.array([canvas.plane.width, canvas.plane.height]) - high)])

    assert margins().min() == pytest.approx(min(800, 600) / 12, rel=0.4)
    canvas.resize(500, 700)
    assert margins().min() > 30


def colour_near(canvas, point, wanted):
    """Whether a colour is painted within a pixel of a point."""
    image = canvas.grab().toImage()
    ratio = image.devicePixelRatio()
    x, y = (canvas.plane.to_pixels(point) * ratio).astype(int)
    near = {image.pixelColor(int(x + i), int(y + j)).name() for i in (-1, 0, 1) for j in (-1, 0, 1)}
    return QColor(wanted).name() in near


@pytest.mark.parametrize("mode", [Mode.TRIGONOMETRIC, Mode.HYPERBOLIC, Mode.INTERPOLATING])
def test_a_segment_is_painted_in_the_colour_of_its_mode(canvas, mode):
    canvas.document.apply_curve("Mode", 0, canvas.document.drawing[0].curve.with_mode([0, 1, 2], mode))
    place = canvas.document.drawing[0].curve(0.45)
    assert colour_near(canvas, place, LIGHT.of_mode(mode))
    canvas.set_shown(modes=False)
    assert not colour_near(canvas, place, LIGHT.of_mode(mode))
    assert colour_near(canvas, place, "#334155")


def test_other_curves_keep_their_own_colour(canvas):
    assert colour_near(canvas, canvas.document.drawing[1].curve(0.5), "#AA00AA")


def test_a_space_curve_is_moved_from_above_and_keeps_its_height(canvas, hand):
    space = [[0.0, 0.0, 5.0], [1.0, 3.0, 6.0], [3.0, 3.0, 7.0], [5.0, -1.0, 8.0]]
    canvas.document.start(Drawing([Item(Curve(space))]))
    canvas.fit()
    hand.drag(space[2][:2], [3.5, 4.0])
    assert points(canvas)[2] == pytest.approx([3.5, 4.0, 7.0])


def test_empty_and_extreme_drawings_are_painted(canvas):
    far = [[0, 0], [1e12, 1e12], [-1e12, 1e12], [0, -1e12]]
    one_place = [[3.0, 3.0]] * 5
    for drawing in (
        Drawing(),
        Drawing([Item(Curve(far, 1e6))]),
        Drawing([Item(Curve(one_place))]),
        Drawing([Item(Curve(POINTS), visible=False)]),
    ):
        canvas.document.start(drawing)
        canvas.fit()
        assert not canvas.grab().isNull()


def test_two_fingers_pan_and_zoom_with_ctrl_or_when_they_are_spread(canvas, hand):
    place = np.array(POINTS[2], dtype=float)
    scale, before = canvas.plane.scale, hand.pixel(place)
    hand.wheel(place, pixels=(30, -20))
    assert hand.pixel(place) == pytest.approx(before + [30, -20])
    assert canvas.plane.scale == pytest.approx(scale)
    before = hand.pixel(place)
    hand.wheel(place, pixels=(0, 15), keys=CTRL)
    hand.pinch(place, 0.5)
    assert hand.pixel(place) == pytest.approx(before)
    assert canvas.plane.scale == pytest.approx(scale * 1.25 * 1.5)


@pytest.mark.parametrize("place", [POINTS[2], "curve"])
def test_a_press_on_a_locked_curve_says_why_nothing_moves(canvas, hand, place, qtbot):
    drawing = canvas.document.drawing
    canvas.document.apply("Lock", drawing.with_item(0, drawing[0].with_(locked=True)))
    with qtbot.waitSignal(canvas.announce) as told:
        hand.press(drawing[0].curve(1.5) if place == "curve" else place)
    assert told.args == ["“one” is locked: unlock it in the list of curves to change it."]
