"""PNG and PDF: read from their bytes, and the PDF's paths as pdfium finds them."""

import ctypes
import os
import struct
import subprocess
import sys

import numpy as np
import pypdfium2
import pytest
from exchange_curves import BLEND, ELLIPSE, HYPERBOLA, gap, size_of
from pypdfium2 import raw
from PySide6.QtGui import QImage

from theditor.drawing import Drawing, DrawingError, Item
from theditor.exchange import PARTS, Options, write
from theditor.spline import nearest

pytestmark = pytest.mark.usefixtures("qapp")  # before the writers make an application of their own


def png(*items, **options):
    return write(Drawing(items), ".png", Options(**options))


def chunks(data):
    """The parts of a PNG by their name."""
    found, position = {}, 8
    while position < len(data):
        length, name = struct.unpack(">I4s", data[position : position + 8])
        found[name.decode()] = data[position + 8 : position + 8 + length]
        position += 12 + length
    return found


def pixels(data):
    """Red, green, blue and alpha of each pixel, from 0 to 255."""
    image = QImage.fromData(data).convertToFormat(QImage.Format.Format_RGBA8888)
    return np.array(image.constBits()).reshape(image.height(), image.bytesPerLine() // 4, 4)[
        :, : image.width()
    ]


def paths(data):
    """The page's paths: width of the line, and points with their kinds, in its own units with y upward."""
    (page,) = pypdfium2.PdfDocument(data)
    found = []
    for thing in page.get_objects():
        matrix, width = raw.FS_MATRIX(), ctypes.c_float()
        raw.FPDFPageObj_GetMatrix(thing.raw, matrix)
        raw.FPDFPageObj_GetStrokeWidth(thing.raw, width)
        segments = [
            raw.FPDFPath_GetPathSegment(thing.raw, i) for i in range(raw.FPDFPath_CountSegments(thing.raw))
        ]
        points = []
        for segment in segments:
            x, y = ctypes.c_float(), ctypes.c_float()
            raw.FPDFPathSegment_GetPoint(segment, x, y)
            points.append((matrix.a * x.value + matrix.e, matrix.d * y.value + matrix.f))
        kinds = [raw.FPDFPathSegment_GetType(segment) for segment in segments]
        found.append((width.value * matrix.a, kinds, np.array(points)))
    return found, page.get_size()


def along(kinds, points, steps=16):
    """Points of a path of lines and Béziers."""
    t, runs, i = np.arange(steps + 1)[:, None] / steps, [points[:1]], 1
    while i < len(points):
        if kinds[i] == raw.FPDF_SEGMENT_LINETO:
            runs.append(points[i : i + 1])
            i += 1
        else:
            a, (b, c, d) = points[i - 1], points[i : i + 3]
            runs.append((1 - t) ** 3 * a + 3 * t * (1 - t) ** 2 * b + 3 * t**2 * (1 - t) * c + t**3 * d)
            i += 3
    return np.concatenate(runs)


