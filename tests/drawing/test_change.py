import pickle
import tracemalloc
import weakref

import numpy as np
from drawing_strategies import curves, drawings, items
from hypothesis import given
from hypothesis import strategies as st

from theditor.drawing import Drawing, Item, difference, encode
from theditor.spline import Curve


@st.composite
def edited(draw, drawing):
    """A drawing made from another by a few edits of the kinds that people make."""
    for kind in draw(
        st.lists(st.sampled_from(["insert", "remove", "swap", "style", "rows", "ends", "curve", "copy"]))
    ):
        if kind == "insert" or not drawing:
            drawing = drawing.inserted(draw(st.integers(0, len(drawing))), draw(items))
            continue
        index = draw(st.integers(0, len(drawing) - 1))
        item = drawing[index]
        curve = item.curve
        if kind == "remove":
            drawing = drawing.without(index)
        elif kind == "swap":
            drawing = drawing.without(index).inserted(draw(st.integers(0, len(drawing) - 1)), item)
        elif kind == "copy":
            drawing = drawing.inserted(index, item)
        elif kind == "style":
            drawing = drawing.with_item(index, item.with_(color="#010203", visible=not item.visible))
        elif kind == "curve":
            drawing = drawing.with_curve(index, draw(curves()))
        elif kind == "ends":
            closed = len(curve.lambdas) >= 3 and not curve.closed
            drawing = drawing.with_curve(index, curve.with_(closed=closed, ends="clamped"))
        else:
            row = draw(st.integers(0, len(curve.lambdas) - 1))
            curve = curve.with_points(row, draw(st.sampled_from([0.0, -0.0, 1.5]))).with_lambdas(row, 0.25)
            drawing = drawing.with_curve(index, curve)
    return drawing


@given(st.data(), drawings)
def test_a_change_leads_to_and_fro_bit_for_bit(data, before):
    after = data.draw(drawings | edited(before))
    change = difference(before, after)
    # The file's text tells all floats apart, so equal bytes are equal bits.
    assert encode(change.apply(before)) == encode(after)
    assert encode(change.revert(after)) == encode(before)
    assert change.apply(before) == after
    assert change.revert(after) == before


def test_a_change_keeps_only_the_rows_that_differ():
    count = 100_000
    long = Curve(np.random.default_rng(1).normal(size=(count, 2)), 0.5)
    before = Drawing([Item(long), Item(long, "other")])
    moved = long.with_points([7, 70_000], [[1, 2], [3, 4]]).with_lambdas(3, 1.0)
    change = difference(before, before.with_curve(1, moved))
    assert len(pickle.dumps(change)) < 2_000

    tracemalloc.start()
    try:
        after = change.apply(before)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert after[1].curve == moved
    assert after[0] is before[0]
    assert peak < 1.2 * (moved.control_points.nbytes + moved.lambdas.nbytes)


def test_a_change_lets_go_of_both_drawings():
    long = Curve(np.random.default_rng(1).normal(size=(1000, 2)), 0.5)
    before = Drawing([Item(long)])
    after = before.with_curve(0, long.with_lambdas(3, 1.0))
    arrays = [weakref.ref(part) for part in (long.control_points, long.lambdas, after[0].curve.lambdas)]
    change = difference(before, after)
    del long, before, after
    assert [ref() for ref in arrays] == [None, None, None]
    assert change is not None


def test_a_change_keeps_only_the_items_that_differ():
    drawing = Drawing(Item(Curve(np.random.default_rng(i).normal(size=(500, 2)))) for i in range(50))
    short = Curve([[0, 0], [1, 1], [2, 0], [3, 1]])
    styled = drawing.with_item(3, drawing[3].with_(color="#ff0000")).with_item(
        40, drawing[40].with_(visible=False)
    )
    inserted = drawing.inserted(45, Item(short)).inserted(2, Item(short))
    for after in (styled, inserted):
        assert len(pickle.dumps(difference(drawing, after))) < 2_000
    assert len(pickle.dumps(difference(drawing, drawing))) < 100
    # Even a drawing loaded anew, which shares no object with the old one.
    assert len(pickle.dumps(difference(drawing, pickle.loads(pickle.dumps(drawing))))) < 100
