"""Shaping in the real window: what the mouse does to panels, and what panels show on the canvas."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QEnterEvent, QHelpEvent
from PySide6.QtWidgets import QApplication, QToolTip

from theditor.spline import CONVEX_HULL_RANGE, INTERPOLATING


def curve(window):
    return window.document.drawing[0].curve


def enter(widget):
    middle = QPointF(widget.rect().center())
    QApplication.sendEvent(widget, QEnterEvent(middle, middle, QPointF(widget.mapToGlobal(middle))))


def leave(widget):
    QApplication.sendEvent(widget, QEvent(QEvent.Type.Leave))


def picture(window):
    return window.canvas.grab().toImage()


def test_hovering_the_slider_or_a_bar_shades_the_reach_on_the_canvas(window, hand, qtbot):
    hand.move((20.0, 20.0))
    window.selection.select(points={9})
    plain = picture(window)
    enter(window.shape.slider)
    shaded = picture(window)
    place = window.canvas.plane.to_pixels(curve(window).with_lambdas([9], [-12.0])(8.2)).astype(int).tolist()
    assert shaded.pixel(*place) != plain.pixel(*place)
    leave(window.shape.slider)
    assert picture(window) == plain
    strip = window.lambda_strip
    column = strip.column_left(9) + 30
    qtbot.mouseMove(strip.viewport(), QPoint(column, strip.viewport().height() // 2))
    assert picture(window).pixel(*place) != plain.pixel(*place)
    leave(strip)
    assert picture(window) == plain


def test_the_menu_keeps_pulls_within_the_convex_hull(window, hand):
    window.actions_by_name["keep_hull"].trigger()
    start = curve(window)(8.5)
    hand.drag(start, start + [2.0, 1.0])
    low, high = CONVEX_HULL_RANGE[3]
    assert ((curve(window).lambdas[9:11] >= low) & (curve(window).lambdas[9:11] <= high)).all()
    assert set(curve(window).lambdas[9:11]) & {low, high}


def test_a_pull_shows_in_every_panel_and_escape_takes_it_back(window, hand, qtbot):
    before = window.document.drawing
    start = curve(window)(4.4)
    hand.press(start)
    hand.move(start + [0.0, 0.1])
    assert window.selection.segments == {4}
    assert window.segments.model.index(4, 0).data() == "blend"
    assert window.shape.field.value() != 1.0 or curve(window).lambdas[5] != curve(window).lambdas[6]
    qtbot.keyClick(window.canvas, Qt.Key.Key_Escape)
    hand.release(start)
    assert window.document.drawing == before
    assert window.segments.model.index(4, 0).data() == "catenary"


def test_warnings_give_their_reason_on_the_canvas_at_middles_and_joints_too(window, hand, monkeypatch):
    told = []
    monkeypatch.setattr(QToolTip, "showText", lambda at, text, widget: told.append(text))

    def tip_at(point):
        hand.move(point)
        at = QPoint(*hand.pixel(point).astype(int).tolist())
        event = QHelpEvent(QEvent.Type.ToolTip, at, window.canvas.viewport().mapToGlobal(at))
        QApplication.sendEvent(window.canvas.viewport(), event)
        return told[-1]

    assert "negative" in tip_at(curve(window)(2.5))
    window.document.apply_curve("Shape", 0, curve(window).with_lambdas([8], [-5.0]))
    assert "reversed" in tip_at(curve(window).joints[7])
    assert tip_at(curve(window)(4.5)) == ""
    window.open_picture("figure-03")
    window.selection.select(curve=1)
    window.canvas.setFocus()
    quadratic = window.document.drawing[1].curve
    middle = int(np.flatnonzero(quadratic.mode_codes == 2)[0]) + 0.5
    hand.canvas.show_view(*quadratic(middle), 300.0)
    window.selection.select(points=(), segments=())
    moved = quadratic.with_lambdas([5, 6], [4.5, 4.5])
    window.document.apply_curve("Shape", 1, moved)
    assert "basis function" in tip_at(moved(middle))


def test_ghosts_and_the_ordinary_b_spline_are_menu_commands(window, hand):
    hand.move((20.0, 20.0))
    plain = picture(window)
    window.actions_by_name["show_uniform"].trigger()
    assert picture(window) != plain
    window.actions_by_name["show_uniform"].trigger()
    assert picture(window) == plain
    hand.press(curve(window).control_points[6])
    hand.move(curve(window).control_points[6] + [0.5, 0.5])
    with_ghost = picture(window)
    window.actions_by_name["show_ghost"].trigger()
    assert picture(window) != with_ghost
    hand.release(curve(window).control_points[6])


def test_a_slid_joint_snaps_to_a_mode_in_the_window(window, hand):
    point, window_scale = 9, window.canvas.plane.scale
    joint = curve(window).joints[point - 1]
    goal = curve(window).control_points[point] + 2.0 / window_scale
    hand.drag(joint, goal)
    assert curve(window).lambdas[point] == INTERPOLATING[3]
    assert curve(window)(8.0) == pytest.approx(curve(window).control_points[point], abs=1e-12)
