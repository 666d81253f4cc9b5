"""CSV, read back with NumPy's reader."""

import csv
import io

import numpy as np
import pytest
from exchange_curves import BLEND, ELLIPSE, HYPERBOLA, SPACE, gap, size_of

from theditor.drawing import Drawing, Item
from theditor.exchange import Options, write
from theditor.spline import Curve, arc_length, arc_lengths, curvature, known


def table(*curves, **options):
    written = write(
        Drawing([Item(curve, f"c{i}") for i, curve in enumerate(curves)]), ".csv", Options(**options)
    )
    rows = list(csv.reader(io.StringIO(written.data.decode())))
    return rows[0], rows[1:], written


def test_points_by_parameter_are_the_curves_own_to_the_last_digit():
    header, rows, written = table(BLEND, samples=5)
    assert header == ["x", "y", "u"]
    x, y, u = np.array(rows, float).T
    np.testing.assert_array_equal(np.column_stack((x, y)), BLEND(u))
    np.testing.assert_array_equal(u, np.arange(5 * BLEND.segment_count + 1) / 5)
    assert written.deviation == 0


def test_points_by_length_are_equally_far_apart_along_the_curve():
    header, rows, _ = table(BLEND, sampling="length", samples=30)
    assert header == ["x", "y", "u", "length"]
    *_, u, length = np.array(rows, float).T
    np.testing.assert_allclose(arc_lengths(BLEND, u), length, atol=1e-8 * length[-1])
    np.testing.assert_allclose(np.diff(length), arc_length(BLEND) / 30)


@pytest.mark.parametrize("tolerance", [1e-2, 1e-5])
def test_points_by_tolerance_are_as_dense_as_chords_need(tolerance):
    _, rows, written = table(BLEND, sampling="tolerance", tolerance=tolerance)
    points = np.array(rows, float)[:, :2]
    size = size_of(BLEND)
    assert gap(BLEND.sample(300), points) <= tolerance * size
    assert gap(BLEND.sample(300), points) == pytest.approx(written.deviation, rel=0.02)


def test_tangent_and_curvature_on_request():
    header, rows, _ = table(HYPERBOLA, tangent=True, curvature=True, samples=4)
    assert header == ["x", "y", "u", "tangent_x", "tangent_y", "curvature"]
    _, _, u, tx, ty, bend = np.array(rows, float).T
    np.testing.assert_array_equal(bend, curvature(HYPERBOLA, u))
    np.testing.assert_allclose(np.hypot(tx, ty), 1)
    velocity = HYPERBOLA(u, 1)
    np.testing.assert_allclose(tx * velocity[:, 1] - ty * velocity[:, 0], 0, atol=1e-14)


def test_at_a_cusp_there_is_neither():
    _, rows, _ = table(known.cycloid(start=-np.pi), tangent=True, curvature=True, samples=2)
    empty = [row for row in rows if row[-1] == ""]
    assert empty
    assert all(row[3:] == ["", "", ""] for row in empty)


def test_several_curves_are_told_apart_and_space_is_kept():
    header, rows, _ = table(SPACE, ELLIPSE, samples=2)
    assert header == ["curve", "x", "y", "z", "u"]
    mine = np.array([row[1:4] for row in rows if row[0] == "c0"], float)
    np.testing.assert_allclose(mine, SPACE.sample(2), atol=1e-15 * 5)
    assert {row[3] for row in rows if row[0] == "c1"} == {"0.0"}


def test_names_are_quoted_and_hidden_curves_left_out():
    items = [Item(BLEND, 'a,"b"'), Item(ELLIPSE, "=1+1"), Item(ELLIPSE, "gone", visible=False)]
    written = write(Drawing(items), ".csv", Options(samples=1))
    names = [row[0] for row in csv.reader(io.StringIO(written.data.decode()))][1:]
    assert set(names) == {'a,"b"', "=1+1"}
    assert written.notes == ("1 hidden curve is left out.",)


def test_nothing_is_a_header_alone_and_a_point_is_its_own_place():
    assert write(Drawing(), ".csv").data == b"x,y,u\n"
    for sampling in ("parameter", "length", "tolerance"):
        _, rows, _ = table(Curve([[2, 3]] * 4), sampling=sampling, samples=3)
        assert {tuple(row[:2]) for row in rows} == {("2.0", "3.0")}
