"""Bounds of how far segments stray from their chords, and of how fast they are run through."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from theditor.spline import INTERPOLATING, Curve
from theditor.spline.flatness import flatness

T = np.linspace(0, 1, 41)


@st.composite
def curves(draw):
    degree = draw(st.sampled_from([2, 3]))
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    count = draw(st.integers(degree + 1, 12))
    points = rng.normal(size=(count, 2)) * 10.0 ** draw(st.integers(-6, 6))
    if draw(st.booleans()):
        points[1:] = points[0]
    lambdas = rng.choice([0.0, 1.0, INTERPOLATING[degree], -16.0, 10.0, 1e6], count)
    ends = draw(st.sampled_from(["free", "clamped"]))
    return Curve(points + draw(st.sampled_from([0.0, 1e9])), lambdas, degree, draw(st.booleans()), ends)


def from_line(points, start, end):
    along = end - start
    squares = np.maximum((along**2).sum(axis=-1, keepdims=True), 1e-300)
    t = (((points - start) * along).sum(axis=-1, keepdims=True) / squares).clip(0, 1)
    return np.hypot(*np.moveaxis(points - start - t * along, -1, 0)).max(axis=1)


@given(curves())
def test_bounds_hold_and_are_not_far_above_the_truth(curve):
    measured = flatness(curve.joint_form, curve.degree)
    u = np.arange(curve.segment_count)[:, None] + T
    points = curve(u.ravel().clip(0, np.nextafter(curve.segment_count, 0))).reshape(*u.shape, 2)
    start, end = measured.start.T[:, None], measured.end.T[:, None]
    size = np.abs(points).max()
    rounding = 1e-13 * size + 1e-6 * np.ptp(points, axis=1).max(axis=1)
    assert np.abs(points[:, :1] - start).max() <= 1e-12 * size
    assert np.abs(points[:, -1:] - end).max() <= 1e-12 * size
    away = from_line(points, start, end)
    assert (away <= measured.stray + rounding).all()
    assert (measured.stray <= 1.5 * away + measured.turning / 400 + rounding).all()
    fast = np.hypot(*np.diff(points, axis=1).T * (len(T) - 1)).max(axis=0)
    assert (fast <= measured.speed * (1 + 1e-6) + 100 * rounding).all()
    assert (measured.speed <= fast + measured.turning / 14 + 100 * rounding).all()
