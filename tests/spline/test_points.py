import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from spline_strategies import curves

from theditor.spline import Curve, fewest_points, insert, insert_on_edge, remove
from theditor.spline.points import edge_at, insert_many

RADIUS = 100.0


def rings(degrees=(2, 3)):
    """Curves round a rough circle, of any ends, with at least nine points."""

    @st.composite
    def ring(draw):
        degree = draw(st.sampled_from(degrees))
        kind = draw(st.sampled_from(["free", "clamped", "closed"]))
        count, seed = draw(st.integers(9, 16)), draw(st.integers(0, 10**6))
        rng = np.random.default_rng(seed)
        angle = np.linspace(0, 2 * np.pi, count, endpoint=kind != "closed")
        points = np.stack((np.cos(angle), np.sin(angle), angle), axis=1) * RADIUS
        points = points[:, : draw(st.sampled_from([2, 3]))] + rng.normal(size=1) * 3
        lambdas = draw(st.sampled_from([0.0, 1.0])) if draw(st.booleans()) else rng.uniform(-2, 3, count)
        return Curve(points, lambdas, degree, kind == "closed", "free" if kind == "closed" else kind)

    return ring()


def to_polyline(points, corners):
    """Distances of points to a polyline, in all its segments."""
    start, edge = corners[:-1], np.diff(corners, axis=0)
    square = np.maximum(np.sum(edge * edge, axis=1), 1e-300)
    t = np.clip((points @ edge.T - np.sum(start * edge, axis=1)) / square, 0, 1)
    gap = points[:, None] - start - t[:, :, None] * edge
    return np.linalg.norm(gap, axis=2).min(axis=1)


def apart(a, b):
    """The Hausdorff distance between two curves, from dense samples."""
    return max(to_polyline(x.sample(30), y.sample(60)).max() for x, y in ((a, b), (b, a)))


few = settings(max_examples=12, deadline=None)


@few
@given(rings(), st.floats(0, 1))
def test_an_inserted_point_hardly_changes_the_shape_and_says_by_how_much(curve, where):
    edited = insert(curve, where * curve.segment_count)
    assert len(edited.curve.control_points) == len(curve.control_points) + 1
    assert edited.deviation <= 0.05 * RADIUS
    assert edited.deviation == pytest.approx(apart(curve, edited.curve), rel=0.02, abs=0.02)
    if not curve.closed:
        ends = [c([0, c.segment_count]) for c in (curve, edited.curve)]
        np.testing.assert_allclose(*ends, rtol=0, atol=1e-6)


@given(st.sampled_from([2, 3]), st.booleans(), st.integers(0, 39))
@few
def test_insertion_is_local_and_keeps_every_other_lambda(degree, closed, edge):
    rng = np.random.default_rng(edge)
    curve = Curve(rng.normal(size=(40, 2)).cumsum(axis=0), rng.uniform(-2, 3, 40), degree, closed)
    new = insert(curve, min(edge + 0.6, curve.segment_count)).curve
    # Points and λ of the new curve, but for seven and one of them in a row, are the old ones.
    old_points = {tuple(p) for p in curve.control_points}
    changed = [i for i, p in enumerate(new.control_points) if tuple(p) not in old_points]
    assert len(changed) <= 7
    kept_points = [p for i, p in enumerate(new.control_points) if i not in changed]
    assert all(tuple(p) in old_points for p in kept_points)
    extra = list(new.lambdas)
    for lam in curve.lambdas:
        extra.remove(lam)
    assert len(extra) == 1


@given(curves(dims=(2,), low=-2, high=3), st.data())
@few
def test_a_point_on_an_edge_moves_no_other(curve, data):
    edge = data.draw(st.integers(0, len(curve.polygon) - 2))
    new = insert_on_edge(curve, edge, 0.25).curve
    expected = 0.75 * curve.polygon[edge] + 0.25 * curve.polygon[edge + 1]
    np.testing.assert_allclose(new.control_points[edge + 1], expected, atol=1e-14)
    np.testing.assert_array_equal(np.delete(new.control_points, edge + 1, axis=0), curve.control_points)
    np.testing.assert_array_equal(np.delete(new.lambdas, edge + 1), curve.lambdas)


