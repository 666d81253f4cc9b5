import numpy as np
import pytest

from theditor.spline import INTERPOLATING, Curve, with_degree
from theditor.spline.deviation import deviation, farthest


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("kind", ["free", "clamped", "closed"])
@pytest.mark.parametrize("count", [4, 9, 40])
def test_a_change_of_degree_keeps_shape_ends_and_count(degree, kind, count):
    angle = np.linspace(0, 2 * np.pi, count, endpoint=kind != "closed")
    points = np.stack((2 * np.cos(angle), np.sin(angle), np.sin(2 * angle)), axis=1)
    curve = Curve(points, 0.3, degree, kind == "closed", "clamped" if kind == "clamped" else "free")
    edited = with_degree(curve, 5 - degree)
    new = edited.curve
    assert (new.degree, new.closed, new.ends) == (5 - degree, curve.closed, curve.ends)
    np.testing.assert_array_equal(new.lambdas, curve.lambdas)
    assert edited.deviation < {4: 0.35, 9: 0.15, 40: 0.02}[count]
    # What is reported is what dense samples say, both ways.
    a, b = curve.sample(40), new.sample(40)
    gaps = np.linalg.norm(a[:, None] - b, axis=2)
    far = max(gaps.min(axis=0).max(), gaps.min(axis=1).max())
    step = max(np.linalg.norm(np.diff(x, axis=0), axis=1).max() for x in (a, b))
    assert abs(edited.deviation - far) <= step / 2 + 0.05 * far
    if kind != "closed":
        ends = [c([0, c.segment_count]) for c in (curve, new)]
        np.testing.assert_allclose(*ends, atol=1e-6)


def test_a_quadratic_with_too_few_points_for_a_cubic_gets_more():
    cubic = with_degree(Curve([(0, 0), (1, 1), (2, 0)], 0, 2), 3)
    assert len(cubic.curve.control_points) == 4
    assert cubic.deviation < 0.1


def test_interpolating_values_follow_the_degree_and_the_same_degree_changes_nothing():
    curve = Curve(np.random.default_rng(0).normal(size=(7, 2)), INTERPOLATING[3])
    assert set(with_degree(curve, 2).curve.lambdas) == {INTERPOLATING[2]}
    assert with_degree(curve, 3) == (curve, 0.0)
    with pytest.raises(ValueError, match="degree must be 2 or 3"):
        with_degree(curve, 4)


@pytest.fixture(scope="module", params=["free", "clamped", "closed"])
def long(request):
    """A curve of more points than are refitted together, with λ of all kinds, and itself in the other degree."""
    rng = np.random.default_rng(4)
    angle = np.arange(1200) * 2 * np.pi / 1200
    points = np.stack((200 * np.cos(angle), (190 + 3 * np.sin(40 * angle)) * np.sin(angle)), axis=1)
    lambdas = np.repeat(rng.choice([0.0, 1.0, -2.0, INTERPOLATING[3]], 120), 10)
    curve = Curve(
        points + rng.normal(scale=0.1, size=points.shape),
        lambdas,
        closed=request.param == "closed",
        ends="clamped" if request.param == "clamped" else "free",
    )
    return curve, with_degree(curve, 2)


@pytest.mark.parametrize("middle", [0, 100, 488, 700, 964])
def test_a_part_of_a_long_curve_is_refitted_as_it_is_by_itself(long, middle):
    curve, edited = long
    if middle == 0 and not curve.closed:
        return
    around, inner = np.arange(middle - 60, middle + 61) % 1200, np.arange(middle - 20, middle + 21) % 1200
    part = with_degree(Curve(curve.control_points[around], curve.lambdas[around]), 2)
    ours = Curve(edited.curve.control_points[inner], edited.curve.lambdas[inner], 2)
    alone = Curve(part.curve.control_points[40:-40], part.curve.lambdas[40:-40], 2)
    # They lie much closer to each other than to the old shape. Their ends may be a little apart along the curve.
    whole = (0, ours.segment_count)
    assert (
        deviation(ours, part.curve, whole, (40, 40 + ours.segment_count), both=False) < 0.15 * part.deviation
    )
    assert (
        deviation(alone, edited.curve, whole, np.add(whole, middle - 20 + curve.closed), both=False)
        < 0.15 * part.deviation
    )


def test_the_deviation_of_a_long_curve_is_that_of_its_samples(long):
    curve, edited = long
    shift = 0.5 if curve.closed else 0.0
    old, new = curve.segment_count, edited.curve.segment_count
    u, v = np.linspace(0, old, 32 * old + 1), shift + np.linspace(0, new, 32 * new + 1)
    there = farthest(curve(u), edited.curve, (shift + u * new / old) % new if curve.closed else u * new / old)
    back = farthest(edited.curve(v % new if curve.closed else v), curve, (v - shift) * old / new)
    assert edited.deviation == pytest.approx(max(there, back), rel=1e-9)
    assert edited.deviation < 0.05


def test_a_change_of_degree_tells_its_progress_and_can_be_called_off():
    curve = Curve(np.random.default_rng(1).normal(size=(1200, 2)).cumsum(axis=0))
    shares = []

    def stop(share):
        shares.append(share)
        if len(shares) == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        with_degree(curve, 2, stop)
    assert 0 == shares[0] < shares[1] < 1


def test_a_cubic_that_becomes_quadratic_ends_in_its_old_direction():
    points = [
        (0.6, 0),
        (0, 0.6),
        (-0.6, 0),
        (-1.6, 1),
        (-1.6, 3),
        (1, 3),
        (2, 5),
        (2, 1),
        (-1, 0.7),
        (-1, -0.8),
    ]
    curve = Curve(points, [0, 0, 0, 9, 9, 1, 1, 1, 0.5, 0])
    new = with_degree(curve, 2).curve
    for old_end, new_end in ((0.0, 0.0), (float(curve.segment_count), float(new.segment_count))):
        a, b = curve(old_end, 1), new(new_end, 1)
        assert a @ b > 0.9 * np.linalg.norm(a) * np.linalg.norm(b)
