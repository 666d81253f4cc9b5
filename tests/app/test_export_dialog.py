"""Export: the dialog by keyboard, the file, what is told, what is remembered, and what goes wrong."""

import numpy as np
import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QImage, QKeySequence
from PySide6.QtWidgets import QApplication, QCheckBox, QComboBox, QFileDialog, QLabel, QMessageBox

from theditor.app.export_dialog import ExportDialog
from theditor.app.kept_options import kept_options
from theditor.drawing import Drawing
from theditor.exchange import Options, writable
from theditor.exchange.embedded import extract
from theditor.panels.number_field import NumberField
from theditor.spline import bounds

ALT = Qt.KeyboardModifier.AltModifier


@pytest.fixture
def chosen(monkeypatch):
    """Answers the dialog for files with a path; the list fills with what it was asked for."""

    def prepare(path):
        asked = []

        def answer(parent, title, suggestion, form):
            asked.append((suggestion, form))
            return str(path or ""), form

        monkeypatch.setattr(QFileDialog, "getSaveFileName", answer)
        return asked

    return prepare


def opened(window, qtbot):
    window.actions_by_name["export"].trigger()
    return active(window, qtbot)


def active(window, qtbot):
    dialog = window.findChildren(ExportDialog)[-1]
    qtbot.waitUntil(dialog.isActiveWindow)
    return dialog


@pytest.fixture
def dialog(window, qtbot):
    return opened(window, qtbot)


def press(qtbot, key, keys=Qt.KeyboardModifier.NoModifier):
    qtbot.keyClick(QApplication.focusWidget(), key, keys)


def test_a_picture_is_exported_by_keys_alone(window, qtbot, chosen, tmp_path):
    asked = chosen(tmp_path / "figure.png")
    qtbot.keySequence(window.canvas, QKeySequence("Ctrl+E"))
    active(window, qtbot)
    press(qtbot, Qt.Key.Key_F, ALT)
    qtbot.keyClicks(QApplication.focusWidget(), "PNG")
    press(qtbot, Qt.Key.Key_S, ALT)
    press(qtbot, Qt.Key.Key_Down)
    press(qtbot, Qt.Key.Key_Tab)
    qtbot.keyClicks(QApplication.focusWidget(), "300")
    press(qtbot, Qt.Key.Key_T, ALT)
    press(qtbot, Qt.Key.Key_E, ALT)
    qtbot.waitUntil(lambda: window.announced.startswith("Exported “figure.png”. "))
    assert asked[0][0].endswith("Figure 10.png")
    picture = QImage(str(tmp_path / "figure.png"))
    (low, high) = bounds(window.document.drawing[0].curve)
    assert max(picture.width(), picture.height()) == 300
    assert picture.width() / picture.height() == pytest.approx(np.divide(*(high - low)), rel=0.05)
    assert picture.pixelColor(0, 0).alpha() == 0

    again = opened(window, qtbot)
    assert (again.suffix, again.options()) == (".png", Options(size=300.0, transparent=True))
    again.reject()


def test_what_is_exported_as_svg_is_the_drawing_itself(window, qtbot, chosen, dialog, tmp_path):
    chosen(tmp_path / "figure.svg")
    dialog.parts["polygon"].setChecked(True)
    press(qtbot, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: "Exported" in window.announced)
    assert "The largest deviation is" in window.announced
    data = (tmp_path / "figure.svg").read_bytes()
    assert extract(data).drawing == window.document.drawing
    assert b'id="polygon"' in data
    assert window.document.is_clean


def test_each_format_is_asked_for_what_concerns_it(dialog):
    concerned = {
        ".svg": {"parts", "print_style", "measure", "tolerance"},
        ".pdf": {"parts", "print_style", "measure", "tolerance"},
        ".png": {"parts", "print_style", "measure", "dpi", "transparent", "tolerance"},
        ".dxf": {"tolerance"},
        ".tex": {"parts", "print_style", "measure", "tolerance"},
        ".csv": {"sampling", "samples", "tangent", "curvature"},
    }
    names = set().union(*concerned.values())
    assert concerned.keys() == set(writable())
    for suffix, expected in concerned.items():
        dialog.format.setCurrentIndex(dialog.format.findData(suffix))
        fields = {name: getattr(dialog, name) for name in names} | {"parts": dialog.parts["comb"]}
        assert {name for name, field in fields.items() if field.isVisible()} == expected, suffix
        letters = [
            text[text.index("&") + 1].lower()
            for widget in (*dialog.findChildren(QLabel), *dialog.findChildren(QCheckBox), dialog.button)
            if widget.isVisible() and "&" in (text := widget.text()) and widget is not dialog.preview
        ]
        assert len(set(letters)) == len(letters), suffix
        assert dialog.width() <= 1024
        assert dialog.height() <= 700
    kinds = (QCheckBox, QComboBox, NumberField)
    assert all(field.accessibleName() for kind in kinds for field in dialog.findChildren(kind))
    dialog.sampling.setCurrentIndex(dialog.sampling.findData("tolerance"))
    assert (dialog.tolerance.isVisible(), dialog.samples.isVisible()) == (True, False)


