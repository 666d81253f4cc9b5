import os
import signal
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

from theditor.cli import COMMANDS, main
from theditor.drawing import Drawing, Item, load, save
from theditor.exchange import readable, writable, write
from theditor.resources import gallery, resource
from theditor.spline import Curve

FIGURE_10 = resource("gallery") / "figure-10.json"
posix = pytest.mark.skipif(sys.platform == "win32", reason="POSIX pipes")

SCREENLESS = {
    name: value
    for name, value in os.environ.items()
    if name not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")
}


def theditor(*arguments, **options):
    command = [sys.executable, "-m", "theditor", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", timeout=60, **options)


def used_qt(*arguments):
    """The Qt modules, pyqtgraph included, that a command loads in a fresh process."""
    code = (
        "import sys; from theditor.cli import main; code = main(sys.argv[1:]); "
        "print(code, *(m for m in sys.modules if m.startswith(('PySide6', 'pyqtgraph'))), file=sys.stderr)"
    )
    command = [sys.executable, "-c", code, *map(str, arguments)]
    drawing = FIGURE_10.read_text("utf-8")
    run = subprocess.run(
        command, capture_output=True, text=True, encoding="utf-8", timeout=60, input=drawing, env=SCREENLESS
    )
    code, *modules = run.stderr.splitlines()[-1].split()
    assert code == "0", run.stderr
    return set(modules)


@pytest.mark.parametrize("command", ["check -", "check --json -", "gallery catenary", "schema"])
def test_commands_run_without_qt(command):
    assert used_qt(*command.split()) == set()


@pytest.mark.parametrize("suffix", writable())
def test_exports_run_without_qt_but_for_pictures_painted_by_it(suffix, tmp_path):
    used = used_qt("export", "-", "-o", tmp_path / f"out{suffix}")
    if suffix in (".pdf", ".png"):
        assert "PySide6.QtGui" in used
        assert used.isdisjoint({"PySide6.QtWidgets", "pyqtgraph"})
    else:
        assert used == set()
    assert (tmp_path / f"out{suffix}").stat().st_size > 0


@pytest.mark.parametrize(
    "arguments",
    [
        ["--no-such-option"],
        ["check"],
        ["export", "a.json"],
        ["import", "a.svg"],
        ["gallery", "-o", "a.json"],
        ["gallery", "catenary", "-o", "a.svg"],
        ["schema", "more"],
    ],
)
def test_wrong_usage_ends_with_2_and_the_usage(capsys, arguments):
    with pytest.raises(SystemExit) as caught:
        main(arguments)
    assert caught.value.code == 2
    assert capsys.readouterr().err.startswith("usage: theditor")


@pytest.mark.parametrize("suffix", readable())
def test_imports_run_without_qt(suffix, tmp_path):
    (tmp_path / f"in{suffix}").write_bytes(write(load(FIGURE_10), suffix).data)
    assert used_qt("import", tmp_path / f"in{suffix}", "-o", tmp_path / "out.json") == set()
    assert len(load(tmp_path / "out.json")) == 1


def test_a_mistyped_command_is_told_instead_of_opened(capsys):
    with pytest.raises(SystemExit) as caught:
        main(["exprot", "a.json", "b.svg"])
    assert caught.value.code == 2
    last = capsys.readouterr().err.splitlines()[-1]
    assert last == "theditor: error: there is no command and no file 'exprot': did you mean export?"


def test_version_and_help():
    assert theditor("--version").stdout.split()[0] == "theditor"
    help_text = theditor("--help").stdout
    assert "theditor [FILE ...]" in help_text
    for name, command in COMMANDS.items():
        assert f"theditor {name} {command.usage}".rstrip() in help_text
    assert "exit codes" in help_text


@pytest.mark.parametrize(
    ("arguments", "files"),
    [
        ([], []),
        (["a.json", "b.json"], ["a.json", "b.json"]),
        (["./check"], ["check"]),
        (["--", "check"], ["check"]),
    ],
)
def test_files_are_opened_in_the_window_even_one_called_check(monkeypatch, arguments, files):
    opened = []
    window = ModuleType("theditor.app.main")
    window.run = lambda paths: opened.append(paths) or 0
    monkeypatch.setitem(sys.modules, "theditor.app.main", window)
    assert main(arguments) == 0
    assert opened == [[Path(file) for file in files]]


def test_a_missing_system_library_is_named_with_the_command_that_installs_it(monkeypatch, capsys):
    class Lacking:
        @staticmethod
        def find_spec(name, *_):
            if name == "theditor.app.main":
                raise ImportError("libEGL.so.1: cannot open shared object file: No such file or directory")

    monkeypatch.setattr(sys, "meta_path", [Lacking, *sys.meta_path])
    monkeypatch.delitem(sys.modules, "theditor.app.main", raising=False)
    assert main([]) == 1
    error = capsys.readouterr().err
    assert error.startswith("theditor: the system library libEGL.so.1 is missing")
    assert "sudo apt-get install -y libgl1 libegl1" in error
    assert error.count("\n") == 1


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere there is always a display")
def test_without_a_display_one_sentence_says_so():
    run = theditor(env=SCREENLESS)
    assert run.returncode == 1
    assert run.stdout == ""
    assert run.stderr.startswith("theditor: there is no display")
    assert run.stderr.count("\n") == 1


@posix
def test_a_reader_that_has_gone_is_no_error_to_speak_of():
    command = [sys.executable, "-m", "theditor", "check", FIGURE_10]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        process.stdout.close()
        assert process.stderr.read() == b""
    assert process.returncode == 141


def test_a_terminal_without_the_letters_of_a_name_gets_escapes(tmp_path):
    path = tmp_path / "name.json"
    save(Drawing([Item(Curve([[0, 0], [1, 1]], ends="clamped"), "λ₃")]), path)
    run = theditor("check", path, env={**os.environ, "PYTHONIOENCODING": "ascii"})
    assert run.returncode == 0
    assert "\\u03bb\\u2083: cubic" in run.stdout


@posix
@pytest.mark.parametrize("stream", ["/dev/full", None])
def test_output_that_cannot_be_written_is_told(stream):
    """On a full disk in a sentence; a closed output is nobody's loss, and the exit code answers still."""
    command = [sys.executable, "-m", "theditor", "check", str(FIGURE_10)]
    if stream is None:
        shell = ["sh", "-c", 'exec "$@" >&-', "sh", *command]
        run = subprocess.run(shell, stderr=subprocess.PIPE, timeout=60)
        assert (run.returncode, run.stderr) == (0, b"")
        return
    with open(stream, "wb") as full:
        run = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, timeout=60)
    assert run.returncode == 1
    assert run.stderr == b"theditor: the output cannot be written: No space left on device.\n"


