"""TikZ, read from its path commands and measured against the curve."""

import re

import numpy as np
import pytest
from exchange_curves import BLEND, CURVES, ELLIPSE, gap, size_of

from theditor.drawing import Drawing, DrawingError, Item
from theditor.exchange import PARTS, Options, write
from theditor.spline import INTERPOLATING, Curve, bounds, nearest

NUMBER = r"-?\d+\.\d+"
POINT = rf"\(({NUMBER}),({NUMBER})\)"


def drawn(*items, **options):
    written = write(Drawing(items), ".tex", Options(**options))
    return written.data.decode(), written


def points_on(text, steps=12):
    """Points of all thick paths, in mm from the lower left corner."""
    runs, t = [], np.arange(steps + 1)[:, None] / steps
    for path in re.findall(r"\\draw\[curve\d+.*?;", text, re.S):
        here = None
        for line in path.splitlines()[1:]:
            corners = np.array(re.findall(POINT, line), float)
            if "controls" in line:
                a, b, c = corners
                runs.append(
                    (1 - t) ** 3 * here + 3 * t * (1 - t) ** 2 * a + 3 * t**2 * (1 - t) * b + t**3 * c
                )
            elif len(corners):
                runs.append(corners if here is None else np.vstack((here, corners)))
            here = corners[-1] if len(corners) else here
    return np.concatenate(runs)


@pytest.mark.parametrize("name", sorted(CURVES.keys() - {"straight"}))  # a square box tells no scale
def test_the_path_is_the_curve_at_one_scale(name):
    curve = CURVES[name].with_(control_points=CURVES[name].control_points[:, :2])
    text, written = drawn(Item(curve), tolerance=1e-5, size=100)
    picture = np.array(re.search(rf"rectangle {POINT}", text).groups(), float)
    low, high = bounds(curve)
    # The picture is the curve's box at one scale with equal margins.
    unit = np.diff(picture)[0] / np.diff(high - low)[0]
    points = points_on(text) / unit + (low + high - picture / unit) / 2
    _, off = nearest(curve, points[:: max(1, len(points) // 30)])
    assert off.max() <= 1.1e-5 * size_of(curve)
    assert gap(curve.sample(8), points) <= 1e-3 * size_of(curve)
    assert 0 < written.deviation <= 1.1e-5 * size_of(curve)


def test_the_picture_is_as_long_as_asked():
    for size in (None, 80.0):
        text, _ = drawn(Item(BLEND), size=size)
        width, height = map(float, re.search(rf"rectangle {POINT}", text).groups())
        assert max(width, height) == (size or 120.0)
        points = points_on(text)
        assert (points > 0).all()
        assert (points < (width, height)).all()


def test_it_is_a_document_of_its_own_with_balanced_braces():
    text, _ = drawn(Item(BLEND, "50% of {a} \\b $c_1"), Item(ELLIPSE), show=PARTS, print_style=True)
    assert text.startswith("\\documentclass[tikz]{standalone}")
    code = "\n".join(line.split("%")[0] for line in text.splitlines())
    assert code.count("{") == code.count("}")
    for name in ("document", "tikzpicture"):
        assert code.count(f"\\begin{{{name}}}") == code.count(f"\\end{{{name}}}") == 1
    assert "\\b " not in code
    assert text.isascii()


def test_polygon_points_and_labels_are_drawn_on_request():
    plain, _ = drawn(Item(BLEND))
    assert "node" not in plain
    full, _ = drawn(Item(BLEND), show={"polygon", "points", "labels", "comb"})
    assert re.findall(r"\{\$(P_\{\d\})\$\}", full) == [f"P_{{{i}}}" for i in range(6)]
    assert full.count("circle[") == 6
    assert full.count("\\draw[polygon") == full.count("\\draw[comb") == 1


def test_print_style_tells_modes_apart_in_black():
    star = INTERPOLATING[3]
    curve = Curve(np.random.default_rng(3).normal(size=(8, 2)), [0, 0, 0, 1, 1, star, star, 0])
    text, _ = drawn(Item(curve, color="#ff0000"), print_style=True)
    patterns = re.findall(r"line width=0\.5292mm(.*?)\]", text)
    assert len(patterns) == 5
    assert len(set(patterns)) == 4
    assert "FF0000" not in text.upper()


def test_what_tex_cannot_measure_is_refused():
    with pytest.raises(DrawingError, match="TeX cannot draw"):
        drawn(Item(BLEND), size=6000)


@pytest.mark.parametrize("factor", [1e-9, 1e11])
def test_any_size_of_drawing_is_written(factor):
    curve = BLEND.with_(control_points=BLEND.control_points * factor)
    small, large = drawn(Item(BLEND))[0], drawn(Item(curve))[0]
    np.testing.assert_allclose(points_on(small), points_on(large), atol=2e-6)


def test_an_empty_drawing_is_an_empty_picture():
    text, written = drawn()
    assert "\\draw" not in text
    assert written.deviation == 0