@pytest.mark.parametrize("curve", [BLEND, HYPERBOLA], ids=["blend", "hyperbola"])
def test_a_pdf_holds_the_curve_as_beziers_at_one_scale(curve):
    written = write(Drawing([Item(curve, width=3)]), ".pdf", Options(tolerance=1e-5, size=100))
    ((width, kinds, points),), size = paths(written.data)
    assert max(size) == pytest.approx(100 / 25.4 * 72, abs=0.5)
    assert width == pytest.approx(3 * 72 / 96, rel=1e-5)
    assert raw.FPDF_SEGMENT_BEZIERTO in kinds
    ends = curve([0, curve.segment_count])
    unit = np.linalg.norm(points[-1] - points[0]) / np.linalg.norm(ends[1] - ends[0])
    mine = (along(kinds, points) - points[0]) / unit + ends[0]
    _, off = nearest(curve, mine[:: max(1, len(mine) // 40)])
    assert off.max() <= 1.3e-5 * size_of(curve)  # the file itself is read in single precision
    assert gap(curve.sample(9), mine) <= 1e-3 * size_of(curve)
    assert 0 < written.deviation <= 1.01e-5 * size_of(curve)


def test_a_pdf_shows_what_is_asked_for():
    plain, _ = paths(write(Drawing([Item(BLEND)]), ".pdf").data)
    full, size = paths(write(Drawing([Item(BLEND)]), ".pdf", Options(show=PARTS)).data)
    assert len(plain) == 1
    assert len(full) >= 1 + 1 + 1 + 6 + 6
    for _, _, points in full:
        assert (points > 0).all()
        assert (points < size).all()


def test_the_same_drawing_gives_the_same_bytes(mixed):
    for suffix in (".pdf", ".png"):
        data = write(mixed, suffix, Options(show=PARTS, size=200)).data
        assert data == write(mixed, suffix, Options(show=PARTS, size=200)).data
    assert b"CreationDate" not in write(mixed, ".pdf").data


def test_a_png_has_the_size_and_density_asked_for():
    data = png(Item(ELLIPSE), size=300, dpi=150).data
    parts = chunks(data)
    assert struct.unpack(">II", parts["IHDR"][:8])[0] == 300
    assert struct.unpack(">IIB", parts["pHYs"]) == (5906, 5906, 1)
    assert struct.unpack(">II", chunks(png(Item(ELLIPSE)).data)["IHDR"][:8])[0] == 1600


def test_lines_of_a_png_keep_their_physical_width():
    def dark(dpi):
        across = pixels(png(Item(ELLIPSE, color="#000000", width=4), size=400, dpi=dpi).data)[:, 200, 0]
        return (255 - across.astype(float)).sum() / 255

    # The ellipse is crossed twice, above and below.
    assert dark(96) == pytest.approx(8, rel=0.05)
    assert dark(192) == pytest.approx(16, rel=0.05)


@pytest.mark.parametrize("transparent", [False, True])
def test_the_ground_of_a_png_is_white_or_nothing(transparent):
    picture = pixels(png(Item(ELLIPSE, color="#c8520a", width=6), size=200, transparent=transparent).data)
    height, width, _ = picture.shape
    assert tuple(picture[height // 2, width // 2]) == ((0, 0, 0, 0) if transparent else (255, 255, 255, 255))
    assert (picture.reshape(-1, 4) == (0xC8, 0x52, 0x0A, 255)).all(axis=1).any()


def test_hidden_curves_are_not_painted():
    picture = pixels(png(Item(ELLIPSE, visible=False), size=50).data)
    assert (picture == 255).all()
    assert len(paths(write(Drawing(), ".pdf").data)[0]) == 0


@pytest.mark.parametrize(
    ("suffix", "wish"), [(".png", {"size": 15_001}), (".pdf", {"size": 5_001}), (".png", {"scale": 1e9})]
)
def test_what_the_format_cannot_hold_is_refused(suffix, wish):
    with pytest.raises(DrawingError, match=r"ask for a(nother| smaller) size"):
        write(Drawing([Item(ELLIPSE)]), suffix, Options(**wish))


def test_a_scale_is_kept_on_paper_and_in_pixels():
    one, two = (
        paths(write(Drawing([Item(BLEND)]), ".pdf", Options(scale=scale)).data)[0][0] for scale in (5, 10)
    )
    for (width, _, points), scale in ((one, 5), (two, 10)):
        assert width == pytest.approx(2 * 72 / 96, rel=1e-5)
        long = np.linalg.norm(points[-1] - points[0]) / 72 * 25.4
        assert long == pytest.approx(scale * np.linalg.norm(BLEND(5.0) - BLEND(0.0)), rel=1e-4)
    wide = pixels(png(Item(ELLIPSE), scale=10, dpi=254).data).shape[1]
    assert wide == pytest.approx(6 * 10 * 10, abs=50)


@pytest.mark.parametrize("factor", [1e-9, 1e11])
def test_any_size_of_drawing_is_painted_alike(factor):
    curve = BLEND.with_(control_points=BLEND.control_points * factor)
    one, other = (pixels(png(Item(each), size=150).data).astype(int) for each in (BLEND, curve))
    assert one.shape == other.shape
    assert np.abs(one - other).max() <= 8


def test_no_display_is_needed_and_no_widgets_are_loaded():
    code = (
        "import sys; from theditor.drawing import *; from theditor.exchange import *; from theditor.spline import *\n"
        "drawing = Drawing([Item(Curve([[0, 0], [1, 2], [3, 2], [4, 0]]))])\n"
        "print(len(write(drawing, '.pdf', Options(show=PARTS)).data) > 1000, 'PySide6.QtWidgets' in sys.modules)\n"
    )
    lone = {
        key: value for key, value in os.environ.items() if "DISPLAY" not in key and not key.startswith("QT_")
    }
    run = subprocess.run([sys.executable, "-c", code], env=lone, capture_output=True, text=True, check=True)
    assert run.stdout.split() == ["True", "False"]
    assert run.stderr == ""
