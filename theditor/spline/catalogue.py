"""What there is to insert: each known curve with its parameters as a person meets them."""

from collections.abc import Callable
from math import inf
from typing import Final, Literal, NamedTuple

from theditor.spline import known
from theditor.spline.chains import MAX_SEGMENTS
from theditor.spline.curve import Curve

SMALLEST: Final = 1e-12
"""The least size worth offering: less is hardly seen beside any coordinate."""


class Parameter(NamedTuple):
    """One parameter of a function that makes a known curve."""

    keyword: str
    labels: tuple[str, ...]
    """One for each number that it consists of."""
    default: float | tuple[float, ...]
    minimum: float = -inf
    """The least value worth offering; the function itself may take less."""
    maximum: float = inf
    integer: bool = False
    nonzero: bool = False
    """Of either sign, but at least `SMALLEST` in size."""
    unit: Literal["", "radians", "quarter turns", "units"] = ""
    """What it is counted in; show radians as degrees. Lengths have no unit."""


class Known(NamedTuple):
    """A curve that can be made by its parameters."""

    name: str
    make: Callable[..., Curve]
    """Takes the parameters by keyword, and `degree` if there is a choice."""
    parameters: tuple[Parameter, ...]
    degrees: tuple[int, ...] = (3,)


_CENTRE = Parameter("centre", ("Centre x", "Centre y"), (0.0, 0.0))
_ORIGIN = Parameter("origin", ("Origin x", "Origin y"), (0.0, 0.0))
_ROTATION = Parameter("rotation", ("Rotation",), 0.0, unit="radians")


def _positive(keyword: str, label: str, default: float) -> Parameter:
    return Parameter(keyword, (label,), default, SMALLEST)


def _angle(label: str) -> Parameter:
    return Parameter("start", (label,), 0.0, unit="radians")


def _quarters(label: str, default: int) -> Parameter:
    return Parameter("quarters", (label,), default, 1, MAX_SEGMENTS, True, unit="quarter turns")


def _reach(start: float, units: int) -> tuple[Parameter, Parameter]:
    return (
        Parameter("start", ("Start at τ",), start, unit="units"),
        Parameter(
            "units", ("Length in τ",), units, 1, 50, True, unit="units"
        ),  # exp 50 is far beyond any coordinate
    )


KNOWN: Final[tuple[Known, ...]] = (
    Known(
        "Ellipse",
        known.ellipse,
        (
            _CENTRE,
            Parameter("semi_axes", ("Semi-axis a", "Semi-axis b"), (2.0, 1.0), SMALLEST),
            _ROTATION,
            _angle("Start at eccentric angle"),
            _quarters("Quarters (4: closed)", 4),
        ),
        (2, 3),
    ),
    Known(
        "Hyperbola",
        known.hyperbola,
        (
            _CENTRE,
            Parameter("semi_axes", ("Transverse semi-axis a", "Conjugate semi-axis b"), (1.0, 1.0), SMALLEST),
            _ROTATION,
            *_reach(-1.0, 2),
        ),
        (2, 3),
    ),
    Known(
        "Sine wave",
        known.sine,
        (
            _ORIGIN,
            Parameter("amplitude", ("Amplitude",), 1.0, nonzero=True),
            _positive("wavelength", "Wavelength", 4.0),
            _ROTATION,
            _angle("Start at phase"),
            _quarters("Quarter periods", 8),
        ),
    ),
    Known(
        "Cycloid",
        known.cycloid,
        (
            _ORIGIN,
            _positive("radius", "Rolling radius", 1.0),
            _ROTATION,
            _angle("Start at rolling angle"),
            _quarters("Quarter turns (4: an arch)", 4),
        ),
    ),
    Known(
        "Trochoid",
        known.trochoid,
        (
            _ORIGIN,
            _positive("radius", "Rolling radius", 1.0),
            _positive("arm", "Arm (longer: prolate, shorter: curtate)", 2.0),
            _ROTATION,
            _angle("Start at rolling angle"),
            _quarters("Quarter turns", 4),
        ),
    ),
    Known(
        "Catenary",
        known.catenary,
        (_ORIGIN, Parameter("parameter", ("Parameter a",), 1.0, nonzero=True), _ROTATION, *_reach(-1.0, 2)),
    ),
    Known(
        "Exponential curve",
        known.exponential,
        (
            _ORIGIN,
            Parameter("amplitude", ("Amplitude A",), 1.0, nonzero=True),
            Parameter("length", ("Length L of growth by e",), 1.0, nonzero=True),
            _ROTATION,
            *_reach(-3.0, 4),
        ),
    ),
    Known(
        "Helix",
        known.helix,
        (
            Parameter("centre", ("Centre x", "Centre y", "Centre z"), (0.0, 0.0, 0.0)),
            _positive("radius", "Radius", 1.0),
            Parameter("pitch", ("Pitch",), 1.0, nonzero=True),
            _angle("Start at angle"),
            _quarters("Quarter turns", 12),
        ),
    ),
)
"""Every known curve, in the order of a menu."""
