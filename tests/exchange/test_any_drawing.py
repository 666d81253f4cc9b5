"""Whatever a drawing holds, every format writes it, soundly and within what it says."""

import io
import xml.etree.ElementTree as ET
from dataclasses import replace

import ezdxf
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from theditor.drawing import Drawing, Item
from theditor.exchange import PARTS, Options, write
from theditor.exchange.embedded import extract
from theditor.spline import INTERPOLATING, MAX_COORDINATE, MAX_LAMBDA, Curve, fewest_points

coordinates = (
    st.sampled_from([0.0, -0.0, 1.0, MAX_COORDINATE, 1e-300, 5e-324])
    | st.floats(-MAX_COORDINATE, MAX_COORDINATE)
    | st.integers(-3, 3).map(float)
)
lambdas = st.sampled_from([0.0, 1.0, *INTERPOLATING.values()]) | st.floats(-MAX_LAMBDA, MAX_LAMBDA)


@st.composite
def curves(draw):
    degree, closed = draw(st.sampled_from([2, 3])), draw(st.booleans())
    ends = draw(st.sampled_from(["free", "clamped"]))
    count = draw(st.integers(fewest_points(degree, closed, ends), 6))
    points = draw(arrays(np.float64, (count, draw(st.sampled_from([2, 3]))), elements=coordinates))
    return Curve(points, draw(arrays(np.float64, count, elements=lambdas)), degree, closed, ends)


names = st.text(st.characters(exclude_categories=["Cc", "Cs", "Zl", "Zp"]), max_size=6)
items = st.builds(Item, curves(), names, width=st.floats(0.1, 100), visible=st.booleans())
drawings = st.lists(items, max_size=3).map(Drawing)
options = st.builds(
    Options,
    tolerance=st.sampled_from([1e-2, 1e-4, 1e-7]),
    size=st.none() | st.floats(1, 5000),
    dpi=st.sampled_from([1, 96, 1200]),
    show=st.sets(st.sampled_from(PARTS)),
    print_style=st.booleans(),
    sampling=st.sampled_from(["parameter", "length", "tolerance"]),
    samples=st.integers(1, 5),
    tangent=st.booleans(),
    curvature=st.booleans(),
)


@settings(max_examples=25)
@given(drawings, options)
def test_svg_holds_it_all(drawing, options):
    written = write(drawing, ".svg", options)
    root = ET.fromstring(written.data)
    numbers = [float(number) for number in root.get("viewBox").split()]
    assert np.isfinite(numbers).all()
    assert min(numbers[2:]) > 0
    assert b"nan" not in written.data.split(b"</metadata>")[1]
    found = extract(written.data)
    assert found.drawing == drawing
    assert found.current
    assert np.isfinite(written.deviation)


@settings(max_examples=15)
@given(drawings, options)
def test_dxf_is_sound(drawing, options):
    written = write(drawing, ".dxf", options)
    document = ezdxf.read(io.StringIO(written.data.decode()))
    assert not document.audit().errors
    layers = {entity.dxf.layer for entity in document.modelspace()}
    assert len(layers) == sum(item.visible for item in drawing)
    assert all(document.layers.has_entry(layer) for layer in layers)


@settings(max_examples=15)
@given(drawings, options)
def test_tables_and_tex_hold_numbers(drawing, options):
    table = write(drawing, ".csv", options).data.decode()
    assert "nan" not in table.replace(table.split("\n")[0], "") or any("nan" in item.name for item in drawing)
    tex = write(drawing, ".tex", options).data.decode()
    code = "\n".join(line for line in tex.splitlines() if not line.startswith("%"))
    assert "nan" not in code
    assert "inf" not in code


@pytest.mark.usefixtures("qapp")
def test_pictures_are_painted():
    @settings(max_examples=12)
    @given(drawings, options)
    def painted(drawing, options):
        options = replace(options, size=min(options.size or 300, 300))
        assert write(drawing, ".pdf", options).data.startswith(b"%PDF-")
        assert write(drawing, ".png", options).data.startswith(b"\x89PNG")

    painted()
