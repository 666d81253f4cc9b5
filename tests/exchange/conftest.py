"""Drawings to write in foreign formats."""

import pytest
from exchange_curves import BLEND, CURVES

from theditor.drawing import Drawing, Item


@pytest.fixture
def mixed():
    """A drawing of everything, with one curve hidden."""
    items = [Item(curve, name, width=1.5) for name, curve in CURVES.items()]
    return Drawing([*items, Item(BLEND, "unseen", visible=False)])
