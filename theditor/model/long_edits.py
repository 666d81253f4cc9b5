"""Edits of curves that can take long: done at once, or as long work on the curves as they are."""

from __future__ import annotations

from collections.abc import Callable, Collection

from theditor.drawing import Drawing
from theditor.model.document import Document
from theditor.model.worker import AtOnce, Report, Result


def edit_curves(
    document: Document,
    chosen: Collection[int],
    words: str,
    edit: Callable[[Report], Result],
    finish: Callable[[Result], str],
    tell: Callable[[str], None],
    *,
    long: bool,
) -> None:
    """Edit some curves of the drawing, and tell what happened.

    Parameters
    ----------
    chosen
        The curves.
    words
        What is going on: ``"Making “a” cubic"``.
    edit
        Works on immutable values alone; its result goes to `finish`.
    finish
        Replaces the curves in one undo step and returns what to tell. The work is given up if they change meanwhile.
    long
        Whether it is long work.
    """
    before = document.drawing

    def doomed() -> str:
        if all(_stands(before, document.drawing, i) for i in chosen):
            return ""
        return f"{words} was given up: {named(before, chosen)} changed meanwhile."

    worker = document.worker if long else AtOnce()
    worker.start(words, edit, lambda result: tell(finish(result)), doomed=doomed, bound=True)


def named(drawing: Drawing, curves: Collection[int]) -> str:
    """What to call some curves of a drawing."""
    return f"“{drawing[min(curves)].name}”" if len(curves) == 1 else f"{len(curves)} curves"


def _stands(before: Drawing, now: Drawing, i: int) -> bool:
    """Whether a curve is still there, may be edited, and is the same."""
    return i < len(now) and now[i].curve is before[i].curve and not now[i].locked
