import pytest
from panel_hand import CTRL, NONE, Hand, some_curve
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QColorDialog, QLineEdit

from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection
from theditor.panels import CurvePanel, CurvesPanel, SegmentsPanel, ShapePanel
from theditor.panels.curve_list import eye_rect, lock_rect
from theditor.spline import INTERPOLATING, nearest

KEY = Qt.Key
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def panel(document, selection, show):
    return show(CurvePanel(document, selection))


@pytest.fixture
def curves(document, selection, show):
    return show(CurvesPanel(document, selection))


def choose(qtbot, combo, text):
    """Pick an entry by keys, as a person does without the mouse."""
    combo.setFocus()
    while combo.currentText() != text:
        key = KEY.Key_Down if combo.findText(text) > combo.currentIndex() else KEY.Key_Up
        before = combo.currentIndex()
        qtbot.keyClick(combo, key)
        assert combo.currentIndex() != before


def place(panel, row, rect):
    return rect(panel.list.visualRect(panel.model.index(row))).center()


def names(document):
    return [item.name for item in document.drawing]


def test_renaming_is_one_step(panel, document, qtbot):
    panel.name.setFocus()
    panel.name.selectAll()
    qtbot.keyClicks(panel.name, "Swan")
    qtbot.keyClick(panel.name, KEY.Key_Return)
    panel.degree.setFocus()
    assert names(document) == ["Swan", "Ring"]
    assert document.undo_stack.count() == 1
    document.undo()
    assert panel.name.text() == "Figure 10"


def test_degree_and_ends_change_the_curve_and_keep_interpolation(panel, document, qtbot):
    choose(qtbot, panel.degree, "Quadratic · C¹")
    curve = document.drawing[0].curve
    assert curve.degree == 2
    assert curve.lambdas[3] == INTERPOLATING[2]
    assert document.undo_stack.undoText() == "Make curve quadratic"
    choose(qtbot, panel.ends, "Open, clamped ends")
    assert document.drawing[0].curve.ends == "clamped"
    choose(qtbot, panel.ends, "Closed")
    assert document.drawing[0].curve.closed
    while document.undo_stack.canUndo():
        document.undo()
    assert panel.degree.currentText() == "Cubic · C²"
    assert panel.ends.currentText() == "Open, free ends"


def test_degree_and_ends_keep_the_shape_and_say_how_well(panel, document, selection, qtbot):
    before = document.drawing[0].curve
    with qtbot.waitSignal(panel.announce) as told:
        choose(qtbot, panel.ends, "Open, clamped ends")
    clamped = document.drawing[0].curve
    words = "Clamped “Figure 10”; the shape changed by at most "
    away = max(nearest(clamped, place)[1] for place in before.sample(4))
    assert away <= float(told.args[0].removeprefix(words)) < 0.05
    with qtbot.waitSignal(panel.announce) as told:
        choose(qtbot, panel.ends, "Open, free ends")
    assert told.args[0] == "Freed the ends of “Figure 10”; the shape is the same"


def test_all_selected_curves_change_together(panel, document, selection, qtbot, monkeypatch):
    selection.select_across({0: [], 1: []})
    monkeypatch.setattr(QColorDialog, "getColor", lambda *_: QColor("#C0FFEE"))
    qtbot.mouseClick(panel.colour, LEFT)
    assert [item.color for item in document.drawing] == ["#c0ffee"] * 2
    assert document.undo_stack.undoText() == "Change line colour of 2 curves"
    choose(qtbot, panel.degree, "Quadratic · C¹")
    assert [item.curve.degree for item in document.drawing] == [2, 2]
    assert document.undo_stack.undoText() == "Make 2 curves quadratic"
    assert selection.curves == (0, 1)


def test_colour_and_width(panel, document, qtbot, monkeypatch):
    monkeypatch.setattr(QColorDialog, "getColor", lambda *_: QColor("#C0FFEE"))
    qtbot.mouseClick(panel.colour, LEFT)
    assert document.drawing[0].color == "#c0ffee"
    assert document.undo_stack.undoText() == "Change line colour"
    monkeypatch.setattr(QColorDialog, "getColor", lambda *_: QColor())
    qtbot.mouseClick(panel.colour, LEFT)
    panel.width_field.setFocus()
    panel.width_field.selectAll()
    qtbot.keyClicks(panel.width_field, "3,5")
    qtbot.keyClick(panel.width_field, KEY.Key_Return)
    assert document.drawing[0].width == 3.5
    assert document.undo_stack.undoText() == "Change line width"
    qtbot.keyClick(panel.width_field, KEY.Key_Up)
    assert document.drawing[0].width == 4.0
    with qtbot.waitSignal(panel.announce) as said:
        panel.width_field.selectAll()
        qtbot.keyClicks(panel.width_field, "101")
        qtbot.keyClick(panel.width_field, KEY.Key_Return)
    assert "0.1 to 100" in said.args[0]
    assert document.drawing[0].width == 4.0


