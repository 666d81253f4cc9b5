"""Offers work that was not saved: what a crash left, and what was discarded in the last days."""

from __future__ import annotations

from contextlib import suppress
from datetime import datetime, timedelta
from typing import TYPE_CHECKING, NamedTuple

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QListWidget,
    QListWidgetItem,
    QVBoxLayout,
)

from theditor.app.thumbnail import thumbnail
from theditor.app.windows import open_windows
from theditor.drawing import Drawing, DrawingError, shown
from theditor.model import colours_for
from theditor.model.kept_work import DAYS, KeptWork, kept_work
from theditor.panels.parts import GAP, MARGIN, Paragraph

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

PICTURE = QSize(132, 88)

_AFTER_CRASH = "The program ended before this was saved. What you recover is still to be saved."
_ALL = f"What was not saved when the program ended, and what was discarded in the last {DAYS} days."


class Offer(NamedTuple):
    """Kept work that can be read."""

    work: KeptWork
    drawing: Drawing


def offer_work(window: MainWindow, *, discarded: bool) -> None:
    """Show what a crash left, if there is anything; with what was `discarded`, or say that there is none."""
    offers, damage = _offers(discarded=discarded)
    if damage:
        window.messages.tell(damage)
    if offers:
        RecoverDialog(window, offers, discarded=discarded).open()
    elif discarded:
        window.announce("There is no unsaved work to recover")


def _offers(*, discarded: bool) -> tuple[list[Offer], str]:
    """Work to offer, what was discarded only if asked for; and which cannot be read, and why."""
    offers, damage = [], []
    for work in kept_work():
        about = work.about
        if about.discarded and not discarded:
            work.let_go()
            continue
        try:
            offers.append(Offer(work, work.read()))
        except DrawingError as error:
            damage.append(f"The unsaved work on “{about.title}” is damaged and cannot be recovered: {error}")
            if not about.discarded:
                with suppress(DrawingError):
                    work.discard()
            work.let_go()
    return offers, "\n".join(damage)


class RecoverDialog(QDialog):
    """Pictures of kept work to recover, to discard or to leave for later.

    What is recovered comes into windows of its own, or into those where nothing was done yet. While the dialog
    is open, no other process offers the same work.

    Parameters
    ----------
    window
        The window that asks.
    offers
        What there is, at least one.
    discarded
        Whether work stays in the list when it is discarded.
    """

    def __init__(self, window: MainWindow, offers: list[Offer], *, discarded: bool) -> None:
        super().__init__(window)
        self.setWindowTitle("Recover unsaved work")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(600, 460)
        self._window, self._offers, self._discarded = window, offers, discarded
        about = Paragraph()
        about.setText(_ALL if discarded else _AFTER_CRASH)
        self.list = QListWidget()
        self.list.setAccessibleName("Work that can be recovered")
        self.list.setIconSize(PICTURE)
        self.list.setSpacing(4)
        self.list.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.list.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        for offer in offers:
            item = QListWidgetItem(self._picture(offer.drawing), _words(offer.work))
            path = offer.work.about.path
            item.setToolTip(shown(path) if path else "")
            self.list.addItem(item)
        buttons = QDialogButtonBox()
        role = QDialogButtonBox.ButtonRole
        self.discard_button = buttons.addButton("Discard", role.ResetRole)
        buttons.addButton("Keep for later", role.RejectRole)
        self.recover_button = buttons.addButton("Recover", role.AcceptRole)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(MARGIN, MARGIN, MARGIN, MARGIN)
        layout.setSpacing(GAP)
        for widget in (about, self.list, buttons):
            layout.addWidget(widget)
        self.recover_button.setDefault(True)
        self.list.setFocus()

        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        self.discard_button.clicked.connect(self._discard)
        self.list.itemSelectionChanged.connect(self._show_state)
        self.list.itemActivated.connect(self.accept)
        if discarded:
            self.list.setCurrentRow(0)
        else:
            self.list.selectAll()
        self._show_state()

    def done(self, result: int) -> None:
        """Recover what is chosen, and let go of the rest."""
        chosen = self._chosen() if result == QDialog.DialogCode.Accepted else []
        for offer in self._offers:
            if offer not in chosen:
                offer.work.let_go()
        super().done(result)
        for work, drawing in chosen:
            path = work.about.path
            window = next((each for each in open_windows if each.has_room_for(path)), None)
            (window or open_windows[-1].beside()).files.recover(work, drawing)

    def _picture(self, drawing: Drawing) -> QIcon:
        pixmap = thumbnail(drawing, PICTURE, self.devicePixelRatioF(), colours_for(self.palette()))
        icon = QIcon(pixmap)
        icon.addPixmap(pixmap, QIcon.Mode.Selected)  # colours mean modes: no tint when selected
        return icon

    def _chosen(self) -> list[Offer]:
        return [self._offers[row] for row in self._rows()]

    def _rows(self) -> list[int]:
        return sorted(index.row() for index in self.list.selectedIndexes())

    def _discard(self) -> None:
        """Keep the chosen work for some more days only; remove what was discarded before."""
        for row in reversed(self._rows()):
            work = self._offers[row].work
            was_discarded = work.about.discarded is not None
            try:
                work.remove() if was_discarded else work.discard()
            except (DrawingError, OSError) as error:
                self._window.messages.tell(str(error))
                continue
            if self._discarded and not was_discarded:
                self.list.item(row).setText(_words(work))
            else:
                work.let_go()
                del self._offers[row]
                self.list.takeItem(row)
        self._show_state()
        if not self._offers:
            self.reject()

    def _show_state(self) -> None:
        chosen = self._chosen()
        self.recover_button.setEnabled(bool(chosen))
        self.discard_button.setEnabled(bool(chosen))
        again = chosen and all(work.about.discarded for work, _ in chosen)
        self.discard_button.setText("Delete for good" if again else "Discard")


def _words(work: KeptWork) -> str:
    about = work.about
    file = f"in {shown(about.path.parent)}" if about.path else "never saved"
    when = f"{work.time:%A}, {_day(work.time)}, {work.time:%H:%M}"
    if about.discarded:
        when += f" · discarded, kept until {_day(about.discarded + timedelta(days=DAYS))}"
    return f"{shown(about.title)}\n{file}\n{when}"


def _day(time: datetime) -> str:
    return f"{time.day} {time:%B}"
