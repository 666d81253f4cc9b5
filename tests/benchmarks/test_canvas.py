"""What the window costs a person's hand: frames at 10⁵ control points beside frames at 100.

    pytest tests/benchmarks/test_canvas.py -n 0

opens two windows of one size, one with a large drawing and one with a small one, and sends both the same real
mouse events, in turns. A frame is the time from the event to the window painted, as the processor spent it, the
fastest of several. It prints, as multiples:

- a frame of dragging a control point, pulling the curve, moving the λ slider and hovering at 10⁵ points, of the
  same at 100 (the aim: at most 2);
- the start of a drag, and undo and redo of little and much, at 10⁵ points, of painting all of the window anew
  (at most 1.5);
- a frame of panning and of zooming at 10⁵ points, of the same at 100 (at most 4);
- a frame of dragging 1,000 selected points out of 10⁵, of dragging one (at most 10), and, without an aim, of
  dragging all points of many curves and changing every λ of a long one.

For a spiral, for a thousand curves, and for a scribble that covers what it is drawn on several times over.
Times on a busy machine mean little, so nothing here fails on them.
"""

import time
from functools import partial
from itertools import count

import numpy as np
import pytest
from hand import LEFT, NONE, Hand
from large import DRAWINGS, spiral
from paired import fastest
from PySide6.QtCore import QEvent, QPointF, QSettings, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget

from theditor.app.main_window import MainWindow
from theditor.app.theme import Theme, apply_theme
from theditor.canvas.curves import MOST_FORMER
from theditor.canvas.held import every_point
from theditor.spline import points

NO_BUTTON = Qt.MouseButton.NoButton


class Desk:
    """A window with a drawing, and a hand over it."""

    def __init__(self, drawing):
        self.window = MainWindow()
        self.window.document.start(drawing)
        self.window.resize(1360, 860)
        self.window.show()
        self.canvas, self.hand = self.window.canvas, Hand(self.window.canvas)
        self.canvas.fit()
        self.steps = count()
        self.frame()

    @property
    def curve(self):
        return self.window.document.drawing[0].curve

    @property
    def step(self):
        """A little way that is another one on each frame."""
        k = next(self.steps)
        return np.array([8.0 + k % 7, -5.0 - k % 5])

    def frame(self):
        QApplication.processEvents()

    @property
    def middle(self):
        plane = self.canvas.plane
        return plane.x, plane.y

    def paint_anew(self):
        """Paint all of the window, with nothing kept."""
        self.canvas.set_shown(grid=not self.canvas.shown.grid)
        for widget in self.window.findChildren(QWidget):
            widget.update()
        self.frame()

    def move(self, pixel, button):
        self.hand._send(QEvent.Type.MouseMove, pixel, NO_BUTTON, button, NONE)
        self.frame()

    def take(self, point):
        """Press on a place of the plane; returns what moves on by one frame."""
        pixel = self.hand.pixel(point)
        self.hand.press(point)
        self.frame()
        return lambda: self.move(pixel + self.step, LEFT)

    def let_go(self):
        self.canvas.cancel_drag()
        self.hand.button = NO_BUTTON
        self.frame()

    def close(self):
        self.window.document.settle()
        self.window.document.undo_stack.setClean()
        self.window.close()


@pytest.fixture(scope="module", autouse=True)
def _application():
    app = QApplication.instance() or QApplication([])
    app.setOrganizationName("theditor-tests")
    app.setApplicationName("theditor-tests")
    app.setStyle("Fusion")
    QSettings().clear()
    apply_theme(Theme.LIGHT)


@pytest.fixture(scope="module", params=list(DRAWINGS))
def desks(request):
    small, large = Desk(spiral(100)), Desk(DRAWINGS[request.param]())
    yield request.param, small, large
    small.close()
    large.close()


@pytest.fixture(autouse=True)
def _told(desks, report):
    yield
    for desk in desks[1:]:
        desk.let_go()
        desk.window.selection.select(points=(), segments=())


def frames(*works, **options):
    return fastest(*works, clock=time.process_time, **options)


