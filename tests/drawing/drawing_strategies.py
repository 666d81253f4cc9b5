"""Arbitrary drawings, within what the format can hold."""

import numpy as np
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from theditor.drawing import Drawing, Item
from theditor.spline import INTERPOLATING, MAX_COORDINATE, MAX_LAMBDA, Curve, fewest_points

_coordinates = st.floats(-MAX_COORDINATE, MAX_COORDINATE)
_lambdas = st.sampled_from([0.0, 1.0, *INTERPOLATING.values()]) | st.floats(-MAX_LAMBDA, MAX_LAMBDA)
_letters = st.characters(exclude_categories=["Cc", "Cs", "Zl", "Zp"])


@st.composite
def curves(draw):
    degree, closed, ends = (
        draw(st.sampled_from([2, 3])),
        draw(st.booleans()),
        draw(st.sampled_from(["free", "clamped"])),
    )
    count = draw(st.integers(fewest_points(degree, closed, ends), 8))
    points = draw(arrays(np.float64, (count, draw(st.sampled_from([2, 3]))), elements=_coordinates))
    return Curve(points, draw(arrays(np.float64, count, elements=_lambdas)), degree, closed, ends)


items = st.builds(
    Item,
    curve=curves(),
    name=st.text(_letters, max_size=12),
    color=st.from_regex("#[0-9A-Fa-f]{6}", fullmatch=True),
    width=st.floats(0.1, 100.0),
    visible=st.booleans(),
    locked=st.booleans(),
)
drawings = st.builds(Drawing, st.lists(items, max_size=4))
