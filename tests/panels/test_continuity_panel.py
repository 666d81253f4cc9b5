from functools import partial

import numpy as np
import pytest
from panel_hand import Hand, some_curve
from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QApplication

from theditor.drawing import Drawing, Item
from theditor.panels import continuity as module
from theditor.panels.continuity import EMPTY, MOST_LIVE, ContinuityPanel
from theditor.spline import JOINT_SLOPE_ZERO, Curve, continuity

DISPLAY, TIP = Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole
NUMBER, POSITION, JUMP, FIRST, SECOND, BEND, MEASURED, PROMISED = range(8)


@pytest.fixture
def panel(document, selection, show):
    return show(ContinuityPanel(document, selection), 900, 220)


@pytest.fixture
def hand(panel):
    return Hand(panel.table.viewport())


def cell(panel, row, column, role=DISPLAY):
    return panel.model.index(row, column).data(role)


def place(panel, row):
    return panel.table.visualRect(panel.model.index(row, POSITION)).center()


def marked_rows(panel):
    return [index.row() for index in panel.table.selectionModel().selectedRows()]


def test_every_joint_has_a_row_with_what_was_measured(panel, document):
    curve = document.drawing[0].curve
    assert panel.heading.text().startswith("9 joints, all C² as promised")
    assert panel.model.rowCount() == 9
    assert [cell(panel, row, NUMBER) for row in range(9)] == [str(n) for n in range(2, 11)]
    x, y = (float(part.replace("−", "-")) for part in cell(panel, 4, POSITION).strip("()").split(","))
    assert (x, y) == pytest.approx(tuple(curve.joints[5]), rel=1e-5)
    assert {cell(panel, row, MEASURED) for row in range(9)} == {"C² G²"}
    assert {cell(panel, row, PROMISED) for row in range(9)} == {"✓ C²"}
    assert cell(panel, 4, PROMISED, TIP) == str(continuity(curve)[4])


def test_a_quadratic_is_c1_and_its_curvature_jumps(panel, selection, document):
    selection.select(curve=1)
    curve = document.drawing[1].curve
    report = continuity(curve)
    assert panel.heading.text().startswith("13 joints, all C¹ as promised")
    jump = float(cell(panel, 5, BEND))
    assert jump == pytest.approx(abs(report.curvature_jump[5]), rel=0.06)
    assert jump > 0.01
    assert float(cell(panel, 5, SECOND)) > 1e-3
    assert cell(panel, 5, MEASURED) == "C¹ G¹"


def test_a_joint_without_velocity_is_noted_and_breaks_no_promise(panel, document):
    still = some_curve([JOINT_SLOPE_ZERO] * 5, degree=2)
    document.start(Drawing([Item(still)]))
    assert panel.heading.text().endswith("the curve stands still at 2.")
    assert cell(panel, 0, PROMISED) == "✓ C¹, still"
    assert cell(panel, 0, MEASURED) == "C¹ G⁰"
    assert cell(panel, 0, BEND) == "—"
    assert "stands still" in cell(panel, 0, PROMISED, TIP)


def test_a_broken_promise_is_seen(panel, document, monkeypatch):
    # With no room for rounding, the measured jumps themselves break the promise.
    monkeypatch.setattr(module, "continuity", partial(continuity, tolerance=0.0))
    document.start(Drawing())
    points = [[-2.1, 7.0], [1.0, -9.3], [5.2, 4.5], [6.8, -6.5], [-8.2, 7.1], [-9.5, 0.8]]
    document.start(Drawing([Item(Curve(points, [0.6, 2.1, -2.7, -1.5, 5.0, 4.8]))]))
    assert panel.heading.text().startswith("2 of 2 joints fail the promised C² within 0 of the size")
    assert [cell(panel, row, PROMISED) for row in (0, 1)] == ["✗ C² fails"] * 2


def test_what_a_low_lambda_does_is_noted_under_the_joints_own_number(panel, document):
    document.start(Drawing([Item(some_curve([0, 0, -5, 0, 0], degree=2))]))
    assert cell(panel, 0, NUMBER) == "2"
    assert cell(panel, 0, PROMISED) == "✓ C¹, reversed"
    assert "λ₂ = −5 is below −2.648…: the velocity reverses at joint 2" in cell(panel, 0, PROMISED, TIP)
    assert "as promised within 1e−9 of the size of the terms" in panel.heading.text()


