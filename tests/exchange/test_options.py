"""What can be asked of a foreign format, and how a wish that cannot be met is refused."""

import numpy as np
import pytest

from theditor.drawing import Drawing, DrawingError, Item
from theditor.exchange import FORMATS, Options, read, readable, writable, write
from theditor.spline import Curve


@pytest.mark.parametrize(
    ("wish", "words"),
    [
        ({"tolerance": 0.0}, "tolerance"),
        ({"tolerance": float("nan")}, "tolerance"),
        ({"size": 0.5}, "size"),
        ({"scale": 0.0}, "scale"),
        ({"scale": 2.0, "size": 100.0}, "not both"),
        ({"dpi": float("inf")}, "dpi"),
        ({"show": {"polygon", "grid"}}, "'grid'"),
        ({"sampling": "chance"}, "'chance'"),
        ({"samples": 2.5}, "2.5"),
        ({"degree": 4}, "4"),
    ],
)
def test_a_wish_that_makes_no_sense_is_refused_in_one_sentence(wish, words):
    with pytest.raises(DrawingError, match=words) as caught:
        Options(**wish)
    assert str(caught.value).count(".\n") == 0
    assert str(caught.value).endswith(".")


def test_parts_to_show_may_come_in_any_collection():
    assert Options(show=["polygon", "polygon"]) == Options(show=frozenset({"polygon"}))


@pytest.mark.parametrize("suffix", ["", ".json", ".docx", "svg"])
def test_an_unknown_format_is_refused_with_the_known_ones(suffix):
    with pytest.raises(DrawingError, match=r"written: choose one of \.svg, \.pdf") as caught:
        write(Drawing(), suffix)
    assert repr(suffix) in str(caught.value) or not suffix
    with pytest.raises(DrawingError, match=r"read: choose one of \.svg, \.csv"):
        read(b"", suffix)


def test_what_only_goes_out_cannot_be_read():
    assert set(readable()) < set(writable()) == set(FORMATS)
    with pytest.raises(DrawingError, match=r"'\.PNG' cannot be read"):
        read(b"", ".PNG")


@pytest.mark.parametrize("suffix", writable())
def test_writing_tells_its_progress_and_can_be_called_off(qapp, suffix):
    rng = np.random.default_rng(1)
    drawing = Drawing(Item(Curve(rng.normal(size=(6, 2)))) for _ in range(9))
    shares = []
    written = write(drawing, suffix, progress=shares.append)
    assert shares == sorted(shares)
    assert 0 == shares[0] < shares[-1] < 1
    assert written == write(drawing, suffix)

    class EnoughError(Exception):
        pass

    def stop(share):
        if share == shares[-1]:
            raise EnoughError

    with pytest.raises(EnoughError):
        write(drawing, suffix, progress=stop)
