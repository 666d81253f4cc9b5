import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from theditor.spline import (
    JOINT_SLOPE_ZERO,
    Curve,
    arc_length,
    intersections,
    known,
    nearest,
    self_intersections,
)
from theditor.spline.crossings import meeting_boxes

LINE = Curve([(-3, 0), (3, 0)], ends="clamped")
EIGHT = Curve([(-2, -1), (2, 1), (2, -1), (-2, 1)], 0.0, 2, closed=True)
TURN = np.array([(np.cos(0.3), np.sin(0.3)), (-np.sin(0.3), np.cos(0.3))])


def line(start, end):
    return Curve([start, end], ends="clamped")


def turned(curve):
    return curve.with_(control_points=curve.control_points @ TURN)


def chord_crossings(a, b, same=False, closed=False):
    """Where two polygons cross, as (index + fraction) pairs, each chord against each."""
    start, other = a[:-1, None], b[None, :-1]
    along, across = np.diff(a, axis=0)[:, None], np.diff(b, axis=0)[None]
    gap = other - start

    def cross(v, w):
        return v[..., 0] * w[..., 1] - v[..., 1] * w[..., 0]

    with np.errstate(divide="ignore", invalid="ignore"):
        s, t = cross(gap, across) / cross(along, across), cross(gap, along) / cross(along, across)
    hit = (s >= 0) & (s < 1) & (t >= 0) & (t < 1)
    if same:
        i, j = np.indices(hit.shape)
        hit &= (j - i > 1) & ~(closed & (j - i == len(a) - 2))
    i, j = np.nonzero(hit)
    return np.stack((i + s[i, j], j + t[i, j]), axis=1)


@st.composite
def scattered(draw):
    """Plane curves through random places, without the coincidences that a search for small examples likes."""
    degree, closed = draw(st.sampled_from([2, 3])), draw(st.booleans())
    count = draw(st.integers(4, 10))
    generator = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    low, high = draw(st.sampled_from([(0, 1), (-2, 9), (-20, 12)]))
    points, lambdas = generator.normal(size=(count, 2)), generator.uniform(low, high, count)
    return Curve(points, lambdas, degree, closed)


def agree(found, expected, reach):
    """Each of the one is near one of the other, as many of each."""
    assert len(found) == len(expected)
    if len(found):
        apart = np.abs(found[:, None] - expected[None]).max(axis=2)
        assert apart.min(axis=0).max() < reach
        assert apart.min(axis=1).max() < reach


def seen_by_chords(found, loops=np.inf):
    """Crossings without those that chords cut off: pairs where curves barely overlap, and small loops."""
    apart = np.abs(found[:, None] - found[None]).max(axis=2) + np.eye(len(found))
    return found[(apart.min(axis=1, initial=1) > 0.03) & (loops > 0.03)]


def loops(found, curve):
    """How long the loops between crossings are, the shorter way round, in u."""
    span = found[:, 1] - found[:, 0]
    return np.minimum(span, curve.segment_count - span) if curve.closed else span


@settings(max_examples=40)
@given(scattered())
def test_a_curve_crosses_itself_where_its_samples_polygon_does(curve):
    n = 200
    found = self_intersections(curve)
    expected = chord_crossings(*2 * [curve.sample(n)], True, curve.closed) / n
    agree(*(seen_by_chords(c, loops(c, curve)) for c in (found, expected)), 0.01)
    assert (found[:, 0] < found[:, 1]).all()
    np.testing.assert_allclose(curve(found[:, 0]), curve(found[:, 1]), atol=1e-12 * 20)


@settings(max_examples=40)
@given(scattered(), scattered())
def test_two_curves_cross_where_their_samples_polygons_do(a, b):
    assume(a.control_points[0, 0] != b.control_points[0, 0])  # else they may run along each other
    n = 200
    found = intersections(a, b)
    expected = chord_crossings(a.sample(n), b.sample(n)) / n
    agree(seen_by_chords(found), seen_by_chords(expected), 0.01)
    np.testing.assert_allclose(a(found[:, 0]), b(found[:, 1]), atol=1e-12 * 20)
    agree(intersections(b, a)[:, ::-1], found, 1e-9)


