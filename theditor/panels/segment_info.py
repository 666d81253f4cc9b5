"""The segment panel: what the selected segment is, in words and numbers."""

from __future__ import annotations

import math
from collections import Counter

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton, QWidget

from theditor.drawing import Item
from theditor.model import Document, Selection, words
from theditor.model.selection import shaping_points
from theditor.model.words import (
    counted,
    exact,
    indexed,
    listed,
    number,
    symbols,
)
from theditor.panels.parts import Paragraph, column, describe, heading
from theditor.spline import Curve, Missing, Mode, arc_length, bending_energy, missing, mode_of, recognise
from theditor.spline.numerals import position
from theditor.spline.wording import with_article

_HINT = "Select a segment on the curve or in the list."
_ACCURACY = 1e-7
"""Of length and bending energy, relative: a digit more than is shown."""


class SegmentPanel(QWidget):
    """Describes the selected segment, or sums up several; completes one that is nearly a known curve."""

    def __init__(self, document: Document, selection: Selection, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._selection = document, selection
        self._shown: tuple[Item | None, frozenset[int]] = (None, frozenset({-1}))
        self._missing: Missing | None = None
        self.heading = heading("Segment")
        self.text = Paragraph()
        self.text.setAccessibleName("Selected segment")
        self.suggestion = Paragraph()
        self.complete = QPushButton("Set it")
        self.complete.clicked.connect(self._complete)
        layout = column(self)
        layout.addWidget(self.heading)
        layout.addWidget(self.text)
        layout.addWidget(self.suggestion)
        layout.addWidget(self.complete, alignment=Qt.AlignmentFlag.AlignLeft)
        layout.addStretch(1)
        document.changed.connect(self._follow)
        selection.changed.connect(self._follow)
        self._follow()

    def _follow(self) -> None:
        item, segments = self._selection.item, self._selection.segments
        old_item, old_segments = self._shown
        if item is old_item and segments == old_segments:
            return
        self._shown = item, segments
        self._missing = None
        if item is None or not segments:
            self.heading.setText("Segment")
            self.text.setText(_HINT)
        elif len(segments) == 1:
            (segment,) = segments
            self.heading.setText(f"Segment {segment + item.curve.first_segment}")
            self.text.setText("\n".join(description(item.curve, segment)))
            self._missing = missing(item.curve, segment)
        else:
            self.heading.setText(f"{len(segments)} segments")
            self.text.setText("\n".join(summary(item.curve, segments)))
        self._suggest(item)

    def _suggest(self, item: Item | None) -> None:
        for widget in (self.suggestion, self.complete):
            widget.setVisible(self._missing is not None)
        if self._missing is not None and item is not None:
            self.suggestion.setText(f"{self._missing.text}.")
            name = f"Make it {with_article(self._missing.recognised.kind)}"
            describe(self.complete, name, words.locked_reason(item.name) if item.locked else name)
            self.complete.setEnabled(not item.locked)

    def _complete(self) -> None:
        """Set the λ that are missing, in one undo step."""
        item, segments = self._selection.item, self._selection.segments
        if self._missing is not None and item is not None:
            indices, values = zip(*self._missing.changes, strict=True)
            named = words.segments_named(item.curve, segments)
            step = f"Make {named} {with_article(self._missing.recognised.kind)}"
            self._document.apply_curve(step, self._selection.curve, item.curve.with_lambdas(indices, values))


def description(curve: Curve, segment: int) -> list[str]:
    """Lines about one segment: what it is, its equation or ends, what shapes it, its measures."""
    found = recognise(curve, segment)
    if found is not None:
        what = f"{found.description[:1].upper()}{found.description[1:]}."
        where = found.equation
    else:
        ends = curve([segment, segment + 1])
        rounding = 1e-12 * float(np.abs(ends).max())
        start, end = (position(point, rounding) for point in ends.tolist())
        what = f"{_in_words(curve, segment)}."
        where = f"From {start} to {end}"
    points = listed([indexed("P", i) for i in shaping_polygon(curve, segment)])
    return [what, where, f"{_lambdas(curve, segment)} · control points {points}", _measures(curve, segment)]


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
    if curve.mode_at(segment) is Mode.BLEND:
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
        return "No λ shapes it"
    values = curve.lambdas[indices].tolist()
    if len(set(values)) == 1:
        return f"{' = '.join(indexed('λ', i) for i in indices)} = {_named(values[0], curve.degree)}"
    return ", ".join(
        f"{indexed('λ', i)} = {_named(value, curve.degree)}" for i, value in zip(indices, values, strict=True)
    )


def _measures(curve: Curve, segment: int) -> str:
    """Length, bending energy ∫κ² ds, and how smoothly the segment joins its neighbours."""
    length = arc_length(curve, segment, segment + 1, _ACCURACY)
    bending = bending_energy(curve, segment, segment + 1, _ACCURACY)
    energy = number(bending) if math.isfinite(bending) else "∞"
    smooth = "C²" if curve.degree == 3 else "C¹"
    start = smooth if curve.closed or segment > 0 else "end"
    end = smooth if curve.closed or segment < curve.segment_count - 1 else "end"
    return f"Length {number(length)} · bending {energy} · joins {start} / {end}"


def _named(value: float, degree: int) -> str:
    if mode_of(value, value, degree) is Mode.INTERPOLATING:
        return f"λ* = {number(value)}"
    return exact(value).replace("-", "−") if len(exact(value)) < 8 else number(value)
