import json

import pytest
from drawing_strategies import drawings
from hypothesis import given
from hypothesis import strategies as st

from theditor.drawing import Drawing, DrawingError, Item, decode, encode
from theditor.spline import Curve

CURVE = '"points": [[0, 0], [1, 2], [3, 0]], "lambda": [0, 1, 0.5], "degree": 2, "closed": false'
MINIMAL = f'{{"format": "theditor", "version": 1, "curves": [{{{CURVE}}}]}}'

LAYOUT = """\
{"format": "theditor", "version": 1,
 "curves": [
  {"name": "Λ \\"1\\"", "degree": 3, "closed": false, "ends": "clamped",
   "points": [
    [0.1, 1.0],
    [1e-07, -2.5]
   ],
   "lambda": [
    0.0,
    8.912056875738365
   ],
   "style": {"color": "#aBcDeF", "width": 2.0}, "visible": true, "locked": false},
  {"name": "Curve", "degree": 2, "closed": true, "ends": "free",
   "points": [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 1000000000000.0],
    [0.0, 1.0, 0.0]
   ],
   "lambda": [
    1.0,
    1.0,
    1.0
   ],
   "style": {"color": "#334155", "width": 0.5}, "visible": false, "locked": true}
 ]}
"""


def bits(drawing):
    """Everything a drawing holds, with every float as its bits."""
    return [
        (
            *(i.curve.control_points.tobytes(), i.curve.lambdas.tobytes(), i.curve.dimension),
            *(i.curve.degree, i.curve.closed, i.curve.ends),
            *(i.name, i.color, i.width, i.visible, i.locked),
        )
        for i in drawing
    ]


@given(drawings)
def test_reading_back_gives_every_bit_and_writing_again_every_byte(drawing):
    data = encode(drawing)
    again = decode(data)
    assert bits(again) == bits(drawing)
    assert encode(again) == data


def test_the_layout_is_fixed_with_one_point_and_one_lambda_a_line():
    flat = Curve([[0.1, 1], [1e-7, -2.5]], [0, 8.912056875738365], ends="clamped")
    space = Curve([[0, 0, 0], [1, 0, 1e12], [0, 1, 0]], 1.0, degree=2, closed=True)
    drawing = Drawing([Item(flat, 'Λ "1"', "#aBcDeF"), Item(space, width=0.5, visible=False, locked=True)])
    assert encode(drawing).decode() == LAYOUT
    assert decode(LAYOUT.encode()) == drawing
    assert encode(Drawing()) == b'{"format": "theditor", "version": 1,\n "curves": []}\n'
    assert decode(encode(Drawing())) == Drawing()


def test_what_is_left_out_has_its_default():
    curve = Curve([[0, 0], [1, 2], [3, 0]], [0, 1, 0.5], degree=2)
    assert decode(MINIMAL.encode()) == Drawing([Item(curve, "Curve", "#334155", 2.0, True, False)])


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        # a field's value
        ("[1, 2]", "[1, true]", "curves[0].points[1][1] must be a number from -1e+12 to 1e+12."),
        ("[1, 2]", "[1, 1e400]", "curves[0].points[1][1] must be a number from -1e+12 to 1e+12."),
        ("[1, 2]", "[1, -2e12]", "curves[0].points[1][1] must be a number from -1e+12 to 1e+12."),
        ("[1, 2]", "[1]", "curves[0].points[1] must be a list of 2 or 3 numbers."),
        (
            "[1, 2]",
            "[1, 2, 3]",
            "curves[0].points[1] must have 2 coordinates like the points before it, but has 3.",
        ),
        ("0.5]", "1e7]", "curves[0].lambda[2] must be a number from -1e+06 to 1e+06."),
        (
            "0.5]",
            "0.5, 1]",
            "curves[0].lambda must have one number per point, but 3 points have 4 λ.",
        ),
        (
            "[1, 2], ",
            "",
            "curves[0].points must be at least 3 points for a free curve of degree 2, but there are 2.",
        ),
        ('"degree": 2', '"degree": 4', "curves[0].degree must be 2 or 3."),
        ('"degree": 2', '"degree": 2.0', "curves[0].degree must be 2 or 3."),
        ("false", '"no"', "curves[0].closed must be true or false."),
        ("false", 'false, "ends": "tied"', 'curves[0].ends must be "free" or "clamped".'),
        (
            "false",
            'false, "style": {"color": "red"}',
            'curves[0].style.color must be a colour such as "#334155".',
        ),
        ("false", 'false, "style": {"width": 0}', "curves[0].style.width must be a number from 0.1 to 100."),
        (
            "false",
            'false, "name": "a\\nb"',
            "curves[0]: A curve's name must be one line without control characters, not 'a\\nb'.",
        ),
        ("[{", "{", "The text is not JSON: expected ',' or '}' at line 1, column 137."),
        # fields
        (', "closed": false', "", 'curves[0] must have the field "closed".'),
        (', "curves"', ', "curve"', "the file has the field 'curve', which is not part of the format."),
        ("false", 'false, "colour": 1', "curves[0] has the field 'colour', which is not part of the format."),
        ("false", 'false, "closed": true', "curves[0].closed is given twice."),
        ('"version": 1', '"version": 1, "version": 1', "version is given twice."),
        # what kind of file
        ('"theditor"', '"other"', 'format must be "theditor": this is not a drawing of this program.'),
        (
            '"version": 1',
            '"version": 7, "news": {}',
            "version is 7, and 1 is the newest this program reads: open it with a newer release of theditor.",
        ),
        ('"version": 1', '"version": true', "version must be a whole number from 1."),
        (MINIMAL, "[1, 2]", "the file must be an object with format, version and curves."),
        # text
        ("[1, 2]", "[1, NaN]", "The text is not JSON: invalid character at line 1, column 73."),
        ("[1, 2]", "\n\n é", "The text is not JSON: invalid character at line 3, column 2."),
        ("}]}", "}]", "The text is not complete JSON: it ends too early, at line 1, column 139."),
        (MINIMAL, "", "The text is not complete JSON: it ends too early, at line 1, column 1."),
        (
            '{"format"',
            '\ufeff{"format"',
            "The text begins with a byte order mark: save it as UTF-8 without one.",
        ),
        ("false", '"\udce9"', "The text is not UTF-8 at line 1, column 133."),
        (
            "false",
            f'false, "more": {"[" * 100_000}',
            "Lists or objects are nested too deeply for a drawing.",
        ),
    ],
)
def test_every_fault_is_one_sentence_with_its_place(old, new, sentence):
    assert old in MINIMAL
    with pytest.raises(DrawingError) as caught:
        decode(MINIMAL.replace(old, new, 1).encode(errors="surrogateescape"))
    assert str(caught.value) == sentence


def test_a_name_may_look_like_a_list_or_an_object():
    name = '[1] {"a": 1, "a": [2]} \\[3]\\'
    drawing = decode(encode(Drawing([Item(Curve([[0, 0], [1, 1]], ends="clamped"), name)])))
    assert drawing[0].name == name


@given(st.data())
def test_damage_is_refused_or_read_as_what_it_says(data):
    """Any damage either leaves a valid file, which says the same to a JSON reader, or is a DrawingError."""
    good = LAYOUT.encode()
    start = data.draw(st.integers(0, len(good) - 1))
    stop = data.draw(st.integers(start, min(start + 3, len(good))))
    bad = good[:start] + data.draw(st.binary(max_size=3)) + good[stop:]
    try:
        drawing = decode(bad)
    except DrawingError:
        return
    assert [i.curve.control_points.tolist() for i in drawing] == [
        c["points"] for c in json.loads(bad)["curves"]
    ]
