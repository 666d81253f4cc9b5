"""Whole curves made others: what is selected on them, and what is said."""

import numpy as np
import pytest

from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection, reshape
from theditor.spline import Curve

POINTS = [[0.0, 0.0], [1.0, 3.0], [3.0, 3.0], [5.0, -1.0], [7.0, 0.0], [8.0, 2.0]]


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("closed", [False, True])
def test_reversing_keeps_what_is_selected(qapp, degree, closed):
    curve = Curve(POINTS, [0, 1, 0.5, 2, 0, 1], degree, closed)
    document = Document(Drawing([Item(curve, "a"), Item(curve, "b"), Item(curve, "c", locked=True)]))
    selection = Selection(document)
    selection.select_across({0: [1, 5], 1: [2], 2: []}, segments={0, 2})
    places = [curve.control_points[points] for points in selection.across.values()]
    middles = curve(np.array([0.5, 2.5]))
    assert reshape.reverse(document, selection) == "2 curves run the other way now; the shape is the same"
    for (i, points), before in zip(selection.across.items(), places, strict=True):
        now = document.drawing[i].curve.control_points[points]
        assert sorted(now.tolist()) == sorted(before.tolist())
    now = document.drawing[0].curve(np.array(sorted(selection.segments)) + 0.5)
    np.testing.assert_allclose(np.sort(now, axis=0), np.sort(middles, axis=0), atol=1e-12)
    assert document.drawing[2].curve is curve
    assert document.undo_stack.undoText() == "Reverse 2 curves"


def test_locked_curves_stay_and_the_others_change_in_one_step(qapp):
    curve = Curve(POINTS)
    document = Document(Drawing([Item(curve, "a"), Item(curve, "b", locked=True), Item(curve, "c")]))
    selection = Selection(document)
    selection.select_across({0: [], 1: [], 2: []})
    said = []
    reshape.set_ends(document, selection, "clamped", said.append)
    (told,) = said
    assert told.startswith("Clamped 2 curves; the shape changed by at most ")
    assert [item.curve.ends for item in document.drawing] == ["clamped", "free", "clamped"]
    assert (document.undo_stack.count(), document.undo_stack.undoText()) == (1, "Clamp 2 curves")
