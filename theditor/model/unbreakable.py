"""Keeps an error in one event from ending the program."""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable
from typing import Any, TypeVar

Widget = TypeVar("Widget", bound=type)

_PAINTS = ("paint", "drawBackground", "drawForeground")


def unbreakable(widget: Widget) -> Widget:
    """Send errors in a class's own event handlers to `sys.excepthook`, as errors in slots go there.

    A class decorator for widgets and delegates. Qt calls handlers within handlers, and on Python 3.11 PySide
    crashes on an error that leaves the inner one; so none leaves it. A handler that failed counts as having
    dealt with its event.
    """
    for name, method in vars(widget).items():
        if callable(method) and (name in _PAINTS or name == "event" or name.endswith("Event")):
            setattr(widget, name, _caught(method))
    return widget


def _caught(method: Callable[..., Any]) -> Callable[..., Any]:
    @functools.wraps(method)
    def handler(*arguments: Any) -> Any:
        try:
            return method(*arguments)
        except Exception:
            sys.excepthook(*sys.exc_info())
            return True if method.__name__ in ("event", "viewportEvent", "editorEvent") else None

    return handler
