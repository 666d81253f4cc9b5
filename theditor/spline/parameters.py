"""Refusals of the measures: parameters outside the curve, accuracies that are none."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from theditor.spline.basis import Floats

if TYPE_CHECKING:
    from theditor.spline.curve import Curve


def check_accuracy(accuracy: float) -> None:
    """Refuse an accuracy that is not a positive number."""
    if not 0 < accuracy < np.inf:
        raise ValueError(f"accuracy must be a positive number, not {accuracy!r}")


def check_plane(curve: "Curve", what: str) -> None:
    """Refuse a space curve."""
    if curve.dimension != 2:
        raise ValueError(
            f"{what} need a plane curve: take two of the three coordinates of its control points"
        )


def clean_parameters(curve: "Curve", u: ArrayLike) -> Floats:
    """Return parameters of the curve as an array, all within its domain."""
    places = np.asarray(u, dtype=np.float64)
    outside = ~((places >= 0) & (places <= curve.segment_count))
    if outside.any():
        raise ValueError(
            f"u = {float(places[outside].flat[0])} lies outside the curve's domain, 0 to {curve.segment_count}"
        )
    return places


def clean_interval(curve: "Curve", u0: float | None, u1: float | None) -> tuple[float, float]:
    """Return the ends of a part of the curve, by default those of its domain."""
    start = 0.0 if u0 is None else float(u0)
    end = float(curve.segment_count) if u1 is None else float(u1)
    clean_parameters(curve, [start, end])
    if end < start:
        raise ValueError(f"u1 = {end} comes before u0 = {start}: give the lesser parameter first")
    return start, end
