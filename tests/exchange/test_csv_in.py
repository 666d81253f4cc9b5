"""Tables of points as spreadsheets, other programs and this one write them."""

import numpy as np
import pytest
from exchange_curves import BLEND, SPACE
from hypothesis import given
from hypothesis import strategies as st

from theditor.drawing import Drawing, DrawingError, Item
from theditor.exchange import Options, read, write
from theditor.spline import INTERPOLATING, Curve, known, nearest

numbers = st.floats(-1e12, 1e12, allow_subnormal=False)
tables = st.integers(2, 3).flatmap(
    lambda width: st.lists(st.lists(numbers, min_size=width, max_size=width), min_size=2, max_size=6)
)


def curves(text, **options):
    return [item.curve for item in read(text.encode(), ".csv", Options(**options)).drawing]


def control_points(text):
    [curve] = curves(text, control_points=True)
    return curve.control_points.tolist()


@given(
    tables, st.sampled_from(["\t", ";", "; ", " ", "   ", ",", ", "]), st.sampled_from(["\n", "\r\n", "\n\n"])
)
def test_what_programs_write_is_read_bit_for_bit(rows, separator, end):
    assert control_points(end.join(separator.join(map(repr, row)) for row in rows) + end) == rows


@given(tables, st.sampled_from(["\t", ";", " "]))
def test_decimal_commas_where_they_do_not_separate(rows, separator):
    assert control_points("\n".join(separator.join(map(repr, row)).replace(".", ",") for row in rows)) == rows


@pytest.mark.parametrize(
    ("text", "rows"),
    [
        ("1,2\n3,4", [[1, 2], [3, 4]]),
        ("1,5 2\n3 4", [[1.5, 2], [3, 4]]),
        ("1;2;3\n4;5;6", [[1, 2, 3], [4, 5, 6]]),
        ("  −1\t2\n3\t4", [[-1, 2], [3, 4]]),
        (" 1 , 2 \n 3 , 4 ", [[1, 2], [3, 4]]),
        ("\ufeffX;Y\n1,5;2\n3;4", [[1.5, 2], [3, 4]]),
        ("y,name,x\n1,a b,2\n3,c d,4", [[2, 1], [4, 3]]),
    ],
)
def test_examples(text, rows):
    assert control_points(text) == rows


def test_unicode_text_of_a_spreadsheet():
    [item] = read("x\ty\n1\t2\n3\t4\n".encode("utf-16"), ".csv", Options(control_points=True)).drawing
    assert item.curve.control_points.tolist() == [[1, 2], [3, 4]]


def test_lambda_makes_control_points():
    [curve] = curves("x,y,λ\n0,0,1\n1,2,0.5\n3,1,0\n")
    assert curve == Curve([[0, 0], [1, 2], [3, 1]], [1, 0.5, 0], ends="clamped")


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("closed", [False, True])
def test_sparse_points_are_passed_through(degree, closed):
    points = np.array([[0, 0], [1, 3], [4, 2], [5, -1], [2, -2.0]])
    rows = [*points, points[0]] if closed else points
    imported = read("\n".join(f"{x},{y}" for x, y in rows).encode(), ".csv", Options(degree=degree))
    [item] = imported.drawing
    assert item.curve.closed == closed
    assert set(item.curve.lambdas) == {INTERPOLATING[degree]}
    assert nearest(item.curve, points)[1].max() < 1e-12
    assert imported.deviation == 0
    assert imported.notes == ("The curve passes through each point, as λ = λ*.",)


def test_samples_too_few_to_tell_the_curve_within_the_tolerance_are_passed_through():
    points = known.catenary().sample(16)
    [curve] = curves("\n".join(f"{x!r} {y!r}" for x, y in points.tolist()))
    assert (curve.control_points == points).all()
    assert (curve.lambdas == INTERPOLATING[3]).all()


def test_a_table_written_here_comes_back_within_the_tolerance():
    drawing = Drawing([Item(BLEND, "One, two"), Item(SPACE, "Strut")])
    imported = read(write(drawing, ".csv", Options(samples=40)).data, ".csv", Options(tolerance=1e-3))
    assert [item.name for item in imported.drawing] == ["One, two", "Strut"]
    for old, new in zip(drawing, imported.drawing, strict=True):
        size = np.ptp(old.curve.sample(40), axis=0).max()
        assert len(new.curve.control_points) < 100
        ours = np.pad(old.curve.sample(40), ((0, 0), (0, 3 - old.curve.dimension)))
        assert nearest(new.curve, ours[::20])[1].max() <= 1.001e-3 * size
    assert imported.deviation > 0


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "no points: the table is empty"),
        ("x,y\n", "a header line alone"),
        ("hello world", "line 1, “hello world”, is neither a row of numbers nor a header"),
        ("1 2\n\n1 x\n3 4", "line 3, column 2: “x” is no number"),
        ("1,2\n3,\n5,6", "line 2, column 2: a number is missing"),
        ("1\n2", "line 1 has 1 column"),
        ("1,2,3,4", "line 1 has 4 columns"),
        ("1 2\n1 2 3", "line 2 has 3 columns, and the first line has 2"),
        ("1,5\t2.5\n1\t2", "both points and commas"),
        ("1 inf\n1 2", "line 1, column 2: “inf” is no number"),
        ("1,2", "line 1 makes no curve"),
        ("1,1e99\n1,2", "lines 1 to 2 make no curve"),
        ('x,y\n1,"2\n3,4', 'line 2, “1,"2”, is no row of a table'),
    ],
)
def test_what_is_no_table_is_refused_with_its_line(text, words):
    with pytest.raises(DrawingError, match=f"(?i){words}"):
        read(text.encode(), ".csv")


@given(st.text('0123456789.,;\t\n -e"xyλ') | st.text() | st.binary())
def test_anything_is_a_table_or_refused(text):
    data = text.encode(errors="replace") if isinstance(text, str) else text
    try:
        drawing = read(data, ".csv").drawing
    except DrawingError:
        return
    assert all(len(item.curve.control_points) >= 2 for item in drawing)
