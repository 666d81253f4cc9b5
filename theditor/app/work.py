"""Long work, done in a thread of its own: the window stays usable meanwhile, and the work can be called off."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from threading import Thread
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtWidgets import QAbstractSpinBox, QApplication, QLineEdit, QWidget

from theditor.app.problems import log
from theditor.drawing import DrawingError
from theditor.model.worker import Report, Result

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

PATIENCE = 2.0
"""Seconds that a closing window waits for work to end."""
MOMENT = 0.4
"""The same before it asks whether to save."""
_PAUSE = 50  # milliseconds between looks whether the hand has left the drawing


_left: list[Job] = []
"""Jobs of closed windows, which are gone, whose threads still run: Qt's objects must not end in one of these."""


class CancelledError(Exception):
    """The work was called off: what the report of progress raises then, which ends it."""


class Job(QObject):
    """One piece of long work."""

    ended = Signal(object)
    """Sent from its thread."""

    def __init__(
        self,
        words: str,
        function: Callable[[Report], Any],
        done: Callable[[Any], object],
        otherwise: Callable[[], object] | None,
        doomed: Callable[[], str] | None,
        bound: bool,
        precious: bool,
    ) -> None:
        super().__init__()
        self.precious = precious
        self.words, self.done, self.otherwise, self.doomed, self.bound = words, done, otherwise, doomed, bound
        self.share = 0.0
        self.cancelled = False
        self.result: Any = None
        self.error: Exception | None = None
        self._function = function
        self.task = Thread(target=self._run, name=words, daemon=True)

    def _run(self) -> None:
        try:
            self.result = self._function(self._report)
        except Exception as error:
            self.error = error
        with suppress(RuntimeError):  # Qt has ended before it
            self.ended.emit(self)

    def _report(self, share: float) -> None:
        if self.cancelled:
            raise CancelledError
        self.share = share


class Work(QObject):
    """Does the long work of one window, and hands over there what comes of it."""

    changed = Signal()
    """Another job is under way, or one fewer."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._jobs: list[Job] = []  # until their threads have ended: Qt's objects must not end in another one
        window.document.leaving.connect(self._leave_drawing)
        window.document.stepped.connect(self._look)
        window.document.worker = self

    @property
    def jobs(self) -> tuple[Job, ...]:
        """Those under way, the oldest first."""
        return tuple(job for job in self._jobs if not job.cancelled)

    def start(
        self,
        words: str,
        function: Callable[[Report], Result],
        done: Callable[[Result], object],
        otherwise: Callable[[], object] | None = None,
        *,
        doomed: Callable[[], str] | None = None,
        bound: bool = False,
        precious: bool = False,
    ) -> Callable[[], None]:
        """Call a function in a thread, and hand its result to `done` in this one: see `Worker.start`.

        That waits until no hand is on the drawing, and nothing half typed is in a field. A report raises once
        the work is called off. A `DrawingError` is told in the window; other errors go to `sys.excepthook`.
        """
        job = Job(words, function, done, otherwise, doomed, bound, precious)
        job.ended.connect(self._deliver, Qt.ConnectionType.QueuedConnection)
        self._jobs.append(job)
        self.changed.emit()
        job.task.start()
        return partial(self.cancel, job)

    def cancel(self, job: Job) -> None:
        """Call a job off. Nothing comes of it, even if it does not end at once."""
        self._give_up(job, f"{job.words} was cancelled.")

    def _give_up(self, job: Job, told: str) -> None:
        if not job.cancelled:
            job.cancelled = True
            self._window.announce(told)
            self.changed.emit()
            if job.otherwise is not None:
                job.otherwise()

    def stop(self) -> None:
        """The window closes: call off what was for its drawing, and wait a little for the rest, files."""
        self._leave_drawing()
        end = time.monotonic() + PATIENCE
        for job in self.jobs:
            job.task.join(max(end - time.monotonic(), 0.0))
            job.cancelled = True
            if job.error is not None:
                log.warning("%s: %s", job.words, job.error)
        self.changed.emit()
        _left[:] = [job for job in (*_left, *self._jobs) if job.task.is_alive()]

    def settle(self) -> None:
        """Wait for what the drawing at hand is to get, a moment or, if it is precious, until it is there.

        It belongs to the drawing when that is asked about.
        """
        end = time.monotonic() + MOMENT
        for job in self.jobs:
            if job.bound:
                job.task.join(None if job.precious else max(end - time.monotonic(), 0.0))
                if not job.task.is_alive():
                    self._deliver(job)

    def _leave_drawing(self) -> None:
        for job in self.jobs:
            if job.bound:
                self.cancel(job)

    def _look(self) -> None:
        """The document made a step: what can come to nothing any more is given up."""
        for job in self.jobs:
            reason = job.doomed() if job.doomed is not None and self._window.document.before is None else ""
            if reason:
                self._give_up(job, reason)

    def _deliver(self, job: Job) -> None:
        if job not in self._jobs:
            return
        at_hand = self._window.document.before is not None or QApplication.mouseButtons()
        if (at_hand or _typing(self._window.focusWidget())) and not job.cancelled:
            QTimer.singleShot(_PAUSE, self, partial(self._deliver, job))
            return
        self._look()
        job.task.join()
        self._jobs.remove(job)
        if job.cancelled:
            return
        self.changed.emit()
        if job.error is None:
            job.done(job.result)
            return
        if job.otherwise is not None:
            job.otherwise()
        if isinstance(job.error, DrawingError):
            self._window.files.report(job.error)
        else:
            sys.excepthook(type(job.error), job.error, job.error.__traceback__)


def _typing(widget: QWidget | None) -> bool:
    """Whether something half typed is in a field."""
    field = widget.lineEdit() if isinstance(widget, QAbstractSpinBox) else widget
    return isinstance(field, QLineEdit) and field.isModified()
