import inspect
import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from theditor.spline import KNOWN, Curve, Mode, known
from theditor.spline.chains import MAX_SEGMENTS, hyperbolic, trigonometric

QUARTER = math.pi / 2

places = st.tuples(st.floats(-5, 5), st.floats(-5, 5))
sizes = st.floats(0.1, 10)
signed = sizes | sizes.map(lambda size: -size)
angles = st.floats(-7, 7)
counts = st.integers(1, 9)
degrees = st.sampled_from([2, 3])


def check(curve, step, start, formula, place=(0, 0), rotation=0.0):
    """The curve runs through formula(τ), turned and moved to its place, τ from `start` by `step` a segment."""
    u = np.linspace(0, curve.segment_count, 8 * curve.segment_count + 1)
    expected = np.stack(np.broadcast_arrays(*formula(start + step * u)), axis=-1)
    turn = np.eye(len(place))
    turn[:2, :2] = [[math.cos(rotation), -math.sin(rotation)], [math.sin(rotation), math.cos(rotation)]]
    limit = 2e-14 * np.abs(curve.control_points).max()
    np.testing.assert_allclose(curve(u), place + expected @ turn.T, rtol=0, atol=limit)


@given(places, sizes, sizes, angles, angles, counts, degrees)
def test_an_ellipse_runs_through_its_eccentric_angles(centre, a, b, rotation, start, quarters, degree):
    curve = known.ellipse(centre, (a, b), rotation, start, quarters, degree)
    check(curve, QUARTER, start, lambda τ: (a * np.cos(τ), b * np.sin(τ)), centre, rotation)
    assert (curve.segment_count, curve.closed) == (quarters, quarters == 4)
    assert set(curve.modes) == {Mode.TRIGONOMETRIC}


@given(places, sizes, sizes, angles, st.floats(-3, 3), st.integers(1, 5), degrees)
def test_a_hyperbola_runs_through_its_branch(centre, a, b, rotation, start, units, degree):
    curve = known.hyperbola(centre, (a, b), rotation, start, units, degree)
    check(curve, 1, start, lambda τ: (a * np.cosh(τ), b * np.sinh(τ)), centre, rotation)
    assert curve.segment_count == units
    assert set(curve.modes) == {Mode.HYPERBOLIC}


@given(places, signed, sizes, angles, angles, counts)
def test_a_sine_wave_is_on_its_equation(origin, height, length, rotation, start, quarters):
    curve = known.sine(origin, height, length, rotation, start, quarters)
    check(curve, QUARTER, start, lambda τ: (length / math.tau * τ, height * np.sin(τ)), origin, rotation)


@given(places, sizes, sizes, angles, angles, counts)
def test_a_trochoid_is_on_its_equation(origin, r, a, rotation, start, quarters):
    curve = known.trochoid(origin, r, a, rotation, start, quarters)
    check(curve, QUARTER, start, lambda τ: (r * τ - a * np.sin(τ), r - a * np.cos(τ)), origin, rotation)
    assert known.cycloid(origin, r, rotation, start, quarters) == known.trochoid(
        origin, r, r, rotation, start, quarters
    )


@given(places, signed, angles, st.floats(-3, 3), st.integers(1, 5))
def test_a_catenary_is_on_its_equation(origin, a, rotation, start, units):
    curve = known.catenary(origin, a, rotation, start, units)
    check(curve, 1, start, lambda τ: (a * τ, a * np.cosh(τ)), origin, rotation)


@given(places, signed, signed, angles, st.floats(-6, 3), st.integers(1, 5))
def test_an_exponential_curve_is_on_its_equation(origin, height, length, rotation, start, units):
    curve = known.exponential(origin, height, length, rotation, start, units)
    check(curve, 1, start, lambda τ: (length * τ, height * np.exp(τ)), origin, rotation)


@given(st.tuples(*[st.floats(-5, 5)] * 3), sizes, signed, angles, counts)
def test_a_helix_is_on_its_equation(centre, r, pitch, start, quarters):
    curve = known.helix(centre, r, pitch, start, quarters)
    check(curve, QUARTER, start, lambda τ: (r * np.cos(τ), r * np.sin(τ), pitch * τ / math.tau), centre)


def test_quarter_turns_give_round_numbers():
    rectangle = known.ellipse(rotation=math.pi / 2, start=math.pi, degree=2).control_points
    np.testing.assert_array_equal(rectangle, [(1, -2), (1, 2), (-1, 2), (-1, -2)])
    assert known.cycloid(quarters=MAX_SEGMENTS).control_points[-2, 0] == math.pi / 2 * MAX_SEGMENTS


