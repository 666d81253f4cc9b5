"""Load and save drawings: a save either happens wholly or leaves the old file as it was."""

from __future__ import annotations

import errno
import os
import secrets
import stat
from contextlib import suppress
from pathlib import Path

from theditor.drawing.drawing import Drawing, DrawingError
from theditor.drawing.schema import decode, encode

# Room for a million points in space; more would more likely be a mistake than a drawing.
MAX_BYTES = 128 * 2**20

_CAUSES = {
    errno.ENOENT: "there is no such file or folder",
    errno.ENOTDIR: "a part of its path is not a folder",
    errno.EISDIR: "it is a folder",
    errno.EACCES: "permission is denied",
    errno.EPERM: "permission is denied",
    errno.EROFS: "the file system is read-only",
    errno.ENOSPC: "the disk is full",
    errno.EDQUOT: "the disk quota is used up",
    errno.ENAMETOOLONG: "the name is too long",
    errno.ELOOP: "its symbolic links lead in a circle",
}


def load(path: str | os.PathLike[str]) -> Drawing:
    """Read a drawing from a file of at most 128 MiB.

    Raises
    ------
    DrawingError
        If the file cannot be read or does not hold a drawing: one sentence with file, place and cause.
    """
    try:
        data = _read(Path(path))
    except (OSError, ValueError) as error:  # ValueError: no path can be spelt so
        raise DrawingError(f"{shown(path)} cannot be read: {_cause(error)}.") from error
    try:
        return decode(data)
    except DrawingError as error:
        raise DrawingError(f"{shown(path)}: {error}") from None


def save(drawing: Drawing, path: str | os.PathLike[str]) -> None:
    """Write a drawing to a file, atomically and durably.

    The bytes go to a temporary file in the same folder, which replaces the target only once they are on the
    disk, so a failure leaves the old file untouched. Symbolic links are followed and stay; the mode of an
    existing file is kept. A hard link to the old file keeps the old drawing.

    Raises
    ------
    DrawingError
        If the file cannot be written: one sentence with the file and the cause.
    """
    data = encode(drawing)
    if len(data) > MAX_BYTES:
        raise DrawingError(
            f"{shown(path)} cannot be saved: the drawing takes {len(data) / 2**20:.0f} MiB, "
            f"and {MAX_BYTES // 2**20} MiB is the most a file may hold."
        )
    try:
        _replace(Path(os.path.realpath(path)), data)
    except (OSError, ValueError) as error:  # ValueError: no path can be spelt so
        raise DrawingError(f"{shown(path)} cannot be saved: {_cause(error)}.") from error


def shown(path: str | os.PathLike[str]) -> str:
    """Return a path as one line of printable text, whatever bytes the file system allows in it."""
    return "".join(sign if sign.isprintable() else ascii(sign)[1:-1] for sign in os.fspath(path))


def _read(path: Path) -> bytes:
    # Asked before opening: opening a pipe would wait for someone to write into it.
    _refuse_unless_regular(path.stat())
    with path.open("rb") as file:
        data = file.read(MAX_BYTES + 1)
    if len(data) > MAX_BYTES:
        raise OSError(f"it holds more than {MAX_BYTES // 2**20} MiB, the most a drawing may take")
    return data


def _replace(target: Path, data: bytes) -> None:
    mode = None
    with suppress(FileNotFoundError):
        status = target.stat()
        _refuse_unless_regular(status)
        if not os.access(target, os.W_OK):
            raise OSError("the file is read-only")
        mode = stat.S_IMODE(status.st_mode)
    temporary = target.with_name(f".theditor-{secrets.token_hex(8)}.tmp")
    try:
        with temporary.open("xb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        if mode is not None:
            temporary.chmod(mode)
        os.replace(temporary, target)
    except BaseException:
        with suppress(OSError):
            temporary.unlink()
        raise
    _sync_folder(target.parent)


def _sync_folder(folder: Path) -> None:
    """Make the new name durable where folders can be synchronised; the drawing itself is safe already."""
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)


def _refuse_unless_regular(status: os.stat_result) -> None:
    if stat.S_ISDIR(status.st_mode):
        raise IsADirectoryError(errno.EISDIR, "is a folder")
    if not stat.S_ISREG(status.st_mode):
        raise OSError("it is a device or a pipe, not a file")


def _cause(error: OSError | ValueError) -> str:
    if isinstance(error, OSError) and error.errno is not None:
        return _CAUSES.get(error.errno) or os.strerror(error.errno)
    return str(error)
