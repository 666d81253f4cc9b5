"""What is laid over the drawing: comb, marks, circle, hull, warnings, tracks."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint
from PySide6.QtGui import QColor, QHelpEvent
from PySide6.QtWidgets import QApplication, QToolTip

from theditor.canvas.comb import marks_near, marks_of
from theditor.canvas.part import Part
from theditor.drawing import Drawing, Item
from theditor.model import LIGHT
from theditor.spline import INTERPOLATING, Curve
from theditor.spline.vertices import inflections

CIRCLE = [[2.0, 2.0], [-2.0, 2.0], [-2.0, -2.0], [2.0, -2.0]]
"""As a closed trigonometric quadratic: a circle of radius 2, counterclockwise."""


def show(canvas, curve, **shown):
    off = dict.fromkeys(("polygon", "labels", "joints", "grid", "legend", "guards"), False)
    canvas.document.start(Drawing([Item(curve)]))
    canvas.fit()
    canvas.set_shown(**(off | shown))
    return canvas.grab().toImage()


def hue_share(image, colour):
    """How many pixels have a colour's hue, faint ones too."""
    wanted = QColor(colour).hslHue()
    count = 0
    for y in range(0, image.height(), 2):
        for x in range(0, image.width(), 2):
            pixel = image.pixelColor(x, y)
            count += pixel.hslSaturation() > 60 and abs(pixel.hslHue() - wanted) < 6
    return count


def test_the_comb_stands_outside_and_is_as_long_as_the_curvature(canvas):
    circle = Curve(CIRCLE, degree=2, closed=True)
    plain, combed = show(canvas, circle), show(canvas, circle, comb=True)
    different = [
        np.hypot(*canvas.plane.to_points((x, y)))
        for y in range(0, plain.height(), 2)
        for x in range(0, plain.width(), 2)
        if plain.pixel(x, y) != combed.pixel(x, y)
    ]
    assert different
    assert min(different) > 1.9
    outer = max(different)
    canvas.set_shown(comb_length=2.0)
    longer = canvas.grab().toImage()
    x, y = canvas.plane.to_pixels([2 + 2 * (outer - 2) - 2 / canvas.plane.scale, 0]).astype(int).tolist()
    assert any(longer.pixel(x + i, y) != combed.pixel(x + i, y) for i in range(-2, 3))


def test_teeth_reach_into_view_from_segments_beside_it(canvas):
    circle = Curve(CIRCLE, degree=2, closed=True)
    show(canvas, circle, comb=True)
    canvas.set_shown(comb_length=16.0)
    plane = canvas.plane
    canvas.show_view(3.5 + plane.width / plane.scale / 2, 0, plane.scale)
    assert hue_share(canvas.grab().toImage(), LIGHT.comb) > 20


def test_the_comb_is_coloured_by_sign(canvas):
    wave = Curve([[0, 0], [1, 2], [2, -2], [3, 2], [4, -2], [5, 0]])
    image = show(canvas, wave, comb=True)
    assert hue_share(image, LIGHT.comb) > 20
    assert hue_share(image, LIGHT.comb_negative) > 20
    turned = show(canvas, Curve(CIRCLE, degree=2, closed=True), comb=True)
    assert hue_share(turned, LIGHT.comb_negative) == 0


def test_inflections_are_marked(canvas):
    wave = Curve([[0, 0], [1, 2], [2, -2], [3, 2], [4, -2], [5, 0]])
    plain, marked = show(canvas, wave), show(canvas, wave, marks=True)
    for place in canvas.plane.to_pixels(wave(inflections(wave).u)).astype(int):
        x, y = place.tolist()
        assert any(plain.pixel(x + i, y) != marked.pixel(x + i, y) for i in range(-5, 6))


def test_the_osculating_circle_follows_the_pointer(canvas, hand):
    circle = Curve(CIRCLE, degree=2, closed=True)
    show(canvas, circle, circle=True, modes=False)
    hand.move([10.0, 10.0])
    away = canvas.grab().toImage()
    hand.move(circle(0.3))
    near = canvas.grab().toImage()
    x, y = canvas.plane.to_pixels([0.0, 0.0]).astype(int).tolist()
    assert near.pixel(x, y) != away.pixel(x, y)


def test_segments_beyond_their_hull_are_marked_with_the_reason(canvas, hand, monkeypatch):
    told = []
    monkeypatch.setattr(QToolTip, "showText", lambda at, text, widget: told.append(text))
    curve = Curve([[0, 0], [1, 3], [3, 3], [5, -1], [7, 0]], [0, 0, INTERPOLATING[3], 0, 0])
    plain, marked = show(canvas, curve), show(canvas, curve, guards=True)
    x, y = canvas.plane.to_pixels(curve(0.5)).astype(int).tolist()
    assert plain.pixel(x, y - 2) != marked.pixel(x, y - 2)
    hand.move(curve(0.5))
    at = QPoint(x, y)
    QApplication.sendEvent(canvas.viewport(), QHelpEvent(QEvent.Type.ToolTip, at, canvas.mapToGlobal(at)))
    assert told[-1].startswith("basis function c₃ is negative near t = ")
    assert "convex hull" in told[-1]
    tame = curve.with_lambdas([2], [1.0])
    assert show(canvas, tame) == show(canvas, tame, guards=True)


def test_the_hull_of_the_selected_segment_is_filled(canvas):
    square = Curve([[0, 0], [0, 4], [4, 4], [4, 0]])
    plain = show(canvas, square, hull=True)
    canvas.selection.select(segments={0})
    hulled = canvas.grab().toImage()
    x, y = canvas.plane.to_pixels([3.7, 1.0]).astype(int).tolist()
    assert plain.pixelColor(x, y).name().upper() == LIGHT.canvas
    assert hulled.pixelColor(x, y).name().upper() != LIGHT.canvas


@pytest.mark.parametrize("lam", [0.0, -16.0, 10.0, 1e6])
def test_everything_can_be_shown_of_anything(canvas, hand, lam):
    everything = dict.fromkeys(("comb", "marks", "circle", "hull", "uniform", "guards"), True)
    points = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [2.0, 2.0], [2.0, 2.0], [3.0, 0.0]]
    for curve in (
        Curve(points, lam),
        Curve(points, lam, degree=2, closed=True),
        Curve([[1.0, 1.0]] * 4, lam, ends="clamped"),
        Curve(np.column_stack([points, np.arange(6.0)]), lam),
    ):
        show(canvas, curve, **everything)
        canvas.selection.select(segments=range(3))
        hand.move(canvas.document.drawing[0].curve(0.4)[:2])
        assert not canvas.grab().isNull()


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize(("ends", "closed"), [("free", False), ("clamped", False), ("free", True)])
def test_marks_of_a_part_are_those_of_the_whole_there(degree, ends, closed):
    rng = np.random.default_rng(degree)
    curve = Curve(rng.normal(size=(30, 2)).cumsum(axis=0), rng.uniform(-2, 4, 30), degree, closed, ends)
    whole = marks_of(curve)
    assert len(whole.inflections) + len(whole.extremes) > 20
    for first, last in ((0, 3), (5, 6), (9, 9), (20, curve.segment_count - 1)):
        part = Part(curve, np.arange(first, last + 1), np.empty(0, dtype=int))
        for near, there in zip(marks_near(curve, part), whole.within(part), strict=True):
            np.testing.assert_allclose(near, there, rtol=0, atol=1e-7)
