import numpy as np
import pytest
from panel_hand import CTRL, NONE, SHIFT, Hand, some_curve
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication, QLabel

from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection
from theditor.panels import ShapePanel
from theditor.panels import lambda_scale as scale
from theditor.spline import INTERPOLATING, MAX_LAMBDA, Mode

KEY = Qt.Key
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def panel(document, selection, show):
    return show(ShapePanel(document, selection))


def title(panel):
    return panel.findChild(QLabel).text()


def lambdas(document):
    return document.drawing[0].curve.lambdas


def at(slider, value):
    """Pixel of λ on the slider's track."""
    return 8 + float(scale.position(value)) * (slider.width() - 16), 12


def test_the_heading_says_which_parameters_are_meant(panel, selection):
    assert title(panel) == "SHAPE · all λ"
    selection.select(points=[9])
    assert title(panel) == "SHAPE · λ₉ (1 point selected)"
    selection.select(points=(), segments=[4])
    assert title(panel) == "SHAPE · λ₅, λ₆ (segment 5)"


def test_one_drag_is_one_step_and_follows_the_hand(panel, document, selection):
    selection.select(points=[9])
    hand = Hand(panel.slider)
    hand.press(*at(panel.slider, 0.5))
    for target in (0.6, 0.7, 0.8):
        hand.move(*at(panel.slider, target))
        assert lambdas(document)[9] == pytest.approx(target, abs=0.02)
        assert panel.field.value() == lambdas(document)[9]
    assert document.undo_stack.count() == 0
    hand.release()
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "Change λ"
    document.undo()
    assert lambdas(document)[9] == 0.5
    assert panel.field.text() == "0.5"


def test_escape_takes_a_drag_back_and_keeps_what_could_be_redone(panel, document, selection, qtbot):
    selection.select(points=[9])
    before = document.drawing
    hand = Hand(panel.slider)
    hand.press(*at(panel.slider, 0.5))
    hand.move(*at(panel.slider, 3))
    assert document.drawing != before
    panel.slider.setFocus()
    qtbot.keyClick(panel.slider, KEY.Key_Escape)
    hand.move(*at(panel.slider, -3))
    hand.release()
    assert document.drawing == before
    assert document.undo_stack.count() == 0


def test_another_drawing_opened_in_mid_drag_is_left_alone(panel, document, selection):
    hand = Hand(panel.slider)
    hand.press(*at(panel.slider, 2))
    hand.move(*at(panel.slider, 3))
    other = Drawing([Item(some_curve([0.25] * 4), "Other")])
    document.start(other)
    hand.move(*at(panel.slider, -3))
    hand.release()
    assert document.drawing == other
    assert panel.field.value() == 0.25


@pytest.mark.parametrize("value", [0.0, 1.0, INTERPOLATING[3]])
def test_a_press_on_a_landmark_gives_its_exact_value_and_shift_does_not(panel, document, selection, value):
    selection.select(points=[7, 9])
    x, y = at(panel.slider, value)
    Hand(panel.slider).click(x + 4, y)
    assert lambdas(document)[[7, 9]].tolist() == [value, value]
    Hand(panel.slider).click(*at(panel.slider, -8))
    Hand(panel.slider).click(x + 4, y, SHIFT)
    assert lambdas(document)[9] == pytest.approx(value, abs=1.0)
    assert lambdas(document)[9] != value


def test_control_drags_ten_times_finer(panel, document, selection):
    selection.select(points=[9])
    hand = Hand(panel.slider)
    x, y = at(panel.slider, 0.5)
    hand.press(x, y)
    hand.move(x + 30, y, CTRL)
    hand.release()
    fine = lambdas(document)[9]
    assert scale.position(fine) - scale.position(0.5) == pytest.approx(
        3 / (panel.slider.width() - 16), rel=0.02
    )


def test_a_press_on_the_handle_changes_nothing(panel, document, selection):
    selection.select(points=[3])
    Hand(panel.slider).click(*at(panel.slider, INTERPOLATING[3]))
    assert document.undo_stack.count() == 0
    selection.select(points=[9])
    panel.field.entered.emit(400.0)
    Hand(panel.slider).click(*at(panel.slider, 400.0))
    assert lambdas(document)[9] == 400.0


def test_runs_of_arrow_keys_and_wheel_are_one_step_each_value_from_where_it_is(
    panel, document, selection, qtbot
):
    selection.select(points=[5, 9])
    panel.slider.setFocus()
    for _ in range(3):
        qtbot.keyClick(panel.slider, KEY.Key_Right)
    wheel(panel.slider, 1)
    assert document.undo_stack.count() == 1
    assert lambdas(document)[5] == 1.08
    assert lambdas(document)[9] == 0.54
    document.undo()
    assert lambdas(document)[[5, 9]].tolist() == [1.0, 0.5]


