"""The card over the canvas that shows how far long work is, and calls it off."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt, QTimer
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QProgressBar, QPushButton, QWidget

from theditor.app.work import Work

DELAY = 300
"""Milliseconds that work may take unseen."""
_EVERY = 100
_MARGIN = 12
_WIDTH = 320
_FINE = 1000


class WorkCard(QFrame):
    """Lies in the lower left corner of the canvas while work takes long; moves nothing else."""

    def __init__(self, work: Work, canvas: QWidget) -> None:
        super().__init__(canvas)
        self._work, self._canvas = work, canvas
        self.setProperty("role", "card")
        self.words, self.bar, self.button = QLabel(), QProgressBar(), QPushButton("Cancel")
        self.bar.setTextVisible(False)
        self.bar.setAccessibleName("Progress")
        self.button.setAccessibleName("Cancel what is going on")
        self.button.clicked.connect(self._cancel)
        layout = QGridLayout(self)
        layout.setContentsMargins(12, 8, 8, 8)
        layout.setHorizontalSpacing(12)
        layout.setVerticalSpacing(6)
        layout.addWidget(self.words, 0, 0)
        layout.addWidget(self.bar, 1, 0)
        layout.addWidget(self.button, 0, 1, 2, 1)
        self.setFixedWidth(_WIDTH)
        self.hide()
        self._delay = QTimer(self, singleShot=True, interval=DELAY)
        self._delay.timeout.connect(self._appear)
        self._refresh = QTimer(self, interval=_EVERY)
        self._refresh.timeout.connect(self._show_share)
        work.changed.connect(self._follow)
        canvas.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Stay in the corner."""
        if isinstance(event, QResizeEvent):
            self._place()
        return False

    def _follow(self) -> None:
        if not self._work.jobs:
            self._delay.stop()
            self._refresh.stop()
            self.hide()
        elif self.isHidden():
            if not self._delay.isActive():
                self._delay.start()
        else:
            self._show_share()

    def _appear(self) -> None:
        self._show_share()
        self._refresh.start()
        self._place()
        self.show()
        self.raise_()

    def _show_share(self) -> None:
        first, *others = self._work.jobs
        more = f" (and {len(others)} more)" if others else ""
        text = f"{first.words}{more}"
        room = _WIDTH - self.button.sizeHint().width() - 36
        self.words.setText(self.fontMetrics().elidedText(text, Qt.TextElideMode.ElideMiddle, room))
        self.setAccessibleName(text)
        # Until it is known how much there is to do, the bar only shows that something is done.
        self.bar.setRange(0, _FINE if first.share else 0)
        self.bar.setValue(round(first.share * _FINE))

    def _place(self) -> None:
        self.adjustSize()
        self.move(_MARGIN, self._canvas.height() - self.height() - _MARGIN)

    def _cancel(self) -> None:
        self._work.cancel(self._work.jobs[0])