@settings(max_examples=20)
@given(scattered(), st.floats(0.1, 100), st.floats(-50, 50))
def test_crossings_move_with_the_curve(curve, factor, shift):
    moved = curve.with_(control_points=curve.control_points @ TURN * factor + shift)
    agree(self_intersections(moved), self_intersections(curve), 1e-7)


def test_the_beginning_of_a_long_curve_crosses_itself_as_if_it_were_alone():
    generator = np.random.default_rng(3)
    points = np.cumsum(generator.normal(size=(5000, 2)) + (0.5, 0), axis=0)
    lambdas = generator.uniform(-2, 9, 5000)
    found = self_intersections(Curve(points, lambdas), 1e-12)
    alone = self_intersections(Curve(points[:303], lambdas[:303]), 1e-12)
    assert len(alone) > 20
    agree(found[found[:, 1] < 300], alone, 1e-9)


def test_a_figure_of_eight_crosses_in_its_middle():
    for curve in (EIGHT, turned(EIGHT), EIGHT.with_(degree=3)):
        found = self_intersections(curve)
        assert len(found) == 1
        assert arc_length(curve, *found[0]) == pytest.approx(arc_length(curve) / 2)
        np.testing.assert_allclose(curve(found[0]), 0, atol=1e-14)


def test_joints_seams_and_cusps_are_no_crossings():
    for curve in (
        known.ellipse(),
        known.ellipse(degree=2),
        known.cycloid(quarters=12),
        turned(known.cycloid(quarters=12)),
        Curve([(0, 0), (1, 2), (3, -1), (4, 1), (6, 0)], JOINT_SLOPE_ZERO, 2),
        Curve([(0, 0), (0, 0), (0, 0), (1, 0), (1, 1), (1, 1), (3, 1)], 0.5, 2),  # with a corner
        Curve([(1, 1)] * 5),
    ):
        assert self_intersections(curve).shape == (0, 2)


def test_beyond_its_cusps_a_trochoid_makes_loops():
    found = self_intersections(known.trochoid(radius=1, arm=2, quarters=12))
    np.testing.assert_allclose(found.sum(axis=1), 2 * np.round(found.sum(axis=1) / 2), atol=1e-12)
    assert len(self_intersections(known.trochoid(radius=1, arm=0.99, quarters=12))) == 0
    assert len(found) >= 2


