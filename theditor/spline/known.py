"""Curves with a name, exactly: ellipse, hyperbola, sine wave, cycloid, trochoid, catenary, exponential, helix.

All angles are in radians. `start` picks where on the curve to begin; trigonometric curves come in quarter
turns, hyperbolic ones in units of τ. Source: J. Xie, Mathematical Problems in Engineering 2014, 242469, whose
printed control points carry misprints; these are derived anew.
"""

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from theditor.spline.basis import Floats
from theditor.spline.chains import clean_numbers, hyperbolic, listed, trigonometric, turn
from theditor.spline.curve import Curve

_LEAST: Final = float(np.finfo(np.float64).tiny)  # sizes below it have lost digits


def ellipse(
    centre: Sequence[float] = (0.0, 0.0),
    semi_axes: Sequence[float] = (2.0, 1.0),
    rotation: float = 0.0,
    start: float = 0.0,
    quarters: int = 4,
    degree: int = 3,
) -> Curve:
    """Return an ellipse (a cos τ, b sin τ), whole or an arc of some quarter turns.

    Parameters
    ----------
    centre : (x, y)
    semi_axes : (a, b)
        Both positive; equal ones give a circle.
    rotation : float
        Angle from the x-axis to the first semi-axis.
    start : float
        Eccentric angle τ to begin at.
    quarters : int
        Number of segments, each a quarter turn of τ. Four give the closed ellipse, any other number an open
        curve with free ends.
    degree : {2, 3}

    Raises
    ------
    ValueError
        If a semi-axis is not positive, a number is not finite, or there are too few or too many quarters.
    """
    a, b = _positive(semi_axes, "semi-axes", 2)
    middle = clean_numbers(centre, "centre", 2)
    along, across = _frame(rotation)
    arc = trigonometric(middle, 0 * middle, a * along, b * across, quarters, _quarters(start), degree)
    if quarters != 4:
        return arc
    return Curve(arc.control_points[1:5], arc.lambdas[1:5], degree, closed=True)  # they repeat after four


def hyperbola(
    centre: Sequence[float] = (0.0, 0.0),
    semi_axes: Sequence[float] = (1.0, 1.0),
    rotation: float = 0.0,
    start: float = -1.0,
    units: int = 2,
    degree: int = 3,
) -> Curve:
    """Return an arc (a cosh τ, b sinh τ) of one branch of a hyperbola.

    Parameters
    ----------
    centre : (x, y)
    semi_axes : (a, b)
        Transverse and conjugate, both positive; equal ones give a rectangular hyperbola.
    rotation : float
        Angle from the x-axis to the vertex of this branch; π gives the other one.
    start : float
        The τ to begin at; 0 is the vertex.
    units : int
        Number of segments, each one unit of τ.
    degree : {2, 3}

    Raises
    ------
    ValueError
        If a semi-axis is not positive, a number is not finite, or the arc is too long.
    """
    a, b = _positive(semi_axes, "semi-axes", 2)
    middle = clean_numbers(centre, "centre", 2)
    along, across = _frame(rotation)
    return hyperbolic(middle, 0 * middle, a * along, b * across, units, start, degree)


def sine(
    origin: Sequence[float] = (0.0, 0.0),
    amplitude: float = 1.0,
    wavelength: float = 4.0,
    rotation: float = 0.0,
    start: float = 0.0,
    quarters: int = 8,
) -> Curve:
    """Return a sine wave (ℓτ/2π, A sin τ), a cubic.

    Parameters
    ----------
    origin : (x, y)
        The point of phase τ = 0.
    amplitude, wavelength : float
        A, not zero, and ℓ, positive. A negative amplitude begins downwards.
    rotation : float
        Angle from the x-axis to the wave's axis.
    start : float
        Phase τ to begin at.
    quarters : int
        Number of segments, each a quarter of the wavelength.

    Raises
    ------
    ValueError
        If a size is senseless, a number is not finite, or there are too few or too many quarters.
    """
    height = _nonzero(amplitude, "amplitude")
    (length,) = _positive(wavelength, "wavelength")
    along, across = _frame(rotation)
    return trigonometric(
        clean_numbers(origin, "origin", 2),
        length / 4 * along,
        0 * along,
        height * across,
        quarters,
        _quarters(start),
    )


def cycloid(
    origin: Sequence[float] = (0.0, 0.0),
    radius: float = 1.0,
    rotation: float = 0.0,
    start: float = 0.0,
    quarters: int = 4,
) -> Curve:
    """Return a cycloid r(τ − sin τ, 1 − cos τ), a cubic: the path of a point on a rolling circle's rim.

    Parameters
    ----------
    origin : (x, y)
        The cusp at τ = 0, on the line rolled on.
    radius : float
        Radius r of the rolling circle, positive.
    rotation : float
        Angle from the x-axis to that line.
    start : float
        Angle τ rolled through at the beginning.
    quarters : int
        Number of segments, each a quarter turn of the circle; four make an arch.

    Raises
    ------
    ValueError
        If the radius is not positive, a number is not finite, or there are too few or too many quarters.
    """
    return trochoid(origin, radius, radius, rotation, start, quarters)


