"""How smoothly segments meet: measured at every joint, beside what the theory promises."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Final, Literal, NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from theditor.spline import joints
from theditor.spline.basis import JOINT_SLOPE_ZERO, Floats, basis
from theditor.spline.changed import changed_segments
from theditor.spline.curvature import stands_still
from theditor.spline.curve import Curve
from theditor.spline.distinct import distinct
from theditor.spline.guards import reversed_joints
from theditor.spline.numerals import number
from theditor.spline.turns import cross, speed_scale

_ORDERS: Final = {-1: "not even continuous", 0: "⁰", 1: "¹", 2: "²"}
_SIDES: Final[tuple[Literal["left", "right"], ...]] = ("left", "right")
_BLOCK: Final = 4096
_ARRAYS: Final = (
    *("position", "jumps", "relative_jumps", "order", "geometric_order"),
    *("curvature_left", "curvature_right", "curvature_jump", "still", "stopped_by_lambda"),
)
"""What is measured at each joint."""
_MEASURED: Final = ("position", "first derivative", "second derivative")


class JointReport(NamedTuple):
    """What was measured where two segments meet."""

    joint: int  # its u, and its index among the curve's joints
    number: int  # the index of the λ it belongs to, by which the joint is called
    position: tuple[float, ...]
    jumps: tuple[float, float, float]  # of position, first and second derivative: right − left, their lengths
    relative_jumps: tuple[float, float, float]  # the same beside the size of what they are made of
    order: int  # n of Cⁿ, 2 at most; −1 where not even the position agrees
    geometric_order: int  # n of Gⁿ, likewise
    curvature_left: float  # nan where the curve stands still
    curvature_right: float
    curvature_jump: float  # right − left; in space the length of the curvature vectors' difference
    promised: int  # n of the Cⁿ that the theory promises
    holds: bool
    still: bool  # the curve has no velocity here
    note: str  # why it stands still, or what a λ below −2.648… does here; or nothing

    def __str__(self) -> str:
        """Return a sentence or two in plain words."""
        place = ", ".join(map(number, self.position))
        parts = [f"Joint {self.number} at ({place}): {_order('C', self.order)}"]
        if self.order >= 0 and not self.still:
            parts[0] += f" and {_order('G', self.geometric_order)}"
        promise = f"the promised {_order('C', self.promised)}"
        if self.holds:
            parts[0] += f"; {promise} holds"
        else:
            broken = self.order + 1
            size = number(self.relative_jumps[broken])
            parts[0] += f"; {promise} fails: the {_MEASURED[broken]} jumps by {size} of its size"
        if not self.still and self.geometric_order < 2:
            parts[0] += "; the curvature jumps "
            if len(self.position) == 2:
                parts[0] += f"from {number(self.curvature_left)} to {number(self.curvature_right)}"
            else:
                parts[0] += f"by {number(self.curvature_jump)}"
        return ". ".join([*parts, *([self.note] if self.note else [])]) + "."


@dataclass(frozen=True, eq=False)
class Continuity:
    """The reports of all joints where two segments meet, in order, as arrays; iterates as `JointReport`."""

    joint: NDArray[np.intp]  # (k,)
    number: NDArray[np.intp]  # (k,)
    position: Floats  # (k, d)
    jumps: Floats  # (k, 3)
    relative_jumps: Floats  # (k, 3)
    order: NDArray[np.intp]  # (k,)
    geometric_order: NDArray[np.intp]  # (k,)
    curvature_left: Floats  # (k,)
    curvature_right: Floats  # (k,)
    curvature_jump: Floats  # (k,)
    still: NDArray[np.bool_]  # (k,) no velocity
    stopped_by_lambda: NDArray[np.bool_]  # (k,) because of λ, not because control points coincide
    reversals: Mapping[int, str]  # by joint, what a λ at or below −2.648… does there
    promised: int
    tolerance: float

    @property
    def holds(self) -> NDArray[np.bool_]:
        """At which joints, (k,), the promise holds."""
        return np.asarray(self.order >= self.promised)

    def __len__(self) -> int:
        return len(self.joint)

    def __iter__(self) -> Iterator[JointReport]:
        return (self[row] for row in range(len(self)))

    def __getitem__(self, row: int) -> JointReport:
        first, second, third = self.jumps[row].tolist()
        relative = self.relative_jumps[row].tolist()
        return JointReport(
            int(self.joint[row]),
            int(self.number[row]),
            tuple(self.position[row].tolist()),
            (first, second, third),
            (relative[0], relative[1], relative[2]),
            int(self.order[row]),
            int(self.geometric_order[row]),
            float(self.curvature_left[row]),
            float(self.curvature_right[row]),
            float(self.curvature_jump[row]),
            self.promised,
            bool(self.order[row] >= self.promised),
            bool(self.still[row]),
            self._note(row),
        )

    def _note(self, row: int) -> str:
        if not self.still[row]:
            return self.reversals.get(int(self.joint[row]), "")
        if self.stopped_by_lambda[row]:
            why = f"its λ is {number(round(JOINT_SLOPE_ZERO, 3))}…"
        elif self.promised == 1:
            why = "the two control points beside it coincide"
        else:
            why = "the control points before and after it coincide"
        return f"The curve stands still here, because {why}, so it may have a cusp or a corner"


def continuity(curve: Curve, tolerance: float = 1e-9) -> Continuity:
    """Return how smoothly the segments of a curve meet, measured from both sides of every joint.

    The theory promises C¹ to a quadratic and C² to a cubic, whatever the λ and the control points. Geometric
    continuity is that of the tangent (G¹) and of the curvature (G²); where the curve stands still there is
    none beyond G⁰, which is noted and is no breach of the promise.

    Parameters
    ----------
    curve : Curve
    tolerance : float
        The largest jump that still counts as rounding, relative to the terms it is the difference of: for
        derivatives the edges and second differences of both segments, times 1 + |λ|; for the position the
        same or its largest |coordinate|, whichever is more. For tangent and curvature the same jumps,
        divided by the speed and by its square.

    Returns
    -------
    Continuity
        Of all joints but the two ends of an open curve; of all, when closed. May be empty.

    Raises
    ------
    ValueError
        If `tolerance` is negative or not a number.
    """
    if not tolerance >= 0:
        raise ValueError(f"tolerance must be a number of at least 0, not {tolerance!r}")
    at = np.arange(0 if curve.closed else 1, curve.segment_count)
    return _report(curve, tolerance, at, _measured(curve, at, tolerance))


def measured_again(report: Continuity, old: Curve, new: Curve) -> tuple[Continuity, NDArray[np.intp]]:
    """Return the report of a curve made from that of another one, and its rows whose joints were measured again.

    Only joints of segments that differ are; the report is the same as that of `continuity`.
    """
    changed = changed_segments(old, new)
    if changed is None or 2 * len(changed) > len(report):
        again = continuity(new, report.tolerance)
        return again, np.arange(len(again))
    first, count = 0 if new.closed else 1, new.segment_count
    beside = np.concatenate((changed, (changed + 1) % count if new.closed else changed + 1))
    at = distinct(beside[(beside >= first) & (beside < count)])
    rows = at - first
    arrays = {name: getattr(report, name).copy() for name in _ARRAYS}
    for name, values in _measured(new, at, report.tolerance).items():
        arrays[name][rows] = values
    return _report(new, report.tolerance, report.joint, arrays), rows


def _report(curve: Curve, tolerance: float, at: NDArray[np.intp], measured: dict[str, Any]) -> Continuity:
    return Continuity(
        joint=at,
        number=(at + curve.first_segment) % len(curve.control_points),
        reversals={each.joint: each.reason for each in reversed_joints(curve)},
        promised=curve.degree - 1,
        tolerance=tolerance,
        **measured,
    )


def _measured(curve: Curve, at: NDArray[np.intp], tolerance: float) -> dict[str, Any]:
    """Measure joints, block by block so that the intermediate results stay in the cache."""
    if 8 * len(at) > curve.segment_count:
        _ = curve.joint_form  # made once, not for each block
    points, count = curve.control_points, len(curve.control_points)
    if curve.closed:
        points = points[np.arange(-1, count + curve.degree - 1) % count]
    elif curve.ends == "clamped":
        first, last = 2 * points[:1] - points[1:2], 2 * points[-1:] - points[-2:-1]
        points = np.concatenate((first, points[1:-1] if curve.degree == 2 else points, last))
    defining = sliding_window_view(points, curve.degree + 1, axis=0)
    # A clamped cubic has no use for the λ at its ends.
    lambdas = np.where(curve.active_lambdas, curve.lambdas, 0.0)
    blocks = [
        _measured_block(curve, at[start : start + _BLOCK], tolerance, defining, lambdas)
        for start in range(0, max(len(at), 1), _BLOCK)
    ]
    return {name: np.concatenate([block[name] for block in blocks]) for name in _ARRAYS}


def _measured_block(
    curve: Curve, at: NDArray[np.intp], tolerance: float, defining: Floats, lambdas: Floats
) -> dict[str, Any]:
    left, right = (
        _side(curve, segments, t, defining, lambdas)
        for segments, t in (((at - 1) % curve.segment_count, 1.0), (at, 0.0))
    )
    jumps = np.stack([_length(b - a) for a, b in zip(left, right, strict=True)], axis=-1)
    before = joints.take_segments(curve, (at - 1) % curve.segment_count)
    scale = np.maximum(speed_scale(before), speed_scale(joints.take_segments(curve, at)))
    sizes = np.stack((np.maximum(scale, np.abs(right[0]).max(axis=-1, initial=0)), scale, scale), axis=-1)
    agree = jumps <= tolerance * sizes
    stops = [stands_still(curve, at, name) for name in _SIDES]
    still = np.logical_or(*stops)
    speed = np.minimum(_length(left[1]), _length(right[1]))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        tangents, curvatures = zip(
            *(_tangent_and_curvature(*side[1:]) for side in (left, right)), strict=True
        )
        turned, bent = _length(tangents[1] - tangents[0]), _length(curvatures[1] - curvatures[0])
        kappa = [
            np.where(stop, np.nan, _signed(tangent, bend))
            for stop, tangent, bend in zip(stops, tangents, curvatures, strict=True)
        ]
        g1 = ~still & (turned <= tolerance * scale / speed)
        g2 = bent <= tolerance * np.maximum(scale / speed**2, _length(curvatures[1]))
    own = curve.lambdas[(at + curve.first_segment) % len(curve.control_points)]
    return {
        "position": curve(at),
        "jumps": jumps,
        "relative_jumps": np.divide(jumps, sizes, out=np.zeros_like(jumps), where=sizes > 0),
        "order": _leading(agree),
        "geometric_order": _leading(np.stack((agree[:, 0], g1, g2), axis=-1)),
        "curvature_left": kappa[0],
        "curvature_right": kappa[1],
        "curvature_jump": kappa[1] - kappa[0] if curve.dimension == 2 else np.where(still, np.nan, bent),
        "still": still,
        # A cubic's velocity does not depend on λ.
        "stopped_by_lambda": (curve.degree == 2) & (np.abs(own - JOINT_SLOPE_ZERO) < 1e-12),
    }


def _side(
    curve: Curve, segments: NDArray[np.intp], t: float, defining: Floats, lambdas: Floats
) -> list[Floats]:
    """Return position, first and second derivative at one end of segments, (k, d) each.

    By the definition, basis functions times control points: evaluation takes a form in which both sides of a
    joint are one and the same sum, which could show no jump.
    """
    own = defining[segments]
    # The weights of derivatives sum to 0: edges give the same, with less rounding far from the origin.
    edges = own - own[..., 1:2]
    start, end = (lambdas[(segments + curve.first_segment + step) % len(lambdas)] for step in (0, 1))
    weights = (basis(t, start, end, curve.degree, nu) for nu in range(3))
    return [np.einsum("kj,kdj->kd", *pair) for pair in zip(weights, (own, edges, edges), strict=True)]


def _signed(tangent: Floats, bend: Floats) -> Floats:
    """Return the curvature, signed in the plane, for unit tangents and curvature vectors, (k, d) each."""
    return cross(tangent.T, bend.T) if tangent.shape[1] == 2 else _length(bend)


def _tangent_and_curvature(velocity: Floats, bend: Floats) -> tuple[Floats, Floats]:
    """Return unit tangents and curvature vectors, (k, d) each."""
    speed = _length(velocity)[:, None]
    tangent = velocity / speed
    return tangent, (bend - (bend * tangent).sum(axis=-1, keepdims=True) * tangent) / speed**2


def _length(vectors: Floats) -> Floats:
    return np.asarray(np.sqrt(np.einsum("kd,kd->k", vectors, vectors)))


def _leading(agree: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Return the highest order, −1 to 2, up to which all agree, (k,)."""
    return np.asarray(np.logical_and.accumulate(agree, axis=1).sum(axis=1) - 1)


def _order(kind: str, order: int) -> str:
    return f"{kind}{_ORDERS[order]}" if order >= 0 else _ORDERS[-1]
