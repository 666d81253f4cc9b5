"""Every command can be found, says when it can be done, and can be done; in menus, by right click, by words."""

import pytest
from hand import Hand
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor, QContextMenuEvent, QKeySequence
from PySide6.QtWidgets import QApplication, QColorDialog, QDialog, QMenu, QMessageBox

from theditor.app.palette import Palette
from theditor.app.shortcuts import Shortcuts
from theditor.drawing import Drawing, Item, load
from theditor.resources import gallery
from theditor.spline import Curve, Mode

popups = pytest.mark.qt_log_ignore("This plugin does not support")  # said of menus offscreen

P5 = (1.0, 2.3130352854993315)


def many_curves():
    pictures = [load(picture.path)[0] for picture in gallery()[:3]]
    return Drawing([*pictures, Item(Curve([(0, 0), (1, 1), (2, 0)], degree=2), locked=True)])


DRAWINGS = {
    "empty": Drawing(),
    "one curve": Drawing([Item(Curve([(0, 0), (1, 2), (3, 1), (4, 0)]))]),
    "many curves": many_curves(),
}
EVERYWHERE = {0: [0, 1], 1: [2], 2: [], 3: []}
"""Points on two curves, and two chosen as a whole, of which one is locked."""


@pytest.fixture
def nobody_asks(monkeypatch, tmp_path):
    """Questions answer themselves; windows that would stay open close at once."""
    monkeypatch.setattr("theditor.app.ask.which_to_open", lambda *_: None)
    monkeypatch.setattr("theditor.app.ask.which_to_import", lambda *_: [])
    monkeypatch.setattr("theditor.app.ask.where_to_save", lambda *_: tmp_path / "saved.json")
    monkeypatch.setattr(QMessageBox, "question", lambda *_: QMessageBox.StandardButton.Discard)
    monkeypatch.setattr(QMessageBox, "about", lambda *_: None)
    monkeypatch.setattr(QDialog, "exec", lambda *_: 0)
    monkeypatch.setattr(QColorDialog, "getColor", lambda *_: QColor("#123456"))
    monkeypatch.setattr(QApplication, "closeAllWindows", lambda: None)


def close_dialogs():
    for widget in QApplication.topLevelWidgets():
        if isinstance(widget, QDialog) and widget.isVisible():
            widget.reject()


@pytest.mark.parametrize(
    ("name", "chosen"),
    [("empty", {}), ("one curve", {0: [0, 1]}), ("many curves", EVERYWHERE)],
)
def test_every_command_can_be_done_when_it_says_so(window, nobody_asks, name, chosen):
    done = set()
    for command in window.commands:
        window.document.start(DRAWINGS[name])
        window.selection.select_across(chosen)
        action = window.actions_by_name[command.name]
        assert action.isEnabled() == command.enabled(window)
        if action.isEnabled():
            action.trigger()
            done.add(command.name)
            QApplication.processEvents()
            close_dialogs()
            window.document.undo_stack.setIndex(0)
            expected = Drawing() if command.name == "new" else DRAWINGS[name]
            assert window.document.drawing == expected, command.name
    assert {"add", "fit", "palette", "shortcuts", "about"} <= done
    assert ("reverse" in done) == (name != "empty")
    assert ("move_down" in done) == (name == "many curves")
    assert ("distribute_vertically" in done) == (name == "many curves")


def test_each_name_and_key_belongs_to_one_command(window):
    names = [command.name for command in window.commands]
    assert len(set(names)) == len(names)
    taken = {}
    for command in window.commands:
        where = "canvas" if command.on_canvas else "list" if command.on_list else "window"
        for key in window.actions_by_name[command.name].shortcuts():
            text = key.toString(QKeySequence.SequenceFormat.PortableText)
            for place in ("canvas", "list") if where == "window" else (where,):
                other = taken.setdefault((place, text), command.name)
                assert other == command.name, f"{text} runs both {other} and {command.name}"


def test_commands_sleep_while_they_have_nothing_to_act_on(window):
    enabled = {name: action.isEnabled for name, action in window.actions_by_name.items()}
    window.selection.select(points=())
    assert not enabled["select_none"]()
    assert not enabled["undo"]()
    window.selection.select(points={2})
    assert enabled["select_none"]()
    window.curves.toggle_locked()
    assert not enabled["reverse"]()
    assert enabled["undo"]()
    window.document.undo()
    assert enabled["redo"]()
    window.document.start(Drawing())
    assert not any(enabled[name]() for name in ("duplicate", "delete", "lock", "select_all", "trigonometric"))


