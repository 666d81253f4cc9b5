"""Shaping by taking hold of the curve: pulling it, sliding its joints, and what is shown meanwhile."""

import numpy as np
import pytest
from hand import CTRL, SHIFT
from PySide6.QtCore import Qt

from theditor.canvas.overlays import marks
from theditor.canvas.viewport import Viewport
from theditor.drawing import Drawing, Item
from theditor.model import LIGHT
from theditor.spline import (
    CONVEX_HULL_RANGE,
    INTERPOLATING,
    PULL_BOUNDS,
    Curve,
    joint_track,
    middle_track,
    pull,
    uniform_b_spline_samples,
)

POINTS = [[0.0, 0.0], [1.0, 3.0], [3.0, 3.0], [5.0, -1.0], [7.0, 0.0], [8.0, 2.0]]


def curve(canvas):
    return canvas.document.drawing[0].curve


def reachable(canvas, u):
    """A place that two λ within the bounds can bring the curve to at u."""
    return pull(curve(canvas), u, curve(canvas)(u), PULL_BOUNDS).curve.with_lambdas([2, 3], [3.0, -4.0])(u)


def test_a_pulled_curve_follows_the_pointer_and_its_points_stay(canvas, hand):
    start, goal = curve(canvas)(1.4), reachable(canvas, 1.4)
    hand.drag(start, goal)
    assert curve(canvas).control_points.tolist() == POINTS
    assert curve(canvas)(1.4) == pytest.approx(goal, abs=1.5 / canvas.plane.scale)
    assert (np.abs(curve(canvas).lambdas[[2, 3]]) > 1).all()
    assert np.delete(curve(canvas).lambdas, [2, 3]).tolist() == [0.0] * 4
    hit = canvas.hit(hand.pixel(goal))
    assert (hit.segment, hit.t) == (1, pytest.approx(0.4, abs=0.02))
    assert canvas.document.undo_stack.undoText() == "Pull the curve"
    canvas.document.undo()
    assert curve(canvas).lambdas.tolist() == [0.0] * 6


def test_a_pull_beyond_reach_stops_at_the_bound_and_shows_the_miss(canvas, hand, qtbot):
    start = curve(canvas)(1.4)
    hand.press(start)
    with qtbot.waitSignal(canvas.pointed) as told:
        hand.move(start + [0.0, -2.5])
    held = curve(canvas).lambdas[[2, 3]]
    assert set(held.tolist()) & set(PULL_BOUNDS)
    assert "as far as the pull goes" in told.args[0].hint
    reached, target = canvas.plane.to_pixels(canvas._drag.miss)
    assert np.hypot(*(target - reached)) > 20
    x, y = ((reached + target) / 2).astype(int).tolist()
    image = canvas.grab().toImage()
    near = [image.pixelColor(x + i, y) for i in range(-2, 3)]
    assert any(pixel.red() > pixel.blue() + 60 for pixel in near)
    qtbot.keyClick(canvas, Qt.Key.Key_Escape)
    assert curve(canvas).lambdas.tolist() == [0.0] * 6
    assert canvas.document.undo_stack.count() == 0


def test_keeping_the_convex_hull_bounds_the_pull(canvas, hand):
    canvas.keep_hull(True)
    start = curve(canvas)(1.4)
    hand.drag(start, start + [0.3, -2.5])
    low, high = CONVEX_HULL_RANGE[3]
    assert ((curve(canvas).lambdas >= low) & (curve(canvas).lambdas <= high)).all()
    assert (curve(canvas).lambdas != 0).any()


def test_ctrl_pulls_with_the_nearer_lambda_and_shift_moves_the_points(canvas, hand):
    start, goal = curve(canvas)(1.3), reachable(canvas, 1.3)
    hand.drag(start, goal, keys=CTRL)
    assert np.flatnonzero(curve(canvas).lambdas).tolist() == [2]
    canvas.document.undo()
    canvas.selection.select(points=(), segments=())
    hand.drag(start, start + [0.4, 0.5], keys=SHIFT)
    assert curve(canvas)(1.3) == pytest.approx(start + [0.4, 0.5])
    assert curve(canvas).lambdas.tolist() == [0.0] * 6
    assert canvas.selection.segments == frozenset()


def test_a_joint_slides_along_its_track_and_is_drawn_to_the_modes(canvas, hand):
    track = joint_track(curve(canvas), 2)
    start, there = track.position(0.0), track.position(6.0)
    hand.drag(start, there + [0.02, 0.02])
    assert curve(canvas).lambdas[2] == pytest.approx(6.0, abs=0.5)
    assert canvas.selection.points == {2}
    assert canvas.document.undo_stack.undoText() == "Slide the joint"
    near = track.position(INTERPOLATING[3]) + 2.0 / canvas.plane.scale
    hand.drag(track.position(curve(canvas).lambdas[2]), near)
    assert curve(canvas).lambdas[2] == INTERPOLATING[3]
    canvas.document.undo()
    hand.drag(track.position(curve(canvas).lambdas[2]), near, keys=SHIFT)
    assert curve(canvas).lambdas[2] != INTERPOLATING[3]


