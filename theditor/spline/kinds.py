"""What curve an equation describes: names for c0 + c1 t + c2 cos(πt/2) + c3 sin(πt/2) and its like.

Plane vectors are complex numbers here: conj(a)·b has the dot product as real part and the cross product as
imaginary part. An equation counts as that of a named curve if it becomes exactly so by changing coefficients
by no more than about a tolerance. Of a curve that one family of names would describe twice, the simpler name
is taken: an ellipse arc with equal axes is a circle arc.
"""

from cmath import phase
from collections.abc import Mapping
from enum import Enum
from math import atan2, cos, exp, hypot, log, pi, sin, tau
from typing import NamedTuple


class Kind(Enum):
    """What a segment is, up to place and size; the value is its name."""

    POINT = "point"
    LINE = "line segment"
    CIRCLE = "circle arc"
    ELLIPSE = "ellipse arc"
    HYPERBOLA = "hyperbola arc"
    SINE = "sine wave"
    CYCLOID = "cycloid"
    PROLATE = "trochoid, prolate"
    CURTATE = "trochoid, curtate"
    HELIX = "helix"
    CATENARY = "catenary"
    EXPONENTIAL = "exponential curve"
    AFFINE_SINE = "affine image of a sine wave"
    AFFINE_CYCLOID = "affine image of a cycloid"
    AFFINE_HELIX = "affine image of a helix"
    AFFINE_CATENARY = "affine image of a catenary"
    AFFINE_EXPONENTIAL = "affine image of an exponential curve"
    TRIGONOMETRIC = "general trigonometric arc"
    HYPERBOLIC = "general hyperbolic arc"

    @property
    def has_own_name(self) -> bool:
        """Whether it is more than an affine image or an arc in general."""
        return not self.value.startswith(("affine", "general"))


class Named(NamedTuple):
    """A kind with its parameters; angles are in radians."""

    kind: Kind
    points: Mapping[str, complex] = {}
    sizes: Mapping[str, float | tuple[float, float]] = {}
    rotation: float | None = None


def trigonometric(c0: complex, c1: complex, c2: complex, c3: complex, tolerance: float) -> Named:
    """Name the plane curve c0 + c1 t + c2 cos(πt/2) + c3 sin(πt/2), known not to be straight."""
    # c2 cos θ + c3 sin θ = major cos(θ − turned) + minor sin(θ − turned), at right angles
    turned = atan2(2 * _dot(c2, c3), abs(c2) ** 2 - abs(c3) ** 2) / 2
    cosine, sine = cos(turned), sin(turned)
    major, minor = c2 * cosine + c3 * sine, c3 * cosine - c2 * sine
    circular = abs(major) - abs(minor) <= tolerance
    if abs(c1) <= tolerance:
        return _circle(c0, c2, c3) if circular else _ellipse(c0, major, minor, turned)
    if abs(minor) <= tolerance:
        if _perpendicular(major, c1, tolerance):
            return _sine(c0, c1, major, turned)
        return Named(Kind.AFFINE_SINE)
    if circular:
        return _trochoid(c0, c1, c2, c3, tolerance)
    # The linear map that takes c2, c3 to perpendicular unit vectors takes c1 to one of this length.
    length = hypot(_cross(c1, c3), _cross(c2, c1)) / abs(_cross(c2, c3))
    ratio = pi / 2 / length
    if abs(c1) * abs(1 - ratio) <= tolerance:
        return Named(Kind.AFFINE_CYCLOID)
    return Named(Kind.TRIGONOMETRIC, sizes={"arm_to_radius": ratio})


def hyperbolic(c0: complex, c1: complex, c2: complex, c3: complex, tolerance: float) -> Named:
    """Name the plane curve c0 + c1 t + c2 cosh t + c3 sinh t, known not to be straight."""
    rising, falling = (c2 + c3) / 2, (c2 - c3) / 2  # the factors of exp t and exp(−t)
    if abs(c1) <= tolerance:
        return _hyperbola(c0, rising, falling)
    if min(abs(rising), abs(falling)) <= tolerance:
        return _exponential(c0, c1, rising, falling, tolerance)
    greater = max(rising, falling, key=abs)
    if abs(_cross(rising, falling)) > tolerance * abs(greater) or _dot(rising, falling) < 0:
        return Named(Kind.HYPERBOLIC)
    # It is 2√(|rising||falling|) cosh(t − t0) along one direction; a catenary's rises as much as c1 is long.
    product = 4 * abs(rising) * abs(falling)
    alike = abs(product - abs(c1) ** 2) <= tolerance * max(4 * abs(greater), 2 * abs(c1))
    if alike and _perpendicular(greater, c1, tolerance):
        return _catenary(c0, c1, greater / abs(greater), log(abs(falling) / abs(rising)) / 2)
    return Named(Kind.AFFINE_CATENARY)


def _circle(c0: complex, c2: complex, c3: complex) -> Named:
    sense = 1 if _cross(c2, c3) > 0 else -1
    radius = (abs(c2) + abs(c3)) / 2
    return Named(Kind.CIRCLE, {"centre": c0}, {"radius": radius, **_turned_through(phase(c2), sense)})


