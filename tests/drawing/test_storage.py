import errno
import os
import stat
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import pytest

from theditor.drawing import Drawing, DrawingError, Item, encode, load, save, unreadable, write_atomically
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
    assert sentence == f"{path} cannot be saved: it would be larger than the system allows."
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
    assert (
        refusal(save, OLD, nowhere)
        == f"{nowhere} cannot be saved: there is no folder {tmp_path / 'nowhere'}."
    )
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
    assert refusal(load, path) == f"{path}: curves[0].degree (line 3, column 29) must be 2 or 3."


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"not mine", "The text is not JSON"),
        (encode(OLD).replace(b'"version": 1', b'"version": 2'), "version (line 1, column 35) is 2"),
        (encode(OLD)[:-5], "The text is not complete JSON"),
    ],
)
def test_what_is_no_readable_drawing_is_replaced_only_when_told_to(tmp_path, content, reason):
    path = tmp_path / "other.json"
    path.write_bytes(content)
    assert unreadable(path).startswith(reason)
    sentence = refusal(save, NEW, path)
    assert sentence.startswith(f"{path} is not replaced")
    assert reason in sentence
    assert path.read_bytes() == content
    save(NEW, path, overwrite=True)
    assert load(path) == NEW
    assert unreadable(path) is None


def test_an_empty_file_may_be_saved_to(tmp_path):
    (tmp_path / "empty.json").touch()
    save(NEW, tmp_path / "empty.json")
    assert load(tmp_path / "empty.json") == NEW


def test_other_files_are_written_in_the_same_way(tmp_path):
    path = tmp_path / "picture.svg"
    write_atomically(path, b"old")
    write_atomically(str(path), b"new")
    assert path.read_bytes() == b"new"
    assert refusal(write_atomically, tmp_path, b"") == f"{tmp_path} cannot be saved: it is a folder."
    assert list(tmp_path.iterdir()) == [path]


# One process that has loaded everything forks children, each of which saves until it is killed, at some moment
# within the time that two saves take.
KILLED_SAVES = """
import os, random, signal, sys, time
from pathlib import Path
from theditor.drawing import Drawing, Item, encode, write_atomically
from theditor.spline import Curve

path = Path(sys.argv[1])
contents = [encode(Drawing([Item(Curve([[i, i % 7] for i in range(n)]))])) for n in (3000, 4000)]
found = dict.fromkeys(contents, 0)
rng = random.Random(0)
times = []
for content in 5 * contents:
    start = time.perf_counter()
    write_atomically(path, content)
    times.append(time.perf_counter() - start)
for _ in range(300):
    listen, say = os.pipe()
    child = os.fork()
    if child == 0:
        others = [each for each in contents if each != path.read_bytes()]
        os.write(say, b"!")
        while True:
            for content in others + contents:
                write_atomically(path, content)
    os.read(listen, 1)
    time.sleep(rng.uniform(0, 2 * sorted(times)[5]))
    os.kill(child, signal.SIGKILL)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == -signal.SIGKILL
    os.close(listen)
    os.close(say)
    found[path.read_bytes()] += 1  # a KeyError would be a file in pieces
print(*found.values())
"""


@pytest.fixture
def quick_folder():
    """A folder in memory where there is one: no save waits for a disk there, so that kills fall into all it does."""
    memory = "/dev/shm"
    with tempfile.TemporaryDirectory(dir=memory if os.access(memory, os.W_OK) else None) as folder:
        yield Path(folder)


@posix
def test_a_save_killed_at_any_moment_leaves_a_whole_file_and_its_remains_are_removed_later(quick_folder):
    path = quick_folder / "drawing.json"
    command = [sys.executable, "-c", KILLED_SAVES, path]
    run = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert run.returncode == 0, run.stderr
    assert min(map(int, run.stdout.split())) > 10  # both contents were met, so the kills fell among saves
    remains = [each for each in quick_folder.iterdir() if each != path]
    assert remains
    fresh, *old = remains
    for each in old:
        os.utime(each, (0, time.time() - 7200))
    save(NEW, path)
    assert set(quick_folder.iterdir()) == {path, fresh}
