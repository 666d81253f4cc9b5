"""Tables follow edits row by row as if they were made anew, keep Qt's rules, and ask little at 10⁵ rows."""

import sys
from collections import Counter
from contextlib import contextmanager

import numpy as np
import pytest
from PySide6.QtCore import QAbstractListModel
from PySide6.QtTest import QAbstractItemModelTester
from PySide6.QtWidgets import QApplication

from theditor.drawing import Drawing, Item
from theditor.model import Document
from theditor.panels import SegmentsPanel
from theditor.panels.continuity import ContinuityPanel
from theditor.panels.points import PointsPanel
from theditor.spline import Curve

PANELS = [PointsPanel, SegmentsPanel, ContinuityPanel]


@pytest.fixture
def document(qapp, request):
    count = request.param
    steps = np.random.default_rng(3).normal(size=(count, 2))
    return Document(Drawing([Item(Curve(steps.cumsum(axis=0), np.arange(count) % 3 / 2))]))


def texts(model):
    columns = range(1 if isinstance(model, QAbstractListModel) else model.columnCount())
    return [[model.index(row, column).data() for column in columns] for row in range(model.rowCount())]


def edits(curve):
    """Edits of one point, of one λ, of scattered λ, of all points, and of how many there are."""
    count = len(curve.lambdas)
    yield curve.with_points(7, curve.control_points[7] + 3.0)
    yield curve.with_lambdas(count - 9, 7.0)
    yield curve.with_lambdas(np.arange(10, count, 17), 0.25)
    yield curve.with_(control_points=curve.control_points[::-1])
    yield curve.with_(control_points=curve.control_points[5:], lambdas=curve.lambdas[5:])
    yield curve.with_(closed=True)


@pytest.mark.parametrize("kind", PANELS)
@pytest.mark.parametrize("document", [60], indirect=True)
def test_a_table_follows_edits_as_if_it_were_made_anew(kind, document, selection, show):
    panel = show(kind(document, selection), 500, 300)
    mode = QAbstractItemModelTester.FailureReportingMode.Warning
    tester = QAbstractItemModelTester(panel.model, mode, panel.model)
    told, resets = [], []
    panel.model.dataChanged.connect(lambda first, last: told.append((first.row(), last.row())))
    panel.model.modelReset.connect(lambda: resets.append(True))
    for new in edits(document.drawing[0].curve):
        old = texts(panel.model)
        told.clear()
        resets.clear()
        document.apply_curve("Edit", 0, new)
        shown = texts(panel.model)
        fresh = show(kind(document, selection), 500, 300)
        assert shown == texts(fresh.model)
        fresh.close()
        if not resets:
            changed = [row for row, (a, b) in enumerate(zip(old, shown, strict=True)) if a != b]
            assert all(any(first <= row <= last for first, last in told) for row in changed)
    assert tester.model() is panel.model


@pytest.mark.parametrize("kind", PANELS)
@pytest.mark.parametrize("document", [100_000], indirect=True)
def test_of_a_hundred_thousand_rows_only_those_in_sight_are_asked_about(kind, document, selection, show):
    panel = show(kind(document, selection), 500, 300)
    told = []
    panel.model.dataChanged.connect(lambda first, last: told.append((first.row(), last.row())))
    curve = document.drawing[0].curve
    moved = curve.with_points(500, curve.control_points[500] + 3.0)
    shorter = curve.with_(control_points=curve.control_points[5:], lambdas=curve.lambdas[5:])
    with asking() as asked:
        document.apply_curve("Move point", 0, moved)
        panel.repaint()
        document.apply_curve("Shorten", 0, shorter)
        QApplication.processEvents()
    assert sum(last - first + 1 for first, last in told) <= 6
    assert 0 < asked["data"] < 3000
    assert asked["rowCount"] < 3000


@contextmanager
def asking():
    """Count the calls of Python functions by their names."""
    asked = Counter()

    def note(frame, event, argument):
        if event == "call":
            asked[frame.f_code.co_name] += 1

    sys.setprofile(note)
    try:
        yield asked
    finally:
        sys.setprofile(None)
