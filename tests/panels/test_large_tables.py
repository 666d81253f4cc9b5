"""Tables follow edits row by row as if they were made anew, keep Qt's rules, and ask little at 10⁵ rows."""

import numpy as np
import pytest
from PySide6.QtCore import QAbstractListModel, Qt
from PySide6.QtTest import QAbstractItemModelTester

from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection
from theditor.model.point_table import PointTable
from theditor.panels import SegmentsPanel
from theditor.panels.continuity import ContinuityPanel
from theditor.panels.continuity_model import ContinuityModel
from theditor.panels.points import PointsPanel
from theditor.panels.segment_model import SegmentModel
from theditor.spline import Curve

PANELS = [PointsPanel, SegmentsPanel, ContinuityPanel]


def documents(count):
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
def test_a_table_follows_edits_as_if_it_were_made_anew(kind, show):
    document = documents(60)
    panel = show(kind(document, Selection(document)), 500, 300)
    tester = QAbstractItemModelTester(panel.model, QAbstractItemModelTester.FailureReportingMode.Warning)
    told, resets = [], []
    panel.model.dataChanged.connect(lambda first, last, _: told.append((first.row(), last.row())))
    panel.model.modelReset.connect(lambda: resets.append(True))
    for new in edits(document.drawing[0].curve):
        old = texts(panel.model)
        told.clear()
        resets.clear()
        document.apply_curve("Edit", 0, new)
        shown = texts(panel.model)
        fresh = show(kind(document, Selection(document)), 500, 300)
        assert shown == texts(fresh.model)
        fresh.close()
        if not resets:
            changed = [row for row, (a, b) in enumerate(zip(old, shown, strict=True)) if a != b]
            assert all(any(first <= row <= last for first, last in told) for row in changed)
    assert tester.model() is panel.model


@pytest.mark.parametrize("kind", PANELS)
def test_of_a_hundred_thousand_rows_an_edit_asks_only_about_those_in_sight(kind, show, monkeypatch):
    document = documents(100_000)
    asked = set()
    model = {PointsPanel: PointTable, SegmentsPanel: SegmentModel, ContinuityPanel: ContinuityModel}[kind]
    data = model.data

    def noted(self, index, role=Qt.ItemDataRole.DisplayRole):
        asked.add(index.row())
        return data(self, index, role)

    monkeypatch.setattr(model, "data", noted)
    panel = show(kind(document, Selection(document)), 500, 300)
    told = []
    panel.model.dataChanged.connect(lambda first, last, _: told.append((first.row(), last.row())))
    curve = document.drawing[0].curve
    document.apply_curve("Move point", 0, curve.with_points(500, curve.control_points[500] + 3.0))
    panel.repaint()
    document.apply_curve(
        "Shorten", 0, curve.with_(control_points=curve.control_points[5:], lambdas=curve.lambdas[5:])
    )
    panel.repaint()
    assert sum(last - first + 1 for first, last in told) <= 6
    assert 0 < len(asked) < 60
