import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from spline_strategies import LIMITS, lambdas_for

from theditor.spline import (
    CONVEX_HULL_RANGE,
    INTERPOLATING,
    JOINT_SLOPE_ZERO,
    Mode,
    basis,
    lambda_of,
    mode_of,
)

DATA = Path(__file__).parents[1] / "data"
T = np.linspace(0, 1, 401)

degrees = st.sampled_from([2, 3])
parameters = st.floats(0, 1, allow_subnormal=False)


def test_values_and_derivatives_match_the_reference():
    for row in json.loads((DATA / "basis_values.json").read_text())["rows"]:
        size = max(1.0, *map(abs, row["lambda"]))
        for nu, name in enumerate(("basis", "d1", "d2", "d3")):
            values = basis(row["t"], *row["lambda"], degree=row["degree"], nu=nu)
            np.testing.assert_allclose(values, row[name], rtol=0, atol=LIMITS[nu] * size, err_msg=str(row))


def test_constants_match_the_reference():
    constants = json.loads((DATA / "constants.json").read_text())
    assert {str(k): v for k, v in INTERPOLATING.items()} == constants["lambda_interpolating"]
    assert {str(k): list(v) for k, v in CONVEX_HULL_RANGE.items()} == constants["lambda_convex_hull"]
    assert constants["lambda_joint_slope_zero"] == JOINT_SLOPE_ZERO


@given(st.data(), degrees, parameters)
def test_weights_sum_to_one_and_their_derivatives_to_zero(data, degree, t):
    a, b = data.draw(lambdas_for(degree)), data.draw(lambdas_for(degree))
    for nu in range(4):
        total = basis(t, a, b, degree, nu).sum()
        assert total == pytest.approx(float(nu == 0), abs=8 * LIMITS[nu] * max(1, abs(a), abs(b)))


@given(st.data(), degrees, parameters, st.integers(0, 3))
def test_running_backwards_mirrors_the_basis(data, degree, t, nu):
    t = 1 - t  # so that 1 − t is exact
    a, b = data.draw(lambdas_for(degree)), data.draw(lambdas_for(degree))
    mirrored = (-1) ** nu * basis(1 - t, b, a, degree, nu)[::-1]
    limit = 2 * LIMITS[nu] * max(1, abs(a), abs(b))
    np.testing.assert_allclose(basis(t, a, b, degree, nu), mirrored, rtol=0, atol=limit)


@given(parameters, lambdas_for(3), lambdas_for(3), st.integers(0, 2))
def test_the_cubics_slope_is_the_quadratic_of_differences(t, a, b, nu):
    weights = basis(t, a, b, degree=3, nu=nu + 1)
    differences = basis(t, a, b, degree=2, nu=nu)
    expected = np.append(0.0, differences) - np.append(differences, 0.0)
    np.testing.assert_allclose(weights, expected, rtol=0, atol=2e-14 * max(1, abs(a), abs(b)))


@given(st.data(), degrees)
def test_no_weight_is_negative_within_the_convex_hull_range(data, degree):
    a, b = (data.draw(lambdas_for(degree, *CONVEX_HULL_RANGE[degree])) for _ in range(2))
    assert basis(T, a, b, degree).min() >= -2e-15 * max(1, abs(a), abs(b))


@pytest.mark.parametrize("degree", [2, 3])
def test_the_convex_hull_range_is_sharp(degree):
    low, high = CONVEX_HULL_RANGE[degree]
    assert basis(T, high + 0.01, 0.0, degree).min() < -1e-10
    assert basis(T, 0.0, high + 0.01, degree).min() < -1e-10
    assert basis(T, low - 0.01, low - 0.01, degree).min() < -1e-5
    if degree == 3:
        assert basis(T, low - 0.01, 0.0, degree).min() < -1e-5
    else:  # one parameter alone may go further down
        assert basis(T, -17.0, 0.0, degree).min() >= 0


def test_interpolating_weights_pick_one_control_point():
    quadratic = basis(0.5, INTERPOLATING[2], INTERPOLATING[2], degree=2)
    np.testing.assert_allclose(quadratic, [0, 1, 0], rtol=0, atol=5e-15)
    np.testing.assert_allclose(basis([0.0, 1.0], *[INTERPOLATING[3]] * 2), np.eye(4)[1:3], rtol=0, atol=9e-15)


def test_the_slope_at_a_joint_vanishes_where_it_should():
    assert basis(1.0, 0.3, JOINT_SLOPE_ZERO, degree=2, nu=1)[2] == pytest.approx(0, abs=1e-15)
    assert basis(1.0, 0.3, JOINT_SLOPE_ZERO - 0.1, degree=2, nu=1)[2] < 0


def test_arguments_broadcast():
    assert basis(0.5, 0, 1).shape == (4,)
    assert basis(T[:, None], [0.0, 1.0], 0.5, degree=2).shape == (401, 2, 3)
    np.testing.assert_array_equal(basis(T[:, None], [0.0, 1.0], 0.5)[7, 1], basis(T[7], 1.0, 0.5))


@pytest.mark.parametrize("degree", [2, 3])
def test_a_mode_and_its_lambda_name_each_other(degree):
    for mode in (Mode.TRIGONOMETRIC, Mode.HYPERBOLIC, Mode.INTERPOLATING):
        lam = lambda_of(mode, degree)
        assert mode_of(lam, lam, degree) is mode
        assert mode_of(lam, 0.5, degree) is mode_of(lam, np.nextafter(lam, 9), degree) is Mode.BLEND
    with pytest.raises(ValueError, match="blend"):
        lambda_of(Mode.BLEND, degree)


@pytest.mark.parametrize(("degree", "nu", "message"), [(4, 0, "degree must be 2 or 3, not 4"), (3, 4, "nu")])
def test_an_unknown_degree_or_order_is_refused(degree, nu, message):
    with pytest.raises(ValueError, match=message):
        basis(0.5, 0, 0, degree, nu)