@few
@given(rings(), st.data())
def test_refitting_the_neighbours_of_a_removed_point_keeps_the_shape_better(curve, data):
    inner = data.draw(st.integers(1, len(curve.control_points) - 2))
    refitted, plain = remove(curve, inner), remove(curve, [inner], refit=False)
    np.testing.assert_array_equal(plain.curve.control_points, np.delete(curve.control_points, inner, axis=0))
    assert len(refitted.curve.control_points) == len(curve.control_points) - 1
    assert refitted.deviation <= plain.deviation
    for edited in refitted, plain:
        assert edited.deviation == pytest.approx(apart(curve, edited.curve), rel=0.02, abs=0.02)


@given(st.sampled_from([2, 3]), st.sampled_from(["free", "clamped", "closed"]))
def test_what_would_leave_too_few_points_is_refused(degree, kind):
    closed, ends = kind == "closed", "free" if kind == "closed" else kind
    fewest = fewest_points(degree, closed, ends)
    curve = Curve(np.random.default_rng(0).normal(size=(fewest + 1, 2)), 0, degree, closed, ends)
    assert len(remove(curve, 1).curve.control_points) == fewest
    with pytest.raises(ValueError, match=f"needs at least {fewest} control points, not {fewest - 1}"):
        remove(curve, [0, 2])


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda c: insert(c, 9), "u = 9.0 lies outside the curve's domain"),
        (lambda c: insert_on_edge(c, 4), "there is no edge 4: they run from 0 to 3"),
        (lambda c: insert_on_edge(c, 0, 1.5), "fraction must be from 0 to 1 along the edge, not 1.5"),
        (lambda c: remove(c, 5), "there is no control point 5"),
    ],
)
def test_what_makes_no_sense_is_refused_with_its_place(change, message):
    with pytest.raises(ValueError, match=message):
        change(Curve([(0, 0), (1, 2), (3, -1), (5, 1), (6, 0)]))


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("kind", ["free", "clamped", "closed"])
@pytest.mark.parametrize("every", [1, 4])
def test_many_points_are_inserted_and_removed_together(degree, kind, every):
    angle = np.linspace(0, 2 * np.pi, 120, endpoint=kind != "closed")
    points = np.stack((3 * np.cos(angle), 2 * np.sin(angle) + 0.3 * np.cos(3 * angle)), axis=1)
    lam = np.where(np.arange(120) // 30 % 2, 1.0, 0.2)
    curve = Curve(points, lam, degree, kind == "closed", "clamped" if kind == "clamped" else "free")
    places = np.arange(10, 10 + 24 * every, every) + 0.5
    more = insert_many(curve, places)
    new = np.array([edge_at(curve, u) + 1 for u in places]) + np.arange(24)
    assert len(more.curve.control_points) == 144
    assert more.deviation < 5e-3
    fewer = remove(more.curve, new)
    assert len(fewer.curve.control_points) == 120
    assert fewer.deviation < 5e-3
    for before, (after, change) in ((curve, more), (more.curve, fewer)):
        # What is told is what dense samples say, both ways, and points far from the places stay.
        a, b = before.sample(30), after.sample(30)
        gaps = np.linalg.norm(a[:, None] - b, axis=2)
        far = max(gaps.min(axis=0).max(), gaps.min(axis=1).max())
        step = max(np.linalg.norm(np.diff(x, axis=0), axis=1).max() for x in (a, b))
        assert abs(change - far) <= step / 2 + 0.05 * far
        if kind != "closed":
            ends = [c([0, c.segment_count]) for c in (before, after)]
            np.testing.assert_allclose(*ends, atol=1e-6)
    tail = edge_at(curve, places[-1]) + 6
    for other in (curve, fewer.curve):
        np.testing.assert_array_equal(other.control_points[tail:], more.curve.control_points[tail + 24 :])


def test_many_points_at_once_tell_their_progress_and_can_be_called_off():
    curve = Curve(np.random.default_rng(1).normal(size=(200, 2)).cumsum(axis=0))
    places = np.arange(10, 190, 4)
    shares, runs = [], []
    insert_many(curve, places + 0.5, shares.append)
    remove(curve, places, progress=runs.append)
    for told, most in ((shares, 1), (runs, len(places))):
        assert told == sorted(told)
        assert 0 == told[0] < told[-1] < most

    def stop(share):
        raise KeyboardInterrupt

    for edit in (
        lambda: insert_many(curve, places + 0.5, stop),
        lambda: remove(curve, places, progress=stop),
    ):
        with pytest.raises(KeyboardInterrupt):
            edit()
