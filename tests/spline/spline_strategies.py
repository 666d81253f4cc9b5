"""Curves at random, the exactness asked of them, and a plain reference to judge them by."""

import numpy as np
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from theditor.spline import INTERPOLATING, Curve, basis, fewest_points

LIMITS = (1e-15, 1e-14, 1e-14, 1e-14)  # of values and of derivatives

coordinates = st.floats(-10, 10, allow_subnormal=False)


def lambdas_for(degree: int, low: float = -30, high: float = 30):
    landmarks = [x for x in (0.0, 1.0, 0.5, INTERPOLATING[degree]) if low <= x <= high]
    return st.one_of(st.sampled_from(landmarks), st.floats(low, high, allow_subnormal=False))


@st.composite
def curves(
    draw, degrees=(2, 3), closed=(False, True), ends=("free", "clamped"), dims=(2, 3), low=-30, high=30
):
    degree, is_closed, end = (draw(st.sampled_from(choice)) for choice in (degrees, closed, ends))
    count = draw(st.integers(fewest_points(degree, is_closed, end), 9))
    points = draw(arrays(np.float64, (count, draw(st.sampled_from([2, 3]))), elements=coordinates))
    lambdas = draw(arrays(np.float64, count, elements=lambdas_for(degree, low, high)))
    return Curve(points, lambdas, degree, is_closed, end)


def scale(curve: Curve) -> float:
    """What errors are relative to."""
    return max(1e-300, np.abs(curve.control_points).max()) * max(1.0, np.abs(curve.lambdas).max())


def defining_points(curve: Curve) -> np.ndarray:
    """The control points of each segment, (segments, degree + 1, d), reflected ones included."""
    points, degree = curve.control_points, curve.degree
    if curve.closed:
        points = np.concatenate((points[-1:], points, points[: degree - 1]))
    elif curve.ends == "clamped":
        before, after = 2 * points[0] - points[1], 2 * points[-1] - points[-2]
        inner = points[1:-1] if degree == 2 else points
        points = np.concatenate(([before], inner, [after]))
    return np.stack([points[s : s + degree + 1] for s in range(len(points) - degree)])


def plainly(curve: Curve, segment: int, t: float, nu: int = 0) -> np.ndarray:
    """A point of the curve as the definition has it: basis functions times control points."""
    where = np.arange(segment, segment + 2) + curve.first_segment
    start, end = curve.lambdas[where % len(curve.control_points)]
    return basis(t, start, end, curve.degree, nu) @ defining_points(curve)[segment]
