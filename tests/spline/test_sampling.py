import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from spline_strategies import curves, scale

from theditor.spline import (
    Curve,
    Mode,
    changed_segments,
    evaluate_segments,
    intervals_for,
    sample_adaptively,
    segment_bounds,
)

steps = st.integers(1, 20)


def along(curve, segments, intervals):
    """Each segment at equal steps of t, (k, intervals + 1, d), one call at a time."""
    t = np.linspace(0, 1, intervals + 1)
    inner, last = t[:-1], np.asarray(segments) + 1.0
    values = [
        np.vstack((curve(s + inner), curve(end, side="left"))) for s, end in zip(segments, last, strict=True)
    ]
    return np.array(values).reshape(-1, intervals + 1, curve.dimension)


def large_curve(degree, closed=False, ends="free"):
    rng = np.random.default_rng(5)
    return Curve(rng.normal(size=(9000, 2)), rng.uniform(-9, 9, 9000), degree, closed, ends)


@given(curves(), steps)
def test_samples_are_points_of_the_curve(curve, per_segment):
    count = curve.segment_count * per_segment
    samples = curve.sample(per_segment)
    expected = curve(np.arange(count + 1) / per_segment)
    np.testing.assert_allclose(samples, expected, rtol=0, atol=1e-14 * scale(curve))
    if curve.closed:
        np.testing.assert_array_equal(samples[0], samples[-1])


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("closed", [False, True])
def test_a_curve_of_several_blocks_is_sampled_seamlessly(degree, closed):
    curve = large_curve(degree, closed, "clamped")
    u = np.arange(4 * curve.segment_count + 1) / 4
    np.testing.assert_allclose(curve.sample(4), curve(u), rtol=0, atol=1e-15 * scale(curve))


def test_samples_are_written_where_asked():
    curve = large_curve(3)
    out = np.full((2, 4 * curve.segment_count + 1), np.nan)
    samples = curve.sample(4, out=out)
    assert np.shares_memory(samples, out)
    np.testing.assert_array_equal(out.T, samples)
    np.testing.assert_array_equal(samples, curve.sample(4))


@pytest.mark.parametrize(
    "out", [np.empty((65, 2)), np.empty((2, 65), np.float32), np.empty((65, 2)).T, np.empty((2, 64))]
)
def test_an_output_that_does_not_fit_is_refused(out):
    with pytest.raises(ValueError, match=r"C-contiguous float64 array of shape \(2, 65\)"):
        Curve(np.arange(14).reshape(7, 2)).sample(16, out=out)


@pytest.mark.parametrize("per_segment", [0, -1, 1.5, True])
def test_steps_must_be_a_positive_integer(per_segment):
    curve = Curve(np.arange(14).reshape(7, 2))
    for attempt in (lambda: curve.sample(per_segment), lambda: evaluate_segments(curve, 0, per_segment)):
        with pytest.raises(ValueError, match="must be a positive integer"):
            attempt()


@given(curves(), steps, st.data())
def test_chosen_segments_are_evaluated_in_their_order(curve, intervals, data):
    chosen = data.draw(st.lists(st.integers(0, curve.segment_count - 1), max_size=5))
    points = evaluate_segments(curve, chosen, intervals)
    expected = along(curve, chosen, intervals)
    np.testing.assert_allclose(points, expected, rtol=0, atol=1e-14 * scale(curve))


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("ends", ["free", "clamped"])
def test_a_few_segments_of_a_large_curve_come_out_as_in_the_whole(degree, closed, ends):
    few, whole = large_curve(degree, closed, ends), large_curve(degree, closed, ends)
    samples = whole.sample(4)
    chosen = [0, 1, 4321, whole.segment_count - 2, whole.segment_count - 1]
    points = evaluate_segments(few, chosen, 4)
    np.testing.assert_allclose(
        points, [samples[4 * s : 4 * s + 5] for s in chosen], rtol=0, atol=1e-15 * scale(few)
    )


