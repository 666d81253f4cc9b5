"""What the canvas draws, in pixels and without a window: clipping, traces, picking, labels, the grid."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from theditor.canvas.grid import number, steps
from theditor.canvas.handles import CELL, thinned
from theditor.canvas.hit_test import near_handles, near_places
from theditor.canvas.labels import place
from theditor.canvas.lines import clipped
from theditor.canvas.trace import TOLERANCE, Trace, strokes
from theditor.canvas.viewport import Viewport
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


def drawn_by_segment(strokes):
    """Rows of segment, mode, and the ends of a line, in order."""
    rows = [np.column_stack([s.segments, np.full(len(s.lines), s.code), s.lines]) for s in strokes]
    table = np.vstack([np.empty((0, 6)), *rows])
    return table[np.argsort(table[:, 0], kind="stable")]


@given(curves(), st.data())
def test_a_trace_after_edits_is_the_trace_made_anew(curve, data):
    trace = Trace()
    trace.update(curve, PLANE)
    for _ in range(3):
        index = data.draw(st.integers(0, len(curve.control_points) - 1))
        if data.draw(st.booleans()):
            curve = curve.with_points([index], [data.draw(st.tuples(coordinates, coordinates))])
        else:
            curve = curve.with_lambdas([index], [data.draw(lambdas)])
        trace.update(curve, PLANE)
        now, anew = drawn_by_segment(trace.strokes()), drawn_by_segment(strokes(curve, PLANE))
        assert now.shape == anew.shape
        assert np.abs(now - anew).max(initial=0.0) < 1e-9


def test_a_drag_samples_only_the_segments_it_changes(monkeypatch):
    curve = Curve(np.random.default_rng(1).normal(size=(200, 2)) * 3, degree=3)
    trace = Trace()
    trace.update(curve, PLANE)
    sampled = []

    def record(curve, plane, segments=None):
        sampled.append(None if segments is None else segments.tolist())
        return strokes(curve, plane, segments)

    monkeypatch.setattr("theditor.canvas.trace.strokes", record)
    for x in (0.1, 0.2, 0.3):
        trace.update(curve.with_points([100], [[x, 0.0]]), PLANE)
    trace.update(curve, PLANE)
    assert sampled == [[97, 98, 99, 100]] * 3


@given(curves(), st.tuples(st.floats(0, 800), st.floats(0, 600)))
def test_picking_finds_the_nearest_place_and_its_parameter(curve, at):
    at = np.array(at)
    u = np.linspace(*curve.domain, 2000)
    pixels = PLANE.to_pixels(curve(u))
    distances = np.hypot(*(pixels - at).T)
    places = near_places(strokes(curve, PLANE), at, curve.segment_count)
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
    lines = strokes(loop, PLANE)
    found = near_places(lines, PLANE.to_pixels(loop(u)), loop.segment_count)
    assert sorted(segment + t for _, segment, t in found) == pytest.approx([u, v], abs=0.05)
    joint = PLANE.to_pixels(loop(1.0))
    assert len(near_places(lines, joint, loop.segment_count)) == 1


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


def test_modes_are_told_apart_in_strokes():
    curve = Curve([[0, 0], [1, 2], [3, 1], [4, 0], [5, 2]]).with_mode(1, Mode.HYPERBOLIC)
    assert {stroke.code for stroke in strokes(curve, PLANE)} == {1, 3}
