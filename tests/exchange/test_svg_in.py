"""SVG comes in: what it draws becomes curves there, in its style; what is hostile is refused in one sentence."""

import gzip
import io
import os
import random
import re
from contextlib import suppress

import numpy as np
import pytest
import svgelements

from theditor.drawing import Drawing, DrawingError, Item
from theditor.exchange import Options, read, write
from theditor.exchange.svg_in import read_path_data
from theditor.spline import Curve, nearest

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'


def svg(body, attributes=""):
    return f"{HEAD} {attributes}>{body}</svg>".encode()


def come_in(body, attributes="", **options):
    return read(svg(body, attributes), ".svg", Options(**options))


def only(body, attributes=""):
    (item,) = come_in(body, attributes).drawing
    return item


NESTED = """
<g transform="translate(10 20) rotate(30)"><path d="M0 0C10 20 30 20 40 0"/>
  <g transform="skewX(20) scale(2,.5)"><path d="M1 2H11V8H1V3"/></g>
  </g><g transform="scale(2) translate(3 -1)"><circle cx="5" cy="5" r="4"/></g>
<svg x="20" y="10" width="60" height="30" viewBox="0 0 10 10"><ellipse cx="5" cy="5" rx="3" ry="2"/>
  <line x1="0" y1="0" x2="10" y2="5"/></svg>
<defs><g id="two"><polygon points="0,0 5,0 5,5"/><polyline points="0 0 5 1 7 8"/></g></defs>
<use xlink:href="#two" x="5" y="7" transform="matrix(1 .2 .3 -1 4 5)"/><rect x="3" y="4" width="9" height="8" rx="2"/>
"""


def test_everything_lies_where_another_library_has_it():
    imported = come_in(NESTED, 'width="100" height="50" viewBox="0 0 100 50"', tolerance=1e-4)
    tree = svgelements.SVG.parse(io.BytesIO(svg(NESTED, 'width="100" height="50" viewBox="0 0 100 50"')))
    shapes = [shape for shape in tree.elements() if isinstance(shape, svgelements.Shape)]
    assert len(shapes) == len(imported.drawing) == 8
    t = np.linspace(0, 1, 15)
    for shape, item in zip(shapes, imported.drawing, strict=True):
        for part in svgelements.Path(shape):
            if not isinstance(part, svgelements.Move | svgelements.Close):
                for place in ((part.point(s).x, -part.point(s).y) for s in t):
                    assert nearest(item.curve, place)[1] <= imported.deviation + 1e-9 * 100
    assert 0 < imported.deviation <= 1e-4 * 100
    exact = [item.curve.degree for item in imported.drawing[1:]]
    assert exact == [2, 2, 2, 3, 2, 2, 2]  # the line is a cubic of two points
    assert imported.notes == ()


def test_units_are_those_of_the_picture_and_lengths_have_theirs():
    curve = only(
        '<circle cx="50%" cy="1in" r="25.4mm"/>', 'width="40mm" height="20mm" viewBox="0 0 400 200"'
    ).curve
    low, high = curve.sample(64).min(axis=0), curve.sample(64).max(axis=0)
    assert (low + high) / 2 == pytest.approx([200, -96])
    assert high - low == pytest.approx([192, 192], rel=1e-3)


def test_names_colours_widths_and_what_is_hidden():
    imported = come_in(
        """<style>/* all */ path {stroke: red} .thick {stroke-width: 3} #c {stroke: #00f; visibility: hidden}</style>
        <g stroke-width="2" color="#123456"><title>not mine</title>
        <path d="M0 0L1 1M2 2L3 3"><title>Two &amp; two</title></path>
        <path id="b" class="thin thick" d="M0 0L1 2" style="stroke:currentColor"/><rect id="c" width="1" height="1"/>
        </g><g display="none"><line x2="4" fill="#abcdef"/></g>"""
    )
    assert [(item.name, item.color, item.width, item.visible) for item in imported.drawing] == [
        ("Two & two 1", "#ff0000", 2.0, True),
        ("Two & two 2", "#ff0000", 2.0, True),
        ("b", "#123456", 3.0, True),
        ("c", "#0000ff", 2.0, False),
        ("Line 1", "#abcdef", 1.0, False),
    ]


def test_a_stroke_is_as_wide_as_the_picture_has_it_on_paper():
    item = only(
        '<path stroke-width="0.5" d="M0 0L9 9"/>', 'width="25.4mm" height="25.4mm" viewBox="0 0 24 24"'
    )
    assert item.width == pytest.approx(2.0)


