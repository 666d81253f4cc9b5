"""Curves on the clipboard: within a window, to another, to and from text, tables and pictures."""

import re
import subprocess
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from PySide6.QtCore import QByteArray, QEvent, QMimeData, QRectF, Qt
from PySide6.QtGui import QGuiApplication, QImage, QKeySequence, QPainter
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QApplication, QDockWidget

from theditor.app.clipboard_data import LARGEST, OWN_TYPE, SVG_TYPE, pictures
from theditor.drawing import Drawing, Item, decode, encode
from theditor.spline import Curve, bounds

KEYS = QKeySequence.StandardKey
PATH = "{http://www.w3.org/2000/svg}path"


@pytest.fixture(autouse=True)
def emptied(qapp):
    yield
    clipboard().clear()


def clipboard():
    return QGuiApplication.clipboard()


def middle(curve):
    return np.add(*bounds(curve)) / 2


def view(window):
    plane = window.canvas.plane
    return plane.x, plane.y, plane.scale


def is_in_view(window, curve):
    plane = window.canvas.plane
    pixels = plane.to_pixels(curve.sample(8))
    return bool(((pixels >= 0) & (pixels <= (plane.width, plane.height))).all())


def test_copy_and_paste_puts_the_middle_at_the_pointer(window, hand, qtbot):
    (item,) = window.document.drawing
    qtbot.keySequence(window.canvas, KEYS.Copy)
    hand.move((1.5, -2.0))
    qtbot.keySequence(window.canvas, KEYS.Paste)
    copy = window.document.drawing[1]
    assert window.selection.curve == 1
    assert middle(copy.curve) == pytest.approx([1.5, -2.0], abs=0.02)
    shift = copy.curve.control_points - item.curve.control_points
    assert np.allclose(shift, shift[0], atol=1e-12)
    assert np.array_equal(copy.curve.lambdas, item.curve.lambdas)
    assert window.document.undo_stack.undoText() == "Paste curve"
    window.document.undo()
    assert window.document.drawing == Drawing([item])


ENDS = """
from PySide6.QtGui import QGuiApplication
from theditor.app.clipboard_data import carried, pictures
from theditor.drawing import Drawing, Item, encode
from theditor.spline import Curve

app = QGuiApplication([])
items = [Item(Curve([[0, 0], [1, 1], [2, 0], [3, 1]]))]
made = pictures(items, 1.0, painted=True)
QGuiApplication.clipboard().setMimeData(carried(encode(Drawing(items)), made))
"""


def test_the_program_ends_in_peace_with_a_curve_on_the_clipboard():
    assert subprocess.run([sys.executable, "-c", ENDS], timeout=60).returncode == 0


def test_away_from_the_canvas_it_is_pasted_into_the_middle_of_the_view(window, hand, qtbot):
    qtbot.keySequence(window.canvas, KEYS.Copy)
    hand.move((1.5, -2.0))
    QApplication.sendEvent(window.canvas, QEvent(QEvent.Type.Leave))
    qtbot.keySequence(window.canvas, KEYS.Paste)
    plane = window.canvas.plane
    assert middle(window.document.drawing[1].curve) == pytest.approx([plane.x, plane.y], abs=0.01)


def test_what_is_pasted_is_in_view_and_the_view_moves_only_for_that(window, hand, qtbot):
    window.canvas.show_view(-0.5, 1.8, 90.0)
    before = view(window)
    clipboard().setText("M0 0C1 2 3 2 4 0")  # whose control points are far away from it
    paste(window, qtbot, "paste")
    arch = window.document.drawing[1].curve
    assert middle(arch) == pytest.approx(before[:2], abs=0.01)
    assert is_in_view(window, arch)
    assert view(window) == before
    hand.move((4.0, -1.0))
    paste(window, qtbot, "paste")
    assert view(window) != before
    assert all(is_in_view(window, item.curve) for item in window.document.drawing)


def test_tiny_curves_are_pasted_where_one_looks(window, qtbot):
    window.canvas.show_view(0.0, 0.0, 50.0)
    before = view(window)
    clipboard().setText("0 0\n0.1 0.1\n0.2 0")
    paste(window, qtbot, "paste")
    assert view(window) == before


def test_cut_and_paste_in_place_gives_the_same_curve_back(window, qtbot):
    drawing = window.document.drawing
    qtbot.keySequence(window.canvas, KEYS.Cut)
    assert window.document.drawing == Drawing()
    assert window.document.undo_stack.undoText() == "Cut curve"
    qtbot.keyClick(
        window.canvas, Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
    )
    assert window.document.drawing == drawing


def test_a_locked_curve_is_copied_but_not_cut_and_its_copy_is_free(window):
    item = window.document.drawing[0].with_(locked=True)
    window.document.start(Drawing([item]))
    assert not window.actions_by_name["cut"].isEnabled()
    window.actions_by_name["copy"].trigger()
    window.actions_by_name["paste_in_place"].trigger()
    assert window.document.drawing == Drawing([item, item.with_(locked=False)])


