import numpy as np
import pytest
from panel_hand import CTRL, SHIFT, Hand, some_curve
from PySide6.QtCore import QPoint, QSize, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPalette
from PySide6.QtWidgets import QWidget

from theditor.drawing import Drawing, Item
from theditor.model import DARK, LIGHT, Document, Selection
from theditor.panels import LambdaStrip
from theditor.panels import lambda_scale as scale
from theditor.spline import INTERPOLATING, Curve

KEY = Qt.Key


@pytest.fixture
def strip(document, selection, show):
    return show(LambdaStrip(document, selection), 858, 180)


@pytest.fixture
def hand(strip):
    return Hand(strip.viewport())


def at(strip, column, value):
    """Pixel of λ in a column's track."""
    x = strip.column_left(column) + 33
    return x, strip.track_top + (1 - float(scale.position(value))) * strip.track_height


def lambdas(document):
    return document.drawing[0].curve.lambdas


def test_dragging_a_column_changes_that_parameter_in_one_step(strip, hand, document):
    hand.press(*at(strip, 9, 0.5))
    for target in (0.6, 0.7, 2.5):
        hand.move(*at(strip, 9, target), SHIFT)
    hand.release()
    assert lambdas(document)[9] == pytest.approx(2.5, rel=0.05)
    assert np.delete(lambdas(document), 9).tolist() == np.delete(some_curve().lambdas, 9).tolist()
    assert document.undo_stack.count() == 1
    document.undo()
    assert lambdas(document)[9] == 0.5


def test_dragging_one_of_several_selected_columns_changes_all_of_them(strip, hand, document, selection):
    selection.select(points=[0, 2, 6, 9])
    hand.press(*at(strip, 6, 1))
    hand.move(*at(strip, 6, INTERPOLATING[3]))
    hand.release()
    assert lambdas(document)[[0, 2, 6, 9]].tolist() == [0.0] + [INTERPOLATING[3]] * 3


def test_dragging_across_paints_every_active_column_on_the_way_however_quick(strip, hand, document):
    hand.press(*at(strip, 9, 1.0))
    hand.move(*at(strip, 9, 1.02))
    hand.move(*at(strip, 12, 1.0))
    hand.release()
    assert lambdas(document)[9:].tolist() == [1.0, 1.0, 1.0, 0.0]
    assert document.undo_stack.count() == 1


def test_a_drag_that_begins_where_nothing_is_shaped_paints_what_it_crosses(strip, hand, document, selection):
    selection.select(points=[0, 2, 9])
    before = lambdas(document)
    hand.press(*at(strip, 0, 3.0))
    hand.move(*at(strip, 0, 2.9))
    assert lambdas(document).tolist() == before.tolist()
    for column in (1, 3):
        hand.move(*at(strip, column, 1.0))
    hand.release()
    assert lambdas(document)[:4].tolist() == [0.0, 1.0, 1.0, 1.0]
    assert lambdas(document)[4:].tolist() == before[4:].tolist()
    assert selection.points == {0, 2, 9}
    assert document.undo_stack.count() == 1


def test_painting_goes_on_across_selected_columns(strip, hand, document, selection):
    selection.select(points=[6, 7, 9])
    hand.press(*at(strip, 5, 0.0))
    for column in (6, 7, 8):
        hand.move(*at(strip, column, 0.0))
    hand.release()
    assert lambdas(document)[5:10].tolist() == [0.0, 0.0, 0.0, 0.0, 0.5]


def test_escape_takes_the_painting_back(strip, hand, document, qtbot):
    before = document.drawing
    hand.press(*at(strip, 5, 1))
    hand.move(*at(strip, 8, -3))
    assert document.drawing != before
    strip.setFocus()
    qtbot.keyClick(strip, KEY.Key_Escape)
    hand.move(*at(strip, 8, 3))
    hand.release()
    assert document.drawing == before
    assert document.undo_stack.count() == 0


def test_another_drawing_opened_in_mid_drag_is_left_alone(strip, hand, document):
    hand.press(*at(strip, 9, 1))
    hand.move(*at(strip, 9, 3))
    document.start(Drawing())
    hand.move(*at(strip, 9, -3))
    hand.release()
    assert document.drawing == Drawing()


def test_a_modes_value_attracts_the_drag_and_control_makes_it_fine(strip, hand, document):
    hand.press(*at(strip, 9, 0.5))
    x, y = at(strip, 9, 1)
    hand.move(x, y + 3)
    assert lambdas(document)[9] == 1.0
    hand.release()
    document.undo()
    x, y = at(strip, 9, 0.5)
    hand.press(x, y)
    hand.move(x, y - 10, CTRL)
    moved = float(scale.position(lambdas(document)[9]) - scale.position(0.5))
    assert moved == pytest.approx(1 / strip.track_height, rel=0.1)
    hand.release()


def test_a_click_selects_and_changes_nothing(strip, hand, document, selection):
    selection.select(segments=[2])
    hand.click(*at(strip, 9, -10))
    assert (selection.points, selection.segments) == ({9}, set())
    hand.click(*at(strip, 3, 0), SHIFT)
    assert selection.points == {3, 9}
    hand.click(*at(strip, 9, 0), SHIFT)
    assert selection.points == {3}
    assert document.undo_stack.count() == 0


