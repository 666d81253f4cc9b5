import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from theditor.spline import MAX_LAMBDA, FormulaError
from theditor.spline.formula import evaluate

N = 7
CURRENT = np.array([0.5, -3, 8.25, 0, 1, 2, 4])

# Words of the language and of its surroundings, for texts that come close to being formulas.
WORDS = """
    i n λ l pi e 0 1 2.5 1e3 1e308 9999999 .5 + - * / % ** ^ // < <= > >= == != ( ) , if else
    sin cos tan asin acos atan sinh cosh tanh exp log sqrt abs floor ceil round min max sign
    and or not lambda True None . [ ] { } : := ' " = ; \\ # @ ~ is in import __class__ 1j λ1 − ∞
"""
words = st.lists(st.sampled_from(WORDS.split()))


@given(st.one_of(st.text(), words.map(" ".join), words.map("".join)))
@example("9**9**9**9")
@example("-" * 499 + "1")
@example("(" * 250 + "i" + ")" * 249)
@example("+".join(["i"] * 200))
@example("i" * 10**6)
@example("\ud800")
@example("1if 1else 2")
def test_any_text_gives_acceptable_lambdas_or_is_refused_as_a_formula(text):
    try:
        values = evaluate(text, N, CURRENT)
    except FormulaError:
        return
    assert values.shape == (N,)
    assert (np.abs(values) <= MAX_LAMBDA).all()


numbers = st.floats(-9, 9, allow_subnormal=False).map(lambda x: repr(abs(x)))
terms = st.recursive(
    st.one_of(numbers, st.sampled_from(["i", "n", "λ", "pi", "e"])),
    lambda t: st.one_of(
        st.tuples(t, st.sampled_from(["+", "-", "*"]), t).map(lambda x: f"({x[0]} {x[1]} {x[2]})"),
        t.map(lambda x: f"-{x}"),
        st.tuples(st.sampled_from(["sin", "cos", "atan", "tanh", "floor", "abs"]), t).map(
            "{0[0]}({0[1]})".format
        ),
        st.lists(t, min_size=1, max_size=3).map(lambda x: f"max({', '.join(x)})"),
        st.tuples(t, t, t, t).map("({0[0]} if {0[1]} < {0[2]} else {0[3]})".format),
    ),
    max_leaves=8,
)


@given(terms)
def test_formulas_mean_what_they_mean_in_python(text):
    def greatest(*values):
        return max(values)

    names = {name: getattr(math, name) for name in ("sin", "cos", "atan", "tanh", "floor", "pi", "e")}
    expected = [
        eval(text, {**names, "abs": abs, "max": greatest}, {"i": i, "n": N, "λ": lam})
        for i, lam in enumerate(CURRENT.tolist())
    ]
    if max(map(abs, expected)) <= MAX_LAMBDA:
        np.testing.assert_allclose(evaluate(text, N, CURRENT), expected, rtol=1e-9, atol=1e-7)
    else:
        with pytest.raises(FormulaError, match="at i = "):
            evaluate(text, N, CURRENT)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("sin(i/3)", np.sin(np.arange(7) / 3)),
        (" l + 1 ", CURRENT + 1),
        ("−2\n*i", -2.0 * np.arange(7)),
        ("i % 2", [0, 1, 0, 1, 0, 1, 0]),
        ("2 ** -i", 0.5 ** np.arange(7)),
        ("1 < i <= 3", [0, 0, 1, 1, 0, 0, 0]),
        ("(i == 2) - (i != 3)", [-1, -1, 0, 0, -1, -1, -1]),
        ("1/i if i > 0 else 9", [9, 1, 1 / 2, 1 / 3, 1 / 4, 1 / 5, 1 / 6]),
        ("min(i, 3, n - i)", [0, 1, 2, 3, 3, 2, 1]),
        ("sign(λ) * sqrt(abs(λ)) + round(ceil(0.2))", np.sign(CURRENT) * np.sqrt(np.abs(CURRENT)) + 1),
        ("log(exp(i)) + asin(sinh(0)) + acos(1) + tan(0) - cosh(0)", np.arange(7) - 1.0),
    ],
)
def test_formulas_worth_writing(text, expected):
    np.testing.assert_allclose(evaluate(text, N, CURRENT), expected, rtol=0, atol=1e-14)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "the formula is empty: write one such as"),
        ("1 + ", r"cannot be read .*: check brackets and operators"),
        ("1 + )i", "cannot be read at character 5"),
        ("λ*foo", "“foo” at character 3 is not understood: use numbers, i, n"),
        ("0,5", "“0,5” at character 1 has a comma: write decimals with a point"),
        ("2 + i^2", r"“2 \+ i\^2” at character 1 has a \^: write \*\* for powers"),
        ("sin", r"“sin” at character 1 needs brackets: write sin\(i\)"),
        ("1 + sin(1, 2)", r"“sin\(1, 2\)” at character 5 has the wrong number of values: sin takes one"),
        ("max()", "max takes one or more"),
        ("i.real", "“i.real” at character 1 is not understood"),
        ("().__class__", "is not understood"),
        ("True", "“True” at character 1 is not understood"),
        ("1e400", "“1e400” at character 1 is too large: write a smaller number"),
        ("1/(i - 3)", "at i = 3 the formula gives no finite λ: change it"),
        ("9**9**9**9", "at i = 0 the formula gives no finite λ"),
        ("10**i", r"at i = 7 the formula gives λ = 1e\+07: change it so that every λ is at most 1e\+06"),
        ("i" * 501, "has 501 characters: shorten it to 500"),
        ("+".join("i" * 200), "lies more than 100 operations deep: write it more simply"),
    ],
)
def test_what_is_no_formula_is_refused_with_place_and_cure(text, message):
    with pytest.raises(FormulaError, match=message):
        evaluate(text, 9, 0.0)


def test_without_current_values_a_formula_may_not_use_them():
    with pytest.raises(FormulaError, match="“λ” at character 5 has no value here: use i and n"):
        evaluate("i + λ", 3)
    assert evaluate("i", 0).shape == (0,)


def test_only_the_wanted_control_points_are_judged():
    np.testing.assert_array_equal(evaluate("1/i + λ", N, CURRENT, [1, 4]), [-2, 1.25])
    np.testing.assert_array_equal(evaluate("2", N, indices=[6, 3]), [2, 2])
    with pytest.raises(FormulaError, match="at i = 3 the formula gives no finite λ"):
        evaluate("1/(i - 3)", N, CURRENT, [2, 3])
    with pytest.raises(ValueError, match="there is no control point 7"):
        evaluate("i", N, indices=[7])