def test_text_editors_get_the_file_and_give_it_back(window):
    window.actions_by_name["copy"].trigger()
    data = clipboard().mimeData()
    assert data.text().encode() == bytes(data.data(OWN_TYPE).data()) == encode(window.document.drawing)
    two = Drawing([*window.document.drawing, Item(Curve([(0, 0), (1, 1), (2, 0)], degree=2), "Arc")])
    clipboard().setText("\n" + encode(two).decode() + "\n")
    window.actions_by_name["paste_in_place"].trigger()
    assert window.document.drawing[1:] == tuple(two)
    assert window.document.undo_stack.undoText() == "Paste 2 curves"


def test_a_table_of_numbers_becomes_a_curve_that_ends_at_its_first_and_last_point(window):
    clipboard().setText("0,5;1\n1,5;2\n2,5;0\n")
    window.actions_by_name["paste_in_place"].trigger()
    assert window.document.drawing[1].curve == Curve([(0.5, 1), (1.5, 2), (2.5, 0)], ends="clamped")
    clipboard().setText("0 0 0\n1 0 1\n2 1 2")
    window.actions_by_name["paste"].trigger()
    assert window.document.drawing[2].curve.dimension == 3


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "holds nothing that can be pasted: copy a curve"),
        (
            "Dear all,\nhello",
            "“Dear all,”, is neither a row of numbers nor a header with x and y. Copy a",
        ),
        ('{"format": "theditor", "version": 99, "curves": []}', "is 99, and 1 is the newest"),
        ('{"format": "theditor", "version": 1, "curves": []}', "has no curves: copy a curve"),
        (
            "1 2",
            "Line 1 makes no curve: a clamped cubic curve needs at least 2 control points, not 1. Copy a",
        ),
        ("1e13 0\n0 0", "control point 0: x is"),
    ],
)
def test_anything_else_is_refused_with_what_can_be_pasted(window, text, words):
    drawing = window.document.drawing
    clipboard().setText(text)
    window.actions_by_name["paste"].trigger()
    assert words in window.announced
    assert window.document.drawing is drawing


def test_a_text_field_keeps_its_keys_and_its_menu(window, qtbot):
    drawing, name = window.document.drawing, window.curve.name
    name.setFocus()
    name.selectAll()
    qtbot.keySequence(name, KEYS.Copy)
    assert clipboard().text() == "Figure 10"
    clipboard().setText("Fig. ten")
    window.actions_by_name["paste"].trigger()
    assert name.text() == "Fig. ten"
    name.selectAll()
    window.actions_by_name["cut"].trigger()
    assert name.text() == ""
    assert window.document.drawing is drawing
    name.setText("Figure 10")  # else the window would ask about it when it closes


def test_the_point_table_keeps_its_keys_and_its_menu(window, qtbot):
    window.findChild(QDockWidget, "points").raise_()
    table = window.points.table
    table.setFocus()
    table.setCurrentIndex(window.points.model.index(3, 1))
    for copy in (lambda: qtbot.keySequence(table, KEYS.Copy), window.actions_by_name["copy"].trigger):
        clipboard().setText("nothing")
        copy()
        assert float(clipboard().text()) == window.document.drawing[0].curve.control_points[3, 1]
    clipboard().setText("*2")
    window.actions_by_name["paste"].trigger()
    assert "nothing was pasted" in window.announced
    qtbot.keySequence(table, KEYS.Cut)
    assert "cannot be cut" in window.announced
    assert len(window.document.drawing) == 1


SVG = '<svg xmlns="http://www.w3.org/2000/svg"><circle cx="2" r="1"/><path id="arch" d="M0 0C1 2 3 2 4 0"/></svg>'


def as_picture(data):
    carrying = QMimeData()
    carrying.setData(SVG_TYPE, data.encode())
    return carrying


def paste(window, qtbot, name="paste_in_place"):
    window.actions_by_name[name].trigger()
    qtbot.waitUntil(lambda: not window.work.jobs)


@pytest.mark.parametrize("picture", [True, False])
def test_a_picture_of_another_program_comes_in_as_curves_and_goes_with_one_step_back(window, qtbot, picture):
    before = window.document.drawing
    if picture:
        clipboard().setMimeData(as_picture(SVG))
    else:
        clipboard().setText(f"<?xml version='1.0'?>\n{SVG}")
    paste(window, qtbot)
    circle, arch = window.document.drawing[1:]
    assert (circle.name, arch.name) == ("Circle 1", "arch")
    np.testing.assert_allclose(np.hypot(*(circle.curve.sample(8) - (2, 0)).T), 1)
    assert window.document.undo_stack.undoText() == "Paste 2 curves"
    assert "Pasted 2 curves. The largest deviation is" in window.announced
    window.document.undo()
    assert window.document.drawing == before