def test_a_segment_that_does_not_exist_is_refused():
    curve = Curve(np.arange(14).reshape(7, 2))
    for attempt in (
        lambda: evaluate_segments(curve, [0, 4], 2),
        lambda: segment_bounds(curve, 4),
        lambda: intervals_for(curve, 1, 4),
        lambda: sample_adaptively(curve, 1, segments=4),
    ):
        with pytest.raises(ValueError, match="no segment 4: they run from 0 to 3"):
            attempt()


@given(curves(), st.data())
def test_changed_segments_are_exactly_those_with_another_definition(curve, data):
    count = len(curve.control_points)
    indices = st.lists(st.integers(0, count - 1), max_size=2)
    moved, bent = data.draw(indices), data.draw(indices)
    new = curve.with_points(moved, curve.control_points[moved] + 1).with_lambdas(
        bent, curve.lambdas[bent] + 1
    )

    def definition(c, s):
        span = np.arange(s - 1, s + c.degree) + c.first_segment
        if c.closed:
            span %= count
        points = c.control_points[[i for i in span if 0 <= i < count]]
        return points.tolist(), [c.lambdas[i] for i in c.lambda_indices(s) if i is not None]

    expected = [s for s in range(curve.segment_count) if definition(curve, s) != definition(new, s)]
    if curve.active_lambdas.any():
        assert changed_segments(curve, new).tolist() == expected
    others = [s for s in range(curve.segment_count) if s not in changed_segments(curve, new).tolist()]
    np.testing.assert_array_equal(evaluate_segments(curve, others, 5), evaluate_segments(new, others, 5))
    assert curve.mode_codes[others].tolist() == new.mode_codes[others].tolist()


def test_curves_that_do_not_correspond_have_no_changed_segments():
    curve = Curve(np.arange(14).reshape(7, 2))
    others = [
        curve.with_(degree=2),
        curve.with_(closed=True),
        curve.with_(ends="clamped"),
        Curve(np.arange(12).reshape(6, 2)),
        Curve(np.arange(21).reshape(7, 3)),
    ]
    assert [changed_segments(curve, other) for other in others] == [None] * 5
    assert changed_segments(curve, Curve(np.arange(14).reshape(7, 2))).tolist() == []


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("ends", ["free", "clamped"])
def test_an_inactive_lambda_changes_no_segment(degree, ends):
    curve = Curve(np.arange(14).reshape(7, 2) ** 2, 0.5, degree, ends=ends)
    idle = np.flatnonzero(~curve.active_lambdas)
    assert changed_segments(curve, curve.with_lambdas(idle, 3.0)).tolist() == []


def test_a_lone_straight_segment_counts_as_changed_when_its_mode_does():
    line = Curve([(0, 0), (1, 1)], ends="clamped")
    assert changed_segments(line, line.with_mode(0, Mode.HYPERBOLIC)).tolist() == [0]


@given(curves(low=-1000, high=1000))
def test_boxes_contain_their_segments(curve):
    low, high = segment_bounds(curve)
    points = evaluate_segments(curve, range(curve.segment_count), 32)
    assert (low[:, None] <= points).all()
    assert (points <= high[:, None]).all()
    some_low, some_high = segment_bounds(curve, [curve.segment_count - 1])
    np.testing.assert_array_equal(some_low[0], low[-1])
    np.testing.assert_array_equal(some_high[0], high[-1])


@given(curves(low=-16, high=10))
def test_boxes_are_not_much_larger_than_the_control_points_around(curve):
    low, high = segment_bounds(curve)
    span = np.ptp(curve.control_points, axis=0)
    assert (high - low <= 5 * span + 1e-12 * scale(curve)).all()


@given(curves(), st.floats(1e-4, 1))
def test_chords_stay_within_the_tolerance(curve, tolerance):
    intervals = intervals_for(curve, tolerance, most=2**20)
    assert (np.bitwise_count(intervals) == 1).all()
    for segment, count in enumerate(np.minimum(intervals, 256)):
        if count < intervals[segment]:
            continue  # wilder than worth the time here
        fine = evaluate_segments(curve, segment, 4 * int(count))[0]
        chords = fine[::4]
        for quarter in (1, 2, 3):
            on_chord = chords[:-1] + quarter / 4 * (chords[1:] - chords[:-1])
            away = np.linalg.norm(fine[quarter::4] - on_chord, axis=1)
            assert (away <= tolerance + 1e-14 * scale(curve)).all()


