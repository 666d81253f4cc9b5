"""Loading Qt without what it does to every import after it."""

from __future__ import annotations

import builtins
from importlib import import_module


def load_qt() -> None:
    """Load Qt, and keep Python's way to import.

    PySide puts its own in place, which looks into the source of each module to come for ``from __feature__``.
    Nothing here has that, and looking takes a tenth of the time until the window is painted.
    """
    plain = builtins.__import__
    try:
        import_module("PySide6.QtCore")
    finally:
        builtins.__import__ = plain
