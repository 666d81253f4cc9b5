"""SVG as another library reads it."""

import io
import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest
import svgelements
from exchange_curves import BLEND, CURVES, ELLIPSE, SPACE, gap, size_of

from theditor.drawing import Drawing, Item
from theditor.exchange import PARTS, Options, write
from theditor.exchange.embedded import extract
from theditor.spline import Curve, nearest

SVG = "{http://www.w3.org/2000/svg}"
EXACT = {"ellipse", "turned", "straight"}


def drawn(drawing, **options):
    return write(drawing, ".svg", Options(**options))


def path_of(written):
    """The first path as svgelements reads it."""
    root = ET.fromstring(written.data)
    return svgelements.Path(next(root.iter(f"{SVG}path")).get("d"))


def points_on(path, steps):
    """Points of a path, y upward."""
    return np.array(
        [
            (point.x, -point.y)
            for segment in path
            if not isinstance(segment, svgelements.Move)
            for point in map(segment.point, np.arange(steps + 1) / steps)
        ]
    )


@pytest.mark.parametrize("name", CURVES)
def test_another_library_reads_the_curve(name):
    curve = CURVES[name]
    plane = curve.with_(control_points=curve.control_points[:, :2])
    written = drawn(Drawing([Item(curve)]), tolerance=1e-5)
    points = points_on(path_of(written), 8)
    points = points[:: max(1, len(points) // 40)]
    _, off = nearest(plane, points)
    size = size_of(plane)
    assert off.max() <= (1e-9 if name in EXACT else 1e-5) * size
    assert written.deviation == 0 if name in EXACT else 0 < written.deviation <= 1e-5 * size
    # And back, but for what chords hide.
    assert gap(plane.sample(9), points_on(path_of(written), 60)) <= 1e-4 * size


def test_ellipses_are_arcs_of_their_own_centre_and_closed():
    path = path_of(drawn(Drawing([Item(ELLIPSE)])))
    arcs = [segment for segment in path if isinstance(segment, svgelements.Arc)]
    assert len(arcs) == 4
    for arc in arcs:
        assert (arc.center.x, arc.center.y) == pytest.approx((0, 0), abs=1e-12)
        assert sorted((abs(arc.rx), abs(arc.ry))) == pytest.approx([1, 3], abs=1e-12)
    assert isinstance(path[-1], svgelements.Close)


def test_the_picture_has_millimetres_and_holds_all_it_shows():
    written = drawn(Drawing([Item(ELLIPSE, width=4)]), show={"polygon"})
    root = ET.fromstring(written.data)
    width, height = (float(root.get(key).removesuffix("mm")) for key in ("width", "height"))
    x, y, across, down = map(float, root.get("viewBox").split())
    assert (across, down) == (width, height)  # a unit is a millimetre
    assert max(x, -x - across) < -3
    assert max(y, -y - down) < -1
    assert "1 unit is 1 mm." in written.notes
    root = ET.fromstring(drawn(Drawing([Item(ELLIPSE)]), size=80).data)
    assert root.get("width") == "80.0mm"
    root = ET.fromstring(drawn(Drawing([Item(ELLIPSE)]), scale=20).data)
    assert float(root.get("width").removesuffix("mm")) / float(
        root.get("viewBox").split()[2]
    ) == pytest.approx(20)


def test_it_is_drawn_upright_in_its_own_colour_and_physical_width():
    item = Item(BLEND, "A", color="#c8520a", width=3)
    picture = svgelements.SVG.parse(io.BytesIO(drawn(Drawing([item]), size=100).data), ppi=25.4)
    (path,) = [each for each in picture.elements() if isinstance(each, svgelements.Path)]
    start, end = path.first_point, path.current_point
    assert start.y > end.y  # on the page, the end is higher
    assert path.stroke.hex == "#c8520a"
    assert path.fill.value is None
    assert path.stroke_width * 96 / 25.4 == pytest.approx(3, rel=1e-6)


NAMES = [
    "a",
    "a",
    "P & Q <b> ]]> --> \"'",
    "",
    "λ*",
    "1st",
    "curves",
    "Zürich\u00a0\ufffe\U0001f600",
]


def test_names_are_titles_and_ids_that_xml_allows_once_each():
    drawing = Drawing([Item(BLEND, name) for name in NAMES])
    written = drawn(drawing)
    root = ET.fromstring(written.data)
    titles = [title.text or "" for title in root.iter(f"{SVG}title")]
    assert titles == [name.replace("\ufffe", "\ufffd") for name in NAMES]
    ids = [each.get("id") for each in root.iter() if each.get("id")]
    assert len(ids) == len(set(ids)) == len(NAMES) + 1
    assert all(re.fullmatch("[A-Za-z_][A-Za-z0-9_.-]*", each) for each in ids)
    assert ids[1:4] == ["a", "a-2", "P-Q-b"]
    assert extract(written.data).drawing == drawing


def test_what_is_asked_for_lies_in_groups_of_its_own():
    root = ET.fromstring(drawn(Drawing([Item(BLEND)]), show=set(PARTS)).data)
    groups = {group.get("id"): group for group in root.iter(f"{SVG}g")}
    assert set(PARTS) < set(groups)
    assert len(groups["points"]) == len(groups["labels"]) == 6
    assert "".join(groups["labels"][2].itertext()) == "P2"
    corners = [tuple(map(float, pair.split(","))) for pair in groups["polygon"][0].get("points").split()]
    np.testing.assert_array_equal(corners, BLEND.control_points * (1, -1))
    assert not list(ET.fromstring(drawn(Drawing([Item(BLEND)])).data).iter(f"{SVG}circle"))


def test_the_comb_stands_on_the_outer_side():
    root = ET.fromstring(drawn(Drawing([Item(ELLIPSE)]), show={"comb"}).data)
    comb = next(group for group in root.iter(f"{SVG}g") if group.get("id") == "comb")
    for line in comb:
        foot, tip, *more = (np.array(pair.split(","), float) for pair in line.get("points").split())
        if not more:
            assert np.linalg.norm(tip) > np.linalg.norm(foot)


def test_print_style_tells_the_modes_apart_without_colour():
    # trigonometric, blend, hyperbolic, blend, interpolating
    curve = Curve(
        np.random.default_rng(3).normal(size=(8, 2)),
        [0, 0, 0, 1, 1, 8.912056875738365] + [8.912056875738365] * 2,
    )
    assert len(set(curve.modes)) == 4
    root = ET.fromstring(drawn(Drawing([Item(curve, color="#ff0000")]), print_style=True).data)
    paths = list(root.iter(f"{SVG}path"))
    assert len(paths) == 5
    dashes = [path.get("stroke-dasharray") for path in paths]
    assert len(set(dashes)) == 4
    assert dashes[1] == dashes[3]
    assert b"ff0000" not in ET.tostring(next(g for g in root.iter(f"{SVG}g") if g.get("id") == "curves"))
    assert {"polygon", "points", "labels"} < {group.get("id") for group in root.iter(f"{SVG}g")}


def test_hidden_curves_are_left_out_but_not_lost(mixed):
    written = drawn(mixed)
    titles = [title.text for title in ET.fromstring(written.data).iter(f"{SVG}title")]
    assert titles == [item.name for item in mixed if item.visible]
    assert "1 hidden curve is left out." in written.notes
    assert "Curves in space are drawn as seen from above." in written.notes
    found = extract(written.data)
    assert found.drawing == mixed
    assert found.current


@pytest.mark.parametrize(
    "change",
    [
        (b"C", b"c"),
        (b'stroke="#334155"', b'stroke="#ff0000"'),
        (b'<g id="curves"', b'<g transform="scale(2)"'),
    ],
)
def test_a_picture_changed_by_another_program_says_so(change):
    data = drawn(Drawing([Item(BLEND)])).data
    found = extract(data.replace(*change))
    assert not found.current
    assert extract(data.replace(b"</svg>", b"<!-- seen --></svg>")).current


def test_a_picture_without_a_drawing_has_none():
    assert extract(b"<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0'/></svg>") is None
    data = drawn(Drawing([Item(BLEND)])).data
    assert extract(data[:-20]) is None
    assert extract(data.replace(b"<svg", b"<!DOCTYPE svg [<!ENTITY a 'b'>]><svg", 1)) is None


def test_an_empty_drawing_is_an_empty_picture():
    written = drawn(Drawing())
    assert not list(ET.fromstring(written.data).iter(f"{SVG}path"))
    assert extract(written.data).drawing == Drawing()


@pytest.mark.parametrize("factor", [1e-9, 1.0, 1e11])
def test_any_size_of_drawing_is_written(factor):
    curve = BLEND.with_(control_points=BLEND.control_points * factor)
    written = drawn(Drawing([Item(curve)]), show=set(PARTS))
    _, off = nearest(curve, points_on(path_of(written), 5))
    assert off.max() <= 1e-4 * size_of(curve)
    assert 0 < written.deviation <= 1e-4 * size_of(curve)
    root = ET.fromstring(written.data)
    assert np.isfinite([float(x) for x in root.get("viewBox").split()]).all()


def test_the_same_drawing_gives_the_same_bytes(mixed):
    assert drawn(mixed, show=set(PARTS)) == drawn(Drawing(list(mixed)), show=set(PARTS))


def test_a_space_curve_is_seen_from_above():
    flat = SPACE.with_(control_points=SPACE.control_points[:, :2])
    one, other = (ET.fromstring(drawn(Drawing([Item(curve)])).data) for curve in (SPACE, flat))
    assert next(one.iter(f"{SVG}path")).get("d") == next(other.iter(f"{SVG}path")).get("d")
