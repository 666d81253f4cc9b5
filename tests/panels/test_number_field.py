import random

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QKeySequence, QShortcut
from PySide6.QtWidgets import QLineEdit, QVBoxLayout, QWidget

from theditor.panels.number_field import NumberField
from theditor.spline import INTERPOLATING

KEY = Qt.Key


@pytest.fixture
def field(show):
    """A number field, beside another widget that can take the focus."""
    window = QWidget()
    layout = QVBoxLayout(window)
    window.field, window.other = NumberField(-1e6, 1e6), QLineEdit()
    layout.addWidget(window.field)
    layout.addWidget(window.other)
    show(window)
    window.other.setFocus()
    window.field.seen = []
    window.field.entered.connect(window.field.seen.append)
    window.field.leave = window.other.setFocus
    window.field.owner = window  # keeps it alive
    return window.field


def retype(qtbot, field, text):
    field.setFocus()
    field.selectAll()
    qtbot.keyClick(field, KEY.Key_Delete)
    if text.isascii():
        qtbot.keyClicks(field, text)
    else:
        QGuiApplication.clipboard().setText(text)
        qtbot.keySequence(field, QKeySequence.StandardKey.Paste)


def test_six_digits_at_rest_and_every_digit_with_the_focus(field):
    field.show_value(INTERPOLATING[3])
    assert field.text() == "8.91206"
    field.setFocus()
    assert float(field.text()) == INTERPOLATING[3]
    field.leave()
    assert field.text() == "8.91206"


def test_looking_and_enter_change_no_bit_of_any_number(qtbot, field):
    chance = random.Random(242469)
    numbers = [chance.uniform(-1, 1) * 10 ** chance.uniform(-12, 6) for _ in range(40)]
    for number in [*numbers, INTERPOLATING[2], 1 / 3, 1e6, 1e-300]:
        field.show_value(number)
        field.setFocus()
        qtbot.keyClick(field, KEY.Key_Return)
        field.leave()
        assert field.value() == number
    assert field.seen == []


@pytest.mark.parametrize(
    ("text", "number"), [("0.25", 0.25), ("0,25", 0.25), ("-3e2", -300.0), ("−1.5", -1.5), (".5", 0.5)]
)
def test_typed_numbers_arrive_once_on_enter(qtbot, field, text, number):
    retype(qtbot, field, text)
    assert field.seen == []
    qtbot.keyClick(field, KEY.Key_Return)
    field.leave()
    assert field.seen == [number]


def test_typed_numbers_arrive_when_the_focus_leaves(qtbot, field):
    retype(qtbot, field, "0.1234567890123")
    field.leave()
    assert field.seen == [0.1234567890123]
    assert field.text() == "0.123457"


@pytest.mark.parametrize(
    ("text", "number"), [("+1.5", 2.25), ("*2", 1.5), ("/3", 0.25), ("0.75-2", -1.25), ("2/5", 0.4)]
)
def test_arithmetic_and_changes_of_the_value_shown(qtbot, field, text, number):
    field.show_value(0.75)
    retype(qtbot, field, text)
    qtbot.keyClick(field, KEY.Key_Return)
    field.leave()
    assert field.seen == [number]
    assert float(field.text()) == number


@pytest.mark.parametrize("text", ["abc", "", "1e7", "nan", "1..2", "*1e7", "1/0"])
def test_bad_text_is_refused_in_words_and_the_old_value_kept(qtbot, field, text):
    field.show_value(0.75)
    retype(qtbot, field, text)
    with qtbot.waitSignal(field.refused) as refused:
        qtbot.keyClick(field, KEY.Key_Return)
    assert "-1000000 to 1000000" in refused.args[0]
    assert (field.value(), field.text(), field.seen) == (0.75, "0.75", [])


def test_escape_puts_the_old_text_back(qtbot, field):
    field.show_value(0.75)
    retype(qtbot, field, "3")
    qtbot.keyClick(field, KEY.Key_Escape)
    field.leave()
    assert (field.text(), field.seen) == ("0.75", [])


def test_values_that_differ_show_so_and_take_any_number_even_the_one_last_shown(qtbot, field):
    field.show_value(1.0)
    field.show_value(None)
    assert field.text() == ""
    assert field.lineEdit().placeholderText() == "differ"
    field.setFocus()
    field.leave()
    assert field.seen == []
    retype(qtbot, field, "+1")
    with qtbot.waitSignal(field.refused):
        qtbot.keyClick(field, KEY.Key_Return)
    assert (field.text(), field.seen) == ("", [])
    retype(qtbot, field, "1")
    qtbot.keyClick(field, KEY.Key_Return)
    assert field.seen == [1.0]
    assert field.text() == "1"


def test_undo_is_the_documents_unless_something_was_typed(qtbot, field):
    undone = []
    shortcut = QShortcut(QKeySequence.StandardKey.Undo, field.owner)
    shortcut.activated.connect(lambda: undone.append("document"))
    field.show_value(0.75)
    field.setFocus()
    qtbot.keySequence(field, QKeySequence.StandardKey.Undo)
    assert undone == ["document"]
    qtbot.keyClicks(field, "3")
    qtbot.keySequence(field, QKeySequence.StandardKey.Undo)
    assert undone == ["document"]
    assert field.text() == "0.75"


def test_arrow_keys_ask_for_steps(qtbot, field):
    field.setFocus()
    steps = []
    field.stepped.connect(steps.append)
    qtbot.keyClick(field, KEY.Key_Up)
    qtbot.keyClick(field, KEY.Key_Down)
    assert steps == [1, -1]
    assert field.seen == []