def test_the_wheel_without_the_focus_scrolls_and_changes_nothing(panel, document):
    panel.all_button.setFocus()
    for control in (panel.slider, panel.field):
        wheel(control, 1)
    assert document.undo_stack.count() == 0


def wheel(widget, notches):
    middle = QPointF(widget.rect().center())
    event = QWheelEvent(
        middle,
        widget.mapToGlobal(middle),
        QPoint(),
        QPoint(0, 120 * notches),
        Qt.MouseButton.NoButton,
        NONE,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(widget, event)


def test_page_keys_walk_the_landmarks(panel, document, selection, qtbot):
    selection.select(points=[9])
    panel.slider.setFocus()
    walk = []
    for _ in range(3):
        qtbot.keyClick(panel.slider, KEY.Key_PageUp)
        walk.append(lambdas(document)[9])
    assert walk == pytest.approx([1, 3.9411958835214436, INTERPOLATING[3]], abs=0)
    qtbot.keyClick(panel.slider, KEY.Key_Home)
    assert lambdas(document)[9] == scale.LOWEST


def test_mode_buttons_set_exact_values_and_show_them(panel, document, selection, qtbot):
    selection.select(points=[9])
    qtbot.mouseClick(panel.mode_buttons[Mode.INTERPOLATING], LEFT)
    assert lambdas(document)[9] == INTERPOLATING[3]
    assert [button.isChecked() for button in panel.mode_buttons.values()] == [False, False, True]
    qtbot.mouseClick(panel.mode_buttons[Mode.INTERPOLATING], LEFT)
    assert panel.mode_buttons[Mode.INTERPOLATING].isChecked()
    assert document.undo_stack.count() == 1


def test_all_acts_on_every_active_parameter_and_says_so(panel, document, selection, qtbot):
    selection.select(points=[9])
    assert not panel.all_button.isChecked()
    qtbot.mouseClick(panel.all_button, LEFT)
    assert panel.all_button.isChecked()
    assert panel.field.text() == ""
    assert panel.field.lineEdit().placeholderText() == "differ"
    qtbot.mouseClick(panel.mode_buttons[Mode.HYPERBOLIC], LEFT)
    assert lambdas(document).tolist() == [0.0] + [1.0] * 11 + [0.0]
    assert document.undo_stack.count() == 1


def test_linked_parameters_keep_their_differences_in_one_step_and_escape_takes_it_back(
    panel, document, selection, qtbot
):
    selection.select(points=[5, 9, 12])
    before = lambdas(document)
    qtbot.mouseClick(panel.link_button, LEFT)
    assert panel.field.value() == 0.75
    assert "mean" in panel.slider.toolTip()
    hand = Hand(panel.slider)
    hand.press(*at(panel.slider, 0.75))
    for target in (0.4, 2.0):
        hand.move(*at(panel.slider, target), SHIFT)
        assert lambdas(document)[[5, 9]].mean() == pytest.approx(target, abs=0.05)
        assert lambdas(document)[5] - lambdas(document)[9] == pytest.approx(0.5, abs=1e-12)
        assert panel.field.value() == lambdas(document)[[5, 9]].mean()
    panel.slider.setFocus()
    qtbot.keyClick(panel.slider, KEY.Key_Escape)
    hand.release()
    assert lambdas(document).tolist() == before.tolist()
    assert not document.undo_stack.canUndo()

    hand.press(*at(panel.slider, 0.75))
    hand.move(*at(panel.slider, 1.0))
    hand.release()
    assert lambdas(document)[[5, 9, 12]].tolist() == [1.25, 0.75, 0.0]
    assert document.undo_stack.count() == 1
    qtbot.keyClick(panel.slider, KEY.Key_Left)
    assert lambdas(document)[5] - lambdas(document)[9] == pytest.approx(0.5, abs=1e-12)
    assert lambdas(document)[[5, 9]].mean() == pytest.approx(0.98)
    document.undo_stack.setIndex(0)
    assert lambdas(document).tolist() == before.tolist()


def test_linked_parameters_take_a_typed_mean_and_stop_together_at_the_limit(
    panel, document, selection, qtbot
):
    qtbot.mouseClick(panel.link_button, LEFT)
    before = lambdas(document)[1:-1]
    for typed, expected in (("2.5", 2.5 - before.mean()), ("1e6", MAX_LAMBDA - before.max())):
        panel.field.setFocus()
        panel.field.selectAll()
        qtbot.keyClicks(panel.field, typed)
        qtbot.keyClick(panel.field, KEY.Key_Return)
        assert lambdas(document)[1:-1] == pytest.approx(before + expected, abs=1e-9)
    assert lambdas(document)[[0, 12]].tolist() == [0, 0]
    assert panel.field.value() == lambdas(document)[1:-1].mean()
    qtbot.mouseClick(panel.link_button, LEFT)
    assert panel.field.text() == ""
    qtbot.mouseClick(panel.mode_buttons[Mode.HYPERBOLIC], LEFT)
    assert (lambdas(document)[1:-1] == 1).all()


def test_looking_at_a_value_in_full_does_not_change_it(panel, document, selection, qtbot):
    selection.select(points=[3])
    panel.field.setFocus()
    qtbot.keyClick(panel.field, KEY.Key_Return)
    panel.slider.setFocus()
    assert document.undo_stack.count() == 0
    assert lambdas(document)[3] == INTERPOLATING[3]


def test_a_typed_value_beyond_the_scale_is_kept_exactly(panel, document, selection, qtbot):
    selection.select(points=[9])
    panel.field.setFocus()
    panel.field.selectAll()
    qtbot.keyClicks(panel.field, "-1234,0625")
    qtbot.keyClick(panel.field, KEY.Key_Return)
    assert lambdas(document)[9] == -1234.0625
    assert document.undo_stack.count() == 1


@pytest.mark.parametrize(
    ("kind", "point", "reason"),
    [
        ({}, 0, "λ₀ shapes nothing: the curve is open with free ends."),
        ({"ends": "clamped"}, 12, "λ₁₂ shapes nothing: at a clamped end the curvature is zero."),
        ({"degree": 2}, 0, "λ₀ shapes nothing: in an open quadratic λᵢ belongs to the edge from Pᵢ₋₁ to Pᵢ."),
    ],
)
def test_a_parameter_that_shapes_nothing_cannot_be_changed_and_says_why(show, kind, point, reason):
    document = Document(Drawing([Item(some_curve(**kind))]))
    selection = Selection(document)
    panel = show(ShapePanel(document, selection))
    selection.select(points=[point])
    controls = (panel.slider, panel.field, *panel.mode_buttons.values())
    assert not any(control.isEnabled() for control in controls)
    assert {control.toolTip() for control in controls} == {reason}
    selection.select(points=[point, 5])
    assert all(control.isEnabled() for control in controls)


def test_a_locked_curve_an_empty_drawing_and_an_undone_lock(show):
    document = Document(Drawing([Item(some_curve(), "Guarded", locked=True)]))
    panel = show(ShapePanel(document, Selection(document)))
    assert not panel.slider.isEnabled()
    assert "“Guarded” is locked" in panel.field.toolTip()
    document.apply("Unlock curve", Drawing([Item(some_curve(), "Guarded")]))
    assert panel.slider.isEnabled()
    document.apply("Delete curve", Drawing())
    assert not panel.slider.isEnabled()
    assert title(panel) == "SHAPE"
    document.undo()
    assert panel.slider.isEnabled()


def test_moving_points_leaves_the_controls_alone_and_every_parameter_shown_is_the_curves(panel, document):
    shown = []
    panel.slider.show_values = lambda values, *_: shown.append(np.array(values))
    curve = document.drawing[0].curve
    document.apply_curve("Move", 0, curve.with_points([2], [[5.0, 5.0]]))
    assert shown == []
    document.apply_curve("Change λ", 0, curve.with_lambdas([2], 0.25))
    assert shown[-1].tolist() == curve.with_lambdas([2], 0.25).lambdas[1:-1].tolist()


def test_points_on_two_curves_share_the_slider_and_take_each_degree_s_own_mode(panel, document, selection):
    selection.select_across({0: [9], 1: [2, 3]})
    assert title(panel) == "SHAPE · 3 points on 2 curves"
    hand = Hand(panel.slider)
    hand.press(*at(panel.slider, 0.5))
    hand.move(*at(panel.slider, 0.7))
    hand.release()
    ring = document.drawing[1].curve
    assert lambdas(document)[9] == ring.lambdas[2] == ring.lambdas[3] == pytest.approx(0.7, abs=0.02)
    panel.mode_buttons[Mode.INTERPOLATING].click()
    assert (lambdas(document)[9], document.drawing[1].curve.lambdas[2]) == (
        INTERPOLATING[3],
        INTERPOLATING[2],
    )
    assert panel.mode_buttons[Mode.INTERPOLATING].isChecked()
    assert document.undo_stack.count() == 2
    document.apply("Lock", document.drawing.with_item(1, document.drawing[1].with_(locked=True)))
    assert title(panel) == "SHAPE · λ₉ (1 point selected)"


def test_whole_curves_chosen_together_share_the_slider(panel, document, selection):
    selection.select_across({0: [], 1: []})
    assert title(panel) == "SHAPE · all λ on 2 curves"
    panel.mode_buttons[Mode.TRIGONOMETRIC].click()
    assert not lambdas(document).any()
    assert not document.drawing[1].curve.lambdas.any()