def test_a_loop_far_smaller_than_its_segment_is_seen():
    barely = Curve([(0, 0), (1, 2), (3, -1), (4, 1), (6, 0)], JOINT_SLOPE_ZERO - 0.02, 2)
    n = 20_000
    near = barely(np.linspace(0.9, 1.1, n + 1))
    expected = chord_crossings(*2 * [near[n // 2 - 800 : n // 2 + 801]], True)
    found = self_intersections(barely)
    assert len(found[np.abs(found - 1).max(axis=1) < 0.1]) == len(expected)


def test_an_ellipse_and_a_line_meet_twice_once_or_not_at_all():
    ellipse = known.ellipse()
    for curve, a, b in ((ellipse, (-3, 0.5), (3, 0.5)), (ellipse, (-1, -2), (-1, 2))):
        assert len(intersections(curve, line(a, b))) == 2
        assert len(intersections(turned(curve), turned(line(a, b)))) == 2
    for degree in (2, 3):
        for carried in (lambda c: c, turned):
            touched = carried(known.ellipse(degree=degree))
            found = intersections(touched, carried(line((-3, 1), (3.5, 1))))
            assert len(found) == 1
            np.testing.assert_allclose(touched(found[0, 0]), carried(line((0, 1), (1, 1)))(0), atol=1e-4)
            assert len(intersections(touched, carried(line((-3, 1 + 1e-6), (3, 1 + 1e-6))))) == 0
            assert len(intersections(touched, carried(line((-3, 1 - 1e-6), (3, 1 - 1e-6))))) == 2


def test_touching_curves_meet_once_even_at_a_seam():
    one, other = known.ellipse(), known.ellipse((4, 0))
    for a, b in ((one, other), (other, one), (turned(one), turned(other))):
        ((u, v),) = intersections(a, b)
        np.testing.assert_allclose(a(u), b(v), atol=1e-8)
        assert abs(a(u) @ np.linalg.inv(TURN) @ (1, 0) - 2) < 1e-4 or abs(a(u)[0] - 2) < 1e-4


def test_a_line_that_ends_on_a_curve_meets_it():
    ellipse = known.ellipse()
    found = intersections(ellipse, line((2, 0), (5, 1)))
    assert len(found) == 1
    assert found[0, 1] == pytest.approx(0, abs=1e-9)
    cycloid = known.cycloid(quarters=12)
    ((u, _),) = intersections(cycloid, line(cycloid(4), cycloid(4) + np.array([0, -1.0])))  # at a cusp
    assert u == pytest.approx(4, abs=1e-3)


def test_stretches_run_along_twice_are_given_once():
    ((u, v),) = intersections(LINE, line((0, 0), (5, 0)))
    np.testing.assert_allclose(LINE(u), line((0, 0), (5, 0))(v), atol=1e-9)
    assert len(intersections(known.ellipse(), known.ellipse(degree=2))) == 1
    twice = known.ellipse(degree=2).control_points
    assert len(self_intersections(Curve(np.tile(twice, (2, 1)), 0.0, 2, closed=True))) == 1
    back_and_forth = Curve(np.outer([0, 3, 1, 2, 0, 5], (1, 2)))
    assert len(self_intersections(back_and_forth)) == 0


@given(
    arrays(np.float64, (2, 23, 2), elements=st.floats(0, 1)),
    arrays(np.float64, (2, 7, 2), elements=st.floats(0, 1)),
    st.floats(0, 0.2),
)
def test_all_meeting_boxes_are_found(first, second, size):
    a, b = ((corner[0].T, corner[0].T + size) for corner in (first, second))

    def meet(i, j, other):
        return bool(((a[0][:, i] <= other[1][:, j]) & (other[0][:, j] <= a[1][:, i])).all())

    def pairs(chunks):
        return sorted((int(i), int(j)) for chunk in chunks for i, j in zip(*chunk, strict=True))

    assert pairs(meeting_boxes(a, b)) == [(i, j) for i in range(23) for j in range(7) if meet(i, j, b)]
    assert pairs(meeting_boxes(a)) == [(i, j) for i in range(23) for j in range(i, 23) if meet(i, j, a)]


def test_space_curves_are_refused():
    helix = Curve([(0, 0, 0), (1, 1, 0), (2, 0, 1), (3, 1, 1)])
    with pytest.raises(ValueError, match="self-intersections need a plane curve"):
        self_intersections(helix)
    with pytest.raises(ValueError, match="intersections need a plane curve"):
        intersections(LINE, helix)
    with pytest.raises(ValueError, match="accuracy must be a positive number"):
        intersections(LINE, LINE, np.nan)


def test_an_overlap_is_told_from_a_crossing_by_directions_and_what_lies_beside_it():
    whole, arc = known.ellipse(), known.ellipse(start=0.3, quarters=2)
    (place,) = intersections(whole, arc)
    u, v = place
    one, other = whole(u, 1), arc(v, 1)
    assert abs(one[0] * other[1] - one[1] * other[0]) <= 1e-6 * np.linalg.norm(one) * np.linalg.norm(other)
    beside = whole(np.array([u - 0.01, u + 0.01]))
    assert nearest(arc, beside)[1].max() < 1e-12
    touching = known.ellipse((4, 0))
    (place,) = intersections(whole, touching)
    assert nearest(touching, whole(np.array([place[0] + 0.01])))[1] > 1e-6
