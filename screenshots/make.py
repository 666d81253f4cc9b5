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
from PySide6.QtGui import QMouseEvent, QPainter
from PySide6.QtWidgets import QApplication, QDockWidget, QWidget

from theditor.app.export_dialog import ExportDialog
from theditor.app.gallery_dialog import GalleryDialog
from theditor.app.insert_dialog import InsertDialog
from theditor.app.main_window import MainWindow
from theditor.app.theme import Theme, apply_theme
from theditor.drawing import Drawing
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


def show_tab(window: MainWindow, name: str) -> None:
    """Bring one of the panels below the canvas to the front."""
    dock = window.findChild(QDockWidget, name)
    dock.show()
    dock.raise_()


def window_pictures() -> None:
    """The whole window, in both themes and in a small size."""
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

    window = opened("figure-10", Theme.LIGHT)
    window.add_curve()
    window.selection.select_across({0: [3, 4, 5], 1: [0, 1]})
    keep(window, "across")

    window = opened("figure-10", Theme.DARK, 1024, 700)
    drag(window, (0.0, 1.8509181282393214), (-0.4, 0.6))
    keep(window, "small")


def shaping_pictures() -> None:
    """Pulling the curve, the reach of a λ, curvature, and the basis."""
    window = opened("figure-10", Theme.LIGHT)
    start = window.selection.item.curve(8.5)
    drag(window, tuple(start), tuple(start + [0.5, 0.35]))
    keep(window.canvas, "pull")

    window = opened("figure-10", Theme.LIGHT)
    send_mouse(window, QEvent.Type.MouseMove, tuple(window.selection.item.curve.joints[7]))
    keep(window.canvas, "reach")

    window = opened("figure-10", Theme.LIGHT)
    for name in ("show_comb", "show_marks", "show_circle"):
        window.actions_by_name[name].setChecked(True)
    show_tab(window, "curvature")
    send_mouse(window, QEvent.Type.MouseMove, tuple(window.selection.item.curve(8.3)))
    keep(window, "curvature")

    window = opened("figure-10", Theme.DARK)
    window.selection.select(segments={2})
    show_tab(window, "basis")
    send_mouse(window, QEvent.Type.MouseMove, tuple(window.selection.item.curve(2.8)))
    keep(window, "basis")


def dialog_pictures() -> None:
    """The gallery, an export, and a known curve being inserted."""
    window = opened("figure-10", Theme.LIGHT)
    window.actions_by_name["export"].trigger()
    export = window.findChild(ExportDialog)
    export.print_style.setChecked(True)
    keep(export, "export")
    export.reject()

    gallery = GalleryDialog(window)
    gallery.show()
    keep(gallery, "gallery")

    window.document.start(Drawing())
    window.canvas.fit()
    window.actions_by_name["insert_trochoid"].trigger()
    dialog = window.findChild(InsertDialog)
    QApplication.processEvents()
    picture = window.grab()
    painter = QPainter(picture)
    painter.drawPixmap(60, 150, dialog.grab())
    painter.end()
    picture.save(str(HERE / "insert.png"))
    dialog.reject()


def main() -> None:
    app = QApplication(["theditor"])
    app.setStyle("Fusion")
    window_pictures()
    shaping_pictures()
    dialog_pictures()


if __name__ == "__main__":
    main()
