"""The segment panel: what the selected segment is, in words and numbers."""

from __future__ import annotations

from collections import Counter

import numpy as np
from numpy.typing import NDArray
from PySide6.QtWidgets import QWidget

from theditor.model import Document, Selection
from theditor.model.selection import shaping_points
from theditor.model.words import (
    counted,
    exact,
    indexed,
    listed,
    number,
    symbols,
)
from theditor.panels.parts import Paragraph, column, heading
from theditor.spline import Curve, Mode, mode_of

_SPANS = {
    (Mode.TRIGONOMETRIC, 2): "1, cos(πt/2), sin(πt/2)",
    (Mode.TRIGONOMETRIC, 3): "1, t, cos(πt/2), sin(πt/2)",
    (Mode.HYPERBOLIC, 2): "1, cosh t, sinh t",
    (Mode.HYPERBOLIC, 3): "1, t, cosh t, sinh t",
}
_HINT = "Select a segment on the curve or in the list."


class SegmentPanel(QWidget):
    """Describes the selected segment, or sums up several."""

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._selection = selection
        self._shown: tuple[Curve | None, frozenset[int]] = (None, frozenset({-1}))
        self.heading = heading("Segment")
        self.text = Paragraph()
        self.text.setAccessibleName("Selected segment")
        layout = column(self)
        layout.addWidget(self.heading)
        layout.addWidget(self.text)
        layout.addStretch(1)
        document.changed.connect(self._follow)
        selection.changed.connect(self._follow)
        self._follow()

    def _follow(self) -> None:
        item, segments = self._selection.item, self._selection.segments
        curve = item.curve if item is not None else None
        old_curve, old_segments = self._shown
        if curve is old_curve and segments == old_segments:
            return
        self._shown = curve, segments
        if curve is None or not segments:
            self.heading.setText("Segment")
            self.text.setText(_HINT)
        elif len(segments) == 1:
            (segment,) = segments
            self.heading.setText(f"Segment {segment + curve.first_segment}")
            self.text.setText("\n".join(description(curve, segment)))
        else:
            self.heading.setText(f"{len(segments)} segments")
            self.text.setText("\n".join(summary(curve, segments)))


def description(curve: Curve, segment: int) -> list[str]:
    """Lines about one segment: mode, parameters, points, ends."""
    mode = curve.modes[segment]
    spans = _SPANS.get((mode, curve.degree))
    first = f"{mode.value.capitalize()}, spans {spans}." if spans else f"{_in_words(curve, segment)}."
    points = shaping_polygon(curve, segment)
    start, end = (curve.joints[j % len(curve.joints)] for j in (segment, segment + 1))
    return [
        first,
        _lambdas(curve, segment),
        f"Control points {listed([indexed('P', i) for i in points])}",
        f"From {_coordinates(start)} to {_coordinates(end)}",
    ]


def summary(curve: Curve, segments: frozenset[int]) -> list[str]:
    """Lines about several segments: how many of each mode, and what shapes them."""
    codes = curve.mode_codes[sorted(segments)]
    counts = Counter(codes.tolist())
    modes = [f"{counts[code]} {mode.value}" for code, mode in enumerate(Mode) if counts[code]]
    shaping = shaping_points(curve, segments).tolist()
    lines = [f"{listed(modes).capitalize()}."]
    if shaping:
        values = curve.lambdas[shaping]
        spread = (
            "all equal" if np.ptp(values) == 0 else f"from {number(values.min())} to {number(values.max())}"
        )
        lines.append(f"{symbols('λ', shaping)}: {spread}")
        lines[-1] += f" ({counted(len(shaping), 'parameter')})"
    return lines


def shaping_polygon(curve: Curve, segment: int) -> list[int]:
    """Control points that shape a segment, ascending along the curve."""
    first = segment + curve.first_segment - 1
    window = range(first, first + curve.degree + 1)
    count = len(curve.control_points)
    if curve.closed:
        return list(dict.fromkeys(i % count for i in window))
    return [i for i in window if 0 <= i < count]


def _in_words(curve: Curve, segment: int) -> str:
    if curve.modes[segment] is Mode.BLEND:
        return "A blend of trigonometric and hyperbolic"
    points = shaping_polygon(curve, segment)
    if curve.degree == 2:
        return f"Interpolating, meets {indexed('P', points[1])} at t = ½"
    middle = {i % len(curve.control_points) for i in _joint_points(curve, segment)}
    return f"Interpolating, meets {listed([indexed('P', i) for i in sorted(middle)])} at its ends"


def _joint_points(curve: Curve, segment: int) -> tuple[int, int]:
    first = segment + curve.first_segment
    return first, first + 1


def _lambdas(curve: Curve, segment: int) -> str:
    indices = [i for i in curve.lambda_indices(segment) if i is not None]
    if not indices:
        return "No λ shapes it: it is straight."
    values = curve.lambdas[indices].tolist()
    if len(set(values)) == 1:
        return f"{' = '.join(indexed('λ', i) for i in indices)} = {_named(values[0], curve.degree)}"
    return ", ".join(
        f"{indexed('λ', i)} = {_named(value, curve.degree)}" for i, value in zip(indices, values, strict=True)
    )


def _named(value: float, degree: int) -> str:
    if mode_of(value, value, degree) is Mode.INTERPOLATING:
        return f"λ* = {number(value)}"
    return exact(value).replace("-", "−") if len(exact(value)) < 8 else number(value)


def _coordinates(point: NDArray[np.float64]) -> str:
    return f"({', '.join(number(coordinate) for coordinate in point.tolist())})"
