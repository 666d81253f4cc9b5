"""A window's dealings with files: what it opens, where it saves, and what it asks before a drawing goes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QAbstractSpinBox, QLineEdit, QMenu, QMessageBox

from theditor.app import ask
from theditor.app.problems import log
from theditor.app.recent import recent_files, remember_file
from theditor.app.tour import lead
from theditor.app.view import keep_view, show_kept_view
from theditor.drawing import Drawing, DrawingError, load, shown, unreadable
from theditor.model.kept_work import KeptWork
from theditor.resources import gallery

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


class Files:
    """Opens and saves the drawing of one window, and tells there what goes wrong."""

    def __init__(self, window: MainWindow) -> None:
        self._window = window
        self._ended_with: Drawing | None = None
        window.document.leaving.connect(self._keep_view)

    def new(self) -> None:
        """Start an empty drawing, once the old one may go."""
        if self.may_discard():
            self._window.document.start(Drawing())
            self._window.canvas.fit()

    def open(self) -> None:
        """Ask for a file and open it."""
        if self.may_discard():
            path = self._window.document.path
            chosen = ask.which_to_open(self._window, path.parent if path else None)
            if chosen is not None:
                self.open_path(chosen)

    def open_path(self, path: Path) -> bool:
        """Open a file; if it cannot be read, say why and keep the drawing. Another program's takes its time."""
        from theditor.app.importing import is_foreign, open_foreign  # loaded when it is first asked for

        self._window.messages.hide()
        if is_foreign(path):
            open_foreign(self._window, path)
            return True
        try:
            self._window.document.open(path)
        except DrawingError as error:
            self.report(error)
            return False
        remember_file(path)
        show_kept_view(path, self._window.canvas)
        return True

    def open_gallery(self) -> None:
        """Let the user choose a picture from the gallery and open a copy of it."""
        if self.may_discard():
            from theditor.app.gallery_dialog import GalleryDialog  # loaded when it is first asked for

            dialog = GalleryDialog(self._window)
            if dialog.exec() and dialog.chosen is not None:
                lead(self._window, dialog.chosen)

    def open_picture(self, name: str) -> None:
        """Open a copy of a gallery picture; saving it asks for a file."""
        picture = next(picture for picture in gallery() if picture.name == name)
        self._window.document.start(load(picture.path), picture.title.split(" · ")[0])
        self._window.messages.hide()
        self._window.canvas.fit()

    def save(self) -> bool:
        """Save to the document's file, or ask for one."""
        self._settle()
        path = self._window.document.path
        return self.save_as() if path is None else self._save_to(path)

    def save_as(self) -> bool:
        """Ask for a file and save to it."""
        self._settle()
        document = self._window.document
        suggestion = document.path or Path(f"{document.title}.json")
        path = ask.where_to_save(self._window, suggestion)
        if path is None:
            return False
        reason = unreadable(path)
        if reason and not ask.whether_to_replace(self._window, path, reason):
            return False
        return self._save_to(path, overwrite=True)

    def may_discard(self) -> bool:
        """Whether the drawing may go: nothing is unsaved, or the user saved it or gave it up."""
        self._settle()
        self._window.work.settle()
        document = self._window.document
        if document.is_clean or document.drawing is self._ended_with:
            return True
        answer, button = ask.whether_to_save(self._window, document.title), QMessageBox.StandardButton
        return answer == button.Discard or (answer == button.Save and self.save())

    def recover(self, work: KeptWork, drawing: Drawing) -> None:
        """Show work that was kept from being lost; it is still to be saved."""
        about, window = work.about, self._window
        window.document.recover(drawing, about.title, about.path, about.fingerprint)
        window.recovery.adopt(work)
        show_kept_view(about.path, window.canvas)
        if not window.messages.text:
            window.messages.tell(f"“{window.document.title}” is recovered, and not saved yet.")

    def expect_end(self) -> None:
        """Keep what is not saved for the next start; closing asks no more, unless something changes until then."""
        self._settle()
        self._window.work.settle()
        self._ended_with = self._window.document.drawing
        self._window.recovery.keep()
        self._window.recovery.flush()

    def leave(self) -> None:
        """The window closes: what was discarded stays recoverable, and the file is free for others."""
        self._keep_view()
        recovery, document = self._window.recovery, self._window.document
        if document.drawing is self._ended_with:
            recovery.leave()
        else:
            recovery.give_up()
            recovery.flush()
        self._window.outside.close()

    def report(self, error: DrawingError) -> None:
        """Tell what is wrong with a file, and log it."""
        log.warning("%s", error)
        self._window.messages.tell(str(error))

    def _keep_view(self) -> None:
        """Remember how the file is looked at, before the drawing goes."""
        keep_view(self._window.document.path, self._window.canvas)

    def list_recent(self, menu: QMenu) -> None:
        """Fill a menu with the files used last."""
        menu.clear()
        for path in recent_files():
            action = menu.addAction(shown(path).replace("&", "&&"))
            action.triggered.connect(
                lambda _checked=False, path=path: self.may_discard() and self.open_path(path)
            )
        if menu.isEmpty():
            menu.addAction("No files yet").setEnabled(False)

    def _settle(self) -> None:
        """Finish what is being typed or dragged: it belongs to the drawing that is saved or closed."""
        editor = self._window.focusWidget()
        if isinstance(editor, QLineEdit | QAbstractSpinBox):
            editor.clearFocus()
            editor.setFocus()
        self._window.document.settle()

    def _save_to(self, path: Path, overwrite: bool = False) -> bool:
        objection = self._window.outside.objection(path)
        if objection:
            with self._window.outside.paused():
                answer = ask.whether_to_save_over(self._window, objection)
            if answer != "replace":
                return answer == "elsewhere" and self.save_as()
            self._window.outside.overrule()
            overwrite = True
        self._window.messages.hide()
        try:
            self._window.document.save(path, overwrite)
        except DrawingError as error:
            self.report(error)
            return False
        remember_file(path)
        self._window.announce(f"Saved {shown(path)}")
        return True