def some_drawing():
    wave = Curve(
        [
            (0, 0),
            (
                1,
                2,
            ),
            (3, 2),
            (4, 0),
        ],
        [0, 1, 8.9, 0.3],
    )
    ring = Curve([(0, 0), (4, 0), (4, 3), (0, 3)], degree=2, closed=True)
    space = Curve([(0, 0, 1), (1, 2, 2), (3, 2, 3), (4, 0, 4)], ends="clamped")
    return Drawing(
        [Item(wave, "wave <&>", "#ff0000", 3.0), Item(ring, visible=False), Item(space, locked=True)]
    )


def test_a_picture_of_ours_is_the_very_drawing_until_somebody_changes_it():
    data = write(some_drawing(), ".svg", Options(show={"points", "polygon", "labels"}, tolerance=1e-3)).data
    imported = read(data, ".svg")
    assert (imported.drawing, imported.deviation, imported.notes) == (some_drawing(), 0.0, ())
    changed = re.sub(rb' d="M[^C]*C', b' d="M7,7 C', data, count=1)
    assert changed != data
    again = read(changed, ".svg", Options(tolerance=1e-2))
    assert [item.name for item in again.drawing] == ["wave <&>", "Curve"]  # without points and polygons
    assert again.drawing[0].curve != some_drawing()[0].curve
    assert "Another program changed the picture" in again.notes[0]
    damaged = read(data.replace(b'"version"', b'"venison"'), ".svg", Options(tolerance=1e-2))
    assert "damaged" in damaged.notes[0]
    assert len(damaged.drawing) == 2


def test_without_its_metadata_a_picture_of_ours_still_has_its_ellipses_exactly():
    rng = np.random.default_rng(3)
    curve = Curve(rng.normal(size=(7, 2)), degree=2, closed=True)
    data = write(Drawing([Item(curve, "T")]), ".svg").data
    bare = re.sub(rb"<metadata>.*</metadata>", b"", data, flags=re.DOTALL)
    imported = read(bare, ".svg")
    assert imported.deviation == 0
    (item,) = imported.drawing
    assert item.name == "T"
    assert len(item.curve.control_points) == 7
    assert max(nearest(item.curve, point)[1] for point in curve.sample(5)) < 1e-12


def test_what_is_no_curve_is_left_out_and_told():
    imported = come_in(
        """<text>a</text><text>b</text><image xlink:href="http://example.org/x.png"/><script>1</script>
        <clipPath id="k"><rect width="1" height="1"/></clipPath><symbol><rect width="1" height="1"/></symbol>
        <path d="M0 0L1 1" clip-path="url(#k)" filter="url(#f)"/><path d="M0 0L1 1 oops"/>
        <rect width="wide" height="1"/><use xlink:href="#nothing"/><g transform="turn(3"><path d="M0 0L1 1"/></g>"""
    )
    assert len(imported.drawing) >= 2
    first, second, third = imported.notes
    assert first == "Left out, as no curve: 1 image, 1 script, 2 texts."
    assert second == "What is drawn with clip paths or filters is read without them."
    assert "(path: from character 10 of its data on)" in third
    assert "(rect: 'wide' is no length)" in third


def test_a_symbol_is_drawn_where_it_is_used_in_its_own_view():
    item = only(
        '<symbol id="s" viewBox="0 0 2 1"><rect width="2" height="1"/></symbol>'
        '<use xlink:href="#s" x="10" y="20" width="40" height="40"/>'
    )
    low, high = item.curve.control_points.min(axis=0), item.curve.control_points.max(axis=0)
    assert (*low, *high) == pytest.approx((10, -50, 50, -30))


def test_path_data_alone_and_its_faults():
    imported = read_path_data("M0 0H10V5ZM3 3a1 1 0 0 0 2 0a1 1 0 0 0-2 0")
    assert [len(item.curve.control_points) for item in imported.drawing] == [6, 4]
    assert imported.drawing[0].curve.control_points.min() == -5  # y upward
    for text, words in (
        ("M0 0L1 1?", "cannot be read from character 9 on"),
        ("M0 0", "draws nothing"),
        ("M0 0L1e30 0", "must be numbers within"),
    ):
        with pytest.raises(DrawingError, match=words):
            read_path_data(text)


def test_progress_is_told_and_may_end_the_work():
    shares = []
    body = '<path d="M0 0C1 2 3 2 4 0"/>' * 5
    read(svg(body), ".svg", progress=shares.append)
    assert shares == sorted(shares)
    assert 0 <= shares[0] < shares[-1] <= 1

    class EnoughError(Exception):
        pass

    def stop(share):
        if share > 0.3:
            raise EnoughError

    with pytest.raises(EnoughError):
        read(svg(body), ".svg", progress=stop)


