"""A window's claim to its file, by which windows on the same file know of each other."""

from __future__ import annotations

import os
from pathlib import Path

from PySide6.QtCore import QLockFile

from theditor.model.data_folder import Owner, data_folder, lock_at, owner_of


class Claim:
    """A claim to one file at a time, seen by all windows and processes of this user.

    It is a lock in the application's data, never beside the file. A claim keeps nobody from reading or writing:
    it says whom to ask first.
    """

    def __init__(self) -> None:
        self._lock: QLockFile | None = None

    def hold(self, path: Path | None) -> Owner | None:
        """Claim a file in place of the one before; None for no file.

        Returns
        -------
        Owner or None
            Who else has the file; None if nobody has, or if claims cannot be made here at all.
        """
        if path is None:
            self._let_go()
            return None
        lock = lock_at(_lock_path(path))
        if self._lock is None or self._lock.fileName() != lock.fileName():
            self._let_go()
            try:
                Path(lock.fileName()).parent.mkdir(parents=True, exist_ok=True)
            except OSError:
                return None
            self._lock = lock
        if self._lock.isLocked() or self._lock.tryLock(0):
            return None
        return owner_of(self._lock) if self._lock.error() == QLockFile.LockError.LockFailedError else None

    def _let_go(self) -> None:
        if self._lock is not None:
            self._lock.unlock()
            self._lock = None


def owner_of_file(path: Path) -> Owner | None:
    """Who has a file; None if nobody has."""
    claim = Claim()
    owner = claim.hold(path)
    claim.hold(None)
    return owner


def _lock_path(path: Path) -> Path:
    """One lock for all names of a file that lead through links."""
    from hashlib import sha256  # brings OpenSSL with it: loaded when it is first asked for

    name = os.fsencode(os.path.normcase(os.path.realpath(path)))
    return data_folder() / "claims" / f"{sha256(name).hexdigest()}.lock"
