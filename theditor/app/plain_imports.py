"""Loading Qt without what it does to every import after it."""

from __future__ import annotations

import builtins
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def plain_imports() -> Iterator[None]:
    """Keep Python's way to import while Qt is loaded.

    PySide puts its own in place, which looks into the source of each module to come for ``from __feature__``.
    Nothing here has that, and looking takes a tenth of the time until the window is painted.
    """
    plain = builtins.__import__
    try:
        yield
    finally:
        builtins.__import__ = plain
