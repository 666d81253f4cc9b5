"""The point table, by keys and mouse."""

import numpy as np
import pytest
from panel_hand import CTRL, LEFT, NONE, SHIFT, some_curve
from PySide6.QtCore import QItemSelectionModel, Qt
from PySide6.QtGui import QGuiApplication, QKeySequence
from PySide6.QtWidgets import QApplication, QLineEdit

from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection
from theditor.panels.points import PointsPanel
from theditor.spline import Curve

KEY, KEYS = Qt.Key, QKeySequence.StandardKey
X, Y, LAMBDA, MODE = range(4)


@pytest.fixture
def panel(document, selection, show):
    panel = show(PointsPanel(document, selection), 640, 320)
    panel.said = []
    panel.announce.connect(panel.said.append)
    return panel


@pytest.fixture
def click(panel, qtbot):
    """Click a cell, with modifier keys as the whole application knows them: the table asks it for them."""

    def click(row, column, keys=NONE):
        place = panel.table.visualRect(panel.model.index(row, column)).center()
        qtbot.mouseClick(panel.table.viewport(), LEFT, keys, place)

    return click


@pytest.fixture
def curve(document):
    return lambda: document.drawing[0].curve


def shown(panel, row, column):
    return panel.model.index(row, column).data()


def retype(qtbot, panel, text):
    """Type into the current cell as a person does: the first key opens the editor."""
    table = panel.table
    qtbot.keyClick(table.viewport(), KEY.Key_F2)
    editor = table.findChild(QLineEdit)
    editor.selectAll()
    qtbot.keyClicks(editor, text)
    enter(qtbot, editor)


def enter(qtbot, editor):
    qtbot.keyClick(editor, KEY.Key_Return)
    QApplication.processEvents()  # the table takes the text once the key has been dealt with


def test_every_point_has_a_row_with_its_numbers_and_its_segment(panel, curve):
    assert panel.model.rowCount() == 13
    titles = [panel.model.headerData(c, Qt.Orientation.Horizontal) for c in range(4)]
    assert titles == ["x", "y", "λ", "Segment"]
    assert panel.model.headerData(12, Qt.Orientation.Vertical) == "P₁₂"
    for row, point in enumerate(curve().control_points):
        values = [float(shown(panel, row, c).replace("−", "-")) for c in (X, Y)]
        assert values == pytest.approx(point.tolist(), rel=1e-5, abs=1e-6)
    assert [shown(panel, row, MODE) for row in (0, 1, 3, 5, 12)] == [
        "",
        "trigonometric",
        "interpolating",
        "hyperbolic",
        "",
    ]


def test_typing_over_a_cell_is_one_step_and_undo_brings_the_old_back(panel, document, curve, click, qtbot):
    before = curve()
    click(2, Y)
    qtbot.keyClicks(panel.table.viewport(), "2")
    editor = panel.table.findChild(QLineEdit)
    assert editor.accessibleName() == "y of P₂"
    qtbot.keyClicks(editor, ",5")
    enter(qtbot, editor)
    assert curve() == before.with_points([2], [[before.control_points[2, 0], 2.5]])
    assert document.undo_stack.undoText() == "Change y of P₂"
    document.undo()
    assert curve() == before
    assert document.undo_stack.index() == 0


def test_relative_input_goes_on_from_every_digit_of_the_old_value(panel, curve, click, qtbot):
    old = curve().control_points[3, X]
    click(3, X)
    retype(qtbot, panel, "*2")
    assert curve().control_points[3, X] == old * 2


def test_opening_an_editor_shows_all_digits_and_changes_nothing(panel, document, curve, click, qtbot):
    click(3, X)
    qtbot.keyClick(panel.table.viewport(), KEY.Key_F2)
    editor = panel.table.findChild(QLineEdit)
    assert float(editor.text()) == curve().control_points[3, X]
    enter(qtbot, editor)
    assert document.undo_stack.count() == 0


def test_a_mode_typed_makes_the_segment(panel, curve, click, qtbot):
    click(1, MODE)
    retype(qtbot, panel, "H")
    assert curve().lambdas[1:3].tolist() == [1, 1]
    assert shown(panel, 1, MODE) == "hyperbolic"


def test_refused_input_keeps_the_old_value_and_says_why(panel, document, click, qtbot):
    drawing = document.drawing
    click(2, Y)
    retype(qtbot, panel, "two")
    assert panel.said == ["“two” is no number for y of P₂: type one such as 0.5, 2/3 or +1.5."]
    assert document.drawing is drawing


