import pickle

import pytest
from drawing_strategies import drawings
from hypothesis import given

from theditor.drawing import Drawing, DrawingError, Item
from theditor.spline import Curve

CURVE = Curve([[0, 0], [1, 2], [3, 2], [4, 0]])
A, B, C = (Item(CURVE, name) for name in "ABC")


@given(drawings)
def test_a_drawing_is_a_value(drawing):
    twin = pickle.loads(pickle.dumps(drawing))
    assert twin == drawing
    assert hash(twin) == hash(drawing)
    assert type(twin) is Drawing


def test_edits_make_new_drawings_and_leave_the_old_one():
    drawing = Drawing([A, B])
    bent = CURVE.with_lambdas(1, 0.5)
    assert drawing.with_item(1, C) == Drawing([A, C])
    assert drawing.with_curve(0, bent) == Drawing([A.with_(curve=bent), B])
    assert drawing.inserted(0, C) == Drawing([C, A, B])
    assert drawing.inserted(2, C) == Drawing([A, B, C])
    assert drawing.without(0) == Drawing([B])
    assert drawing == Drawing([A, B])
    with pytest.raises(IndexError):
        drawing.without(2)


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("name", "two\nlines"),
        ("name", "bell\x07"),
        ("name", "half a pair \ud800"),
        ("name", "n" * 201),
        ("name", None),
        ("color", "red"),
        ("color", "#12345"),
        ("color", "#1234567"),
        ("color", "#12345６"),
        ("width", 0.0),
        ("width", 100.5),
        ("width", float("nan")),
        ("width", float("inf")),
    ],
)
def test_an_item_refuses_what_no_file_may_hold(field, value):
    with pytest.raises(DrawingError, match=field.replace("color", "colour")):
        A.with_(**{field: value})


def test_a_drawing_refuses_what_is_not_an_item():
    with pytest.raises(TypeError, match="number 1 is a Curve"):
        Drawing([A, CURVE])
