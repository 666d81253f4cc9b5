"""File › Export: pictures and tables of the drawing, for other programs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QSettings

from theditor.app import ask
from theditor.app.export_dialog import ExportDialog
from theditor.app.kept_options import keep_folder, keep_options, kept_folder, kept_options
from theditor.drawing import Drawing, shown, write_atomically
from theditor.exchange import Options, Progress, Written, told, write

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


def ask_to_export(window: MainWindow) -> None:
    """Ask how and where to export the drawing as it is now, or what is selected of it, and do so."""
    window.document.settle()
    drawing = window.document.drawing
    last = str(QSettings().value("export/format", ".svg"))
    selected = Drawing(drawing[i] for i in window.selection.curves)
    dialog = ExportDialog(
        drawing, last, lambda suffix: kept_options("export", suffix), window, selected=selected
    )

    def go_on() -> None:
        chosen, suffix, options = dialog.drawing, dialog.suffix, dialog.options()
        path = ask.where_to_export(dialog, _suggested(window, suffix), suffix)
        if path is not None:
            dialog.accept()
            QSettings().setValue("export/format", suffix)
            keep_options(options, "export", suffix)
            keep_folder(path.parent, "export")
            export(window, chosen, path, options)

    dialog.wanted.connect(go_on)
    dialog.open()


def export(window: MainWindow, drawing: Drawing, path: Path, options: Options) -> None:
    """Write a drawing to a file, in the format of its suffix, while the window is used."""
    window.messages.hide()
    name = f"“{shown(path.name)}”"

    def work(progress: Progress) -> Written:
        written = write(drawing, path.suffix, options, lambda share: progress(0.9 * share))
        progress(0.9)  # once called off, nothing is written
        write_atomically(path, written.data)
        return written

    window.work.start(
        f"Exporting {name}",
        work,
        lambda written: window.announce(f"Exported {name}. {told(written.deviation, written.notes)}"),
    )


def _suggested(window: MainWindow, suffix: str) -> Path:
    """Return a file called like the drawing, in the folder of the last export, else beside the drawing."""
    document = window.document
    folder = kept_folder("export") or (document.path.parent if document.path is not None else Path())
    name = document.path.stem if document.path is not None else document.title.replace("/", "-")
    return folder / f"{name}{suffix}"
