import pytest
from hypothesis import given
from hypothesis import strategies as st

from theditor.model.number_table import points_in

numbers = st.floats(allow_nan=False, allow_infinity=False)
tables = st.integers(2, 3).flatmap(
    lambda width: st.lists(st.lists(numbers, min_size=width, max_size=width), min_size=1, max_size=6)
)


@given(
    tables, st.sampled_from(["\t", ";", "; ", " ", "   ", ",", ", "]), st.sampled_from(["\n", "\r\n", "\n\n"])
)
def test_what_programs_write_is_read_bit_for_bit(rows, separator, end):
    assert points_in(end.join(separator.join(map(repr, row)) for row in rows) + end) == rows


@given(tables, st.sampled_from(["\t", ";", " "]))
def test_decimal_commas_where_they_do_not_separate(rows, separator):
    text = "\n".join(separator.join(repr(x).replace(".", ",") for x in row) for row in rows)
    assert points_in(text) == rows


@pytest.mark.parametrize(
    ("text", "rows"),
    [
        ("1,2\n3,4", [[1, 2], [3, 4]]),
        ("1,5 2\n3 4", [[1.5, 2], [3, 4]]),
        ("1;2;3", [[1, 2, 3]]),
        ("  −1\t2\n", [[-1, 2]]),
        (" 1 , 2 \n 3 , 4 ", [[1, 2], [3, 4]]),
    ],
)
def test_examples(text, rows):
    assert points_in(text) == rows


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "no text"),
        ("hello world", "line 1, “hello world”, is no row of numbers"),
        ("1 2\n\n1 x", "line 3, “1 x”, is no row of numbers"),
        ("1\n2", "line 1, “1”, has not two or three columns"),
        ("1,2,3,4", "has not two or three columns"),
        ("1 2\n1 2 3", "line 2, “1 2 3”, has not as many columns"),
        ("1,5\t2.5", "both points and commas"),
        ("1 inf", "no row of numbers"),
    ],
)
def test_what_is_no_table_is_refused_with_its_line(text, words):
    with pytest.raises(ValueError, match=words):
        points_in(text)


@given(st.text("0123456789.,;\t\n -e") | st.text())
def test_any_text_is_a_table_or_refused(text):
    try:
        rows = points_in(text)
    except ValueError:
        return
    assert {len(row) for row in rows} in ({2}, {3})
