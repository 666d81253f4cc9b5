import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from panel_hand import Hand, some_curve
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QApplication

from theditor.app.theme import palette
from theditor.drawing import Drawing, Item
from theditor.model import DARK, LIGHT
from theditor.panels.curvature import EMPTY, HINT, NO_LENGTH, CurvaturePanel
from theditor.panels.curvature_plot import NO_MARKS, plot_of
from theditor.panels.curvature_profile import profile
from theditor.spline import Curve, arc_lengths, curvature, inflections

KEY = Qt.Key
NONE = Qt.MouseButton.NoButton
ELLIPSE = Curve([[2, 1], [-2, 1], [-2, -1], [2, -1]], 0.0, degree=2, closed=True)  # semi-axes 2 and 1


@pytest.fixture
def panel(document, selection, show):
    return show(CurvaturePanel(document, selection), 900, 180)


@pytest.fixture
def hand(panel):
    return Hand(panel.plot)


def plot(panel):
    return plot_of(panel.plot.shown, panel.plot.width(), panel.plot.height())[0]


def point_at_length(panel, hand, length):
    where = plot(panel)
    hand.move(float(where.pixel_x(length)), where.area.center().y(), held=NONE)


def rgb(colour):
    return np.array(colour.getRgb()[:3])


def image(panel):
    return panel.plot.grab().toImage()


def test_hovering_the_plot_tells_the_place_and_what_the_curvature_is_there(panel, hand, document, qtbot):
    curve = document.drawing[0].curve
    whole = arc_lengths(curve)[-1]
    assert panel.text.text() == HINT
    with qtbot.waitSignal(panel.hovered) as pointed:
        point_at_length(panel, hand, 0.4 * whole)
    (u,) = pointed.args
    assert arc_lengths(curve, [u])[0] == pytest.approx(0.4 * whole, rel=1e-3)
    words = panel.text.text().replace("−", "-")
    kappa, radius = map(float, re.search(r"κ = ([-\d.e]+), radius ([\d.e]+)", words).groups())
    assert kappa == pytest.approx(float(curvature(curve, u)), rel=1e-5)
    assert radius == pytest.approx(1 / abs(kappa), rel=1e-5)
    assert re.search(r"length (\S+) of (\S+)", words).groups() == (f"{0.4 * whole:.4g}", f"{whole:.4g}")
    with qtbot.waitSignal(panel.hovered) as pointed:
        QApplication.sendEvent(panel.plot, QEvent(QEvent.Type.Leave))
    assert pointed.args == [None]
    assert panel.text.text() == HINT


def test_at_the_vertex_of_an_ellipse_the_radius_is_the_one_of_the_textbook(panel, document):
    document.start(Drawing([Item(ELLIPSE)]))
    told = set()
    for joint in (0.0, 1.0):
        panel.show_place(joint)
        told.add(panel.text.text().splitlines()[1])
    assert told == {"κ = 2, radius 0.5", "κ = 0.25, radius 4"}


def test_straight_pointlike_and_missing_curves_say_so(panel, document):
    document.start(Drawing([Item(Curve([[0, 0], [1, 1], [2, 2], [3, 3]], 0.7))]))
    panel.show_place(0.5)
    assert "straight" in panel.text.text()
    low, high = plot(panel).y
    assert low < 0 < high, "rounding is not blown up to fill the plot"
    document.start(Drawing([Item(Curve(np.ones((5, 2))))]))
    panel.show_place(0.5)
    assert panel.text.text() == NO_LENGTH
    panel.plot.grab()
    document.start(Drawing())
    assert panel.text.text() == EMPTY
    panel.plot.grab()


@pytest.mark.parametrize("colours", [LIGHT, DARK])
def test_the_line_is_drawn_where_the_curvature_is_in_light_and_dark(panel, document, colours):
    panel.setPalette(palette(colours))
    document.start(Drawing([Item(some_curve([0.0] * 13))]))
    seen, where = image(panel), plot(panel)
    curve, shown = document.drawing[0].curve, panel.plot.shown
    for u in np.linspace(0.3, curve.segment_count - 0.3, 9):
        value = float(curvature(curve, u))
        x, y = int(where.pixel_x(shown.length_at(u))), float(where.pixel_y(value))
        if abs(value) > 0.1 and where.y[0] < value < where.y[1]:
            column = [rgb(seen.pixelColor(x, row)) for row in range(round(y) - 2, round(y) + 3)]
            own = rgb(QColor(colours.comb if value > 0 else colours.comb_negative))
            assert np.abs(column - own).max(axis=1).min() < 30, "antialiasing aside, the line's own colour"


