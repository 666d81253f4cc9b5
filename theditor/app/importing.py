"""File › Import: curves from the files of other programs."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from theditor.app import ask
from theditor.app.adding import add_curves
from theditor.app.kept_options import keep_folder, keep_options, kept_folder, kept_options
from theditor.app.recent import remember_file
from theditor.app.view import show_added
from theditor.drawing import Drawing, DrawingError, Item, read_bytes, shown
from theditor.exchange import Imported, Options, Progress, read, readable, told
from theditor.exchange.embedded import extract
from theditor.model.words import counted

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

_LOOKED_AT = 2**20  # bytes of the largest file that is looked into before anything is asked


class Found(NamedTuple):
    """What files of other programs hold."""

    items: tuple[Item, ...]
    paths: tuple[Path, ...]
    """The files that hold them."""
    told: str
    """How far the curves are from what the files show, and what else is to be known."""
    faults: tuple[str, ...]
    """A sentence for each file that could not be read."""


def is_foreign(path: Path) -> bool:
    """Whether a file is to be imported, by its name."""
    return path.suffix.lower() in readable()


def ask_to_import(window: MainWindow) -> None:
    """Ask for files and, where that matters, how to read them; then add their curves to the drawing."""
    from theditor.app.import_dialog import ImportDialog  # loaded when it is first asked for

    path = window.document.path
    paths = ask.which_to_import(window, kept_folder("import") or (path.parent if path is not None else None))
    if not paths:
        return
    keep_folder(paths[0].parent, "import")
    if all(map(_carries_drawing, paths)):
        import_files(window, paths)
        return
    dialog = ImportDialog(paths, kept_options("import"), window)

    def go_on() -> None:
        keep_options(dialog.options(), "import")
        import_files(window, paths)

    dialog.accepted.connect(go_on)
    dialog.open()


def import_files(window: MainWindow, paths: Sequence[Path]) -> None:
    """Add the curves in files to the drawing, as one undo step, read as it was chosen last."""
    window.messages.hide()
    options = kept_options("import")

    def add(found: Found) -> None:
        add_curves(window, "Import", found.items)
        show_added(window.canvas, window.selection)
        window.announce(
            f"Imported {counted(len(found.items), 'curve')} from {_named(found.paths)}. {found.told}"
        )
        if found.faults:
            window.messages.tell("\n".join(found.faults))

    window.work.start(
        f"Importing {_named(paths)}", lambda progress: read_files(paths, options, progress), add, bound=True
    )


def open_foreign(window: MainWindow, path: Path) -> None:
    """Open the curves in a file as a new drawing; the one at hand may go as it is now."""
    given_up, options = window.document.drawing, kept_options("import")

    def show(found: Found) -> None:
        if window.document.drawing is not given_up and not window.files.may_discard():
            return
        window.document.start(Drawing(found.items), path.stem)
        window.canvas.fit()
        remember_file(path)
        window.announce(f"Imported {_named([path])}: saving makes a drawing of it. {found.told}")

    window.work.start(
        f"Opening {_named([path])}", lambda progress: read_files([path], options, progress), show, bound=True
    )


def read_files(paths: Sequence[Path], options: Options, progress: Progress) -> Found:
    """Read files of other programs; those that cannot be read do not keep the others back.

    Raises
    ------
    DrawingError
        If there are no curves in any.
    """
    items: list[Item] = []
    notes: list[str] = []
    faults: list[str] = []
    good: list[Path] = []
    deviation = 0.0
    for number, path in enumerate(paths):

        def tell(share: float, number: int = number) -> None:
            progress((number + share) / len(paths))

        tell(0.0)
        try:
            imported = _read(path, options, tell)
        except DrawingError as error:
            faults.append(str(error))
            continue
        good.append(path)
        items += imported.drawing
        deviation = max(deviation, imported.deviation)
        notes += imported.notes
    if not items:
        raise DrawingError("\n".join(faults))
    return Found(tuple(items), tuple(good), told(deviation, list(dict.fromkeys(notes))), tuple(faults))


def _read(path: Path, options: Options, progress: Progress) -> Imported:
    data = read_bytes(path)
    try:
        imported = read(data, path.suffix, options, progress)
        if not imported.drawing:
            raise DrawingError(" ".join(["it holds no curves.", *imported.notes]))
    except DrawingError as error:
        raise DrawingError(f"{shown(path)}: {error}") from None
    return imported


def _carries_drawing(path: Path) -> bool:
    """Whether a picture opens as the drawing that was exported, so that there is nothing to choose."""
    try:
        if path.suffix.lower() != ".svg" or path.stat().st_size > _LOOKED_AT:
            return False
        found = extract(read_bytes(path))
    except (OSError, DrawingError):
        return False
    return found is not None and found.current


def _named(paths: Iterable[Path]) -> str:
    first, *others = paths
    return f"{len(others) + 1} files" if others else f"“{shown(first.name)}”"
