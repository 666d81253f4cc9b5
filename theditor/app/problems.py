"""Problems: told in a sentence, logged in full, and never the end of the window."""

from __future__ import annotations

import logging
import sys
import traceback
from collections.abc import Callable
from logging.handlers import RotatingFileHandler
from pathlib import Path
from types import TracebackType

from PySide6.QtCore import QMessageLogContext, Qt, QtMsgType, qInstallMessageHandler
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QSizePolicy, QWidget

from theditor.model.data_folder import data_folder

log = logging.getLogger("theditor")


class MessageBar(QFrame):
    """A bar across the top of the canvas that says what went wrong; it stays until it is answered or closed."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "message")
        self._label = QLabel()
        self._label.setWordWrap(True)
        self._label.setTextFormat(Qt.TextFormat.PlainText)
        self._label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._label.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        close = QPushButton("Close")
        close.setAccessibleName("Close the message")
        close.clicked.connect(self.hide)
        self._answers: list[QPushButton] = []
        layout = QHBoxLayout(self)
        layout.setContentsMargins(16, 8, 12, 8)
        layout.setSpacing(12)
        layout.addWidget(self._label)
        layout.addWidget(close)
        self._layout = layout
        self.hide()

    def tell(self, text: str, *answers: tuple[str, Callable[[], object]]) -> None:
        """Show `text` in place of what was told before, with a button for each answer: its words and what it does."""
        for button in self._answers:
            self._layout.removeWidget(button)
            button.hide()
            button.deleteLater()  # it may be the one that is being pressed
        self._answers = [self._answer(*answer) for answer in answers]
        self._label.setText(text)
        self.setAccessibleName(text)
        self.show()

    def _answer(self, words: str, act: Callable[[], object]) -> QPushButton:
        button = QPushButton(words)
        button.setAccessibleName(words)
        button.clicked.connect(self.hide)
        button.clicked.connect(lambda: act())
        self._layout.insertWidget(self._layout.count() - 1, button)
        return button

    @property
    def text(self) -> str:
        """What is being told, empty when the bar is hidden."""
        return "" if self.isHidden() else self._label.text()


def log_path() -> Path:
    """The log file: beside the application's data."""
    return data_folder() / "theditor.log"


def start_log() -> None:
    """Log to `log_path`, Qt's messages included; without a writable place, to the standard error stream."""
    handler: logging.Handler
    try:
        log_path().parent.mkdir(parents=True, exist_ok=True)
        handler = RotatingFileHandler(
            log_path(), maxBytes=1_000_000, backupCount=1, encoding="utf-8", delay=True
        )
    except OSError:
        handler = logging.StreamHandler()
    handler.setFormatter(logging.Formatter("%(asctime)s %(levelname)s %(message)s"))
    log.addHandler(handler)
    log.setLevel(logging.INFO)
    qInstallMessageHandler(_log_qt)


def _log_qt(kind: QtMsgType, context: QMessageLogContext, message: str) -> None:
    level = logging.INFO if kind in (QtMsgType.QtDebugMsg, QtMsgType.QtInfoMsg) else logging.WARNING
    log.log(level, "Qt: %s", message)


def catch_everything(tell: Callable[[str], None]) -> None:
    """Send errors that nobody caught, those in slots included, to the log and to `tell`."""

    def caught(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        if issubclass(kind, KeyboardInterrupt):
            sys.__excepthook__(kind, error, trace)
            return
        log.error("uncaught\n%s", "".join(traceback.format_exception(kind, error, trace)))
        detail = str(error) or kind.__name__
        tell(
            f"Something went wrong inside the editor ({kind.__name__}: {detail}). "
            f"The drawing is as it was; save it, and see {log_path()} for the details."
        )

    sys.excepthook = caught
