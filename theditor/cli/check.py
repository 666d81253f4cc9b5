"""``theditor check``: say what is in drawings and how smoothly their segments meet, or what is wrong."""

from __future__ import annotations

import argparse
import json
from collections import Counter
from collections.abc import Iterator
from itertools import groupby, islice
from typing import Any

from theditor.cli import streams
from theditor.drawing import DrawingError, Item
from theditor.spline import (
    Curve,
    Mode,
    continuity,
    missing,
    negative_basis,
    recognise_segments,
    reversed_joints,
)
from theditor.spline.certificate import remarkable, summary, table
from theditor.spline.numerals import counted

_MOST_LINES = 20  # about the parts of one curve; of longer ones they are counted


def declare(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments."""
    parser.description = (
        "Say what is in each drawing and how smoothly its segments meet, or what is wrong with it."
    )
    parser.add_argument("files", metavar="FILE", nargs="+", help="drawings to read, or - for standard input")
    parser.add_argument(
        "--json", action="store_true", help="answer in JSON: a list with an object for each file, as UTF-8"
    )


def run(options: argparse.Namespace) -> int:
    """Check each file and return 1 if one is faulty or breaks a promise."""
    code, answers = 0, []
    for name in options.files:
        file, fault, curves = streams.label(name), "", []
        try:
            curves = [Measured(item) for item in streams.read_drawing(name)]
        except DrawingError as error:
            fault = str(error)
        if fault or not all(each.continuity.holds.all() for each in curves):
            code = 1
        if options.json:
            known = {"error": fault} if fault else {"curves": [facts(each) for each in curves]}
            answers.append({"file": file, **known})
        else:
            print(fault or f"{file}: {counted(len(curves), 'curve')}")
            for line in (line for each in curves for line in _lines(each)):
                print(f"  {line}")
    if options.json:
        text = json.dumps(answers, ensure_ascii=False, allow_nan=False)
        streams.write(streams.STANDARD, f"{text}\n".encode())
    return code


class Measured:
    """A curve of a drawing and what is measured on it."""

    def __init__(self, item: Item) -> None:
        self.item, self.curve = item, item.curve
        self.recognised = recognise_segments(item.curve)
        self.guards = negative_basis(item.curve)
        self.continuity = continuity(item.curve)


def facts(measured: Measured) -> dict[str, Any]:
    """Return what is known of a curve as plain data for JSON, every segment and every joint included."""
    curve, report = measured.curve, measured.continuity
    return {
        "name": measured.item.name,
        "degree": curve.degree,
        "closed": curve.closed,
        "ends": curve.ends,
        "dimension": curve.dimension,
        "points": len(curve.control_points),
        "segments": [
            {
                "number": place + curve.first_segment,
                "mode": mode.value,
                "name": found.name if found else None,
                "description": found.description if found else None,
                "equation": found.equation if found else None,
                "negative_basis": measured.guards.reason(place) or None,
            }
            for place, (mode, found) in enumerate(zip(curve.modes, measured.recognised, strict=True))
        ],
        "joints": [
            {
                "number": joint.number,
                "position": list(joint.position),
                "relative_jumps": list(joint.relative_jumps),
                "order": joint.order,
                "geometric_order": joint.geometric_order,
                "promised": joint.promised,
                "holds": bool(joint.holds),
                "remark": joint.note or None,
            }
            for joint in report
        ],
        "holds": bool(report.holds.all()),
    }


def _lines(measured: Measured) -> Iterator[str]:
    """Yield what is known of a curve as text."""
    yield _described(measured.item)
    for line in _segments(measured):
        yield f"  {line}"
    for line in _certificate(measured):
        yield f"  {line}"


def _segments(measured: Measured) -> list[str]:
    """Name each segment that is a known curve or nearly one, or has a negative basis function.

    Of a long curve, count the names and the negative ones.
    """
    curve, found, guards = measured.curve, measured.recognised, measured.guards
    if len(found) > _MOST_LINES:
        counts = Counter(each.name for each in found if each is not None)
        lines = [", ".join(f"{count} × {name}" for name, count in counts.items())] if counts else []
        if negative := len(set(guards.segments.tolist())):
            where = counted(negative, "segment")
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


def _certificate(measured: Measured) -> Iterator[str]:
    """Yield how smoothly segments meet, of a long curve only where there is a remark."""
    curve, report = measured.curve, measured.continuity
    if 0 < len(report) <= _MOST_LINES:
        yield from table(report)
    remarks = remarkable(report)
    for joint in islice(remarks, _MOST_LINES):
        yield str(joint)
    if more := sum(1 for _ in remarks):
        yield f"… and {counted(more, 'joint')} more with a remark"
    for end in reversed_joints(curve):
        if not curve.closed and end.joint in curve.domain:
            yield f"{end.reason}."
    yield summary(report)


def _described(item: Item) -> str:
    curve = item.curve
    parts = [
        "quadratic" if curve.degree == 2 else "cubic",
        "closed" if curve.closed else f"open with {curve.ends} ends",
        *(["in space"] if curve.dimension == 3 else []),
        counted(len(curve.control_points), "point"),
        counted(curve.segment_count, "segment"),
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
