"""Random editing of a document: whatever happens, undo goes back exactly and a file holds everything.

Short and derandomised by default; ``THEDITOR_LONG_RUN=1 pytest tests/model/test_editing_machine.py`` goes on at random.
"""

import os
import tempfile
from pathlib import Path

import numpy as np
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule

from theditor.drawing import Drawing, Item, load, save
from theditor.model import Document, Selection, reshape
from theditor.spline import Curve, Mode, fewest_points, insert, pull, remove

LONG = bool(os.environ.get("THEDITOR_LONG_RUN"))

coordinates = st.floats(-100, 100, width=32)
lambdas = st.one_of(st.sampled_from([0.0, 1.0, -1.0]), st.floats(-20, 20, width=32))
picks = st.integers(0, 10**6)


@st.composite
def curves(draw):
    degree, closed = draw(st.sampled_from([2, 3])), draw(st.booleans())
    ends = draw(st.sampled_from(["free", "clamped"]))
    least = fewest_points(degree, closed, ends)
    points = draw(st.lists(st.tuples(coordinates, coordinates), min_size=least, max_size=least + 4))
    values = draw(st.lists(lambdas, min_size=len(points), max_size=len(points)))
    return Curve(points, values, degree=degree, closed=closed, ends=ends)


class Editing(RuleBasedStateMachine):
    """A document under a hand that does not know what it wants."""

    def __init__(self):
        super().__init__()
        self.folder = tempfile.TemporaryDirectory(prefix="theditor-machine-")
        self.path = Path(self.folder.name) / "drawing.json"

    def teardown(self):
        self.document.settle()
        stack, last = self.document.undo_stack, self.document.drawing
        done = stack.index()
        stack.setIndex(0)
        assert self.document.drawing == self.first
        stack.setIndex(done)
        assert self.document.drawing == last
        self.folder.cleanup()

    @initialize(items=st.lists(curves(), max_size=3))
    def begin(self, items):
        self.first = Drawing([Item(curve, name=f"curve {i}") for i, curve in enumerate(items)])
        self.document = Document(self.first)
        self.selection = Selection(self.document)
        self.save()

    @property
    def drawing(self):
        return self.document.drawing

    def chosen(self, pick):
        index = pick % len(self.drawing)
        return index, self.drawing[index].curve

    @rule(curve=curves(), pick=picks)
    def add(self, curve, pick):
        self.document.apply("Add", self.drawing.inserted(pick % (len(self.drawing) + 1), Item(curve)))

    @precondition(lambda self: len(self.drawing))
    @rule(pick=picks)
    def delete(self, pick):
        self.document.apply("Delete", self.drawing.without(pick % len(self.drawing)))

    @precondition(lambda self: len(self.drawing))
    @rule(pick=picks, place=st.tuples(coordinates, coordinates), commit=st.booleans())
    def drag(self, pick, place, commit):
        index, curve = self.chosen(pick)
        gesture = self.document.begin("Move")
        for share in (0.5, 1.0):
            moved = curve.with_points([pick % len(curve.control_points)], [np.multiply(place, share)])
            gesture.preview(gesture.before.with_curve(index, moved))
        gesture.commit() if commit else gesture.cancel()

    @precondition(lambda self: len(self.drawing))
    @rule(pick=picks, lam=lambdas, merge=st.booleans())
    def shape(self, pick, lam, merge):
        index, curve = self.chosen(pick)
        shaped = curve.with_lambdas([pick % len(curve.lambdas)], [lam])
        self.document.apply_curve("Change λ", index, shaped, merge="run" if merge else None)

    @precondition(lambda self: len(self.drawing))
    @rule(pick=picks, mode=st.sampled_from([Mode.TRIGONOMETRIC, Mode.HYPERBOLIC, Mode.INTERPOLATING]))
    def toggle(self, pick, mode):
        index, curve = self.chosen(pick)
        self.document.apply_curve("Mode", index, curve.with_mode(pick % curve.segment_count, mode))

    @precondition(lambda self: len(self.drawing))
    @rule(pick=picks, share=st.floats(0.1, 0.9))
    def pull(self, pick, share):
        index, curve = self.chosen(pick)
        u = share * curve.segment_count
        self.document.apply_curve("Pull", index, pull(curve, u, curve(u) + 0.5).curve)

    @precondition(lambda self: len(self.drawing))
    @rule(pick=picks, share=st.floats(0.1, 0.9))
    def insert(self, pick, share):
        index, curve = self.chosen(pick)
        if len(curve.control_points) < 10:
            self.document.apply_curve("Insert", index, insert(curve, share * curve.segment_count).curve)

    @precondition(lambda self: len(self.drawing))
    @rule(pick=picks, refit=st.booleans())
    def remove(self, pick, refit):
        index, curve = self.chosen(pick)
        count = len(curve.control_points)
        if count > fewest_points(curve.degree, curve.closed, curve.ends):
            self.document.apply_curve("Remove", index, remove(curve, [pick % count], refit=refit).curve)

    @rule(pick=picks, points=st.frozensets(st.integers(0, 12)), segments=st.frozensets(st.integers(0, 12)))
    def select(self, pick, points, segments):
        self.selection.select(curve=pick % max(len(self.drawing), 1), points=points, segments=segments)

    @rule(
        points=st.dictionaries(st.integers(0, 4), st.frozensets(st.integers(0, 12)), max_size=3), pick=picks
    )
    def select_across(self, points, pick):
        self.selection.select_across(points, pick % max(len(self.drawing), 1))

    @rule(offset=st.tuples(coordinates, coordinates), commit=st.booleans())
    def drag_all(self, offset, commit):
        chosen = self.selection.movable
        gesture = self.document.begin("Move all")
        before = gesture.before
        moved = {i: before[i].curve.control_points[of] + offset for i, of in chosen.items()}
        curves = {i: before[i].curve.with_points(of, moved[i]) for i, of in chosen.items()}
        gesture.preview(before.with_curves(curves))
        gesture.commit() if commit else gesture.cancel()
        assert {i: of.tolist() for i, of in self.selection.movable.items()} == {
            i: of.tolist() for i, of in chosen.items()
        }

    @precondition(lambda self: len(self.drawing))
    @rule(ends=st.sampled_from(["free", "clamped", "closed"]))
    def reshape(self, ends):
        if ends == "closed":
            reshape.close(self.document, self.selection, str)
        else:
            reshape.set_ends(self.document, self.selection, ends, str)

    @precondition(lambda self: len(self.drawing) > 1)
    @rule(pick=picks, place=picks)
    def reorder(self, pick, place):
        row, item = pick % len(self.drawing), self.selection.item
        moved = self.drawing.without(row).inserted(place % len(self.drawing), self.drawing[row])
        self.document.apply("Reorder", moved)
        assert self.selection.item is item

    @rule()
    def undo(self):
        self.document.undo()

    @rule()
    def redo(self):
        self.document.redo()

    @rule()
    def save(self):
        self.document.save(self.path)
        assert self.document.is_clean
        self.saved = self.drawing
        assert load(self.path) == self.drawing

    @rule(items=st.lists(curves(), max_size=2), known=st.booleans())
    def reload(self, items, known):
        theirs = self.drawing if known else Drawing(map(Item, items))
        save(theirs, self.path)
        assert self.document.differs_on_disk == (load(self.path) != self.saved)
        self.document.reload()
        self.saved = self.drawing
        assert self.document.drawing == theirs
        assert self.document.is_clean
        assert not self.document.differs_on_disk

    @invariant()
    def the_selection_is_on_the_drawing(self):
        item = self.selection.item
        assert (item is None) == (len(self.drawing) == 0)
        if item is not None:
            assert all(i < len(item.curve.control_points) for i in self.selection.points)
            assert all(s < item.curve.segment_count for s in self.selection.segments)
            assert self.selection.curve in self.selection.curves
        for i, points in self.selection.across.items():
            assert (np.diff(points) > 0).all()
            assert points[0] >= 0
            assert points[-1] < len(self.drawing[i].curve.control_points)

    @invariant()
    def every_value_is_valid(self):
        for item in self.drawing:
            assert np.isfinite(item.curve.control_points).all()
            assert np.isfinite(item.curve.sample(2)).all()


TestEditing = Editing.TestCase
TestEditing.settings = settings(
    max_examples=400 if LONG else 25,
    stateful_step_count=60 if LONG else 25,
    derandomize=not LONG,
    deadline=None,
)
