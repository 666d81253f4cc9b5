"""The history panel through the mouse: any state is one click away, told to the views once."""

import pytest
from PySide6.QtCore import Qt

from theditor.panels.history import HistoryPanel


@pytest.fixture
def panel(document, show):
    for x in (1.0, 2.0, 3.0):
        curve = document.drawing[0].curve
        document.apply_curve(f"Move to {x:g}", 0, curve.with_points([1], [[x, 0.0]]))
    return show(HistoryPanel(document), 300, 200)


def texts(panel):
    return [panel.model.index(row).data() for row in range(panel.model.rowCount())]


def test_a_click_goes_to_any_state_in_one_change(panel, document, qtbot):
    assert texts(panel) == ["Start · saved", "Move to 1", "Move to 2", "Move to 3"]
    last = document.drawing
    heard = []
    document.changed.connect(lambda old, new: heard.append((old, new)))
    where = panel.list.visualRect(panel.model.index(0)).center()
    qtbot.mouseClick(panel.list.viewport(), Qt.MouseButton.LeftButton, pos=where)
    assert document.undo_stack.index() == 0
    assert heard == [(last, document.drawing)]
    qtbot.keyClick(panel.list, Qt.Key.Key_End)
    assert document.drawing == last
    assert len(heard) == 2


def test_it_follows_undo_new_steps_saving_and_new_drawings(panel, document, tmp_path):
    document.undo()
    assert panel.list.currentIndex().row() == 2
    document.save(tmp_path / "a.json")
    assert texts(panel)[2] == "Move to 2 · saved"
    curve = document.drawing[0].curve
    document.apply_curve("Bend", 0, curve.with_lambdas([1], [0.25]))
    assert texts(panel) == ["Start", "Move to 1", "Move to 2 · saved", "Bend"]
    document.start(document.drawing)
    assert texts(panel) == ["Start · saved"]
