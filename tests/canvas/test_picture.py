"""What the canvas draws, in pixels and without a window: clipping, traces, picking, labels, the grid."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtGui import QImage, QPainter

from theditor.canvas.curves import CurvesPainter
from theditor.canvas.grid import number, steps
from theditor.canvas.handles import CELL, detail, thinned
from theditor.canvas.hit_test import near_handles, near_places
from theditor.canvas.labels import place
from theditor.canvas.lines import clipped
from theditor.canvas.trace import TOLERANCE, Stroke, strokes
from theditor.canvas.viewport import Viewport
from theditor.drawing import Drawing, Item
from theditor.model import LIGHT
from theditor.spline import Curve, Mode, self_intersections

PLANE = Viewport(1.0, 0.5, 80.0, 800.0, 600.0)
coordinates = st.floats(-6, 8)
lambdas = st.floats(-16, 10)


@st.composite
def curves(draw):
    degree = draw(st.sampled_from([2, 3]))
    count = draw(st.integers(degree + 1, 9))
    points = draw(st.lists(st.tuples(coordinates, coordinates), min_size=count, max_size=count))
    values = draw(st.lists(lambdas, min_size=count, max_size=count))
    return Curve(points, values, degree=degree, closed=draw(st.booleans()))


@given(st.tuples(coordinates, coordinates), st.floats(1e-3, 1e6))
def test_pixels_and_points_are_inverse(point, scale):
    plane = Viewport(1.0, 0.5, scale, 800.0, 600.0)
    assert np.allclose(
        plane.to_points(plane.to_pixels(point)), point, rtol=0, atol=1e-12 * max(1, 1e3 / scale)
    )


@given(st.lists(st.tuples(*[st.floats(-1e9, 1e9) | st.floats(-50, 850)] * 4), min_size=1, max_size=5))
def test_clipping_keeps_what_is_inside_and_nothing_far_outside(lines):
    lines = np.array(lines)
    kept, owners = clipped(lines.copy(), 800, 600)
    assert (np.abs(kept) < 12_000).all()
    for k, line in enumerate(lines):
        along = line[:2] + np.linspace(0, 1, 2001)[:, None] * (line[2:] - line[:2])
        inside = along[((along > 0) & (along < (800, 600))).all(axis=1)]
        parts = kept[owners == k]
        for point in inside[:: max(1, len(inside) // 5)]:
            assert distance(parts, point) < 1e-3


def distance(lines, point):
    if not len(lines):
        return np.inf
    start, along = lines[:, :2], lines[:, 2:] - lines[:, :2]
    squares = np.maximum((along**2).sum(axis=1), 1e-300)
    f = (((point - start) * along).sum(axis=1) / squares).clip(0, 1)
    return np.hypot(*(start + f[:, None] * along - point).T).min()


@given(curves())
def test_every_visible_place_of_a_curve_is_drawn_within_the_tolerance(curve):
    drawn = np.vstack([np.empty((0, 4)), *(stroke.lines for stroke in strokes(curve, PLANE))])
    pixels = PLANE.to_pixels(curve(np.linspace(*curve.domain, 60)))
    for pixel in pixels[((pixels > 0) & (pixels < (800, 600))).all(axis=1)]:
        assert distance(drawn, pixel) <= TOLERANCE + 1e-6


def picked(curve, at):
    painter = CurvesPainter()
    painter.update(Drawing([Item(curve)]))
    nothing = Stroke(-1, np.empty((0, 4)), np.empty(0, dtype=int), np.empty((0, 2)))
    return painter.near(at, 8.0, PLANE).get(0, nothing)


@given(curves(), st.tuples(st.floats(0, 800), st.floats(0, 600)))
def test_picking_finds_the_nearest_place_and_its_parameter(curve, at):
    at = np.array(at)
    u = np.linspace(*curve.domain, 2000)
    pixels = PLANE.to_pixels(curve(u))
    distances = np.hypot(*(pixels - at).T)
    places = near_places(picked(curve, at), at, curve.segment_count)
    if not places:
        assert distances.min() > 8 - TOLERANCE - 1e-6
    else:
        found, segment, t = places[0]
        assert found <= distances.min() + TOLERANCE + 1e-6
        assert np.hypot(*(PLANE.to_pixels(curve(segment + min(t, 1.0))) - at)) <= found + 0.5


def test_handles_in_one_place_are_picked_from_the_topmost_down():
    handles = np.array([[10.0, 10.0], [50.0, 50.0], [10.0, 10.0], [12.0, 10.0]])
    assert near_handles(handles, np.array([13.0, 10.0])) == [3, 2, 0]
    assert near_handles(handles, np.array([30.0, 30.0])) == []
    assert near_handles(np.empty((0, 2)), np.zeros(2)) == []


def test_a_curve_is_picked_once_for_each_of_its_passages():
    loop = Curve([[-3, 0], [4, 3], [0, 4], [-2, 1], [3, -1], [6, 2]], ends="clamped")
    ((u, v),) = self_intersections(loop)
    crossing = PLANE.to_pixels(loop(u))
    found = near_places(picked(loop, crossing), crossing, loop.segment_count)
    assert sorted(segment + t for _, segment, t in found) == pytest.approx([u, v], abs=0.05)
    joint = PLANE.to_pixels(loop(1.0))
    assert len(near_places(picked(loop, joint), joint, loop.segment_count)) == 1


@given(st.lists(st.tuples(st.floats(0, 300), st.floats(0, 200)), min_size=1, max_size=25))
def test_labels_overlap_neither_each_other_nor_handles(handles):
    handles = np.array(handles)
    sizes = np.tile([18.0, 15.0], (len(handles), 1))
    centres = place(handles, sizes, np.empty((0, 2)))
    boxes = [(c - sizes[0] / 2, c + sizes[0] / 2) for c in centres if c is not None]
    for i, (low, high) in enumerate(boxes):
        assert not any(((p > low) & (p < high)).all() for p in handles)
        for other_low, other_high in boxes[:i]:
            assert not ((low < other_high) & (high > other_low)).all()


def test_thinning_covers_every_handle_and_keeps_the_topmost():
    pixels = np.random.default_rng(2).uniform(0, 60, size=(5000, 2))
    kept = thinned(pixels)
    assert len(kept) <= (60 / CELL + 1) ** 2
    assert (kept[-1] == pixels[-1]).all()
    for pixel in pixels[::50]:
        assert np.abs(kept - pixel).max(axis=1).min() <= CELL


@given(st.floats(1e-6, 1e9))
def test_grid_lines_are_neither_crowded_nor_rare(scale):
    major, minor = steps(scale)
    assert 79.9 <= major * scale <= 200.1
    assert round(major / minor) in (4, 5)
    assert float(f"{major:.0e}") == pytest.approx(major)


@pytest.mark.parametrize(
    ("value", "step", "text"),
    [(-0.5, 0.5, "−0.5"), (3.0, 1.0, "3"), (1e9 + 2, 1.0, "1000000002"), (2e-8, 1e-8, "2e−08")],
)
def test_grid_numbers_tell_neighbours_apart(value, step, text):
    assert number(value, step) == text
    assert number(value, step) != number(value + step, step)


def spaced(gap, count=60):
    """A wavy row of control points, so many pixels from each other."""
    x = np.arange(count) * gap / PLANE.scale
    return Curve(np.stack([x + PLANE.x - x.mean(), PLANE.y + 0.02 * np.sin(x)], axis=1))


@pytest.mark.parametrize(
    ("gap", "handles", "joints"), [(3, False, False), (11, True, False), (13, True, True)]
)
def test_handles_show_where_they_can_be_told_apart(gap, handles, joints):
    curve = spaced(gap)
    found = detail(curve, PLANE, np.arange(curve.segment_count))
    assert (found.handles, found.joints) == (handles, joints)
    assert found.points == 60


def test_a_few_handles_always_show():
    assert detail(spaced(0.5, 12), PLANE, np.arange(9)).handles


def test_modes_are_told_apart_in_strokes():
    curve = Curve([[0, 0], [1, 2], [3, 1], [4, 0], [5, 2]]).with_mode(1, Mode.HYPERBOLIC)
    assert {stroke.code for stroke in strokes(curve, PLANE)} == {1, 3}


def test_a_wide_line_does_not_fray_in_a_bend(qapp):
    width, plane = 24.0, Viewport(0.5, 0.5, 100.0, 200.0, 200.0)
    curve = Curve([(0, 0), (0.5, 0.4), (0.6, 0.5), (0.5, 0.6), (0, 1)], ends="clamped")
    drawing, painted = Drawing([Item(curve, width=width)]), CurvesPainter()
    painted.update(drawing)
    image = QImage(200, 200, QImage.Format.Format_RGB32)
    image.fill(0xFFFFFF)
    painter = QPainter(image)
    painted.paint(painter, drawing, 0, plane, LIGHT, by_mode=False)
    painter.end()
    rows, columns = np.nonzero(np.array(image.constBits()).reshape(200, 200, 4)[..., 0] < 128)
    inked = np.stack([columns, rows], axis=1) + 0.5
    along = plane.to_pixels(curve.sample(60))
    away = np.hypot(*(inked[:, None] - along).transpose(2, 0, 1)).min(axis=1)
    assert len(away) > 1000
    assert away.max() < width / 2 + 0.75
