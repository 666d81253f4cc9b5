"""Keeps the unsaved work of one document on the disk, a few seconds behind the hand."""

from __future__ import annotations

import logging
import os
from contextlib import suppress
from datetime import datetime
from functools import cache
from threading import Event
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QSysInfo, QTimer, Signal

from theditor.drawing import Drawing
from theditor.model.document import Document
from theditor.model.kept_work import About, KeptWork, new_work

if TYPE_CHECKING:
    from concurrent.futures import Future, ThreadPoolExecutor

DELAY = 2000
"""Milliseconds from the first change to the disk."""
REST = 0.004
"""Seconds of rest after each small part of a drawing that is written, so that the hand at work feels nothing."""

_hurry = Event()
"""Somebody waits: no rest now."""


@cache
def _writer() -> ThreadPoolExecutor:
    """Writes for all windows, one after the other, so that nothing overtakes."""
    from concurrent.futures import ThreadPoolExecutor  # loaded when it is first asked for

    return ThreadPoolExecutor(max_workers=1, thread_name_prefix="recovery")


class Recovery(QObject):
    """Writes what is not saved to `kept_work` soon after each change, and takes it away once it is saved.

    The writing is done beside the window's work. If it fails, `failed` says so once, and editing goes on.
    """

    failed = Signal(str)
    kept = Signal()
    """What is on the disk is up to date with a change."""
    _written = Signal(object)

    def __init__(self, document: Document, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._work: KeptWork | None = None
        self._last: tuple[Drawing, About] | None = None
        self._keeps = False
        self._failing = False
        self._timer = QTimer(self, singleShot=True, interval=DELAY)
        self._timer.timeout.connect(self.keep)
        self._written.connect(self._tell)
        document.changed.connect(self._note)
        document.stepped.connect(self._note)
        document.renamed.connect(self._note)
        document.leaving.connect(self.give_up)

    def keep(self) -> None:
        """Write now what is not saved, unless it is on the disk already; `flush` waits for it."""
        self._timer.stop()
        if self._document.is_clean:
            self._forget()
            return
        now = self._document.drawing, self._about()
        if now != self._last:
            self._last = now
            self._submit(*now)

    def flush(self) -> None:
        """Wait until all that is to be written is on the disk."""
        _hurry.set()
        try:
            _writer().submit(lambda: None).result()
        finally:
            _hurry.clear()

    def give_up(self) -> None:
        """The drawing goes: what was not saved stays recoverable for some days."""
        if self._document.is_clean:
            self._forget()
        else:
            self._submit(self._document.drawing, self._about(datetime.now()))
            self._release()

    def leave(self) -> None:
        """The program ends without asking: what was not saved is for the next start to offer."""
        self.keep()
        self._release()
        self.flush()

    def adopt(self, work: KeptWork) -> None:
        """Go on with recovered work, which the document shows: later changes are kept in its place."""
        self._keeps = True
        _writer().submit(self._take_over, work)
        self.keep()

    def _note(self, *_: object) -> None:
        if self._document.is_clean:
            self._forget()
        elif not self._timer.isActive():
            self._timer.start()

    def _about(self, discarded: datetime | None = None) -> About:
        document = self._document
        where = os.getpid(), QSysInfo.machineHostName()
        return About(document.title, document.path, document.fingerprint, discarded, *where)

    def _submit(self, drawing: Drawing, about: About) -> None:
        self._keeps = True
        _writer().submit(self._write, drawing, about).add_done_callback(self._done)

    def _forget(self) -> None:
        self._timer.stop()
        if self._keeps:
            self._keeps, self._last = False, None
            _writer().submit(self._remove)

    def _release(self) -> None:
        self._timer.stop()
        self._keeps, self._last = False, None
        _writer().submit(self._let_go)

    def _tell(self, problem: str) -> None:
        if not problem:
            self.kept.emit()
        else:
            self._last = None  # so that it is tried again
            if not self._failing:
                self.failed.emit(problem)
        self._failing = bool(problem)

    # What follows runs beside the window's work; nothing else touches `_work`.

    def _write(self, drawing: Drawing, about: About) -> None:
        if self._work is None:
            self._work = new_work()
        self._work.write(drawing, about, lambda: _hurry.wait(REST))

    def _remove(self) -> None:
        if self._work is not None:
            work, self._work = self._work, None
            with suppress(OSError):
                work.remove()

    def _let_go(self) -> None:
        if self._work is not None:
            self._work.let_go()
            self._work = None

    def _take_over(self, work: KeptWork) -> None:
        self._remove()
        self._work = work

    def _done(self, writing: Future[None]) -> None:
        error = writing.exception()
        if error is not None:
            logging.getLogger("theditor").warning("Unsaved work cannot be kept: %s", error, exc_info=error)
        with suppress(RuntimeError):  # the window has gone
            self._written.emit("" if error is None else str(error))