def test_what_falls_exponentially_keeps_its_relative_accuracy():
    x, y = hyperbolic((0, 0), (1, 0), (0, 1), (0, -1), 25)(25)
    assert x == 25
    assert y == pytest.approx(math.exp(-25), rel=1e-13)


def test_general_chains_take_any_coefficients_in_plane_and_space():
    c = np.array([(1, 2, 0), (0, 3, -1), (2, 0, 1), (1, 1, 4)])
    t = np.linspace(0, 2, 17)
    for make, first, second in (
        (trigonometric, np.cos(QUARTER * (t - 0.7)), np.sin(QUARTER * (t - 0.7))),
        (hyperbolic, np.cosh(t - 0.7), np.sinh(t - 0.7)),
    ):
        expected = np.stack((np.ones_like(t), t - 0.7, first, second), axis=-1) @ c
        np.testing.assert_allclose(make(*c, 2, -0.7)(t), expected, rtol=0, atol=1e-13)
        flat = make(*c[:, :2], 2, -0.7)
        np.testing.assert_allclose(flat(t), expected[:, :2], rtol=0, atol=1e-13)
        with pytest.raises(ValueError, match="a quadratic has no term in t"):
            make(*c, degree=2)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: known.ellipse(semi_axes=(2, 0)), "semi-axes must be positive"),
        (lambda: known.hyperbola(semi_axes=(-1, 1)), "semi-axes must be positive"),
        (lambda: known.ellipse(semi_axes=3.0), "semi-axes must be 2 numbers"),
        (lambda: known.ellipse(centre=(0, math.nan)), "centre must be finite"),
        (
            lambda: known.ellipse(semi_axes=np.array([1, -1])),
            "semi-axes must be positive, not 1, −1: give at",
        ),
        (lambda: known.ellipse(semi_axes=(1e-320, 1)), "semi-axes must be positive"),
        (lambda: known.catenary(parameter=-1e-320), "parameter must not be zero"),
        (lambda: known.cycloid(radius=1e12), "the curve would reach beyond 1e\\+12"),
        (lambda: known.ellipse(degree=4), "degree must be 2 or 3"),
        (lambda: known.sine(amplitude=0), "amplitude must not be zero"),
        (lambda: known.sine(wavelength=-4), "wavelength must be positive"),
        (lambda: known.cycloid(rotation=math.inf), "rotation must be finite"),
        (lambda: known.trochoid(arm=0), "arm must be positive"),
        (lambda: known.catenary(parameter=0), "parameter must not be zero"),
        (lambda: known.exponential(length=0), "length must not be zero"),
        (lambda: known.helix(pitch=0), "pitch must not be zero"),
        (lambda: known.helix(start=math.nan), "start must be finite"),
        (lambda: known.sine(quarters=0), "a whole one from 1 to 10000, not 0"),
        (lambda: known.sine(quarters=10_001), "a whole one from 1 to 10000"),
        (lambda: known.catenary(units=1.5), "a whole one from 1 to 10000"),
        (lambda: known.hyperbola(units=40), "reach beyond 1e\\+12: make it shorter"),
        (lambda: known.exponential(start=1e12), "reach beyond"),
        (lambda: trigonometric((1,), (0,), (0,), (0,)), "c0 needs 2 or 3 coordinates, not 1"),
        (lambda: hyperbolic((1, 1), (0, 0, 0), (0, 0), (0, 0)), "c1 must be 2 numbers"),
    ],
)
def test_senseless_parameters_are_refused_by_name(make, message):
    with pytest.raises(ValueError, match=message):
        make()


@pytest.mark.parametrize("entry", KNOWN, ids=lambda entry: entry.name)
def test_the_catalogue_describes_the_functions(entry):
    signature = inspect.signature(entry.make).parameters
    assert [p.keyword for p in entry.parameters] == [key for key in signature if key != "degree"]
    assert ("degree" in signature) == (len(entry.degrees) > 1)
    for parameter in entry.parameters:
        default = np.atleast_1d(parameter.default)
        assert parameter.default == signature[parameter.keyword].default
        assert len(parameter.labels) == len(default)
        assert (parameter.minimum <= default).all()
        assert (default <= parameter.maximum).all()
        assert parameter.integer == isinstance(parameter.default, int)
        for bound in (parameter.minimum, parameter.maximum):
            if math.isfinite(bound) and not parameter.integer:
                value = bound if default.size == 1 else (bound,) * default.size
                assert isinstance(entry.make(**{parameter.keyword: value}), Curve)
    assert {entry.make(**{"degree": d} if len(entry.degrees) > 1 else {}).degree for d in entry.degrees} == {
        *entry.degrees
    }


def test_names_and_functions_of_the_catalogue_differ():
    assert all(a.name != b.name and a.make is not b.make for a, b in pairwise(KNOWN))
