import copy
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from spline_strategies import curves

from theditor.spline import INTERPOLATING, Curve, Mode, fewest_points

SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 2.0)]


@given(curves())
def test_equal_content_is_equal_and_survives_pickling(curve):
    same = Curve(
        curve.control_points.tolist(), curve.lambdas.tolist(), curve.degree, curve.closed, curve.ends
    )
    thawed = pickle.loads(pickle.dumps(curve))
    for other in (same, thawed, copy.deepcopy(curve)):
        assert other == curve
        assert hash(other) == hash(curve)
    assert not thawed.control_points.flags.writeable
    assert curve.with_points(0, curve.control_points[0] + 1) != curve
    assert curve.with_lambdas(0, curve.lambdas[0] + 1) != curve
    assert curve != "a curve"


def test_every_attribute_counts_for_equality():
    curve = Curve(SQUARE)
    others = [
        curve.with_(degree=2),
        curve.with_(closed=True),
        curve.with_(ends="clamped"),
        Curve(SQUARE, 0.5),
    ]
    assert len({curve, *others}) == 5


def test_negative_zero_is_zero():
    plus = Curve(SQUARE)
    minus = Curve([[-0.0 if x == 0 else x for x in point] for point in SQUARE], -0.0)
    assert plus == minus == plus.with_points(0, [-0.0, -0.0]) == plus.with_lambdas([0], -0.0)
    assert {hash(c) for c in (plus, minus, plus.with_points(0, [-0.0, 0.0]))} == {hash(plus)}
    assert not np.signbit(minus.control_points).any()


def test_a_curve_cannot_be_changed():
    points = np.array(SQUARE)
    curve = Curve(points)
    points[0] = 7
    assert curve.control_points[0, 0] == 0
    for array in (curve.control_points, curve.lambdas, curve.active_lambdas, curve.mode_codes, curve.polygon):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1
    with pytest.raises(AttributeError):
        curve.degree = 2
    with pytest.raises(AttributeError):
        del curve.lambdas


def test_a_changed_curve_shares_what_it_keeps_and_leaves_the_first_alone():
    curve = Curve(SQUARE, 0.5)
    moved, bent = curve.with_points([1, 3], [(5, 6), (7, 8)]), curve.with_lambdas(2, 3.0)
    assert moved.lambdas is curve.lambdas
    assert bent.control_points is curve.control_points
    assert curve.with_(closed=True).control_points is curve.control_points
    assert moved.control_points.tolist() == [[0, 0], [5, 6], [1, 1], [7, 8], [0, 2]]
    assert bent.lambdas.tolist() == [0.5, 0.5, 3, 0.5, 0.5]
    assert curve == Curve(SQUARE, 0.5)
    assert curve.with_points([0, 1], [9, 9]).control_points[:2].tolist() == [[9, 9], [9, 9]]
    assert curve.with_points([], np.empty((0, 2))) == curve


def test_what_was_worked_out_for_one_curve_is_not_taken_for_another():
    curve = Curve(SQUARE, 0.0)
    assert curve.modes == (Mode.TRIGONOMETRIC,) * 2
    assert hash(curve)
    curve.sample()
    changed = curve.with_lambdas(range(5), 1.0).with_points(2, [4, 4])
    fresh = Curve(changed.control_points, 1.0)
    assert (changed.modes, hash(changed)) == (fresh.modes, hash(fresh))
    np.testing.assert_array_equal(changed.sample(), fresh.sample())


def test_a_new_degree_keeps_interpolation():
    lambdas = [0.0, 1.0, INTERPOLATING[3], 0.5, INTERPOLATING[3]]
    curve = Curve(SQUARE, lambdas)
    quadratic = curve.with_(degree=2)
    assert quadratic.lambdas.tolist() == [0.0, 1.0, INTERPOLATING[2], 0.5, INTERPOLATING[2]]
    assert quadratic.with_(degree=3) == curve
    assert curve.with_(degree=2, lambdas=lambdas).lambdas.tolist() == lambdas


def test_the_ends_of_a_closed_curve_are_kept_but_without_effect():
    free, clamped = (Curve(SQUARE, 0.5, closed=True, ends=ends) for ends in ("free", "clamped"))
    np.testing.assert_array_equal(free.sample(), clamped.sample())
    assert clamped.with_(closed=False) == Curve(SQUARE, 0.5, ends="clamped")


@given(curves())
def test_repr_is_short(curve):
    assert len(repr(curve)) < 60


