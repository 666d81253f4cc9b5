"""Unsaved work on the disk, where it outlives a crash: files of the application's own, beside its data."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator
from contextlib import suppress
from datetime import datetime, timedelta
from pathlib import Path
from typing import NamedTuple

from theditor.drawing import Drawing, encode_in_parts, load, write_atomically
from theditor.model.data_folder import data_folder, lock_at

DAYS = 7
"""How long discarded work can be recovered."""


class About(NamedTuple):
    """Which drawing it is.

    Attributes
    ----------
    title, path
        What the drawing is called, and its file, if it has one.
    fingerprint
        Of what that file held when it was last read or saved.
    discarded
        When the work was given up, None if it was not: then something ended the program.
    process, host
        Which process kept it, for whoever looks into the folder.
    """

    title: str
    path: Path | None = None
    fingerprint: str | None = None
    discarded: datetime | None = None
    process: int = 0
    host: str = ""


class KeptWork:
    """One drawing's unsaved work: the drawing in the native format, what it is, and a lock while somebody has it.

    Parameters
    ----------
    stem
        Path of the three files without their endings.
    """

    def __init__(self, stem: Path) -> None:
        self.path = stem.with_name(f"{stem.name}.json")
        self._about_path = stem.with_name(f"{stem.name}.about")
        self._lock = lock_at(stem.with_name(f"{stem.name}.lock"))

    def take(self) -> bool:
        """Take hold of it; false if another window or process has it."""
        return self._lock.isLocked() or self._lock.tryLock(0)

    def let_go(self) -> None:
        """Leave it as it is for others."""
        self._lock.unlock()

    def write(self, drawing: Drawing, about: About, rest: Callable[[], object]) -> None:
        """Keep a drawing in place of the one before; raises `DrawingError` if that is impossible.

        About every millisecond of work it takes a `rest`.
        """
        self._write_about(about)
        parts = []
        for part in encode_in_parts(drawing):
            parts.append(part)
            rest()
        write_atomically(self.path, b"".join(parts))

    def discard(self) -> None:
        """Note that it was given up now: in some days `kept_work` removes it."""
        self._write_about(self.about._replace(discarded=datetime.now()))

    def remove(self) -> None:
        """Remove it for good."""
        self.path.unlink(missing_ok=True)
        self._about_path.unlink(missing_ok=True)
        self.let_go()

    def read(self) -> Drawing:
        """The drawing; raises `DrawingError` if its file is damaged."""
        return load(self.path)

    @property
    def time(self) -> datetime:
        """When the drawing was written."""
        try:
            return datetime.fromtimestamp(self.path.stat().st_mtime)
        except OSError:
            return datetime.now()

    @property
    def about(self) -> About:
        """Which drawing it is, as far as that can still be told."""
        try:
            told = json.loads(self._about_path.read_text("utf-8"))
        except (OSError, ValueError):
            told = None
        if not isinstance(told, dict):
            return About("Untitled")
        path, known, title = told.get("path"), told.get("fingerprint"), told.get("title")
        return About(
            title if isinstance(title, str) else "Untitled",
            Path(path) if isinstance(path, str) else None,
            known if isinstance(known, str) else None,
            _time(told.get("discarded")),
        )

    def _write_about(self, about: About) -> None:
        told = {
            "title": about.title,
            "path": None if about.path is None else os.path.abspath(about.path),
            "fingerprint": about.fingerprint,
            "discarded": None if about.discarded is None else about.discarded.isoformat(),
            "process": about.process,
            "host": about.host,
        }
        write_atomically(self._about_path, json.dumps(told, indent=1).encode())


def new_work() -> KeptWork:
    """A place for work that is to be kept, taken; raises OSError if there can be none."""
    folder = _folder()
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)  # as private as the drawing may be
    work = KeptWork(folder / f"{datetime.now():%Y-%m-%d-%H%M%S}-{os.urandom(4).hex()}")
    if not work.take():
        raise OSError(f"{folder} cannot be written")
    return work


def kept_work() -> list[KeptWork]:
    """All work that no window has now, each taken, the latest first.

    What was discarded more than `DAYS` days ago is removed.
    """
    found = []
    for work in _all():
        if not work.take():
            continue
        given_up = work.about.discarded
        if not work.path.exists() or (given_up and datetime.now() - given_up > timedelta(days=DAYS)):
            with suppress(OSError):
                work.remove()
            work.let_go()
        else:
            found.append(work)
    return sorted(found, key=lambda work: work.time, reverse=True)


def any_work() -> bool:
    """Whether there is work that may be `kept_work`; takes none."""
    return any(True for _ in _all())


def _all() -> Iterator[KeptWork]:
    with suppress(OSError):
        stems = {path.with_suffix("") for path in _folder().iterdir() if path.suffix in (".json", ".about")}
        yield from map(KeptWork, sorted(stems))


def _folder() -> Path:
    return data_folder() / "recovery"


def _time(told: object) -> datetime | None:
    try:
        return datetime.fromisoformat(told) if isinstance(told, str) else None
    except ValueError:
        return None