def test_a_jump_at_a_joint_is_one(panel, document, selection):
    selection.select(curve=1)  # a quadratic
    shown, curve = panel.plot.shown, document.drawing[1].curve
    at = np.arange(1, curve.segment_count)
    assert shown.curvature[:-1, -1] == pytest.approx(curvature(curve, at, "left"))
    assert shown.curvature[1:, 0] == pytest.approx(curvature(curve, at))
    assert np.abs(shown.curvature[1:, 0] - shown.curvature[:-1, -1]).max() > 0.1


def test_marks_rest_while_a_hand_is_on_the_drawing(panel, document):
    curve = document.drawing[0].curve
    turns = inflections(curve).u
    assert panel.plot.marks.turns == pytest.approx(turns)
    assert len(turns)
    gesture = document.begin("Move")
    gesture.preview(document.drawing.with_curve(0, curve.with_points(3, [0.3, 0.1])))
    assert panel.plot.marks is NO_MARKS
    gesture.commit()
    assert panel.plot.marks.turns == pytest.approx(inflections(document.drawing[0].curve).u)


def test_the_arrow_keys_go_along_the_curve_by_equal_lengths(panel, document, qtbot):
    places = []
    panel.hovered.connect(places.append)
    panel.plot.setFocus()
    for key in (KEY.Key_Home, KEY.Key_Right, KEY.Key_Right, KEY.Key_End):
        qtbot.keyClick(panel.plot, key)
    lengths = arc_lengths(document.drawing[0].curve, places)
    assert lengths / lengths[-1] == pytest.approx([0, 1 / 200, 2 / 200, 1], abs=1e-5)


def test_the_sliders_ask_for_another_comb(panel, qtbot):
    asked = []
    panel.comb_changed.connect(lambda *comb: asked.append(comb))
    qtbot.keyClick(panel.length, KEY.Key_End)
    qtbot.keyClick(panel.density, KEY.Key_Home)
    assert asked == [(pytest.approx(10), 16), (pytest.approx(10), 1)]


def test_another_curve_starts_without_a_marker(panel, selection):
    panel.show_place(3.0)
    selection.select(curve=1)
    assert panel.text.text() == HINT


def test_a_very_long_curve_shows_its_whole_range_of_curvature(panel, document):
    angles = np.linspace(0, 40 * np.pi, 20_000)
    document.start(Drawing([Item(Curve(np.c_[angles, np.sin(angles)]))]))
    seen, where = image(panel), plot(panel)
    for share in (0.1, 0.5, 0.9):
        x = int(where.area.left() + share * where.area.width())
        colours = {seen.pixel(xx, y) for xx in range(x - 30, x + 30) for y in range(seen.height())}
        assert {QColor(LIGHT.comb).rgb(), QColor(LIGHT.comb_negative).rgb()} <= colours


@given(
    st.lists(st.tuples(*[st.floats(-10, 10)] * 2), min_size=4, max_size=9, unique=True),
    st.floats(-4, 9),
    st.sampled_from([2, 3]),
    st.booleans(),
    st.floats(0, 1),
)
def test_the_table_agrees_with_the_library(points, lam, degree, closed, share):
    curve = Curve(np.round(points, 2), lam, degree, closed)
    table = profile(curve)
    assert table.joints == pytest.approx(arc_lengths(curve), rel=1e-3, abs=1e-9)
    if table.total > 1e-3:
        u = table.parameter_at(share * table.total)
        assert table.length_at(u) == pytest.approx(share * table.total, abs=1e-9 * table.total)
    low, high = table.range
    assert low <= 0 <= high
    assert low < high


def test_in_space_the_curvature_is_not_negative(panel, document):
    helix = Curve(np.c_[np.cos(np.arange(9)), -np.sin(np.arange(9)), np.arange(9) / 4])
    document.start(Drawing([Item(helix)]))
    assert panel.plot.shown.curvature.min() > 0
    u = 2.25
    panel.show_place(u)
    assert f"κ = {float(curvature(helix, u)):.6g}" in panel.text.text()
    assert plot(panel).y[0] == 0
    panel.plot.grab()