def test_a_locked_curve_can_be_read_and_copied_but_not_changed(panel, document, click, qtbot):
    document.apply("Lock", document.drawing.with_item(0, document.drawing[0].with_(locked=True)))
    click(2, Y)
    qtbot.keyClick(panel.table.viewport(), KEY.Key_F2)
    assert panel.table.findChild(QLineEdit) is None
    QGuiApplication.clipboard().setText("5")
    qtbot.keySequence(panel.table, KEYS.Paste)
    assert panel.said == ["“Figure 10” is locked: unlock it in the list of curves to change it."]
    assert document.undo_stack.count() == 1


def test_a_block_goes_to_a_spreadsheet_and_back_in_one_step(panel, document, curve, click, qtbot):
    before = curve()
    click(2, X)
    click(4, LAMBDA, SHIFT)
    qtbot.keySequence(panel.table, KEYS.Copy)
    lines = [line.split("\t") for line in QGuiApplication.clipboard().text().splitlines()]
    block = np.array(lines, dtype=float)
    assert np.array_equal(block, np.c_[before.control_points, before.lambdas][2:5])

    QGuiApplication.clipboard().setText("\n".join("\t".join(map(repr, row)) for row in (block + 1).tolist()))
    qtbot.keySequence(panel.table, KEYS.Paste)
    rows = [2, 3, 4]
    expected = before.with_points(rows, block[:, :2] + 1).with_lambdas(rows, block[:, 2] + 1)
    assert curve() == expected
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "Paste 9 cells"
    assert panel.said == ["Pasted 9 cells at x of P₂."]


def test_one_value_fills_all_selected_cells(panel, curve, click, qtbot):
    click(2, LAMBDA)
    click(5, LAMBDA, SHIFT)
    QGuiApplication.clipboard().setText("0,5\n")
    qtbot.keySequence(panel.table, KEYS.Paste)
    assert curve().lambdas[2:6].tolist() == [0.5] * 4


def test_points_selected_in_the_table_are_selected_on_the_curve_and_the_other_way(panel, selection, click):
    selection.select(segments=[3])
    click(2, Y)
    assert (selection.points, selection.segments) == ({2}, frozenset())
    click(4, X, CTRL)
    assert selection.points == {2, 4}
    selection.select(points=[6, 7, 11])
    marked = {(i.row(), i.column()) for i in panel.table.selectedIndexes()}
    assert marked == {(row, column) for row in (6, 7, 11) for column in range(4)}
    selection.select(points=[])
    assert panel.table.selectedIndexes() == []
    selection.select(curve=1, points=[12])
    assert panel.table.selected_rows().tolist() == [12]


def test_points_that_come_and_go_keep_table_and_selection_in_step(panel, document, selection, curve):
    selection.select(points=[3, 12])
    shorter = Curve(curve().control_points[:8], curve().lambdas[:8])
    document.apply_curve("Shorten", 0, shorter)
    assert panel.model.rowCount() == 8
    assert sorted(selection.points) == panel.table.selected_rows().tolist() == [3]
    document.apply("Clear", Drawing())
    assert panel.model.rowCount() == panel.model.columnCount() == 0


def test_a_drag_tells_the_table_only_of_the_rows_that_changed(panel, document, curve):
    told = []
    panel.model.dataChanged.connect(lambda first, last: told.append((first.row(), last.row())))
    gesture = document.begin("Move")
    gesture.preview(document.drawing.with_curve(0, curve().with_points([4, 5, 9], 2.0)))
    gesture.preview(document.drawing.with_curve(0, curve().with_lambdas([7], 0.25)))
    gesture.commit()
    assert told == [(4, 5), (9, 9), (6, 7)]
    assert shown(panel, 4, X) == "2"


def test_a_space_curve_has_a_z(panel, document, click, qtbot):
    points = np.c_[some_curve().control_points, np.arange(13.0)]
    document.start(Drawing([Item(Curve(points))]))
    assert panel.model.headerData(2, Qt.Orientation.Horizontal) == "z"
    click(5, 2)
    retype(qtbot, panel, "+0.5")
    assert document.drawing[0].curve.control_points[5, 2] == 5.5


def test_a_hundred_thousand_rows_select_copy_and_paste(qapp, show):
    angles = np.linspace(0, 600, 100_000)
    document = Document(Drawing([Item(Curve(np.c_[angles, np.sin(angles)]))]))
    selection = Selection(document)
    panel = show(PointsPanel(document, selection), 640, 320)
    selection.select(points=range(100_000))
    assert len(panel.table.selected_rows()) == 100_000
    panel.table.selectionModel().select(
        panel.model.index(0, Y), QItemSelectionModel.SelectionFlag.ClearAndSelect
    )
    assert selection.points == {0}
    lines = "".join(f"{y!r}\n" for y in np.cos(angles).tolist())
    QGuiApplication.clipboard().setText(lines)
    panel.table.paste()
    assert np.array_equal(document.drawing[0].curve.control_points[:, Y], np.cos(angles))
