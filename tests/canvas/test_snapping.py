"""Snapping while points are dragged or placed: to what, how near, and what is said."""

import numpy as np
import pytest
from hand import CTRL, SHIFT
from hypothesis import given
from hypothesis import strategies as st

from theditor.canvas.curves import CurvesPainter
from theditor.canvas.grid import steps
from theditor.canvas.hit_test import REACH
from theditor.canvas.snapping import Snapper
from theditor.canvas.viewport import Viewport
from theditor.drawing import Drawing, Item
from theditor.spline import Curve, nearest

POINTS = [[0.0, 0.0], [1.0, 3.0], [3.0, 3.0], [5.0, -1.0], [7.0, 0.0], [8.0, 2.0]]
OTHER = [[0.0, 5.0], [3.0, 6.0], [6.0, 5.0], [8.0, 6.0]]


def points(canvas, curve=0):
    return canvas.document.drawing[curve].curve.control_points


def off(canvas, dx, dy):
    return np.array([dx, dy]) / canvas.plane.scale


@pytest.fixture
def snapping(canvas):
    canvas.snapper.on = True
    return canvas


def carry(canvas, hand, goal, keys=None):
    """Drag P₂ towards a goal; returns what the label said."""
    hand.press(POINTS[2])
    hand.move((np.array(POINTS[2]) + goal) / 2)
    arguments = () if keys is None else (keys,)
    hand.move(goal, *arguments)
    snapped = canvas._frame().snapped
    assert not canvas.grab().isNull()
    hand.release(goal, *arguments)
    return snapped and snapped.to


def test_it_is_off_at_the_start(canvas, hand):
    goal = np.array(OTHER[1]) + off(canvas, 3, 2)
    assert carry(canvas, hand, goal) is None
    assert points(canvas)[2] == pytest.approx(goal)


def test_a_point_goes_onto_a_control_point_exactly(snapping, hand):
    assert carry(snapping, hand, np.array(OTHER[1]) + off(snapping, 4, -3)) == "P₁"
    assert points(snapping)[2].tolist() == OTHER[1]


def test_a_point_goes_onto_a_joint(snapping, hand):
    joint = snapping.document.drawing[1].curve.joints[0]
    assert carry(snapping, hand, joint + off(snapping, 3, 3)) == "joint"
    assert points(snapping)[2] == pytest.approx(joint, abs=1e-12)


def test_a_point_goes_onto_a_curve_that_does_not_move(snapping, hand):
    other = snapping.document.drawing[1].curve
    assert carry(snapping, hand, other(0.5) + off(snapping, 1, 5)) == "curve"
    assert nearest(other, points(snapping)[2])[1] < 1e-9


def test_else_it_goes_to_the_grid_and_never_to_what_moves_along(snapping, hand):
    minor = steps(snapping.plane.scale)[1]
    goal = np.round(np.array([3.4, 4.1]) / minor) * minor
    assert carry(snapping, hand, goal + off(snapping, 5, -4)) == "grid"
    assert points(snapping)[2] == pytest.approx(goal, abs=1e-12)
    snapping.selection.select(points={2})
    own = snapping.document.drawing[0].curve(0.9)
    hand.drag(points(snapping)[2], own + off(snapping, 3, 3))
    assert np.hypot(*(points(snapping)[2] - own)) * snapping.plane.scale < 20


@pytest.mark.parametrize("keys", [SHIFT, CTRL])
def test_shift_suspends_it_and_ctrl_keeps_to_its_line(snapping, hand, keys):
    goal = np.array(OTHER[1]) + off(snapping, 3, 2)
    assert carry(snapping, hand, goal, keys) is None
    assert points(snapping)[2].tolist() != OTHER[1]


def test_the_pen_places_where_it_is_drawn_to(snapping, hand):
    snapping.use("pen")
    near = np.array(OTHER[2]) + off(snapping, 3, -3)
    hand.move(near)
    assert snapping._frame().snapped.to == "P₂"
    hand.click(near)
    hand.click(np.array(POINTS[0]) + off(snapping, 3, -3))
    snapping.use("select")
    assert points(snapping, 2).tolist() == [OTHER[2], POINTS[0]]


@given(st.tuples(st.floats(-1, 9), st.floats(-2, 7)), st.floats(20, 300))
def test_what_it_goes_to_is_there_and_within_reach(point, scale):
    curves = [Curve(POINTS), Curve(OTHER, ends="clamped")]
    drawing = Drawing([Item(curve) for curve in curves])
    snapper = Snapper(CurvesPainter())
    snapper.on = True
    plane = Viewport(4.0, 2.0, scale, 800.0, 600.0)
    snapped = snapper(np.array(point), drawing, plane)
    if snapped is None:
        gaps = [np.hypot(*(c.control_points - point).T).min() for c in curves]
        assert min(gaps) * scale > REACH
        return
    away = np.hypot(*(snapped.point - point)) * scale
    assert away <= (REACH * np.sqrt(2) if snapped.to == "grid" else REACH + 0.5)
    if snapped.to == "grid":
        lines = snapped.point / steps(scale)[1]
        assert np.isclose(lines, np.round(lines), atol=1e-9).any()
    elif snapped.to in ("joint", "curve"):
        assert min(nearest(c, snapped.point)[1] for c in curves) < 1e-9
    else:
        assert any((c.control_points == snapped.point).all(axis=1).any() for c in curves)
