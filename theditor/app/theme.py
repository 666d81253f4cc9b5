"""Light and dark: the palette and the style sheet, made from the one set of colours."""

from __future__ import annotations

from enum import StrEnum
from string import Template

from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QApplication

from theditor.model import DARK, LIGHT, Colours
from theditor.resources import resource


class Theme(StrEnum):
    """What the user chose."""

    SYSTEM = "system"
    LIGHT = "light"
    DARK = "dark"


def chosen_theme() -> Theme:
    """The theme kept in the user's settings."""
    kept = str(QSettings().value("theme", Theme.SYSTEM.value))
    return Theme(kept) if kept in tuple(Theme) else Theme.SYSTEM


def choose_theme(theme: Theme) -> None:
    """Use a theme from now on, and keep the choice in the user's settings."""
    QSettings().setValue("theme", theme.value)
    apply_theme(theme)


def apply_theme(theme: Theme) -> None:
    """Give the whole application the colours of a theme."""
    app = QApplication.instance()
    if isinstance(app, QApplication):
        colours = _colours(theme)
        app.setPalette(palette(colours))
        app.setStyleSheet(style_sheet(colours))


def follow_system() -> None:
    """Apply the chosen theme now, and again whenever the system turns dark or light."""
    apply_theme(chosen_theme())
    QApplication.styleHints().colorSchemeChanged.connect(lambda _scheme: apply_theme(chosen_theme()))


def _colours(theme: Theme) -> Colours:
    if theme is Theme.SYSTEM:
        dark = QApplication.styleHints().colorScheme() == Qt.ColorScheme.Dark
        return DARK if dark else LIGHT
    return DARK if theme is Theme.DARK else LIGHT


def palette(colours: Colours) -> QPalette:
    """The palette for standard widgets; its window colour is also how views tell light from dark."""
    result = QPalette()
    role = QPalette.ColorRole
    for target, colour in {
        role.Window: colours.window,
        role.WindowText: colours.text,
        role.Base: colours.canvas,
        role.AlternateBase: colours.panel,
        role.ToolTipBase: colours.panel,
        role.ToolTipText: colours.text,
        role.PlaceholderText: colours.secondary,
        role.Text: colours.text,
        role.Button: colours.panel,
        role.ButtonText: colours.text,
        role.Highlight: colours.selection,
        role.HighlightedText: colours.accent_text,
        role.Link: colours.accent_text,
        role.Accent: colours.accent,
        role.Mid: colours.border,
    }.items():
        result.setColor(target, QColor(colour))
    for target in (role.WindowText, role.Text, role.ButtonText):
        result.setColor(QPalette.ColorGroup.Disabled, target, QColor(_faded(colours)))
    return result


