from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from theditor.panels import lambda_scale as scale
from theditor.spline import CONVEX_HULL_RANGE, INTERPOLATING, MAX_LAMBDA

degrees = st.sampled_from([2, 3])
on_scale = st.floats(scale.LOWEST, scale.HIGHEST)
anywhere = st.floats(-MAX_LAMBDA, MAX_LAMBDA)


@given(on_scale)
def test_place_and_value_are_inverse(value):
    assert scale.value_at(scale.position(value)) == pytest.approx(value, abs=1e-11)


@given(anywhere, anywhere)
def test_larger_values_stand_no_further_left_and_all_stand_on_the_scale(a, b):
    low, high = scale.position(sorted([a, b]))
    assert 0 <= low <= high <= 1


def test_the_scale_ends_where_it_says_and_gives_t_to_h_nearly_a_third():
    assert scale.position([scale.LOWEST, scale.HIGHEST]).tolist() == [0, 1]
    start, end = scale.position([0, 1])
    assert 0.27 < end - start < 0.34


@pytest.mark.parametrize(("degree", "word"), [(2, "cusp"), (3, "inflection")])
def test_landmarks_are_those_of_the_degree(degree, word):
    marks = scale.landmarks(degree)
    assert [mark.label for mark in marks] == ["hull", word, "T", "H", "hull", "λ*"]
    values = [mark.value for mark in marks]
    assert (values[0], values[4]) == CONVEX_HULL_RANGE[degree]
    assert values[2:4] == [0, 1]
    assert values[5] == INTERPOLATING[degree]
    assert values[1] == pytest.approx(-2.6481961715882543)


@given(on_scale, degrees, st.floats(60, 2000))
def test_a_landmark_attracts_exactly_what_is_within_six_pixels(value, degree, length):
    result = scale.snapped(value, degree, length)
    magnets = [0.0, 1.0, INTERPOLATING[degree]]
    distances = np.abs(scale.position(magnets) - scale.position(value)) * length
    assume(abs(distances.min() - 6) > 1e-9)
    assert result == (magnets[int(distances.argmin())] if distances.min() < 6 else value)


@given(st.lists(anywhere, min_size=1, max_size=5), degrees, st.sampled_from([1, -1]), st.booleans())
def test_a_step_goes_its_way_a_little_and_never_jumps_over_a_mode(values, degree, direction, fine):
    start = np.array(values)
    assume((np.abs(start) < MAX_LAMBDA - 1e5).all())
    end = scale.stepped(start, direction, degree, fine)
    assert (np.sign(end - start) == direction).all()
    for magnet in (0.0, 1.0, INTERPOLATING[degree]):
        assert ((start - magnet) * (end - magnet) >= 0).all()
    inside = (start > scale.LOWEST) & (start < scale.HIGHEST)
    moved = np.abs(scale.position(end) - scale.position(start))[inside]
    assert (moved < 0.02).all()


def test_steps_between_the_modes_are_round_numbers():
    walk = [0.0]
    while walk[-1] < 1:
        walk.append(float(scale.stepped(walk[-1], 1, 3)))
    assert walk[-1] == 1.0
    assert all(value == round(value, 2) for value in walk)
    assert 30 < len(walk) < 100


@given(anywhere, degrees, st.sampled_from([1, -1]))
def test_page_keys_go_to_the_next_landmark_or_stay(value, degree, direction):
    reached = scale.next_landmark(value, direction, degree)
    values = [mark.value for mark in scale.landmarks(degree)]
    assert not any((v - value) * direction > 0 and (reached - v) * direction > 0 for v in values)
    assert reached == value or (reached in values and (reached - value) * direction > 0)


@given(
    st.lists(st.tuples(st.floats(0, 400), st.floats(1, 90)), max_size=8),
    st.floats(100, 400),
)
def test_labels_never_overlap_and_stay_inside(labels, length):
    labels = [(min(place, length), width) for place, width in labels]
    lefts = scale.placed_labels([p for p, _ in labels], [w for _, w in labels], length)
    spans = sorted((x, x + w) for x, (_, w) in zip(lefts, labels, strict=True) if x is not None)
    assert all(end + 4 <= start + 1e-9 for (_, end), (start, _) in pairwise(spans))
    assert all(start >= 0 and end <= length + 1e-9 for start, end in spans)
    if labels:
        assert lefts[0] is not None


@given(on_scale, st.lists(st.floats(-400, 400), min_size=1, max_size=6), degrees)
def test_where_a_drag_ends_does_not_depend_on_the_way(value, moves, degree):
    start = float(scale.position(value))
    wandering, straight = (scale.ScaleDrag(degree, 300, start) for _ in range(2))
    ends = [wandering.move(pixels, free=True) for pixels in moves]
    assert ends[-1] == pytest.approx(straight.move(sum(moves), free=True), abs=1e-2, rel=2e-2)


def test_a_drag_is_ten_times_finer_or_free_on_request():
    start = float(scale.position(0.5))
    coarse, fine = (scale.ScaleDrag(3, 300, start) for _ in range(2))
    coarse.move(3, free=True)
    fine.move(30, fine=True, free=True)
    assert fine.place == pytest.approx(coarse.place)
    near_h = float(scale.position(1.0)) + 2 / 300
    assert scale.ScaleDrag(3, 300, near_h).move(1) == 1.0
    assert scale.ScaleDrag(3, 300, near_h).move(1, free=True) != 1.0