def test_the_preview_shows_what_is_asked_for(window, dialog):
    def ink():
        QApplication.processEvents()
        image = dialog.preview.pixmap().toImage()
        return sum(
            image.pixelColor(x, y).lightness() < 250
            for x in range(image.width())
            for y in range(image.height())
        )

    curve = ink()
    dialog.parts["comb"].setChecked(True)
    assert ink() > curve
    dialog.format.setCurrentIndex(dialog.format.findData(".csv"))
    QApplication.processEvents()
    assert dialog.preview.text().startswith("x,y,u\n0.0,0.0,0.0\n")


def test_what_is_selected_can_be_exported_alone(window, qtbot, chosen, tmp_path):
    drawing = window.document.drawing
    for k in range(1, 4):
        item = drawing[0].with_(name=f"Curve {k}", visible=k != 3)
        window.document.apply("Add", window.document.drawing.inserted(k, item))
    window.selection.select_across({1: [], 2: [], 3: []}, curve=2)
    dialog = opened(window, qtbot)
    assert dialog.curves.isVisible()
    assert [dialog.curves.itemText(k) for k in range(2)] == ["All", "The 2 selected"]
    dialog.curves.setCurrentIndex(1)
    dialog.format.setCurrentIndex(dialog.format.findData(".svg"))
    chosen(tmp_path / "some.svg")
    dialog.button.click()
    qtbot.waitUntil(lambda: not window.work.jobs)
    data = (tmp_path / "some.svg").read_bytes()
    assert [item.name for item in extract(data).drawing] == ["Curve 1", "Curve 2", "Curve 3"]
    assert data.count(b"<path") == 2


def test_one_curve_leaves_nothing_to_choose_from(dialog):
    assert not dialog.curves.isVisible()
    assert len(dialog.drawing) == 1


def test_print_style_ticks_what_it_draws_and_gives_back_what_was_ticked(dialog):
    def ticked():
        return {part for part, box in dialog.parts.items() if box.isChecked()}

    dialog.parts["points"].setChecked(True)
    dialog.print_style.click()
    assert ticked() == {"polygon", "points", "labels"}
    assert [box.isEnabled() for box in dialog.parts.values()] == [part == "comb" for part in dialog.parts]
    dialog.parts["comb"].click()
    for suffix in (".csv", ".pdf", ".svg"):
        dialog.format.setCurrentIndex(dialog.format.findData(suffix))
        assert dialog.print_style.isChecked() == (suffix == ".svg")
    assert ticked() == {"polygon", "points", "labels", "comb"}
    assert dialog.options().show == {"points", "comb"}
    dialog.print_style.click()
    assert ticked() == {"points", "comb"}
    assert all(box.isEnabled() for box in dialog.parts.values())


def test_what_is_no_number_is_told_and_bars_the_export(dialog, qtbot):
    dialog.tolerance.setFocus()
    dialog.tolerance.selectAll()
    qtbot.keyClicks(dialog.tolerance, "half")
    assert "“half” is no number" in dialog.sentence.text()
    assert not dialog.button.isEnabled()
    dialog.tolerance.selectAll()
    qtbot.keyClicks(dialog.tolerance, "1e-6")
    assert (dialog.sentence.text(), dialog.button.isEnabled()) == ("", True)
    assert dialog.options().tolerance == 1e-6


def test_who_thinks_better_of_the_file_is_back_in_the_dialog(window, dialog, qtbot, chosen):
    asked = chosen(None)
    dialog.button.click()
    assert len(asked) == 1
    assert dialog.isVisible()
    press(qtbot, Qt.Key.Key_Escape)
    assert window.work.jobs == ()


@pytest.mark.parametrize("answer", ["Yes", "Cancel"])
def test_a_name_that_is_completed_replaces_no_file_unasked(
    window, dialog, chosen, monkeypatch, qtbot, tmp_path, answer
):
    (tmp_path / "fig.1.svg").write_text("mine")
    chosen(tmp_path / "fig.1")
    asked = []

    def question(parent, title, words, *rest):
        asked.append(words)
        return QMessageBox.StandardButton[answer]

    monkeypatch.setattr(QMessageBox, "question", question)
    dialog.button.click()
    assert asked == ["“fig.1.svg” exists already. Replace it?"]
    qtbot.waitUntil(lambda: not window.work.jobs)
    assert ((tmp_path / "fig.1.svg").read_text() == "mine") == (answer == "Cancel")


def test_a_file_that_cannot_be_written_is_told_and_nothing_is_lost(window, dialog, chosen, qtbot, tmp_path):
    drawing = window.document.drawing
    chosen(tmp_path / "gone" / "figure.svg")
    dialog.button.click()
    qtbot.waitUntil(lambda: "cannot be saved: there is no folder" in window.messages.text)
    assert "figure.svg" in window.messages.text
    assert window.document.drawing is drawing


def test_settings_that_nobody_understands_are_passed_over(window):
    for text in ("{", "[1]", '{"tolerance": "much"}', '{"size": 1, "scale": 1}', '{"new": 1}'):
        QSettings().setValue("export/options.svg", text)
        assert kept_options("export", ".svg") == Options()


def test_an_empty_drawing_has_nothing_to_export(window):
    window.document.start(Drawing())
    assert not window.actions_by_name["export"].isEnabled()
