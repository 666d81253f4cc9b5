import pytest

from theditor.model.words import symbols


@pytest.mark.parametrize(
    ("indices", "named"),
    [
        ([5, 6], "λ₅, λ₆"),
        ([0, 1, 2, 3, 5], "λ₀ … λ₃, λ₅"),
        ([0, 2, 3, 7, 8, 9], "λ₀, λ₂, λ₃, λ₇ … λ₉"),
        (range(100), "λ₀ … λ₉₉"),
        (range(0, 100, 2), "λ₀ … λ₉₈"),
    ],
)
def test_symbols_are_named_one_by_one_or_run_by_run(indices, named):
    assert symbols("λ", indices) == named
