"""What an installed package knows besides its code: the gallery, other resources, its version.

Resources lie inside the package when it is installed, and beside it in the repository.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NamedTuple

_PACKAGE = Path(__file__).resolve().parent


class Setup(NamedTuple):
    """What a picture brings with it, so that one can try at once what it says.

    Attributes
    ----------
    panel
        Name of the dock to raise.
    curve, points, segments
        What to select; segments by the numbers that the window shows.
    show
        What to show on the canvas besides the usual.
    """

    panel: str = ""
    curve: int = 0
    points: tuple[int, ...] = ()
    segments: tuple[int, ...] = ()
    show: tuple[str, ...] = ()


class Picture(NamedTuple):
    """One drawing of the gallery: a short name, a title, what it shows and what to try, its file, its setup."""

    name: str
    title: str
    about: str
    path: Path
    setup: Setup = Setup()


def resource(name: str) -> Path:
    """Return the path of a resource, a file or folder such as ``"gallery"``.

    Raises
    ------
    FileNotFoundError
        If it is neither in the installed package nor in a repository around it.
    """
    for folder in (_PACKAGE / "_resources", _PACKAGE.parent / "resources"):
        if (path := folder / name).exists():
            return path
    raise FileNotFoundError(f"theditor's resource {name!r} is missing: install theditor again.")


def gallery() -> tuple[Picture, ...]:
    """Return the pictures of the gallery in the order to show them: the paper's figures, known curves."""
    folder = resource("gallery")
    entries = json.loads((folder / "index.json").read_text("utf-8"))
    return tuple(
        Picture(
            entry["name"],
            entry["title"],
            entry["about"],
            folder / f"{entry['name']}.json",
            _setup(entry.get("setup", {})),
        )
        for entry in entries
    )


def _setup(entry: dict[str, Any]) -> Setup:
    fields: dict[str, Any] = {k: tuple(v) if isinstance(v, list) else v for k, v in entry.items()}
    return Setup(**fields)


def version() -> str:
    """Return the installed version, or "unknown" where the package runs without being installed."""
    from importlib import metadata  # takes longer to load than all else here, and is seldom asked for

    try:
        return metadata.version("theditor")
    except metadata.PackageNotFoundError:
        return "unknown"
