"""What the formats are asked for, and what they answer."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final, Literal, TypeVar

from theditor.drawing import Drawing, DrawingError

Progress = Callable[[float], None]
"""Told the share of the work that is done, 0 to 1; what it raises ends the work."""
T = TypeVar("T")

PARTS: Final = ("polygon", "points", "labels", "comb")
"""What a picture can show besides the curves."""

PAGE: Final = 120.0
"""Longer side of PDF and TikZ pictures in mm, unless one is asked for."""
PIXELS: Final = 1600.0
"""The same of PNG, in pixels."""
MOST_PIXELS: Final = 15_000
"""Longer side of the largest PNG."""
_MOST_SAMPLES: Final = 100_000


@dataclass(frozen=True, slots=True)
class Options:
    """How to write or read a foreign format. Every format takes what concerns it and ignores the rest.

    Parameters
    ----------
    tolerance
        Largest deviation where a format or a fit cannot be exact, as a share of the drawing's size: the
        longer side of the box around its curves.
    size
        Longer side of the picture, in pixels for PNG and in millimetres for SVG, PDF and TikZ. By default PNG
        has 1600 pixels, PDF and TikZ are 120 mm long, and SVG has 1 mm for each unit of the drawing.
    scale
        Millimetres for each unit of the drawing; given instead of a size, which then follows.
    dpi
        Pixels per inch of a PNG. Lines and letters keep their physical size, so that more make them wider.
    transparent
        Whether the ground of a PNG is transparent instead of white; the other pictures have none.
    show
        What a picture shows besides the curves: any of `PARTS`.
    print_style
        Whether a picture is drawn as in a paper: black, with polygon, points and labels, and every mode of
        segments with dashes of its own: trigonometric ones whole, hyperbolic ones dashed, interpolating ones
        dash-dotted, blends dotted.
    sampling
        Where a CSV takes its points: at equal steps of the parameter, at equal arc lengths, or so densely that
        chords are within the tolerance.
    samples
        Steps of a CSV: for each segment if by parameter, for each curve if by length.
    tangent, curvature
        Whether a CSV has columns for the unit tangent, or the curvature.
    degree
        Degree of the curves that are fitted to what is read, 2 or 3.
    control_points
        Whether the rows of a CSV that is read are the control points, instead of points to pass through.

    Raises
    ------
    DrawingError
        If a value is none of those above; the message is one sentence.
    """

    tolerance: float = 1e-4
    size: float | None = None
    scale: float | None = None
    dpi: float = 96.0
    transparent: bool = False
    show: frozenset[str] = frozenset()
    print_style: bool = False
    sampling: Literal["parameter", "length", "tolerance"] = "parameter"
    samples: int = 16
    tangent: bool = False
    curvature: bool = False
    degree: Literal[2, 3] = 3
    control_points: bool = False

    def __post_init__(self) -> None:
        _check_number("tolerance", self.tolerance, 1e-12, 0.1)
        if self.size is not None:
            _check_number("size", self.size, 1, 1e6)
        if self.scale is not None:
            _check_number("scale", self.scale, 1e-18, 1e18)
            if self.size is not None:
                raise DrawingError("A picture has a size or a scale of its own: give one of them, not both.")
        _check_number("dpi", self.dpi, 1, 10_000)
        object.__setattr__(self, "show", frozenset(self.show))
        if unknown := sorted(map(str, self.show - set(PARTS))):
            raise DrawingError(f"A picture cannot show {unknown[0]!a}: choose from {', '.join(PARTS)}.")
        if self.sampling not in ("parameter", "length", "tolerance"):
            raise DrawingError(
                f"A curve cannot be sampled by {self.sampling!a}: choose parameter, length or tolerance."
            )
        if self.samples != int(self.samples) or not 1 <= self.samples <= _MOST_SAMPLES:
            raise DrawingError(
                f"The number of samples must be a whole one from 1 to {_MOST_SAMPLES}, not {self.samples!r}."
            )
        if self.degree not in (2, 3):
            raise DrawingError(f"The degree must be 2 or 3, not {self.degree!r}.")


def _check_number(name: str, value: float, least: float, most: float) -> None:
    if not (math.isfinite(value) and least <= value <= most):
        raise DrawingError(f"The {name} must be a number from {least:g} to {most:g}, not {value!r}.")


DEFAULTS: Final = Options()


@dataclass(frozen=True, slots=True)
class Written:
    """The bytes of a file, and how far what they show is from the drawing."""

    data: bytes
    deviation: float = 0.0
    """Largest distance from the true curves, measured, in units of the drawing; 0 where all is exact."""
    notes: tuple[str, ...] = ()
    """What to tell the user, a sentence each: the scale, curves left out, space curves seen from above."""


@dataclass(frozen=True, slots=True)
class Imported:
    """The drawing in a file, and how far it is from what the file shows."""

    drawing: Drawing
    deviation: float = 0.0
    """Largest distance from the file's own curves, measured, in units of the drawing; 0 where all is exact."""
    notes: tuple[str, ...] = ()
    """What was left out or approximated, a sentence each."""


def told(deviation: float, notes: Sequence[str]) -> str:
    """Return in one line how far what was written or read is from the original, and what else is to be known."""
    first = "Exact." if deviation == 0 else f"The largest deviation is {deviation:.2g} units."
    return " ".join([first, *notes])


def watched(
    items: Sequence[T], progress: Progress | None, begin: float = 0.0, end: float = 1.0
) -> Iterator[T]:
    """Yield items, and tell before each which share of the work is done: from `begin` to `end` with them all."""
    for number, item in enumerate(items):
        if progress is not None:
            progress(begin + (end - begin) * number / len(items))
        yield item