def test_the_number_of_intervals_is_neither_wasteful_nor_without_limit():
    circle = Curve([(1, 1), (-1, 1), (-1, -1), (1, -1)], 0, 2, closed=True)
    # The sagitta of a quarter turn cut into n is 1 − cos(π/4n): 8 meet a thousandth with 0.0048 no more.
    needed = next(2**e for e in range(9) if 1 - np.cos(np.pi / 4 / 2**e) <= 1e-3)
    assert set(intervals_for(circle, 1e-3)) <= {needed, 2 * needed}
    assert set(intervals_for(circle, 1e-300)) == {512}
    assert set(intervals_for(circle, 1e-9, most=100)) == {64}
    straight = Curve([(0, 0), (1, 2), (2, 4), (3, 6), (4, 8)], 700.0)
    assert set(intervals_for(straight, 1e-9)) == {1}


@given(curves(), st.floats(1e-3, 1), st.data())
def test_a_window_gets_all_that_it_shows_in_order(curve, tolerance, data):
    corner = np.array(
        data.draw(st.lists(st.floats(-12, 12), min_size=curve.dimension, max_size=curve.dimension))
    )
    low, high = corner - 4, corner + 4
    drawn = sample_adaptively(curve, tolerance, low, high)
    shown = evaluate_segments(curve, range(curve.segment_count), 16)
    inside = ((shown >= low) & (shown <= high)).all(axis=2).any(axis=1)
    assert set(np.flatnonzero(inside)) <= set(drawn.segments)
    assert (np.diff(drawn.segments) > 0).all()
    assert drawn.intervals.tolist() == intervals_for(curve, tolerance, drawn.segments).tolist()
    assert len(drawn.points) == drawn.starts[-1]
    for j, segment in enumerate(drawn.segments):
        points = drawn.points[drawn.starts[j] : drawn.starts[j + 1]]
        expected = evaluate_segments(curve, segment, int(drawn.intervals[j]))[0]
        np.testing.assert_allclose(points, expected, rtol=0, atol=1e-15 * scale(curve))


def test_only_what_a_window_shows_is_sampled():
    x = np.arange(1000.0)
    wave = Curve(np.stack((x, np.sin(x)), axis=1))
    drawn = sample_adaptively(wave, 0.01, (500, -2), (503, 2))
    assert 3 <= len(drawn.segments) <= 7
    assert len(sample_adaptively(wave, 0.01, low=(0, 5)).points) == 0
    assert len(sample_adaptively(wave, 0.01, high=(10, 2)).segments) < 15
    assert sample_adaptively(wave, 0.01, (500, -2), (503, 2), segments=[3, 501]).segments.tolist() == [501]
    assert len(sample_adaptively(wave, 0.01).segments) == wave.segment_count
    with pytest.raises(ValueError, match="corner needs 2 numbers"):
        sample_adaptively(wave, 0.01, low=(0, 0, 0))


def test_chosen_segments_are_drawn_in_the_order_asked_for():
    curve = large_curve(3)
    for chosen in ([4, 0, 7000], range(curve.segment_count - 1, -1, -1)):
        drawn = sample_adaptively(curve, 1.0, segments=chosen)
        assert drawn.segments.tolist() == list(chosen)
        np.testing.assert_allclose(drawn.points[drawn.starts[:-1]], curve(chosen), rtol=0, atol=1e-14)


@pytest.mark.parametrize("tolerance", [0, -1, np.nan, np.inf])
def test_a_tolerance_must_be_positive(tolerance):
    with pytest.raises(ValueError, match="tolerance must be a positive number"):
        sample_adaptively(Curve(np.arange(14).reshape(7, 2)), tolerance)