def test_the_middle_of_a_quadratic_segment_slides(canvas, hand):
    canvas.document.start(Drawing([Item(Curve(POINTS, degree=2))]))
    canvas.fit()
    middle = curve(canvas)(1.5)
    towards = np.array(POINTS[2]) - middle
    hand.drag(middle, middle + 0.6 * towards)
    assert curve(canvas).lambdas[2] == curve(canvas).lambdas[3] > 1
    assert np.delete(curve(canvas).lambdas, [2, 3]).tolist() == [0.0] * 4


def test_a_space_curve_is_pulled_from_above(canvas, hand):
    space = np.column_stack([POINTS, np.arange(6.0)])
    canvas.document.start(Drawing([Item(Curve(space))]))
    canvas.fit()
    start = curve(canvas)(1.4)[:2]
    hand.drag(start, start + [0.02, 0.1])
    assert np.flatnonzero(curve(canvas).lambdas).tolist() == [2, 3]
    assert np.array_equal(curve(canvas).control_points, space)


def near_colour(canvas, point, wanted):
    image = canvas.grab().toImage()
    x, y = (canvas.plane.to_pixels(point) * image.devicePixelRatio()).astype(int)
    near = {image.pixelColor(int(x + i), int(y + j)).name().upper() for i in (-1, 0, 1) for j in (-1, 0, 1)}
    return wanted.upper() in near


def test_the_curve_as_it_was_stays_visible_while_dragged(canvas, hand):
    canvas.set_shown(grid=False, polygon=False, labels=False, joints=False)
    before = curve(canvas)
    place = before(1.5)
    hand.press(POINTS[2])
    hand.move([4.5, 5.5])
    assert not near_colour(canvas, place, LIGHT.trigonometric)
    with_ghost = canvas.grab().toImage()
    canvas.set_shown(ghost=False)
    without = canvas.grab().toImage()
    x, y = canvas.plane.to_pixels(place).astype(int).tolist()
    assert any(
        with_ghost.pixel(x + i, y + j) != without.pixel(x + i, y + j) for i in (-1, 0, 1) for j in (-1, 0, 1)
    )
    canvas.set_shown(ghost=True)
    hand.release([4.5, 5.5])
    assert canvas.grab().toImage() != with_ghost


def test_the_reach_of_a_lambda_is_shaded(canvas):
    canvas.set_shown(grid=False, polygon=False, labels=False)
    plain = canvas.grab().toImage()
    canvas.show_reach([2])
    shaded = canvas.grab().toImage()
    place = curve(canvas).with_lambdas([2], [-12.0])(1.2)
    x, y = canvas.plane.to_pixels(place).astype(int).tolist()
    assert shaded.pixel(x, y) != plain.pixel(x, y)
    canvas.show_reach([])
    assert canvas.grab().toImage() == plain


def start_quadratic(canvas, lambdas=0.0):
    canvas.document.start(Drawing([Item(Curve(POINTS, lambdas, degree=2))]))
    canvas.fit()


def test_a_slide_begins_where_the_middle_is_and_keeps_differences(canvas, hand):
    start_quadratic(canvas, [0, 0, -10.0, 9.0, 0, 0])
    middle = curve(canvas)(1.5)
    along = middle_track(curve(canvas), 1).direction
    step = 4.0 / canvas.plane.scale * along / np.hypot(*along)
    hand.drag(middle, middle + step)
    assert np.hypot(*(curve(canvas)(1.5) - middle)) == pytest.approx(4.0 / canvas.plane.scale, rel=0.3)
    assert curve(canvas).lambdas[3] - curve(canvas).lambdas[2] == pytest.approx(19.0)


def test_slides_and_pulls_say_when_they_end(canvas, hand, qtbot):
    track = joint_track(curve(canvas), 2)
    hand.press(track.position(0.0))
    with qtbot.waitSignal(canvas.pointed) as told:
        hand.move(track.position(40.0))
    assert curve(canvas).lambdas[2] == PULL_BOUNDS[1]
    assert "as far as the slide goes" in told.args[0].hint
    hand.release(track.position(40.0))
    start_quadratic(canvas)
    canvas.show_view(*curve(canvas)(1.0), 400.0)
    joint = curve(canvas)(1.0)
    hand.press(joint)
    with qtbot.waitSignal(canvas.pointed) as told:
        hand.move(joint + [0.1, 0.1])
    assert "drag beside it" in told.args[0].hint


