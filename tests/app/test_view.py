"""The view goes to what is selected, and comes back with the file."""

import json
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QSettings, Qt

from theditor.app.main_window import MainWindow
from theditor.app.view import MOST, keep_view


@pytest.fixture
def forgetful():
    QSettings().remove("views")
    yield
    QSettings().remove("views")


def view(window):
    plane = window.canvas.plane
    return plane.x, plane.y, plane.scale


@pytest.mark.parametrize(
    "what", [{"points": {3, 4, 8}}, {"segments": {2, 6}}, {}, {"points": {1}, "segments": {9}}]
)
def test_the_selection_fills_the_canvas(window, qtbot, what):
    window.selection.select(**{"points": (), "segments": (), **what})
    window.canvas.show_view(100.0, 50.0, 3.0)
    qtbot.keyClick(window.canvas, Qt.Key.Key_3)
    curve, plane = window.document.drawing[0].curve, window.canvas.plane
    points = [curve.control_points[i] for i in what.get("points", ())]
    points += [curve(s + t) for s in what.get("segments", ()) for t in np.linspace(0, 1, 33)]
    pixels = plane.to_pixels(points or [*curve.control_points, *curve.sample(16)])
    share = (pixels.max(axis=0) - pixels.min(axis=0)) / (plane.width, plane.height)
    assert 0.69 < share.max() < 0.72
    assert (pixels >= 0).all()
    assert (pixels <= (plane.width, plane.height)).all()


def test_one_point_comes_to_the_middle_at_the_same_scale(window, qtbot):
    scale = window.canvas.plane.scale
    window.selection.select(points={8})
    qtbot.keyClick(window.canvas, Qt.Key.Key_3)
    assert view(window) == pytest.approx((*window.document.drawing[0].curve.control_points[8], scale))


def test_each_file_is_seen_again_as_it_was_left(window, forgetful, tmp_path, qtbot):
    for name in ("a.json", "b.json"):
        window.document.save(tmp_path / name)
    window.open_path(tmp_path / "a.json")
    fitted = view(window)
    window.canvas.show_view(1.5, 2.5, 200.0)
    window.open_path(tmp_path / "b.json")
    assert view(window) == pytest.approx(fitted)
    window.open_path(tmp_path / "a.json")
    assert view(window) == pytest.approx((1.5, 2.5, 200.0))
    window.canvas.fit()
    again = window.beside()
    qtbot.addWidget(again)
    window.close()
    again.open_path(tmp_path / "a.json")
    assert view(again) == pytest.approx(fitted)


@pytest.mark.parametrize(
    "garbage", ["not JSON", "[1, 2]", '{"FILE": [1, "x", 2]}', '{"FILE": [1.0, 1.0, -2.0]}']
)
def test_settings_that_make_no_sense_are_passed_over(window, forgetful, tmp_path, garbage):
    window.document.save(tmp_path / "a.json")
    window.canvas.fit()
    fitted = view(window)
    QSettings().setValue("views", garbage.replace("FILE", str(tmp_path / "a.json")))
    window.document.start(window.document.drawing)
    window.open_path(tmp_path / "a.json")
    assert view(window) == pytest.approx(fitted)


def test_only_the_latest_views_are_kept(window, forgetful):
    window.canvas.show_view(0.0, 0.0, 10.0)
    for number in range(MOST + 5):
        keep_view(Path(f"/{number}.json"), window.canvas)
    kept = json.loads(QSettings().value("views"))
    assert len(kept) == MOST
    assert str(Path("/4.json").absolute()) not in kept


def test_what_is_shown_is_shown_the_next_time(window, qtbot):
    for name in ("show_grid", "show_comb", "snap"):
        window.actions_by_name[name].toggle()
    window.close()
    again = MainWindow()
    qtbot.addWidget(again)
    checked = {
        name: again.actions_by_name[name].isChecked() for name in ("show_grid", "show_comb", "show_labels")
    }
    assert checked == {"show_grid": False, "show_comb": True, "show_labels": True}
    assert again.canvas.shown.comb
    assert not again.canvas.shown.grid
    assert again.canvas.snapper.on
