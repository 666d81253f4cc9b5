"""Curvature against arc length: a table over a whole curve, fine enough for a plot. No Qt here."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from theditor.spline import Curve
from theditor.spline.joints import evaluate
from theditor.spline.turns import cross

Floats = NDArray[np.float64]

_SAMPLES = 16384
"""Intervals in all, if the curve has not more segments than that."""
_FEWEST, _MOST = 4, 64
"""Intervals in a segment."""
_TYPICAL = 0.9
"""Share of the samples that do not exceed a typical curvature."""
_SPIKE = 4.0
"""Curvature more than this many times the typical one leaves the plot."""
_FLAT = 1e-9
"""A curve that turns less than this, in radians, is straight."""


@dataclass(frozen=True, eq=False)
class Profile:
    """Curvature and arc length at equal steps of t in every segment, both its ends included."""

    curve: Curve
    t: Floats  # (k,)
    length: Floats  # (segments, k), from the start of the curve
    curvature: Floats  # (segments, k), nan where the curve stands still

    @property
    def total(self) -> float:
        """The length of the curve."""
        return float(self.length[-1, -1])

    @property
    def joints(self) -> Floats:
        """Lengths at which segments meet, begin or end, (segments + 1,)."""
        return np.append(self.length[:, 0], self.length[-1, -1])

    def length_at(self, u: float) -> float:
        """The length from the start of the curve to parameter `u`."""
        segment = min(int(u), self.curve.segment_count - 1)
        return float(np.interp(u - segment, self.t, self.length[segment]))

    def parameter_at(self, length: float) -> float:
        """The parameter at a length from the start of the curve."""
        last = self.curve.segment_count - 1
        segment = min(max(int(np.searchsorted(self.length[:, 0], length, side="right")) - 1, 0), last)
        return segment + float(np.interp(length, self.length[segment], self.t))

    @cached_property
    def range(self) -> tuple[float, float]:
        """Least and greatest curvature worth showing, 0 included: spikes at cusps do not count in full."""
        values = self.curvature[np.isfinite(self.curvature)]
        if not values.size:
            return -1.0, 1.0
        sizes = np.abs(values)
        typical = float(np.quantile(sizes, _TYPICAL))
        most = min(float(sizes.max()), _SPIKE * typical) if typical > 0 else float(sizes.max())
        if most * self.total <= _FLAT:
            return (-1.0 if self.curve.dimension == 2 else 0.0), 1.0
        return max(float(values.min()), -most) if values.min() < 0 else 0.0, max(min(values.max(), most), 0.0)


def profile(curve: Curve) -> Profile:
    """Tabulate a curve; lengths by Simpson's rule, as exact as a plot needs."""
    steps = min(max(_SAMPLES // curve.segment_count // 2 * 2, _FEWEST), _MOST)
    t = np.linspace(0, 1, steps + 1)
    speed, curvature = np.empty((2, curve.segment_count, len(t)))
    for k, place in enumerate(t):
        velocity, bend = (evaluate(curve.joint_form, place, curve.degree, nu) for nu in (1, 2))
        turn = cross(velocity, bend)
        if curve.dimension == 3:
            turn = np.sqrt((turn**2).sum(axis=0))
        speed[:, k] = np.sqrt((velocity**2).sum(axis=0))
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            curvature[:, k] = turn / speed[:, k] ** 3
    curvature[~np.isfinite(curvature)] = np.nan
    return Profile(curve, t, _running_length(speed, 1 / steps), curvature)


def _running_length(speed: Floats, step: float) -> Floats:
    """Integrate (segments, k) speeds, k odd, from the start of the curve to every sample."""
    first, middle, last = speed[:, :-2:2], speed[:, 1::2], speed[:, 2::2]
    length = np.zeros_like(speed)
    # Simpson's rule over pairs of steps, and its half over the first step of each pair.
    pairs = step / 3 * (first + 4 * middle + last)
    halves = np.clip(step / 12 * (5 * first + 8 * middle - last), 0, pairs)
    length[:, 2::2] = np.cumsum(pairs, axis=1)
    length[:, 1::2] = length[:, :-2:2] + halves
    length[1:] += np.cumsum(length[:-1, -1])[:, None]
    return length
