"""How curves, segments and shape parameters are called in the window. No Qt here."""

from __future__ import annotations

import math
from bisect import bisect
from collections.abc import Iterable, Mapping, Sequence, Sized

import numpy as np

from theditor.spline import Curve, Mode
from theditor.spline.numerals import counted as counted
from theditor.spline.numerals import indexed as indexed
from theditor.spline.numerals import number as number

MODE_LETTERS = {Mode.TRIGONOMETRIC: "T", Mode.HYPERBOLIC: "H", Mode.INTERPOLATING: "λ*"}
"""The modes that can be set, with the letter that stands for each."""

_ENUMERATED = 4


def sentence(problem: str) -> str:
    """Return what an error says as a sentence, with a capital and a full stop; nothing stays nothing."""
    return problem and problem[0].upper() + problem[1:].removesuffix(".") + "."


def exact(value: float) -> str:
    """Return the shortest text that reads back as exactly `value`, without a needless ``.0``."""
    return repr(float(value)).removesuffix(".0")


def listed(names: Sequence[str]) -> str:
    """Join names in a sentence: ``4, 5 and 6``."""
    return names[0] if len(names) == 1 else ", ".join(names[:-1]) + " and " + names[-1]


def points_counted(points: Mapping[int, Sized], state: str = "") -> str:
    """Count control points by their curve, as an edit's object or, with a state, as a sentence.

    ``control point``, ``5 control points on 2 curves``; ``1 control point selected``.
    """
    count = sum(map(len, points.values()))
    told = "control point" if count == 1 and not state else counted(count, "control point")
    told += f" {state}" if state else ""
    return told if len(points) < 2 else f"{told} on {len(points)} curves"


def symbols(symbol: str, indices: Sequence[int]) -> str:
    """Name symbols by their indices, ascending: ``λ₅, λ₆``, or ``λ₀ … λ₃, λ₉`` when there are many.

    Where that would be long, too, just the first and the last: ``λ₀ … λ₉₉``.
    """
    if len(indices) <= _ENUMERATED:
        return ", ".join(indexed(symbol, i) for i in indices)
    names: list[str] = []
    begin = 0
    while begin < len(indices) and len(names) < _ENUMERATED:
        end = _end_of_run(indices, begin)
        run = indices[begin:end] if end - begin < 3 else (indices[begin],)
        names += [indexed(symbol, i) for i in run]
        if end - begin > len(run):
            names[-1] += f" … {indexed(symbol, indices[end - 1])}"
        begin = end
    if begin < len(indices):
        names = [f"{indexed(symbol, indices[0])} … {indexed(symbol, indices[-1])}"]
    return ", ".join(names)


def _end_of_run(indices: Sequence[int], begin: int) -> int:
    """Where in ascending indices the run of successive ones ends that begins there."""
    first = indices[begin] - begin
    return bisect(range(len(indices)), first, begin, key=lambda k: indices[k] - k)


def segments_named(curve: Curve, segments: Iterable[int]) -> str:
    """Name segments by the paper's numbers: ``segments 4 and 6``, or ``12 segments`` when they are many."""
    ordered = sorted(segments)
    if len(ordered) > _ENUMERATED:
        return counted(len(ordered), "segment")
    numbers = [str(s + curve.first_segment) for s in ordered]
    return f"segment {numbers[0]}" if len(numbers) == 1 else f"segments {listed(numbers)}"


def shape_changed(deviation: float, *curves: Curve) -> str:
    """Say how far the shape of curves is from what it was."""
    size = max(float(np.ptp(curve.control_points, axis=0).max()) for curve in curves)
    if deviation <= 1e-9 * size:
        return "the shape is the same"
    return f"the shape changed by at most {number(_rounded_up(deviation))}"


def _rounded_up(value: float) -> float:
    """Two significant digits, never less than the value."""
    unit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return math.ceil(value / unit - 1e-9) * unit


def locked_reason(name: str) -> str:
    """Say why nothing can be changed, and the cure."""
    return f"“{name}” is locked: unlock it in the list of curves to change it."


def inactive_reason(curve: Curve, indices: Sequence[int]) -> str:
    """Say why the λ of `indices`, none of which is active, shape nothing."""
    if not curve.active_lambdas.any():
        return "No λ shapes this curve: it is one straight segment."
    names = symbols("λ", indices) + (" shapes nothing" if len(indices) == 1 else " shape nothing")
    if curve.degree == 2:
        return f"{names}: in an open quadratic λᵢ belongs to the edge from Pᵢ₋₁ to Pᵢ."
    if curve.ends == "clamped":
        return f"{names}: at a clamped end the curvature is zero."
    return f"{names}: the curve is open with free ends."
