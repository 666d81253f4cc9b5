"""The commands' icons: in the theme's colours, sharp on every screen; their words where there is room."""

import pytest
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QIcon
from PySide6.QtWidgets import QApplication, QMenu, QToolBar

from theditor.app.icons import SIZE, icon
from theditor.app.theme import Theme, apply_theme
from theditor.model import DARK, LIGHT

On, Off = QIcon.State.On, QIcon.State.Off
Normal, Disabled = QIcon.Mode.Normal, QIcon.Mode.Disabled


def picture(icon, ratio=1.0, mode=Normal, state=Off):
    return icon.pixmap(QSize(SIZE, SIZE), ratio, mode, state).toImage()


def pixels(image):
    return [image.pixelColor(x, y) for y in range(image.height()) for x in range(image.width())]


def inks(image):
    """The colours of the pixels that are wholly covered."""
    return {colour.name().upper() for colour in pixels(image) if colour.alpha() == 255}


def coverage(image):
    """How much of each pixel is covered, row by row."""
    return [[image.pixelColor(x, y).alphaF() for x in range(image.width())] for y in range(image.height())]


def toolbar(window):
    return window.findChild(QToolBar, "toolbar")


def buttons(window):
    return [action for action in toolbar(window).actions() if not action.isSeparator()]


def look_into_menus(window):
    """Show every menu for a moment: it is then that they draw their icons."""
    for menu in window.menuBar().findChildren(QMenu):
        menu.aboutToShow.emit()


def test_each_button_has_a_picture_of_its_own(window):
    pictures = [coverage(picture(action.icon())) for action in buttons(window)]
    assert len(pictures) > 10
    for k, drawn in enumerate(pictures):
        assert 0.05 < sum(map(sum, drawn)) / SIZE**2 < 0.6
        assert drawn not in pictures[:k]


def test_icons_take_the_colours_of_the_theme_and_change_with_it(window):
    look_into_menus(window)
    for theme, colours in ((Theme.LIGHT, LIGHT), (Theme.DARK, DARK)):
        apply_theme(theme)
        QApplication.processEvents()
        for command in window.commands:
            if not command.icon:
                continue
            shown = window.actions_by_name[command.name].icon()
            assert inks(picture(shown)) == {colours.text}
            assert inks(picture(shown, state=On)) == {colours.accent_text}
            (faded,) = inks(picture(shown, mode=Disabled))
            assert inks(picture(shown, mode=Disabled, state=On)) == {faded}
            ground = QColor(colours.panel).lightness()
            distance = [abs(QColor(c).lightness() - ground) for c in (faded, colours.secondary)]
            assert 30 < distance[0] < distance[1]


@pytest.mark.parametrize("ratio", [1.0, 1.5, 2.0, 3.0])
def test_icons_are_sharp_at_every_scale(window, ratio):
    for command in window.commands:
        if command.brief:
            image = picture(icon(command.icon, window.palette(), [ratio]), ratio)
            assert (image.width(), image.height()) == (SIZE * ratio, SIZE * ratio)
    drawn = picture(icon("hyperbolic", window.palette(), [ratio]), ratio)
    stem = coverage(drawn)[int(5 * ratio)]
    # An upright stroke of 1½ pixels: its own width of ink, in as few device pixels as can hold it.
    left = stem[: len(stem) // 2]
    assert sum(left) == pytest.approx(1.5 * ratio, abs=0.1)
    assert sum(value > 0.02 for value in left) <= 1.5 * ratio + 2


def test_words_stand_beside_the_icons_where_there_is_room(window):
    bar = toolbar(window)

    def shown():
        QApplication.processEvents()
        widgets = [bar.widgetForAction(action) for action in buttons(window)]
        return bar.toolButtonStyle(), [w for w in widgets if w.isVisible()]

    window.resize(1800, 860)
    style, visible = shown()
    assert style == Qt.ToolButtonStyle.ToolButtonTextBesideIcon
    assert len(visible) == len(buttons(window))
    window.resize(1024, 700)
    style, visible = shown()
    assert window.width() == 1024
    assert style == Qt.ToolButtonStyle.ToolButtonIconOnly
    assert len(visible) == len(buttons(window))
    assert all(action.toolTip() for action in buttons(window))
    window.resize(1800, 860)
    assert shown()[0] == Qt.ToolButtonStyle.ToolButtonTextBesideIcon


def test_menus_draw_their_icons_when_they_are_shown(window):
    new, insert = (window.actions_by_name[name] for name in ("new", "insert_point"))
    assert new.icon().isNull()
    next(a for a in window.menuBar().actions() if a.text() == "&File").menu().aboutToShow.emit()
    assert inks(picture(new.icon())) == {LIGHT.text}
    assert insert.icon().isNull()
    assert insert in window.context_menus.menu("segment").actions()
    assert inks(picture(insert.icon())) == {LIGHT.text}


def test_a_checked_command_keeps_its_check_mark_in_the_menus(window):
    look_into_menus(window)
    shown = {
        name
        for name, a in window.actions_by_name.items()
        if not a.icon().isNull() and a.isIconVisibleInMenu()
    }
    assert {"new", "open", "save", "undo", "trigonometric", "insert_point", "fit"} <= shown
    assert not any(window.actions_by_name[name].isCheckable() for name in shown)