def test_path_data_comes_to_the_pointer(window, qtbot, hand):
    clipboard().setText(" M0 0H10V5z ")
    hand.move((1.5, -2.0))
    paste(window, qtbot, "paste")
    curve = window.document.drawing[1].curve
    assert middle(curve) == pytest.approx([1.5, -2.0], abs=0.02)
    assert np.subtract(*bounds(curve)) == pytest.approx([-10, -5])
    assert window.announced == "Pasted “Path”. Exact."


def test_a_picture_that_cannot_be_read_is_told_and_changes_nothing(window, qtbot):
    drawing = window.document.drawing
    for text, words in (
        ("<svg", "What was copied cannot be pasted: The text is not XML"),
        ('<svg xmlns="http://www.w3.org/2000/svg"><text>a</text></svg>', "no path or shape"),
        ("M0 0L1 1 x", "cannot be read from character 10 on"),
    ):
        clipboard().setText(text)
        paste(window, qtbot)
        assert words in window.announced
        assert not window.messages.text, "where it would stay through later ones that go well"
    assert window.document.drawing is drawing


def test_the_pictures_show_the_curve_upright_and_as_large_as_on_screen(window):
    window.actions_by_name["copy"].trigger()
    data = clipboard().mimeData()
    picture = bytes(data.data(SVG_TYPE).data())
    root = ET.fromstring(picture)
    curve, scale = window.document.drawing[0].curve, window.canvas.plane.scale
    low, high = bounds(curve)
    width, height = (float(root.get(side).removesuffix("mm")) * 96 / 25.4 for side in ("width", "height"))
    assert (width, height) == pytest.approx((high - low) * scale, abs=20)
    (path,) = root.iter(PATH)
    start = [float(number) for number in re.findall(r"M([^,]*),([^A-Z]*)", path.get("d"))[0]]
    assert start == pytest.approx(curve(0.0) * (1, -1))
    vector = QImage(round(width), round(height), QImage.Format.Format_ARGB32)
    vector.fill(Qt.GlobalColor.white)
    painter = QPainter(vector)
    renderer = QSvgRenderer(QByteArray(picture))
    assert renderer.isValid()
    renderer.render(painter, QRectF(vector.rect()))
    painter.end()
    pixels = data.imageData()
    assert pixels.size() == vector.size()
    ink = [
        {
            (x, y)
            for x in range(vector.width())
            for y in range(vector.height())
            if image.pixelColor(x, y).red() < 90
        }
        for image in (vector, pixels)
    ]
    assert len(ink[0] & ink[1]) > 0.8 * len(ink[0] | ink[1])


def test_names_and_far_away_giants_make_valid_pictures():
    curve = Curve([(1e12, -1e12), (-1e12, 1e12), (1e12, 1e12), (0, 0)], closed=True)
    small = Curve(np.full((4, 2), 1e12))
    for items in ([Item(curve, "<&>")], [Item(small)], [Item(curve, visible=False), Item(small)]):
        root = ET.fromstring(pictures(items, 1e6)[SVG_TYPE])
        assert float(root.get("width").removesuffix("mm")) * 96 / 25.4 <= LARGEST + 20
        assert [path.get("d")[-1] == "Z" for path in root.iter(PATH)] == [item.curve.closed for item in items]


def test_the_picture_of_a_large_curve_follows_its_text(window, qtbot):
    x = np.linspace(0, 3000, 3000)
    window.document.apply("Draw", Drawing([Item(Curve(np.stack([x, np.sin(x)], axis=1)), "long")]))
    window.actions_by_name["copy"].trigger()
    assert decode(clipboard().mimeData().text().encode()) == window.document.drawing
    qtbot.waitUntil(lambda: clipboard().mimeData().hasFormat(SVG_TYPE))
    assert decode(clipboard().mimeData().text().encode()) == window.document.drawing
    # What was copied elsewhere meanwhile stays.
    window.actions_by_name["copy"].trigger()
    clipboard().setText("sheep")
    qtbot.waitUntil(lambda: not window.work.jobs)
    assert clipboard().mimeData().formats() == ["text/plain"]


def test_what_other_programs_mark_as_ours_is_checked_like_a_file(window):
    data = QMimeData()
    data.setData(OWN_TYPE, b"{")
    clipboard().setMimeData(data)
    window.actions_by_name["paste"].trigger()
    assert "is no drawing" in window.announced


def test_all_selected_curves_are_cut_and_pasted_together(window, qtbot):
    drawing = window.document.drawing
    window.document.apply("Add", drawing.inserted(1, drawing[0].with_(name="Second")))
    both = window.document.drawing
    window.selection.select_across({0: [1], 1: [2, 3]})
    window.clipboard.cut()
    assert window.document.drawing == Drawing()
    assert window.document.undo_stack.undoText() == "Cut 2 curves"
    window.clipboard.paste_in_place()
    assert window.document.drawing == both
    counts = {i: len(item.curve.control_points) for i, item in enumerate(both)}
    assert {i: len(of) for i, of in window.selection.across.items()} == counts, "to be moved at once"
