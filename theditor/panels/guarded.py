"""Why some segments and λ need a warning, found where they are looked for."""

from __future__ import annotations

import numpy as np

from theditor.spline import (
    CONVEX_HULL_RANGE,
    JOINT_SLOPE_ZERO,
    Curve,
    Guards,
    negative_basis,
    reversed_joints,
)

_BLOCK = 64


class NegativeBasis:
    """Reasons to mark segments, computed by blocks as they are asked for, and kept until a λ changes."""

    def __init__(self) -> None:
        self._curve: Curve | None = None
        self._blocks: dict[int, Guards] = {}

    def reason(self, curve: Curve, segment: int) -> str:
        """Say which basis function of a segment is negative and what follows; nothing where none is."""
        if self._curve is None or not same_lambdas(self._curve, curve):
            self._blocks = {}
        self._curve = curve
        block, place = divmod(segment, _BLOCK)
        if block not in self._blocks:
            end = min((block + 1) * _BLOCK, curve.segment_count)
            self._blocks[block] = negative_basis(_stretch(curve, block * _BLOCK, end))
        return self._blocks[block].reason(place)

    def caused_by(self, curve: Curve, point: int) -> list[str]:
        """Say of which segments the λ of a control point makes a basis function negative."""
        low, high = CONVEX_HULL_RANGE[curve.degree]
        if low <= curve.lambdas[point] <= high or not curve.active_lambdas[point]:
            return []
        count = curve.segment_count
        beside = [point - curve.first_segment - 1, point - curve.first_segment]
        segments = [s % count for s in beside] if curve.closed else [s for s in beside if 0 <= s < count]
        reasons = ((s + curve.first_segment, self.reason(curve, s)) for s in segments)
        return [f"Segment {number}: {why}" for number, why in reasons if why]


def reversal(curve: Curve, point: int) -> str:
    """Say what a λ at or below the one of slope zero does to its joint; nothing for other λ."""
    if curve.lambdas[point] > JOINT_SLOPE_ZERO:
        return ""
    return next((joint.reason for joint in reversed_joints(curve) if joint.point == point), "")


def same_lambdas(one: Curve, other: Curve) -> bool:
    """Whether two curves have the same λ, and the same basis functions by them."""
    return (one.degree, one.closed, one.ends) == (other.degree, other.closed, other.ends) and (
        one.lambdas is other.lambdas or np.array_equal(one.lambdas, other.lambdas)
    )


def _stretch(curve: Curve, start: int, end: int) -> Curve:
    """Return a curve whose segments have the λ, and so the basis functions, of the segments start … end − 1."""
    joints = (np.arange(start, end + 1) + curve.first_segment) % len(curve.lambdas)
    lambdas = np.where(curve.active_lambdas, curve.lambdas, 0.0)[joints]
    padded = np.pad(lambdas, (1, curve.degree - 2))  # the λ at free ends that shape nothing
    return Curve(np.zeros((len(padded), 2)), padded, curve.degree)
