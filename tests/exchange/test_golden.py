"""What was written once is written for ever: files kept in tests/data/exchange, but for the last digits.

To keep a change on purpose, run the test with THEDITOR_REWRITE=1 and look at the difference.
"""

import os
import re
from pathlib import Path

import numpy as np
import pytest
from exchange_curves import BLEND, ELLIPSE, HYPERBOLA, STRAIGHT

from theditor.drawing import Drawing, Item
from theditor.exchange import Options, write

FOLDER = Path(__file__).parents[1] / "data" / "exchange"
NUMBER = re.compile(r"-?\d+\.\d+(?:e[+-]\d+)?|(?<=picture=\")[0-9a-f]+")
DRAWING = Drawing(
    [
        Item(BLEND, "Blend & more", "#c8520a", 3.0),
        Item(ELLIPSE, "Ellipse"),
        Item(HYPERBOLA, "Hyperbola"),
        Item(STRAIGHT, "Straight"),
        Item(ELLIPSE, "Unseen", visible=False),
    ]
)
ASKED = {
    "plain.svg": Options(),
    "shown.svg": Options(size=100, show={"polygon", "points", "labels"}),
    "printed.svg": Options(size=100, print_style=True),
    "printed.tex": Options(print_style=True),
    "table.csv": Options(samples=2, tangent=True, curvature=True),
}


@pytest.mark.parametrize("name", ASKED)
def test_the_same_file_comes_out(name):
    text = write(DRAWING, Path(name).suffix, ASKED[name]).data.decode()
    if os.environ.get("THEDITOR_REWRITE"):
        (FOLDER / name).write_text(text, encoding="utf-8", newline="\n")
    kept = (FOLDER / name).read_text("utf-8")
    assert NUMBER.sub("#", text) == NUMBER.sub("#", kept)
    mine, theirs = ([float(n) for n in NUMBER.findall(each) if "." in n] for each in (text, kept))
    np.testing.assert_allclose(mine, theirs, rtol=1e-9, atol=1e-9)
