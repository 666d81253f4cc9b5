import json
import math
from pathlib import Path

import numpy as np
import pytest

from theditor.spline import INTERPOLATING, Curve, Mode

DATA = Path(__file__).parents[1] / "data"
KNOWN = json.loads((DATA / "known_curves.json").read_text())
FIGURES = json.loads((DATA / "figures.json").read_text())
T = np.linspace(0, 1, 33)


def curve_from(entry: dict) -> Curve:
    return Curve(entry["control_points"], entry["lambda"], entry["degree"], entry["closed"])


@pytest.mark.parametrize("name", [name for name in KNOWN if "whole" not in name])
def test_a_segment_is_the_curve_it_is_known_for(name):
    entry = KNOWN[name]
    curve = curve_from(entry)
    formulas = [entry["x_of_t"], entry["y_of_t"]] + ["t"] * (curve.dimension - 2)
    names = {"pi": math.pi} | {f: getattr(np, f) for f in ("sin", "cos", "sinh", "cosh", "exp")}
    expected = np.stack([eval(formula, names | {"t": T}) for formula in formulas], axis=-1)
    np.testing.assert_allclose(curve(T), expected, rtol=0, atol=1e-15 * np.abs(curve.control_points).max())


@pytest.mark.parametrize("name", [name for name in KNOWN if "whole" in name])
def test_a_closed_polygon_is_a_whole_ellipse(name):
    curve = curve_from(KNOWN[name])
    x, y = curve.sample(64).T
    np.testing.assert_allclose(x**2 / 4 + y**2, 1, rtol=0, atol=2e-15)
    turn = np.unwrap(np.arctan2(y, x / 2))
    assert abs(turn[-1] - turn[0]) == pytest.approx(2 * math.pi)


def test_figure_9_is_made_of_ellipse_hyperbola_and_a_point_met():
    curve = curve_from(FIGURES["figure 9"])
    x, y = curve(1 + T).T
    np.testing.assert_allclose((x / 3) ** 2 + (y / curve.control_points[0, 1]) ** 2, 1, rtol=0, atol=4e-15)
    x, y = curve(3 + T).T
    axis = (2 * math.cosh(1) - 1) / (2 * math.cosh(1) - 2)
    np.testing.assert_allclose(((x - 3) / axis - 1) ** 2 - y**2, 1, rtol=0, atol=1e-14)
    np.testing.assert_allclose(curve(5.5), curve.control_points[5], rtol=0, atol=2e-14)
    assert curve.modes == (
        Mode.BLEND,
        Mode.TRIGONOMETRIC,
        Mode.BLEND,
        Mode.HYPERBOLIC,
        Mode.BLEND,
        Mode.INTERPOLATING,
    )


def test_figure_10_is_made_of_the_curves_it_names():
    curve = curve_from(FIGURES["figure 10"])
    assert (curve.first_segment, curve.segment_count) == (1, 10)

    def segment(number):
        return curve(number - 1 + T).T

    trochoid = T - np.sin(np.pi / 2 * T), 1 - np.cos(np.pi / 2 * T)
    np.testing.assert_allclose(segment(1), trochoid, rtol=0, atol=1e-14)
    np.testing.assert_allclose(segment(5), (1 - T, 1 + np.cosh(1 - T)), rtol=0, atol=1e-14)  # a catenary
    np.testing.assert_allclose(segment(6), (-np.sinh(T), 1 + np.cosh(T)), rtol=0, atol=1e-14)  # a hyperbola
    x, y = segment(10)
    np.testing.assert_allclose((x + 2) ** 2 + 4 * y**2, 1, rtol=0, atol=1e-14)  # an ellipse
    np.testing.assert_allclose(curve.joints[2:4], curve.control_points[3:5], rtol=0, atol=1e-13)
    letters = "".join(mode.name[0] for mode in curve.modes)
    assert letters == "TBIBHHHBBT"
    assert (curve.lambdas == INTERPOLATING[3]).nonzero()[0].tolist() == [3, 4]