def test_the_position_takes_the_room_that_is_left_and_no_other_is_cut(panel):
    header, width = panel.table.horizontalHeader(), panel.table.fontMetrics().horizontalAdvance
    longest = {
        POSITION: "(−1234567, −1234567)",
        SECOND: "1e−16",
        BEND: "1e−16",
        PROMISED: "✓ C¹, reversed",
    }
    for column, text in longest.items():
        assert header.sectionSize(column) > width(text) + 20
    assert header.length() == panel.table.viewport().width()


def test_a_click_selects_what_shapes_the_joint_and_shows_it(panel, hand, selection, qtbot):
    with qtbot.waitSignal(panel.hovered) as shown:
        hand.click_at(place(panel, 3))
    assert (selection.points, selection.segments, shown.args) == ({5}, set(), [4.0])
    qtbot.keyClick(panel.table, Qt.Key.Key_Down)
    assert selection.points == {6}
    selection.select(curve=1)
    hand.click_at(place(panel, 0))
    assert (selection.points, selection.segments) == (set(), {0, 12})
    hand.click_at(place(panel, 2))
    assert selection.segments == {1, 2}


def test_pointing_at_a_row_shows_the_joint_until_the_pointer_leaves(panel, hand):
    shown = []
    panel.hovered.connect(shown.append)
    for row in (1, 2):
        at = place(panel, row)
        hand.move(at.x(), at.y(), held=Qt.MouseButton.NoButton)
    QApplication.sendEvent(panel.table.viewport(), QEvent(QEvent.Type.Leave))
    assert shown == [2.0, 3.0, None]


def test_the_row_of_what_is_selected_on_the_canvas_is_marked(panel, selection):
    selection.select(points={4})
    assert marked_rows(panel) == [2]
    selection.select(points={4, 5})
    assert marked_rows(panel) == []
    selection.select(points={0})
    assert marked_rows(panel) == [], "an inactive λ has no joint"
    selection.select(curve=1, segments={0, 12})
    assert marked_rows(panel) == [0]
    selection.select(segments={3, 4})
    assert marked_rows(panel) == [4]
    assert selection.segments == {3, 4}, "what marks a row changes no selection"


def test_rows_follow_a_drag(panel, document):
    before = cell(panel, 4, POSITION)
    gesture = document.begin("Move")
    gesture.preview(document.drawing.with_curve(0, document.drawing[0].curve.with_points(6, [3.0, 3.0])))
    during = cell(panel, 4, POSITION)
    gesture.cancel()
    assert during != before
    assert cell(panel, 4, POSITION) == before


def test_of_a_very_long_curve_only_what_changed_is_measured_again(panel, document):
    long = Curve(np.c_[np.arange(MOST_LIVE + 9), np.arange(MOST_LIVE + 9) % 2])
    document.start(Drawing([Item(long)]))
    assert panel.model.rowCount() == MOST_LIVE + 5
    told = []
    panel.model.dataChanged.connect(lambda first, last: told.append((first.row(), last.row())))
    gesture = document.begin("Move")
    moved = long.with_points(5, [5.0, 9.0])
    gesture.preview(document.drawing.with_curve(0, moved))
    assert told == [(1, 5)]
    assert cell(panel, 3, POSITION) == f"({moved.joints[4][0]:g}, {moved.joints[4][1]:g})"
    gesture.cancel()
    # Where all of it changes, it waits until the hand lets go.
    gesture, report = document.begin("Move"), panel.model.report
    gesture.preview(document.drawing.with_curve(0, long.with_(control_points=long.control_points + 1)))
    assert panel.model.report is report
    gesture.commit()
    assert panel.model.report is not report
    assert cell(panel, 3, POSITION) == f"({long.joints[4][0] + 1:g}, {long.joints[4][1] + 1:g})"


def test_nothing_is_measured_while_nobody_sees_it(document, selection, qtbot, monkeypatch):
    measured = []
    monkeypatch.setattr(module, "continuity", lambda curve: measured.append(curve) or continuity(curve))
    panel = ContinuityPanel(document, selection)
    qtbot.addWidget(panel)
    document.apply_curve("Reverse", 0, document.drawing[0].curve.reversed())
    assert measured == []
    with qtbot.waitExposed(panel):
        panel.show()
    assert measured == [document.drawing[0].curve]
    assert panel.model.rowCount() == 9


def test_without_a_joint_or_a_curve_it_says_so(panel, document):
    document.start(Drawing([Item(Curve([[0, 0], [1, 1]], ends="clamped"))]))
    assert panel.heading.text() == "No joints: the curve is one segment."
    document.start(Drawing())
    assert panel.heading.text() == EMPTY
    assert panel.model.rowCount() == 0