def _ellipse(c0: complex, first: complex, second: complex, turned: float) -> Named:
    if abs(first.imag) > abs(first.real):  # the axis nearer to the x-axis comes first
        first, second, turned = second, -first, turned + pi / 2
    if first.real < 0:
        first, second, turned = -first, -second, turned + pi
    sense = 1 if _cross(first, second) > 0 else -1
    axes = abs(first), abs(second)
    angles = _turned_through(-sense * turned, sense)
    return Named(Kind.ELLIPSE, {"centre": c0}, {"semi_axes": axes, **angles}, phase(first))


def _sine(c0: complex, c1: complex, crest: complex, turned: float) -> Named:
    sense = 1 if _rightward(c1) else -1
    along = sense * c1 / abs(c1)
    upward = 1 if _dot(crest, 1j * along) > 0 else -1
    phases = _turned_through(sense * (pi / 2 - turned) + (pi if upward != sense else 0), sense)
    origin = c0 - along * abs(c1) * phases["start"] * 2 / pi
    sizes = {"amplitude": abs(crest), "wavelength": 4 * abs(c1), **phases}
    return Named(Kind.SINE, {"origin": origin}, sizes, phase(along))


def _trochoid(c0: complex, c1: complex, c2: complex, c3: complex, tolerance: float) -> Named:
    sense = 1 if _cross(c2, c3) < 0 else -1  # a wheel that rolls forward on a line below turns clockwise
    along = sense * c1 / abs(c1)
    lowest = -1j * along
    radius, arm = 2 / pi * abs(c1), (abs(c2) + abs(c3)) / 2
    angles = _turned_through(-phase(c2 / lowest), sense)
    points = {"origin": c0 + radius * (lowest - along * angles["start"])}
    if abs(radius - arm) <= tolerance:
        return Named(Kind.CYCLOID, points, {"radius": radius, **angles}, phase(along))
    kind = Kind.PROLATE if arm > radius else Kind.CURTATE
    return Named(kind, points, {"radius": radius, "arm": arm, **angles}, phase(along))


def _hyperbola(c0: complex, rising: complex, falling: complex) -> Named:
    vertex = log(abs(falling) / abs(rising)) / 2  # the t where both terms are equally long
    ahead, behind = rising * exp(vertex), falling * exp(-vertex)
    transverse, conjugate = ahead + behind, ahead - behind
    sense = 1 if _cross(transverse, conjugate) > 0 else -1
    axes = abs(transverse), abs(conjugate)
    reach = _run_through(-vertex, sense)
    return Named(Kind.HYPERBOLA, {"centre": c0}, {"semi_axes": axes, **reach}, phase(transverse))


def _exponential(c0: complex, c1: complex, rising: complex, falling: complex, tolerance: float) -> Named:
    sense, height = (1, rising) if abs(rising) > abs(falling) else (-1, falling)
    if not _perpendicular(height, c1, tolerance):
        return Named(Kind.AFFINE_EXPONENTIAL)
    step = sense * c1
    side = 1 if _rightward(step) else -1
    along = side * step / abs(step)
    sizes = {"amplitude": _dot(height, 1j * along), "length": side * abs(step), **_run_through(0.0, sense)}
    return Named(Kind.EXPONENTIAL, {"origin": c0}, sizes, phase(along))


def _catenary(c0: complex, c1: complex, upward: complex, lowest: float) -> Named:
    along = -1j * upward
    sense = 1 if _dot(c1, along) > 0 else -1
    origin = c0 + c1 * lowest
    points = {"origin": origin, "vertex": origin + abs(c1) * upward}
    return Named(Kind.CATENARY, points, {"parameter": abs(c1), **_run_through(-lowest, sense)}, phase(along))


def _run_through(elapsed: float, sense: int) -> dict[str, float]:
    """Return where a segment starts and ends, `elapsed` after the curve's own zero, run through as `sense`."""
    start = sense * elapsed
    return {"start": start, "end": start + sense}


def _turned_through(start: float, sense: int) -> dict[str, float]:
    """Return the angles of a quarter turn, the lower one from 0 to less than 2π."""
    quarter = sense * pi / 2
    lower = min(start, start + quarter)
    turns = (lower + 1e-9) // tau  # just below a full turn is none
    start -= turns * tau
    return {"start": start, "end": start + quarter}


def _rightward(a: complex) -> bool:
    """Whether a direction points to the right, or straight up."""
    return a.real > 0 or (a.real == 0 and a.imag > 0)


def _dot(a: complex, b: complex) -> float:
    return a.real * b.real + a.imag * b.imag


def _cross(a: complex, b: complex) -> float:
    return a.real * b.imag - a.imag * b.real


def _perpendicular(a: complex, b: complex, tolerance: float) -> bool:
    """Whether turning the shorter of two vectors by the tolerance makes them perpendicular."""
    return abs(_dot(a, b)) <= tolerance * max(abs(a), abs(b))