def _faded(colours: Colours) -> str:
    """Half-way between secondary text and the panel: what cannot be used now."""
    one, other = QColor(colours.secondary), QColor(colours.panel)
    red, green, blue = (one.red() + other.red(), one.green() + other.green(), one.blue() + other.blue())
    return QColor(red // 2, green // 2, blue // 2).name()


def style_sheet(colours: Colours) -> str:
    """The style sheet on top of Qt's Fusion style: a 4-pixel grid, 26-pixel controls, 6-pixel corners."""
    on_accent = "#FFFFFF" if QColor(colours.accent).lightness() < 160 else "#10151C"
    icons = resource("icons").as_posix()
    return Template(_SHEET).substitute(
        colours._asdict(), faded=_faded(colours), on_accent=on_accent, icons=icons
    )


_SHEET = """
QMainWindow, QDialog { background: $window; }
QMenuBar { background: $panel; border-bottom: 1px solid $border; padding: 2px 6px; }
QMenuBar::item { padding: 4px 10px; border-radius: 6px; background: transparent; color: $text; }
QMenuBar::item:selected { background: $selection; color: $accent_text; }
QMenu { background: $panel; border: 1px solid $border; padding: 4px; color: $text; }
QMenu::item { padding: 5px 28px 5px 24px; border-radius: 4px; }
QMenu::item:selected { background: $selection; color: $accent_text; }
QMenu::item:disabled { color: $faded; }
QMenu::icon { padding-left: 8px; }
QMenu::indicator { width: 12px; height: 12px; margin-left: 8px; }
QMenu::indicator:checked { image: url($icons/check.svg); }
QMenu::separator { height: 1px; background: $border; margin: 4px 8px; }
QToolBar { background: $panel; border: none; border-bottom: 1px solid $border; padding: 5px 8px; spacing: 2px; }
QToolBar::separator { width: 1px; background: $border; margin: 5px 10px; }
QToolBar QToolButton { color: $text; background: transparent; border: none; border-radius: 6px; padding: 5px 10px; }
QToolBar QToolButton:hover { background: $window; }
QToolBar QToolButton:pressed { background: $border; }
QToolBar QToolButton:checked { background: $selection; color: $accent_text; font-weight: 600; }
QToolBar QToolButton:disabled { color: $faded; }
QToolBar QToolButton:focus { border: 1px solid $accent; }
QStatusBar { background: $panel; border-top: 1px solid $border; color: $secondary; }
QStatusBar::item { border: none; }
QStatusBar QLabel { color: $secondary; padding: 2px 8px; }
QStatusBar QLabel[role="strong"] { color: $text; font-weight: 600; }
QDockWidget {
    color: $secondary; titlebar-close-icon: url($icons/close.svg); titlebar-normal-icon: url($icons/float.svg);
}
QDockWidget::close-button, QDockWidget::float-button { background: transparent; border: none; padding: 1px; }
QDockWidget::close-button:hover, QDockWidget::float-button:hover { background: $selection; border-radius: 4px; }
QDockWidget::title { background: $panel; padding: 8px 16px 4px 16px; text-align: left; }
QDockWidget > QWidget { background: $panel; }
QMainWindow::separator { background: $border; width: 1px; height: 1px; }
QMainWindow::separator:hover { background: $accent; }
QScrollArea, QScrollArea > QWidget > QWidget { background: $panel; border: none; }
QLabel { color: $text; background: transparent; }
QLabel[role="heading"] { color: $secondary; font-size: 11px; font-weight: 600; }
QLabel[role="secondary"] { color: $secondary; }
QLabel:disabled { color: $faded; }
QLineEdit, QAbstractSpinBox, QComboBox {
    background: $canvas; color: $text; border: 1px solid $border; border-radius: 6px;
    min-height: 24px; padding: 0 9px; selection-background-color: $accent; selection-color: $on_accent;
}
QLineEdit:focus, QAbstractSpinBox:focus, QComboBox:focus { border-color: $accent; }
QLineEdit:disabled, QAbstractSpinBox:disabled, QComboBox:disabled { color: $faded; background: $panel; }
/* Qt gives the text no room unless the missing buttons have a width. */
NumberField::up-button, NumberField::down-button { width: 0; subcontrol-origin: border; }
QComboBox::drop-down { border: none; width: 24px; }
QComboBox::down-arrow { image: url($icons/chevron.svg); width: 12px; height: 12px; }
QComboBox QAbstractItemView {
    background: $panel; color: $text; border: 1px solid $border; outline: none;
    selection-background-color: $selection; selection-color: $accent_text;
}
QPushButton, QToolButton {
    background: $canvas; color: $text; border: 1px solid $border; border-radius: 6px; min-height: 24px; padding: 0 10px;
}
QToolBar QToolButton { min-height: 18px; }
QFileDialog QToolButton { padding: 3px; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QPushButton:hover, QToolButton:hover { border-color: $secondary; }
QPushButton:pressed, QToolButton:pressed { background: $selection; }
QPushButton:focus, QToolButton:focus { border-color: $accent; }
QPushButton:checked, QToolButton:checked { background: $accent; color: $on_accent; border-color: $accent; }
QToolButton:checked:focus, QPushButton:checked:focus { border-color: $text; }
QPushButton:disabled, QToolButton:disabled { color: $faded; background: $panel; }
QPushButton:default { border-color: $accent; }
QToolButton[segment="left"] { border-top-right-radius: 0; border-bottom-right-radius: 0; border-right: none; }
QToolButton[segment="middle"] { border-radius: 0; }
QToolButton[segment="right"] { border-top-left-radius: 0; border-bottom-left-radius: 0; border-left: none; }
QPushButton { min-width: 56px; }
QListView, QTableView { background: $panel; color: $text; border: 1px solid $panel; outline: none; }
LambdaStrip { border: 1px solid $panel; }
QListView:focus, QTableView:focus, LambdaStrip:focus { border-color: $accent; }
QListView::item:selected { background: $selection; color: $accent_text; }
QTableView::item { padding: 0 7px; }
QTableView::item:selected { background: $selection; color: $accent_text; }
QHeaderView { background: $panel; border: none; }
QHeaderView::section {
    background: $panel; color: $secondary; border: none; border-bottom: 1px solid $border; padding: 4px 7px;
}
QHeaderView::section:vertical { border: none; }
QTableCornerButton::section { background: $panel; border: none; border-bottom: 1px solid $border; }
QTabBar { background: $panel; qproperty-drawBase: 0; }
QTabBar::tab {
    background: $panel; color: $secondary; padding: 8px 12px; border: none; border-bottom: 2px solid $border;
}
QTabBar::tab:selected { color: $text; border-bottom: 2px solid $accent; font-weight: 600; }
QTabBar::tab:hover { color: $text; }
QSlider::groove:horizontal { height: 4px; border-radius: 2px; background: $border; }
QSlider::sub-page:horizontal { height: 4px; border-radius: 2px; background: $accent; }
QSlider::handle:horizontal { background: $accent; width: 12px; margin: -4px 0; border-radius: 6px; }
QSlider::handle:horizontal:focus, QSlider::handle:horizontal:hover { background: $accent_text; }
QCheckBox { color: $text; spacing: 6px; }
QCheckBox:disabled { color: $faded; }
QCheckBox::indicator {
    width: 14px; height: 14px; background: $canvas; border: 1px solid $secondary; border-radius: 4px;
}
QCheckBox::indicator:checked { background: $selection; border-color: $accent; image: url($icons/check.svg); }
QCheckBox::indicator:focus, QCheckBox::indicator:hover { border-color: $accent; }
QCheckBox::indicator:disabled { background: $panel; border-color: $border; }
QLabel[role="paper"] { background: #FFFFFF; border: 1px solid $border; color: #1B2430; }
QProgressBar { background: $border; border: none; border-radius: 2px; max-height: 4px; }
QProgressBar::chunk { background: $accent; border-radius: 2px; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle { background: $border; border-radius: 3px; margin: 2px; min-width: 24px; min-height: 24px; }
QScrollBar::handle:hover { background: $secondary; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QToolTip { background: $panel; color: $text; border: 1px solid $border; padding: 4px 6px; }
QFrame[role="rule"] { background: $border; max-height: 1px; min-height: 1px; border: none; }
QFrame[role="message"] { background: $selection; border-bottom: 1px solid $accent; }
QFrame[role="card"] { background: $panel; border: 1px solid $border; border-radius: 6px; }
QFrame[role="card"] QLabel { color: $secondary; }
QFrame[role="guide"] { background: $panel; border-bottom: 1px solid $border; }
QFrame[role="message"] QLabel { color: $text; }
"""
