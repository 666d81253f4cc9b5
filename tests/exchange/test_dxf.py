"""DXF, read from its tags alone and evaluated by the formulas of the format."""

import io
from itertools import pairwise

import ezdxf
import numpy as np
import pytest
from exchange_curves import BLEND, CLOSED, CURVES, ELLIPSE, HYPERBOLA, SPACE, gap, size_of

from theditor.drawing import Drawing, Item
from theditor.exchange import Options, write
from theditor.spline import Curve, known, nearest

EXACT = {"ellipse": "ELLIPSE", "turned": "ELLIPSE", "straight": "LWPOLYLINE", "hyperbola": "SPLINE"}


def entities(data):
    """Every entity of the drawing as its type and the values of each group code."""
    lines = iter(data.decode().split("\r\n" if b"\r\n" in data else "\n"))
    pairs = [(int(code), value) for code, value in zip(lines, lines, strict=False)]
    start = pairs.index((2, "ENTITIES")) + 1
    found = []
    for code, value in pairs[start:]:
        if code == 0:
            if value == "ENDSEC":
                return found
            found.append((value, {}))
        else:
            found[-1][1].setdefault(code, []).append(value)
    raise AssertionError("no end of the entities")


def vectors(tags, first):
    return np.array([tags[code] for code in (first, first + 10, first + 20)], float).T


def points_of(kind, tags, steps=24):
    if kind == "LINE":
        return np.vstack((vectors(tags, 10), vectors(tags, 11)))
    if kind == "LWPOLYLINE":
        corners = np.array([tags[10], tags[20]], float).T
        return np.column_stack((corners, np.full(len(corners), float(tags.get(38, [0])[0]))))
    if kind == "ELLIPSE":
        (centre,), (major,) = vectors(tags, 10), vectors(tags, 11)
        normal = vectors(tags, 210)[0] if 210 in tags else np.array([0.0, 0, 1])
        ratio, start, end = (float(tags[code][0]) for code in (40, 41, 42))
        angle = np.linspace(start, end, steps * 4 + 1)[:, None]
        return centre + np.cos(angle) * major + np.sin(angle) * ratio * np.cross(normal, major)
    assert kind == "SPLINE"
    controls, knots = vectors(tags, 10), np.array(tags[40], float)
    degree, weights = int(tags[71][0]), np.array(tags.get(41, np.ones(len(controls))), float)
    assert len(knots) == len(controls) + degree + 1
    t = np.unique([np.linspace(a, b, steps + 1) for a, b in pairwise(np.unique(knots))])
    raised = de_boor(np.column_stack((controls * weights[:, None], weights)), knots, degree, t)
    return raised[:, :-1] / raised[:, -1:]


def de_boor(controls, knots, degree, t):
    span = np.clip(np.searchsorted(knots, t, side="right") - 1, degree, len(controls) - 1)
    d = [controls[span - degree + j] for j in range(degree + 1)]
    for r in range(1, degree + 1):
        for j in range(degree, r - 1, -1):
            low, high = knots[span - degree + j], knots[span + 1 + j - r]
            a = ((t - low) / (high - low))[:, None]
            d[j] = (1 - a) * d[j - 1] + a * d[j]
    return d[degree]


def in_space(curve):
    return np.pad(curve.sample(240), ((0, 0), (0, 3 - curve.dimension)))


