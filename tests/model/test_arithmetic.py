import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from theditor.model.arithmetic import calculated, number_in
from theditor.model.words import exact

numbers = st.floats(allow_nan=False, allow_infinity=False)


@given(numbers)
def test_the_exact_text_of_a_number_means_that_number(number):
    text = exact(number)
    for typed in (text, text.replace(".", ","), f" {text.replace('-', '−')} "):
        assert number_in(typed) == number
        assert calculated(typed) == calculated(typed, 7.0) == number


@given(st.floats(-1e100, 1e100), st.floats(1e-100, 1e100))
def test_a_change_goes_on_from_the_present_value(present, step):
    text = exact(step)
    assert calculated(f"+{text}", present) == present + step
    assert calculated(f"+-{text}", present) == present - step
    assert calculated(f"*{text}", present) == present * step
    assert calculated(f"/{text}", present) == present / step


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("2/3", 2 / 3),
        ("(1+2)*4", 12),
        ("1,5 + 2,5", 4),
        ("2**-1", 0.5),
        ("-2**2", -4),
        ("007", 7),
        ("--3", 3),
    ],
)
def test_simple_arithmetic(text, number):
    assert calculated(text) == calculated(text, 100.0) == number


def test_precedence_reaches_the_present_value():
    assert calculated("*2+1", -3.0) == -5.0
    assert calculated("+1*2", -3.0) == -1.0


@pytest.mark.parametrize("text", ["+1", "*2", "/2"])
def test_without_a_present_value_there_is_nothing_to_go_on_from(text):
    with pytest.raises(ValueError, match="go on from"):
        calculated(text)


@pytest.mark.parametrize(
    "text",
    ["1,234.5", "1.234,5", "1,2,3", "1 000", "1_000", "9**9**9", "1/0", "(-8)**(1/3)", "1e400", "2(3)"],
)
def test_what_is_ambiguous_or_no_number_is_refused(text):
    with pytest.raises(ValueError, match=r"."):
        calculated(text)


@given(st.text("0123456789.,+-*/()eE −") | st.text(), st.none() | numbers)
@example("(" * 190, None)
@example("-" * 199 + "1", None)
@example("__import__('os')", None)
def test_any_text_gives_a_finite_number_or_a_refusal(text, present):
    for read in (number_in, lambda text: calculated(text, present)):
        try:
            result = read(text)
        except ValueError:
            continue
        assert isinstance(result, float)
        assert abs(result) < float("inf")
