"""Opens the window's dialogs. Each is loaded when it is first asked for, so that the window opens sooner."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from PySide6.QtWidgets import QMessageBox

from theditor.resources import version
from theditor.spline import Known

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


def insert_known(window: MainWindow, known: Known) -> None:
    """Ask for the parameters of a known curve and insert it."""
    from theditor.app.insert_dialog import InsertDialog

    InsertDialog(known, window.document, window.selection, window.canvas.plane, window).open()


def change_lambdas(window: MainWindow, how: Literal["gradient", "smooth", "formula"]) -> None:
    """Ask how to change many λ at once, or say why none can be."""
    from theditor.app.lambda_dialogs import formula_dialog, gradient_dialog, smooth_dialog

    dialog = {"gradient": gradient_dialog, "smooth": smooth_dialog, "formula": formula_dialog}[how]
    try:
        dialog(window.document, window.selection, window).open()
    except ValueError as error:
        window.announce(str(error))


def import_files(window: MainWindow) -> None:
    """Ask for files of other programs and add their curves to the drawing."""
    from theditor.app.importing import ask_to_import

    ask_to_import(window)


def export(window: MainWindow) -> None:
    """Ask how and where to export the drawing."""
    from theditor.app.exporting import ask_to_export

    ask_to_export(window)


def recover(window: MainWindow, *, discarded: bool = True) -> None:
    """Offer unsaved work that can be brought back, what was discarded as well or not."""
    from theditor.app.recover_dialog import offer_work

    offer_work(window, discarded=discarded)


def find_command(window: MainWindow) -> None:
    """Let the user find a command by words and run it."""
    from theditor.app.palette import Palette

    Palette(window.menuBar(), window).open()


def show_preferences(window: MainWindow) -> None:
    """Let the user choose theme, nudge step and degree."""
    from theditor.app.preferences import Preferences

    Preferences(window).open()


def show_shortcuts(window: MainWindow) -> None:
    """Show what the keys and the mouse do."""
    from theditor.app.shortcuts import Shortcuts

    Shortcuts(window).open()


def show_about(window: MainWindow) -> None:
    """Say what this is."""
    QMessageBox.about(
        window,
        "About theditor",
        f"<b>theditor {version()}</b><p>An editor for TH-type uniform B-splines: quadratic and cubic curves "
        "whose segments are trigonometric, hyperbolic or interpolating, as their shape parameters λ say.</p>"
        "<p>After J. Xie, <i>A Geometric Modeling Method Based on TH-Type Uniform B-Splines</i>, "
        "Mathematical Problems in Engineering 2014, 242469.</p><p>MIT licence.</p>",
    )
