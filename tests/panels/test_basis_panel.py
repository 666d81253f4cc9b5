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
from theditor.panels.basis import HINT, BasisPanel
from theditor.panels.basis_plot import SegmentBasis, plots
from theditor.spline import Curve, Mode, negative_basis

KEY = Qt.Key


@pytest.fixture
def panel(document, selection, show):
    return show(BasisPanel(document, selection), 900, 180)


@pytest.fixture
def hand(panel):
    return Hand(panel)


def said(panel):
    """Segment, t and weights as the panel tells them."""
    words = panel.accessibleDescription()
    segment = int(re.match(r"Segment (\d+)", words)[1])
    t = float(re.search(r"t = ([\d.]+)", words)[1])
    return segment, t, [float(w.replace("−", "-")) for w in re.findall(r"[cq]\S = ([−\d.e]+)", words)]


def pixel(panel, t):
    functions, _, _ = plots(panel.shown, panel.width(), panel.height())
    return float(functions.pixel_x(t)), functions.area.center().y()


def test_the_weights_under_the_pointer_make_the_point_of_the_curve(panel, hand, selection, qtbot):
    selection.select(segments=[4])
    with qtbot.waitSignal(panel.hovered) as pointed:
        hand.move(*pixel(panel, 0.25), held=Qt.MouseButton.NoButton)
    (u,) = pointed.args
    segment, t, weights = said(panel)
    assert (segment, t) == (5, pytest.approx(0.25, abs=1e-3))
    assert u == pytest.approx(4.25, abs=1e-3)
    assert sum(weights) == pytest.approx(1)
    curve = selection.item.curve
    assert np.array(weights) @ curve.control_points[4:8] == pytest.approx(curve(u), abs=1e-4)
    with qtbot.waitSignal(panel.hovered) as pointed:
        QApplication.sendEvent(panel, QEvent(QEvent.Type.Leave))
    assert pointed.args == [None]


def test_it_shows_the_selected_segment_else_the_one_under_the_pointer_else_says_what_to_do(panel, selection):
    assert panel.accessibleDescription() == HINT
    panel.show_place(6.75)
    assert said(panel)[:2] == (7, 0.75)
    selection.select(segments=[2])
    assert said(panel)[0] == 3
    panel.show_place(6.5)
    assert said(panel)[:2] == (3, 0.75), "another segment's t is not this one's"
    panel.show_place(2.125)
    assert said(panel)[:2] == (3, 0.125)
    selection.select(segments=[2, 6])
    panel.show_place(6.5)
    assert said(panel)[:2] == (7, 0.5)
    panel.show_place(None)
    selection.select(segments=())
    assert panel.accessibleDescription() == HINT
    panel.show_place(6.5)
    selection.select(curve=1)
    assert panel.accessibleDescription() == HINT, "the pointer is over another curve"


def test_it_follows_while_lambda_changes(panel, document, selection):
    selection.select(segments=[4])
    panel.show_place(5.0)
    _, _, (first, *_) = said(panel)
    gesture = document.begin("Change λ")
    for lam in (0.0, -3.0):
        gesture.preview(document.drawing.with_curve(0, document.drawing[0].curve.with_lambdas(6, lam)))
    _, _, weights = said(panel)
    gesture.cancel()
    assert first == 0
    assert weights[-1] > 0.2
    assert said(panel)[2][-1] < 0.2


def test_the_arrow_keys_move_t(panel, selection, qtbot):
    selection.select(segments=[0])
    panel.setFocus()
    places = []
    panel.hovered.connect(places.append)
    for key, modifier in (
        (KEY.Key_Home, Qt.KeyboardModifier.NoModifier),
        (KEY.Key_Left, Qt.KeyboardModifier.NoModifier),
        (KEY.Key_Right, Qt.KeyboardModifier.NoModifier),
        (KEY.Key_Right, Qt.KeyboardModifier.ShiftModifier),
        (KEY.Key_End, Qt.KeyboardModifier.NoModifier),
    ):
        qtbot.keyClick(panel, key, modifier)
    assert places == pytest.approx([0, 0, 0.01, 0.11, 1])


@pytest.mark.parametrize("colours", [LIGHT, DARK])
def test_the_functions_have_the_colour_of_the_mode_in_light_and_dark(panel, selection, colours):
    panel.setPalette(palette(colours))
    selection.select(segments=[2])
    assert panel.shown.mode is Mode.INTERPOLATING
    image = panel.grab().toImage()
    functions, bars, _ = plots(panel.shown, panel.width(), panel.height())
    second = image.pixelColor(int(bars.pixel_x(1.5)), int(bars.pixel_y(0.1)))
    assert second == QColor(colours.interpolating)
    found = {image.pixel(int(functions.pixel_x(0.9)), y) for y in range(panel.height())}
    assert QColor(colours.interpolating).rgb() in found
    assert QColor(colours.panel).rgb() in found


def test_every_curve_can_be_shown_at_its_ends(panel, document, selection):
    straight = Curve([[0, 0], [1, 1]], 7.0, ends="clamped")
    kinds = [{"ends": "free"}, {"ends": "clamped"}, {"closed": True}]
    curves = [some_curve(degree=degree, **kind) for degree in (2, 3) for kind in kinds]
    for curve in [*curves, straight]:
        document.start(Drawing([Item(curve)]))
        for segment in {0, curve.segment_count - 1}:
            selection.select(segments=[segment])
            assert sum(said(panel)[2]) == pytest.approx(1, abs=1e-5)
            assert not panel.grab().isNull()


@given(st.floats(-30, 30), st.floats(-30, 30), st.sampled_from([2, 3]))
def test_the_title_names_the_functions_that_the_library_finds_negative(start, end, degree):
    curve = Curve(np.eye(6, 2), [0, 0, start, end, 0, 0], degree)
    segment = 2 - curve.first_segment
    guards = negative_basis(curve)
    names = [f"{'cq'[degree == 2]}{'₀₁₂₃'[k]}" for k in guards.functions[guards.segments == segment]]
    title = SegmentBasis(curve, segment).title()
    assert re.findall("[cq][₀₁₂₃]", title) == names
    assert ("negative" in title) == bool(names)
