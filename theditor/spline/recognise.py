"""Which known curve a segment is, and what is missing where it is nearly one."""

from cmath import rect
from collections.abc import Callable, Mapping, Sequence
from math import hypot, sqrt
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline import checks, joints, kinds, wording
from theditor.spline.basis import Floats, Mode, lambda_of
from theditor.spline.coefficients import coefficients, tolerances
from theditor.spline.joints import Segments
from theditor.spline.kinds import Kind, Named

if TYPE_CHECKING:
    from theditor.spline.curve import Curve

Vector = Sequence[float]
Parameters = dict[str, float | tuple[float, ...]]

NEARLY: Final = 0.1
"""How far a λ may be from 0 or 1 for `missing` to suggest setting it there."""

_NAMES: Final[dict[Mode, Callable[[complex, complex, complex, complex, float], Named]]] = {
    Mode.TRIGONOMETRIC: kinds.trigonometric,
    Mode.HYPERBOLIC: kinds.hyperbolic,
}


class Recognised(NamedTuple):
    """A segment known for what it is."""

    kind: Kind
    parameters: Mapping[str, Any]
    """Those of the function in `known` that makes the curve, with `start` and `end` where the segment lies on
    it (it may run backwards). A plane curve in space has the directions `axis` and `normal` in place of
    `rotation`; an affine image or general arc has its coefficients c0 … c3."""
    mode: Mode
    """The space its equation is taken from; of a line or point, the segment's mode."""
    coefficients: tuple[tuple[float, ...], ...]
    """c0 … c3 of its equation in t; none for a line or point."""
    tolerance: float
    """What was taken for zero."""

    @property
    def name(self) -> str:
        """The short name: ``catenary``, ``trochoid, prolate``."""
        return self.kind.value

    @property
    def description(self) -> str:
        """What it is and where, in one line, numbers to six digits."""
        return wording.description(self.kind, self.parameters, self.tolerance)

    @property
    def equation(self) -> str:
        """Its parametrisation as text, numbers to six digits: ``(x, y) = (t, cosh t), t ∈ [0, 1]``."""
        if self.kind is Kind.POINT:
            return wording.fixed(self.parameters["position"], self.tolerance)
        if self.kind is Kind.LINE:
            return wording.straight(self.parameters["start"], self.parameters["end"], self.tolerance)
        return wording.equation(self.mode, self.coefficients, self.tolerance)


class Missing(NamedTuple):
    """What would make a segment a known curve."""

    changes: tuple[tuple[int, float], ...]
    """Control points and the λ to give them."""
    recognised: Recognised
    """What the segment then is."""
    text: str
    """The same as a sentence: ``λ₄ = 0.97: set to 1 to make it a hyperbola arc``."""


def recognise(curve: "Curve", segment: int) -> Recognised | None:
    """Return what a segment is, or None if it has no name.

    Every trigonometric and every hyperbolic segment is recognised, if only as a general arc; one of another
    mode only where its control points are collinear or coincide. What is named agrees with the segment
    within about 1e-9 of the polygon's size (`tolerances`).

    Raises
    ------
    ValueError
        If there is no such segment.
    """
    return recognise_segments(curve, segment)[0]


def recognise_segments(curve: "Curve", segments: ArrayLike | None = None) -> tuple[Recognised | None, ...]:
    """Return what each of the segments is, all of them by default; quicker than one at a time.

    Raises
    ------
    ValueError
        If there is no such segment.
    """
    if segments is None:
        chosen = np.arange(curve.segment_count)
    else:
        chosen = checks.clean_indices(segments, curve.segment_count, "segment")
    parts = joints.take_segments(curve, chosen)
    all_modes = tuple(Mode)
    modes = [all_modes[code] for code in curve.mode_codes[chosen].tolist()]
    return _recognised(parts, curve.degree, modes)


def missing(curve: "Curve", segment: int) -> Missing | None:
    """Return which λ to set so that a segment becomes a curve known by its own name.

    Only λ within `NEARLY` of 0 or 1 are touched. None if the segment is recognised already, if a λ is further
    off, or if it would become a mere affine image or general arc.

    Raises
    ------
    ValueError
        If there is no such segment.
    """
    (place,) = checks.clean_indices(segment, curve.segment_count, "segment")
    active = [i for i in curve.lambda_indices(int(place)) if i is not None]
    values = curve.lambdas[active].tolist()
    for mode in _NAMES:
        target = lambda_of(mode, curve.degree)
        if not values or any(abs(value - target) > NEARLY for value in values):
            continue
        if recognise(curve, int(place)) is not None:
            return None
        (found,) = _recognised(joints.take_segments(curve, np.array([place])), curve.degree, [mode])
        if found is None or not found.kind.has_own_name:
            return None
        wrong = [(i, value) for i, value in zip(active, values, strict=True) if value != target]
        changes = tuple((i, target) for i, _ in wrong)
        return Missing(changes, found, wording.suggestion(wrong, target, found.kind))
    return None


