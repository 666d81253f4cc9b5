"""The gallery shows what its descriptions say, and its files are what the script writes."""

import importlib.util
import math
import re
from pathlib import Path

import numpy as np
import pytest

from theditor import resources
from theditor.drawing import encode, load
from theditor.spline import INTERPOLATING, Mode

ROOT = Path(__file__).parents[1]
PICTURES = {picture.name: picture for picture in resources.gallery()}


def curves(name):
    return [item.curve for item in load(PICTURES[name].path)]


def along(curve, first=0, last=None):
    """Parameters along some segments of a curve, joints included, and their points, one row a coordinate."""
    u = np.linspace(first, curve.segment_count if last is None else last, 101)
    return u, curve(u).T


def near(value, wanted):
    np.testing.assert_allclose(value, np.broadcast_to(wanted, np.shape(value)), rtol=0, atol=2e-14)


def test_every_file_is_listed_and_is_what_the_script_writes():
    specification = importlib.util.spec_from_file_location(
        "make_gallery", ROOT / "resources" / "make_gallery.py"
    )
    script = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(script)
    written = script.pictures()
    assert written.keys() == PICTURES.keys()
    assert {p.stem for p in (ROOT / "resources/gallery").glob("*.json")} == {*PICTURES, "index"}
    for name, drawing in written.items():
        committed = load(PICTURES[name].path)
        assert encode(committed) == PICTURES[name].path.read_bytes()
        assert len(committed) == len(drawing)
        for old, new in zip(committed, drawing, strict=True):
            # cosh and sinh may differ in the last digit from one system to another
            np.testing.assert_allclose(
                old.curve.control_points, new.curve.control_points, rtol=1e-15, atol=1e-15
            )
            assert old.with_(curve=new.curve) == new
            assert old.curve.with_(control_points=new.curve.control_points) == new.curve


def test_every_picture_has_a_title_and_says_what_it_shows():
    assert list(PICTURES)[:10] == [f"figure-{number:02}" for number in range(1, 11)]
    assert len({picture.title for picture in PICTURES.values()}) == len(PICTURES)
    for picture in PICTURES.values():
        assert len(re.findall(r"\.(?= |$)", picture.about)) == 2, picture.about
        assert len(picture.about) < 300


def test_the_installed_package_is_asked_before_the_repository(tmp_path, monkeypatch):
    package = tmp_path / "theditor"
    monkeypatch.setattr(resources, "_PACKAGE", package)
    with pytest.raises(FileNotFoundError, match="gallery"):
        resources.gallery()
    for folder in (tmp_path / "resources", package / "_resources"):
        (folder / "gallery").mkdir(parents=True)
        (folder / "gallery" / "index.json").write_text('[{"name": "a", "title": "A", "about": "B."}]')
        expected = resources.Picture("a", "A", "B.", folder / "gallery" / "a.json")
        assert resources.gallery() == (expected,)


# Figures 1 to 4


@pytest.mark.parametrize(
    ("name", "degree", "changed", "value"),
    [
        ("figure-01", 2, [3], -1.0),
        ("figure-02", 3, [5], -1.0),
        ("figure-03", 2, [5, 6], INTERPOLATING[2]),
        ("figure-04", 3, [5], INTERPOLATING[3]),
    ],
)
def test_figures_1_to_4_change_some_lambdas_on_one_polygon(name, degree, changed, value):
    even, other = curves(name)
    assert even.degree == degree
    assert np.all(even.lambdas == 0.5)
    assert other == even.with_lambdas(changed, value)
    differs = [
        not np.array_equal(even(s + t), other(s + t)) for s in range(even.segment_count) for t in [0.5]
    ]
    numbers = even.first_segment + np.flatnonzero(differs)
    assert set(numbers) == {segment for i in changed for segment in (i - 1, i)}


def test_figure_1_keeps_the_joint_and_figures_3_and_4_meet_the_point():
    even, other = curves("figure-01")
    near(other.joints, even.joints)
    _, quadratic = curves("figure-03")
    near(quadratic(5 - quadratic.first_segment + 0.5), quadratic.control_points[5])
    _, cubic = curves("figure-04")
    near(cubic(5 - cubic.first_segment), cubic.control_points[5])


# Known curves, on their equations; θ = πu/2


