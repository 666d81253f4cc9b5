"""Makes the pictures in this folder: the real window, rendered without a screen.

Run it with ``.venv/bin/python screenshots/make.py`` after every visible change, and look at the result.
"""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

os.environ["QT_QPA_PLATFORM"] = "offscreen"
for variable in ("XDG_CONFIG_HOME", "XDG_DATA_HOME"):
    os.environ[variable] = tempfile.mkdtemp(prefix="theditor-screenshots-")

from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget

from theditor.app.gallery_dialog import GalleryDialog
from theditor.app.main_window import MainWindow
from theditor.app.theme import Theme, apply_theme
from theditor.spline import Mode

HERE = Path(__file__).resolve().parent


def send_mouse(window: MainWindow, kind: QEvent.Type, point: tuple[float, float]) -> None:
    """Let the mouse do something at a point of the plane."""
    viewport = window.canvas.viewport()
    at = QPointF(*window.canvas.plane.to_pixels(point))
    pressed = Qt.MouseButton.NoButton if kind == QEvent.Type.MouseMove else Qt.MouseButton.LeftButton
    event = QMouseEvent(
        kind,
        at,
        QPointF(viewport.mapToGlobal(at.toPoint())),
        pressed,
        pressed,
        Qt.KeyboardModifier.NoModifier,
    )
    QApplication.sendEvent(viewport, event)


def drag(window: MainWindow, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Press at one point and move to another, without letting go."""
    send_mouse(window, QEvent.Type.MouseMove, start)
    send_mouse(window, QEvent.Type.MouseButtonPress, start)
    send_mouse(window, QEvent.Type.MouseMove, end)


def opened(picture: str, theme: Theme, width: int = 1360, height: int = 860) -> MainWindow:
    """A window with a picture from the gallery."""
    apply_theme(theme)
    window = MainWindow()
    window.resize(width, height)
    window.show()
    QApplication.processEvents()
    window.open_picture(picture)
    QApplication.processEvents()
    return window


def keep(widget: QWidget, name: str) -> None:
    """Save what a widget shows."""
    for _ in range(3):  # a layout may need another round
        QApplication.processEvents()
    widget.grab().save(str(HERE / f"{name}.png"))
    widget.hide()


def main() -> None:
    app = QApplication(["theditor"])
    app.setStyle("Fusion")

    for theme in (Theme.LIGHT, Theme.DARK):
        window = opened("figure-10", theme)
        window.selection.select(points={9}, segments={4})
        send_mouse(window, QEvent.Type.MouseMove, (0.44, 2.1))
        keep(window, f"window-{theme}")

    window = opened("figure-09", Theme.LIGHT)
    window.selection.select(segments={1})
    window.segments.set_mode(Mode.HYPERBOLIC)
    window.selection.select(segments={1})
    keep(window, "modes")

    window = opened("figure-10", Theme.DARK, 1024, 700)
    drag(window, (0.0, 1.8509181282393214), (-0.4, 0.6))
    keep(window, "small")

    apply_theme(Theme.LIGHT)
    gallery = GalleryDialog(window)
    gallery.show()
    keep(gallery, "gallery")


if __name__ == "__main__":
    main()