def _recognised(parts: Segments, degree: int, modes: Sequence[Mode]) -> tuple[Recognised | None, ...]:
    """Return what the segments are, each taken to be of its mode."""
    found: list[Recognised | None] = [None] * len(modes)
    limits = tolerances(parts)
    for mode in _NAMES:
        if rows := [row for row, each in enumerate(modes) if each is mode]:
            curved = _curved(parts.take(np.array(rows)), degree, mode, limits[rows])
            for row, segment in zip(rows, curved, strict=True):
                found[row] = segment
    spanning = np.stack((parts.end - parts.start, parts.bend_start, parts.bend_end))
    directions, counts = _directions(spanning, limits)
    for row, count in enumerate(counts.tolist()):
        if found[row] is None and (count < 2 or modes[row] in _NAMES):
            one, along = parts.take(np.array([row])), directions[0, :, row] if count else None
            found[row] = _straight(one, degree, modes[row], along, float(limits[row]))
    return tuple(found)


def _curved(parts: Segments, degree: int, mode: Mode, limits: Floats) -> list[Recognised | None]:
    """Return what the segments of a mode with names are; None for those that are straight."""
    c = coefficients(parts, degree, mode)
    spanning = c[1:]
    if mode is Mode.HYPERBOLIC:  # exp t and exp(−t), of which one alone makes an exponential
        spanning = np.stack((c[1], (c[2] + c[3]) / 2, (c[2] - c[3]) / 2))
    directions, counts = _directions(spanning, limits)
    rows = zip(
        c.transpose(2, 0, 1).tolist(),
        directions.transpose(2, 0, 1).tolist(),
        counts.tolist(),
        limits.tolist(),
        strict=True,
    )
    return [
        _named(mode, vectors, axes[:count], limit) if count > 1 else None
        for vectors, axes, count, limit in rows
    ]


def _named(mode: Mode, c: Sequence[Vector], directions: Sequence[Vector], tolerance: float) -> Recognised:
    """Return what the curve with coefficients c0 … c3 is, which runs in two or three directions."""
    kind, parameters = (
        _in_space(mode, c, tolerance) if len(directions) == 3 else _in_plane(mode, c, directions, tolerance)
    )
    if not kind.has_own_name:
        parameters |= {f"c{i}": tuple(vector) for i, vector in enumerate(c)}
    return Recognised(kind, parameters, mode, tuple(map(tuple, c)), tolerance)


def _in_plane(
    mode: Mode, c: Sequence[Vector], directions: Sequence[Vector], tolerance: float
) -> tuple[Kind, Parameters]:
    if len(c[0]) == 2:
        c0, c1, c2, c3 = (complex(x, y) for x, y in c)
        named = _NAMES[mode](c0, c1, c2, c3, tolerance)
        parameters: Parameters = {key: (z.real, z.imag) for key, z in named.points.items()}
        turn = {} if named.rotation is None else {"rotation": named.rotation}
        return named.kind, parameters | {**named.sizes} | turn
    across, upward, normal = _axes_of_plane(*directions)
    c1, c2, c3 = (complex(_dot(vector, across), _dot(vector, upward)) for vector in c[1:])
    named = _NAMES[mode](0j, c1, c2, c3, tolerance)

    def lifted(z: complex) -> list[float]:
        return [z.real * u + z.imag * v for u, v in zip(across, upward, strict=True)]

    parameters = {
        key: tuple(x + dx for x, dx in zip(c[0], lifted(z), strict=True)) for key, z in named.points.items()
    }
    axes = {"axis": tuple(lifted(rect(1.0, named.rotation or 0.0))), "normal": tuple(normal)}
    return named.kind, parameters | {**named.sizes} | axes


