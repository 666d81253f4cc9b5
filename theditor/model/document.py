"""The document: the drawing being edited, where it is saved, and its undo history."""

from __future__ import annotations

import weakref
from contextlib import suppress
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from theditor.drawing import Drawing, fingerprint, load, save
from theditor.drawing.change import Change, difference
from theditor.model.gesture import Gesture
from theditor.model.worker import AtOnce, Worker
from theditor.spline import Curve

UNTITLED = "Untitled"


class Document(QObject):
    """The current `Drawing` with its undo history and its file.

    A drawing is an immutable value; every edit replaces it. Views listen to `changed`, which carries the old
    and the new value, and redraw where the two differ.
    """

    changed = Signal(object, object)
    """The drawing was replaced: old value, new value. Sent for previews of a gesture, too."""

    leaving = Signal()
    """Everything is about to be replaced: what is not saved or kept now is lost."""

    started = Signal()
    """Everything was replaced: another drawing was opened or begun."""

    stepped = Signal()
    """The undo history is another one: a step more or less, another state, another state saved."""

    travelling = Signal()
    """The history is about to go back or forth to another state, by undo, redo or a jump."""

    renamed = Signal()
    """The path or the title is another one."""

    def __init__(self, drawing: Drawing | None = None, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._drawing = drawing if drawing is not None else Drawing()
        self._path: Path | None = None
        self._title = UNTITLED
        self._known: str | None = None
        self._gesture: Gesture | None = None
        self._run = 0
        self._jumping = False
        self.worker: Worker = AtOnce()
        self.undo_stack = QUndoStack(self)
        # Python clears circles in any order, and the stack would delete steps that are gone already: so it is
        # emptied while all of them are there.
        weakref.finalize(self, _empty, self.undo_stack).atexit = False
        self.undo_stack.indexChanged.connect(self._tell_step)
        self.undo_stack.cleanChanged.connect(self._tell_step)

    @property
    def drawing(self) -> Drawing:
        """The current value."""
        return self._drawing

    @property
    def path(self) -> Path | None:
        """The file this drawing was opened from or saved to, if any."""
        return self._path

    @property
    def title(self) -> str:
        """What to call this drawing: its file's name, or a title while it has no file."""
        return self._path.stem if self._path else self._title

    @property
    def fingerprint(self) -> str | None:
        """Fingerprint of what the file held when it was last read or written here, None without a file."""
        return self._known

    @property
    def is_clean(self) -> bool:
        """Whether there is nothing unsaved."""
        gesture = self._gesture
        return self.undo_stack.isClean() and (gesture is None or gesture.before == self._drawing)

    @property
    def before(self) -> Drawing | None:
        """The value before the open gesture, None while no hand is on the drawing."""
        return self._gesture.before if self._gesture is not None else None

    # Edits

    def begin(self, text: str) -> Gesture:
        """Start a gesture whose undo step will be called `text`; an open one is committed first."""
        self.settle()
        self._gesture = Gesture(text, self._drawing, self._show, self._close_gesture)
        return self._gesture

    def settle(self) -> None:
        """Commit the open gesture, if there is one. Save, undo and close do this first."""
        if self._gesture is not None:
            self._gesture.commit()

    def apply(self, text: str, drawing: Drawing, merge: object = None) -> None:
        """Replace the drawing in one undo step called `text`; nothing happens if it is equal.

        Parameters
        ----------
        merge
            Steps that follow each other with the same text and an equal `merge` (not None) become one step:
            nudges by key, wheel and spin-box steps. `break_run` ends such a run.
        """
        self.settle()
        before = self._drawing
        if drawing == before:
            return
        self._show(drawing)
        key = None if merge is None else (text, merge, self._run)
        self.undo_stack.push(_Replace(self, text, difference(before, drawing), key))

    def apply_curve(self, text: str, index: int, curve: Curve, merge: object = None) -> None:
        """Replace the curve of item `index`, otherwise as `apply`."""
        self.settle()
        self.apply(text, self._drawing.with_curve(index, curve), merge)

    def break_run(self) -> None:
        """End a run of merging steps: the next step is one of its own."""
        self._run += 1

    def undo(self) -> None:
        """Take the last step back; an open gesture counts as the last step."""
        self.settle()
        if self.undo_stack.canUndo():
            self.travelling.emit()
        self.undo_stack.undo()
        self.break_run()

    def redo(self) -> None:
        """Do the step last taken back once more."""
        self.settle()
        if self.undo_stack.canRedo():
            self.travelling.emit()
        self.undo_stack.redo()
        self.break_run()

    def jump(self, index: int) -> None:
        """Go to the state after the first `index` steps at once: views hear of one change, however many steps."""
        self.settle()
        if index != self.undo_stack.index():
            self.travelling.emit()
        before = self._drawing
        self._jumping = True
        self.undo_stack.blockSignals(True)
        try:
            self.undo_stack.setIndex(index)
        finally:
            self.undo_stack.blockSignals(False)
            self._jumping = False
        self.break_run()
        if self._drawing is not before:
            self.changed.emit(before, self._drawing)
        # The stack was kept silent, so that nobody heard of a step before its drawing.
        stack = self.undo_stack
        stack.indexChanged.emit(stack.index())
        stack.cleanChanged.emit(stack.isClean())
        stack.canUndoChanged.emit(stack.canUndo())
        stack.canRedoChanged.emit(stack.canRedo())

    # Files

    def open(self, path: Path) -> None:
        """Replace everything by the drawing in a file.

        Raises
        ------
        DrawingError
            The file cannot be read; the document is as it was.
        """
        known = fingerprint(path)  # before it is read: a change in between is noticed later on
        drawing = load(path)
        self._start_anew(drawing, path, path.stem, known)

    def start(self, drawing: Drawing, title: str = UNTITLED) -> None:
        """Replace everything by a drawing that has no file yet."""
        self._start_anew(drawing, None, title, None)

    def recover(self, drawing: Drawing, title: str, path: Path | None, known: str | None) -> None:
        """Replace everything by unsaved work on the file at `path`, whose fingerprint was `known` then."""
        self._start_anew(drawing, path, title, known)
        self.mark_unsaved()

    def reload(self) -> None:
        """Take over what the file holds now, in an undo step; reloads without anything in between are one step.

        Raises
        ------
        DrawingError
            The file cannot be read; the document is as it was.
        ValueError
            There is no file.
        """
        if self._path is None:
            raise ValueError("the drawing has no file to reload")
        known = fingerprint(self._path)
        drawing = load(self._path)
        self.settle()
        self.mark_unsaved()  # a saved state is never merged into another step
        self.apply("Reload", drawing, merge="reload")
        self._known = known
        self.undo_stack.setClean()

    def mark_unsaved(self) -> None:
        """Count every state as unsaved until the next save: the file holds none of them any more."""
        self.undo_stack.resetClean()

    def insist(self) -> None:
        """Keep the drawing in spite of what the file holds now; the next save may replace that."""
        self._known = fingerprint(self._path) if self._path is not None else None
        self.mark_unsaved()

    @property
    def differs_on_disk(self) -> bool:
        """Whether the file holds something other than was last read or written here; a file that is gone does not."""
        found = fingerprint(self._path) if self._path is not None else None
        return found is not None and found != self._known

    def leave_file(self, title: str) -> None:
        """Go on without the file, under a title: as a copy of it."""
        self._path, self._title, self._known = None, title, None
        self.renamed.emit()

    def save(self, path: Path | None = None, overwrite: bool = False) -> None:
        """Save to `path`, or to the document's own file; `overwrite` as for `theditor.drawing.save`.

        Raises
        ------
        DrawingError
            The file cannot be written, or is another one that holds no drawing; it is as it was.
        ValueError
            There is neither a path nor a file yet.
        """
        self.settle()
        path = path or self._path
        if path is None:
            raise ValueError("the drawing has no file yet: name one")
        self._known = save(self._drawing, path, overwrite or path == self._path)
        self._path = path
        self.undo_stack.setClean()
        self.renamed.emit()

    # Inner workings

    def _start_anew(self, drawing: Drawing, path: Path | None, title: str, known: str | None) -> None:
        if self._gesture is not None:
            self._gesture.cancel()
        self.leaving.emit()
        self.undo_stack.clear()
        self._path, self._title, self._known = path, title, known
        self._show(drawing)
        self.started.emit()
        self.renamed.emit()

    def _show(self, drawing: Drawing) -> None:
        old, self._drawing = self._drawing, drawing
        if old is not drawing and not self._jumping:
            self.changed.emit(old, drawing)

    def _tell_step(self, *_: object) -> None:
        self.stepped.emit()

    def _close_gesture(self, gesture: Gesture, keep: bool) -> None:
        self._gesture = None
        after = self._drawing
        if not keep or after == gesture.before:
            self._show(gesture.before)
        else:
            change = difference(gesture.before, after)
            self.undo_stack.push(_Replace(self, gesture.text, change, None))
            self.break_run()


def _empty(stack: QUndoStack) -> None:
    with suppress(RuntimeError):  # Qt has deleted it before, steps and all
        stack.blockSignals(True)
        stack.clear()


class _Replace(QUndoCommand):
    """The one kind of undo step: a change from one drawing to another, already shown when it is pushed."""

    ID = 1

    def __init__(self, document: Document, text: str, change: Change, key: object) -> None:
        super().__init__(text)
        self._document = weakref.ref(document)  # the stack's steps outlive it by a moment
        self.change = change
        self.key = key
        self._shown = True

    @property
    def document(self) -> Document:
        document = self._document()
        assert document is not None, "its stack belongs to it"
        return document

    def redo(self) -> None:
        if self._shown:
            self._shown = False
        else:
            self.document._show(self.change.apply(self.document.drawing))

    def undo(self) -> None:
        self.document._show(self.change.revert(self.document.drawing))

    def id(self) -> int:
        return self.ID if self.key is not None else -1

    def mergeWith(self, other: QUndoCommand) -> bool:
        if not isinstance(other, _Replace) or other.key != self.key:
            return False
        after = self.document.drawing
        before = self.change.revert(other.change.revert(after))
        self.change = difference(before, after)
        self.setObsolete(before == after)
        return True