def test_keeping_the_convex_hull_holds_for_every_curve_and_for_slides(canvas, hand):
    canvas.keep_hull(True)
    low, high = CONVEX_HULL_RANGE[3]
    other = canvas.document.drawing[1].curve
    hand.drag(other(0.5), other(0.5) + [0.2, -3.0])
    lambdas = canvas.document.drawing[1].curve.lambdas
    assert ((lambdas >= low) & (lambdas <= high)).all()
    assert (lambdas != 1.0).any()
    canvas.selection.select(curve=0)
    track = joint_track(curve(canvas), 2)
    hand.drag(track.position(0.0), track.position(40.0))
    assert curve(canvas).lambdas[2] == high


def test_clamped_and_closed_curves_are_pulled_and_locked_ones_are_not(canvas, hand):
    for kind in ({"ends": "clamped"}, {"closed": True}):
        canvas.document.start(Drawing([Item(Curve(POINTS, **kind))]))
        canvas.fit()
        u = 0.4
        start, goal = curve(canvas)(u), curve(canvas).with_lambdas([0, 1], [2.0, 3.0])(u)
        hand.drag(start, goal)
        assert curve(canvas)(u) == pytest.approx(goal, abs=4 / canvas.plane.scale)
        assert curve(canvas).control_points.tolist() == POINTS
    locked = canvas.document.drawing[0].with_(locked=True)
    canvas.document.start(Drawing([locked]))
    hand.drag(start, goal)
    assert canvas.document.drawing[0] == locked


def changed_at(before, after, place):
    x, y = place
    return any(
        before.pixel(x + i, y + j) != after.pixel(x + i, y + j) for i in range(-3, 4) for j in range(-3, 4)
    )


def test_tracks_show_where_the_modes_put_a_joint(canvas, hand):
    off = dict.fromkeys(("grid", "labels", "polygon", "joints", "legend"), False)
    canvas.set_shown(**off)
    hand.move([20.0, 20.0])
    plain = canvas.grab().toImage()
    track = joint_track(curve(canvas), 2)
    ends = canvas.plane.to_pixels(track.position(np.array([-12.0, 5.0]))).astype(int).tolist()
    hand.move(track.position(0.0))
    hovered = canvas.grab().toImage()
    assert all(changed_at(plain, hovered, end) for end in ends)
    hand.move([20.0, 20.0])
    canvas.selection.select(points={2})
    selected = canvas.grab().toImage()
    assert all(changed_at(plain, selected, end) for end in ends)


def test_marks_nearer_than_a_hand_can_tell_become_one(canvas):
    track = joint_track(curve(canvas), 2)
    small, large = (Viewport(*track.origin, scale, 800.0, 600.0) for scale in (10.0, 5000.0))
    assert next(letters for _, letters in marks(3, track, small)).startswith("T H")
    assert [letters for _, letters in marks(3, track, large)] == ["T", "H", "λ*"]


def test_the_ordinary_b_spline_is_drawn_on_the_same_polygon(canvas):
    canvas.set_shown(grid=False, polygon=False)
    canvas.document.apply_curve("Shape", 0, curve(canvas).with_lambdas([2, 3], [-12.0, -12.0]))
    plain = canvas.grab().toImage()
    canvas.set_shown(uniform=True)
    with_it = canvas.grab().toImage()
    samples = canvas.plane.to_pixels(uniform_b_spline_samples(curve(canvas), 16)).astype(int).tolist()
    assert sum(changed_at(plain, with_it, place) for place in samples) > len(samples) / 2


def test_hovering_a_joint_or_a_middle_shades_its_reach(canvas, hand):
    canvas.set_shown(grid=False, polygon=False, labels=False)
    hand.move([20.0, 20.0])
    plain = canvas.grab().toImage()
    hand.move(joint_track(curve(canvas), 2).position(0.0))
    place = canvas.plane.to_pixels(curve(canvas).with_lambdas([2], [-12.0])(1.2)).astype(int).tolist()
    assert changed_at(plain, canvas.grab().toImage(), place)
    start_quadratic(canvas)
    hand.move([20.0, 20.0])
    plain = canvas.grab().toImage()
    hand.move(curve(canvas)(1.5))
    place = canvas.plane.to_pixels(curve(canvas).with_lambdas([2], [-12.0])(1.2)).astype(int).tolist()
    assert changed_at(plain, canvas.grab().toImage(), place)


def test_the_band_of_reach_has_the_interpolating_curve_in_it(canvas):
    canvas.set_shown(grid=False, polygon=False, labels=False, modes=False, joints=False)
    canvas.show_reach([2])
    there = curve(canvas).with_lambdas([2], [INTERPOLATING[3]])
    image = canvas.grab().toImage()
    greenish = 0
    for x, y in canvas.plane.to_pixels(there(np.linspace(0.5, 1.5, 30))).astype(int).tolist():
        near = [image.pixelColor(x + i, y + j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
        greenish += any(pixel.green() > max(pixel.red(), pixel.blue()) + 20 for pixel in near)
    assert greenish > 15
