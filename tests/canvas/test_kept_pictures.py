"""What is kept between frames shows in no picture: each is as if everything had been painted anew."""

import numpy as np
import pytest
from hand import LEFT, MIDDLE, NONE, SHIFT, Hand
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPainterPath, QPalette, QPen, QPolygonF
from PySide6.QtTest import QTest

from theditor.canvas import curves
from theditor.canvas.curves import CurvesPainter
from theditor.canvas.layers import Layers
from theditor.canvas.viewport import Viewport
from theditor.drawing import Drawing, Item
from theditor.model.colours import LIGHT
from theditor.spline import Curve


def shot(layers, canvas, ratio=1.0):
    """One frame of a canvas as an array, (height, width, 4)."""
    frame = canvas._frame()
    size = round(frame.plane.width * ratio), round(frame.plane.height * ratio)
    image = QImage(*size, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    painter = QPainter(image)
    layers.paint(painter, frame)
    painter.end()
    return pixels(image)


def pixels(image):
    return np.array(image.constBits()).reshape(image.height(), image.width(), 4).astype(np.int16)


def anew(canvas, ratio=1.0):
    return shot(Layers(CurvesPainter()), canvas, ratio)


def differing(one, other):
    """Which pixels of two pictures differ more than rounding explains."""
    assert one.shape == other.shape
    return np.abs(one - other).max(axis=2) > 8


class Fidget:
    """A hand that does this and that at random, each time one thing more."""

    def __init__(self, canvas, seed):
        self.canvas, self.hand, self.rng = canvas, Hand(canvas), np.random.default_rng(seed)

    def somewhere(self):
        item = self.canvas.document.drawing[0]
        points = item.curve.control_points
        place = points[self.rng.integers(len(points))] if self.rng.random() < 0.6 else item.curve(2.4)
        return place + self.rng.choice([0.0, 0.05])

    def drag(self):
        start = self.somewhere()
        self.hand.press(start)
        pixel = self.hand.pixel(start)
        for k in range(1, 4):
            self.hand._send(
                QEvent.Type.MouseMove,
                pixel + k * 9,
                Qt.MouseButton.NoButton,
                LEFT,
                self.rng.choice([NONE, SHIFT]),
            )
            yield False
            self.in_between()
            yield False
        if self.rng.random() < 0.3:
            QTest.keyClick(self.canvas, Qt.Key.Key_Escape)
            yield True
        self.hand.release(start)
        yield True

    def in_between(self):
        """What may happen while the hand drags."""
        what = self.rng.integers(6)
        if what == 0:
            self.hand.wheel(self.somewhere(), self.rng.choice([-1, 1]))
        elif what == 1:
            self.canvas.resize(*self.rng.integers(300, 500, 2).tolist())
        elif what == 2:
            other_theme(self.canvas)

    def pan(self):
        start = self.canvas.plane.to_points(np.array([120.0, 90.0]))
        away = self.rng.integers(-60, 60, 2) / self.canvas.plane.scale
        self.hand.drag(start, start + away, button=MIDDLE, steps=2)
        yield True

    def zoom(self):
        for notches in self.rng.choice([-1, 1], 3).tolist():
            self.hand.wheel(self.somewhere(), notches)
            yield False

    def undo(self):
        self.canvas.document.undo()
        yield True
        self.canvas.document.redo()
        yield True

    def select(self):
        self.hand.drag(np.array([-1.0, -2.0]), self.somewhere() + 0.3)
        yield True

    def look(self):
        name = self.rng.choice(["comb", "marks", "uniform", "hull", "polygon", "joints", "labels", "ghost"])
        self.canvas.set_shown(**{str(name): not getattr(self.canvas.shown, name)})
        yield True

    def hover(self):
        self.hand.move(self.somewhere())
        yield True

    def __iter__(self):
        doings = [self.drag, self.drag, self.pan, self.zoom, self.undo, self.select, self.look, self.hover]
        for _ in range(12):
            yield from doings[self.rng.integers(len(doings))]()


def other_theme(canvas):
    palette = QPalette()
    dark = canvas.palette().window().color().lightness() >= 128
    palette.setColor(QPalette.ColorRole.Window, Qt.GlobalColor.black if dark else Qt.GlobalColor.white)
    canvas.setPalette(palette)


@pytest.mark.parametrize(
    ("seed", "ratio", "dense"), [(1, 1.0, 0.1), (2, 2.0, 0.0), (4, 1.5, 0.1), (5, 1.0, 0.0)]
)
def test_no_frame_shows_what_was_before(canvas, seed, ratio, dense, monkeypatch):
    monkeypatch.setattr(curves, "DENSE", dense)
    monkeypatch.setattr(curves, "MOST_LINES", 0)
    canvas.resize(480, 360)
    canvas.fit()
    kept = Layers(CurvesPainter())
    for at_rest in Fidget(canvas, seed):
        wrong = differing(shot(kept, canvas, ratio), anew(canvas, ratio))
        # In mid-drag more may count as moving than does, and lies in another order where lines cross.
        assert wrong.sum() == 0 if at_rest else wrong.mean() < 5e-4


def test_while_a_point_moves_the_picture_is_that_of_the_moved_curve(canvas, hand):
    canvas.set_shown(ghost=False, labels=False)
    hand.press((3.0, 3.0))
    hand._send(QEvent.Type.MouseMove, hand.pixel((4.0, 2.0)), Qt.MouseButton.NoButton, LEFT, NONE)
    assert canvas.document.before is not None
    moving = shot(canvas._layers, canvas)
    hand.release((4.0, 2.0))
    hand.move((4.0, 2.0))
    assert differing(moving, anew(canvas)).mean() < 1e-3


def test_a_drag_paints_only_what_it_moves(canvas, hand, monkeypatch):
    painted = []
    paint = CurvesPainter.paint
    monkeypatch.setattr(
        CurvesPainter, "paint", lambda self, *a, **k: painted.append(1) or paint(self, *a, **k)
    )
    hand.press((3.0, 3.0))
    for x in (3.5, 4.0, 4.5, 3.0, 2.0):
        hand._send(QEvent.Type.MouseMove, hand.pixel((x, 2.0)), Qt.MouseButton.NoButton, LEFT, NONE)
        shot(canvas._layers, canvas)
    assert len(painted) == 1


def test_panning_paints_what_comes_into_view(canvas, monkeypatch):
    areas = []
    paint = CurvesPainter.paint
    monkeypatch.setattr(
        CurvesPainter,
        "paint",
        lambda self, *a, **k: areas.append(k["area"]) or paint(self, *a, **k),
    )
    shot(canvas._layers, canvas)
    plane = canvas.plane
    canvas.show_view(plane.x - 7 / plane.scale, plane.y - 3 / plane.scale, plane.scale)
    shot(canvas._layers, canvas)
    width, height = plane.width, plane.height
    assert areas == [(0, 0, 7, height), (7, height - 3, width - 7, 3)]


def test_going_back_and_forth_measures_no_curve_again(canvas, monkeypatch):
    document, measured = canvas.document, []
    shot(canvas._layers, canvas)
    tree = curves.ChordTree
    monkeypatch.setattr(curves, "ChordTree", lambda *of: measured.append(1) or tree(*of))
    for factor in (1.1, 1.2, 1.3):
        curve = document.drawing[0].curve
        every = range(len(curve.control_points))
        document.apply_curve("Grow", 0, curve.with_points(every, curve.control_points * factor))
        shot(canvas._layers, canvas)
    assert len(measured) == 3
    for step in [document.undo] * 3 + [document.redo] * 3:
        step()
        shot(canvas._layers, canvas)
    assert len(measured) == 3
    document.start(document.drawing.with_curve(0, document.drawing[0].curve.with_(closed=True)))
    shot(canvas._layers, canvas)
    assert len(measured) == 4
    assert not canvas._curves._former


def test_no_more_is_kept_after_many_edits_than_after_some():
    painter, sizes = CurvesPainter(), []
    for k in range(60):
        painter.update(Drawing([Item(Curve(np.arange(12.0).reshape(6, 2) ** (1 + k / 60)))]))
        sizes.append(len(painter._former))
    assert sizes[-1] == sizes[20] > 3


def test_what_is_hidden_under_the_pointer_is_gone(canvas, hand):
    drawing = canvas.document.drawing
    hand.move(drawing[1].curve(0.5))
    shown = anew(canvas)
    canvas.document.apply("Hide", drawing.with_item(1, drawing[1].with_(visible=False)))
    assert differing(shot(canvas._layers, canvas), shown).any()
    assert not differing(shot(canvas._layers, canvas), anew(canvas)).any()


def writing(count):
    """A long curve of small loops."""
    turns = np.arange(count) * 0.83
    return (
        np.stack([turns * 0.05 % 40, turns * 0.05 // 40], axis=1)
        + np.stack([np.cos(turns), np.sin(turns)], axis=1) * (0.3 + 0.1 * np.sin(turns / 7))[:, None]
    )


def winding(count):
    turns = np.sqrt(np.arange(1, count + 1) / np.pi) * 2 * np.pi
    return (turns * np.stack([np.cos(turns), np.sin(turns)])).T / 12


@pytest.mark.parametrize("dense", [0.0, np.inf])
@pytest.mark.parametrize("make", [writing, winding])
def test_what_is_left_out_of_a_crowded_picture_cannot_be_seen(qapp, make, dense, monkeypatch):
    monkeypatch.setattr(curves, "CROWDED", 4000)
    monkeypatch.setattr(curves, "DENSE", dense)
    monkeypatch.setattr(curves, "MOST_LINES", 0)
    curve = Curve(make(4500), ends="clamped")
    low, high = curve.control_points.min(axis=0), curve.control_points.max(axis=0)
    plane = Viewport(*((low + high) / 2).tolist(), 500.0 / float((high - low).max()), 520.0, 520.0)
    drawing = Drawing([Item(curve)])

    def quick(painter):
        crowd = CurvesPainter()
        crowd.update(drawing)
        crowd.paint(painter, drawing, -1, plane, LIGHT, by_mode=False)

    def exact(painter):
        path = QPainterPath()
        path.addPolygon(QPolygonF([QPointF(*place) for place in plane.to_pixels(curve.sample(6))]))
        painter.setPen(QPen(QColor(drawing[0].color), drawing[0].width))
        painter.drawPath(path)

    drawn, wanted = (picture(paint, 520) for paint in (quick, exact))
    assert (wanted < 255).mean() > 0.05
    # As far as when nothing moves by more than half a pixel: each pixel is between its neighbours' values.
    around = np.lib.stride_tricks.sliding_window_view(np.pad(wanted, 1, mode="edge"), (3, 3))
    beyond = np.maximum(around.min(axis=(2, 3)) - drawn, drawn - around.max(axis=(2, 3)))
    assert (beyond > 16).mean() < 3e-3
    assert np.abs(drawn - wanted).mean() < 7


@pytest.mark.parametrize("width", [2.0, 8.0])
@pytest.mark.parametrize("extent", [1.0, 1e-3, 0.0])
def test_a_curve_too_small_to_see_is_a_dot_as_wide_as_its_pen(qapp, width, extent):
    square = Curve([[-extent, 0], [0, extent], [extent, 0], [0, -extent]], closed=True)
    drawing, crowd = Drawing([Item(square, width=width)]), CurvesPainter()
    crowd.update(drawing)
    plane = Viewport(0.0, 0.0, 1e-3, 60.0, 60.0)
    drawn = picture(lambda painter: crowd.paint(painter, drawing, -1, plane, LIGHT, by_mode=False), 60)
    assert 0.7 * width**2 <= (drawn < 160).sum() <= 1.3 * width**2


def picture(paint, size):
    """What is painted on white, as an array (size, size) of one of the colours."""
    image = QImage(size, size, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    paint(painter)
    painter.end()
    return np.array(image.constBits()).reshape(size, size, 4)[..., 1].astype(int)