def _in_space(mode: Mode, c: Sequence[Vector], tolerance: float) -> tuple[Kind, Parameters]:
    """Name a curve that lies in no plane: an affine image of a helix if trigonometric."""
    if mode is Mode.HYPERBOLIC:
        return Kind.HYPERBOLIC, {}
    c0, c1, c2, c3 = c
    first, second, step = (sqrt(_dot(v, v)) for v in (c2, c3, c1))
    longest = max(first, second)
    circular = abs(first - second) <= tolerance and abs(_dot(c2, c3)) <= tolerance * longest
    upright = max(abs(_dot(c1, c2)), abs(_dot(c1, c3))) <= tolerance * max(step, longest)
    if not (circular and upright):
        return Kind.AFFINE_HELIX, {}
    sense = 1.0 if _dot(c1, _cross(c2, c3)) > 0 else -1.0
    axis = tuple(x / step for x in c1)
    sizes = {"radius": (first + second) / 2, "pitch": sense * 4 * step}
    return Kind.HELIX, {"centre": tuple(c0), **sizes, "axis": axis}


def _straight(
    parts: Segments, degree: int, mode: Mode, direction: Floats | None, tolerance: float
) -> Recognised:
    """Return the one segment as a line in a direction, or as a point if it has none."""
    if direction is None:
        position = tuple(parts.start[:, 0].tolist())
        return Recognised(Kind.POINT, {"position": position}, mode, (), tolerance)
    start, end = _stretch(parts, degree, direction)
    return Recognised(Kind.LINE, {"start": start, "end": end}, mode, (), tolerance)


def _stretch(parts: Segments, degree: int, direction: Floats) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return the ends of what a straight segment covers, in the order that it runs through them.

    They are its joints unless it turns back within.
    """

    def speed(t: Floats) -> Floats:
        along: Floats = direction @ joints.evaluate(parts, t, degree, 1)
        return along

    t = np.linspace(0.0, 1.0, 33)
    forward = speed(t) > 0
    turns = np.flatnonzero(forward[:-1] != forward[1:])
    low, high = t[turns], t[turns + 1]
    for _ in range(50 if turns.size else 0):
        middle = (low + high) / 2
        before = (speed(middle) > 0) == forward[turns]
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    points = joints.evaluate(parts, np.array([0.0, *low, 1.0]), degree, 0)
    reach = direction @ points
    if reach[-1] < reach[0]:
        reach = -reach
    start, end = points[:, reach.argmin()].tolist(), points[:, reach.argmax()].tolist()
    return tuple(start), tuple(end)


def _directions(vectors: Floats, tolerance: Floats) -> tuple[Floats, NDArray[np.intp]]:
    """Return orthogonal unit vectors that span each segment's vectors within its tolerance, the longest's first.

    `vectors` is (p, d, k) for k segments; the result (d, d, k), zero beyond the number of directions, and that
    number (k,).
    """
    rest = vectors.copy()
    _, dimension, count = vectors.shape
    units = np.zeros((dimension, dimension, count))
    more, found = np.ones(count, dtype=bool), np.zeros(count, dtype=np.intp)
    for step in range(dimension):
        lengths = np.sqrt(np.einsum("pdk,pdk->pk", rest, rest))
        more &= lengths.max(axis=0) > tolerance
        if not more.any():
            break
        found += more
        longest = lengths.argmax(axis=0)[None]
        np.divide(
            np.take_along_axis(rest, longest[:, None], axis=0)[0],
            np.take_along_axis(lengths, longest, axis=0),
            out=units[step],
            where=more,
        )
        rest -= np.einsum("pdk,dk->pk", rest, units[step])[:, None] * units[step]
    return units, found


def _axes_of_plane(a: Vector, b: Vector) -> tuple[Vector, Vector, Vector]:
    """Return horizontal and upward unit vectors of the plane that two span in space, and its normal.

    The normal points up; of an upright plane, towards negative y.
    """
    normal = _unit(_cross(a, b))
    x, y, z = (0.0 if abs(component) <= 1e-9 else component for component in normal)
    if (z, -y, x) < (0.0, 0.0, 0.0):
        normal = [-component for component in normal]
    nx, ny, _ = normal
    across = _unit([-ny, nx, 0.0]) if hypot(nx, ny) > 1e-9 else [1.0, 0.0, 0.0]
    return across, _cross(normal, across), normal


def _unit(a: Vector) -> Vector:
    length = sqrt(_dot(a, a))
    return [x / length for x in a]


def _dot(a: Vector, b: Vector) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))


def _cross(a: Vector, b: Vector) -> Vector:
    (a1, a2, a3), (b1, b2, b3) = a, b
    return [a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1]
