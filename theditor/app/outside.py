"""What goes on around a window's file: other programs that change it, other windows that have it open."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from theditor.app.windows import same_file, window_on
from theditor.drawing import Drawing, DrawingError, fingerprint, load, shown
from theditor.model.claim import Claim, owner_of_file
from theditor.model.data_folder import Owner
from theditor.model.watch import Watch

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

PATIENCE = 20
"""How many looks in a row may fail before that is told: the file may be half written, or just being replaced."""

_NOTHING = ""  # is no fingerprint


class Outside:
    """Follows the file of one window: reloads it, asks or tells; and says what speaks against a save."""

    def __init__(self, window: MainWindow) -> None:
        self._window = window
        self._claim, self._watch = Claim(), Watch(window)
        self._path: Path | None = None
        self._patience = PATIENCE
        self._told: str | None = _NOTHING  # fingerprint of what was asked about or told of
        self._untouched: Drawing | None = None  # shown then, with nothing of the user's in it
        self._said = ""
        self._paused = False
        self._owner: Owner | None = None  # who else had the file when it was last saved
        self._overruled: Owner | None = None
        self._watch.touched.connect(self._look)
        window.document.renamed.connect(self._follow)

    def check(self) -> None:
        """Look at the file if it seems to be another one: not every file system tells of changes."""
        self._watch.look_if_new()

    def close(self) -> None:
        """Let the file go: others may have it."""
        self._claim.hold(None)
        self._watch.follow(None)

    @contextmanager
    def paused(self) -> Iterator[None]:
        """Leave the drawing alone for a while: the user is asked what becomes of it."""
        self._paused = True
        try:
            yield
        finally:
            self._paused = False

    def objection(self, path: Path) -> str:
        """What speaks against saving to a file unasked, in a sentence; empty if nothing does."""
        document = self._window.document
        ours = same_file(document.path, path)
        if ours and document.differs_on_disk:
            return f"{_name(path)} has been changed by another program since it was opened or saved here."
        self._owner = self._claim.hold(document.path) if ours else owner_of_file(path)
        if self._owner is None or self._owner == self._overruled:
            return ""
        return f"{_name(path)} is open in {_described(self._owner)}, too."

    def overrule(self) -> None:
        """The user saves in spite of who has the file: they are not asked about the same one again."""
        self._overruled = self._owner

    # Other windows

    def _follow(self) -> None:
        path, before = self._window.document.path, self._path
        self._path = path
        owner = self._claim.hold(path)
        self._watch.follow(path)
        self._settle()
        if path is not None and owner is not None and path != before:
            self._tell_of(owner, path)

    def _tell_of(self, owner: Owner, path: Path) -> None:
        answers: list[tuple[str, Callable[[], object]]] = [("Work on a copy", self._work_on_copy)]
        other = window_on(path, besides=self._window)
        if other is not None:
            answers.insert(0, ("Go to that window", other.come_to_front))
        self._tell(
            f"{_name(path)} is open in {_described(owner)}, too. Each shows what the other saves, or asks.",
            *answers,
        )

    def _work_on_copy(self) -> None:
        document = self._window.document
        document.leave_file(f"{document.title} copy")

    # Other programs

    def _look(self) -> None:
        document = self._window.document
        path = document.path
        if path is None:
            return
        hand_on = document.before is not None or QApplication.mouseButtons() != Qt.MouseButton.NoButton
        if hand_on or self._paused:
            self._watch.look_soon()
            return
        self._claim.hold(path)  # whoever had it may have gone
        found = fingerprint(path)
        if found == self._told or (self._told == _NOTHING and found == document.fingerprint):
            self._patience = PATIENCE
            return
        free = document.is_clean or document.drawing is self._untouched
        try:
            if free or load(path) == document.drawing:
                self._take_over()
                return
            problem = ""
        except DrawingError as error:
            if self._patience:
                self._patience -= 1
                self._watch.look_soon()
                return
            problem = str(error)
        self._patience = PATIENCE
        self._told, self._untouched = found, document.drawing if free else None
        document.mark_unsaved()
        if not problem:
            self._tell(
                f"Another program has changed {_name(path)}, and here it has changes that are not saved.",
                ("Reload", self._reload),
                ("Keep mine", self._keep_mine),
            )
        elif found is None and not path.exists():
            self._tell(
                f"{_name(path)} has been deleted or moved. The drawing is still here: save it to keep it."
            )
        else:
            self._tell(f"Another program has changed the file; the drawing here is as it was. {problem}")

    def _reload(self) -> None:
        try:
            self._take_over()
        except DrawingError as error:
            self._window.messages.tell(str(error))

    def _take_over(self) -> None:
        before = self._window.document.drawing
        self._window.document.reload()
        self._settle()
        if self._window.document.drawing is not before and self._path is not None:
            self._window.announce(f"Reloaded {_name(self._path)}, which another program has changed")

    def _keep_mine(self) -> None:
        self._window.document.insist()
        self._settle()

    def _tell(self, text: str, *answers: tuple[str, Callable[[], object]]) -> None:
        self._said = text
        self._window.end_announcement()  # it may tell of an earlier reload
        self._window.messages.tell(text, *answers)

    def _settle(self) -> None:
        """Nothing is open between the file and the window."""
        self._patience = PATIENCE
        self._told, self._untouched = _NOTHING, None
        if self._said and self._window.messages.text == self._said:
            self._window.messages.hide()
        self._said = ""


def _name(path: Path) -> str:
    return f"“{shown(path.name)}”"


def _described(owner: Owner) -> str:
    if owner.is_this_process:
        return "another window"
    place = "" if owner.is_this_host else f" on {owner.host}"
    return f"another theditor (process {owner.process}{place}, since {owner.since:%H:%M})"
