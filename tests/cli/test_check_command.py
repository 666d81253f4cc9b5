import json
import sys

from theditor.cli import main
from theditor.drawing import Drawing, Item, save
from theditor.resources import resource
from theditor.spline import JOINT_SLOPE_ZERO, Curve, Mode, basis, continuity, known

FIGURE_10 = resource("gallery") / "figure-10.json"


def test_check_says_what_is_in_a_file(capsys, tmp_path):
    plane = Curve([[0, 0], [1, 2], [3, 2], [4, 0]], 1.0, degree=2, closed=True)
    space = Curve([[0, 0, 0], [1, 1, 1]], 0.5, ends="clamped")
    save(Drawing([Item(plane, "Ring"), Item(space, "Strut")]), tmp_path / "two.json")
    save(Drawing(), tmp_path / "none.json")
    assert main(["check", str(FIGURE_10), str(tmp_path / "two.json"), str(tmp_path / "none.json")]) == 0
    lines = capsys.readouterr().out.splitlines(keepends=True)
    promise = "as promised within 1e−9 of the size of the terms (largest jump"
    told = [line for line in lines if not line.lstrip().startswith(("Segment", "Joint", *"0123456789"))]
    assert "".join(told) == (
        f"{FIGURE_10}: 1 curve\n"
        "  Figure 10: cubic, open with free ends, 13 points, 10 segments; segments 1 trigonometric, 2 blend, "
        "3 interpolating, 4 blend, 5–7 hyperbolic, 8–9 blend, 10 trigonometric\n"
        f"{tmp_path / 'two.json'}: 2 curves\n"
        "  Ring: quadratic, closed, 4 points, 4 segments; all hyperbolic\n"
        "  Strut: cubic, open with clamped ends, in space, 2 points, 1 segment; blend\n"
        "    no joints: the curve is one segment\n"
        f"{tmp_path / 'none.json'}: 0 curves\n"
    )
    sums = [line.strip() for line in lines if promise in line]
    assert sums[0].startswith(f"9 joints, all C² {promise}")
    assert sums[1].startswith(f"4 joints, all C¹ {promise}")
    assert sums[1].endswith("the curvature jumps at 2")


def test_check_measures_every_joint_of_a_short_curve_and_explains_the_remarkable_ones(capsys, tmp_path):
    points = [[0, 0], [1, 2], [3, -1], [4, 1], [6, 0], [7, 3]]
    low = Curve(points, [0, -5, 5, -3, 0.97, -5], degree=2)
    nearly = Curve(points[:4], [0, 0.97, 1, 0])
    save(Drawing([Item(low), Item(nearly.with_(degree=2))]), tmp_path / "low.json")
    assert main(["check", str(tmp_path / "low.json")]) == 0
    lines = [line.strip() for line in capsys.readouterr().out.splitlines()]
    assert "Segment 1: basis function q₂ is negative near t = 0.35; the convex hull no longer bounds" in str(
        lines
    )
    assert "Segment 1: λ₁ = 0.97: set to 1 to make it a hyperbola arc" in lines
    titles = lines.index("Joint  Position  Jump of C  of C′  of C″  of κ  Measured  Promised")
    rows = [line.split() for line in lines[titles + 1 : titles + 4]]
    assert [row[0] for row in rows] == ["2", "3", "4"]
    assert [row[1:3] for row in rows] == [["(2,", "0.5)"], ["(3.5,", "0)"], ["(5,", "0.5)"]]
    assert all(float(row[3].replace("−", "-")) < 1e-15 < float(row[5]) for row in rows)
    assert [row[7:] for row in rows] == [
        ["C¹", "G¹", "✓", *end] for end in (["C¹"], ["C¹,", "reversed"], ["C¹"])
    ]
    assert lines[titles + 4].startswith("Joint 3 at (3.5, 0)")
    assert lines[titles + 4].endswith("the velocity reverses at joint 3, which makes a cusp or a loop.")
    for number, end in zip("₁₅", lines[titles + 5 : titles + 7], strict=True):
        assert end.startswith(f"λ{number} = −5 is below −2.648…: the velocity at joint")


