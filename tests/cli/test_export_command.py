import sys

import numpy as np
import pytest

from theditor.cli import main
from theditor.drawing import Drawing, DrawingError, Item, decode, load
from theditor.exchange import Imported, Options, Written, formats, write
from theditor.resources import resource
from theditor.spline import Curve

FIGURE_10 = resource("gallery") / "figure-10.json"
HELIX = resource("gallery") / "helix.json"


def usage_error(capsys, *arguments):
    with pytest.raises(SystemExit) as caught:
        main([*map(str, arguments)])
    assert caught.value.code == 2
    return capsys.readouterr().err.splitlines()[-1]


def test_a_drawing_is_written_in_the_format_of_the_suffix(capsys, tmp_path):
    out = tmp_path / "figure.SVG"
    assert main(["export", str(FIGURE_10), "-o", str(out)]) == 0
    written = write(load(FIGURE_10), ".svg")
    assert out.read_bytes() == written.data
    told = capsys.readouterr().out
    assert (
        told == f"{out}: The largest deviation is {written.deviation:.2g} units. {' '.join(written.notes)}\n"
    )


def test_what_is_exact_is_said_to_be(capsys, tmp_path):
    assert (
        main(["export", str(resource("gallery") / "ellipse-quadratic.json"), "-o", str(tmp_path / "e.svg")])
        == 0
    )
    assert capsys.readouterr().out.startswith(f"{tmp_path / 'e.svg'}: Exact. ")


def test_every_option_reaches_the_format(monkeypatch, tmp_path):
    seen = []

    def noted(drawing, suffix, options):
        seen.append((suffix, options))
        return Written(b"data")

    monkeypatch.setattr("theditor.cli.export.write", noted)
    given = "--tolerance 1e-6 --size 90 --dpi 300 --transparent --show labels,comb --print-style"
    given += " --sampling length --samples 7 --tangent --curvature --format tex"
    assert main(["export", str(FIGURE_10), "-o", str(tmp_path / "a"), *given.split()]) == 0
    show = frozenset({"labels", "comb"})
    options = Options(
        tolerance=1e-6,
        size=90,
        dpi=300,
        transparent=True,
        show=show,
        print_style=True,
        sampling="length",
        samples=7,
        tangent=True,
        curvature=True,
    )
    assert seen == [(".tex", options)]
    assert main(["export", str(FIGURE_10), "-o", str(tmp_path / "a.csv"), "--scale", "5"]) == 0
    assert seen[1:] == [(".csv", Options(scale=5))]
    assert (tmp_path / "a").read_bytes() == b"data"


def test_to_standard_output_goes_the_file_alone(capsysbinary):
    assert main(["export", str(FIGURE_10), "-o", "-", "--format", "svg"]) == 0
    captured = capsysbinary.readouterr()
    assert captured.out == write(load(FIGURE_10), ".svg").data
    assert captured.err.startswith(b"standard output: The largest deviation is")


def test_many_go_into_a_folder_and_a_faulty_one_does_not_stop_the_others(capsys, tmp_path):
    bad, folder = tmp_path / "bad.json", tmp_path / "new" / "pictures"
    bad.write_text("{}")
    files = [str(FIGURE_10), str(bad), str(HELIX)]
    assert main(["export", *files, "-o", str(folder), "--format", "svg"]) == 1
    assert sorted(path.name for path in folder.iterdir()) == ["figure-10.svg", "helix.svg"]
    assert (folder / "helix.svg").read_bytes() == write(load(HELIX), ".svg").data
    captured = capsys.readouterr()
    assert captured.err.startswith(f"theditor: {bad}: The file must have the field")
    assert captured.err.count("\n") == 1
    assert f"{folder / 'figure-10.svg'}: The largest deviation" in captured.out


def test_what_does_not_go_together_is_refused_before_anything_is_written(capsys, tmp_path):
    copy = tmp_path / "figure-10.json"
    copy.write_bytes(FIGURE_10.read_bytes())
    before = copy.read_bytes()

    def refused(*arguments):
        return usage_error(capsys, "export", *arguments).removeprefix("theditor export: error: ")

    known = "svg, pdf, png, dxf, tex, csv"
    assert refused(copy, "-o", tmp_path / "a.bmp") == (
        f"{tmp_path / 'a.bmp'} does not end in one of {known}: say --format if it is one all the same"
    )
    assert refused(copy, "-o", "a", "--format", "bmp") == f"--format must be one of {known}, not 'bmp'"
    assert refused(copy, "-o", "-") == f"- has no suffix: say --format, one of {known}"
    assert refused(copy, HELIX, "-o", "-", "--format", "svg") == (
        "several drawings need a folder to be written to"
    )
    assert refused(copy, HELIX, "-o", tmp_path / "x") == (
        f"{tmp_path / 'x'} is to be a folder: say --format, one of {known}"
    )
    assert refused(copy, FIGURE_10, "-o", tmp_path / "x", "--format", "svg") == (
        f"several drawings would be written to {tmp_path / 'x' / 'figure-10.svg'}: export each to another folder"
    )
    assert "standard input has no name" in refused("-", copy, "-o", tmp_path / "x", "--format", "svg")
    assert refused(copy, "-o", copy, "--format", "svg") == f"{copy} is the drawing itself: name another OUT"
    assert "cannot show 'knots'" in refused(copy, "-o", "a.svg", "--show", "points,knots")
    assert "a size or a scale" in refused(copy, "-o", "a.svg", "--size", "9", "--scale", "1")
    assert "tolerance must be a number" in refused(copy, "-o", "a.svg", "--tolerance", "nan")
    assert copy.read_bytes() == before
    assert list(tmp_path.iterdir()) == [copy]


