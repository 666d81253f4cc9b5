import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from theditor.spline import Curve, fit, nearest
from theditor.spline.fit import LIKE_POLYNOMIALS

few = settings(max_examples=6, deadline=None)
degrees = pytest.mark.parametrize("degree", [2, 3])


def to_polyline(points, corners):
    start, edge = corners[:-1], np.diff(corners, axis=0)
    square = np.maximum(np.sum(edge * edge, axis=1), 1e-300)
    t = np.clip((points @ edge.T - np.sum(start * edge, axis=1)) / square, 0, 1)
    return np.linalg.norm(points[:, None] - start - t[:, :, None] * edge, axis=2).min(axis=1)


def missed(stroke, curve):
    """How far the stroke's points are from the curve, or the curve from the polyline."""
    line = np.concatenate((stroke, stroke[:1])) if curve.closed else stroke
    return max(nearest(curve, stroke)[1].max(), to_polyline(curve.sample(100), line).max())


def wave(count=200, noise=0.0, seed=0):
    t = np.linspace(0, 1, count)
    stroke = np.stack((600 * t, 80 * np.sin(14 * t)), axis=1)
    return stroke + np.random.default_rng(seed).uniform(-noise, noise, stroke.shape)


@few
@given(st.sampled_from([2, 3]), st.sampled_from([1.5, 3.0, 8.0]), st.integers(0, 10**6), st.booleans())
def test_a_shaky_stroke_is_met_within_the_tolerance_by_few_points(degree, tolerance, seed, shape):
    stroke = np.round(wave(noise=0.4, seed=seed))  # as a mouse has it, in whole pixels
    curve, deviation = fit(stroke, degree, tolerance, shape=shape)
    assert deviation <= tolerance
    assert deviation == pytest.approx(missed(stroke, curve), rel=0.02)
    assert len(curve.control_points) <= 24
    np.testing.assert_allclose(curve([0, curve.segment_count]), stroke[[0, -1]], atol=1e-12)
    assert shape or not curve.lambdas.any()


@few
@given(st.sampled_from([2, 3]), st.sampled_from([0.0, 0.5, 1.0]), st.integers(0, 10**6))
def test_samples_of_a_known_curve_give_no_more_points_than_it_has(degree, lam, seed):
    angle = np.linspace(0, 5, 9)
    points = np.stack((np.cos(angle), np.sin(angle)), axis=1) * 100
    points += np.random.default_rng(seed).uniform(-8, 8, points.shape)
    known = Curve(points, lam, degree, ends="clamped")
    curve, deviation = fit(known.sample(40), degree, 1.0)
    assert deviation <= 1.0
    assert len(curve.control_points) <= 9


@degrees
def test_shape_parameters_save_points(degree):
    angle = np.linspace(0, 2 * np.pi, 200)
    ring = np.stack((np.cos(angle), np.sin(angle)), axis=1) * 100
    bent, plain = (fit(ring, degree, 1.0, closed=True, shape=shape) for shape in (True, False))
    assert bent.deviation <= 1
    assert (len(bent.curve.control_points), len(plain.curve.control_points)) == (3, 4)
    assert bent.curve.lambdas.all()


@degrees
def test_a_circle_is_a_closed_curve_of_few_points_in_the_plane_and_in_space(degree):
    angle = np.linspace(0, 2 * np.pi, 200)
    for stroke in (
        np.stack((np.cos(angle), np.sin(angle)), axis=1),
        np.stack((np.cos(angle), np.sin(angle), np.cos(angle)), axis=1),
    ):
        curve, deviation = fit(stroke, degree, 0.01, closed=True)
        assert curve.closed
        assert deviation <= 0.01
        assert len(curve.control_points) <= 4


@degrees
@pytest.mark.parametrize("ends", ["clamped", "free"])
def test_straight_strokes_are_straight_curves_with_the_fewest_points(degree, ends):
    line = np.linspace((0, 0), (300, 100), 80)
    for stroke in (line, line[[0, -1]], np.repeat(line, 3, axis=0)):
        curve, deviation = fit(stroke, degree, 1.0, ends=ends)
        assert deviation < 1e-9
        assert curve.ends == ends
        assert len(curve.control_points) == {"clamped": 5 - degree, "free": {2: 3, 3: 4}[degree]}[ends]