@pytest.mark.parametrize("name", CURVES)
def test_the_entities_are_the_curve(name):
    curve, size = CURVES[name], size_of(CURVES[name])
    written = write(Drawing([Item(curve)]), ".dxf", Options(tolerance=1e-5))
    found = entities(written.data)
    if name in EXACT:
        assert {kind for kind, _ in found} == {EXACT[name]}
        assert written.deviation == 0
    else:
        assert 0 < written.deviation <= 1.01e-5 * size
    points = np.vstack([points_of(kind, tags) for kind, tags in found])
    plane = points[:, : curve.dimension]
    _, off = nearest(curve, plane[:: max(1, len(plane) // 40)])
    assert off.max() <= (1e-9 if name in EXACT else 1.01e-5) * size
    assert gap(in_space(curve)[::17], points) <= 1e-3 * size


@pytest.mark.parametrize(("degree", "weighted"), [(2, True), (3, False)])
def test_a_hyperbola_is_exact_only_where_it_is_a_quadratic(degree, weighted):
    written = write(Drawing([Item(known.hyperbola(degree=degree))]), ".dxf", Options(tolerance=1e-5))
    found = entities(written.data)
    assert [(kind, 41 in tags) for kind, tags in found] == [("SPLINE", weighted)] * len(found)
    assert (written.deviation == 0) == weighted


def test_a_whole_ellipse_is_one_entity():
    ((kind, tags),) = entities(write(Drawing([Item(ELLIPSE)]), ".dxf").data)
    assert kind == "ELLIPSE"
    assert float(tags[40][0]) == pytest.approx(1 / 3, abs=1e-15)
    assert [float(tags[code][0]) for code in (41, 42)] == [0, 2 * np.pi]


@pytest.mark.parametrize("backwards", [False, True])
@pytest.mark.parametrize("quarters", [1, 2, 3])
def test_an_arc_starts_and_ends_with_the_curve(quarters, backwards):
    curve = known.ellipse(centre=(5, -3), semi_axes=(3, 1), rotation=0.7, quarters=quarters, start=0.4)
    curve = curve.reversed() if backwards else curve
    ((kind, tags),) = entities(write(Drawing([Item(curve)]), ".dxf").data)
    points = points_of(kind, tags)[:, :2]
    ends = curve([0, curve.segment_count])
    assert gap(points, curve.sample(2000)) <= 1e-6
    for end in ends:
        assert min(np.linalg.norm(points[[0, -1]] - end, axis=1)) <= 1e-14 * 8
    np.testing.assert_array_less(gap(curve.sample(16), points), 2e-3)


def test_a_circle_in_an_upright_plane_is_an_ellipse_there():
    curve = Curve([[-1, 2, 1], [1, 2, 1], [1, 2, -1], [-1, 2, -1]], 0.0, 2, closed=True)
    ((kind, tags),) = entities(write(Drawing([Item(curve)]), ".dxf").data)
    assert kind == "ELLIPSE"
    points = points_of(kind, tags)
    np.testing.assert_allclose(points[:, 1], 2, atol=1e-15)
    np.testing.assert_allclose(np.hypot(points[:, 0], points[:, 2]), 1, atol=1e-14)


def test_one_run_is_one_spline_with_clamped_knots_even_if_closed():
    for curve in (BLEND, CLOSED, SPACE):
        (kind, tags), *more = entities(write(Drawing([Item(curve)]), ".dxf").data)
        assert (kind, more) == ("SPLINE", [])
        knots = [float(knot) for knot in tags[40]]
        assert knots[:4] == [knots[0]] * 4
        assert knots[-4:] == [knots[-1]] * 4
        assert not int(tags[70][0]) & 1
    (_, tags), *_ = entities(write(Drawing([Item(HYPERBOLA)]), ".dxf").data)
    assert int(tags[70][0]) & 4
    assert float(tags[41][1]) == pytest.approx(np.cosh(0.5), abs=1e-15)


def test_layers_have_valid_names_once_each_and_the_curves_colours(mixed):
    names = ["a", "A", "0", "", "x<y>|z", "λ*"]
    items = [Item(BLEND, name, "#c8520a", width=3) for name in names]
    data = write(Drawing(items), ".dxf").data
    document = ezdxf.read(io.StringIO(data.decode()))
    assert not document.audit().errors
    layers = [entity.dxf.layer for entity in document.modelspace()]
    assert layers == ["a", "A 2", "0 2", "Curve", "x-y--z", "λ-"]
    assert all(document.layers.get(name).rgb == (0xC8, 0x52, 0x0A) for name in layers)
    assert document.units == 4
    everything = ezdxf.read(io.StringIO(write(mixed, ".dxf").data.decode()))
    assert not everything.audit().errors
    assert "unseen" not in {entity.dxf.layer for entity in everything.modelspace()}


def test_the_same_drawing_gives_the_same_bytes(mixed):
    assert write(mixed, ".dxf") == write(mixed, ".dxf")
    assert not entities(write(Drawing(), ".dxf").data)


@pytest.mark.parametrize("factor", [1e-9, 1e11])
def test_any_size_of_drawing_is_written(factor):
    curve = BLEND.with_(control_points=BLEND.control_points * factor)
    found = entities(write(Drawing([Item(curve)]), ".dxf").data)
    _, off = nearest(curve, points_of(*found[0], steps=3)[:, :2])
    assert off.max() <= 1.01e-4 * size_of(curve)


def test_ellipses_too_small_for_the_format_are_drawn_all_the_same():
    tiny = ELLIPSE.with_(control_points=ELLIPSE.control_points * 1e-13)
    (found,) = entities(write(Drawing([Item(tiny)]), ".dxf").data)
    assert found[0] == "SPLINE"
    assert gap(points_of(*found)[:, :2], tiny.sample(600)) <= 1e-6 * size_of(tiny)
    kinds = [kind for kind, _ in entities(write(Drawing([Item(tiny), Item(ELLIPSE)]), ".dxf").data)]
    assert "ELLIPSE" not in kinds[:-1]
    assert kinds[-1] == "ELLIPSE"
