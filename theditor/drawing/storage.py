"""Load and save drawings: a save either happens wholly or leaves the old file as it was."""

from __future__ import annotations

import errno
import os
import shutil
import stat
import time
from contextlib import suppress
from io import BufferedReader, BytesIO
from pathlib import Path
from typing import BinaryIO

from theditor.drawing.drawing import Drawing, DrawingError
from theditor.drawing.schema import decode, encode

# Room for a million points in space; more would more likely be a mistake than a drawing.
MAX_BYTES = 128 * 2**20

# Names of temporary files, and the age in seconds at which one is no longer being written.
_PREFIX, _SUFFIX = ".theditor-", ".tmp"
_ABANDONED = 3600.0

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
    errno.ENXIO: "it is a device or a pipe, not a file",
    errno.EFBIG: "it would be larger than the system allows",
    errno.ELOOP: "its symbolic links lead in a circle",
}


def load(path: str | os.PathLike[str]) -> Drawing:
    """Read a drawing from a file of at most 128 MiB.

    Raises
    ------
    DrawingError
        If the file cannot be read or does not hold a drawing: one sentence with file, place and cause.
    """
    data = read_bytes(path)
    try:
        return decode(data)
    except DrawingError as error:
        raise DrawingError(f"{shown(path)}: {error}") from None


def read_bytes(path: str | os.PathLike[str]) -> bytes:
    """Read a whole file, of at most 128 MiB; folders, devices and pipes are refused at once.

    Raises
    ------
    DrawingError
        If the file cannot be read: one sentence with the file and the cause.
    """
    try:
        return _read(Path(path))
    except (OSError, ValueError) as error:  # ValueError: no path can be spelt so
        raise DrawingError(f"{shown(path)} cannot be read: {_cause(error)}.") from error


def save(drawing: Drawing, path: str | os.PathLike[str], overwrite: bool = False) -> str:
    """Write a drawing to a file as `write_atomically` does.

    Parameters
    ----------
    overwrite
        Whether the file may be replaced even if it holds something that is not a drawing of this version.

    Returns
    -------
    str
        The `fingerprint` of what was written.

    Raises
    ------
    DrawingError
        If the file cannot be written, or holds what `unreadable` tells of and `overwrite` is false: one
        sentence with the file and the cause.
    """
    data = encode(drawing)
    if len(data) > MAX_BYTES:
        raise DrawingError(
            f"{shown(path)} cannot be saved: the drawing takes {len(data) / 2**20:.0f} MiB, "
            f"and {MAX_BYTES // 2**20} MiB is the most a file may hold."
        )
    if not overwrite and (reason := unreadable(path)):
        raise DrawingError(
            f"{shown(path)} is not replaced, since it holds something other than a drawing that this program "
            f"can read; choose another name. ({reason})"
        )
    write_atomically(path, data)
    return _sha256(BytesIO(data))


def fingerprint(path: str | os.PathLike[str]) -> str | None:
    """Tell by the SHA-256 of what a file holds whether it still is what was read or written.

    None if there is no such file, or it cannot be read.
    """
    try:
        _refuse_unless_regular(os.stat(path))
        with open(path, "rb", opener=_open_without_waiting) as file:
            return _sha256(file)
    except (OSError, ValueError):  # ValueError: no path can be spelt so
        return None


def _sha256(file: BufferedReader | BytesIO) -> str:
    from hashlib import file_digest  # brings OpenSSL with it: loaded when it is first asked for

    return file_digest(file, "sha256").hexdigest()


def unreadable(path: str | os.PathLike[str]) -> str | None:
    """Tell why what a file holds is no drawing for `load`, so that saving there would destroy something else.

    None if it is a drawing, is empty or is not there, and of folders and devices, which no save replaces.
    """
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    if not stat.S_ISREG(status.st_mode) or not status.st_size:
        return None
    try:
        decode(_read(Path(path)))
    except DrawingError as error:
        return str(error)
    except OSError as error:
        return f"It cannot be read: {_cause(error)}."
    return None


def write_atomically(path: str | os.PathLike[str], data: bytes) -> None:
    """Write bytes to a file, atomically and durably: it holds the old content or the new, never a part.

    The bytes go to a temporary file in the same folder, which replaces the target only once they are on the
    disk. Symbolic links are followed and stay; permissions, extended attributes and, where the system lets
    us, the owner of an existing file are kept. A hard link to the old file keeps the old content.

    Raises
    ------
    DrawingError
        If the file cannot be written: one sentence with the file and the cause.
    """
    try:
        _replace(Path(os.path.realpath(path)), data)
    except (OSError, ValueError) as error:  # ValueError: no path can be spelt so
        cause = _cause(error)
        if isinstance(error, FileNotFoundError):
            folder = os.path.dirname(os.path.realpath(path))
            cause = cause if os.path.isdir(folder) else f"there is no folder {shown(folder)}"
        raise DrawingError(f"{shown(path)} cannot be saved: {cause}.") from error


def shown(path: str | os.PathLike[str]) -> str:
    """Return a path as one line of printable text, whatever bytes the file system allows in it."""
    return "".join(sign if sign.isprintable() else ascii(sign)[1:-1] for sign in os.fspath(path))


def _read(path: Path) -> bytes:
    # Asked before opening, which alone may set a device going, and after, in case another file came between.
    _refuse_unless_regular(path.stat())
    with open(path, "rb", opener=_open_without_waiting) as file:
        _refuse_unless_regular(os.fstat(file.fileno()))
        data = file.read(MAX_BYTES + 1)
    if len(data) > MAX_BYTES:
        raise OSError(f"it holds more than {MAX_BYTES // 2**20} MiB, the most a drawing may take")
    return data


def _open_without_waiting(path: str, flags: int) -> int:
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


def _replace(target: Path, data: bytes) -> None:
    old = None
    with suppress(FileNotFoundError):
        old = target.stat()
        _refuse_unless_regular(old)
        if not os.access(target, os.W_OK):
            raise OSError("the file is read-only")
    _sweep(target.parent)
    temporary = target.with_name(f"{_PREFIX}{os.urandom(8).hex()}{_SUFFIX}")
    try:
        with _new(temporary) as file:
            if old is not None:
                _copy_permissions(target, old, temporary)
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, target)
    except BaseException:
        with suppress(OSError):
            temporary.unlink()
        raise
    _sync_folder(target.parent)


def _new(path: Path) -> BinaryIO:
    try:
        return path.open("xb")
    except PermissionError:
        raise OSError("permission is denied to make files in its folder, which saving needs") from None


def _copy_permissions(target: Path, status: os.stat_result, temporary: Path) -> None:
    """Give a file, while it is still empty, the owner, mode and extended attributes of another."""
    with suppress(OSError, AttributeError):  # only root gives files away, and not every system knows owners
        os.chown(temporary, status.st_uid, status.st_gid)
    with suppress(OSError):  # a file system without permissions has none to keep
        shutil.copystat(target, temporary)
        os.utime(temporary)  # `_sweep` goes by its age


def _sweep(folder: Path) -> None:
    """Remove what saves that were killed left in a folder, once it is too old to belong to one at work."""
    with suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if entry.name.startswith(_PREFIX) and entry.name.endswith(_SUFFIX):
                with suppress(OSError):
                    if time.time() - entry.stat(follow_symlinks=False).st_mtime > _ABANDONED:
                        os.unlink(entry.path)


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
