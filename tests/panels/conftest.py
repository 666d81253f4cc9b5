import pytest
from panel_hand import some_curve

from theditor.drawing import Drawing, Item
from theditor.model import Document, Selection


@pytest.fixture
def document(qapp):
    return Document(
        Drawing([Item(some_curve(), "Figure 10"), Item(some_curve(degree=2, closed=True), "Ring")])
    )


@pytest.fixture
def selection(document):
    return Selection(document)


@pytest.fixture
def show(qtbot):
    """Show a widget at a size, active, and return it."""

    def shown(widget, width=360, height=None):
        qtbot.addWidget(widget)
        widget.resize(width, height or widget.sizeHint().height())
        with qtbot.waitExposed(widget):
            widget.show()
        widget.activateWindow()
        return widget

    return shown