def test_check_sums_up_a_long_curve(capsys, tmp_path):
    curve = Curve([[i, i % 2] for i in range(103)], -20.0)
    save(Drawing([Item(curve)]), tmp_path / "long.json")
    assert main(["check", str(tmp_path / "long.json")]) == 0
    lines = [line.strip() for line in capsys.readouterr().out.splitlines()]
    assert "100 segments with a negative basis function: there the convex hull is no bound" in lines
    assert sum(line.startswith("Joint") for line in lines) == 20
    assert "… and 79 joints more with a remark" in lines


def test_check_names_the_segments_that_are_known_curves(capsys):
    assert main(["check", str(FIGURE_10)]) == 0
    lines = [
        line.strip()
        for line in capsys.readouterr().out.splitlines()
        if "Segment" in line and "basis" not in line
    ]
    assert [line for line in lines if "general" not in line] == [
        "Segment 1: trochoid, prolate, rolling radius 0.63662, arm 1, origin (0, 0.36338), 0°–90°; "
        "(x, y) = (t − sin(πt/2), 1 − cos(πt/2)), t ∈ [0, 1]",
        "Segment 5: catenary, parameter 1, vertex (0, 2), from τ = 1 to 0; "
        "(x, y) = (1 − t, 1 + cosh(1 − t)), t ∈ [0, 1]",
        "Segment 6: hyperbola arc, centre (0, 1), semi-axes 1 and 1, turned by 90°, from τ = 0 to 1; "
        "(x, y) = (−sinh t, 1 + cosh t), t ∈ [0, 1]",
        "Segment 10: ellipse arc, centre (−2, 0), semi-axes 1 and 0.5, 270°–360°; "
        "(x, y) = (−2 + sin(πt/2), −0.5 cos(πt/2)), t ∈ [0, 1]",
    ]
    assert [line.split(";")[0] for line in lines if "general" in line] == [
        "Segment 7: general hyperbolic arc"
    ]


def test_check_counts_the_names_of_a_long_curve(capsys, tmp_path):
    save(Drawing([Item(known.sine(quarters=30))]), tmp_path / "long.json")
    assert main(["check", str(tmp_path / "long.json")]) == 0
    assert "\n    30 × sine wave\n" in capsys.readouterr().out


def test_check_counts_modes_that_would_make_a_long_list(capsys, tmp_path):
    curve = Curve([[i, i % 3] for i in range(103)]).with_mode(range(0, 100, 5), Mode.HYPERBOLIC)
    save(Drawing([Item(curve)]), tmp_path / "long.json")
    assert main(["check", str(tmp_path / "long.json")]) == 0
    assert "100 segments; 41 trigonometric, 20 hyperbolic, 39 blend\n" in capsys.readouterr().out


def test_check_tells_where_a_curve_stands_still_and_that_this_breaks_no_promise(capsys, tmp_path):
    curve = Curve([[0, 0], [1, 2], [3, 2], [4, 0]], JOINT_SLOPE_ZERO, degree=2)
    save(Drawing([Item(curve)]), tmp_path / "still.json")
    assert main(["check", str(tmp_path / "still.json")]) == 0
    joint, *ends, certificate = capsys.readouterr().out.splitlines()[-4:]
    assert certificate.startswith("    1 joint, C¹ as promised")
    assert certificate.endswith("the curve stands still at 1")
    assert joint.startswith("    Joint 2 at (2, 2): C¹; the promised C¹ holds. The curve stands still here")
    for number, end in zip((1, 3), ends, strict=True):
        assert end.endswith(
            f" = −2.648…: the curve stands still at joint {number}, where it is C¹ but not G¹."
        )


