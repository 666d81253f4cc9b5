import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from spline_strategies import curves, scale

from theditor.spline import Curve, closed, join, opened, split, with_free_ends
from theditor.spline.pieces import stretch

any_curves = curves(low=-3, high=10)
open_curves = curves(closed=(False,), low=-3, high=10)
few = settings(max_examples=25, deadline=None)


def meeting(degree, turn):
    """Two clamped curves, the second starting where the first ends and turned against it by an angle."""
    a = Curve([(0, 0), (10, 8), (20, -4), (30, 6), (40, 0)], 0.5, degree, ends="clamped")
    tangent = a(a.segment_count, 1)
    angle = np.arctan2(tangent[1], tangent[0]) + turn
    across = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    b = np.array([(0, 0), (10, 0), (20, 8), (30, -5), (40, 0)]) @ across + a.control_points[-1]
    return a, Curve(b, 0.5, degree, ends="clamped")


@few
@given(open_curves)
def test_free_ends_are_the_same_curve(curve):
    free = with_free_ends(curve)
    assert free.ends == "free"
    np.testing.assert_allclose(free.sample(7), curve.sample(7), rtol=0, atol=1e-14 * scale(curve))
    if curve.segment_count > 1:
        assert free.modes == curve.modes


@few
@given(any_curves, st.data())
def test_a_stretch_is_those_segments_alone(curve, data):
    first = data.draw(st.integers(0, curve.segment_count - 1))
    last = data.draw(st.integers(first, curve.segment_count - 1))
    alone = stretch(curve, first, last)
    assert alone.segment_count == last - first + 1
    u = np.linspace(first, last + 1, 30)
    np.testing.assert_allclose(alone(u - first), curve(u), rtol=0, atol=1e-13 * scale(curve))


@few
@given(open_curves, st.data())
def test_a_split_is_exact_and_joining_undoes_it(curve, data):
    assume(curve.segment_count > 1)
    joint = data.draw(st.integers(1, curve.segment_count - 1))
    first, second, deviation = split(curve, joint)
    samples = curve.sample(8)
    atol = 1e-14 * scale(curve)
    np.testing.assert_allclose(first.sample(8), samples[: 8 * joint + 1], rtol=0, atol=atol)
    np.testing.assert_allclose(second.sample(8), samples[8 * joint :], rtol=0, atol=atol)
    assert deviation <= atol
    assert first.modes + second.modes == with_free_ends(curve).modes
    whole = join(first, second)
    np.testing.assert_array_equal(whole.curve.control_points, with_free_ends(curve).control_points)
    assert whole.deviation <= atol


@few
@given(curves(closed=(True,), low=-3, high=10), st.data())
def test_opening_is_exact_at_any_joint_and_closing_undoes_it(curve, data):
    joint = data.draw(st.integers(0, curve.segment_count - 1))
    cut = opened(curve, joint)
    expected = np.concatenate((curve.sample(6)[6 * joint : -1], curve.sample(6)[: 6 * joint + 1]))
    np.testing.assert_allclose(cut.curve.sample(6), expected, rtol=0, atol=1e-14 * scale(curve))
    assert cut.deviation <= 1e-14 * scale(curve)
    again = closed(cut.curve)
    np.testing.assert_array_equal(np.roll(again.curve.control_points, joint, axis=0), curve.control_points)
    np.testing.assert_array_equal(np.roll(again.curve.lambdas, joint), curve.lambdas)


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("ends", ["free", "clamped"])
def test_curves_apart_stay_exactly_and_a_stretch_leads_across(degree, ends):
    rng = np.random.default_rng(degree)
    a, b = (
        Curve(rng.normal(size=(6, 2)) + where, rng.uniform(-2, 3, 6), degree, ends=ends) for where in (0, 20)
    )
    joined = join(a, b)
    assert joined.deviation <= 1e-13
    assert joined.curve.ends == ends
    count = joined.curve.segment_count
    assert count == a.segment_count + b.segment_count + degree
    np.testing.assert_allclose(joined.curve([0, count]), [a(0), b(b.segment_count)], atol=1e-13)
    ring = closed(a)
    assert ring.deviation <= 1e-13
    assert ring.curve.segment_count == a.segment_count + degree


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("turn", [0.0, 1.2, np.pi / 2])
def test_ends_that_meet_become_one_joint_smooth_or_a_corner(degree, turn):
    a, b = meeting(degree, turn)
    joined = join(a, b)
    assert joined.deviation < 2
    curve, points = joined.curve, joined.curve.control_points
    assert curve.ends == "clamped"
    np.testing.assert_allclose(points[[0, -1]], [a.control_points[0], b.control_points[-1]], atol=1e-12)
    repeats = np.count_nonzero(np.abs(points - b.control_points[0]).max(axis=1) < 1e-9)
    assert (repeats == degree) == (turn > 0)


def test_a_clamped_loop_closes_without_a_seam():
    angle = np.linspace(0, 2 * np.pi, 25)
    loop = np.stack((np.cos(angle), np.sin(angle)), axis=1)
    loop[-1] = loop[0]
    ring = closed(Curve(loop, ends="clamped"))
    assert ring.curve.closed
    assert ring.curve.segment_count == 24
    np.testing.assert_allclose(np.linalg.norm(ring.curve.sample(16), axis=1), 0.99, atol=0.02)
    assert 0 < ring.deviation < 0.02


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda c, ring: split(ring, 1), "a closed curve has no two parts: open it at the joint"),
        (lambda c, ring: split(c, 0.5), "within a segment: the joints next to it are 0 and 1"),
        (lambda c, ring: split(c, 2), "u = 2 is an end of the curve"),
        (lambda c, ring: opened(c), "open already"),
        (lambda c, ring: closed(ring), "closed already"),
        (lambda c, ring: join(c, ring), "a closed curve has no end to join"),
        (lambda c, ring: join(c, c.with_(degree=2)), "must agree in degree and dimension"),
    ],
)
def test_what_makes_no_sense_is_refused(change, message):
    curve = Curve([(0, 0), (1, 2), (3, -1), (5, 1), (6, 0)])
    with pytest.raises(ValueError, match=message):
        change(curve, curve.with_(closed=True))
