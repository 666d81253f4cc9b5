"""What was chosen last for each foreign format, and the folders it was for; kept in the user's settings."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Literal

from PySide6.QtCore import QSettings

from theditor.exchange import Options

Way = Literal["export", "import"]


def kept_options(way: Way, suffix: str = "") -> Options:
    """Return the options used last; the usual ones if there are none, or none that this program knows."""
    try:
        return Options(**json.loads(str(QSettings().value(_place(way, suffix), "{}"))))
    except (ValueError, TypeError):
        return Options()


def keep_options(options: Options, way: Way, suffix: str = "") -> None:
    """Keep options for the next time."""
    values = asdict(options) | {"show": sorted(options.show)}
    QSettings().setValue(_place(way, suffix), json.dumps(values))


def kept_folder(way: Way) -> Path | None:
    """Return the folder used last, if it is still there."""
    folder = Path(str(QSettings().value(f"{way}/folder", "")))
    return folder if folder.is_absolute() and folder.is_dir() else None


def keep_folder(folder: Path, way: Way) -> None:
    """Keep a folder for the next time."""
    QSettings().setValue(f"{way}/folder", str(folder.absolute()))


def _place(way: Way, suffix: str) -> str:
    return f"{way}/options{suffix}"