def test_check_names_every_joint_that_breaks_its_promise_and_ends_with_1(capsys, tmp_path, monkeypatch):
    def wrong(t, start, end, degree, nu):
        values = basis(t, start, end, degree, nu)
        values[start == 3, -1] *= 1 + 1e-6
        return values

    monkeypatch.setattr(sys.modules[continuity.__module__], "basis", wrong)
    curve = Curve([[0, 0], [1, 3], [3, 2], [5, 1], [6, 1], [7, 0], [9, 2]], [0, 0, 3, 0, 0, 0, 0])
    save(Drawing([Item(curve)]), tmp_path / "wrong.json")
    assert main(["check", str(tmp_path / "wrong.json"), str(FIGURE_10)]) == 1
    out = capsys.readouterr().out
    assert "    1 of 3 joints fails the promised C² within 1e−9 of the size of the terms" in out
    (row,) = (line for line in out.splitlines() if line.endswith("✗ C² fails"))
    assert row.split()[0] == "3"
    (joint,) = (line for line in out.splitlines() if "fails: " in line)
    assert joint.startswith("    Joint 3 at (")
    assert "the promised C² fails: the position jumps by" in joint


def test_check_says_what_is_wrong_and_goes_on(capsys, tmp_path):
    bad = tmp_path / "bad.json"
    bad.write_text('{"format": "theditor", "version": 2}')
    assert main(["check", str(bad), str(tmp_path / "no.json"), str(FIGURE_10)]) == 1
    wrong, missing, good, *_ = capsys.readouterr().out.splitlines()
    assert wrong.startswith(
        f"{bad}: version (line 1, column 35) is 2, and 1 is the newest this program reads"
    )
    assert missing == f"{tmp_path / 'no.json'} cannot be read: there is no such file or folder."
    assert good == f"{FIGURE_10}: 1 curve"


def test_check_says_how_a_foreign_file_becomes_a_drawing(capsys, tmp_path):
    (tmp_path / "picture.svg").write_text("<svg/>")
    assert main(["check", str(tmp_path / "picture.svg")]) == 1
    told = capsys.readouterr().out
    assert told.startswith(f"{tmp_path / 'picture.svg'}: The text is not JSON")
    assert told.endswith("(theditor import makes a drawing of it.)\n")


def test_check_answers_in_json_with_every_segment_and_joint(capsysbinary, tmp_path):
    (tmp_path / "bad.json").write_text("{}")
    arguments = ["check", "--json", str(FIGURE_10), str(tmp_path / "bad.json")]
    assert main(arguments) == 1
    good, bad = json.loads(capsysbinary.readouterr().out)
    assert good["file"] == str(FIGURE_10)
    (curve,) = good["curves"]
    assert (curve["name"], curve["degree"], curve["points"], curve["holds"]) == ("Figure 10", 3, 13, True)
    assert [each["number"] for each in curve["segments"]] == list(range(1, 11))
    assert curve["segments"][4]["name"] == "catenary"
    assert curve["segments"][4]["equation"].startswith("(x, y) = (1 − t, 1 + cosh(1 − t))")
    assert curve["segments"][1]["negative_basis"].startswith("basis function c₃ is negative")
    assert [joint["number"] for joint in curve["joints"]] == list(range(2, 11))
    assert all(joint["holds"] and joint["order"] == 2 for joint in curve["joints"])
    assert bad["error"].endswith('must have the field "format": this is not a drawing of this program.')


def test_check_in_json_is_valid_json_where_a_curve_stands_still(capsysbinary, tmp_path):
    save(Drawing([Item(Curve([[0, 0]] * 4, degree=2), "�")]), tmp_path / "still.json")
    assert main(["check", "--json", str(tmp_path / "still.json")]) == 0
    ((curve,),) = (each["curves"] for each in json.loads(capsysbinary.readouterr().out))
    assert curve["name"] == "�"
    assert curve["joints"][0]["remark"].startswith("The curve stands still here")
