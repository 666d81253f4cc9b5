"""Points laid into a picture of bits: what a round pen covers that has been at all of them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtGui import QImage, QPainter

from theditor.canvas import curves, dense
from theditor.canvas.curves import CurvesPainter
from theditor.canvas.dense import NARROWEST, WIDEST, Grid, coverage, spacing
from theditor.canvas.viewport import Viewport
from theditor.drawing import Drawing, Item
from theditor.model.colours import LIGHT
from theditor.spline import Curve

CORNER, SCALE, COLUMNS, ROWS = np.array([2.0, 3.0]), 5.0, 40, 30


def share(points, width, fine=4):
    bands = list(
        coverage(lambda raster: map(raster.places, points), width, Grid(CORNER, SCALE, COLUMNS, ROWS, fine))
    )
    covered = np.concatenate([band for _, band in bands])
    assert [first for first, _ in bands] == np.cumsum([0, *(len(band) for _, band in bands[:-1])]).tolist()
    assert len(covered) == ROWS
    return covered[:, :COLUMNS] / 16


def in_plane(pixels):
    """Points of the plane, (2, n), at pixels (2, n)."""
    return CORNER[:, None] + np.asarray(pixels, dtype=float) / [[SCALE], [-SCALE]]


@given(st.integers(0, 2**32 - 1), st.floats(NARROWEST, WIDEST), st.integers(0, 60), st.sampled_from([4, 2]))
def test_a_pixel_is_covered_as_far_as_it_is_near_a_point(seed, width, count, fine):
    pixels = np.random.default_rng(seed).uniform(-10, 50, (2, count))
    grid = (np.arange(8 * max(COLUMNS, ROWS)) + 0.5) / 8
    away = np.hypot(
        grid[None, : 8 * COLUMNS, None] - pixels[0], grid[: 8 * ROWS, None, None] - pixels[1]
    ).min(axis=2, initial=np.inf)
    exact = (away <= width / 2).reshape(ROWS, 8, COLUMNS, 8).mean(axis=(1, 3))
    drawn = share([in_plane(pixels[:, : count // 2]), in_plane(pixels[:, count // 2 :])], width, fine)
    # Points are moved by up to half a bit each way, the pen's width by as much, on both sides of a gap.
    assert np.abs(drawn - exact).max() < 2.5 / fine
    assert np.abs(drawn - exact).mean() < 0.2 / fine


@pytest.mark.parametrize("width", [0.5, 1.0, 1.3, 2.0, 3.6, 8.0, WIDEST])
def test_a_straight_line_is_as_wide_as_its_pen(width):
    along = np.arange(-5.0, 45.0, spacing(width))
    level = share([in_plane([along, np.full_like(along, 15.0)])], width)
    upright = share([in_plane([np.full_like(along, 20.0), along])], width)
    for sums in (level.sum(axis=0), upright.sum(axis=1)):
        assert np.abs(sums - width).max() <= 0.25


@pytest.mark.parametrize("fine", [4, 2])
def test_bands_of_rows_fit_together(monkeypatch, fine):
    points = [in_plane(np.random.default_rng(1).uniform(-5, 45, (2, 80)))]
    whole = share(points, 3.0, fine)
    monkeypatch.setattr(dense, "BAND", 7 * COLUMNS)
    assert (share(points, 3.0, fine) == whole).all()
    assert 0 < whole.mean() < 1


@pytest.mark.parametrize("width", [4.0, WIDEST])
@pytest.mark.parametrize("fine", [4, 2])
def test_what_lies_outside_leaves_nothing_inside(width, fine):
    away = width / 2 + 0.3
    far = [[-1e9, 1e9, -away, 40 + away, 20.0, 20.0], [10.0, 10.0, 10.0, 10.0, -away, 30 + away]]
    assert not share([in_plane(far)], width, fine).any()


@pytest.mark.parametrize("ratio", [1.0, 1.5, 2.0])
def test_parts_of_a_picture_fit_together(qapp, monkeypatch, ratio):
    monkeypatch.setattr(curves, "DENSE", 0.0)
    monkeypatch.setattr(curves, "MOST_LINES", 0)
    angles = np.arange(400) * 0.9
    drawing = Drawing(
        [Item(Curve((np.stack([np.cos(angles), np.sin(angles)]) * (2 + angles / 90)).T), color="#7A5AC8")]
    )
    painted = CurvesPainter()
    painted.update(drawing)
    plane = Viewport(0.3, -0.2, 22.0, 200.0, 160.0)

    def picture(areas):
        image = QImage(round(200 * ratio), round(160 * ratio), QImage.Format.Format_ARGB32_Premultiplied)
        image.setDevicePixelRatio(ratio)
        image.fill(0)
        painter = QPainter(image)
        for area in areas:
            painted.paint(painter, drawing, 0, plane, LIGHT, by_mode=True, area=area)
        painter.end()
        return np.array(image.constBits())

    whole = picture([(0.0, 0.0, 200.0, 160.0)])
    assert (whole > 0).mean() > 0.1
    assert (
        picture([(0.0, 0.0, 60.0, 160.0), (60.0, 0.0, 140.0, 44.0), (60.0, 44.0, 140.0, 116.0)]) == whole
    ).all()


def painted_at_once(monkeypatch, width):
    """A curve of a width, painted as if it were a very dense one, on white; returns both as arrays."""
    monkeypatch.setattr(curves, "DENSE", 0.0)
    monkeypatch.setattr(curves, "MOST_LINES", 0)
    angles = np.arange(40) * 0.9
    drawing = Drawing([Item(Curve(np.stack([np.cos(angles), np.sin(angles)]).T), width=width)])
    painted = CurvesPainter()
    painted.update(drawing)
    image = QImage(100, 100, QImage.Format.Format_RGB32)
    image.fill(0xFFFFFF)
    blank = np.array(image.constBits())
    painter = QPainter(image)
    painted.paint(painter, drawing, 0, Viewport(0, 0, 40, 100, 100), LIGHT, by_mode=False)
    painter.end()
    return np.array(image.constBits()), blank


@pytest.mark.parametrize("width", [0.3, 30.0])
def test_pens_too_fine_or_too_wide_draw_lines(qapp, monkeypatch, width):
    monkeypatch.setattr(dense, "coverage", None)
    picture, blank = painted_at_once(monkeypatch, width)
    assert (picture != blank).any()


@pytest.mark.parametrize("width", [0.6, 9.0, 20.0])
def test_other_pens_draw_no_lines(qapp, monkeypatch, width):
    monkeypatch.setattr(curves, "draw_lines", None)
    picture, blank = painted_at_once(monkeypatch, width)
    assert (picture != blank).any()
