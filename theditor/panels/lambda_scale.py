"""The scale on which λ is shown: wide open between T and H, yet reaching the hull's ends and λ*.

A place on the scale is a number in [0, 1], whatever the control's length in pixels. No Qt here.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline import CONVEX_HULL_RANGE, INTERPOLATING, JOINT_SLOPE_ZERO, MAX_LAMBDA

LOWEST, HIGHEST = -16.0, 10.0
"""Where the scale ends. λ itself goes further, to ±`MAX_LAMBDA`."""

MAGNETISM = 6.0
"""Pixels within which a dragged λ lands on a landmark."""

_MIDDLE, _SOFTNESS = 0.5, 0.3
_LEFT, _RIGHT = (math.asinh((end - _MIDDLE) / _SOFTNESS) for end in (LOWEST, HIGHEST))
_SPAN = _RIGHT - _LEFT
_STEPS = 200
_FINENESS = 10


class Landmark(NamedTuple):
    """A λ worth knowing, its word on the scale, and whether a dragged λ is drawn to it."""

    value: float
    label: str
    magnetic: bool = False


def position(value: ArrayLike) -> NDArray[np.float64]:
    """Return the place of λ on the scale, in [0, 1]; values beyond the scale sit at its ends."""
    warped = np.arcsinh((np.asarray(value, dtype=np.float64) - _MIDDLE) / _SOFTNESS)
    return np.clip((warped - _LEFT) / _SPAN, 0.0, 1.0)


def value_at(place: ArrayLike) -> NDArray[np.float64]:
    """Return λ at a place on the scale, the inverse of `position`; places are clipped to [0, 1]."""
    warped = _LEFT + np.clip(np.asarray(place, dtype=np.float64), 0.0, 1.0) * _SPAN
    return np.clip(_MIDDLE + _SOFTNESS * np.sinh(warped), LOWEST, HIGHEST)


def landmarks(degree: int) -> tuple[Landmark, ...]:
    """Return what to mark on the scale of a quadratic (2) or cubic (3) curve, ascending."""
    hull_start, hull_end = CONVEX_HULL_RANGE[degree]
    marks = (
        Landmark(hull_start, "hull"),
        Landmark(JOINT_SLOPE_ZERO, "cusp" if degree == 2 else "inflection"),
        Landmark(0.0, "T", magnetic=True),
        Landmark(1.0, "H", magnetic=True),
        Landmark(hull_end, "hull"),
        Landmark(INTERPOLATING[degree], "λ*", magnetic=True),
    )
    return tuple(sorted(marks, key=lambda mark: mark.value))


def snapped(value: float, degree: int, length: float, tolerance: float = MAGNETISM) -> float:
    """Return T, H or λ* if one lies within `tolerance` pixels of `value`, else `value` itself.

    The scale is `length` pixels long.
    """
    magnets = [mark.value for mark in landmarks(degree) if mark.magnetic]
    distances = np.abs(position(magnets) - position(value)) * length
    nearest = int(np.argmin(distances))
    return magnets[nearest] if distances[nearest] <= tolerance else value


def stepped(values: ArrayLike, count: int, degree: int, fine: bool = False) -> NDArray[np.float64]:
    """Return λ moved by `count` small steps of the scale, each value from where it is.

    A step is a round number (1, 2 or 5 times a power of ten) of about 1/200 of the scale, ten times less if
    `fine`; values land on its multiples, and no step jumps over T, H or λ*.
    """
    start = np.asarray(values, dtype=np.float64)
    direction = np.sign(count)
    result = start.copy()
    for _ in range(abs(count)):
        step = _round_step(result) / (_FINENESS if fine else 1)
        multiple = result / step
        away = np.where(direction > 0, np.floor(multiple + 1e-9), np.ceil(multiple - 1e-9)) + direction
        target = np.round(away * step, 6)
        for mark in landmarks(degree):
            between = (mark.value - result) * (mark.value - target) < 0
            target = np.where(between & mark.magnetic, mark.value, target)
        result = target
    return np.clip(result, -MAX_LAMBDA, MAX_LAMBDA)


def next_landmark(value: float, direction: int, degree: int) -> float:
    """Return the closest landmark above (`direction` > 0) or below `value`, or `value` if none is."""
    beyond = [m.value for m in landmarks(degree) if (m.value - value) * direction > 0]
    return min(beyond, key=lambda mark: abs(mark - value), default=value)


def placed_labels(
    places: Sequence[float], widths: Sequence[float], length: float, gap: float = 4.0
) -> list[float | None]:
    """Return left edges for labels that shall stand under `places`, so that none overlap.

    None stands for a label that finds no room.

    Parameters
    ----------
    places
        Wished centres, in pixels from 0 to `length`, the most important first.
    widths
        Widths of the labels in pixels.
    length
        Labels stay within [0, `length`].
    gap
        Least distance between two labels.
    """
    taken: list[tuple[float, float]] = []
    result: list[float | None] = []
    for centre, width in zip(places, widths, strict=True):
        room = max(length - width, 0.0)
        wishes = (min(max(centre - width / 2 + shift, 0.0), room) for shift in (0, -4, 4, -8, 8, -12, 12))
        left = next((x for x in wishes if all(x + width + gap <= a or b + gap <= x for a, b in taken)), None)
        if left is not None:
            taken.append((left, left + width))
        result.append(left)
    return result


class ScaleDrag:
    """A drag along the scale, followed pixel by pixel from the place where it began."""

    def __init__(self, degree: int, length: float, place: float) -> None:
        self.degree, self.length, self.place = degree, length, place

    def move(self, pixels: float, *, fine: bool = False, free: bool = False) -> float:
        """Return λ after the pointer went on by `pixels`.

        The drag is ten times slower if `fine`, and without magnetism if `free`. Between landmarks the value
        is rounded to what a pixel can tell apart.
        """
        self.place += pixels / self.length / (_FINENESS if fine else 1)
        value = float(value_at(self.place))
        caught = value if free else snapped(value, self.degree, self.length)
        if caught != value:
            return caught
        pixel = _slope(value) / self.length / (_FINENESS if fine else 1)
        return round(value, max(0, math.ceil(-math.log10(pixel))))


def _slope(value: ArrayLike) -> NDArray[np.float64]:
    """How much λ changes over the whole scale at the rate it has at `value`."""
    return np.hypot(np.asarray(value, dtype=np.float64) - _MIDDLE, _SOFTNESS) * _SPAN


def _round_step(value: NDArray[np.float64]) -> NDArray[np.float64]:
    step = _slope(value) / _STEPS
    power = 10.0 ** np.floor(np.log10(step))
    return np.asarray(power * np.select([step < 2 * power, step < 5 * power], [1.0, 2.0], 5.0))
