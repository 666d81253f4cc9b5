"""Ends without a question and without a loss, when a signal or the end of the session asks for it."""

from __future__ import annotations

import signal
import socket

from PySide6.QtCore import QObject, QSocketNotifier
from PySide6.QtGui import QSessionManager
from PySide6.QtWidgets import QApplication

from theditor.app.windows import open_windows

_SIGNALS = ("SIGTERM", "SIGINT", "SIGHUP")


class Ending(QObject):
    """Listens for the ends that nobody in a window asked for. The next start offers what was not saved."""

    def __init__(self, app: QApplication) -> None:
        super().__init__(app)
        app.commitDataRequest.connect(prepare_end)
        # Python runs its handlers only between its own instructions; the byte in the socket wakes Qt.
        self._ours, self._theirs = socket.socketpair()
        self._ours.setblocking(False)
        self._theirs.setblocking(False)
        self._notifier = QSocketNotifier(self._ours.fileno(), QSocketNotifier.Type.Read, self)
        self._notifier.activated.connect(self._end)
        signal.set_wakeup_fd(self._theirs.fileno(), warn_on_full_buffer=False)
        for name in _SIGNALS:
            number = getattr(signal, name, None)
            if number is not None and signal.getsignal(number) is not signal.SIG_IGN:  # as nohup wants it
                signal.signal(number, _once)

    def _end(self) -> None:
        number = self._ours.recv(64)[0]
        for window in list(open_windows):
            window.files.expect_end()
            window.close()
        QApplication.exit(128 + number)


def prepare_end(manager: QSessionManager) -> None:
    """The session ends, unless another program objects: keep all work, and ask nothing when windows are closed."""
    manager.setRestartHint(QSessionManager.RestartHint.RestartNever)
    for window in open_windows:
        window.files.expect_end()


def _once(number: int, _frame: object) -> None:
    """Leave the rest to Qt; a second signal ends the program as ever, should it hang."""
    signal.signal(number, signal.SIG_DFL)
