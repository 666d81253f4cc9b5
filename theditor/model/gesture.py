"""A gesture: an edit while the hand is still on it (a drag, a slider press)."""

from __future__ import annotations

from collections.abc import Callable

from theditor.drawing import Drawing


class Gesture:
    """An edit in progress: previewed live, then committed as one undo step or cancelled without trace.

    Every preview is built from `before`, so that nothing drifts however long the drag. Get one from
    `Document.begin`; a document has at most one open gesture.
    """

    def __init__(
        self,
        text: str,
        before: Drawing,
        show: Callable[[Drawing], None],
        close: Callable[[Gesture, bool], None],
    ) -> None:
        self.text = text
        self.before = before
        self._show = show
        self._close = close
        self.is_open = True

    def preview(self, drawing: Drawing) -> None:
        """Show `drawing` as the document's value. Ignored once the gesture is over."""
        if self.is_open:
            self._show(drawing)

    def commit(self) -> None:
        """Keep what is shown, as one undo step (none if it equals `before`)."""
        self._end(keep=True)

    def cancel(self) -> None:
        """Go back to `before`; the undo history is as it was, its redo branch included."""
        self._end(keep=False)

    def _end(self, *, keep: bool) -> None:
        if self.is_open:
            self.is_open = False
            self._close(self, keep)