def test_what_cannot_be_written_is_told_in_a_sentence(capsys, tmp_path):
    (tmp_path / "file").touch()
    arguments = ["export", str(FIGURE_10), str(HELIX), "-o", str(tmp_path / "file"), "--format", "svg"]
    assert main(arguments) == 1
    assert capsys.readouterr().err == f"theditor: {tmp_path / 'file'} cannot be made a folder: File exists.\n"
    assert main(["export", str(FIGURE_10), "-o", str(tmp_path / "no" / "a.svg")]) == 1
    assert capsys.readouterr().err.endswith(f"a.svg cannot be saved: there is no folder {tmp_path / 'no'}.\n")


@pytest.fixture
def reader(monkeypatch):
    """A foreign format whose files hold one straight curve, or are refused."""

    def prepare(imported):
        module = type(sys)("theditor.exchange.fake")
        seen = []

        def read(data, options, progress):
            progress(0.5)
            progress(1.0)
            seen.append((data, options))
            if isinstance(imported, Exception):
                raise imported
            return imported

        module.read = read
        monkeypatch.setitem(sys.modules, "theditor.exchange.fake", module)
        monkeypatch.setitem(formats.FORMATS, ".svg", formats.Format("fake", None, "fake:read"))
        return seen

    return prepare


def test_exported_points_come_back_as_a_curve_through_them(tmp_path):
    table, out = tmp_path / "points.csv", tmp_path / "out.json"
    assert main(["export", str(FIGURE_10), "-o", str(table), "--samples", "2"]) == 0
    assert main(["import", str(table), "-o", str(out)]) == 0
    before, after = load(FIGURE_10)[0].curve, load(out)[0].curve
    np.testing.assert_allclose(after.joints, before.sample(2), atol=1e-12)


def test_an_exported_picture_holds_the_drawing(tmp_path):
    picture, out = tmp_path / "figure.svg", tmp_path / "out.json"
    assert main(["export", str(FIGURE_10), "-o", str(picture)]) == 0
    assert main(["import", str(picture), "-o", str(out)]) == 0
    assert out.read_bytes() == FIGURE_10.read_bytes()


LINE = Drawing([Item(Curve([[0, 0], [1, 1]], ends="clamped"), "line")])


def test_import_reads_with_its_options_and_tells_deviation_and_notes(capsys, tmp_path, reader):
    seen = reader(Imported(LINE, 0.001, ("A text was left out.",)))
    source, out = tmp_path / "in.svg", tmp_path / "out.json"
    source.write_bytes(b"<svg/>")
    arguments = [
        "import",
        str(source),
        "-o",
        str(out),
        "--tolerance",
        "0.01",
        "--degree",
        "2",
        "--control-points",
    ]
    assert main(arguments) == 0
    assert load(out) == LINE
    assert seen == [(b"<svg/>", Options(tolerance=0.01, degree=2, control_points=True))]
    captured = capsys.readouterr()
    assert captured.out == f"{source}: The largest deviation is 0.001 units. A text was left out.\n"
    assert captured.err == ""


def test_import_writes_a_drawing_alone_to_standard_output(capsysbinary, tmp_path, reader):
    reader(Imported(LINE))
    source = tmp_path / "in.SVG"
    source.write_bytes(b"")
    assert main(["import", str(source), "-o", "-"]) == 0
    captured = capsysbinary.readouterr()
    assert decode(captured.out) == LINE
    assert captured.err == f"{source}: Exact.\n".encode()


def test_import_says_what_is_wrong_and_replaces_nothing_but_drawings(capsys, tmp_path, reader):
    reader(DrawingError("The text is not XML."))
    source, out = tmp_path / "in.svg", tmp_path / "out.json"
    source.write_bytes(b"")
    assert main(["import", str(source), "-o", str(out)]) == 1
    assert capsys.readouterr().err == f"theditor: {source}: The text is not XML.\n"
    assert not out.exists()
    assert main(["import", str(tmp_path / "no.svg"), "-o", str(out)]) == 1
    assert "no.svg cannot be read: there is no such file" in capsys.readouterr().err
    reader(Imported(LINE))
    out.write_text("notes")
    assert main(["import", str(source), "-o", str(out)]) == 1
    assert out.read_text() == "notes"
    assert main(["import", str(source), "-o", str(out), "--overwrite"]) == 0
    assert load(out) == LINE
    assert "- has no suffix: say --format" in usage_error(capsys, "import", "-", "-o", out)