BOMB = "".join(f'<!ENTITY l{i + 1} "{f"&l{i};" * 10}">' for i in range(9))
MANY = "".join(f'<g id="g{i + 1}">' + f'<use xlink:href="#g{i}"/>' * 10 + "</g>" for i in range(9))


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "empty"),
        (b"  \n", "empty"),
        (b"hello", "is not XML: syntax error at line 1, column 1"),
        (svg("<g>")[:-6], "at line 1"),
        (b"<html><path d='M0 0L1 1'/></html>", "outermost element is 'html', not svg"),
        (svg(""), "no path or shape"),
        (svg("<text>Words</text>"), "no path or shape to be read. Left out, as no curve: 1 text."),
        (gzip.compress(svg(""), mtime=0), "unpack it with gzip"),
        (b'<?xml version="1.0" encoding="klingon"?><svg/>', "encoding"),
        (f'<!DOCTYPE svg [<!ENTITY l0 "ha">{BOMB}]>{HEAD}>&l9;</svg>'.encode(), "could grow beyond measure"),
        (f'<!DOCTYPE s [<!ENTITY f SYSTEM "file:///etc/passwd">]>{HEAD}>&f;</svg>'.encode(), "not fetched"),
        (f'<!DOCTYPE s [<!ENTITY f "{"x" * 10**6}">]>{HEAD}>&f;</svg>'.encode(), "could grow beyond measure"),
        (svg("<g>" * 300 + "</g>" * 300), "nested more than 200 deep"),
        (svg("<g/>" * 1001), "more than 1,000 elements"),
        (
            svg('<g id="g0"><path d="M0 0L1 1"/></g>' + MANY + '<use xlink:href="#g9"/>'),
            "more than 500 elements",
        ),
        (svg(f'<path d="M0 0{"h1v1" * 300}"/>'), "more than 500 lines"),
        (svg('<g id="a"><use xlink:href="#b"/></g><g id="b"><use xlink:href="#a"/></g>'), "uses itself"),
        (svg('<path d="M0 0L1e999 1"/>'), "Line 1: coordinates must be numbers within"),
        (svg('<path d="M0 0l1 1a5 3 20 0 1 3 1e999l1 1"/>'), "Line 1: coordinates must be numbers within"),
        (svg('<polygon points="0 0 1e999 1 nan 3"/>'), "Line 1: coordinates must be numbers within"),
        (svg('<circle r="1e29" transform="scale(1e300)"/>'), "Line 1: coordinates must be"),
        (svg('<rect x="1e999" width="9" height="8" rx="2"/>'), "(rect: '1e999' is too large)"),
        (svg('<circle r="nan"/>'), "no path or shape"),
        (svg('<path d="M1e-200 0L2e-200 1e-200"/>'), "outlines without length"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_hostile_and_empty_files_are_refused_in_one_sentence(data, words, monkeypatch):
    monkeypatch.setattr("theditor.exchange.xml_tree.MAX_ELEMENTS", 1000)
    for limit in ("MAX_USED", "MAX_PIECES"):
        monkeypatch.setattr(f"theditor.exchange.svg_in.{limit}", 500)
    with pytest.raises(DrawingError) as told:
        read(data, ".svg")
    assert words in str(told.value)


def test_short_entities_as_drawing_programs_write_them_are_fine():
    data = f'<!DOCTYPE svg [<!ENTITY blue "#0000ff">]>{HEAD}><path stroke="&blue;" d="M0 0L1 1"/></svg>'
    assert read(data.encode(), ".svg").drawing[0].color == "#0000ff"


FORMS = [
    svg(NESTED, 'viewBox="0 0 100 50"'),
    svg('<path d="M0 0C1 2 3 2 4 0a5 3 20 0 1 3 4zm1 1q1 2 3 4t1 1h3v-2"/>'),
]
ODD = [
    b"1e999",
    b"nan",
    b"-",
    b"0",
    b"%",
    b'"',
    b"<",
    b">",
    b"&#1;",
    b"Z",
    b"M",
    b"use",
    b"e",
    b"1e-320",
    b"matrix(",
    b"\xff",
]
LONG = "THEDITOR_LONG_RUN" in os.environ


@pytest.mark.parametrize("seed", range(4 if not LONG else 400))
def test_damaged_files_are_read_or_refused(seed):
    chance = random.Random(seed)
    for _ in range(40):
        data = bytearray(chance.choice(FORMS))
        for _ in range(chance.randint(1, 6)):
            start = chance.randrange(len(data))
            end = min(start + chance.choice((0, 1, 1, 4, 30)), len(data))
            data[start:end] = chance.choice(
                [*ODD, bytes(data[start:end]) * 2, bytes([chance.randrange(256)])]
            )
        with suppress(DrawingError):
            imported = read(bytes(data), ".svg", Options(tolerance=1e-2))
            assert sum(len(item.curve.control_points) for item in imported.drawing) < 10_000
