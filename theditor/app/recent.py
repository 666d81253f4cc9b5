"""The files opened and saved last, kept in the user's settings."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QSettings

MOST = 10


def recent_files() -> list[Path]:
    """The latest first; files that are gone are left out."""
    kept = QSettings().value("recent", [])
    names = kept if isinstance(kept, list) else [kept]
    return [path for name in names if name and (path := Path(str(name))).is_file()]


def remember_file(path: Path) -> None:
    """Put a file first."""
    path = path.absolute()
    files = [path, *(other for other in recent_files() if other != path)]
    QSettings().setValue("recent", [str(file) for file in files[:MOST]])
