"""Curves on the clipboard: within a window, to another, to and from text, tables and pictures."""

import re
import subprocess
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QByteArray, QEvent, QMimeData, QRectF, Qt
from PySide6.QtGui import QGuiApplication, QImage, QKeySequence, QPainter
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QApplication, QDockWidget

from theditor.app.clipboard import OWN_TYPE, SVG_TYPE
from theditor.app.svg import TOLERANCE, beziers, svg
from theditor.drawing import Drawing, Item, encode
from theditor.spline import Curve, nearest

KEYS = QKeySequence.StandardKey
PATH = "{http://www.w3.org/2000/svg}path"


@pytest.fixture(autouse=True)
def emptied(qapp):
    yield
    clipboard().clear()


def clipboard():
    return QGuiApplication.clipboard()


def box(curve):
    points = curve.control_points[:, :2]
    return points.min(axis=0), points.max(axis=0)


def test_copy_and_paste_puts_the_middle_at_the_pointer(window, hand, qtbot):
    (item,) = window.document.drawing
    qtbot.keySequence(window.canvas, KEYS.Copy)
    hand.move((1.5, -2.0))
    qtbot.keySequence(window.canvas, KEYS.Paste)
    copy = window.document.drawing[1]
    assert window.selection.curve == 1
    assert np.add(*box(copy.curve)) / 2 == pytest.approx([1.5, -2.0], abs=0.02)
    shift = copy.curve.control_points - item.curve.control_points
    assert np.allclose(shift, shift[0], atol=1e-12)
    assert np.array_equal(copy.curve.lambdas, item.curve.lambdas)
    assert window.document.undo_stack.undoText() == "Paste curve"
    window.document.undo()
    assert window.document.drawing == Drawing([item])


ENDS = """
from PySide6.QtGui import QGuiApplication
from theditor.app.clipboard import carried
from theditor.drawing import Item
from theditor.spline import Curve

app = QGuiApplication([])
QGuiApplication.clipboard().setMimeData(carried([Item(Curve([[0, 0], [1, 1], [2, 0], [3, 1]]))], 1.0))
"""


def test_the_program_ends_in_peace_with_a_curve_on_the_clipboard():
    assert subprocess.run([sys.executable, "-c", ENDS], timeout=60).returncode == 0


def test_away_from_the_canvas_it_is_pasted_into_the_middle_of_the_view(window, hand, qtbot):
    qtbot.keySequence(window.canvas, KEYS.Copy)
    hand.move((1.5, -2.0))
    QApplication.sendEvent(window.canvas, QEvent(QEvent.Type.Leave))
    qtbot.keySequence(window.canvas, KEYS.Paste)
    plane = window.canvas.plane
    assert np.add(*box(window.document.drawing[1].curve)) / 2 == pytest.approx([plane.x, plane.y])


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
        ("", "it holds no text: copy a curve"),
        ("Dear all,\nhello", "line 1, “Dear all,”, is no row of numbers: copy a curve"),
        ('{"format": "theditor", "version": 99, "curves": []}', "is 99, and 1 is the newest"),
        ('{"format": "theditor", "version": 1, "curves": []}', "has no curves: copy a curve"),
        ("1 2", "needs at least 2 control points, not 1"),
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


def test_the_picture_shows_the_curve_upright_and_as_large_as_on_screen(window):
    window.actions_by_name["copy"].trigger()
    picture = bytes(clipboard().mimeData().data(SVG_TYPE).data())
    (path,) = ET.fromstring(picture).iter(PATH)
    numbers = np.array(re.findall(r"-?[\d.]+(?:e-?\d+)?", path.get("d")), dtype=float).reshape(-1, 2)
    curve = window.document.drawing[0].curve
    joints = curve.joints * (1, -1) * window.canvas.plane.scale
    ends = np.vstack([numbers[:1], numbers[3::3]])
    apart = ends[:, None] - ends[0] - (joints - joints[0])
    assert np.hypot(*np.moveaxis(apart, -1, 0)).min(axis=0).max() < 1e-6
    image = QImage(300, 300, QImage.Format.Format_ARGB32)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    renderer = QSvgRenderer(QByteArray(picture))
    assert renderer.isValid()
    renderer.render(painter, QRectF(image.rect()))
    painter.end()
    colours = {image.pixelColor(x, y).name() for x in range(300) for y in range(300)}
    assert "#334155" in colours


def test_names_and_far_away_giants_make_valid_pictures():
    curve = Curve([(1e12, -1e12), (-1e12, 1e12), (1e12, 1e12), (0, 0)], closed=True)
    small = Curve(np.full((4, 2), 1e12))
    for items in ([Item(curve, "<&>")], [Item(small)], [Item(curve), Item(small)]):
        root = ET.fromstring(svg(items, 1e6))
        assert float(root.get("width")) <= 10_004 * 2
        assert [path.get("d")[-1] == "Z" for path in root.iter(PATH)] == [item.curve.closed for item in items]


@given(
    st.sampled_from([2, 3]),
    st.booleans(),
    st.sampled_from(["free", "clamped"]),
    st.lists(st.tuples(*[st.floats(-500, 500)] * 2), min_size=4, max_size=7),
    st.data(),
)
def test_beziers_follow_the_curve(degree, closed, ends, points, data):
    lambdas = data.draw(st.lists(st.floats(-20, 10), min_size=len(points), max_size=len(points)))
    curve = Curve(points, lambdas, degree, closed, ends)
    cubics = beziers(curve, TOLERANCE)
    assert np.array_equal(cubics[1:, 0], cubics[:-1, 3])
    assert np.array_equal(cubics[0, 0], curve(0.0))
    t = np.linspace(0, 1, 9)[:, None, None]
    b = (1 - t) ** 3 * cubics[:, 0] + 3 * t * (1 - t) ** 2 * cubics[:, 1]
    b = b + 3 * t**2 * (1 - t) * cubics[:, 2] + t**3 * cubics[:, 3]
    for place in b.reshape(-1, 2)[:: max(1, b.size // 16)]:
        assert nearest(curve, place)[1] < 1.5 * TOLERANCE


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
    assert window.selection.curves == (0, 1)