@pytest.mark.parametrize("kind", [CurvePanel, ShapePanel, SegmentsPanel, CurvesPanel])
def test_panels_live_through_an_empty_drawing_and_hidden_or_space_curves(show, kind):
    document = Document()
    panel = show(kind(document, Selection(document)))
    helix = some_curve([0.0] * 6).control_points
    space = Item(type(some_curve())([(*point, 1.0) for point in helix]), "Helix", visible=False)
    document.apply("Add curve", Drawing([space]))
    panel.grab()
    document.undo()
    panel.grab()
    document.redo()


def test_a_locked_curve_disables_the_panel_and_says_why(panel, document, selection):
    item = document.drawing[0].with_(locked=True)
    document.apply("Lock curve", document.drawing.with_item(0, item))
    controls = (panel.name, panel.degree, panel.ends, panel.colour, panel.width_field)
    assert not any(control.isEnabled() for control in controls)
    assert all("“Figure 10” is locked" in control.toolTip() for control in controls)
    selection.select(curve=1)
    assert all(control.isEnabled() for control in controls)


def test_the_current_row_is_the_current_curve(curves, selection, qtbot):
    assert curves.list.currentIndex().row() == 0
    row = curves.list.visualRect(curves.model.index(1))
    Hand(curves.list.viewport()).click(row.center().x(), row.center().y())
    assert selection.curve == 1
    selection.select(curve=0)
    assert curves.list.currentIndex().row() == 0


def test_eye_and_lock_are_steps_and_leave_the_current_curve(curves, document, selection):
    hand = Hand(curves.list.viewport())
    hand.click_at(place(curves, 1, eye_rect))
    assert [item.visible for item in document.drawing] == [True, False]
    assert document.undo_stack.undoText() == "Hide curve"
    hand.click_at(place(curves, 1, lock_rect))
    assert document.drawing[1].locked
    assert selection.curve == 0
    assert curves.model.index(1).data(Qt.ItemDataRole.AccessibleTextRole) == "Ring, hidden, locked"
    document.undo()
    document.undo()
    assert document.drawing[1].visible
    assert not document.drawing[1].locked


@pytest.mark.parametrize("by_key", [True, False])
def test_a_name_is_edited_in_its_row(curves, document, qtbot, by_key):
    if by_key:
        curves.list.setFocus()
        qtbot.keyClick(curves.list, KEY.Key_F2)
    else:
        curves.rename()
    editor = curves.list.viewport().findChild(QLineEdit)
    editor.selectAll()
    qtbot.keyClicks(editor, "Swan")
    qtbot.keyClick(editor, KEY.Key_Return)
    qtbot.waitUntil(lambda: names(document) == ["Swan", "Ring"])
    assert document.undo_stack.undoText() == "Rename curve"


def test_duplicate_and_delete_act_on_the_current_curve_and_can_be_undone(curves, document, selection, qtbot):
    qtbot.mouseClick(curves.duplicate_button, LEFT)
    assert names(document) == ["Figure 10", "Figure 10 copy", "Ring"]
    assert selection.curve == 1
    assert curves.list.currentIndex().row() == 1
    selection.select(curve=0)
    qtbot.mouseClick(curves.duplicate_button, LEFT)
    assert names(document)[1] == "Figure 10 copy 2"
    qtbot.mouseClick(curves.delete_button, LEFT)
    assert names(document) == ["Figure 10", "Figure 10 copy", "Ring"]
    while document.undo_stack.canUndo():
        document.undo()
    assert names(document) == ["Figure 10", "Ring"]
    assert [curves.model.index(row).data() for row in range(2)] == ["Figure 10", "Ring"]
    assert curves.list.currentIndex().row() == selection.curve


def test_add_is_left_to_the_window(curves, qtbot):
    with qtbot.waitSignal(curves.add_requested):
        qtbot.mouseClick(curves.add_button, LEFT)


def test_the_list_tells_of_nothing_but_rows_that_look_different(curves, document):
    told = []
    curves.model.dataChanged.connect(lambda a, b: told.append(a.row()))
    curves.model.modelReset.connect(lambda: told.append("reset"))
    document.apply_curve("Move", 0, document.drawing[0].curve.with_points(0, [[4, 4]]))
    assert told == []
    document.apply("Rename", document.drawing.with_item(1, document.drawing[1].with_(name="Loop")))
    assert told == [1]


def test_the_list_grows_to_five_rows_and_then_scrolls(curves, document):
    heights = []
    for count in (1, 3, 5, 9):
        document.apply("Fill", Drawing([Item(some_curve())] * count))
        heights.append(curves.list.sizeHint().height())
    assert heights[0] < heights[1] < heights[2] == heights[3]


def test_the_last_curve_can_be_deleted(curves, document, selection, qtbot):
    for _ in range(2):
        qtbot.mouseClick(curves.delete_button, LEFT)
    assert len(document.drawing) == 0
    assert not curves.delete_button.isEnabled()
    assert not curves.list.currentIndex().isValid()
    document.undo()
    assert curves.list.currentIndex().row() == selection.curve == 0
    assert curves.list.visualRect(curves.model.index(0)).top() == QPoint(0, 0).y()


@pytest.fixture
def three(document, curves):
    document.apply("Add curve", document.drawing.inserted(2, Item(some_curve(), "Third")))
    return Hand(curves.list.viewport())


