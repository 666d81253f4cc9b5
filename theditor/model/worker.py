"""Who does long work for the document: this thread, at once, unless a window does it beside itself."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol, TypeVar

Result = TypeVar("Result")
Report = Callable[[float], None]
"""Is told now and then the share of the work that is done, 0 to 1."""


class Worker(Protocol):
    """Does work, and hands over in the window's thread what comes of it."""

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
        """Call a function, and hand its result to `done`; returns what calls it off.

        Parameters
        ----------
        words
            What is going on: ``"Making “a” cubic"``.
        function
            Must touch neither window nor document: immutable values alone.
        otherwise
            Called in place of `done` if nothing comes of it: it failed, or was called off.
        doomed
            Asked after every step of the document. Once it returns a sentence, nothing can come of the work any
            more; the sentence is told, and the work called off.
        bound
            Whether the work is for the drawing at hand, and is called off when another one takes its place.
        precious
            Whether it works on what the hand made and nothing else holds: leaving the drawing waits for it.
        """


class AtOnce:
    """Does all work where it is asked for."""

    def start(
        self,
        words: str,
        function: Callable[[Report], Result],
        done: Callable[[Result], object],
        *_: object,
        **__: object,
    ) -> Callable[[], None]:
        """See `Worker.start`."""
        done(function(_unheard))
        return _over


def part_of(report: Report, before: int, count: int) -> Report:
    """Return what reports the work on one of `count` parts, `before` of which are done."""
    return lambda share: report((before + share) / count)


def _over() -> None:
    """It is done: there is nothing to call off."""


def _unheard(share: float) -> None:
    """Nobody waits for a report."""
