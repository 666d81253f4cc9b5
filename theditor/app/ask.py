"""Questions about files: where to open, where to save, and whether unsaved changes may go."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from theditor.drawing import shown
from theditor.model.kept_work import DAYS

FILE_FILTER = "theditor drawings (*.json);;All files (*)"


def which_to_open(parent: QWidget, folder: Path | None) -> Path | None:
    """Ask for a file to open; None if the user thinks better of it."""
    name, _ = QFileDialog.getOpenFileName(
        parent, "Open a drawing", str(folder or ""), f"{FILE_FILTER.split(';;')[0]};;{_foreign_filter()}"
    )
    return Path(name) if name else None


def which_to_import(parent: QWidget, folder: Path | None) -> list[Path]:
    """Ask for files of other programs; none if the user thinks better of it."""
    names, _ = QFileDialog.getOpenFileNames(parent, "Import curves", str(folder or ""), _foreign_filter())
    return [Path(name) for name in names]


def _foreign_filter() -> str:
    from theditor.exchange import FORMATS, readable  # loaded when it is first asked for

    every = " ".join(f"*{suffix}" for suffix in readable())
    each = ";;".join(f"{FORMATS[suffix].name} (*{suffix})" for suffix in readable())
    return f"All that can be imported ({every});;{each};;All files (*)"


def where_to_save(parent: QWidget, suggestion: Path) -> Path | None:
    """Ask for a file to save to, completed by ``.json``, also where the name is that of another kind of file.

    What is replaced is asked about.
    """
    dialog = QFileDialog(parent, "Save the drawing", str(suggestion.parent), FILE_FILTER)
    dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
    dialog.setFileMode(QFileDialog.FileMode.AnyFile)
    dialog.setDefaultSuffix("json")
    dialog.selectFile(suggestion.name)
    if not dialog.exec():
        return None
    from theditor.exchange import FORMATS  # loaded when it is first asked for

    path = Path(dialog.selectedFiles()[0])
    return _completed(parent, path, ".json") if path.suffix.lower() in FORMATS else path


def where_to_export(parent: QWidget, suggestion: Path, suffix: str) -> Path | None:
    """Ask for a file of a foreign format to write to, completed by its suffix; what is replaced is asked about."""
    from theditor.exchange import FORMATS

    form = f"{FORMATS[suffix].name} (*{suffix})"
    name, _ = QFileDialog.getSaveFileName(parent, "Export the drawing", str(suggestion), form)
    if not name:
        return None
    path = Path(name)
    return path if path.suffix.lower() == suffix else _completed(parent, path, suffix)


def _completed(parent: QWidget, path: Path, suffix: str) -> Path | None:
    """Add the suffix; a file of that name, which the dialog for files could not know yet, is asked about."""
    path = path.with_name(path.name + suffix)
    return path if not path.exists() or _whether_to_overwrite(parent, path) else None


def _whether_to_overwrite(parent: QWidget, path: Path) -> bool:
    """Ask about a file whose name the dialog for files did not know yet."""
    buttons = QMessageBox.StandardButton
    words = f"“{shown(path.name)}” exists already. Replace it?"
    answer = QMessageBox.question(
        parent, "Replace a file", words, buttons.Yes | buttons.Cancel, buttons.Cancel
    )
    return bool(answer == buttons.Yes)


def whether_to_save(parent: QWidget, title: str) -> QMessageBox.StandardButton:
    """Ask what becomes of unsaved changes: ``Save``, ``Discard`` or ``Cancel``."""
    buttons = QMessageBox.StandardButton
    return QMessageBox.question(
        parent,
        "Unsaved changes",
        f"“{title}” has changes that are not saved. Save them?\n\n"
        f"For {DAYS} days, File\u00a0›\u00a0Recover brings back what you discard.",
        buttons.Save | buttons.Discard | buttons.Cancel,
        buttons.Save,
    )


def whether_to_save_over(parent: QWidget, objection: str) -> Literal["replace", "elsewhere", ""]:
    """Ask whether to save to a file in spite of something, to another one, or not at all."""
    box = QMessageBox(QMessageBox.Icon.Warning, "Save over a changed file", objection, parent=parent)
    box.setText(f"{objection} Replace what it holds?")
    box.setStandardButtons(QMessageBox.StandardButton.Cancel)
    replace = box.addButton("Replace", QMessageBox.ButtonRole.DestructiveRole)
    elsewhere = box.addButton("Save as…", QMessageBox.ButtonRole.AcceptRole)
    box.setDefaultButton(elsewhere)
    box.exec()
    chosen = box.clickedButton()
    return "replace" if chosen is replace else "elsewhere" if chosen is elsewhere else ""


def whether_to_replace(parent: QWidget, path: Path, reason: str) -> bool:
    """Ask whether a file that holds something other than a readable drawing may go."""
    buttons = QMessageBox.StandardButton
    answer = QMessageBox.warning(
        parent,
        "Not a drawing",
        f"{shown(path)} holds something other than a drawing that this program can read, and saving would "
        f"destroy it. Replace it?\n\n{reason}",
        buttons.Yes | buttons.Cancel,
        buttons.Cancel,
    )
    return bool(answer == buttons.Yes)
