"""The command line: open the window, or do without one what the first word says."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib import import_module
from typing import Final, NamedTuple

INTERRUPTED, CLOSED_PIPE = 130, 141  # 128 + SIGINT and + SIGPIPE, as a shell reports them


class Command(NamedTuple):
    """A command: the module that declares its arguments and runs it, how it is called, and what it does."""

    module: str
    usage: str
    about: str


COMMANDS: Final = {
    "check": Command("check", "FILE ...", "say what is in drawings, or what is wrong with them"),
    "export": Command("export", "FILE ... -o OUT", "write drawings as SVG, PDF, PNG, DXF, TikZ or CSV"),
    "import": Command("importing", "FILE -o OUT", "make a drawing of an SVG picture or a table of points"),
    "gallery": Command("gallery", "[NAME [-o OUT]]", "list the gallery, or take a drawing from it"),
    "schema": Command("schema", "", "print the JSON Schema of the file format"),
}

EXIT_CODES: Final = (
    "exit codes: 0 all is well; 1 a file is faulty, cannot be read or written, or a curve breaks a promise of the "
    "theory; 2 wrong usage; 130 interrupted; 141 whoever read the output has gone"
)


class UsageError(Exception):
    """The arguments do not go together; the message says why, in one sentence without a full stop."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command with these arguments, else those of the process, and return its exit code.

    Wrong usage ends with SystemExit. Qt is imported only to open the window and to draw PDF and PNG.
    """
    # NumPy's threads spin while they wait, a fifth of the processor's time of a start; no product here gains by them.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    arguments = list(sys.argv[1:] if argv is None else argv)
    for stream in (sys.stdout, sys.stderr):
        # A name in a drawing must not fail on a terminal that lacks its letters.
        if reconfigure := getattr(stream, "reconfigure", None):
            reconfigure(errors="backslashreplace")
    try:
        code = _run(arguments)
        if sys.stdout is not None:
            sys.stdout.flush()
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:  # the reader has gone, as in `theditor check … | head`
        _silence_output()
        return CLOSED_PIPE
    except OSError as error:  # files have their own error class
        _silence_output()
        return fail(f"the output cannot be written: {error.strerror}.")
    return code


def fail(sentence: object) -> int:
    """Say what went wrong, where it is not taken for output, and return the exit code."""
    print(f"theditor: {sentence}", file=sys.stderr)
    return 1


def _run(arguments: Sequence[str]) -> int:
    if not arguments:
        return _open_window([])
    import argparse  # a start without arguments needs no parser

    name = arguments[0]
    if name not in COMMANDS:
        return _open(arguments)
    command = import_module(f"theditor.cli.{COMMANDS[name].module}")
    from theditor.drawing import DrawingError

    usage = f"theditor {name} {COMMANDS[name].usage}".rstrip() + " [OPTION ...]"
    parser = argparse.ArgumentParser(prog=f"theditor {name}", usage=usage, epilog=f"{EXIT_CODES}.")
    command.declare(parser)
    try:
        return int(command.run(parser.parse_args(arguments[1:])))
    except UsageError as error:
        parser.error(str(error))
    except DrawingError as error:
        return fail(error)


def _open(arguments: Sequence[str]) -> int:
    import argparse

    lines = (f"  theditor {name + ' ' + each.usage:<25} {each.about}" for name, each in COMMANDS.items())
    parser = argparse.ArgumentParser(
        prog="theditor",
        usage="theditor [FILE ...]\n       theditor COMMAND ...",
        formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Draw and shape TH-type uniform B-splines; without a file the window shows an example.",
        epilog="\n".join(
            [
                "commands, which open no window (--help after one tells more):",
                *lines,
                "",
                "To them, - is standard input or output. A drawing called like a command opens as ./check.",
                EXIT_CODES.replace(": ", ":\n  ", 1).replace("; ", "\n  "),
            ]
        ),
    )
    parser.add_argument("files", metavar="FILE", nargs="*", help="drawings to open")
    parser.add_argument("--version", action="store_true", help="print the version")
    options = parser.parse_args(arguments)
    if options.version:
        from theditor.resources import version

        print(f"theditor {version()}")
        return 0
    if hint := _mistyped(arguments):
        parser.error(hint)
    return _open_window(options.files)


def _open_window(files: Sequence[str]) -> int:
    from theditor.cli.window import open_window

    return open_window(files)


def _mistyped(words: Sequence[str]) -> str:
    """Return what to say of a first word that looks like a command; nothing if it is a file or looks like one."""
    if not words or "." in words[0] or os.path.exists(words[0]):
        return ""
    from difflib import get_close_matches  # loaded when it is first asked for

    near = get_close_matches(words[0], COMMANDS, 1)
    return f"there is no command and no file {words[0]!a}: did you mean {near[0]}?" if near else ""


def _silence_output() -> None:
    """Keep the interpreter's last flush from failing as well."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
