"""Curvature at points of a curve, the circle it belongs to, and its energy."""

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline import joints
from theditor.spline.basis import Floats
from theditor.spline.curve import Curve
from theditor.spline.parameters import check_accuracy, clean_interval
from theditor.spline.quadrature import Derivatives, integrals, pieces
from theditor.spline.turns import cross, speed_scale, straight

Side = Literal["left", "right"]

_STILL = 4e-15  # a velocity this small beside the terms it is the sum of is none


def curvature(curve: Curve, u: ArrayLike, side: Side = "right") -> Floats:
    """Return the curvature κ at the given parameters.

    In the plane it is signed, positive where the curve turns left; in space it is not negative. It is computed
    from the first two derivatives in closed form, exact to rounding, and so takes no accuracy.

    Parameters
    ----------
    curve : Curve
    u : array_like
        Parameters within the domain.
    side : {"right", "left"}
        Which segment counts at a joint, as for the curve itself.

    Returns
    -------
    ndarray
        Of the shape of `u`, in 1 / unit of the control points; nan where the curve stands still, for then it
        has no direction to turn from.

    Raises
    ------
    ValueError
        If a parameter lies outside the domain or `side` is neither.
    """
    velocity, bend = curve(u, 1, side), curve(u, 2, side)
    speed = np.linalg.norm(velocity, axis=-1)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        # Divided first, since a product of lengths may be too small to be a number.
        direction, change = (np.moveaxis(vector, -1, 0) / speed for vector in (velocity, bend))
        turn = cross(direction, change)
        if curve.dimension == 3:
            turn = np.linalg.norm(turn, axis=0)
        return np.where(stands_still(curve, u, side), np.nan, turn / speed)


def curvature_along(curve: Curve, segments: NDArray[np.intp], t: Floats) -> tuple[Floats, Floats, Floats]:
    """Return what goes on along some segments of a plane curve, each by itself, so that jumps at joints show.

    Parameters
    ----------
    curve : Curve
    segments : ndarray of int, shape (k,)
    t : ndarray, shape (n,)

    Returns
    -------
    points : ndarray, shape (2, k, n)
    directions : ndarray, shape (2, k, n)
        Of unit length; nan where the curve stands still.
    curvature : ndarray, shape (k, n)
        As of `curvature`.
    """
    parts = joints.take_segments(curve, np.repeat(segments, len(t)))
    at = np.tile(t, len(segments))
    points, velocity, bend = (joints.evaluate(parts, at, curve.degree, nu) for nu in range(3))
    speed = np.hypot(*velocity)
    speed[speed <= _STILL * speed_scale(parts)] = np.nan
    with np.errstate(over="ignore"):
        directions = velocity / speed
        curved = cross(directions, bend / speed) / speed
    shape = len(segments), len(t)
    return points.reshape(2, *shape), directions.reshape(2, *shape), curved.reshape(shape)


def stands_still(curve: Curve, u: ArrayLike, side: Side = "right") -> NDArray[np.bool_]:
    """Return where the curve has no velocity: no more than the rounding of the terms it is the sum of."""
    places = np.asarray(u, dtype=np.float64)
    speed = np.linalg.norm(curve(places, 1, side), axis=-1)
    segment = np.floor(places) if side == "right" else np.ceil(places) - 1
    last = curve.segment_count - 1
    # Before the start of a closed curve comes its last segment.
    segment = np.where(segment < 0, last if curve.closed else 0, np.minimum(segment, last))
    parts = joints.take_segments(curve, segment.ravel().astype(np.intp))
    return np.asarray(speed <= _STILL * speed_scale(parts).reshape(places.shape))


def osculating_circle(curve: Curve, u: ArrayLike, side: Side = "right") -> tuple[Floats, Floats]:
    """Return centre and radius of the circles that touch the curve to second order.

    Parameters
    ----------
    curve : Curve
    u : array_like
        Parameters within the domain.
    side : {"right", "left"}
        Which segment counts at a joint.

    Returns
    -------
    centre : ndarray, shape (..., d)
        nan where there is no circle: the curvature is 0 or the curve stands still.
    radius : ndarray
        Of the shape of `u`; inf where the curvature is 0, nan where the curve stands still.

    Raises
    ------
    ValueError
        If a parameter lies outside the domain or `side` is neither.
    """
    velocity, bend = curve(u, 1, side), curve(u, 2, side)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        radius = 1 / np.abs(curvature(curve, u, side))
        direction = velocity / np.linalg.norm(velocity, axis=-1, keepdims=True)
        # The part of C'' across the curve points to the centre.
        across = bend - (bend * direction).sum(axis=-1, keepdims=True) * direction
        across /= np.linalg.norm(across, axis=-1, keepdims=True)
        centre = curve(u, 0, side) + across * radius[..., None]
    return np.where(np.isfinite(radius)[..., None], centre, np.nan), radius


def bending_energy(
    curve: Curve, u0: float | None = None, u1: float | None = None, accuracy: float = 1e-9
) -> float:
    """Return ∫κ² ds between two parameters.

    Parameters
    ----------
    curve : Curve
    u0, u1 : float, optional
        From where to where, u0 ≤ u1; the whole domain by default.
    accuracy : float
        Largest error, relative to the energy.

    Returns
    -------
    float
        In 1 / unit of the control points; inf if there is a cusp. Segments that are straight to rounding,
        and a corner where the curve stands still, add nothing.

    Raises
    ------
    ValueError
        If a parameter lies outside the domain, u1 is less than u0, or `accuracy` is not a positive number.
    """
    check_accuracy(accuracy)
    segments, start, end = pieces(*clean_interval(curve, u0, u1))
    bent = ~straight(joints.take_segments(curve, segments), curve.degree)
    return float(integrals(curve, segments[bent], start[bent], end[bent], _energy, accuracy).sum())


def _energy(derivatives: Derivatives) -> Floats:
    velocity = derivatives(1)
    turn = cross(velocity, derivatives(2))
    turned = turn**2 if turn.ndim == 2 else (turn**2).sum(axis=0)
    speed = np.sqrt((velocity**2).sum(axis=0))
    energy: Floats = turned / speed**5
    return energy
