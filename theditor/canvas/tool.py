"""What a tool is: it turns presses into drags, and keys into steps, until another tool is taken up."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, Protocol

from PySide6.QtCore import Qt

from theditor.canvas.curves import CurvesPainter
from theditor.canvas.hit_test import Hit
from theditor.canvas.sketch import Sketch
from theditor.canvas.snapping import Snapped, Snapper
from theditor.canvas.tools import Drag, Pointer
from theditor.canvas.view import PlaneView
from theditor.drawing import Item
from theditor.model import Document, Selection
from theditor.model.naming import new_name
from theditor.spline import Curve


class Bench(NamedTuple):
    """What tools work with."""

    document: Document
    selection: Selection
    view: PlaneView
    curves: CurvesPainter
    snapper: Snapper
    bounds: Callable[[int], tuple[float, float]]
    """The bounds of λ for a curve of the drawing."""
    say: Callable[[str], None]
    """Tells what happened."""

    def draw(self, curve: Curve, *, current: bool = True) -> None:
        """Add a curve to the drawing in one undo step, and make it current unless something else is to stay so."""
        drawing = self.document.drawing
        item = Item(curve, name=new_name({item.name for item in drawing}))
        self.document.apply("Draw curve", drawing.inserted(len(drawing), item))
        if current:
            self.selection.select(curve=len(drawing))


class Keys(NamedTuple):
    """A key (a `Qt.Key`) and what is held with it."""

    key: int
    shift: bool = False
    ctrl: bool = False


class Tool(Protocol):
    """What the left button and the keys do on the canvas."""

    @property
    def keys(self) -> frozenset[int]:
        """Keys that mean something here before they mean a command."""

    @property
    def sketch(self) -> Sketch | None:
        """The curve to come, if there is one."""

    @property
    def snapped(self) -> Snapped | None:
        """What the next place is drawn to."""

    @property
    def hint(self) -> str:
        """What the mouse would do now; empty to leave that to what is under the pointer."""

    @property
    def cursor(self) -> Qt.CursorShape | None:
        """The pointer's shape; None to leave that to what is under the pointer."""

    def hover(self, pointer: Pointer) -> Hit:
        """Follow the pointer while no button is down; returns what would be grabbed."""

    def press(self, pointer: Pointer, *, double: bool) -> Drag:
        """Begin a drag."""

    def click(self, drag: Drag, pointer: Pointer) -> None:
        """End a drag that has not left the place of its press."""

    def key(self, keys: Keys) -> bool:
        """Act on a key; returns whether it means something here."""

    def leave(self) -> None:
        """Put away what is unfinished: another tool is taken up."""
