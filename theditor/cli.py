"""The command line: open the window, or say what is in a file without any window."""

from __future__ import annotations

import argparse
import os
import sys
from collections import Counter
from collections.abc import Sequence
from itertools import groupby, islice
from pathlib import Path

from theditor.drawing import DrawingError, Item, load, shown
from theditor.resources import version
from theditor.spline import (
    Curve,
    Mode,
    continuity,
    missing,
    negative_basis,
    recognise_segments,
    reversed_joints,
)
from theditor.spline.certificate import joints, remarkable, summary, table

_DEBIAN_PACKAGES = (
    "libgl1 libegl1 libxkbcommon0 libdbus-1-3 libfontconfig1 libglib2.0-0 fonts-dejavu-core "
    "libxkbcommon-x11-0 libx11-xcb1 libxcb-cursor0 libxcb-icccm4 libxcb-image0 libxcb-keysyms1 libxcb-randr0 "
    "libxcb-render-util0 libxcb-shape0 libxcb-shm0 libxcb-sync1 libxcb-xfixes0 libxcb-xkb1"
)
_CLOSED_PIPE = 141  # 128 + SIGPIPE, as a shell reports it
_MOST_LINES = 20  # about the parts of one curve; of longer ones they are counted


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command with these arguments, else those of the process, and return its exit code.

    0: done; 1: a file is not a drawing, a curve breaks a promise of the theory, or no window can be opened;
    2 (as SystemExit): wrong usage. Qt is imported only to open the window.
    """
    arguments = list(sys.argv[1:] if argv is None else argv)
    for stream in (sys.stdout, sys.stderr):
        # A name in a drawing must not fail on a terminal that lacks its letters.
        if reconfigure := getattr(stream, "reconfigure", None):
            reconfigure(errors="backslashreplace")
    try:
        code = _check(arguments[1:]) if arguments[:1] == ["check"] else _open(arguments)
        sys.stdout.flush()
    except BrokenPipeError:
        # The reader has gone, as in `theditor check … | head`; keep the interpreter's last flush silent too.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return _CLOSED_PIPE
    return code


def _open(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="theditor",
        usage="theditor [FILE ...]\n       theditor check FILE ...",
        description="Draw and shape TH-type uniform B-splines; without a file the window shows an example.",
        epilog='"theditor check" says what is in files without opening a window; '
        "a file of that name opens as ./check.",
    )
    parser.add_argument("files", metavar="FILE", nargs="*", type=Path, help="drawings to open")
    parser.add_argument("--version", action="version", version=f"theditor {version()}")
    files = parser.parse_args(arguments).files
    if sys.platform == "linux" and not any(
        os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")
    ):
        return _fail(
            "there is no display to open a window on: start it from a desktop session, "
            "or set DISPLAY to one (QT_QPA_PLATFORM=offscreen runs it unseen)."
        )
    try:
        from theditor.app.main import run
    except ImportError as error:
        library, _, reason = str(error).partition(": ")
        if "shared object" not in reason:
            raise
        return _fail(
            f"the system library {library} is missing: on Debian or Ubuntu, "
            f"sudo apt-get install -y {_DEBIAN_PACKAGES}"
        )
    return run(files)


def _fail(sentence: str) -> int:
    print(f"theditor: {sentence}", file=sys.stderr)
    return 1


def _check(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="theditor check",
        description="Say what is in each drawing and how smoothly its segments meet, or what is wrong with it.",
        epilog="The exit code is 0 if every file is a drawing whose joints are as smooth as the theory promises, "
        "else 1.",
    )
    parser.add_argument("files", metavar="FILE", nargs="+", type=Path, help="drawings to read")
    code = 0
    for path in parser.parse_args(arguments).files:
        try:
            drawing = load(path)
        except DrawingError as error:
            print(error)
            code = 1
        else:
            print(f"{shown(path)}: {_count(len(drawing), 'curve')}")
            for item in drawing:
                print(f"  {_described(item)}")
                for line in _segments(item.curve):
                    print(f"    {line}")
                code |= _certify(item.curve)
    return code


def _segments(curve: Curve) -> list[str]:
    """Name each segment that is a known curve or nearly one, or has a negative basis function.

    Of a long curve, count the names and the negative ones.
    """
    found, guards = recognise_segments(curve), negative_basis(curve)
    if len(found) > _MOST_LINES:
        counts = Counter(each.name for each in found if each is not None)
        lines = [", ".join(f"{count} × {name}" for name, count in counts.items())] if counts else []
        if negative := len(set(guards.segments.tolist())):
            where = _count(negative, "segment")
            lines.append(f"{where} with a negative basis function: there the convex hull is no bound")
        return lines
    lines = []
    for segment, each in enumerate(found):
        name = f"Segment {segment + curve.first_segment}"
        if each is not None:
            lines.append(f"{name}: {each.description}; {each.equation}")
        elif hint := missing(curve, segment):
            lines.append(f"{name}: {hint.text}")
        if reason := guards.reason(segment):
            lines.append(f"{name}: {reason}")
    return lines


def _certify(curve: Curve) -> int:
    """Print how smoothly segments meet, of a long curve only where there is a remark; return 1 if a promise fails."""
    report = continuity(curve)
    if 0 < len(report) <= _MOST_LINES:
        for line in table(report):
            print(f"    {line}")
    remarks = remarkable(report)
    for joint in islice(remarks, _MOST_LINES):
        print(f"    {joint}")
    if more := sum(1 for _ in remarks):
        print(f"    … and {joints(more)} more with a remark")
    for end in reversed_joints(curve):
        if not curve.closed and end.joint in curve.domain:
            print(f"    {end.reason}.")
    print(f"    {summary(report)}")
    return int(not report.holds.all())


def _described(item: Item) -> str:
    curve = item.curve
    parts = [
        "quadratic" if curve.degree == 2 else "cubic",
        "closed" if curve.closed else f"open with {curve.ends} ends",
        *(["in space"] if curve.dimension == 3 else []),
        _count(len(curve.control_points), "point"),
        _count(curve.segment_count, "segment"),
    ]
    return f"{item.name}: {', '.join(parts)}; {_modes(curve)}"


def _modes(curve: Curve) -> str:
    """Tell the modes in order along the curve, or only how many there are of each if that would be long."""
    runs: list[tuple[Mode, list[int]]] = [
        (mode, [number for number, _ in run])
        for mode, run in groupby(enumerate(curve.modes, curve.first_segment), key=lambda pair: pair[1])
    ]
    if len(runs) > _MOST_LINES:
        counts = ((curve.modes.count(mode), mode.value) for mode in Mode)
        return ", ".join(f"{count} {mode}" for count, mode in counts if count)
    if len(runs) == 1:
        return f"all {runs[0][0].value}" if curve.segment_count > 1 else runs[0][0].value
    spans = (
        (str(numbers[0]) if len(numbers) == 1 else f"{numbers[0]}–{numbers[-1]}", mode.value)
        for mode, numbers in runs
    )
    return "segments " + ", ".join(f"{span} {mode}" for span, mode in spans)


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
