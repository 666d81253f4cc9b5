"""A canvas with two curves under a hand."""

import pytest
from hand import Hand

from theditor.canvas import Canvas
from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection
from theditor.spline import Curve

POINTS = [[0.0, 0.0], [1.0, 3.0], [3.0, 3.0], [5.0, -1.0], [7.0, 0.0], [8.0, 2.0]]
OTHER = [[0.0, 5.0], [3.0, 6.0], [6.0, 5.0], [8.0, 6.0]]


@pytest.fixture
def canvas(qtbot):
    drawing = Drawing([Item(Curve(POINTS), name="one"), Item(Curve(OTHER, 1.0), name="two", color="#AA00AA")])
    document = Document(drawing)
    selection = Selection(document)
    canvas = Canvas(document, selection)
    canvas.document, canvas.selection = document, selection
    qtbot.addWidget(canvas)
    canvas.resize(800, 600)
    with qtbot.waitExposed(canvas):
        canvas.show()
    canvas.setFocus()
    return canvas


@pytest.fixture
def hand(canvas):
    return Hand(canvas)