def right_click(widget, at, reason=QContextMenuEvent.Reason.Mouse):
    event = QContextMenuEvent(reason, at, widget.mapToGlobal(at))
    QApplication.sendEvent(widget, event)
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    names = [action.objectName() for action in menu.actions() if not action.isSeparator()]
    return menu, names


@popups
def test_a_right_click_selects_what_it_meets_and_offers_what_can_be_done_with_it(window):
    hand, viewport = Hand(window.canvas), window.canvas.viewport()

    def at(point):
        return QPoint(*(int(v) for v in hand.pixel(point)))

    menu, names = right_click(viewport, at(P5))
    assert window.selection.points == {5}
    assert "interpolating" in names
    assert "add" not in names
    next(a for a in menu.actions() if a.objectName() == "interpolating").trigger()
    menu.close()
    assert window.document.drawing[0].curve.lambdas[5] == pytest.approx(8.9113, abs=1e-3)
    window.document.undo()

    window.selection.select(points={2, 5})
    menu, _ = right_click(viewport, at(P5))
    menu.close()
    assert window.selection.points == {2, 5}

    menu, names = right_click(viewport, at(window.document.drawing[0].curve(4.5)))
    menu.close()
    assert (window.selection.points, window.selection.segments) == (set(), {4})
    assert "hyperbolic" in names

    menu, names = right_click(viewport, QPoint(3, viewport.height() - 3))
    menu.close()
    assert {"add", "fit", "select_all"} <= set(names)
    assert "hyperbolic" not in names


@popups
def test_a_right_click_on_one_of_several_selected_curves_keeps_them_selected(window):
    drawing = window.document.drawing
    window.document.apply("Add", drawing.inserted(1, drawing[0].with_(name="Second")))
    window.selection.select_across({0: [], 1: []})
    hand, viewport = Hand(window.canvas), window.canvas.viewport()
    place = QPoint(*(int(v) for v in hand.pixel(drawing[0].curve(4.5))))
    menu, names = right_click(viewport, place)
    menu.close()
    assert window.selection.curves == (0, 1)
    assert {"hyperbolic", "duplicate", "delete"} <= set(names)


@popups
def test_the_menu_key_offers_what_can_be_done_with_the_selection(window):
    keyboard = QContextMenuEvent.Reason.Keyboard
    window.selection.select(segments={4})
    menu, names = right_click(window.canvas, QPoint(0, 0), keyboard)
    menu.close()
    assert "trigonometric" in names
    assert window.selection.segments == {4}
    menu, names = right_click(window.curves.list, QPoint(5, 5), keyboard)
    menu.close()
    assert {"rename", "duplicate", "delete", "hide", "lock", "move_up", "move_down"} <= set(names)


@pytest.fixture
def palette(window, qtbot):
    window.actions_by_name["palette"].trigger()
    palette = window.findChild(Palette)
    qtbot.waitExposed(palette)
    return palette


def listed(palette):
    return [palette.table.item(row, 0).text() for row in range(palette.table.rowCount())]


def test_a_command_is_found_by_words_and_run_by_enter(window, palette, qtbot):
    window.selection.select(segments={4})
    every = listed(palette)
    qtbot.keyClicks(palette.field, "make hyper")
    assert listed(palette) == ["Make segments hyperbolic"]
    assert palette.table.item(0, 2).text() == "H"
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert not palette.isVisible()
    assert window.document.drawing[0].curve.modes[4] is Mode.HYPERBOLIC
    assert {"Dark", "Curvature", "Ellipse", "Undo"} <= {name.removeprefix("✓ ") for name in every}


def test_the_palette_marks_with_arrows_and_runs_only_what_can_be_done(window, palette, qtbot):
    qtbot.keyClicks(palette.field, "redo")
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert palette.isVisible()
    palette.field.clear()
    qtbot.keyClicks(palette.field, "zoom")
    assert listed(palette)[:3] == ["Zoom to selection", "Zoom in", "Zoom out"]
    scale = window.canvas.plane.scale
    for _ in range(2):
        qtbot.keyClick(palette.field, Qt.Key.Key_Down)
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert window.canvas.plane.scale < scale
    palette.field.setText("no such thing")
    assert listed(palette) == []
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)


def test_the_sheet_of_shortcuts_has_every_key(window, qtbot):
    qtbot.keyClick(window.canvas, "?")
    sheet = window.findChild(Shortcuts)
    assert sheet.isVisible()
    shown = {what for rows in sheet.groups.values() for _, what in rows}
    for command in window.commands:
        if window.actions_by_name[command.name].shortcuts():
            plain = command.text.replace("&", "").removesuffix("…")
            assert any(what.startswith(plain) for what in shown), command.name
    sheet.reject()