def a_point(desk):
    return desk.curve.control_points[3 * len(desk.curve.control_points) // 10]


def a_place(desk):
    """Somewhere on the curve where nothing else can be taken hold of."""
    for u in np.linspace(0.31, 0.37, 400) * desk.curve.segment_count:
        point = desk.curve(u)
        if type(desk.canvas.hit(desk.hand.pixel(point))).__name__ == "SegmentHit":
            return point
    return None


def test_dragging_a_point(desks, report):
    name, small, large = desks
    few, many = frames(small.take(a_point(small)), large.take(a_point(large)))
    report(f"{name}: dragging a point {many / few:.2f} ({many * 1e3:.1f} ms)")


def test_pulling_the_curve(desks, report):
    name, small, large = desks
    for desk in (small, large):
        place = a_place(small).copy() if desk is small else desk.curve(0.31 * desk.curve.segment_count)
        desk.canvas.show_view(
            *place, 40 * desk.canvas.plane.scale if desk is large else desk.canvas.plane.scale
        )
        desk.frame()
    few, many = frames(*(desk.take(a_place(desk)) for desk in (small, large)))
    report(f"{name}: pulling the curve {many / few:.2f} ({many * 1e3:.1f} ms)")
    for desk in (small, large):
        desk.let_go()
        desk.canvas.fit()
        desk.frame()


def test_moving_the_slider(desks, report):
    name, *both = desks

    def slide(desk):
        desk.window.selection.select(points=[3 * len(desk.curve.control_points) // 10])
        desk.frame()
        slider, steps = desk.window.shape.slider, count()

        def send(kind, x):
            at = QPointF(x, slider.height() / 2)
            button = LEFT if kind == QEvent.Type.MouseButtonPress else NO_BUTTON
            event = QMouseEvent(kind, at, QPointF(slider.mapToGlobal(at.toPoint())), button, LEFT, NONE)
            QApplication.sendEvent(slider, event)
            desk.frame()

        send(QEvent.Type.MouseButtonPress, 150.0)
        return lambda: send(QEvent.Type.MouseMove, 160.0 + 4 * (next(steps) % 9))

    few, many = frames(*(slide(desk) for desk in both))
    for desk in both:
        desk.window.document.settle()
        desk.window.document.undo()
    report(f"{name}: moving the λ slider {many / few:.2f} ({many * 1e3:.1f} ms)")


def test_hovering(desks, report):
    name, *both = desks

    def hover(desk):
        pixel = desk.hand.pixel(a_point(desk))
        return lambda: desk.move(pixel + desk.step, NO_BUTTON)

    few, many = frames(*(hover(desk) for desk in both))
    report(f"{name}: hovering {many / few:.2f} ({many * 1e3:.1f} ms)")


def test_starting_a_drag(desks, report):
    name, _, large = desks
    pixel = large.hand.pixel(a_point(large))

    def prepare():
        large.let_go()
        large.take(a_point(large))

    anew, start = frames(large.paint_anew, lambda: large.move(pixel + large.step, LEFT), prepare=prepare)
    report(f"{name}: starting a drag {start / anew:.2f} ({start * 1e3:.1f} ms)")


def changes(drawing):
    """Drawings that differ in little and in much."""
    curve, rng = drawing[0].curve, np.random.default_rng(0)
    count = len(curve.control_points)
    some = np.sort(rng.choice(count, min(1000, count // 2), replace=False))
    yield "one point", drawing.with_curve(0, curve.with_points([50], [[0.0, 0.0]]))
    yield (
        "1,000 scattered points",
        drawing.with_curve(0, curve.with_points(some, curve.control_points[some] + 0.1)),
    )
    every = [item.curve for item in drawing]
    for what, change in (
        ("every point", lambda c: c.with_points(range(len(c.lambdas)), c.control_points + 0.1)),
        ("every λ", lambda c: c.with_lambdas(range(len(c.lambdas)), 0.3)),
        ("the degree", lambda c: c.with_(degree=5 - c.degree)),
    ):
        yield what, drawing.with_curves(dict(enumerate(map(change, every))))
    yield "1,000 scattered points gone", drawing.with_curve(0, points.remove(curve, some).curve)
    yield (
        "a point more in the middle",
        drawing.with_curve(0, points.insert(curve, curve.segment_count / 2).curve),
    )


def test_undoing(desks, report):
    name, _, large = desks
    document = large.window.document

    def undo():
        document.undo()
        large.frame()

    def redo():
        document.redo()
        large.frame()

    for text, new in changes(document.drawing):
        document.apply(text, new)
        large.frame()
        anew, undone, redone = frames(large.paint_anew, undo, redo, rounds=6)
        document.undo()
        report(
            f"{name}: undo, redo of {text} {undone / anew:.2f}, {redone / anew:.2f} ({undone * 1e3:.1f} ms)"
        )


def test_undoing_many_steps(desks, report):
    """Each step changed everything, and there are more of them than trees of chords are kept; the slowest counts."""
    name, _, large = desks
    document = large.window.document
    for _ in range(MOST_FORMER + 2):
        every = {
            i: item.curve.with_points(range(len(item.curve.lambdas)), item.curve.control_points * 1.01)
            for i, item in enumerate(document.drawing)
        }
        document.apply("Grow", document.drawing.with_curves(every))
        large.frame()

    def go(step):
        step()
        large.frame()

    works = [partial(go, step) for step in (document.undo, document.redo) for _ in range(MOST_FORMER + 2)]
    anew, *times = frames(large.paint_anew, *works, rounds=6)
    for _ in range(MOST_FORMER + 2):
        document.undo()
    ways = np.reshape(times, (2, -1)) / anew
    kept, further = (part.max() for part in (ways[:, :MOST_FORMER], ways[:, MOST_FORMER:]))
    report(f"{name}: undo, redo of {MOST_FORMER} steps, each {kept:.2f}, of further ones {further:.2f}")


def test_panning(desks, report):
    name, *both = desks

    def pan(desk):
        plane = desk.canvas.plane

        def show():
            x, y = plane.to_points(np.array([plane.width, plane.height]) / 2 + desk.step)
            desk.canvas.show_view(float(x), float(y), plane.scale)
            desk.frame()

        return show

    few, many = frames(*(pan(desk) for desk in both))
    for desk in both:
        desk.canvas.fit()
    report(f"{name}: panning {many / few:.2f} ({many * 1e3:.1f} ms)")


def test_zooming(desks, report):
    """A notch of the wheel, from a view that is painted."""
    name, *both = desks

    def start(enlarged):
        for desk in both:
            desk.canvas.fit()
            desk.canvas.show_view(*desk.middle, desk.canvas.plane.scale * enlarged)
            desk.frame()

    def turn(desk, notches):
        desk.hand.wheel(desk.middle, notches)
        desk.frame()

    for way, notches, enlarged in (("in", 1, 1.0), ("out", -1, 2.0)):
        works = [partial(turn, desk, notches) for desk in both]
        few, many = frames(*works, prepare=partial(start, enlarged))
        report(f"{name}: zooming {way} {many / few:.2f} ({many * 1e3:.1f} ms)")

    for desk in both:
        desk.canvas.fit()


def test_dragging_many_points(desks, report):
    name, _, large = desks
    points = len(large.curve.control_points)
    if points < 1000:
        pytest.skip("no curve with so many points")
    first = 3 * points // 10
    for what, chosen in (
        ("together", np.arange(first, first + 1000)),
        ("scattered", np.append(np.random.default_rng(0).choice(points, 999, replace=False), first)),
    ):
        one = frames(large.take(a_point(large)))[0]
        large.let_go()
        large.window.selection.select(points=chosen)
        (thousand,) = frames(large.take(a_point(large)))
        large.let_go()
        report(f"{name}: dragging 1,000 points, {what}, {thousand / one:.2f} ({thousand * 1e3:.1f} ms)")


@pytest.mark.parametrize("share", [0.1, 1.0], ids=["some", "all"])
def test_dragging_many_curves(desks, report, share):
    name, _, large = desks
    drawing = large.window.document.drawing
    if len(drawing) < 10:
        pytest.skip("not many curves")
    one = frames(large.take(a_point(large)))[0]
    large.let_go()
    chosen = every_point(drawing, range(int(share * len(drawing))))
    large.window.selection.select_across(chosen, curve=0)
    (many,) = frames(large.take(a_point(large)))
    report(f"{name}: dragging all points of {len(chosen)} curves {many / one:.1f} ({many * 1e3:.1f} ms)")


def test_changing_every_lambda(desks, report):
    name, small, large = desks
    if name == "many":
        pytest.skip("one long curve is measured")

    def hold(desk):
        gesture, values = desk.window.document.begin("λ"), count()

        def show():
            lambdas = range(len(desk.curve.lambdas))
            new = desk.curve.with_lambdas(lambdas, 0.1 + 0.01 * (next(values) % 50))
            gesture.preview(gesture.before.with_curve(0, new))
            desk.frame()

        return show

    few, many = frames(hold(small), hold(large))
    for desk in (small, large):
        desk.window.document.settle()
        desk.window.document.undo()
    report(f"{name}: changing every λ {many / few:.1f} ({many * 1e3:.1f} ms)")
