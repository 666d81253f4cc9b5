"""The guided gallery: a picture brings its panels along and says what to try."""

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QDockWidget, QPushButton

from theditor.app.gallery_dialog import GalleryDialog
from theditor.app.tour import lead
from theditor.resources import gallery

PICTURES = {picture.name: picture for picture in gallery()}


@pytest.mark.parametrize("command", ["gallery", "tour"])
def test_a_picture_chosen_in_the_gallery_says_what_to_try(window, qtbot, command):
    def choose():
        dialog = QApplication.activeModalWidget()
        assert isinstance(dialog, GalleryDialog)
        dialog._list.setCurrentRow(1)
        dialog.accept()

    QTimer.singleShot(0, choose)
    window.actions_by_name[command].trigger()
    assert window.document.title == "Figure 2"
    assert window.guide.isVisible()
    assert window.guide.text == PICTURES["figure-02"].about
    assert (window.selection.curve, window.selection.points) == (1, {5})
    window.guide.findChild(QPushButton).click()
    assert not window.guide.isVisible()


def test_the_guide_leaves_with_its_picture(window):
    lead(window, PICTURES["sine"])
    window.actions_by_name["new"].trigger()
    assert not window.guide.isVisible()


@pytest.mark.parametrize("name", PICTURES)
def test_every_setup_is_what_the_window_has(window, qtbot, name):
    picture = PICTURES[name]
    setup = picture.setup
    lead(window, picture)
    dock = window.findChild(QDockWidget, setup.panel)
    qtbot.waitUntil(lambda: not dock.visibleRegion().isEmpty())
    assert window.selection.curve == setup.curve
    assert window.selection.points == set(setup.points)
    first = window.selection.item.curve.first_segment
    assert {s + first for s in window.selection.segments} == set(setup.segments)
    assert all(getattr(window.canvas.shown, shown) for shown in setup.show)
    assert window.document.undo_stack.count() == 0
    assert window.document.is_clean


def test_what_one_picture_shows_is_hidden_with_the_next_and_the_users_choice_is_kept(window):
    window.actions_by_name["show_grid"].trigger()
    lead(window, PICTURES["figure-08"])
    assert window.canvas.shown.comb
    lead(window, PICTURES["figure-09"])
    assert not window.canvas.shown.comb
    assert not window.actions_by_name["show_comb"].isChecked()
    assert not window.canvas.shown.grid