@degrees
def test_corners_stay_corners_unless_they_are_to_be_rounded(degree):
    side = np.linspace(0, 1, 40)[:-1, None]
    tips = np.array([(0.0, 0.0), (200, 0), (200, 150), (0, 150)])
    square = np.concatenate(
        [a + side * (b - a) for a, b in zip(tips, np.roll(tips, -1, axis=0), strict=True)]
    )
    # Begun in the middle of a side, closed and open.
    for stroke, closed in ((np.roll(square, 20, axis=0), True), (square, False)):
        curve, deviation = fit(stroke, degree, 1.0, closed=closed)
        assert deviation < 1e-9
        for tip in tips if closed else tips[1:]:
            assert np.count_nonzero(np.linalg.norm(curve.control_points - tip, axis=1) < 1e-9) == degree
        assert len(curve.control_points) == (4 * degree if closed else 3 * degree + 2)
    rounded = fit(square, degree, 4.0, closed=True, corners=False)
    assert 0 < rounded.deviation <= 4
    assert len(np.unique(rounded.curve.control_points, axis=0)) == len(rounded.curve.control_points)


@few
@given(st.lists(st.tuples(st.integers(0, 40), st.integers(0, 40)), min_size=2, max_size=30), st.booleans())
@example([(14, 0), (0, 8), (16, 11), (7, 9)], True)
def test_any_scribble_gives_a_curve_and_its_true_deviation(scribble, closed):
    if len(set(scribble)) < 3:
        return
    curve, deviation = fit(scribble, 3, 2.0, closed=closed)
    stroke = np.array(scribble, dtype=float)
    if curve.segment_count < 200:
        assert deviation == pytest.approx(missed(stroke, curve), rel=0.05, abs=0.02)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([(0, 0), (0, 0)],), "an open stroke needs at least 2 different points"),
        (([(0, 0), (1, 1), (0, 0)], 3, 1.0, True), "a closed stroke needs at least 3 different points"),
        (([(0, 0), (1, np.nan)],), "control point 1: y is nan"),
        (([(0, 0), (1, 1)], 3, 0.0), "tolerance must be a positive number, not 0.0"),
        (([(0, 0), (1, 1)], 4), "degree must be 2 or 3"),
        (([(0, 0), (1, 1)], 3, 1.0, False, "loose"), 'ends must be "free" or "clamped"'),
    ],
)
def test_what_makes_no_sense_is_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        fit(*arguments)


@degrees
def test_corners_given_are_met_exactly_and_nothing_else_is_one(degree):
    square = np.array([(0.0, 0), (4, 0), (4, 3), (0, 3)])
    curve, deviation = fit(square, degree, 0.01, closed=True, corners=range(4))
    assert deviation < 1e-12
    assert len(curve.control_points) == 4 * degree
    assert np.hypot(*(curve.joints[:, None] - square).T).min(axis=1).max() < 1e-12
    smooth, _ = fit(square, degree, 0.5, closed=True, corners=[])
    assert np.hypot(*(smooth.joints[:, None] - square).T).min() > 0.01
    for corners in ([1, 0], [0, 0], [4], [-1]):
        with pytest.raises(ValueError, match="ascending indices from 0 to 3"):
            fit(square, degree, corners=corners, closed=True)
    with pytest.raises(ValueError, match="no point may repeat"):
        fit([(0, 0), (1, 0), (1, 0), (1, 1)], degree, corners=[2])


def test_free_ends_and_a_polynomial_like_lambda_need_few_points_for_a_tight_tolerance():
    t = np.linspace(0, 1, 400)
    arch = np.stack((100 * t, 120 * t * (1 - t)), axis=1)
    free, clamped = (
        fit(arch, 3, 0.01, ends=ends, shape=False, lam=LIKE_POLYNOMIALS[3]) for ends in ("free", "clamped")
    )
    assert free.curve.ends == "free"
    assert free.deviation <= 0.01
    assert free.deviation == pytest.approx(missed(arch, free.curve), rel=0.05)
    assert len(free.curve.control_points) <= 6 < len(clamped.curve.control_points)
    np.testing.assert_allclose(free.curve([0, free.curve.segment_count]), arch[[0, -1]], atol=1e-12)
    quadratic, _ = fit(arch, 2, 0.01, shape=False, lam=LIKE_POLYNOMIALS[2])
    assert len(quadratic.control_points) <= 9
