import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from spline_strategies import LIMITS, curves, scale

from theditor.spline import bernstein
from theditor.spline.roots import sign_changes

T = np.linspace(0, 1, 17)

coefficients = arrays(np.float64, st.tuples(st.just(1), st.integers(2, 9)), elements=st.floats(-10, 10))


def at(polynomials, t):
    """The values at each t, by the definition's successive means."""
    values = np.repeat(polynomials[..., None], len(t), axis=-1)
    while values.shape[-2] > 1:
        values = (1 - t) * values[..., :-1, :] + t * values[..., 1:, :]
    return values[..., 0, :]


@given(curves())
def test_polynomials_stand_for_every_segment_and_its_derivatives(curve):
    u = np.arange(curve.segment_count)[:, None] + T
    for nu in range(4):
        values = at(bernstein.polynomials(curve.joint_form, curve.degree, nu), T).transpose(1, 2, 0)
        inner = slice(1, -1)  # the joint belongs to the next segment, too
        np.testing.assert_allclose(
            values[:, inner], curve(u, nu)[:, inner], rtol=0, atol=40 * LIMITS[nu] * scale(curve)
        )


@given(coefficients, coefficients)
def test_products_and_halves_keep_the_values(a, b):
    np.testing.assert_allclose(at(bernstein.product(a, b), T), at(a, T) * at(b, T), atol=1e-11)
    first, second = bernstein.halves(a)
    np.testing.assert_allclose(at(first, T), at(a, T / 2), atol=1e-13)
    np.testing.assert_allclose(at(second, T), at(a, (T + 1) / 2), atol=1e-13)
    np.testing.assert_allclose(bernstein.value(np.repeat(a, len(T), axis=0), T), at(a, T)[0], atol=1e-13)


@given(
    st.lists(st.integers(1, 15), min_size=1, max_size=6, unique=True),
    st.lists(st.integers(1, 15), max_size=1),
    st.sampled_from([-1.0, 1.0]),
)
def test_sign_changes_are_the_roots_of_odd_order(simple, double, sign):
    simple = sorted(simple)
    polynomial = np.array([[sign]])
    for root in (*simple, *double, *double):
        polynomial = bernstein.product(polynomial, np.array([[-root / 16, 1 - root / 16]]))
    found = sign_changes(polynomial, np.full(1, 1e-15 * np.abs(polynomial).max()), 1e-9)
    odd = np.array(simple) / 16
    assert len(found.t) == len(odd)
    # A root of order 3 is smeared by rounding.
    often = np.array([1 + 2 * double.count(root) for root in simple])
    assert (np.abs(found.t - odd) <= np.where(often > 1, 0.01, 1e-8)).all()
    assert (found.rising == (sign * (-1.0) ** np.arange(len(odd), 0, -1) < 0)).all()
    assert found.last[0] == sign


def test_what_vanishes_never_changes_sign():
    found = sign_changes(np.array([[1e-17, -1e-17, 1e-17], [0.0, 0.0, 0.0]]), np.full(2, 1e-16), 1e-9)
    assert len(found.t) == 0
    np.testing.assert_array_equal(found.first, 0)
