import json
from pathlib import Path

import pytest
from drawing_strategies import drawings
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

from theditor.drawing import Drawing, DrawingError, Item, decode, encode, json_schema, migrations
from theditor.resources import gallery, resource
from theditor.spline import Curve

DATA = Path(__file__).parents[1] / "data"

MINIMAL = """\
{"format": "theditor", "version": 1, "curves": [
 {"points": [[0, 0], [1, 2], [3, 0]],
  "lambda": [0, 1, 0.5],
  "degree": 2, "closed": false}]}
"""

LAYOUT = """\
{"format": "theditor", "version": 1,
 "curves": [
  {"name": "Λ \\"1\\"", "degree": 3, "closed": false, "ends": "clamped",
   "points": [
    [0.1, 1.0],
    [1e-7, -2.5]
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


HUGE = "1" + 5000 * "0"

# What is changed in MINIMAL, what into, and what is said of it.
FAULTS = [
    # a value
    (
        "[1, 2]",
        "[1, true]",
        "curves[0].points[1][1] (line 2, column 26) must be a number from -1e+12 to 1e+12.",
    ),
    (
        "[1, 2]",
        '[1, "2"]',
        "curves[0].points[1][1] (line 2, column 26) must be a number from -1e+12 to 1e+12.",
    ),
    (
        "[1, 2]",
        "[1, 1e400]",
        "curves[0].points[1][1] (line 2, column 26) must be a number from -1e+12 to 1e+12.",
    ),
    (
        "[1, 2]",
        "[null, 2]",
        "curves[0].points[1][0] (line 2, column 23) must be a number from -1e+12 to 1e+12.",
    ),
    (
        "[1, 2]",
        "[1, -2e12]",
        "curves[0].points[1][1] (line 2, column 26) must be a number from -1e+12 to 1e+12.",
    ),
    ("[1, 2]", "[1]", "curves[0].points[1] (line 2, column 22) must be a list of 2 or 3 numbers."),
    ("[1, 2]", "\n7", "curves[0].points[1] (line 3, column 1) must be a list of 2 or 3 numbers."),
    (
        "[1, 2]",
        "[1, 2, 3]",
        "curves[0].points[1] (line 2, column 22) must have 2 coordinates like the points before it, but has 3.",
    ),
    ("0.5]", "1e7]", "curves[0].lambda[2] (line 3, column 20) must be a number from -1e+06 to 1e+06."),
    (
        "0.5]",
        f"{HUGE}]",
        "curves[0].lambda[2] (line 3, column 20) must be a number from -1e+06 to 1e+06.",
    ),
    (
        "0.5]",
        "0.5, 1]",
        "curves[0].lambda (line 3, column 13) must have one number per point, but 3 points have 4 λ.",
    ),
    (
        "[1, 2], ",
        "",
        "curves[0].points (line 2, column 13) must be at least 3 points for a free curve of degree 2, "
        "but there are 2.",
    ),
    ('"degree": 2', '"degree": 4', "curves[0].degree (line 4, column 13) must be 2 or 3."),
    ('"degree": 2', '"degree": 2.0', "curves[0].degree (line 4, column 13) must be 2 or 3."),
    ("false", '"no"', "curves[0].closed (line 4, column 26) must be true or false."),
    ("false", "0", "curves[0].closed (line 4, column 26) must be true or false."),
    ("false", 'false, "ends": "tied"', 'curves[0].ends (line 4, column 41) must be "free" or "clamped".'),
    (
        "false",
        'false, "style": {"width": 3, "color": "red"}',
        'curves[0].style.color (line 4, column 64) must be a colour such as "#334155".',
    ),
    (
        "false",
        'false, "style": {"color": "#334155\\n"}',
        'curves[0].style.color (line 4, column 52) must be a colour such as "#334155".',
    ),
    (
        "false",
        'false, "style": {"width": 0}',
        "curves[0].style.width (line 4, column 52) must be a number from 0.1 to 100.",
    ),
    (
        "false",
        'false, "name": "a\\nb"',
        "curves[0].name (line 4, column 41) must be one line of text without control characters, "
        "at most 200 characters long.",
    ),
    # fields
    (', "closed": false', "", 'curves[0] (line 2, column 2) must have the field "closed".'),
    (
        ', "curves"',
        ', "curve"',
        "The file (line 1, column 38) has the field 'curve', which is not part of the format.",
    ),
    (
        "false",
        'false, "colour": 1',
        "curves[0] (line 4, column 33) has the field 'colour', which is not part of the format.",
    ),
    (
        "false",
        f'false, "` - at `$.é\\n{"x" * 60}": 1',
        rf"curves[0] (line 4, column 33) has the field '` - at `$.\xe9\n{'x' * 28}\u2026', "
        "which is not part of the format.",
    ),
    ("false", 'false, "closed": true', "curves[0] (line 4, column 33) has the field 'closed' twice."),
    (
        '"version": 1',
        '"version": 1, "version": 1',
        "The file (line 1, column 38) has the field 'version' twice.",
    ),
    # what kind of file
    (
        '"theditor"',
        '"other"',
        'format (line 1, column 12) must be "theditor": this is not a drawing of this program.',
    ),
    (
        '"format": "theditor", ',
        "",
        'The file must have the field "format": this is not a drawing of this program.',
    ),
    (
        '"version": 1',
        '"version": 7, "news": {}',
        "version (line 1, column 35) is 7, and 1 is the newest this program reads: "
        "open it with a newer release of theditor.",
    ),
    (', "version": 1', "", 'The file must have the field "version".'),
    *(
        (
            '"version": 1',
            f'"version": {value}',
            "version (line 1, column 35) must be a whole number such as 1.",
        )
        for value in ("true", "0", "1.0", "1e400", '"1"', "[1e400]", HUGE)
    ),
    (MINIMAL, "[1, 2]", "The file must be an object with format, version and curves."),
    ("[\n", "{}\n,", "The text is not JSON: object keys must be strings at line 2, column 3."),
]
# Valid JSON, but what is wrong with it no schema can say: equal lengths, and numbers as they are written.
BEYOND_A_SCHEMA = {"but 3 points have 4 λ", '"degree": 2.0', '"version": 1.0', "twice"}

# Not JSON in UTF-8.
TEXT_FAULTS = [
    ("[\n", "\n", "The text is not JSON: expected ',' or '}' at line 4, column 32."),
    ("[1, 2]", "[1, NaN]", "The text is not JSON: invalid character at line 2, column 26."),
    ("[1, 2]", "[1, -Infinity]", "The text is not JSON: invalid character at line 2, column 27."),
    ("[1, 2]", "\n\n é", "The text is not JSON: invalid character at line 4, column 2."),
    ("]}\n", "]} é", "The text is not JSON: trailing characters at line 4, column 36."),
    ("]}\n", "]", "The text is not complete JSON: it ends too early, at line 4, column 33."),
    (MINIMAL, "", "The text is not complete JSON: it ends too early, at line 1, column 1."),
    ("false", '"\udce9"', "The text is not UTF-8 at line 4, column 27."),
    (
        "false",
        'false, "name": "\\ud800"',
        r"The text is not Unicode: an escape from \ud800 to \udfff stands alone, which is no character.",
    ),
    ("false", f'false, "more": {"[" * 100_000}', "Lists or objects are nested too deeply for a drawing."),
]


def changed(old, new):
    assert old in MINIMAL
    return MINIMAL.replace(old, new, 1).encode(errors="surrogateescape")


def refusal(data):
    with pytest.raises(DrawingError) as caught:
        decode(data)
    return str(caught.value)


@pytest.mark.parametrize(("old", "new", "sentence"), FAULTS + TEXT_FAULTS)
def test_every_fault_is_one_sentence_with_its_place(old, new, sentence):
    assert refusal(changed(old, new)) == sentence


def test_a_byte_order_mark_is_passed_over_and_other_encodings_are_named():
    assert decode(b"\xef\xbb\xbf" + MINIMAL.encode()) == decode(MINIMAL.encode())
    wrong = MINIMAL.replace("false", '"no"')
    assert refusal(b"\xef\xbb\xbf" + wrong.encode()) == refusal(wrong.encode())
    for encoding in ("utf-16", "utf-16-le", "utf-16-be", "utf-32"):
        assert refusal(MINIMAL.encode(encoding)) == f"The text is {encoding[:6].upper()}: save it as UTF-8."


def test_a_million_points_are_read_and_a_fault_is_found_far_down():
    def text(count, last):
        points, lambdas = "[0,0]," * (count - 1) + last, "0," * (count - 1) + "0"
        return MINIMAL.replace("[0, 0], [1, 2], [3, 0]", points).replace("0, 1, 0.5", lambdas).encode()

    assert len(decode(text(10**6, "[1,1]"))[0].curve.control_points) == 10**6
    fault = refusal(text(10**4, "[1,true]"))
    assert fault.startswith("curves[0].points[9999][1] (line 2, column 60011) must be a number")


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


# The schema


@pytest.fixture(scope="module")
def validator():
    schema = json_schema()
    Draft202012Validator.check_schema(schema)
    return Draft202012Validator(schema)


def test_the_schema_is_shipped_as_it_is():
    shipped = resource("theditor.schema.json").read_text("utf-8")
    assert json.loads(shipped) == json_schema(), "run `theditor schema > resources/theditor.schema.json`"


@pytest.mark.parametrize(
    "path", [*(p.path for p in gallery()), *DATA.glob("version-*.json")], ids=lambda p: p.stem
)
def test_the_schema_accepts_what_is_read(validator, path):
    validator.validate(json.loads(path.read_text("utf-8")))


@given(drawings)
def test_the_schema_accepts_what_is_written(drawing):
    Draft202012Validator(json_schema()).validate(json.loads(encode(drawing)))


@pytest.mark.parametrize(("old", "new", "sentence"), FAULTS)
def test_the_schema_refuses_what_is_not_read(validator, old, new, sentence):
    beyond = any(part in new or part in sentence for part in BEYOND_A_SCHEMA)
    try:
        document = json.loads(changed(old, new))
    except ValueError:  # Python reads no number of so many digits
        pytest.skip("not readable here")
    assert validator.is_valid(document) == beyond


# Versions

SAMPLE = Drawing(
    [
        Item(Curve([[0.1, 1], [1e-7, -2.5]], [0, 8.912056875738365], ends="clamped"), 'Λ "1"', "#aBcDeF"),
        Item(
            Curve([[0, 0, 0], [1, 0, 1e12], [0, 1, 0]], 1.0, degree=2, closed=True),
            width=0.5,
            visible=False,
            locked=True,
        ),
        Item(Curve([[0, 0], [1, 2], [3, 0]], [0, 1, 0.5], degree=2)),
    ]
)


@pytest.mark.parametrize("path", sorted(DATA.glob("version-*.json")), ids=lambda p: p.stem)
def test_files_of_every_version_are_read(path):
    assert decode(path.read_bytes()) == SAMPLE


def test_an_older_version_is_brought_up_step_by_step(monkeypatch):
    """A format older than the first: there, a curve's name was called label."""

    def renamed(data):
        curves = [{("name" if k == "label" else k): v for k, v in c.items()} for c in data["curves"]]
        return {**data, "version": 1, "curves": curves}

    old = MINIMAL.replace('"version": 1', '"version": 0').replace("false", 'false, "label": "Old"')
    assert refusal(old.encode()) == "version (line 1, column 35) must be a whole number such as 1."
    monkeypatch.setitem(migrations.STEPS, 0, renamed)
    assert decode(old.encode())[0].name == "Old"
    assert decode(MINIMAL.encode())[0].name == "Curve"
    assert refusal(old.replace("0.5", "true").encode()) == (
        "curves[0].lambda[2] must be a number from -1e+06 to 1e+06."
    )
    twice = refusal(old.replace("false", 'true, "closed": false').encode())
    assert twice == "curves[0] (line 4, column 32) has the field 'closed' twice."


def test_steps_follow_each_other(monkeypatch):
    for old in (1, 2, 3):
        monkeypatch.setitem(migrations.STEPS, old, lambda data, old=old: {"steps": [*data["steps"], old]})
    assert migrations.migrated({"steps": []}, 2, 4) == {"steps": [2, 3]}