@pytest.fixture
def interruptible():
    """Started in the background, a shell's commands ignore interrupts, and so would theirs."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@posix
@pytest.mark.usefixtures("interruptible")
def test_an_interrupted_command_ends_with_130_and_says_nothing():
    """The interrupt comes while standard input is waited for."""
    command = [sys.executable, "-m", "theditor", "check", FIGURE_10, "-"]
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    with subprocess.Popen(command, env={**os.environ, "PYTHONUNBUFFERED": "1"}, **pipes) as process:
        process.stdout.readline()  # the first file is done
        process.send_signal(signal.SIGINT)
        assert process.stderr.read() == b""
        process.stdin.close()
    assert process.returncode == 130


def test_drawings_come_from_standard_input_and_go_to_standard_output():
    taken = theditor("gallery", "figure-10").stdout
    assert taken.encode() == FIGURE_10.read_bytes()
    checked = theditor("check", "-", input=taken)
    assert checked.returncode == 0
    assert checked.stdout.startswith("standard input: 1 curve\n")
    broken = theditor("check", "-", input=taken[:-5])
    assert broken.returncode == 1
    assert broken.stdout.startswith("standard input: The text is not complete JSON")


def test_the_gallery_is_listed_and_taken_from(capsys, tmp_path):
    assert main(["gallery"]) == 0
    out = capsys.readouterr().out
    assert all(any(line.startswith(f"{p.name} ") for line in out.splitlines()) for p in gallery())
    path = tmp_path / "mine.json"
    assert main(["gallery", "helix", "-o", str(path)]) == 0
    assert load(path) == load(resource("gallery") / "helix.json")
    path.write_text("my notes")
    assert main(["gallery", "helix", "-o", str(path)]) == 1
    assert path.read_text() == "my notes"
    assert capsys.readouterr().err.startswith(f"theditor: {path} is not replaced")
    assert main(["gallery", "helix", "-o", str(path), "--overwrite"]) == 0
    with pytest.raises(SystemExit) as caught:
        main(["gallery", "helics"])
    assert caught.value.code == 2
    assert "did you mean helix?" in capsys.readouterr().err


def test_the_schema_is_printed(capsysbinary):
    assert main(["schema"]) == 0
    assert capsysbinary.readouterr().out == resource("theditor.schema.json").read_bytes()
