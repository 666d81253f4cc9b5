"""The segments panel: a mode per segment, toggled for one or many at a time."""

from __future__ import annotations

from PySide6.QtCore import QItemSelection, QItemSelectionModel, Signal
from PySide6.QtWidgets import QWidget

from theditor.drawing import Item
from theditor.model import Document, Selection, words
from theditor.panels.parts import column, describe, heading
from theditor.panels.segment_list import SegmentList
from theditor.panels.segment_model import SegmentModel, runs
from theditor.spline import Curve, Mode

_TIP = (
    "Segments of the curve. T, H and λ* make a segment trigonometric, hyperbolic or interpolating; "
    "the keys T, H and I do so with the selected ones."
)


class SegmentsPanel(QWidget):
    """Lists the segments of the current curve, in step with the selected ones, and sets their modes."""

    announce = Signal(str)
    """A sentence for the status line: what a toggle did, to neighbours too."""

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._selection = document, selection
        self._item: Item | None = None
        self._shown_segments: frozenset[int] = frozenset()
        self._following = False
        self.model = SegmentModel(self)
        self.list = SegmentList()
        self.list.setModel(self.model)
        self.model.modelReset.connect(self._start_anew)
        describe(self.list, "Segments", _TIP)
        layout = column(self)
        layout.setContentsMargins(0, 12, 0, 9)
        title = heading("Segments")
        title.setContentsMargins(16, 0, 16, 0)
        layout.addWidget(title)
        layout.addWidget(self.list)

        self.list.mode_clicked.connect(self._click)
        self.list.mode_key.connect(self.set_mode)
        self.list.selectionModel().selectionChanged.connect(self._select)
        document.changed.connect(self._follow)
        selection.changed.connect(self._follow)
        self._follow()

    def set_mode(self, mode: Mode) -> None:
        """Give the selected segments a mode, every segment if none is selected."""
        item = self._selection.item
        if item is not None:
            self._make(item, sorted(self._selection.segments) or list(range(item.curve.segment_count)), mode)

    def _click(self, row: int, mode: Mode) -> None:
        if row in self._selection.segments:
            self.set_mode(mode)
        elif self._selection.item is not None:
            self._selection.select(points=(), segments=[row])
            self._make(self._selection.item, [row], mode)

    def _make(self, item: Item, segments: list[int], mode: Mode) -> None:
        if item.locked:
            self.announce.emit(words.locked_reason(item.name))
            return
        old = item.curve
        new = old.with_mode(segments, mode)
        changed = new.mode_codes != old.mode_codes
        chosen = set(segments)
        blends = [s for s in changed.nonzero()[0].tolist() if s not in chosen and new.modes[s] is Mode.BLEND]
        named = words.segments_named(old, segments) if len(segments) == 1 else f"{len(segments)} segments"
        self._document.apply_curve(f"Make {named} {mode.value}", self._selection.curve, new)
        self.model.show_formerly({s: old.modes[s] for s in blends})
        self.announce.emit(_outcome(old, segments, blends, mode))

    def _select(self) -> None:
        """Select on the curve what is selected in the list."""
        if not self._following:
            ranges = self.list.selectionModel().selection()
            rows = [row for part in ranges.toList() for row in range(part.top(), part.bottom() + 1)]
            self._shown_segments = frozenset(rows)
            self._selection.select(points=(), segments=rows)

    def _follow(self) -> None:
        item = self._selection.item
        if item is not self._item:
            old, self._item = self._item, item
            self._following = True
            if item is None or old is None or item.curve is not old.curve:
                self.model.show_curve(item.curve if item is not None else None)
            self._following = False
            self.model.locked_reason = words.locked_reason(item.name) if item and item.locked else ""
            self.list.editable = item is not None and not item.locked
            self.list.viewport().update()
        self._show_selection()

    def _start_anew(self) -> None:
        self._shown_segments = frozenset()
        self.list.updateGeometry()

    def _show_selection(self) -> None:
        """Select in the list what is selected on the curve."""
        model, chosen = self.list.selectionModel(), self._selection.segments
        if self._shown_segments == chosen:
            return
        self._shown_segments = chosen
        selection = QItemSelection()
        for first, last in runs(sorted(chosen)):
            selection.select(self.model.index(first), self.model.index(last))
        self._following = True
        model.select(selection, QItemSelectionModel.SelectionFlag.ClearAndSelect)
        self._following = False
        if chosen:
            first_index = self.model.index(min(chosen))
            model.setCurrentIndex(first_index, QItemSelectionModel.SelectionFlag.NoUpdate)
            self.list.scrollTo(first_index)


def _outcome(curve: Curve, segments: list[int], blends: list[int], mode: Mode) -> str:
    named = words.segments_named(curve, segments)
    sentence = f"{named.capitalize()} {'is' if len(segments) == 1 else 'are'} {mode.value}"
    if not blends:
        return f"{sentence}."
    fate = "became a blend" if len(blends) == 1 else "became blends"
    return f"{sentence}; {words.segments_named(curve, blends)} {fate}."