def trochoid(
    origin: Sequence[float] = (0.0, 0.0),
    radius: float = 1.0,
    arm: float = 2.0,
    rotation: float = 0.0,
    start: float = 0.0,
    quarters: int = 4,
) -> Curve:
    """Return a trochoid (rτ − a sin τ, r − a cos τ), a cubic: the path of a point of a rolling wheel.

    An arm longer than the radius makes it prolate, with loops; a shorter one curtate, without cusps.

    Parameters
    ----------
    origin : (x, y)
        Where the circle touches the line that it rolls on at τ = 0.
    radius, arm : float
        Radius r of the rolling circle and distance a of the point from its centre, both positive.
    rotation : float
        Angle from the x-axis to that line.
    start : float
        Angle τ rolled through at the beginning.
    quarters : int
        Number of segments, each a quarter turn of the circle.

    Raises
    ------
    ValueError
        If a size is not positive, a number is not finite, or there are too few or too many quarters.
    """
    (r,) = _positive(radius, "radius")
    (a,) = _positive(arm, "arm")
    along, across = _frame(rotation)
    foot = clean_numbers(origin, "origin", 2)
    return trigonometric(
        foot + r * across, r * np.pi / 2 * along, -a * across, -a * along, quarters, _quarters(start)
    )


def catenary(
    origin: Sequence[float] = (0.0, 0.0),
    parameter: float = 1.0,
    rotation: float = 0.0,
    start: float = -1.0,
    units: int = 2,
) -> Curve:
    """Return a catenary a(τ, cosh τ), a cubic: y = a cosh(x/a).

    Parameters
    ----------
    origin : (x, y)
        The point of the directrix below the vertex, at the distance |a| from it.
    parameter : float
        The size a, not zero; negative for an arch.
    rotation : float
        Angle from the x-axis to the directrix.
    start : float
        The τ to begin at; 0 is the vertex.
    units : int
        Number of segments, each one unit of τ.

    Raises
    ------
    ValueError
        If the parameter is zero, a number is not finite, or the arc is too long.
    """
    a = _nonzero(parameter, "parameter")
    along, across = _frame(rotation)
    return hyperbolic(clean_numbers(origin, "origin", 2), a * along, a * across, 0 * along, units, start)


def exponential(
    origin: Sequence[float] = (0.0, 0.0),
    amplitude: float = 1.0,
    length: float = 1.0,
    rotation: float = 0.0,
    start: float = -3.0,
    units: int = 4,
) -> Curve:
    """Return an exponential curve (Lτ, A exp τ), a cubic: y = A exp(x/L).

    Parameters
    ----------
    origin : (x, y)
        The point of the asymptote below the one of height A.
    amplitude, length : float
        A and L, not zero; over each length L the curve grows by the factor e. A negative L makes it fall.
    rotation : float
        Angle from the x-axis to the asymptote.
    start : float
        The τ to begin at.
    units : int
        Number of segments, each one unit of τ.

    Raises
    ------
    ValueError
        If a size is zero, a number is not finite, or the curve is too long.
    """
    height = _nonzero(amplitude, "amplitude")
    step = _nonzero(length, "length")
    along, across = _frame(rotation)
    rise = height * across
    return hyperbolic(clean_numbers(origin, "origin", 2), step * along, rise, rise, units, start)


def helix(
    centre: Sequence[float] = (0.0, 0.0, 0.0),
    radius: float = 1.0,
    pitch: float = 1.0,
    start: float = 0.0,
    quarters: int = 12,
) -> Curve:
    """Return a helix (r cos τ, r sin τ, hτ/2π) about the vertical, a cubic in space.

    Parameters
    ----------
    centre : (x, y, z)
        The point of the axis at the height of τ = 0.
    radius : float
        The distance r from the axis, positive.
    pitch : float
        The rise h in one turn, not zero; negative for a left-handed helix.
    start : float
        Angle τ to begin at.
    quarters : int
        Number of segments, each a quarter turn.

    Raises
    ------
    ValueError
        If a size is senseless, a number is not finite, or there are too few or too many quarters.
    """
    (r,) = _positive(radius, "radius")
    x, y, z = np.eye(3)
    climb = _nonzero(pitch, "pitch") / 4 * z
    return trigonometric(clean_numbers(centre, "centre", 3), climb, r * x, r * y, quarters, _quarters(start))


def _quarters(angle: float) -> float:
    (radians,) = clean_numbers(angle, "start")
    return float(radians / (np.pi / 2))


def _frame(rotation: float) -> tuple[Floats, Floats]:
    """Return the unit vectors of the axes turned by an angle."""
    (cosine,), (sine,) = turn(clean_numbers(rotation, "rotation") / (np.pi / 2))
    return np.array([cosine, sine]), np.array([-sine, cosine])


def _positive(values: ArrayLike, what: str, count: int = 1) -> Floats:
    numbers = clean_numbers(values, what, count)
    if not (numbers >= _LEAST).all():
        raise ValueError(f"{what} must be positive, not {listed(numbers)}: give at least {_LEAST:g}")
    return numbers


def _nonzero(value: float, what: str) -> float:
    (number,) = clean_numbers(value, what)
    if abs(number) < _LEAST:
        raise ValueError(
            f"{what} must not be zero, nor below {_LEAST:g} in size: the curve would be a straight line or a circle"
        )
    return float(number)