def test_an_inactive_column_says_why_it_cannot_be_dragged(strip, hand, document, qtbot):
    reason = "λ₀ shapes nothing: the curve is open with free ends."
    hand.press(*at(strip, 0, 0))
    with qtbot.waitSignal(strip.announce) as said:
        hand.move(*at(strip, 0, 5))
    hand.release()
    assert said.args == [reason]
    assert reason in strip.tip(0)
    assert document.undo_stack.count() == 0


def test_tips_give_every_digit_and_the_mode(strip):
    assert strip.tip(3).split("\n") == [
        "λ₃ = 8.912056875738365 · interpolating",
        "Segment 2: basis function c₃ is negative near t = 0.77; the convex hull no longer bounds this segment",
        "Segment 3: basis functions c₀ (near t = 0.23) and c₃ (near t = 0.77) are negative; "
        "the convex hull no longer bounds this segment",
    ]
    assert strip.tip(9) == "λ₉ = 0.5 · blend"


def test_keys_select_columns_and_step_the_parameter(strip, document, selection, qtbot):
    selection.select(points=[8])
    strip.setFocus()
    qtbot.keyClick(strip, KEY.Key_Right)
    assert selection.points == {9}
    for _ in range(2):
        qtbot.keyClick(strip, KEY.Key_Up)
    assert lambdas(document)[9] == 0.52
    assert document.undo_stack.count() == 1
    qtbot.keyClick(strip, KEY.Key_PageDown)
    assert lambdas(document)[9] == 0.0
    qtbot.keyClick(strip, KEY.Key_End)
    assert selection.points == {12}


def test_bars_have_the_colour_of_their_mode_in_light_and_dark(strip):
    for colours in (LIGHT, DARK):
        palette = QPalette(strip.palette())
        palette.setColor(QPalette.ColorRole.Window, QColor(colours.panel))
        strip.setPalette(palette)
        picture = strip.viewport().grab().toImage()
        for column, colour in ((3, colours.interpolating), (5, colours.hyperbolic), (9, colours.blend)):
            x, top = at(strip, column, some_curve().lambdas[column])
            _, bottom = at(strip, column, 0)
            assert picture.pixelColor(x, round((top + 2 + bottom) / 2)).name() == colour.lower()


@pytest.fixture
def long_curve(qapp):
    angles = np.linspace(0, 900, 100_000)
    return Curve(np.c_[np.cos(angles), angles, np.sin(angles)], np.tile([0.0, 1.0, 0.5, 3.0], 25_000))


def test_a_hundred_thousand_columns_scroll_to_the_selected_one_and_paint_only_what_shows(show, long_curve):
    document = Document(Drawing([Item(long_curve)]))
    selection = Selection(document)
    strip = show(LambdaStrip(document, selection), 400, 200)
    selection.select(points=[99_000])
    x = strip.column_left(99_000)
    assert 0 <= x <= 400 - 44
    hand = Hand(strip.viewport())
    hand.press(x + 22, 60)
    hand.move(x + 22, 40)
    hand.release()
    changed = np.flatnonzero(lambdas(document) != long_curve.lambdas)
    assert changed.tolist() == [99_000]


def test_tips_say_what_happens_at_a_joint_of_a_low_parameter(strip, document):
    document.apply_curve("Change λ", 0, document.drawing[0].curve.with_lambdas(6, -3.0))
    assert strip.tip(6).split("\n") == [
        "λ₆ = −3 · blend",
        "λ₆ = −3 is below −2.648…: the second derivative at joint 6 is reversed, which adds inflections",
    ]


def test_a_parameter_that_makes_a_basis_function_negative_has_a_hatched_knob(strip, document):
    def pixels_of_knob(value):
        document.apply_curve("Change λ", 0, document.drawing[0].curve.with_lambdas(6, value))
        y = round(strip.track_top + (1 - float(scale.position(value))) * strip.track_height)
        left = strip.column_left(6) + (strip.column_left(7) - strip.column_left(6)) // 2 - 10
        image = strip.viewport().grab().toImage()
        return [image.pixelColor(left + x, y).lightness() for x in range(20)]

    assert np.ptp(pixels_of_knob(0.5)) == 0
    assert np.ptp(pixels_of_knob(6.0)) > 100


@pytest.mark.parametrize("ratio", [1.25, 1.5, 1.75])
def test_nothing_dark_is_left_at_the_edges_on_a_fine_screen(strip, ratio):
    size = strip.viewport().size()
    image = QImage((size + QSize(2, 2)) * ratio, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    image.fill(0)
    painter = QPainter(image)
    strip.viewport().render(painter, QPoint(1, 1), renderFlags=QWidget.RenderFlag(0))
    painter.end()
    ends = [[image.pixelColor(x, round(3 * ratio)).name() for x in range(image.width())]]
    ends += [[image.pixelColor(round(3 * ratio), y).name() for y in range(image.height())]]
    assert {end[k] for end in ends for k in (*range(4), *range(-4, 0))} == {"#000000", LIGHT.panel.lower()}
