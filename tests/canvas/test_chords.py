"""Level of detail: the lines in place of segments stay with the curves, and none that shows is missing."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from theditor.canvas import segment_table
from theditor.canvas.chords import MIXED, ChordTree
from theditor.canvas.raster import Raster
from theditor.canvas.trace import strokes, traced
from theditor.canvas.viewport import Viewport
from theditor.spline import INTERPOLATING, Curve

coordinates = st.floats(-6, 8)
WINDOW = np.array([-3.0, -2.5]), np.array([4.0, 5.0])
PLANE = Raster(np.zeros((2, 1)), np.ones((2, 1)), np.zeros((2, 1)))


@st.composite
def curves(draw):
    degree = draw(st.sampled_from([2, 3]))
    count = draw(st.integers(degree + 1, 24))
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    points = rng.normal(scale=0.4, size=(count, 2)).cumsum(axis=0)
    lambdas = rng.choice([0.0, 0.0, 1.0, INTERPOLATING[degree], -16.0, 10.0], count)
    ends = draw(st.sampled_from(["free", "clamped"]))
    return Curve(points, lambdas, degree=degree, closed=draw(st.booleans()), ends=ends)


drawings = st.lists(curves(), max_size=3)
tolerances = st.sampled_from([1e-3, 0.02, 0.3, 5.0])


def distances(points, lines):
    """How far each point is from the nearest line."""
    start, along = lines[:, :2], lines[:, 2:] - lines[:, :2]
    away = points[:, None] - start
    squares = np.maximum((along**2).sum(axis=1), 1e-300)
    t = ((away * along).sum(axis=2) / squares).clip(0, 1)
    return np.hypot(*np.moveaxis(away - t[..., None] * along, -1, 0)).min(axis=1, initial=np.inf)


def points_of(curve):
    return curve(np.linspace(0, curve.segment_count, 6 * curve.segment_count + 1))


@given(drawings, tolerances)
def test_lines_and_curves_are_within_the_tolerance_of_each_other(drawing, tolerance):
    chords = ChordTree(drawing).chords(*WINDOW, tolerance)
    for place, curve in enumerate(drawing):
        lines = chords.lines[chords.curves == place]
        points = points_of(curve)
        inside = ((points > WINDOW[0]) & (points < WINDOW[1])).all(axis=1)
        assert (distances(points[inside], lines) <= tolerance + 1e-9).all()
        middles = (lines[:, :2] + lines[:, 2:]) / 2
        pieces = np.hstack([points[:-1], points[1:]])
        grain = np.hypot(*(pieces[:, 2:] - pieces[:, :2]).T).max()
        assert (distances(middles, pieces) <= tolerance + grain).all()


@given(curves(), st.floats(0, 1), st.floats(-9, 1))
def test_however_small_a_part_of_a_curve_is_seen_its_lines_are_within_the_tolerance(curve, share, exponent):
    u = share * curve.segment_count
    width, place = 10**exponent, curve(u)
    plane = Viewport(*place.tolist(), 1000 / width, 1000.0, 1000.0)
    nearby = np.clip(u + np.linspace(-1, 1, 9) * width / max(np.hypot(*curve(u, nu=1)), 1.0), *curve.domain)
    pixels = plane.to_pixels(curve(nearby))
    pixels = pixels[((pixels > 0) & (pixels < 1000)).all(axis=1)]
    chords = ChordTree([curve]).chords(*plane.window(), 0.1 / plane.scale)
    drawn = [
        plane.lines_to_pixels(chords.lines),
        np.vstack([stroke.lines for stroke in strokes(curve, plane)]),
    ]
    drawn += traced([(curve, np.arange(curve.segment_count))], plane)
    rounding = 1e-14 * plane.scale * (1 + np.abs(curve.control_points).max())
    for lines in drawn:
        assert (distances(pixels, lines) <= 0.1 + rounding).all()
        assert len(lines) < 600 * curve.segment_count


def laid(tree, without, spacing):
    leaves = tree.leaves(*WINDOW, without)
    some = (leaves.rows[leaves.curves == place] for place in range(len(tree.sizes.T)))
    return [np.hstack([np.empty((2, 0)), *tree.points(rows, spacing, np.inf)(PLANE)]).T for rows in some]


@given(drawings, st.sampled_from([0.003, 0.05, 0.7]), st.data())
def test_no_place_of_a_curve_is_far_from_points_along_it(drawing, spacing, data):
    tree = ChordTree(drawing)
    without = {
        place: np.array(sorted(data.draw(st.sets(st.integers(0, curve.segment_count - 1)))), dtype=np.intp)
        for place, curve in enumerate(drawing)
    }
    for place, points in enumerate(laid(tree, without, spacing)):
        curve = drawing[place]
        kept = np.setdiff1d(np.arange(curve.segment_count), without[place])
        wanted = curve((kept[:, None] + np.linspace(0, 1, 7)).ravel())
        wanted = wanted[((wanted > WINDOW[0]) & (wanted < WINDOW[1])).all(axis=1)]
        if len(wanted):
            away = np.hypot(*np.moveaxis(wanted[:, None] - points, -1, 0)).min(axis=1)
            assert away.max() <= spacing / 2 + 1e-5


def test_too_many_points_are_given_up():
    tree = ChordTree([Curve(np.arange(20.0).reshape(10, 2) ** 2)])
    assert tree.points(np.arange(7), 1.0, 10) is None
    assert 10 < sum(some.shape[1] for some in tree.points(np.arange(7), 1.0, 1e4)(PLANE)) <= 1e4


@given(drawings, tolerances, st.data())
def test_a_tree_that_follows_an_edit_is_the_tree_made_anew(drawing, tolerance, data):
    tree = ChordTree(drawing)
    new = list(drawing)
    for place in range(len(new)):
        curve = new[place]
        index = data.draw(st.integers(0, len(curve.control_points) - 1))
        if data.draw(st.booleans()):
            new[place] = curve.with_points([index], [data.draw(st.tuples(coordinates, coordinates))])
        else:
            new[place] = curve.with_lambdas([index], [data.draw(st.floats(-16, 10))])
    if tree.follow(new):
        now, anew = tree.chords(*WINDOW, tolerance), ChordTree(new).chords(*WINDOW, tolerance)
        assert now.lines.shape == anew.lines.shape
        assert np.abs(now.lines - anew.lines).max(initial=0.0) < 1e-9
        assert (now.codes == anew.codes).all()
        assert (now.segments == anew.segments).all()
        for some, others in zip(laid(tree, {}, 0.1), laid(ChordTree(new), {}, 0.1), strict=True):
            assert np.abs(some - others).max(initial=0.0) < 1e-9


@given(drawings, tolerances, st.data())
def test_a_tree_like_another_is_the_tree_made_anew(drawing, tolerance, data):
    new = data.draw(st.permutations(drawing))
    for place, curve in enumerate(new):
        count = len(curve.control_points)
        first, last = sorted(data.draw(st.tuples(st.integers(0, count), st.integers(0, count))))
        extra = np.array(data.draw(st.lists(st.tuples(coordinates, coordinates), max_size=3))).reshape(-1, 2)
        points = np.vstack([curve.control_points[:first], extra, curve.control_points[last:]])
        if data.draw(st.booleans()) and len(points) > curve.degree:
            lambdas = np.concatenate([curve.lambdas[:first], np.zeros(len(extra)), curve.lambdas[last:]])
            new[place] = Curve(points, lambdas, curve.degree, curve.closed, curve.ends)
    now, anew = ChordTree(new, ChordTree(drawing)), ChordTree(new)
    for some, others in zip(now.chords(*WINDOW, tolerance), anew.chords(*WINDOW, tolerance), strict=True):
        assert (some == others).all()
    for some, others in zip(laid(now, {}, 0.1), laid(anew, {}, 0.1), strict=True):
        assert (some == others).all()


@given(drawings, tolerances, st.data())
def test_a_tree_follows_curves_that_are_moved_whole(drawing, tolerance, data):
    tree, new = ChordTree(drawing), drawing
    for _ in range(2):
        offset = np.array(data.draw(st.tuples(st.integers(-40, 40), st.integers(-40, 40)))) / 7
        moved = data.draw(st.sets(st.sampled_from(range(len(new))))) if new else set()
        new = [
            curve.with_points(range(len(curve.control_points)), curve.control_points + offset)
            if place in moved
            else curve
            for place, curve in enumerate(new)
        ]
        assert tree.follow(new)
    anew = ChordTree(new)
    now, wanted = tree.chords(*WINDOW, tolerance), anew.chords(*WINDOW, tolerance)
    # At the edge of the window or of the tolerance rounding may decide.
    assert abs(len(now.lines) - len(wanted.lines)) <= 2
    if now.lines.shape == wanted.lines.shape:
        assert np.abs(now.lines - wanted.lines).max(initial=0.0) < 1e-9
    assert np.abs(tree.sizes - anew.sizes).max(initial=0.0) < 1e-9


def moved(curve, some, offset):
    return curve.with_points(some, curve.control_points[some] + offset)


def test_what_was_moved_very_often_is_measured_anew_and_then_followed_as_before(monkeypatch):
    monkeypatch.setattr(segment_table, "MOST_SHIFTS", 5)
    one = other = Curve(np.random.default_rng(0).normal(size=(60, 2)).cumsum(axis=0))
    tree, followed = ChordTree([one, other]), []
    for _ in range(13):
        one = moved(one, range(60), [0.1, 0.2])
        followed.append(tree.follow([one, other]))
        if not followed[-1]:
            tree = ChordTree([one, other], tree)
    assert [k for k, well in enumerate(followed) if not well] == [5, 11]
    assert tree.follow([moved(one, [30], [0.1, 0.0]), other])


def follows_wrongly(curves):
    """Whether a tree that follows curves ends up elsewhere than the last one; it may give up."""
    tree = ChordTree(curves[:1])
    if not all(tree.follow([curve]) for curve in curves[1:]):
        return False
    wanted = ChordTree(curves[-1:]).chords(*WINDOW, 1e-6)
    return np.abs(tree.chords(*WINDOW, 1e-6).lines - wanted.lines).max() > 1e-9


@pytest.mark.parametrize("far", [1e3, 1e6, 1e9, 9e11])
def test_a_small_curve_that_was_far_away_is_itself_again(far):
    small = Curve(np.random.default_rng(0).normal(scale=1e-3, size=(9, 2)))
    assert not follows_wrongly([small, moved(small, range(9), [far, 0.0]), small])


def test_a_point_is_moved_alone_where_another_is_too_far_away_to_tell():
    curve = Curve([[0, 0], [1, 0], [1, 1], [2, 2], [1e12, 3]])
    assert not follows_wrongly([curve, moved(curve, [0], [3e-4, 0.0])])


def test_an_edit_of_a_long_curve_is_followed():
    rng = np.random.default_rng(1)
    curve = Curve(rng.normal(size=(1000, 2)).cumsum(axis=0), rng.choice([0.0, 1.0], 1000))
    tree = ChordTree([curve])
    assert tree.follow([curve.with_points(range(10, 60), rng.normal(size=(50, 2)))])
    assert not tree.follow([curve.with_(closed=True)])
    assert not tree.follow([curve, curve])


@given(drawings, tolerances)
def test_a_line_over_several_segments_has_their_mode_where_that_counts(drawing, tolerance):
    chords = ChordTree(drawing).chords(*WINDOW, tolerance, by_mode=0)
    own = chords.curves == 0
    assert MIXED not in chords.codes[own]
    for segment, code in zip(chords.segments[own], chords.codes[own], strict=True):
        assert drawing[0].mode_codes[segment] == code


@given(drawings, tolerances, st.data())
def test_segments_left_out_are_not_drawn_and_the_others_are(drawing, tolerance, data):
    tree, gone = ChordTree(drawing), {}
    for place, curve in enumerate(drawing):
        chosen = data.draw(st.sets(st.integers(0, curve.segment_count - 1)))
        gone[place] = np.array(sorted(chosen), dtype=np.intp)
    rest = tree.chords(*WINDOW, tolerance, without=gone)
    for place, curve in enumerate(drawing):
        assert not np.isin(rest.segments[rest.curves == place], gone[place]).any()
        kept = np.setdiff1d(np.arange(curve.segment_count), gone[place])
        points = curve((kept[:, None] + np.linspace(0.01, 0.99, 8)).ravel())
        inside = ((points > WINDOW[0]) & (points < WINDOW[1])).all(axis=1)
        assert (distances(points[inside], rest.lines[rest.curves == place]) <= tolerance + 1e-9).all()


@given(curves(), tolerances)
def test_parameters_tell_where_a_line_begins_and_ends(curve, tolerance):
    chords = ChordTree([curve]).chords(*WINDOW, tolerance, whole=True)
    for column, ends in ((0, chords.lines[:, :2]), (1, chords.lines[:, 2:])):
        u = np.minimum(chords.segments + chords.parameters[:, column], curve.segment_count)
        assert np.abs(curve(u) - ends).max(initial=0.0) < 1e-9


@given(curves())
def test_segments_in_view_are_those_with_points_in_view_and_few_more(curve):
    seen = ChordTree([curve]).seen(0, *WINDOW)
    for segment in range(curve.segment_count):
        points = curve(np.minimum(segment + np.linspace(0, 1, 20), curve.segment_count - 1e-12))
        if ((points > WINDOW[0]) & (points < WINDOW[1])).all(axis=1).any():
            assert segment in seen
    assert len(ChordTree([curve]).seen(0, np.array([90.0, 90.0]), np.array([99.0, 99.0]))) == 0