def test_repr_says_what_the_curve_is():
    assert repr(Curve(SQUARE, ends="clamped")) == "<Curve: clamped cubic, 5 points, 2-D>"


@given(st.sampled_from([2, 3]), st.booleans(), st.sampled_from(["free", "clamped"]))
def test_the_fewest_points_suffice_and_one_less_does_not(degree, closed, ends):
    count = fewest_points(degree, closed, ends)
    points = np.arange(2.0 * count).reshape(count, 2)
    assert Curve(points, 0, degree, closed, ends).sample(4).shape[1] == 2
    with pytest.raises(ValueError, match=f"needs at least {count} control points, not {count - 1}"):
        Curve(points[:-1], 0, degree, closed, ends)


def with_entry(row, column, value):
    points = [list(point) for point in SQUARE]
    points[row][column] = value
    return points


CURVE = Curve(SQUARE)
REFUSED = {
    "nan": (lambda: Curve(with_entry(3, 1, float("nan"))), "control point 3: y is nan"),
    "infinite": (lambda: Curve(with_entry(4, 0, float("inf"))), "control point 4: x is inf"),
    "far": (
        lambda: Curve(with_entry(0, 0, -1.01e12)),
        "control point 0: x is -1010000000000.0, .* at most 1e.12",
    ),
    "flat": (lambda: Curve([1, 2, 3]), r"shape \(m, 2\) or \(m, 3\), not \(3,\)"),
    "four coordinates": (lambda: Curve(np.zeros((5, 4))), r"not \(5, 4\)"),
    "ragged": (lambda: Curve([(0, 0), (1,), (2, 2)]), "rows of different length"),
    "text": (lambda: Curve([("0", "1")] * 5), "control points must be real numbers"),
    "complex": (lambda: Curve(np.zeros((5, 2), complex)), "real numbers"),
    "none": (lambda: Curve([]), "shape"),
    "number of λ": (lambda: Curve(SQUARE, [0, 1]), "one for each of the 5 control points"),
    "large λ": (lambda: Curve(SQUARE, [0, 0, 1.1e6, 0, 0]), "control point 2: λ is 1100000.0"),
    "nan λ": (lambda: Curve(SQUARE, float("nan")), "control point 0: λ is nan"),
    "degree": (lambda: Curve(SQUARE, 0, 4), "degree must be 2 or 3, not 4"),
    "closed": (lambda: Curve(SQUARE, 0, 3, "yes"), "closed must be True or False"),
    "ends": (lambda: Curve(SQUARE, 0, 3, False, "loose"), 'ends must be "free" or "clamped", not \'loose\''),
    "side": (lambda: CURVE(0.5, side="top"), 'side must be "left" or "right"'),
    "order": (lambda: CURVE(0.5, 4), "order nu of the derivative"),
    "no such point": (lambda: CURVE.with_points([1, 5], 0), "no control point 5: they run from 0 to 4"),
    "negative index": (lambda: CURVE.with_lambdas(-1, 0), "no control point -1"),
    "fractional index": (lambda: CURVE.with_points(1.5, [0, 0]), "integer"),
    "mask": (lambda: CURVE.with_lambdas([True, False, True, False, True], 0), "integer"),
    "moved to nan": (lambda: CURVE.with_points([2, 4], [(0, 0), (0, np.nan)]), "control point 4: y is nan"),
    "moved in 3-D": (lambda: CURVE.with_points([2], [(0, 0, 0)]), r"shape \(1, 2\), not \(1, 3\)"),
    "λ too large": (lambda: CURVE.with_lambdas([3], 2e6), "control point 3: λ is 2000000.0"),
    "no such segment": (lambda: CURVE.with_mode(2, Mode.HYPERBOLIC), "no segment 2: they run from 0 to 1"),
    "blend": (lambda: CURVE.with_mode(0, Mode.BLEND), "a blend has no λ of its own"),
    "too few to free": (lambda: Curve(SQUARE[:3], ends="clamped").with_(ends="free"), "at least 4"),
    "too few to open": (lambda: Curve(SQUARE[:3], closed=True).with_(closed=False), "at least 4"),
    "loose λ": (lambda: CURVE.with_(control_points=SQUARE[:4]), "4 control points need as many λ"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_bad_input_is_refused_with_its_place(name):
    attempt, message = REFUSED[name]
    with pytest.raises(ValueError, match=message):
        attempt()
