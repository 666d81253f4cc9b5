"""The docks below the canvas and the canvas point at the same place."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QColor, QMouseEvent
from PySide6.QtWidgets import QApplication, QDockWidget

from theditor.model import LIGHT


def curve(window):
    return window.document.drawing[0].curve


def bring_up(window, name):
    window.findChild(QDockWidget, name).raise_()
    QApplication.processEvents()


def point_at(widget, x, y):
    at = QPointF(x, y)
    buttons = Qt.MouseButton.NoButton
    keys = Qt.KeyboardModifier.NoModifier
    event = QMouseEvent(QEvent.Type.MouseMove, at, QPointF(widget.mapToGlobal(at)), buttons, buttons, keys)
    QApplication.sendEvent(widget, event)


def colour_at(window, u):
    pixel = window.canvas.plane.to_pixels(curve(window)(u))
    return window.canvas.grab().toImage().pixelColor(*np.floor(pixel).astype(int).tolist()).name()


@pytest.mark.parametrize("dock", ["basis", "curvature"])
def test_the_place_under_the_pointer_is_shown_in_the_plot(window, hand, dock):
    bring_up(window, dock)
    u = 5.37
    hand.move(curve(window)(u))
    if dock == "basis":
        assert window.basis.accessibleDescription().startswith("Segment 6")
        assert f"t = {u % 1:.2f}" in window.basis.accessibleDescription()
    else:
        assert window.curvature.plot.place == pytest.approx(u, abs=0.01)
    QApplication.sendEvent(window.canvas.viewport(), QEvent(QEvent.Type.Leave))
    hand.move((-3.5, 2.0))
    if dock == "curvature":
        assert window.curvature.plot.place is None


def test_the_joint_under_the_pointer_is_shown_too(window, hand):
    bring_up(window, "curvature")
    hand.move(curve(window).joints[6])
    assert window.curvature.plot.place == 6


def test_the_place_in_the_plot_is_shown_on_the_canvas(window):
    bring_up(window, "curvature")
    plot, places = window.curvature.plot, []
    plot.hovered.connect(places.append)
    point_at(plot, plot.width() * 0.6, plot.height() / 2)
    (u,) = places
    assert colour_at(window, u) == QColor(LIGHT.comb).name()
    QApplication.sendEvent(plot, QEvent(QEvent.Type.Leave))
    assert colour_at(window, u) != QColor(LIGHT.comb).name()


def test_the_place_in_the_basis_plot_is_shown_on_the_canvas(window):
    bring_up(window, "basis")
    window.selection.select(segments=[7])
    point_at(window.basis, 200, 60)
    assert colour_at(window, 7 + window.basis.t) == QColor(LIGHT.comb).name()


def test_a_joint_of_the_table_is_shown_on_the_canvas(window):
    bring_up(window, "continuity")
    table = window.continuity.table
    at = table.visualRect(window.continuity.model.index(0, 1)).center()
    point_at(table.viewport(), at.x(), at.y())
    assert colour_at(window, 1.0) == QColor(LIGHT.comb).name()


def test_a_comb_slider_shows_the_comb(window, qtbot):
    bring_up(window, "curvature")
    assert not window.canvas.shown.comb
    qtbot.keyClick(window.curvature.density, Qt.Key.Key_End)
    qtbot.keyClick(window.curvature.length, Qt.Key.Key_Right)
    shown = window.canvas.shown
    assert (shown.comb, shown.comb_density) == (True, 64)
    assert shown.comb_length > 1
    assert window.actions_by_name["show_comb"].isChecked()