@pytest.mark.parametrize(
    ("name", "centres"), [("figure-05", (-3, 3)), ("ellipse-quadratic", (0,)), ("ellipse-cubic", (0,))]
)
def test_the_ellipses(name, centres):
    for curve, centre in zip(curves(name), centres, strict=True):
        u, (x, y) = along(curve)
        x = x - centre
        near((x / 2) ** 2 + y**2, 1.0)
        # once round: each quarter is one segment
        turned = np.unwrap(np.arctan2(y, x / 2))
        near(turned - turned[0], math.pi / 2 * u)


@pytest.mark.parametrize(("name", "reach"), [("figure-06", 1), ("hyperbola", 2)])
def test_the_hyperbolas(name, reach):
    for curve, sign, degree in zip(curves(name), (1, -1), (3, 2), strict=False):
        u, (x, y) = along(curve)
        assert curve.degree == degree
        near(x, sign * np.cosh(u - reach))
        near(y, np.sinh(u - reach))
        near(x**2 - y**2, 1.0)


def test_the_asymptotes_are_straight():
    for curve, slope in zip(curves("hyperbola")[2:], (1, -1), strict=True):
        _, (x, y) = along(curve)
        near(y, slope * x)


@pytest.mark.parametrize(("name", "reach"), [("figure-08", 1), ("catenary", 2)])
def test_the_catenaries(name, reach):
    u, (x, y) = along(*curves(name))
    near(x, u - reach)
    near(y, np.cosh(x))


def test_the_exponential():
    u, (x, y) = along(*curves("exponential"))
    near(x, u - 3)
    near(y, np.exp(x))


@pytest.mark.parametrize(
    ("name", "index", "radius", "arm", "turns"),
    [
        ("figure-07", 0, 2 / math.pi, 1.0, 1),
        ("figure-07", 1, 2 / math.pi, 2 / math.pi, 1),
        ("cycloid", 0, 1.0, 1.0, 3),
        ("trochoid-prolate", 0, 0.5, 1.0, 3),
        ("trochoid-curtate", 0, 1.0, 0.5, 3),
    ],
)
def test_the_trochoids(name, index, radius, arm, turns):
    curve = curves(name)[index]
    u, (x, y) = along(curve)
    angle = math.pi / 2 * u
    assert curve.segment_count == 4 * turns
    near(x, radius * angle - arm * np.sin(angle))
    near(y, radius - arm * np.cos(angle))


def test_the_sine_wave():
    u, (x, y) = along(*curves("sine"))
    near(x, math.pi / 2 * u)
    near(y, np.sin(x))
    assert x[-1] == pytest.approx(4 * math.pi)


def test_the_helix():
    u, (x, y, z) = along(*curves("helix"))
    near(x, np.cos(math.pi / 2 * u))
    near(y, np.sin(math.pi / 2 * u))
    near(z, u / 4)
    assert z[-1] == pytest.approx(3)


def test_the_star_meets_its_corners():
    through, inside = curves("interpolating")
    near(through.joints, through.control_points)
    assert np.hypot(*inside.joints[::2].T).max() < 3


# Figures 9 and 10, whose segments differ


def test_figure_9():
    (curve,) = curves("figure-09")
    t, h, i, b = Mode.TRIGONOMETRIC, Mode.HYPERBOLIC, Mode.INTERPOLATING, Mode.BLEND
    assert list(curve.modes) == [b, t, b, h, b, i]
    near(curve(5.5), curve.control_points[5])
    _, (x, y) = along(curve, 1, 2)
    low = math.tanh(0.5)
    # The ellipse about the origin that touches the edges P₀P₁ and P₁P₂ at their midpoints.
    near((x / 3) ** 2 + (y / low) ** 2, 1.0)


def test_figure_10():
    (curve,) = curves("figure-10")
    t, h, i, b = Mode.TRIGONOMETRIC, Mode.HYPERBOLIC, Mode.INTERPOLATING, Mode.BLEND
    assert list(curve.modes) == [t, b, i, b, h, h, h, b, b, t]
    near(curve.joints[2:4], curve.control_points[3:5])
    u, (x, y) = along(curve, 0, 1)
    near(x, u - np.sin(math.pi / 2 * u))
    near(y, 1 - np.cos(math.pi / 2 * u))
    u, (x, y) = along(curve, 4, 5)
    near(x, 5 - u)
    near(y, 1 + np.cosh(x))
    u, (x, y) = along(curve, 5, 6)
    near((y - 1) ** 2 - x**2, 1.0)
    u, (x, y) = along(curve, 9, 10)
    near((x + 2) ** 2 + (2 * y) ** 2, 1.0)
