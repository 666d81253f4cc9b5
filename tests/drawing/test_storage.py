import errno
import os
import stat
import sys
from pathlib import Path

import pytest

from theditor.drawing import Drawing, DrawingError, Item, encode, load, save
from theditor.spline import Curve

OLD = Drawing([Item(Curve([[0, 0], [1, 2], [3, 2], [4, 0]]), "old")])
NEW = Drawing([Item(Curve([[0, 0], [1, 2], [3, 2], [4, 0]], 1.0, closed=True), "new λ")])

posix = pytest.mark.skipif(sys.platform == "win32", reason="POSIX files")
not_root = pytest.mark.skipif(
    not hasattr(os, "geteuid") or os.geteuid() == 0, reason="nothing is forbidden to root"
)


def refusal(action, *arguments):
    with pytest.raises(DrawingError) as caught:
        action(*arguments)
    return str(caught.value)


def test_save_and_load(tmp_path):
    path = tmp_path / "Zeichnung λ.json"
    save(OLD, path)
    save(NEW, str(path))
    assert load(path) == NEW
    assert path.read_bytes() == encode(NEW)
    assert list(tmp_path.iterdir()) == [path]


@posix
def test_a_save_keeps_links_and_permissions(tmp_path):
    target, link = tmp_path / "target.json", tmp_path / "link.json"
    save(OLD, target)
    target.chmod(0o640)
    link.symlink_to(target.name)
    save(NEW, link)
    assert link.is_symlink()
    assert load(target) == NEW
    assert stat.S_IMODE(target.stat().st_mode) == 0o640


@posix
def test_a_new_file_has_the_permissions_that_the_user_gives_new_files(tmp_path):
    save(OLD, tmp_path / "drawing.json")
    (tmp_path / "other").touch()
    assert (tmp_path / "drawing.json").stat().st_mode == (tmp_path / "other").stat().st_mode


@pytest.mark.parametrize("step", ["fsync", "replace"])
@pytest.mark.parametrize(
    ("code", "cause"),
    [
        (errno.ENOSPC, "the disk is full"),
        (errno.EROFS, "the file system is read-only"),
        (errno.EACCES, "permission is denied"),
        (errno.EIO, os.strerror(errno.EIO)),
    ],
)
def test_a_failed_save_leaves_the_old_file_and_nothing_else(tmp_path, monkeypatch, step, code, cause):
    path = tmp_path / "drawing.json"
    save(OLD, path)

    def fail(*_):
        raise OSError(code, os.strerror(code))

    monkeypatch.setattr(os, step, fail)
    assert refusal(save, NEW, path) == f"{path} cannot be saved: {cause}."
    assert load(path) == OLD
    assert list(tmp_path.iterdir()) == [path]


@posix
def test_a_save_cut_off_by_the_system_leaves_the_old_file(tmp_path):
    import resource

    path = tmp_path / "drawing.json"
    save(OLD, path)
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, hard))
    try:
        sentence = refusal(save, NEW, path)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert sentence == f"{path} cannot be saved: File too large."
    assert load(path) == OLD
    assert list(tmp_path.iterdir()) == [path]


def test_an_interrupted_save_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "drawing.json"
    save(OLD, path)

    def interrupt(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", interrupt)
    with pytest.raises(KeyboardInterrupt):
        save(NEW, path)
    assert load(path) == OLD
    assert list(tmp_path.iterdir()) == [path]


def test_what_cannot_be_read_or_written_is_named_with_its_cause(tmp_path):
    file = tmp_path / "file.json"
    save(OLD, file)
    missing = tmp_path / "missing.json"
    assert refusal(load, missing) == f"{missing} cannot be read: there is no such file or folder."
    assert refusal(load, tmp_path) == f"{tmp_path} cannot be read: it is a folder."
    assert refusal(save, OLD, tmp_path) == f"{tmp_path} cannot be saved: it is a folder."
    nowhere = tmp_path / "nowhere" / "a.json"
    assert refusal(save, OLD, nowhere) == f"{nowhere} cannot be saved: there is no such file or folder."
    large = tmp_path / "large.json"
    with large.open("wb") as stream:
        stream.truncate(128 * 2**20 + 1)
    assert "more than 128 MiB" in refusal(load, large)


@posix
def test_devices_pipes_and_odd_paths_are_refused_at_once(tmp_path):
    pipe, loop = tmp_path / "pipe", tmp_path / "loop"
    os.mkfifo(pipe)
    loop.symlink_to(loop)
    for path in (pipe, Path(os.devnull)):
        assert refusal(load, path) == f"{path} cannot be read: it is a device or a pipe, not a file."
        assert refusal(save, OLD, path) == f"{path} cannot be saved: it is a device or a pipe, not a file."
    assert refusal(load, loop) == f"{loop} cannot be read: its symbolic links lead in a circle."
    assert refusal(save, OLD, loop) == f"{loop} cannot be saved: its symbolic links lead in a circle."
    below = pipe / "a.json"
    assert refusal(load, below) == f"{below} cannot be read: a part of its path is not a folder."
    long = tmp_path / ("n" * 300)
    assert refusal(save, OLD, long) == f"{long} cannot be saved: the name is too long."
    assert refusal(load, tmp_path / "two\nlines").count("\n") == 0
    assert "null" in refusal(load, tmp_path / "a\0b")


@posix
@not_root
def test_what_the_user_may_not_touch_is_told_apart(tmp_path):
    file = tmp_path / "file.json"
    save(OLD, file)
    file.chmod(0o444)
    assert refusal(save, NEW, file) == f"{file} cannot be saved: the file is read-only."
    file.chmod(0o000)
    assert refusal(load, file) == f"{file} cannot be read: permission is denied."
    tmp_path.chmod(0o555)
    assert "permission is denied" in refusal(save, NEW, tmp_path / "new.json")
    tmp_path.chmod(0o755)


def test_a_fault_in_the_content_names_the_file(tmp_path):
    path = tmp_path / "bad.json"
    path.write_bytes(encode(OLD).replace(b'"degree": 3', b'"degree": 5'))
    assert refusal(load, path) == f"{path}: curves[0].degree must be 2 or 3."