def drag_row(hand, panel, row, y, let_go=True):
    start = panel.list.visualRect(panel.model.index(row)).center()
    hand.press(start.x(), start.y())
    for step in (0.3, 0.6, 1.0):
        hand.move(start.x(), start.y() + step * (y - start.y()))
    if let_go:
        hand.release()


def test_a_row_is_dragged_to_another_place_in_one_step(curves, document, selection, three):
    selection.select(curve=0, points={3})
    steps = document.undo_stack.count()
    before = curves.list.grab().toImage()
    drag_row(three, curves, 0, 500, let_go=False)
    assert curves.list.grab().toImage() != before
    assert names(document) == ["Figure 10", "Ring", "Third"]
    three.release()
    assert names(document) == ["Ring", "Third", "Figure 10"]
    assert (selection.curve, selection.points) == (2, {3})
    assert curves.list.currentIndex().row() == 2
    assert document.undo_stack.undoText() == "Reorder curves"
    drag_row(three, curves, 2, curves.list.visualRect(curves.model.index(1)).top() + 3)
    assert names(document) == ["Ring", "Figure 10", "Third"]
    document.undo()
    document.undo()
    assert names(document) == ["Figure 10", "Ring", "Third"]
    assert document.undo_stack.index() == steps


def test_a_drag_that_ends_where_it_began_or_is_taken_back_changes_nothing(curves, document, three, qtbot):
    value = document.drawing
    drag_row(three, curves, 1, 40)
    drag_row(three, curves, 0, 80, let_go=False)
    qtbot.keyClick(curves.list, KEY.Key_Escape)
    three.release()
    assert document.drawing is value


def test_curves_are_moved_up_and_down_and_stay_within_the_list(curves, document, selection, three):
    said = []
    curves.announce.connect(said.append)
    selection.select(curve=1)
    curves.reorder(1)
    assert names(document) == ["Figure 10", "Third", "Ring"]
    assert said[-1] == "“Ring” lies above “Third” now."
    curves.reorder(1)
    assert names(document) == ["Figure 10", "Third", "Ring"]
    curves.reorder(-5)
    assert names(document) == ["Ring", "Figure 10", "Third"]
    assert selection.curve == 0


def test_several_rows_are_selected_and_edited_together(curves, document, selection, three):
    for row, keys in ((0, NONE), (2, CTRL)):
        three.click_at(curves.list.visualRect(curves.model.index(row)).center(), keys)
    assert (selection.curves, selection.curve) == ((0, 2), 2)
    start = document.drawing
    curves.toggle_visible()
    assert [item.visible for item in document.drawing] == [False, True, False]
    assert document.undo_stack.undoText() == "Hide 2 curves"
    curves.toggle_visible()
    assert document.drawing == start
    curves.duplicate_button.click()
    assert names(document) == ["Figure 10", "Figure 10 copy", "Ring", "Third", "Third copy"]
    assert (selection.curves, selection.curve) == ((1, 4), 4)
    curves.delete_button.click()
    assert document.drawing == start
    assert document.undo_stack.undoText() == "Delete 2 curves"


def test_what_is_selected_on_several_curves_shows_in_the_rows(curves, selection, three):
    selection.select_across({0: [1], 1: [2]})
    assert [index.row() for index in curves.list.selectionModel().selectedIndexes()] == [0, 1]
    assert curves.list.currentIndex().row() == 0
    three.click_at(curves.list.visualRect(curves.model.index(2)).center(), CTRL)
    assert selection.curves == (0, 1, 2)
    assert {i: of.tolist() for i, of in selection.across.items()} == {0: [1], 1: [2]}
    assert curves.list.currentIndex().row() == selection.curve == 1
    three.click_at(curves.list.visualRect(curves.model.index(1)).center())
    assert (selection.curves, selection.count) == ((1,), 1), "what is selected on the one that is left stays"


def test_locked_curves_among_several_stay(curves, document, selection, three, qtbot):
    document.apply("Lock", document.drawing.with_item(1, document.drawing[1].with_(locked=True)))
    selection.select_across({0: [], 1: [], 2: []})
    with qtbot.waitSignal(curves.announce) as told:
        curves.delete()
    assert told.args == ["2 curves are deleted; Undo brings them back. 1 locked curve stayed."]
    assert names(document) == ["Ring"]


def test_a_double_click_on_the_colour_asks_for_another(curves, document, three, qtbot):
    row = curves.list.visualRect(curves.model.index(2))
    with qtbot.waitSignal(curves.recolour_requested):
        at = QPoint(eye_rect(row).right() + 14, row.center().y())
        qtbot.mouseClick(curves.list.viewport(), LEFT, pos=at)
        qtbot.mouseDClick(curves.list.viewport(), LEFT, pos=at)
    assert curves.list.findChild(QLineEdit) is None


def test_without_a_curve_the_width_is_empty_and_back_with_the_same_one(panel, document):
    before = panel.width_field.text()
    document.apply("Delete", Drawing())
    assert panel.width_field.text() == ""
    document.undo()
    assert panel.width_field.text() == before
